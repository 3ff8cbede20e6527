# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""OpenStreetMap extracts."""

from ..log import logged
from .reader import ATTRIBUTION, read

__all__ = ["ATTRIBUTION", "read"]

read = logged(read)
