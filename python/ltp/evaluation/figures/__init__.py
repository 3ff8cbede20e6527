# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""All that is drawn of flights and gaps; each function returns a figure and writes nothing."""
