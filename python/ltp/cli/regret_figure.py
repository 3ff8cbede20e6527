# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp figure regret`: from what `ltp regret` has written."""

from pathlib import Path
from typing import Annotated

import typer

from .inputs import open_world
from .options import PictureFile, WorldArgument
from .output import write_figure

RegretFolder = Annotated[
    Path,
    typer.Argument(metavar="DIR", help="Folder of `ltp regret`: its --out.", show_default=False),
]


def regret(
    folder: RegretFolder,
    world: WorldArgument = "city",
    out: PictureFile = Path("out/regret.png"),
) -> None:
    """Draw what was flown against what one could have flown.

    Each planner of the last `ltp regret` in the folder has a line.
    """
    from ltp.evaluation.figures.regrets import regret_figure
    from ltp.evaluation.regret import TABLE, read_regrets

    rows, place = read_regrets(folder / TABLE), open_world(world)
    if rows and rows[0].world != place.name:
        raise ValueError(f"{folder} was flown over {rows[0].world}, not over {place.name}")
    write_figure(regret_figure(rows, place.attribution), out)
