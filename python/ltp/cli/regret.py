# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp regret`: what was flown against what one could have flown knowing all obstacles."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from .global_paths import GlobalPaths
from .inputs import names, numbers, open_priority, open_world, planner_names, workers
from .naming import naming
from .options import PriorityFile, PriorityMaps, Processes, ResumedFolder, WorldArgument
from .output import console, narrow_table, remark, resumable, say, tell, write_text
from .settings import Settings
from .spread import spread

if TYPE_CHECKING:
    from ltp.evaluation.campaign.variants import Variant
    from ltp.evaluation.regret import RegretRow

_TABLES = "regret.md"


def register(app: typer.Typer) -> None:
    """Add the command."""
    app.command("regret")(regret)


@spread
def regret(
    *,
    world: WorldArgument = "city",
    paths: Annotated[int, typer.Option(help="Number of global paths.")] = 50,
    global_paths: GlobalPaths,
    planners: Annotated[
        str,
        typer.Option(
            help="Planners to fly, with commas between; `NAME+refine` is one with its paths "
            "refined."
        ),
    ] = "auto",
    ratios: Annotated[
        str, typer.Option(help="Ratios of the weights, W_P / W_L, with commas between.")
    ] = "2",
    maps: PriorityMaps = "binary",
    priority: PriorityFile = None,
    gate: Annotated[
        float | None,
        typer.Option(
            help="Radius within which the ideal routes serve a waypoint that is not the last [m]; "
            "0 is the waypoint's own cell. By default that of the flights.",
            show_default=False,
        ),
    ] = None,
    processes: Processes = 0,
    settings: Settings,
    out: ResumedFolder = Path("out/regret"),
) -> None:
    """Measure what not knowing the obstacles costs.

    Flies planners over many global paths and holds the flown Eq. 5 of each flight against that of
    the best routes over the true world's cells through the same waypoints: each leg the best by
    itself, and all legs planned jointly. Writes regret.csv and regret.md beside what `ltp evaluate
    --records` writes. Stopped in any way, it goes on where it was when the same command is given
    again.
    """
    from ltp.evaluation.campaign import Campaign, run_campaign
    from ltp.evaluation.regret import TABLE, check_gate, run_regret
    from ltp.evaluation.regret.tables import markdown_regrets

    from .progress import CampaignProgress, RegretProgress

    with naming("gate"):
        check_gate(gate)
    variants = _variants(planners, ratios, maps)
    base = settings.open()
    place = open_world(world)
    given = open_priority(priority, place)
    scenarios = global_paths.over(place, paths)
    say(f"{place.name}: {len(scenarios)} global paths, {len(variants)} variants")
    with resumable(out, "flown and judged"):
        flights = run_campaign(
            Campaign(place, variants, scenarios, base, given),
            out,
            processes=workers(processes),
            keep_records=True,
            observers=[CampaignProgress(console())],
        )
        rows = run_regret(
            place,
            flights,
            out,
            gate=gate,
            priority=given,
            observers=[RegretProgress(console())],
        )
    write_text(markdown_regrets(rows), out / _TABLES)
    _print_regrets(rows)
    tell("regrets", out / TABLE)
    tell("tables", out / _TABLES)


def _variants(planners: str, ratios: str, maps: str) -> "list[Variant]":
    from ltp.evaluation.campaign.variants import at_ratio, unique

    wanted, kinds = planner_names("--planners", planners), names(maps)
    if not wanted:
        raise ValueError("--planners must name a planner")
    if not kinds:
        raise ValueError("--maps must name a priority map")
    with naming(planner="--planners", ratio="--ratios", priority_map="--maps"):
        return unique(
            at_ratio(ratio, name, kind)
            for kind in kinds
            for ratio in numbers("--ratios", ratios)
            for name in wanted
        )


def _print_regrets(rows: "Sequence[RegretRow]") -> None:
    from ltp.evaluation.campaign.compare import interval_text
    from ltp.evaluation.regret.tables import by_case, signed, summarise_regrets

    titles = ("planner", "flights", "flown", "planned", "Eq. 5", "regret")
    for title, lines in by_case(summarise_regrets(rows)).items():
        grid = narrow_table(title, titles)
        for s in lines:
            who = s.variant.contender.title, f"{s.counted}/{s.flights}", signed(s.flown)
            grid.add_row(*who, "by leg", signed(s.legs), interval_text(s.over_legs))
            grid.add_row("", "", "", "jointly", signed(s.joint), interval_text(s.over_joint))
        console().print(grid)
    remark(
        "Eq. 5 of whole routes; regret: flown less what one could have flown knowing all\n"
        "obstacles, leg by leg or planning all legs jointly, with its 95 % interval",
    )
