# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files: written all at once or not at all, read with distrust."""

from ltp.files.atomic import atomic_write
from ltp.files.blame import blamed_on

__all__ = ["atomic_write", "blamed_on"]
