# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Units by EPSG code and by name, GeoKeys by their bytes."""

import struct

import pytest

from ltp.world.crs import Unit
from ltp.world.importers.geokeys import GeoKeys
from ltp.world.importers.units import METRE, Says, height_scale, unit_named, unit_of_code

pytest.importorskip("pyproj")

FOOT, US_FOOT = Unit("foot", 0.3048), Unit("US survey foot", 1200 / 3937)


@pytest.mark.parametrize(
    ("names", "metres"),
    [
        (("m", "M", "metre", "Metre", "metres", "meter", "METERS", " metre "), 1.0),
        (("ft", "foot", "Feet", "international foot"), 0.3048),
        (
            ("us-ft", "us_ft", "ftUS", "US survey foot", "us_survey_foot", "Survey Feet"),
            1200 / 3937,
        ),
        (("yd", "yard", "Yards"), 0.9144),
        (("km", "kilometre", "kilometers"), 1000.0),
        (("cm", "centimetre", "Centimeters"), 0.01),
        (("dm", "decimetre", "decimeters"), 0.1),
        (("mm", "millimetres"), 0.001),
        (("in", "inch"), 0.0254),
        (("Clarke's foot",), 0.3047972654),
        (("fathom",), 1.8288),
    ],
)
def test_units_have_many_names(names: tuple[str, ...], metres: float) -> None:
    for name in names:
        unit = unit_named(name)
        assert unit is not None, name
        assert unit.metres == pytest.approx(metres, rel=1e-9), name


@pytest.mark.parametrize("name", ["", "furlongs", "degree", "s", "m/s", "metre squared", "dB"])
def test_other_words_are_no_unit_of_length(name: str) -> None:
    assert unit_named(name) is None


def test_units_by_code() -> None:
    codes = {9001: 1.0, 9002: 0.3048, 9003: 1200 / 3937, 9005: 0.3047972654, 9096: 0.9144}
    for code, metres in codes.items():
        unit = unit_of_code(code)
        assert unit is not None
        assert unit.metres == pytest.approx(metres, rel=1e-9)
    assert unit_of_code(9102) is None  # a degree
    assert unit_of_code(32767) is None
    assert unit_of_code(32767, 0.3048) == Unit("user-defined unit", 0.3048)


def test_a_metre_may_have_another_name() -> None:
    assert Unit("Gerhardt's rod", 1.0).is_metre
    assert Unit("German legal metre", 1.0000135965).is_metre
    assert not US_FOOT.is_metre
    assert not Unit("metre", 0.9144).is_metre


def test_what_is_said_of_heights() -> None:
    assert height_scale("a", [], False) == (
        1.0,
        False,
        "heights are in metres: the file does not say, they are taken for such",
    )
    assert height_scale("a", [Says("its key", METRE)], False)[:2] == (1.0, True)
    assert height_scale("a", [Says("its key", FOOT), Says("its CRS", METRE)], True).metres == 0.3048
    nearly = [Says("its key", FOOT), Says("its CRS", US_FOOT)]  # 0.6 mm in 300 m
    assert height_scale("a", nearly, True).metres == 0.3048
    with pytest.raises(ValueError, match="a must hold heights in metres, not in foot"):
        height_scale("a", [Says("its CRS", FOOT)], False)
    with pytest.raises(ValueError, match="a contradicts itself"):
        height_scale("a", [Says("its key", METRE), Says("its CRS", FOOT)], True)


@pytest.mark.parametrize(
    "directory",
    [
        b"",
        b"\1\0",
        struct.pack("<4H", 2, 1, 0, 0),
        struct.pack("<4H", 1, 1, 0, 3),
        struct.pack("<8H", 1, 1, 0, 1, 3077, 34736, 1, 5),  # beyond its numbers
    ],
)
def test_cut_geokeys_are_refused(directory: bytes) -> None:
    with pytest.raises(ValueError, match="GeoKey"):
        GeoKeys.parse(directory, b"\0" * 8)
