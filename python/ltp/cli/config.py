# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp config`: every mission setting, ready to be changed."""

import typer

from .inputs import open_config
from .options import Config, InsteadOfPrinting
from .output import tell


def register(app: typer.Typer) -> None:
    """Add the command."""
    app.command("config")(config)


def config(start: Config = None, out: InsteadOfPrinting = None) -> None:
    """Print every mission setting as TOML, ready to be changed."""
    settings = open_config(start)
    if out is None:
        print(settings.to_toml(), end="")
        return
    settings.save(out)
    tell("settings", out)
