# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""How much memory this process has, and had at most."""

import contextlib
import ctypes
from pathlib import Path

_PROCESS = Path("/proc/self")


def resident() -> int:
    """Resident memory [B], from which on `peak` counts anew; 0 where the system cannot tell.

    What was freed is given back first: else it would serve what comes, unseen.
    """
    with contextlib.suppress(OSError, AttributeError):  # not every C library has it
        ctypes.CDLL(None).malloc_trim(0)
    try:
        (_PROCESS / "clear_refs").write_text("5", encoding="ascii")
        return _status("VmRSS")
    except OSError:
        return 0


def peak() -> int:
    """The most that was resident since `resident` was asked [B]."""
    return _status("VmHWM")


def _status(key: str) -> int:
    for line in (_PROCESS / "status").read_text(encoding="ascii").splitlines():
        if line.startswith(key):
            return int(line.split()[1]) * 1024
    return 0
