# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The frame of a raster: its CRS, held against where it lies, and the unit of its heights."""

import re
from pathlib import Path
from typing import Any, NamedTuple

from ltp.world.crs import (
    Box,
    Unit,
    any_crs,
    check_scale,
    crs_report,
    height_datum,
    height_unit,
    horizontal,
    refuse_degrees,
)

from ..geokeys import GeoKeys
from ..units import (
    HeightScale,
    Says,
    height_scale,
    metric_frame,
    refuse_depths,
    unit_in_words,
    unit_named,
)

_UNIT_TAG = re.compile(r"(^|_|z|vertical|elevation|height)units?(_?type)?$", re.IGNORECASE)


class Frame(NamedTuple):
    """What the coordinates and the heights of a raster mean."""

    crs: Any | None  # horizontal part, a pyproj CRS; None if the file names none
    datum: str | None  # what its heights count from, if it says so
    heights: HeightScale
    report: str  # a sentence about the CRS


def raster_frame(
    path: Path,
    dataset: Any,
    keys: GeoKeys | None,
    *,
    metric: bool,
    heights: bool,
    convert_heights: bool,
) -> Frame:
    """Find the frame of an open raster.

    Args:
        path: the file.
        dataset: rasterio's.
        keys: the file's GeoKeys.
        metric: whether x and y must be in metres that are true there.
        heights: whether the values are heights, whose unit matters.
        convert_heights: whether heights in another unit are scaled to metres, or refused.

    Raises:
        ValueError: naming the file and what is wrong.
    """
    known = _known_crs(path, dataset, keys)
    flat = None if known is None else horizontal(known)
    report = crs_report(None, None, "")
    if metric:
        west, south, east, north = dataset.bounds
        box: Box = (west, min(south, north), east, max(south, north))
        unit = None if keys is None else keys.linear_unit()
        flat = metric_frame(path, known, unit, box)
        refuse_degrees(box, str(path), abs(dataset.transform.a))
        if flat is not None:
            report = crs_report(flat, check_scale(flat, box, str(path)), f"by {path.name}")
    if heights and known is not None:
        refuse_depths(known, str(path))
    says = _heights_say(path, dataset, keys, known) if heights else []
    scale = height_scale(path, says, convert_heights)
    return Frame(flat, None if known is None else height_datum(known), scale, report)


def _known_crs(path: Path, dataset: Any, keys: GeoKeys | None) -> Any | None:
    """The CRS as a pyproj CRS, with its vertical part; None if the file names none."""
    try:
        unit = None if keys is None else keys.linear_unit()
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from error
    if keys is not None and keys.is_nameless:
        if unit is None and keys.projected is not None:
            raise ValueError(
                f"{path} has a user-defined projection, and tells neither it nor its unit"
            )
        return None
    if dataset.crs is None:
        return None
    known = any_crs(dataset.crs.to_wkt(), f"the CRS of {path}")
    if keys is not None and keys.projected is not None and not horizontal(known).is_projected:
        raise ValueError(f"{path} has a CRS that nobody knows: GeoKey 3072 = {keys.projected}")
    return known


def _heights_say(path: Path, dataset: Any, keys: GeoKeys | None, crs: Any | None) -> list[Says]:
    """All that tells the unit of the heights, the most explicit first."""
    says = []
    vertical: Unit | None = None if crs is None else height_unit(crs)
    text = dataset.units[0]
    if text:
        unit = unit_named(text)
        if unit is None:
            raise ValueError(f"{path} must hold heights in metres, not in {text!r}")
        # GDAL fills the unit of the band in from the vertical CRS, where the file has no other.
        if vertical is None or vertical.metres != unit.metres:
            says.append(Says("the unit of its band", unit))
    says += _words_say(dataset)
    if keys is not None:
        try:
            says += keys.vertical_units()
        except ValueError as error:
            raise ValueError(f"{path}: {error}") from error
    if vertical is not None:
        says.append(Says("its vertical CRS", vertical))
    return says


def _words_say(dataset: Any) -> list[Says]:
    """What free text tells of the unit: the name of the band, and tags such as UNITS=feet."""
    texts = {"the name of its band": dataset.descriptions[0] or ""}
    for key, text in {**dataset.tags(), **dataset.tags(1)}.items():
        if _UNIT_TAG.search(key):
            texts[f"its tag {key}"] = text
    found = ((where, unit_in_words(text)) for where, text in texts.items())
    return [Says(where, unit) for where, unit in found if unit is not None]


def check_heights_agree(frames: dict[Path, Frame]) -> None:
    """Demand that the heights of some files are comparable.

    Raises:
        ValueError: naming two of them, if one is scaled and another does not tell its unit, or if
            they count from different datums.
    """
    scaled = [path for path, frame in frames.items() if frame.heights.metres != 1.0]
    silent = [path for path, frame in frames.items() if not frame.heights.told]
    if scaled and silent:
        raise ValueError(
            f"{silent[0]} does not say in which unit its heights are, while those of {scaled[0]} "
            "are not in metres: set the unit of its band (gdal_edit.py -units)"
        )
    named = [(path, frame.datum) for path, frame in frames.items() if frame.datum is not None]
    for path, datum in named[1:]:
        if datum != named[0][1]:
            raise ValueError(
                f"{path} has heights above {datum}, {named[0][0]} above {named[0][1]}: bring "
                "them to one height datum first"
            )


def heights_report(frames: dict[Path, Frame]) -> list[str]:
    """A sentence for each file of heights, or one for all that say the same."""
    told: dict[str, list[str]] = {}
    for path, frame in frames.items():
        told.setdefault(frame.heights.report, []).append(path.name)
    return [f"{', '.join(names)}: {sentence}" for sentence, names in told.items()]
