# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The works of `tests.bench.peers`, one file each, and the libraries that take part in several."""
