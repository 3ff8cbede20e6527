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
    beside: Annotated[
        list[Path] | None,
        typer.Option(
            "--beside",
            metavar="DIR",
            help="Another folder of `ltp regret` to draw below it: other gates, another horizon. "
            "May be given several times.",
            show_default=False,
        ),
    ] = None,
    out: PictureFile = Path("out/regret.png"),
) -> None:
    """Draw what was flown against what one could have flown.

    Each planner of the last `ltp regret` in the folder has a line.
    """
    from ltp.evaluation.figures.regrets import regret_figure
    from ltp.evaluation.regret import TABLE, read_regrets

    place = open_world(world)
    rows = []
    for each in (folder, *(beside or ())):
        mine = read_regrets(each / TABLE)
        if mine and mine[0].world != place.name:
            raise ValueError(f"{each} was flown over {mine[0].world}, not over {place.name}")
        rows += mine
    write_figure(regret_figure(rows, place.attribution), out)
