# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The frame of a survey: its CRS, held against where its points lie, and its unit of height."""

from pathlib import Path
from typing import Any, NamedTuple

from ltp.world.crs import (
    Box,
    Unit,
    any_crs,
    check_scale,
    crs_name,
    crs_report,
    height_unit,
    horizontal,
    refuse_degrees,
    same_grid,
)
from ltp.world.whereabouts import elsewhere, overlap

from ..units import HeightScale, Says, height_scale, metric_frame, refuse_depths
from .declared import Declared, declared_crs

_FINE_STEP = 1e-5  # coordinates in such steps are degrees: a metre of them, or 10 micrometres


class Frame(NamedTuple):
    """What the coordinates of a survey mean."""

    crs: str | None  # short name
    heights: HeightScale
    report: tuple[str, ...]


def survey_frame(
    path: Path, header: Any, *, crs: str | None, bounds: Box | None, convert_heights: bool
) -> Frame:
    """Find the frame of a survey; `header` is laspy's, the rest are arguments of `read`.

    Raises:
        ValueError: naming the file or the argument, if x and y are not in metres that are true
            there, heights are in another unit and `convert_heights` is not set, or `bounds` lie
            outside of the survey.
    """
    box = (
        float(header.mins[0]),
        float(header.mins[1]),
        float(header.maxs[0]),
        float(header.maxs[1]),
    )
    step = float(max(header.scales[:2]))
    told = _told(path, crs)
    flat = metric_frame(path, told.crs, told.plan, box, "crs" if crs else None)
    if told.crs is not None:
        refuse_depths(told.crs, str(path))
    refuse_degrees(box, str(path), _FINE_STEP if step <= _FINE_STEP else None)
    if bounds is not None:
        refuse_degrees(bounds, "bounds", crs=flat)
        _refuse_outside(path, box, bounds, flat)
    deviation = None if flat is None else check_scale(flat, bounds or box, str(path))
    heights = height_scale(path, told.heights, convert_heights)
    report = (
        crs_report(flat, deviation, told.where if crs else f"by {told.where}"),
        heights.report,
    )
    return Frame(None if flat is None else crs_name(flat), heights, report)


def _told(path: Path, crs: str | None) -> Declared:
    """What the caller says, or else the file."""
    if crs is None:
        return declared_crs(path)
    given = any_crs(crs, "crs")
    told = declared_crs(path, given=True)
    where, plan = "as given", told.plan
    if told.crs is not None and not same_grid(told.crs, given):
        where = f"as given, not {crs_name(told.crs)[:60]} as in {told.where}"
        axis = horizontal(told.crs).axis_info[0]
        if plan is None and horizontal(told.crs).is_projected:
            plan = Says(told.where, Unit(axis.unit_name, axis.unit_conversion_factor))
    unit = height_unit(given)
    heights = told.heights if unit is None else [Says("crs", unit), *told.heights]
    return Declared(given, where, plan, heights)


def _refuse_outside(path: Path, box: Box, bounds: Box, crs: Any) -> None:
    if overlap(bounds, box):
        return
    name = (
        "its coordinates" if crs is None else f"{crs_name(crs)[:40]}{elsewhere(crs, box, bounds)}"
    )
    raise ValueError(
        f"bounds {_text(bounds)} lie outside of {path}, which covers {_text(box)} in {name}"
    )


def _text(box: Box) -> str:
    return f"({', '.join(f'{value:.10g}' for value in box)})"
