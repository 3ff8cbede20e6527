# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp fly`: one mission, its record, a figure and a recording."""

import csv
import dataclasses
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
import typer

from .common import (
    Altitude,
    Config,
    Length,
    Margin,
    Reference,
    Seed,
    Spacing,
    ThroughBuildings,
    WorldArgument,
    console,
    open_config,
    open_world,
    scenario_options,
    tell,
)

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ltp.config import MissionConfig
    from ltp.sim.record import FlightRecord
    from ltp.world import World


def register(app: typer.Typer) -> None:
    """Add the command."""
    app.command("fly")(fly)


def fly(
    world: WorldArgument = "city",
    planner: Annotated[str | None, typer.Option(help="Name of the planner.")] = None,
    length_weight: Annotated[float | None, typer.Option(help="W_L of Eq. (5).")] = None,
    priority_weight: Annotated[float | None, typer.Option(help="W_P of Eq. (5).")] = None,
    priority_map: Annotated[
        str | None, typer.Option(help="`binary`, or `lpf` for the low-pass map.")
    ] = None,
    refine: Annotated[
        bool | None,
        typer.Option(help="Free the paths from the grid's directions."),
    ] = None,
    config: Config = None,
    waypoints: Annotated[
        Path | None,
        typer.Option(help="CSV with a waypoint x,y,z a line, the start first, world frame [m]."),
    ] = None,
    scenario: Annotated[
        int, typer.Option(help="Without --waypoints: which of the seeded global paths, from 0.")
    ] = 0,
    altitude: Altitude = 50.0,
    reference: Reference = "ground",
    seed: Seed = 1,
    length: Length = 500.0,
    spacing: Spacing = 50.0,
    margin: Margin = 20.0,
    through_buildings: ThroughBuildings = 1.0,
    out: Annotated[Path, typer.Option(help="Folder for record, figure and recording.")] = Path(
        "out/fly"
    ),
    recording: Annotated[
        bool | None,
        typer.Option(
            help="Write a recording for the viewer (default: if the viewer is installed)."
        ),
    ] = None,
) -> None:
    """Fly one mission; write its record, a figure and a recording to replay.

    Settings come from --config; the options named here win over it.
    """
    place = open_world(world)
    given: dict[str, Any] = {
        "planner": planner,
        "length_weight": length_weight,
        "priority_weight": priority_weight,
        "priority_map": priority_map,
        "refine": refine,
    }
    settings = dataclasses.replace(
        open_config(config), **{name: value for name, value in given.items() if value is not None}
    )
    if waypoints is not None:
        path = _read_waypoints(waypoints)
    else:
        if scenario < 0:
            raise ValueError(f"--scenario must be >= 0, not {scenario}")
        from ltp.evaluation.scenarios import make_scenario

        options = scenario_options(
            1, altitude, reference, seed, length, spacing, margin, through_buildings
        )
        path = make_scenario(place, options, scenario).global_path
    out.mkdir(parents=True, exist_ok=True)
    record, sensed, recorded = fly_recorded(
        place, settings, path, out / "flight.rrd", recording, settings.planner
    )
    record.save(out / "flight.npz")
    _report(record)
    tell("record", out / "flight.npz")
    draw_summary(place, [record], sensed, out / "flight.png")
    tell("figure", out / "flight.png")
    if recorded is not None:
        tell("recording", recorded)
        console.print(f"             open it with: ltp replay {recorded}", markup=False)


def fly_recorded(
    world: "World",
    config: "MissionConfig",
    global_path: "NDArray[np.float64]",
    recording: Path,
    wanted: bool | None,
    title: str,
) -> tuple["FlightRecord", Any, Path | None]:
    """Fly with progress, gather what was sensed, and record for the viewer if wanted.

    Returns:
        The record, the sensed cells, and the recording's path if one was written.
    """
    from contextlib import ExitStack

    from ltp.evaluation.sensed import SensedTrace
    from ltp.sim import fly as fly_mission
    from ltp.viewer.rerun_module import has_rerun

    from .progress import FlightProgress

    sensed = SensedTrace()
    recorded = has_rerun() if wanted is None else wanted
    with ExitStack() as stack:
        observers: list[Any] = [stack.enter_context(FlightProgress(console, title)), sensed]
        if recorded:
            from ltp.viewer import FlightRecording

            observers.append(stack.enter_context(FlightRecording(recording)))
        record = fly_mission(world, config, global_path, observers)
    if not recorded and wanted is None:
        console.print(r'no recording: it needs pip install "ltp\[viewer]"')
    return record, sensed, recording if recorded else None


def draw_summary(world: "World", records: "list[FlightRecord]", sensed: Any, path: Path) -> None:
    """Draw flights of one global path over the city."""
    from ltp.evaluation.backdrop import save_figure
    from ltp.evaluation.summary_figure import summary_figure

    save_figure(summary_figure(world, records, sensed), path)


def _report(record: "FlightRecord") -> None:
    console.print(
        f"{record.outcome.value} after {record.duration:.0f} s and {record.length:.0f} m: "
        f"mean priority {record.mean_priority:.2f}, length ratio {record.length_ratio:.2f}, "
        f"clearance {record.min_clearance:.1f} m, {len(record.plans)} plans"
    )
    for event in record.dropped:
        console.print(
            f"waypoint {event.index + 1} dropped at {event.time:.0f} s: "
            f"{event.reason.replace('_', ' ')}"
        )


def _read_waypoints(path: Path) -> "NDArray[np.float64]":
    with path.open(newline="", encoding="utf-8") as file:
        lines = [line for line in csv.reader(file) if line and not line[0].startswith("#")]
    try:
        points = np.array([[float(value) for value in line] for line in lines])
    except ValueError as error:
        raise ValueError(f"{path}: not a list of numbers x,y,z: {error}") from None
    if points.ndim != 2 or points.shape[1] != 3 or len(points) < 2:
        raise ValueError(f"{path}: expected two lines x,y,z or more")
    return points
