# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Regret: what was flown against what one could have flown knowing all obstacles."""

from .judge import RegretJudge, check_gate, gates_of
from .regret import TABLE, RegretObserver, run_regret
from .rows import RegretRow, read_regrets

__all__ = [
    "TABLE",
    "RegretJudge",
    "RegretObserver",
    "RegretRow",
    "check_gate",
    "gates_of",
    "read_regrets",
    "run_regret",
]
