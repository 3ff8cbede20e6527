# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the class of a laser return means: the standard's, and the producer's own from 64 on."""

import enum
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ltp.world.classes import LandClass, land_class

from ..optional import require

#: Code -> LandClass, its name in any case, its number, or "noise".
Meanings = Mapping[int, LandClass | str | int]

#: Whose meaning the classes 64 to 255 have: by what the file says, the French survey's, nobody's.
USER_CLASSES = ("auto", "ign", "none")
_NOISE = "noise"


class Role(enum.IntEnum):
    """What a return is to the world."""

    UNDEFINED = 0  # nobody says: an obstacle if it stands above the ground, else unknown ground
    GROUND = 1
    PLANT = 2
    STRUCTURE = 3
    CLUTTER = 4  # unclassified: an obstacle if it stands above the ground, else nothing
    DROPPED = 5


_TAKEN_FOR = {
    Role.UNDEFINED: "obstacles where they stand above the ground, else UNKNOWN",
    Role.GROUND: "ground",
    Role.PLANT: "plants",
    Role.STRUCTURE: "BUILDING",
    Role.CLUTTER: "obstacles where they stand above the ground, else nothing",
    Role.DROPPED: "nothing: dropped",
}

# LAS 1.4 R15, tables 9 and 10. In files of the older point formats 8 are key points of the ground
# and 12 is overlap; newer files that were made from such keep them.
_STANDARD = {
    0: ("never classified", Role.CLUTTER),
    1: ("unclassified", Role.CLUTTER),
    2: ("ground", Role.GROUND),
    3: ("low vegetation", Role.PLANT),
    4: ("medium vegetation", Role.PLANT),
    5: ("high vegetation", Role.PLANT),
    6: ("building", Role.STRUCTURE),
    7: ("low noise", Role.DROPPED),
    8: ("key point of the ground", Role.GROUND),
    9: ("water", Role.GROUND),
    10: ("rail", Role.GROUND),
    11: ("road surface", Role.GROUND),
    12: ("overlap", Role.DROPPED),
    13: ("wire guard", Role.STRUCTURE),
    14: ("wire conductor", Role.STRUCTURE),
    15: ("transmission tower", Role.STRUCTURE),
    16: ("wire connector", Role.STRUCTURE),
    17: ("bridge deck", Role.STRUCTURE),
    18: ("high noise", Role.DROPPED),
    19: ("overhead structure", Role.CLUTTER),
    20: ("ignored ground", Role.CLUTTER),
    21: ("snow", Role.CLUTTER),
    22: ("temporal exclusion", Role.UNDEFINED),
}
_KINDS = {9: LandClass.WATER, 10: LandClass.RAIL, 11: LandClass.ROAD}

# IGN, LiDAR HD: "sursol perenne", "artefacts", "points virtuels", "divers - batis".
_IGN = {
    64: ("permanent object, IGN", Role.STRUCTURE),
    65: ("artefact, IGN", Role.DROPPED),
    66: ("virtual point, IGN", Role.DROPPED),
    67: ("other built, IGN", Role.DROPPED),
}
_FIRST_USER = 64

# Geodetic systems of France and its territories, by the start of their names in the EPSG registry.
_FRENCH = ("RGF93", "NTF", "RGAF09", "RRAF", "RGFG95", "RGR92", "RGM04", "RGM23", "RGSPM06")
_FRENCH_MAKER = re.compile(r"(?<![A-Za-z])IGN(F|\b|_)|LIDAR[ _-]?HD(?![A-Za-z])", re.IGNORECASE)


def french_by(crs: str | None, header: Any) -> str | None:
    """What says that a survey with that header is of the French mapping agency, if anything does.

    Its CRS, if it is of France or a territory of it, or the system or software that made the file.
    """
    if crs is not None:
        pyproj = require("pyproj", "working with map coordinates")
        known = pyproj.CRS.from_user_input(crs)
        if str(known.geodetic_crs.name).startswith(_FRENCH):
            return f"its CRS is {known.name}"
    for what in ("system_identifier", "generating_software"):
        said = getattr(header, what, "")
        text = said.decode("latin-1") if isinstance(said, bytes) else str(said)
        if _FRENCH_MAKER.search(text):
            return f"its header says {text.strip(chr(0)).strip()!r}"
    return None


@dataclass(frozen=True)
class Codes:
    """The meaning of each of the 256 classes."""

    names: Mapping[int, str]
    roles: NDArray[np.uint8]  # (256,) Role
    kinds: NDArray[np.uint8]  # (256,) LandClass that the ground gets; UNKNOWN: none
    report: tuple[str, ...] = field(default=())

    @staticmethod
    def of(user_classes: str, table: Meanings | None, crs: str | None, header: Any) -> "Codes":
        """The meanings for a survey.

        Args:
            user_classes: one of `USER_CLASSES`.
            table: meanings that the user gives, which win over all others.
            crs: CRS of the survey.
            header: of the file.

        Raises:
            ValueError: naming the argument that is none of what it can be.
        """
        if user_classes not in USER_CLASSES:
            known = ", ".join(USER_CLASSES)
            raise ValueError(f"user_classes must be one of {known}, not {user_classes!r}")
        names = {code: name for code, (name, _) in _STANDARD.items()}
        roles = np.full(256, Role.UNDEFINED, dtype=np.uint8)
        kinds = np.full(256, LandClass.UNKNOWN, dtype=np.uint8)
        for code, (_, role) in _STANDARD.items():
            roles[code], kinds[code] = role, _KINDS.get(code, LandClass.UNKNOWN)
        why = "user_classes says so" if user_classes == "ign" else None
        if user_classes == "auto":
            why = french_by(crs, header)
        report = []
        if why is not None:
            for code, (name, role) in _IGN.items():
                names[code], roles[code] = name, role
            report.append(f"classes 64 to 67 mean what the French survey (IGN) means, as {why}")
        for code, meaning in (table or {}).items():
            number = _code(code)
            name, role, kind = _given(meaning)
            names[number], roles[number], kinds[number] = f"{name}, as you say", role, kind
        return Codes(names, roles, kinds, tuple(report))

    def describe(self, counts: NDArray[np.int64]) -> list[str]:
        """A sentence for each class that is there, by the number of returns of each, (256,)."""
        told = list(self.report)
        undefined = []
        for code in map(int, np.flatnonzero(counts)):
            role = Role(int(self.roles[code]))
            name = self.names.get(code)
            if name is None:
                undefined.append(code)
                name = "the producer's own" if code >= _FIRST_USER else "reserved"
            land = LandClass(int(self.kinds[code]))
            taken = _TAKEN_FOR[role] + (f", {land.name}" if land else "")
            told.append(f"class {code} ({name}): {counts[code]:,} returns, taken for {taken}")
        if undefined:
            codes = ", ".join(map(str, undefined))
            told.append(
                f"nobody says what class {codes} means here; say it by class_table "
                f"(--class {undefined[-1]}=building), or if the survey is French by "
                "user_classes='ign' (--user-classes ign)"
            )
        return told


def _code(code: object) -> int:
    if isinstance(code, bool) or not isinstance(code, int | np.integer) or not 0 <= code < 256:
        raise ValueError(f"class_table must name classes 0 to 255, not {code!r}")
    return int(code)


def _given(meaning: LandClass | str | int) -> tuple[str, Role, LandClass]:
    if isinstance(meaning, str) and meaning.lower() == _NOISE:
        return _NOISE, Role.DROPPED, LandClass.UNKNOWN
    kind = land_class(meaning)
    name = kind.name.lower()
    role = {
        LandClass.BUILDING: Role.STRUCTURE,
        LandClass.TREES: Role.PLANT,
        LandClass.UNKNOWN: Role.UNDEFINED,
    }.get(kind)
    if role is not None:
        return name, role, LandClass.UNKNOWN
    return name, Role.GROUND, LandClass.UNKNOWN if kind == LandClass.GROUND else kind
