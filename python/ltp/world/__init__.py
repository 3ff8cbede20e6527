# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Worlds to fly over: what stands where, what lies on the ground, and where one may land."""

from .classes import CLASS_COLOURS, LANDABLE_PRESETS, LandClass
from .world import Datum, World

__all__ = ["CLASS_COLOURS", "LANDABLE_PRESETS", "Datum", "LandClass", "World"]
