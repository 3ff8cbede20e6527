# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Coordinate reference systems in which a metre is a metre."""

from typing import Any

from .optional import require


def metric_crs(crs: Any, source: str) -> Any:
    """The horizontal part of `crs` (a pyproj CRS, or any text that names one) as a pyproj CRS.

    `source` names the argument or file in the message.

    Raises:
        ImportError: if pyproj is not installed.
        ValueError: if nobody knows that CRS, or it is not in metres.
    """
    pyproj = require("pyproj", "working with map coordinates")
    try:
        known = pyproj.CRS.from_user_input(crs)
    except pyproj.exceptions.CRSError as error:
        raise ValueError(f"{source} must be a known CRS, e.g. EPSG:32618: {error}") from error
    flat = known.sub_crs_list[0] if known.is_compound else known
    units = {axis.unit_name for axis in flat.axis_info[:2]}
    if not flat.is_projected or units != {"metre"}:
        raise ValueError(f"{source} must be a projected CRS in metres, not {known.name} ({units})")
    return flat


def crs_name(crs: Any) -> str:
    """Short name of a pyproj CRS: its EPSG code, or else its definition (WKT)."""
    code = crs.to_epsg()
    return f"EPSG:{code}" if code is not None else str(crs.to_wkt())
