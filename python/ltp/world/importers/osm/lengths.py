# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lengths and numbers of storeys, in all the ways that mappers write them."""

import re
import unicodedata
from functools import lru_cache

TALLEST = 1000.0  # a height above this is a slip of the keyboard [m]

_FOOT, _INCH, _YARD, _MILE = 0.3048, 0.0254, 0.9144, 1609.344  # international, exact [m]

_METRE_WORDS = (
    "m mt mts mtr mtrs meter meters metern metre metres metro metros mètre mètres metri metry "
    "metru metrů metrów metrar metriä méter mét м метр метра метров метри метрів μ μέτρα μετρα "
    "米 公尺 メートル 미터 מטר מ متر م मीटर मी মিটার เมตร ม მეტრი მ մետր մ"
)
_FOOT_WORDS = (
    "' ft fts feet feets foot fuß fuss pied pieds pie pies pés фут фута футов 呎 英尺 フィート "
    "フット 피트 قدم फुट फीट ฟุต רגל"
)
_INCH_WORDS = '" in ins inch inches zoll pouce pouces дюйм 吋 英寸 インチ'
_UNITS: dict[str, float] = {
    **dict.fromkeys(_METRE_WORDS.split(), 1.0),
    **dict.fromkeys(("km", "kms", "kilometer", "kilometre", "км", "公里", "千米"), 1000.0),
    **dict.fromkeys(("dm", "дм"), 0.1),
    **dict.fromkeys(("cm", "cms", "см", "厘米", "公分", "センチ"), 0.01),
    **dict.fromkeys(("mm", "мм", "毫米"), 0.001),
    **dict.fromkeys(_FOOT_WORDS.split(), _FOOT),
    **dict.fromkeys(_INCH_WORDS.split(), _INCH),
    **dict.fromkeys(["yd", "yds", "yard", "yards", "ярд", "碼", "码"], _YARD),
    **dict.fromkeys(["mi", "mile", "miles"], _MILE),
}
# What a second number without a unit of its own counts in (394'0, 1 m 50), and what it is below.
_NEXT_UNIT = {_FOOT: (_INCH, 12.0), 1.0: (0.01, 100.0), _YARD: (_FOOT, 3.0)}

_SIGNS = str.maketrans(
    {
        **dict.fromkeys("′’‘ʹ`´ʼ‛׳", "'"),
        **dict.fromkeys("″”“„ʺ˝״", '"'),
        **dict.fromkeys("–—−‒―‐‑", "-"),
        **dict.fromkeys("∼〜", "~"),
        **dict.fromkeys("،|、", ";"),
        "⁄": "/",
        "٫": ".",
        "٬": ",",
    }
)
_FRACTIONS = {"¼": ".25", "½": ".5", "¾": ".75", "⅓": ".333", "⅔": ".667"}
_NUMBER = r"(?:\d+(?:[ ,.]\d+)*|\.\d+)"
_WORD = r"'|\"|[^\W\d_][^\s\d'\"+~.,;()-]*"  # not \w alone: vowel signs are no letters
_QUANTITY = re.compile(rf"({_NUMBER})\s*({_WORD})?[.,]?\s*")
_ABOUT = re.compile(
    r"^(?:[-~≈≃≅±><≥≤=\s]|(?:ca|c|circa|approx|approximately|appr|about|around|roughly|"
    r"etwa|ungefähr|rund|environ|env|aprox|около|约|約|est|estimated|up to|over|min|max|"
    r"from|de|von|entre|between|bis|од|от)(?![^\W\d_])\.?:?)+"
)
_HIGH = re.compile(
    r"(?:\s|\+|\?|!|(?<![^\W\d_])(?:approx|approximately|ca|est|estimated|agl|high|tall|hoch)\.?)+$"
)
_RANGE = re.compile(
    r"\s*(?:[-~]|\.\.+|…|\bto\b|\bbis\b|\bà\b|\band\b|\by\b|\bund\b|\bdo\b|до|至)\s*"
)
_MIXED = re.compile(r"(\d{1,4}) (\d)/([2-9])(?!\d)")  # 5 1/2
_HYPHENS = re.compile(r"(?<=\d)-(?=[^\W\d])|(?<=')\s*-\s*(?=\d+(?:\.\d+)?\s*\")")  # 12-ft, 5'-10"
_UNIT = re.compile(r"\d[.,]?\s*([^\d\s.,+]+)[.,]?\s*$")
_BARE = re.compile(r"[\d.,\s]+")
_TOLERANCE = re.compile(r"(?<=[^\s])\s*(?:\+/-|±)\s*(?=\d)")  # 120 ± 5: at most 125
_LONGEST = 100  # of a text that is still read
_ALTERNATIVE = re.compile(r"[;/()\[\]]|\bor\b|\boder\b|(?<=\d),\s+(?=\d)")
_GROUND_FLOORS = frozenset({"g", "gf", "r", "rc", "rdc", "p"})  # English, French, Serbian


@lru_cache(maxsize=4096)
def length(text: str | None) -> float | None:
    """A length in metres out of what people write: "12", "12,5 m", "40'", "394 ft 0 in".

    Of a list ("12;15", "12 m (39 ft)") and of a range ("100-120") the largest counts, of a sum
    ("12+3") the whole. Signs of doubt ("~12", "ca. 12", ">12", "12+") are passed over. A comma
    before three digits separates thousands. None if there is no number that makes sense: nothing
    readable, not above zero, or more than 1000 m.
    """
    return max((v for v in map(_one_length, _pieces(text)) if v is not None), default=None)


@lru_cache(maxsize=4096)
def count(text: str | None) -> float | None:
    """A number of storeys out of "3", "2.5", "3,5", "3-4", "3;4", "2+1" (three) or "ca. 5 floors".

    None if there is none, or if it lies below zero (storeys underground).
    """
    return max((v for v in map(_one_count, _pieces(text)) if v is not None), default=None)


def _pieces(text: str | None) -> list[str]:
    """The alternatives that a text lists, in lower case and with plain signs."""
    if not text or len(text) > _LONGEST:
        return []
    for sign, digits in _FRACTIONS.items():
        text = re.sub(rf"(?<=\d)\s*{sign}", digits, text).replace(sign, "0" + digits)
    plain = unicodedata.normalize("NFKC", text.translate(_SIGNS)).translate(_SIGNS).lower()
    plain = "".join(_digit(character) for character in plain).replace("''", '"')
    plain = _MIXED.sub(lambda m: f"{int(m[1]) + int(m[2]) / int(m[3]):.3f}", plain)
    plain = _TOLERANCE.sub("+", _HYPHENS.sub(" ", plain)).replace("מ'", "מ")
    return [piece.strip() for piece in _ALTERNATIVE.split(plain)]


def _digit(character: str) -> str:
    value = unicodedata.decimal(character, None)
    return character if value is None else str(value)


def _one_length(piece: str) -> float | None:
    text = _HIGH.sub("", _ABOUT.sub("", piece)) if not _negative(piece) else ""
    if not text:
        return None
    ends = [part for part in _RANGE.split(text) if part]
    unit = _UNIT.search(ends[-1]) if ends else None
    if unit is not None:  # of the last number, and of those before it that have none: 10-12 ft
        ends = [f"{end} {unit[1]}" if _BARE.fullmatch(end) else end for end in ends]
    found = [value for end in ends if (value := _sum(end)) is not None]
    value = max(found, default=0.0)
    return value if len(found) == len(ends) and 0.0 < value <= TALLEST else None


def _negative(piece: str) -> bool:
    return re.match(r"-\s*\d[^-]*$", piece) is not None


def _sum(text: str) -> float | None:
    values = [_quantities(part.strip()) for part in text.split("+") if part.strip()]
    known = [value for value in values if value is not None]
    return sum(known) if known and len(known) == len(values) else None


def _quantities(text: str) -> float | None:
    """Numbers with units, from the large unit to the small: "394 ft 0 in", "5'10"."""
    total, unit, at = 0.0, 0.0, 0
    while at < len(text):
        match = _QUANTITY.match(text, at)
        number = None if match is None else _number(match[1])
        if match is None or number is None:
            return None
        word = match[2]
        factor = 1.0 if word is None else _UNITS.get(word)
        if word is None and unit:
            factor, most = _NEXT_UNIT.get(unit, (None, 0.0))
            if number >= most:
                return None
        if factor is None or (unit and factor >= unit):
            return None
        total, unit, at = total + number * factor, factor, match.end()
    return total if at > 0 else None


def _number(text: str) -> float | None:
    """A number with its separators: 1,234 and 1 234 are thousands, 12,5 and 12.5 are not."""
    if re.fullmatch(r"\d*[.,]\d+|\d+", text) and not re.fullmatch(r"[1-9]\d{0,2},\d{3}", text):
        return float(text.replace(",", "."))
    if re.fullmatch(r"\d{1,3}(?:,\d{3})+(?:\.\d+)?", text):
        return float(text.replace(",", ""))
    if re.fullmatch(r"\d{1,3}(?:\.\d{3})+,\d+|\d{1,3}(?:\.\d{3}){2,}", text):
        return float(text.replace(".", "").replace(",", "."))
    if re.fullmatch(r"\d{1,3}(?: \d{3})+(?:[.,]\d+)?", text):
        return float(text.replace(" ", "").replace(",", "."))
    return None


def _one_count(piece: str) -> float | None:
    if _negative(piece):
        return None
    text = _ABOUT.sub("", piece)
    values = [_storeys(part) for part in _RANGE.split(text) if part.strip()]
    return max((value for value in values if value is not None), default=None)


def _storeys(text: str) -> float | None:
    """The sum of "2+1", the largest of "1,2,3"."""
    total = 0.0
    for part in text.split("+"):
        numbers = re.findall(r"\d{1,4}(?:[.,]\d{1,3})?(?!\d)", part)
        if part.strip() in _GROUND_FLOORS:  # G+3: a ground floor and three
            numbers = ["1"]
        if part.count(",") > 1:
            numbers = re.findall(r"\d{1,4}", part)
        if not numbers:
            if part.strip():
                return None
            continue
        total += max(float(number.replace(",", ".")) for number in numbers)
    return total
