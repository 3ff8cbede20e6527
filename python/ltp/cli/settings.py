# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp config`, `ltp version`, `ltp replay`."""

from pathlib import Path
from typing import Annotated

import typer

from .common import Config, open_config, tell


def register(app: typer.Typer) -> None:
    """Add the commands."""
    app.command("config")(config)
    app.command("replay")(replay)
    app.command("version")(version)


def config(
    start: Config = None,
    out: Annotated[Path | None, typer.Option(help="File to write instead of printing.")] = None,
) -> None:
    """Print every mission setting with its default as TOML, ready to be changed."""
    settings = open_config(start)
    if out is None:
        print(settings.to_toml(), end="")
        return
    settings.save(out)
    tell("settings", out)


def replay(
    recording: Annotated[Path, typer.Argument(help="A recording, .rrd, of `ltp fly` or `demo`.")],
) -> None:
    """Open a recording in the rerun viewer: no usage statistics, reachable from here only."""
    from ltp.viewer import replay as open_viewer

    if status := open_viewer(recording):
        raise RuntimeError(f"the viewer ended with status {status}: is there a display?")


def version() -> None:
    """Print the version."""
    from ltp._core import __version__

    print(__version__)
