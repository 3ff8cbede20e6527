# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a coordinate reference system (CRS) says: its units, its short name, its scale on the spot.

A CRS is a pyproj CRS, or any text that names one; bounds are x_min, y_min, x_max, y_max in it.
"""

from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np

from .geodesy import PURPOSE, from_lon_lat, lon_lat, north_is_up, scales, utm_zone
from .importers.optional import require

Box = tuple[float, float, float, float]

#: A metre of the map may be this much longer or shorter than one on the ground.
MAX_SCALE_ERROR = 0.01

_SAME_UNIT = 1e-4  # the German legal metre is 1.4e-5 longer than the metre, the foot far shorter
_TINY_CELL = 0.01  # no map of a city has smaller cells [m]; rasters in degrees have
_SMALL_CELL = 0.1  # nor such, away from the origin of a local frame [m]
_SMALL_SPAN = 1.0  # nor is so small [m]; a degree spans 111 km
_LAT_LON = {
    "subtype": "ellipsoidal",
    "axis": [
        {"name": "Latitude", "abbreviation": "Lat", "direction": "north", "unit": "degree"},
        {"name": "Longitude", "abbreviation": "Lon", "direction": "east", "unit": "degree"},
    ],
}
_PROBES = 4  # points along each side of an area at which its scale is measured


@dataclass(frozen=True)
class Unit:
    """A unit of length."""

    name: str
    metres: float  # [m] in one

    @property
    def is_metre(self) -> bool:
        """Whether it is the metre, whatever it is called."""
        return abs(self.metres - 1.0) < _SAME_UNIT

    def __str__(self) -> str:
        return f"{self.name} ({self.metres:.8g} m)"


def any_crs(crs: Any, source: str) -> Any:
    """The pyproj CRS that `crs` names; `source` names the argument or file in the message.

    Raises:
        ImportError: if pyproj is not installed.
        ValueError: if nobody knows that CRS.
    """
    pyproj = require("pyproj", PURPOSE)
    try:
        known = pyproj.CRS.from_user_input(crs)
        known.to_json_dict()  # fails where a parameter is no finite number
        return known
    except (pyproj.exceptions.CRSError, ValueError) as error:
        named = str(crs) if len(str(crs)) < 60 else f"{str(crs)[:60]} ..."
        reason = str(error).rpartition("Internal Proj Error: ")[2].rstrip(")") or "unknown"
        raise ValueError(
            f"{source} must be a known CRS, e.g. EPSG:32618, not {named!r} ({reason[:200]})"
        ) from error


def horizontal(crs: Any) -> Any:
    """The part of a pyproj CRS that tells x and y."""
    while crs.is_compound or crs.is_bound:
        crs = crs.sub_crs_list[0] if crs.is_compound else crs.source_crs
    return crs.to_2d() if len(crs.axis_info) > 2 and not crs.is_geocentric else crs


def height_unit(crs: Any) -> Unit | None:
    """The unit of the vertical axis of a pyproj CRS; None if it has no such axis."""
    if crs.is_geocentric or len(crs.axis_info) < 3:
        return None
    axis = crs.axis_info[2]
    return Unit(axis.unit_name, axis.unit_conversion_factor)


def height_datum(crs: Any) -> str | None:
    """What the heights of a pyproj CRS count from; None if it has no vertical axis."""
    if height_unit(crs) is None:
        return None
    if not crs.is_compound:
        return "ellipsoid"
    vertical = crs.sub_crs_list[1]
    vertical = vertical.source_crs if vertical.is_bound else vertical
    return str(vertical.datum.name if vertical.datum is not None else vertical.name)


def metric_crs(crs: Any, source: str, bounds: Box | None = None) -> Any:
    """The horizontal part of `crs` as a pyproj CRS: projected, in metres, x east and y north.

    `source` names the argument or file in the message; `bounds`, the area in question, makes the
    message name a CRS that would do there. Units count by their factor, not by their name.

    Raises:
        ImportError: if pyproj is not installed.
        ValueError: if nobody knows that CRS, or it is something else.
    """
    known = any_crs(crs, source)
    flat = horizontal(known)
    if not (flat.is_projected or flat.is_geographic):
        raise ValueError(
            f"{source} must be a projected CRS in metres, not {known.name} ({known.type_name})"
        )
    flaw = _flaw(flat, known.name)
    if flaw is not None:
        raise ValueError(f"{source} must be {flaw}; reproject it first, to {_cure(flat, bounds)}")
    return flat


def metric_plan(crs: Any, source: str, bounds: Box | None = None) -> Any | None:
    """What `metric_crs` returns; None for a site grid in metres (an engineering CRS).

    Raises:
        ImportError: if pyproj is not installed.
        ValueError: as `metric_crs` does.
    """
    flat = horizontal(any_crs(crs, source))
    if flat.is_engineering and all(
        Unit(axis.unit_name, axis.unit_conversion_factor).is_metre for axis in flat.axis_info
    ):
        return None
    return metric_crs(crs, source, bounds)


def _flaw(flat: Any, name: str) -> str | None:
    """Why a projected or geographic CRS is no metric map: what it must be, "not" what it is."""
    if flat.is_geographic:
        return f"a projected CRS in metres, not in degrees ({name})"
    for axis in flat.axis_info:
        unit = Unit(axis.unit_name, axis.unit_conversion_factor)
        if not unit.is_metre:
            return f"a projected CRS in metres, not {name} in {unit}"
    directions = [axis.direction.lower() for axis in flat.axis_info]
    if "west" in directions:
        return f"a CRS whose axes go east and north, not {' and '.join(directions)} as in {name}"
    return None


@lru_cache(maxsize=64)
def crs_name(crs: Any) -> str:
    """Short name of a pyproj CRS: the EPSG code of its horizontal part, or else its WKT.

    However the CRS is spelt (WKT of any dialect, PROJ, compound, axis order), the same grid has the
    same code; a code is given only to a CRS that is equivalent to the one of that code.
    """
    pyproj = require("pyproj", PURPOSE)
    flat = horizontal(crs)
    code = flat.to_epsg(min_confidence=100)
    if code is not None:
        return f"EPSG:{code}"
    for spelling in (flat, _unspelt(flat, north_first=True)):
        for match in spelling.list_authority(auth_name="EPSG", min_confidence=20):
            if same_grid(pyproj.CRS.from_epsg(match.code), flat):
                return f"EPSG:{match.code}"
    return str(flat.to_wkt())


def same_grid(crs: Any, other: Any) -> bool:
    """Whether two CRSs (pyproj, or text) give x and y alike; heights and spelling do not matter."""
    one, two = (horizontal(any_crs(each, "crs")) for each in (crs, other))
    return bool(one == two or _unspelt(one).equals(_unspelt(two)))


def _unspelt(flat: Any, north_first: bool = False) -> Any:
    """A horizontal CRS without what makes no difference to x (east) and y (north)."""
    if not flat.is_projected:
        return flat
    parts = flat.to_json_dict()
    for key in ("id", "scope", "area", "bbox", "usages", "remarks"):
        parts.pop(key, None)
    parts["name"] = parts["conversion"]["name"] = "any"
    parts["base_crs"]["coordinate_system"] = _LAT_LON
    axes = parts["coordinate_system"]["axis"]
    if {axis["direction"] for axis in axes} == {"east", "north"}:
        axes.sort(key=lambda axis: str(axis["direction"]), reverse=north_first)
        for axis in axes:
            name = f"{axis['direction'].capitalize()}ing"  # Easting, Northing
            axis.update(name=name, abbreviation=name[0])
    return type(flat).from_json_dict(parts)


def check_scale(crs: Any, bounds: Box, source: str) -> float:
    """How far a metre of the map is from one on the ground within `bounds`, as a share of it.

    Args:
        crs: a metric CRS, from `metric_crs`.
        bounds: the area [m].
        source: names the argument or file in the message.

    Returns:
        The largest deviation of the scale from 1, over the area and all directions.

    Raises:
        ValueError: if it exceeds `MAX_SCALE_ERROR`, saying by how much, and which CRS would do; or
            if the bounds are nowhere in that CRS.
    """
    sides = np.linspace(bounds[:2], bounds[2:], _PROBES)
    x, y = (axis.ravel() for axis in np.meshgrid(*sides.T))
    try:
        found = scales(crs, x, y).ravel()
    except ValueError as error:
        raise ValueError(f"{source}: {bounds} does not lie in {crs.name}: {error}") from error
    transverse = "Transverse Mercator" in str(crs.coordinate_operation.method_name)
    if transverse and not north_is_up(crs, x, y):  # true again beyond the pole
        raise ValueError(
            f"{source}: north is down in {crs.name} here, on the far side of the Earth; use "
            f"{_cure(crs, bounds)}"
        )
    worst = float(found[np.abs(found - 1.0).argmax()])
    if abs(worst - 1.0) > MAX_SCALE_ERROR:
        raise ValueError(
            f"{source}: a metre on the ground is {worst:.3f} m in {crs.name} here, more than "
            f"{MAX_SCALE_ERROR:.0%} off; use {_cure(crs, bounds)}"
        )
    return abs(worst - 1.0)


def crs_report(crs: Any | None, deviation: float | None, where: str) -> str:
    """The sentence of an import about its CRS.

    Args:
        crs: the horizontal CRS, a pyproj CRS; None if nobody names one.
        deviation: from `check_scale`.
        where: "by" or "as" what, e.g. "by its WKT".
    """
    if crs is None:
        return "CRS: none is named; x and y are taken for metres, east and north"
    scale = "" if deviation is None else f"; a metre of it is one on the ground to {deviation:.2%}"
    return f"CRS: {crs_name(crs)[:60]} ({crs.name}) {where}, in metres{scale}"


def _cure(crs: Any, bounds: Box | None) -> str:
    """A metric CRS for an area in any CRS, as far as that can be told."""
    generic = "the UTM zone of the place, e.g. EPSG:32618"
    if bounds is None:
        return generic
    try:
        x, y = 0.5 * (bounds[0] + bounds[2]), 0.5 * (bounds[1] + bounds[3])
        lon, lat = lon_lat(crs, x, y)
    except ValueError:
        return generic
    return f"{utm_zone(lon, lat)} (the place lies at longitude {lon:.4f}, latitude {lat:.4f})"


def looks_like_degrees(bounds: Box, cell: float | None = None) -> bool:
    """Whether an area cannot be meant in metres, but can in degrees of longitude and latitude.

    It lies within -180...360 and -90...90, and is less than 1 m wide and high, or its cells are no
    larger than 1 cm (10 cm, if it lies off the origin, where local frames begin). The thresholds
    are assumed: 1 cm taken for degrees is 1.1 km.
    """
    x0, y0, x1, y1 = bounds
    if not (-180.0 <= x0 <= x1 <= 360.0 and -90.0 <= y0 <= y1 <= 90.0):
        return False
    if x1 - x0 < _SMALL_SPAN and y1 - y0 < _SMALL_SPAN and (x1 > x0 or y1 > y0):
        return True
    at_origin = x0 <= 0.0 <= x1 and y0 <= 0.0 <= y1
    return cell is not None and cell < (_TINY_CELL if at_origin else _SMALL_CELL)


def refuse_degrees(
    bounds: Box, source: str, cell: float | None = None, crs: Any | None = None
) -> None:
    """Refuse an area that looks like degrees where metres are expected.

    `cell` is the size of its cells, if any; `crs` the pyproj CRS that it should be in, if known.

    Raises:
        ValueError: naming `source`, and what the area would be in metres.
    """
    if not looks_like_degrees(bounds, cell):
        return
    x, y = 0.5 * (bounds[0] + bounds[2]), 0.5 * (bounds[1] + bounds[3])
    where = f"{bounds[0]:.8g}, {bounds[1]:.8g}, {bounds[2]:.8g}, {bounds[3]:.8g}"
    zone = utm_zone(x, y)
    if crs is None:
        cure = f"reproject to {zone} first"
    else:
        cure = f"in {crs_name(crs)[:40]} that is {_projected(crs, bounds)}"
    raise ValueError(f"{source} must be in metres; {where} looks like degrees: {cure}")


def _projected(crs: Any, bounds: Box) -> str:
    """Bounds in degrees, in metres of `crs`."""
    x0, y0, x1, y1 = bounds
    try:
        x, y = from_lon_lat(crs, [x0, x1, x0, x1], [y0, y0, y1, y1])
    except ValueError:
        return "nowhere"
    return f"{x.min():.0f}, {y.min():.0f}, {x.max():.0f}, {y.max():.0f}"
