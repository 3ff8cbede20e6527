# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp fly`: one mission, its record, a figure and a recording."""

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from .global_paths import GlobalPaths
from .inputs import open_priority, open_world, telling_old_names
from .naming import naming
from .options import PriorityFile, ScenarioIndex, WorldArgument
from .output import note, say, tell, tell_recording
from .recorded_flight import draw_summary, fly_recorded
from .settings import Settings
from .spread import spread
from .waypoints import read_waypoints

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from ltp.config import MissionConfig
    from ltp.sim.record import FlightRecord
    from ltp.world import World


def register(app: typer.Typer) -> None:
    """Add the command."""
    app.command("fly")(fly)


def _octree(path: Path | None) -> Path | None:
    """Refuse what no map is written to before anything is flown for it."""
    if path is not None and path.suffix not in (".bt", ".ot"):
        raise ValueError(f"--save-map must end in .bt or .ot, not {str(path)!r}")
    return path


@spread
def fly(
    *,
    world: WorldArgument = "city",
    planner: Annotated[str | None, typer.Option(help="Name of the planner.")] = None,
    length_weight: Annotated[
        float | None, typer.Option(help="Weight of the path's length, W_L of Eq. 5.")
    ] = None,
    priority_weight: Annotated[
        float | None, typer.Option(help="Weight of the priority below it, W_P of Eq. 5.")
    ] = None,
    priority_map: Annotated[
        str | None, typer.Option(help="Priority map: `binary`, or `lpf` for the low-pass map.")
    ] = None,
    priority: PriorityFile = None,
    refine: Annotated[
        bool | None,
        typer.Option(help="Free the paths from the grid's directions."),
    ] = None,
    climb: Annotated[
        float | None,
        typer.Option(
            help="Height above the highest waypoint of a leg to which the UAV may climb [m]; 0: it "
            "keeps to its altitude. By default that of the preset `fly`, 20; 0 with --preset "
            "paper; or as --config says."
        ),
    ] = None,
    chosen: Settings,
    waypoints: Annotated[
        Path | None,
        typer.Option(
            "--waypoints",
            help="CSV to take the global path from: a waypoint x,y,z a line, the start first, "
            "world frame [m].",
        ),
    ] = None,
    old_waypoints: Annotated[
        Path | None,
        typer.Option("--way-points", hidden=True, help="Old name of --waypoints."),
    ] = None,
    known_map: Annotated[
        Path | None,
        typer.Option(
            help="OctoMap file (.bt or .ot) of what was seen before, to begin with: of --save-map, "
            "say, in voxels of the same size."
        ),
    ] = None,
    save_map: Annotated[
        Path | None,
        typer.Option(
            help="File to write with all obstacles seen: .bt, or .ot with log-odds.",
            callback=_octree,
        ),
    ] = None,
    scenario: ScenarioIndex = 0,
    global_paths: GlobalPaths,
    out: Annotated[Path, typer.Option(help="Folder for record, figure and recording.")] = Path(
        "out/fly"
    ),
    recording: Annotated[
        bool | None,
        typer.Option(help="Write a recording for the viewer; by default if it is installed."),
    ] = None,
) -> None:
    """Fly one mission; write its record, a figure and a recording.

    Settings come from --config, those of the map from --preset; the options named here win over
    both. Without a file the UAV may climb (preset `fly`), which the paper's does not. The global
    path is one of the seeded ones, unless --waypoints gives another.

    Exits with 1 after a collision, a time-out, or a flight that reached no waypoint.
    """
    from ltp.world.off_world import refuse_off_world

    place = open_world(world)
    settings = chosen.open()
    if chosen.config is None and chosen.preset != "paper":
        settings.use_preset("fly")
    of_planner = settings.planner_options
    _set_given(settings, planner=planner, priority_map=priority_map)
    _set_given(of_planner, refine=refine)
    _set_given(settings.navigation, climb=climb)
    _set_given(of_planner.weights, length=length_weight, priority=priority_weight)
    with (
        telling_old_names("--planner"),
        naming(
            "planner",
            "priority_map",
            **{"navigation.climb": "--climb"},
            **{"weights.length": "--length-weight", "weights.priority": "--priority-weight"},
            **{
                "planner_options.weights.length": "--length-weight",
                "planner_options.weights.priority": "--priority-weight",
            },
        ),
    ):
        settings.check()
    if settings.navigation.climb > 0.0:
        rise = f"{settings.navigation.climb:g} m"
        say(f"the UAV may climb {rise} above its waypoints; --climb 0: it keeps to its altitude")
    if old_waypoints:
        note("--way-points is now --waypoints; the old name goes with the next release")
        waypoints = waypoints or old_waypoints
    if waypoints:
        path, path_name = read_waypoints(waypoints), f"{waypoints}: waypoints"
        refuse_off_world(place, path, path_name)
    else:
        path, path_name = global_paths.one(place, scenario), "global_path"
    own_priority = open_priority(priority, place)
    out.mkdir(parents=True, exist_ok=True)
    with naming(global_path=path_name):
        record, sensed, recorded = fly_recorded(
            place,
            settings,
            path,
            out / "flight.rrd",
            recording,
            settings.planner,
            own_priority,
            known_map,
            save_map,
        )
    record.save(out / "flight.npz")
    _report(record)
    _tell_finer_preset(place, settings, path)
    tell("record", out / "flight.npz")
    if save_map is not None:
        tell("map", save_map)
    draw_summary(place, [record], sensed, out / "flight.png")
    tell("figure", out / "flight.png")
    if recorded is not None:
        tell_recording(recorded)
    if record.outcome != "reached":
        raise typer.Exit(1)


def _set_given(holder: object, **settings: object) -> None:
    """Set those that were given on the command line."""
    for name, value in settings.items():
        if value is not None:
            setattr(holder, name, value)


def _tell_finer_preset(
    world: "World", settings: "MissionConfig", path: "NDArray[np.float64]"
) -> None:
    """Say so where the path comes too near to the ground for the map's cells."""
    from ltp.config import finer_preset

    ground = world.ground_raster()
    heights = [float(z) - float(ground.at(float(x), float(y))) for x, y, z in path]
    least = min((height for height in heights if math.isfinite(height)), default=math.inf)
    cell_height = float(settings.mapping.cell[2])
    finer = finer_preset(least, cell_height)
    if finer is not None:
        note(
            f"the path comes within {least:.0f} m of the ground, and cells are {cell_height:g} m "
            f"high: --preset {finer} keeps more of the free air"
        )


def _fates(record: "FlightRecord") -> str:
    """How many were reached and how near to, and what became of the others."""
    near = [entry.distance for entry in record.reached]
    how_near = f" (within {max(near):.1f} m)" if near else ""
    left = len(record.global_path) - 1 - len(record.waypoints)
    others = {"dropped": len(record.dropped), "too far": len(record.skipped), "left": left}
    parts = [f"{len(near)} reached{how_near}"]
    return ", ".join(parts + [f"{count} {fate}" for fate, count in others.items() if count])


def _report(record: "FlightRecord") -> None:
    outcome = record.outcome.value.replace("_", " ")
    say(
        f"{outcome} after {record.duration:.0f} s and {record.length:.0f} m: "
        f"mean priority {record.mean_priority:.2f}, length ratio {record.length_ratio:.2f}, "
        f"clearance {record.min_clearance:.1f} m, {len(record.plans)} plans"
    )
    if record.outcome != "reached":
        say(f"why: {record.reason}")
    say(f"waypoints: {_fates(record)}")
    for event in record.waypoints:
        if event.outcome != "reached":
            fate = f"{event.outcome} at {event.time:.0f} s: {event.reason_text}"
            say(f"waypoint {event.index + 1} {fate}")
