# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""GeoTIFF rasters."""

from ..log import logged
from .reader import ClassTable, land_class, read

__all__ = ["ClassTable", "land_class", "read"]

read = logged(read)
