# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""In which units a file counts, in height and in plan: by all that it says, and no guess."""

import re
from collections.abc import Sequence
from functools import cache
from typing import Any, NamedTuple

from ltp.world.crs import Box, Unit, height_unit, metric_plan

from .optional import require

METRE = Unit("metre", 1.0)

_USER_DEFINED = 32767
# Spellings that the tables of EPSG and PROJ do not hold.
_ALIASES = {
    "meter": "metre",
    "feet": "foot",
    "international foot": "foot",
    "international feet": "foot",
    "ftus": "us survey foot",
    "foot us": "us survey foot",
    "us foot": "us survey foot",
    "us feet": "us survey foot",
    "us survey feet": "us survey foot",
    "survey foot": "us survey foot",
    "survey feet": "us survey foot",
    "centimeter": "centimetre",
    "millimeter": "millimetre",
    "decimetre": "decimeter",
    "kilometer": "kilometre",
}


class Says(NamedTuple):
    """One place in a file that tells the unit of its heights."""

    where: str  # e.g. "its GeoKey 4099 (VerticalUnits)"
    unit: Unit


class HeightScale(NamedTuple):
    """How the heights of a file become metres."""

    metres: float  # [m] in one unit
    told: bool  # whether the file says so
    report: str  # a sentence


def height_scale(source: object, says: Sequence[Says], convert: bool) -> HeightScale:
    """The factor that brings the heights of `source` to metres.

    Args:
        source: the file.
        says: all that it says of their unit, the most explicit first; nothing means metres.
        convert: whether heights in another unit are scaled, or refused.

    Raises:
        ValueError: naming the file and where it says so, if they are not in metres and `convert` is
            not set, or if it says two things.
    """
    other = [said for said in says if not said.unit.is_metre]
    if not other:
        told = f" ({says[0].where})" if says else ": the file does not say, they are taken for such"
        return HeightScale(1.0, bool(says), f"heights are in metres{told}")
    first = other[0]
    if not convert:
        raise ValueError(
            f"{source} must hold heights in metres, not in {first.unit} as {first.where} says; "
            "with convert_heights they are scaled to metres"
        )
    for said in says:
        # An explicit unit outweighs that of the vertical CRS, metres most often, beside it.
        agrees = abs(said.unit.metres / first.unit.metres - 1.0) < 1e-4
        if not agrees and (first is not says[0] or not said.unit.is_metre):
            raise ValueError(
                f"{source} contradicts itself: heights are in {first.unit} as {first.where} says, "
                f"in {said.unit} as {said.where} says"
            )
    return HeightScale(
        first.unit.metres,
        True,
        f"heights were scaled from {first.unit} to metres ({first.where})",
    )


def metric_frame(
    path: object, crs: Any | None, plan: Says | None, box: Box, name: str | None = None
) -> Any | None:
    """The metric CRS of a file.

    Args:
        path: the file.
        crs: its CRS, a pyproj CRS; None if it names none.
        plan: what a key says of the unit of x and y besides.
        box: where it lies.
        name: what to call the CRS; default: that of the file.

    Returns:
        The horizontal part of `crs`; None if there is none, or it is a site grid in metres.

    Raises:
        ValueError: naming the file, if x and y are not in metres.
    """
    in_feet = plan is not None and not plan.unit.is_metre
    key = f" ({plan.where})" if in_feet and plan is not None else ""
    flat = None if crs is None else metric_plan(crs, name or f"the CRS of {path}{key}", box)
    if in_feet and plan is not None:
        raise ValueError(
            f"{path} must have x and y in metres, not in {plan.unit}, as {plan.where} says; "
            "reproject it first"
        )
    return flat


def refuse_depths(crs: Any, source: str) -> None:
    """Refuse a pyproj CRS whose third axis goes down.

    Raises:
        ValueError: naming `source`.
    """
    if height_unit(crs) is not None and crs.axis_info[2].direction.lower() == "down":
        raise ValueError(f"{source} must hold heights, not depths ({crs.name})")


@cache
def _units() -> tuple[dict[int, Unit], dict[str, Unit]]:
    """Units of length by EPSG code, and by name and PROJ's short name in lower case."""
    database = require("pyproj.database", "telling the units of heights")
    by_code, by_name = {}, {"metre": METRE}
    for name, found in database.get_units_map(category="linear", allow_deprecated=True).items():
        unit = Unit(name, found.conv_factor)
        if found.auth_name == "EPSG":
            by_code[int(found.code)] = unit
        for spelling in (name, found.proj_short_name or name):
            by_name.setdefault(_plain(spelling), unit)
    by_name["dm"] = by_name["decimeter"] = Unit("decimetre", 0.1)  # PROJ's table says 0.01
    return by_code, by_name


def unit_of_code(code: int, size: float | None = None) -> Unit | None:
    """The unit of length with that EPSG code, or of that size [m] if the code is the user's own."""
    if code == _USER_DEFINED:
        return None if size is None or not size > 0.0 else Unit("user-defined unit", size)
    return _units()[0].get(code)


def unit_named(name: str) -> Unit | None:
    """The unit of length of that name in EPSG's, PROJ's or everyday spelling."""
    plain = _plain(name)
    for spelling in (plain, plain.removesuffix("s")):
        found = _units()[1].get(_ALIASES.get(spelling, spelling))
        if found is not None:
            return found
    return None


def unit_in_words(text: str) -> Unit | None:
    """The unit of length in the name of a CRS, such as "NAVD88 height (ftUS)"; feet come first."""
    words = set(re.findall("[a-z]+", text.lower()))
    if words & {"ft", "foot", "feet", "ftus", "usft", "sft"}:
        survey = words & {"us", "survey", "ftus", "usft", "sft"}
        return unit_named("us survey foot" if survey else "foot")
    return METRE if words & {"m", "metre", "metres", "meter", "meters"} else None


def _plain(name: str) -> str:
    return " ".join(name.lower().replace("_", " ").replace("-", " ").split())
