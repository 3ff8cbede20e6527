# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A package, so that `python -m tests.bench.peers` finds it before any peer's own `tests`."""
