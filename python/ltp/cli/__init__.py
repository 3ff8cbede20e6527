# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command line, `ltp`: a thin layer that parses, calls one function, prints its result."""

from ltp.installed import warn_if_overwritten

from . import (
    compare,
    config,
    demo,
    evaluate,
    export,
    figure,
    fly,
    gap,
    regret,
    replay,
    table,
    version,
    world,
)
from . import root as root_options
from .app import make_group

__all__ = ["app", "main"]

app = make_group(
    "ltp",
    "Local trajectory planning for autonomous UAV landing.\n\nFly missions over cities, evaluate "
    "planners, draw the tables and figures. Lengths are metres, times seconds.",
)

for module in (
    root_options,
    demo,
    fly,
    evaluate,
    table,
    compare,
    gap,
    regret,
    config,
    export,
    replay,
    version,
    figure,
    world,
):
    module.register(app)


def main() -> None:
    """Run the command line and exit."""
    warn_if_overwritten()
    app()
