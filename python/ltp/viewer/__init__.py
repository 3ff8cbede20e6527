# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Observers that record a mission for the rerun viewer; needs the extra ltp-uav[viewer]."""

from .recording import FlightRecording
from .replay import replay

__all__ = ["FlightRecording", "replay"]
