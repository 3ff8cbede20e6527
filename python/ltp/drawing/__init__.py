# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of worlds, and what all pictures over a world share: light, axes, colours."""
