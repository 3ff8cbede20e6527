# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp config`: every mission setting, ready to be changed."""

import typer

from .options import InsteadOfPrinting
from .output import tell
from .settings import Settings
from .spread import spread


def register(app: typer.Typer) -> None:
    """Add the command."""
    app.command("config")(config)


@spread
def config(*, settings: Settings, out: InsteadOfPrinting = None) -> None:
    """Print every mission setting as TOML, ready to be changed."""
    chosen = settings.open()
    if out is None:
        print(chosen.to_toml(), end="")
        return
    chosen.save(out)
    tell("settings", out)
