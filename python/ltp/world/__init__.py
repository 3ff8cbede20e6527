# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Worlds to fly over: what stands where, what lies on the ground, and where one may land."""

from typing import TYPE_CHECKING

from ltp.renamed import old_names

from .by_hand import boxes
from .city import make_city
from .classes import CLASS_COLOURS, LANDABLE_PRESETS, LandClass
from .cover import Cover, land_cover
from .importers.priority import read_priority, save_priority
from .landable import LandingLimits, LandingRules, landable_mask
from .priority import binary_priority, footprint, lowpass_priority, priority_map
from .shapes import Box, Cylinder, Prism
from .world import Datum, World

__all__ = [
    "CLASS_COLOURS",
    "LANDABLE_PRESETS",
    "Box",
    "Cover",
    "Cylinder",
    "Datum",
    "LandClass",
    "LandingLimits",
    "LandingRules",
    "Prism",
    "World",
    "binary_priority",
    "boxes",
    "footprint",
    "land_cover",
    "landable_mask",
    "lowpass_priority",
    "make_city",
    "priority_map",
    "read_priority",
    "save_priority",
]

if not TYPE_CHECKING:  # type checkers know the new names only
    __getattr__ = old_names(__name__)
