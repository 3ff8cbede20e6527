# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where on the Earth a point of a map lies, how large the map is there, and its UTM zone."""

from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .importers.optional import require

PURPOSE = "working with map coordinates"

_PROBE = 50.0  # half of the distance over which a scale is measured [m]


@lru_cache(maxsize=16)
def _transformer(source: Any, target: Any) -> Any:
    """From one CRS to another, x or longitude first."""
    return require("pyproj", PURPOSE).Transformer.from_crs(source, target, always_xy=True)


def _transformed(source: Any, target: Any, *points: ArrayLike) -> NDArray[np.float64]:
    pyproj = require("pyproj", PURPOSE)
    columns = [np.asarray(column, dtype=np.float64) for column in points]
    try:
        found = np.stack(_transformer(source, target).transform(*columns))
    except pyproj.exceptions.ProjError as error:
        raise ValueError(f"PROJ cannot bring {source} to {target}: {error}") from error
    if not np.isfinite(found).all():
        raise ValueError("some of it is nowhere on the Earth")
    return found


def lon_lat(crs: Any, x: ArrayLike, y: ArrayLike) -> NDArray[np.float64]:
    """Longitudes and latitudes [degrees, WGS 84] of points of a pyproj CRS, stacked: (2, ...).

    Raises:
        ValueError: if any of them is nowhere.
    """
    return _transformed(crs, "EPSG:4326", x, y)


def from_lon_lat(crs: Any, lon: ArrayLike, lat: ArrayLike) -> NDArray[np.float64]:
    """x and y in a pyproj CRS of longitudes and latitudes [degrees, WGS 84], stacked: (2, ...).

    Raises:
        ValueError: if the CRS does not reach one of them.
    """
    return _transformed("EPSG:4326", crs, lon, lat)


def scales(crs: Any, x: NDArray[np.float64], y: NDArray[np.float64]) -> NDArray[np.float64]:
    """The largest and the smallest scale (map / ground) at points (n,) of a metric CRS: (n, 2).

    They are the axes of Tissot's ellipse: the singular values of the Jacobian from the map to
    geocentric space (WGS 84), inverted. `pyproj.Proj.get_factors` says the same, but takes Web
    Mercator for true on a sphere (0.7 % off).

    Raises:
        ValueError: if any of the points is nowhere, or the map tears there.
    """
    jacobian = np.empty((len(x), 3, 2))
    for axis, (dx, dy) in enumerate(((_PROBE, 0.0), (0.0, _PROBE))):
        lon, lat = lon_lat(crs, [x - dx, x + dx], [y - dy, y + dy])
        space = _transformed("EPSG:4979", "EPSG:4978", lon, lat, np.zeros_like(lon))
        jacobian[:, :, axis] = (space[:, 1] - space[:, 0]).T / (2.0 * _PROBE)
    ground = np.linalg.svd(jacobian, compute_uv=False)
    if not (ground > 0.0).all():
        raise ValueError("the map shrinks to a line there")
    return np.asarray(1.0 / ground[:, ::-1], dtype=np.float64)


def north_is_up(crs: Any, x: NDArray[np.float64], y: NDArray[np.float64]) -> bool:
    """Whether the latitude grows with y at all points (n,) of a metric CRS.

    Raises:
        ValueError: if any of the points is nowhere.
    """
    (_, south), (_, north) = (lon_lat(crs, x, y + step) for step in (-_PROBE, _PROBE))
    return bool((north > south).all())


@lru_cache(maxsize=64)
def utm_zone(lon: float, lat: float) -> str:
    """Short code of the metric CRS of that place [degrees]: its UTM zone, or UPS at the poles."""
    pyproj = require("pyproj", PURPOSE)
    here = ((lon + 180.0) % 360.0 - 180.0, lat) * 2
    area = pyproj.aoi.AreaOfInterest(*here)
    zones = pyproj.database.query_utm_crs_info("WGS 84", area, contains=True)
    return f"EPSG:{zones[0].code}" if zones else f"EPSG:{32661 if lat > 0.0 else 32761}"
