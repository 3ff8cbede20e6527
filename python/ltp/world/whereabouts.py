# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where a file lies that holds nothing of the area asked for."""

from typing import Any

from .crs import Box
from .geodesy import from_lon_lat, lon_lat, utm_zone


def overlap(one: Box, other: Box) -> bool:
    """Whether two areas of one CRS share more than a line."""
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]


def elsewhere(crs: Any, covered: Box, bounds: Box) -> str:
    """Where a file lies that has nothing within `bounds`, and the CRS that may have been meant.

    Args:
        crs: of `covered`, a pyproj CRS, in degrees too.
        covered: what the file covers.
        bounds: what was asked for [m].

    Returns:
        The end of a sentence; empty if nobody knows.
    """
    x0, y0, x1, y1 = covered
    try:
        lon, lat = lon_lat(crs, [x0, x1, x0, x1], [y0, y0, y1, y1])
        zone = utm_zone(float(lon.mean()), float(lat.mean()))
        x, y = from_lon_lat(zone, lon, lat)
    except ValueError:
        return ""
    at = f": it lies at longitude {lon.mean():.4f}, latitude {lat.mean():.4f}, {zone}"
    meant = overlap((x.min(), y.min(), x.max(), y.max()), bounds)
    return f"{at}, in which these bounds lie within it" if meant else at
