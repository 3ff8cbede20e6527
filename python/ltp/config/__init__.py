# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The settings of a mission, in and out of TOML."""

from ltp.config.guidance import GuidanceOptions
from ltp.config.mission import MissionConfig, VehicleOptions
from ltp.config.presets import PRESETS, finer_preset

__all__ = ["PRESETS", "GuidanceOptions", "MissionConfig", "VehicleOptions", "finer_preset"]
