# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp demo`: the built-in city, seven planners, a table, a figure, a recording."""

from pathlib import Path
from typing import Annotated

import typer

from .inputs import open_world, read_flights, workers
from .naming import naming
from .options import Processes
from .output import console, say, tell, tell_recording

#: What is flown beside Table I; more lines than colours would make no picture.
_BESIDE_THE_TABLE = ("bezier", "sweep", "auto")


def register(app: typer.Typer) -> None:
    """Add the command."""
    app.command("demo")(demo)


def demo(
    out: Annotated[Path, typer.Option(help="Folder for all that is written.")] = Path("out/demo"),
    paths: Annotated[int, typer.Option(help="Number of global paths.")] = 3,
    seed: Annotated[int, typer.Option(help="Seed of the set of global paths.")] = 1,
    processes: Processes = 0,
) -> None:
    """Fly the built-in city with the paper's planners and ours.

    Writes tables, a figure and a recording. The flights are straight 500 m global paths at 50 m
    height that lead through buildings.
    """
    from ltp.config import MissionConfig
    from ltp.evaluation.campaign import RECORDS, TABLE, Campaign, run_campaign
    from ltp.evaluation.campaign.flights import mission_config, record_path
    from ltp.evaluation.campaign.variants import TABLE_I, Variant
    from ltp.evaluation.scenarios import ScenarioOptions, make_scenarios
    from ltp.sim import FlightRecord

    from .campaign_tables import write_tables
    from .progress import CampaignProgress
    from .recorded_flight import draw_summary, fly_recorded

    world, base = open_world("city"), MissionConfig()
    with naming("seed", count="--paths"):
        scenarios = make_scenarios(world, ScenarioOptions(count=paths, seed=seed))
    variants = [*TABLE_I, *(Variant(name, 0.5, 1.0) for name in _BESIDE_THE_TABLE)]
    say(
        f"{world.name}: {paths} global paths at 50 m, through buildings; "
        "the paper's planners, sweep and auto"
    )
    campaign = Campaign(world, variants, scenarios, base)
    run_campaign(
        campaign,
        out,
        processes=workers(processes),
        keep_records=True,
        observers=[CampaignProgress(console())],
    )
    drawn = {variant.planner: variant for variant in variants}  # of each planner the last
    star = drawn.pop("auto")
    record, sensed, recorded = fly_recorded(
        world,
        mission_config(base, star),
        scenarios[0].global_path,
        out / "demo.rrd",
        None,
        "recording Auto",
    )
    keys = {
        flight.variant: flight.key for flight in campaign.flights() if flight.scenario.index == 0
    }
    kept = [FlightRecord.load(record_path(out / RECORDS, keys[v])) for v in drawn.values()]
    write_tables(read_flights(out), out)
    draw_summary(world, [record, *kept], sensed, out / "demo.png")
    tell("flights", out / TABLE)
    tell("figure", out / "demo.png")
    if recorded is not None:
        tell_recording(recorded)
