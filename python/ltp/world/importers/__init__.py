# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Worlds from real data: a folder for each kind of file, its `read` gives a `World`.

The libraries that they need come with the extra `ltp-uav[geo]`, and are loaded when `read` runs.
"""
