# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The benchmarks: C++ (`*_bench.cpp`), Python against peers (`peers`), growth (`scale`), report."""
