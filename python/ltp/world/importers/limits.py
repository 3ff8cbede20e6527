# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Heights on which all importers agree: what can be true, and what is an object."""

#: Heights outside of this are noise, or no-data values whose tag was lost (-9999, ...) [m].
HEIGHTS = (-1000.0, 10000.0)

#: What stands higher than this above the ground is an object, not a kind of ground [m].
OBJECT_HEIGHT = 2.0
