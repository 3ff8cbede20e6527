# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Classified laser surveys, LAS or LAZ."""

from ..log import logged
from .reader import read

__all__ = ["read"]

read = logged(read)
