# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command line, `ltp`: a thin layer that parses, calls one function, prints its result."""

from . import compare, demo, evaluate, figure, flight, gap, replan, settings, world
from .app import app

__all__ = ["app", "main"]

for module in (demo, flight, evaluate, compare, gap, replan, figure, settings, world):
    module.register(app)


def main() -> None:
    """Run the command line and exit."""
    app()
