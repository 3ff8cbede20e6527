# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The numbers of a GeoTIFF's one band, and all the ways in which it can say "nothing here"."""

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ltp.world.archive import MAX_CELLS

from ..optional import require
from .layout import check_complete


def has_alpha(dataset: Any) -> bool:
    """Whether the second and last band of an open raster says where the first one is opaque."""
    return bool(dataset.count == 2 and dataset.colorinterp[1].name == "alpha")


def read_band(path: Path, dataset: Any) -> tuple[NDArray[Any], NDArray[np.bool_], list[str]]:
    """The first band of an open raster as stored, where it holds nothing, and what to tell.

    Nothing is there where the no-data tag says so, or the mask inside of the file, or its alpha
    band, or the mask in a file of that name plus `.msk` beside it (GDAL's external mask).

    Raises:
        ValueError: naming the mask, if it is damaged or of another size.
    """
    band = dataset.read(1, masked=True)  # by GDAL's rules a mask hides the no-data tag
    stored, missing = np.asarray(band.data), np.ma.getmaskarray(band)
    report = []
    nodata = dataset.nodata
    if nodata is not None:
        missing = missing | (stored == nodata)
    if has_alpha(dataset):
        missing = missing | (dataset.read(2) == 0)
        report.append(f"{path.name}: its alpha band was read, 0 is a hole")
    elif any(flag.name == "per_dataset" for flag in dataset.mask_flag_enums[0]):
        report.append(f"{path.name}: the mask inside of it was read")
    beside = _beside(path, ".msk")
    if beside is not None:
        missing = missing | _read_external(beside, stored.shape)
        report.append(f"{path.name}: the mask {beside.name} beside it was read")
    notes = _beside(path, ".aux.xml")
    if notes is not None and b"<NoDataValue" in notes.read_bytes()[:_MOST_NOTES]:
        report.append(
            f"{path.name}: {notes.name} beside it names a no-data value and was not read; if there "
            "are holes, write the value into the file itself (gdal_edit.py -a_nodata)"
        )
    return stored, np.asarray(missing), report


_MOST_NOTES = 1 << 20  # bytes of an .aux.xml that are looked at


def _beside(path: Path, suffix: str) -> Path | None:
    for name in (path.name + suffix, path.name + suffix.upper()):
        if (found := path.with_name(name)).is_file():
            return found
    return None


def _read_external(path: Path, shape: tuple[int, ...]) -> NDArray[np.bool_]:
    """Where the first band of a mask is 0."""
    rasterio = require("rasterio", "reading GeoTIFF")
    check_complete(path)
    try:
        with rasterio.open(path.resolve(), driver="GTiff") as dataset:
            if dataset.shape != shape:
                raise ValueError(
                    f"{path} masks {dataset.width} x {dataset.height} cells, expected "
                    f"{shape[1]} x {shape[0]}: it belongs to another raster; remove it, or make it "
                    "anew"
                )
            if max(int(a) * int(b) for a, b in dataset.block_shapes) > MAX_CELLS:
                raise ValueError(f"{path} declares blocks of more than {MAX_CELLS:,} cells")
            return np.asarray(dataset.read(1) == 0)
    except rasterio.errors.RasterioError as error:
        raise ValueError(f"{path} cannot be read as a mask: {error}") from error
