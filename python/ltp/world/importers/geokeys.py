# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""GeoKeys, the CRS of GeoTIFF and of LAS up to 1.3: units from the keys, the rest by GDAL.

OGC GeoTIFF 1.1 (19-008r4), section 7; the same records stand in LAS files (LAS 1.4 R15, 2.6).
"""

import struct
from dataclasses import dataclass
from typing import Any

from ltp.world.crs import any_crs, height_unit

from .optional import require
from .units import Says, unit_in_words, unit_of_code

_MODEL_TYPE, _GEODETIC, _PROJECTED = 1024, 2048, 3072
_PROJECTION, _LINEAR_UNITS, _LINEAR_UNIT_SIZE = 3074, 3076, 3077
_PARAMETERS = range(3078, 3096)
_VERTICAL, _VERTICAL_UNITS = 4096, 4099
# Names in free text: of the file's CRS, of its projected part, of its vertical part.
_CITATION, _PROJECTED_CITATION, _VERTICAL_CITATION = 1026, 3073, 4097
_ASCII, _DOUBLES = 34737, 34736  # TIFF tags and LAS records of the values that are no integer
_DIRECTORY = 34735
_USER_DEFINED = 32767


@dataclass(frozen=True)
class GeoKeys:
    """The keys of one file."""

    values: dict[int, int | float]  # those that are one number
    citations: dict[int, str]  # those that are text
    directory: bytes  # little-endian, as the tags of a TIFF file
    doubles: bytes
    text: bytes

    @staticmethod
    def parse(directory: bytes, doubles: bytes = b"", text: bytes = b"") -> "GeoKeys":
        """Read the three records (little-endian).

        Raises:
            ValueError: if they are cut, or point outside of each other.
        """
        if len(directory) < 8:
            raise ValueError(f"GeoKeys of {len(directory)} bytes")
        version, _, _, count = struct.unpack_from("<4H", directory)
        if version != 1 or len(directory) < 8 + 8 * count:
            raise ValueError(f"GeoKeys of version {version} with {count} keys do not fit")
        values: dict[int, int | float] = {}
        citations: dict[int, str] = {}
        for index in range(count):
            key, place, number, value = struct.unpack_from("<4H", directory, 8 + 8 * index)
            if place == 0:
                values[key] = value
            elif place == _DOUBLES and number:
                if 8 * (value + number) > len(doubles):
                    raise ValueError(f"GeoKey {key} lies beyond its numbers")
                values[key] = struct.unpack_from("<d", doubles, 8 * value)[0]
            elif place == _ASCII:
                told = text[value : value + number].decode("utf-8", "replace")
                citations[key] = told.strip("|\0 ")
        return GeoKeys(values, citations, directory[: 8 + 8 * count], doubles, text)

    def linear_unit(self) -> Says | None:
        """The unit of x and y, if a key tells it, or a name where no code does.

        Raises:
            ValueError: if it is one that nobody knows.
        """
        size = self.values.get(_LINEAR_UNIT_SIZE)
        explicit = self._unit(_LINEAR_UNITS, "ProjLinearUnits", size)
        if explicit is not None or self.projected not in (None, _USER_DEFINED):
            return explicit
        return self._cited(_PROJECTED_CITATION, 0) or self._cited(_CITATION, 0)

    def vertical_units(self) -> list[Says]:
        """What the keys say of the unit of heights, the unit itself before the vertical CRS.

        Raises:
            ValueError: if it is one that nobody knows.
        """
        explicit = self._unit(_VERTICAL_UNITS, "VerticalUnits", None)
        says = [] if explicit is None else [explicit]
        code = self.values.get(_VERTICAL, 0)
        try:
            unit = height_unit(any_crs(f"EPSG:26918+{code}", "it")) if 0 < code < 32767 else None
        except ValueError:  # old codes of datums are no CRS; they tell no unit
            unit = None
        if unit is not None:
            says.append(Says(f"GeoKey {_VERTICAL} (VerticalCSType) = {code}", unit))
        cited = [self._cited(_VERTICAL_CITATION, 0)]
        cited += [self._cited(key, 1) for key in (_PROJECTED_CITATION, _CITATION)]
        return says + [said for said in cited if said is not None]

    def _cited(self, key: int, part: int) -> Says | None:
        """The unit that a name tells, such as "UTM zone 18N + NAVD88 height (ftUS)".

        Args:
            key: the GeoKey.
            part: which part of a compound name.
        """
        parts = self.citations.get(key, "").split(" + ")
        unit = unit_in_words(parts[part]) if part < len(parts) else None
        return None if unit is None else Says(f"GeoKey {key} = {parts[part][:60]!r}", unit)

    def _unit(self, key: int, name: str, size: float | None) -> Says | None:
        code = int(self.values.get(key, 0))
        if code == 0:
            return None
        unit = unit_of_code(code, size)
        if unit is None:
            raise ValueError(f"GeoKey {key} ({name}) = {code} is no known unit of length")
        return Says(f"GeoKey {key} ({name}) = {code}", unit)

    @property
    def is_nameless(self) -> bool:
        """Whether they say that x and y are projected, and not how."""
        values = self.values
        if not values.keys() & {_PROJECTED, _PROJECTION, _LINEAR_UNITS, _GEODETIC}:
            return False
        if values.get(_PROJECTED, _USER_DEFINED) not in (0, _USER_DEFINED):
            return False
        if values.get(_MODEL_TYPE, 1 if _PROJECTED in values else 0) != 1:
            return False
        if b"PE String" in self.text:  # ESRI writes the projection as text
            return False
        told = values.get(_PROJECTION, _USER_DEFINED) not in (0, _USER_DEFINED)
        return not told and not any(key in values for key in _PARAMETERS)

    @property
    def projected(self) -> int | None:
        """The code of the projected CRS, 32767 if it is user-defined; None without one."""
        return int(self.values.get(_PROJECTED, 0)) or None

    def crs(self) -> Any:
        """Their CRS as a pyproj CRS; None if there is none, or it is `is_nameless`.

        Raises:
            ImportError: if rasterio is not installed and the projection is user-defined.
            ValueError: if nobody knows it.
        """
        code = self.projected
        if code not in (None, _USER_DEFINED):
            return any_crs(f"EPSG:{code}", f"GeoKey {_PROJECTED} (ProjectedCSType)")
        if self.is_nameless or not self.values.keys() & {_GEODETIC, _PROJECTED}:
            return self._named_crs()
        rasterio = require("rasterio", "reading user-defined GeoKeys")
        try:
            with rasterio.MemoryFile(self._tiff()) as file, file.open(driver="GTiff") as dataset:
                wkt = dataset.crs.to_wkt() if dataset.crs else ""
        except (rasterio.errors.RasterioError, rasterio.errors.CRSError) as error:
            raise ValueError(f"GeoKeys that GDAL cannot read: {error}") from error
        return any_crs(wkt, "the CRS of its GeoKeys")

    def _named_crs(self) -> Any:
        """The projected CRS that a citation names as EPSG does; None without one."""
        for key in (_PROJECTED_CITATION, _CITATION):
            name = self.citations.get(key, "").partition(" + ")[0]
            if " / " not in name:
                continue
            try:
                crs = any_crs(name, f"GeoKey {key}")
            except ValueError:
                continue
            if crs.is_projected and crs.name.lower() == name.lower():  # PROJ guesses, too
                return crs
        return None

    def _tiff(self) -> bytes:
        """A GeoTIFF file of one pixel with these keys: GDAL knows all their ways (TIFF 6.0)."""
        short, long, double, text = 3, 4, 12, 2
        tags = [
            (256, short, struct.pack("<H", 1)),  # width
            (257, short, struct.pack("<H", 1)),  # height
            (258, short, struct.pack("<H", 8)),  # bits
            (259, short, struct.pack("<H", 1)),  # not compressed
            (262, short, struct.pack("<H", 1)),  # black is zero
            (273, long, struct.pack("<I", 8)),  # the strip begins
            (278, short, struct.pack("<H", 1)),  # its rows
            (279, long, struct.pack("<I", 1)),  # its bytes
            (33550, double, struct.pack("<3d", 1.0, 1.0, 0.0)),  # pixel scale
            (33922, double, struct.pack("<6d", *[0.0] * 6)),  # tie point
            (_DIRECTORY, short, self.directory),
            (_DOUBLES, double, self.doubles),
            (_ASCII, text, self.text),
        ]
        tags = [tag for tag in tags if tag[2]]
        start = 12  # after the header and the pixel
        data = start + 2 + 12 * len(tags) + 4
        sizes = {short: 2, long: 4, double: 8, text: 1}
        entries, blob = b"", b""
        for tag, kind, value in tags:
            entries += struct.pack("<HHI", tag, kind, len(value) // sizes[kind])
            if len(value) <= 4:
                entries += value.ljust(4, b"\0")
            else:
                entries += struct.pack("<I", data + len(blob))
                blob += value + b"\0" * (len(value) % 2)
        head = b"II*\0" + struct.pack("<I", start) + b"\0" * 4
        return head + struct.pack("<H", len(tags)) + entries + b"\0" * 4 + blob
