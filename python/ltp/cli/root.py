# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The options of `ltp` itself, in front of a command: `--version` and `--log`."""

import sys
from pathlib import Path
from typing import Annotated

import typer

from .log import log_to
from .version import version


def register(app: typer.Typer) -> None:
    """Add the options."""
    app.callback()(root)


def _print_version(wanted: bool) -> None:
    if wanted:
        version()
        raise typer.Exit


def root(
    context: typer.Context,
    log: Annotated[
        Path | None,
        typer.Option(
            help="File to add a log to: imports, decisions in flight, finished flights, mistakes.",
            show_default=False,
        ),
    ] = None,
    show_version: Annotated[
        bool,
        typer.Option(
            "--version", help="Print the version.", callback=_print_version, is_eager=True
        ),
    ] = False,
) -> None:
    """Run a command."""
    if log is not None:
        context.call_on_close(log_to(log, sys.argv))
