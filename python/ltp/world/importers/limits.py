# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Heights on which all importers agree: what can be true, and what is an object."""

#: Where land can lie: from the shore of the Dead Sea to the top of Mount Everest. What is outside
#: is noise, or a no-data value whose tag was lost (-9999, -999, 9999, ...) [m].
HEIGHTS = (-430.0, 8849.0)

#: Nothing built stands higher above the ground: Burj Khalifa, 828 m to its tip [m].
HIGHEST_BUILT = 830.0

#: No tree is higher (Hyperion, a coast redwood, 116 m), with room for its growth and errors [m].
HIGHEST_TREE = 130.0

#: What stands higher than this above the ground is an object, not a kind of ground [m].
OBJECT_HEIGHT = 2.0
