# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp figure front`, `gap`: planners against the optimum, from what `ltp gap` has written."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from .gap_queries import queries_file
from .inputs import planner_names
from .naming import naming
from .options import Memory, PictureFile, PriorityMap, Ratio
from .output import console, say, write_figure

if TYPE_CHECKING:
    from ltp.evaluation.gap.queries import QuerySet

GapFolder = Annotated[
    Path, typer.Argument(metavar="DIR", help="Folder of `ltp gap`: its --out.", show_default=False)
]


def front(
    folder: GapFolder,
    query: Annotated[int, typer.Option(help="Index of the recorded query, from 0.")] = 0,
    ratio: Ratio = 2.0,
    priority_map: PriorityMap = "binary",
    band: Annotated[
        str, typer.Option(help="Altitude band: `planar` or `open`, as in `ltp gap`.")
    ] = "planar",
    planners: Annotated[
        str,
        typer.Option(
            help="Planners to draw, with commas between, as in `ltp gap`; by default all."
        ),
    ] = "",
    memory: Memory = 2048.0,
    out: PictureFile = Path("out/front.png"),
) -> None:
    """Draw the front of one recorded query and the planners' paths.

    The front's hull and the certificate of the optimum are drawn too.
    """
    from ltp.evaluation.contenders import SHORTEST, Contender
    from ltp.evaluation.figures.gaps import front_figure
    from ltp.evaluation.gap import GapOptions
    from ltp.evaluation.gap.front import survey
    from ltp.registry import PLANNERS

    queries = _queries(folder)
    with naming("ratio", "memory", maps="--map", bands="--band", planner="--planners"):
        options = GapOptions(maps=[priority_map], bands=[band], ratios=[ratio], memory=memory)
        (case,) = options.cases()
        chosen = planner_names("--planners", planners) or (SHORTEST, *PLANNERS)
        contenders = [Contender(name) for name in chosen]
    with console().status("planning"), naming("query"):
        view = survey(queries, query, case, contenders, memory)
    if view.front is None:
        say(f"the exact front takes more than {memory:g} MB (--memory): left out")
    write_figure(front_figure(view, queries.world, queries.attribution), out)


def gap(folder: GapFolder, out: PictureFile = Path("out/gap.png")) -> None:
    """Draw how the gaps of each planner are spread.

    Each ratio, map and band has a part of its own.
    """
    from ltp.evaluation.figures.gaps import gap_figure
    from ltp.evaluation.gap import TABLE, read_gaps

    rows = read_gaps(folder / TABLE)
    write_figure(gap_figure(rows, _queries(folder).attribution), out)


def _queries(folder: Path) -> "QuerySet":
    from ltp.evaluation.gap.queries import QuerySet

    return QuerySet.load(queries_file(folder) if folder.is_dir() else folder)
