# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp replay`: a recorded flight in the viewer."""

from pathlib import Path
from typing import Annotated

import typer


def register(app: typer.Typer) -> None:
    """Add the command."""
    app.command("replay")(replay)


def replay(
    recording: Annotated[Path, typer.Argument(help="A recording, .rrd, of `ltp fly` or `demo`.")],
) -> None:
    """Open a recording in the rerun viewer.

    The viewer sends no usage statistics and can be reached from this machine only.
    """
    from ltp.viewer import replay as open_viewer

    if status := open_viewer(recording):
        raise RuntimeError(f"the viewer ended with status {status}: is there a display?")
