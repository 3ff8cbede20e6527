# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""GeoTIFF rasters."""

from ltp.world.classes import land_class

from ..log import logged
from .reader import ClassTable, read

__all__ = ["ClassTable", "land_class", "read"]

read = logged(read)
