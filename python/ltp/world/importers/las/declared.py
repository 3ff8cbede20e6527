# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the records of a survey say of its CRS: WKT or GeoKeys, before or behind the points."""

import struct
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Any

from ltp.world.crs import any_crs, height_unit, horizontal, same_grid

from ..geokeys import GeoKeys
from ..units import Says
from .records import Record, walk

_USERS = (b"LASF_Projection", b"liblas")
_WKT, _DIRECTORY, _DOUBLES, _TEXT = 2112, 34735, 34736, 34737


@dataclass(frozen=True)
class Declared:
    """What the file says."""

    crs: Any  # pyproj CRS, compound if it is; None if there is none
    where: str  # that says so
    plan: Says | None  # unit of x and y, where a key tells it besides the CRS
    heights: list[Says]


def declared_crs(path: Path, given: bool = False) -> Declared:
    """Read the CRS of a survey whose header has been checked.

    Args:
        path: the file.
        given: whether the caller names the CRS; then one that nobody knows is passed over, and
            only the units of the file count.

    Raises:
        ValueError: naming the file and the record, if nobody knows the CRS, or it has two.
    """
    with path.open("rb") as file:
        try:
            found = list(_records(file))
            wkts = [_wkt(file, record) for record in found if record.number == _WKT]
            keys = _keys(file, found)
            plan = None if keys is None else keys.linear_unit()
            heights = [] if keys is None else keys.vertical_units()
        except (struct.error, EOFError) as error:
            raise ValueError(f"{path} ends early: {error}") from error
        except ValueError as error:
            raise ValueError(f"{path}: {error}") from error
    said = []
    try:
        said = _named(wkts, keys, plan)
    except ValueError as error:
        if not given:
            raise ValueError(f"{path} {error}; give crs") from error
    for where, crs in said:
        unit = height_unit(crs)
        if unit is not None:
            heights.append(Says(f"the vertical CRS in {where}", unit))
    if not said:
        return Declared(None, "its GeoKeys", plan, heights)
    # The one with heights says more.
    where, crs = next((one for one in said if height_unit(one[1]) is not None), said[0])
    return Declared(crs, where, plan, heights)


def _named(wkts: list[str], keys: GeoKeys | None, plan: Says | None) -> list[tuple[str, Any]]:
    """The CRSs that the records name, and where; all of one grid."""
    said: list[tuple[str, Any]] = []
    try:
        said += [("its WKT", any_crs(wkt, "its WKT")) for wkt in wkts if wkt]
        if keys is not None:
            said.append(("its GeoKeys", keys.crs()))
    except ValueError as error:
        raise ValueError(f"has a CRS that nobody knows: {error}") from error
    said = [(where, crs) for where, crs in said if crs is not None]
    for where, crs in said[1:]:
        if not same_grid(crs, said[0][1]):
            raise ValueError(
                f"has two CRSs: {horizontal(said[0][1]).name} in {said[0][0]}, "
                f"{horizontal(crs).name} in {where}"
            )
    nameless = keys is not None and keys.is_nameless and keys.projected is not None
    if not said and nameless and plan is None:
        raise ValueError("has a user-defined projection, and tells neither it nor its unit")
    return said


def _records(file: IO[bytes]) -> Iterator[Record]:
    """The records that tell of the CRS."""
    head = file.read(375)
    start, end, count = struct.unpack_from("<HII", head, 94)
    records = list(walk(file, start, count, end))
    if tuple(head[24:26]) == (1, 4):
        start, count = struct.unpack_from("<QI", head, 235)
        size = file.seek(0, 2)
        records += walk(file, start, count, size, extended=True)
    return (record for record in records if record.user in _USERS)


def _wkt(file: IO[bytes], record: Record) -> str:
    return record.read(file).partition(b"\0")[0].decode("utf-8", "replace").strip()


def _keys(file: IO[bytes], records: list[Record]) -> GeoKeys | None:
    found = {record.number: record.read(file) for record in records if record.number != _WKT}
    if _DIRECTORY not in found:
        return None
    return GeoKeys.parse(found[_DIRECTORY], found.get(_DOUBLES, b""), found.get(_TEXT, b""))
