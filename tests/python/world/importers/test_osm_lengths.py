# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Heights and storeys, in all the ways that people write them; what nobody can read is None."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from ltp.world.importers.osm.lengths import count, length

FOOT, INCH, YARD, MILE = 0.3048, 0.0254, 0.9144, 1609.344

METRES = (
    "m", " m", "m.", " mt", " mts", " mtr", " meters", " metre", " Meter", " mètres", " metros",
    " м", " м.", " метров", " 米", "米", " 公尺", " メートル", " ㍍", " 미터", " מטר", " متر",
    " मीटर", " เมตร", " מ׳", " მ", " metrów", "ｍ", "\u00a0m",
)  # fmt: skip
FEET = ("'", "′", "’", "´", "`", "＇", " ft", "ft", " ft.", " feet", " foot", " Fuß", " pieds",
        " pies", " pés", " футов", " 呎", " フィート", " 피트", "-ft")  # fmt: skip
OTHERS = {
    " km": 1000.0, "km": 1000.0, " км": 1000.0, " cm": 0.01, "cm.": 0.01, " см": 0.01,
    " 厘米": 0.01, " mm": 0.001, " in": INCH, '"': INCH, "″": INCH, "''": INCH, "’’": INCH,
    " yd": YARD, " yds": YARD, " yards": YARD, " yd.": YARD, " mi": MILE, " dm": 0.1,
}  # fmt: skip
ABOUT = ("~", "~ ", "≈", "± ", "ca. ", "ca ", "ca.", "c. ", "circa ", "approx. ", "about ",
         "около ", "約", ">", ">= ", "≥", "<", "≤ ", "=", "+", "up to ", "max. ",
         "est. ", "over ")  # fmt: skip
ENDS = ("+", " +", "?", " ?", ".", " (approx.)", " approx.", " ca.", ";", ",", " agl", " high")
RANGES = ("-", " - ", "–", " – ", "—", "−", "..", " ... ", "…", "~", "～", " to ", " bis ", " à ")


@pytest.mark.parametrize("unit", METRES)
@pytest.mark.parametrize("number", ["12", "12.5", "12,5", "120", "7.25", ".5", "１２", "١٢", "12½"])
def test_metres_in_any_script(number: str, unit: str) -> None:
    plain = {"12,5": 12.5, "１２": 12.0, "١٢": 12.0, "12½": 12.5}.get(number) or float(number)
    assert length(number + unit) == pytest.approx(plain)
    assert length(number) == pytest.approx(plain)


@pytest.mark.parametrize("unit", FEET)
@pytest.mark.parametrize("number", [40.0, 69.5, 574.0])
def test_feet_in_any_script(number: float, unit: str) -> None:
    assert length(f"{number:g}{unit}") == pytest.approx(number * FOOT)


@pytest.mark.parametrize(("unit", "metres"), OTHERS.items())
def test_other_units(unit: str, metres: float) -> None:
    number = round(12.0 / metres, 4)
    assert length(f"{number:.4f}{unit}") == pytest.approx(number * metres)


@pytest.mark.parametrize("about", ABOUT)
@pytest.mark.parametrize("rest", ["120", "120 m", "120.0", "0.12 km"])
def test_signs_of_doubt_before_a_number(about: str, rest: str) -> None:
    assert length(about + rest) == pytest.approx(120.0)


@pytest.mark.parametrize("end", ENDS)
@pytest.mark.parametrize("start", ["120", "120 m", "ca. 120"])
def test_signs_of_doubt_behind_a_number(start: str, end: str) -> None:
    assert length(start + end) == pytest.approx(120.0)


@pytest.mark.parametrize("sign", RANGES)
@pytest.mark.parametrize(("unit", "metres"), [("", 1.0), (" m", 1.0), (" ft", FOOT), ("'", FOOT)])
def test_ranges_take_the_upper_value(sign: str, unit: str, metres: float) -> None:
    assert length(f"100{sign}120{unit}") == pytest.approx(120.0 * metres)
    assert length(f"ca. 100{unit}{sign}120{unit}") == pytest.approx(120.0 * metres)
    assert length(f"120{sign}100{unit}") == pytest.approx(120.0 * metres)


@pytest.mark.parametrize(
    ("text", "metres"),
    [
        ("5'10\"", 5 * FOOT + 10 * INCH),
        ("5′10″", 5 * FOOT + 10 * INCH),
        ("5’ 10”", 5 * FOOT + 10 * INCH),
        ("5' 10''", 5 * FOOT + 10 * INCH),
        ("5'-10\"", 5 * FOOT + 10 * INCH),
        ("5'10", 5 * FOOT + 10 * INCH),
        ("394'0", 394 * FOOT),
        ("394 ft 0 in", 394 * FOOT),
        ("394 feet 6 inches", 394.5 * FOOT),
        ("12ft6in", 12.5 * FOOT),
        ("6' 2½\"", 6 * FOOT + 2.5 * INCH),
        ("6 1/2 ft", 6.5 * FOOT),
        ("1 m 50 cm", 1.5),
        ("1m50", 1.5),
        ("4 yd 1 ft", 4 * YARD + FOOT),
    ],
)
def test_numbers_in_two_units(text: str, metres: float) -> None:
    assert length(text) == pytest.approx(metres)


@pytest.mark.parametrize(
    ("text", "metres"),
    [
        ("5;5.5", 5.5),
        ("3 m; 10 ft", 3.048),
        ("12/15", 15.0),
        ("12 m (39 ft)", 12.0),
        ("39 ft (12 m)", 12.0),
        ("12 m / 40 ft", 40 * FOOT),
        ("12 or 15", 15.0),
        ("12; tall", 12.0),
        ("12+3", 15.0),
        ("120 ± 5", 125.0),
        ("120+/-5 m", 125.0),
        ("100、120", 120.0),
    ],
)
def test_of_a_list_the_largest_and_of_a_sum_the_whole(text: str, metres: float) -> None:
    assert length(text) == pytest.approx(metres)


@pytest.mark.parametrize(
    ("text", "metres"),
    [
        ("1,234", None),  # 1234 m is no height, and 1.234 m is not what it says
        ("1,234 m", None),
        ("1,234 ft", 1234 * FOOT),
        ("1,234'", 1234 * FOOT),
        ("1 234 ft", 1234 * FOOT),
        ("1\u202f234 ft", 1234 * FOOT),
        ("1,234.5 ft", 1234.5 * FOOT),
        ("1.234,5 ft", 1234.5 * FOOT),
        ("12,500 mm", 12.5),
        ("1,234,567 mm", None),
        ("123,456 mm", 123.456),
        ("0,123 km", 123.0),
        ("1.234", 1.234),
        ("12,50", 12.5),
        ("30, 40", 40.0),
    ],
)
def test_a_comma_before_three_digits_separates_thousands(text: str, metres: float | None) -> None:
    assert length(text) == (None if metres is None else pytest.approx(metres))


@pytest.mark.parametrize(
    "text",
    ["", None, "tall", "0", "-3", "12 km", "12000", "1e9", "9" * 50, "9" * 400, "nan", "inf",
     "five", "12 x 5", "1 2", "1.2.3", "5 storeys", "12 m AMSL", "m", "'", "ft", "-", "1'234",
     "12 parsecs"],
)  # fmt: skip
def test_what_nobody_can_read_is_nothing(text: str | None) -> None:
    assert length(text) is None


@given(st.text())
def test_no_text_is_too_odd(text: str) -> None:
    value = length(text)
    assert value is None or 0.0 < value <= 1000.0
    levels = count(text)
    assert levels is None or levels >= 0.0


@pytest.mark.parametrize(
    ("text", "levels"),
    [
        ("3", 3.0), ("2.5", 2.5), ("3,5", 3.5), ("2½", 2.5), ("2+1", 3.0), ("2 + 1", 3.0),
        ("2+1+1", 4.0), ("3-4", 4.0), ("3–4", 4.0), ("3;4", 4.0), ("1,2,3", 3.0), ("3+", 3.0),
        ("R+4", 5.0), ("RDC+2", 3.0),
        ("~3", 3.0), ("ca. 5", 5.0), (">5", 5.0), ("5 floors", 5.0), ("G+3", 4.0), ("٣", 3.0),
        ("0", 0.0), ("-1", None), ("-2;-1", None), ("-1-3", 3.0), ("-1;3", 3.0), ("", None),
        (None, None), ("many", None),
    ],
)  # fmt: skip
def test_numbers_of_storeys(text: str | None, levels: float | None) -> None:
    assert count(text) == levels
