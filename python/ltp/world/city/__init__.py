# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The built-in city: a plan, blocks between its streets, and what stands on them."""

from .builder import make_city

__all__ = ["make_city"]
