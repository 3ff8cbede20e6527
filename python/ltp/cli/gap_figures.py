# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp figure front`, `gap`, `curve`: planners against the optimum, and against each other."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from .common import WorldArgument, console, names, open_world, write_figure
from .evaluate import read_flights
from .gap import QUERIES

if TYPE_CHECKING:
    from ltp.evaluation.queries import QuerySet

GapFolder = Annotated[
    Path, typer.Argument(metavar="DIR", help="Folder of `ltp gap`: its --out.", show_default=False)
]
Out = Annotated[Path, typer.Option("--out", "-o", help="Picture to write: .png, .pdf or .svg.")]


def register(group: typer.Typer) -> None:
    """Add the commands to `ltp figure`."""
    group.command("front")(front)
    group.command("gap")(gap)
    group.command("curve")(curve)


def front(
    folder: GapFolder,
    query: Annotated[int, typer.Option(help="Which of the recorded queries, from 0.")] = 0,
    ratio: Annotated[float, typer.Option(help="W_P / W_L.")] = 2.0,
    priority_map: Annotated[
        str, typer.Option("--map", help="Priority map: `binary` or `lpf`.")
    ] = "binary",
    band: Annotated[str, typer.Option(help="`planar` or `open`.")] = "planar",
    planners: Annotated[
        str, typer.Option(help="Planners to draw, commas between, as in `ltp gap` (default: all).")
    ] = "",
    memory: Annotated[float, typer.Option(help="For the exact front [MB].")] = 2048.0,
    out: Out = Path("out/front.png"),
) -> None:
    """Draw all that one recorded query offers: front, hull, certificate, planners' paths."""
    from ltp.evaluation.front import survey
    from ltp.evaluation.gap import SHORTEST, Contender, GapOptions
    from ltp.evaluation.gap_figures import front_figure
    from ltp.planners import PLANNERS

    queries = _queries(folder)
    (case,) = GapOptions(maps=[priority_map], bands=[band], ratios=[ratio]).cases()
    contenders = [Contender(name) for name in names(planners) or (SHORTEST, *PLANNERS)]
    with console.status("planning"):
        view = survey(queries, query, case, contenders, memory)
    if view.front is None:
        console.print(f"the exact front takes more than {memory:g} MB (--memory): left out")
    write_figure(front_figure(view, queries.world, queries.attribution), out)


def gap(folder: GapFolder, out: Out = Path("out/gap.png")) -> None:
    """Draw how the gaps of each planner are spread, for each ratio, map and band."""
    from ltp.evaluation.gap import TABLE, read_gaps
    from ltp.evaluation.gap_figures import gap_figure

    rows = read_gaps(folder / TABLE)
    write_figure(gap_figure(rows, _queries(folder).attribution), out)


def curve(
    flights: Annotated[
        Path, typer.Argument(help="flights.csv of a campaign, or the campaign's folder.")
    ],
    world: WorldArgument = "city",
    planners: Annotated[
        str, typer.Option(help="Planners to draw, commas between (default: all that were swept).")
    ] = "",
    out: Out = Path("out/curve.png"),
) -> None:
    """Draw flown length against mean priority, swept over W_P / W_L: one curve a planner.

    From a campaign such as `ltp evaluate WORLD --rows none --planners lp-dijkstra,sweep --ratios
    default`.
    """
    from ltp.evaluation.curve_figure import curve_figure

    rows, place = read_flights(flights), open_world(world)
    if rows[0].world != place.name:
        raise ValueError(f"{flights} was flown over {rows[0].world}, not over {place.name}")
    write_figure(curve_figure(rows, place.attribution, names(planners)), out)


def _queries(folder: Path) -> "QuerySet":
    from ltp.evaluation.queries import QuerySet

    return QuerySet.load(folder / QUERIES if folder.is_dir() else folder)
