# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`FlightRecording`: an observer that writes a mission to a `.rrd` file for the rerun viewer."""

import os
from pathlib import Path
from types import TracebackType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ltp._core import ObstacleMap, OccupancyGrid, Scan, path_length, tally
from ltp.sim import FlightRecord, MissionSetup, Step
from ltp.sim.record import fate_of

from .rerun_module import require_rerun
from .scenery import Mesh, priority_mesh, surface_mesh

_SCAN_EVERY = 1.0  # [s]
_CELLS_EVERY = 2.0  # [s]
_MOST_HITS = 1200  # points of a scan that are kept

_CYAN, _RED, _YELLOW = (0, 200, 230), (224, 33, 58), (255, 220, 0)
_BLUE, _GREEN, _WHITE = (31, 139, 224), (24, 176, 123), (245, 245, 245)
_GREY = (150, 156, 168)
_FATES = {"reached": _GREEN, "dropped": _RED, "skipped": _YELLOW}


class FlightRecording:
    """Writes one flight: world, window, scans, plans, flown path, priority map, penalty.

    The file appears under its name when the flight has ended; used as a context manager, a flight
    that fails leaves nothing behind. Scans and cells are thinned so that a 500 m flight stays below
    20 MB. Nothing is sent anywhere.

    Args:
        path: of the recording, `.rrd`.

    Raises:
        ImportError: with the pip command, if rerun is not installed.
        ValueError: if `path` does not end in .rrd.
        OSError: if its folder cannot be written.
    """

    _setup: MissionSetup  # since the start
    _map: ObstacleMap  # since the first step
    _waypoints: NDArray[np.float64]  # (n, 3), as shown
    _colours: NDArray[np.uint8]  # (n, 3)

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self._rr: Any = require_rerun()
        self._path = Path(path)
        if self._path.suffix != ".rrd":
            raise ValueError(f"a recording's file must end in .rrd, not {os.fspath(path)!r}")
        self._part = self._path.with_name(f".{self._path.name}.part")
        self._part.open("wb").close()  # rerun only logs that it cannot write
        self._stream: Any = None
        self._window: NDArray[np.float64] | None = None
        self._cells: tuple[int, bytes] = (0, b"")
        self._next_scan = 0.0
        self._next_cells = 0.0
        self._flown: list[NDArray[np.float64]] = []

    def __enter__(self) -> "FlightRecording":
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._close()
        self._part.unlink(missing_ok=True)

    def on_start(self, setup: MissionSetup) -> None:
        """Write what stays as it is: world, priority map, global path."""
        rr, world, path = self._rr, setup.world, setup.global_path
        self._setup = setup
        self._waypoints, self._colours = np.empty((0, 3)), np.empty((0, 3), dtype=np.uint8)
        self._stream = rr.RecordingStream("ltp", send_properties=False)
        self._stream.save(self._part, default_blueprint=self._blueprint(setup))
        self._static("/", rr.ViewCoordinates.RIGHT_HAND_Z_UP)
        self._static("world/surface", self._mesh(surface_mesh(world)))
        self._static("world/priority", self._mesh(priority_mesh(world, setup.priority)))
        note = f"# {world.name}\n\n{setup.config.planner}\n\n{world.attribution}"
        self._static("about", rr.TextDocument(note, media_type=rr.MediaType.MARKDOWN))
        self._static("mission/global_path", rr.LineStrips3D([path], colors=_CYAN, radii=0.5))
        self._static("mission/start", rr.Points3D(path[:1], colors=_RED, radii=3.0))
        for name, colour in (
            ("penalty/plan", _RED),
            ("priority/flown_so_far", _BLUE),
            ("priority/of_plan", _GREEN),
            ("search/milliseconds", _YELLOW),
        ):
            label = name.partition("/")[2].replace("_", " ")
            self._static(f"plots/{name}", rr.SeriesLines(colors=colour, names=label, widths=2.0))

    def on_step(self, step: Step) -> None:
        """Write what has changed."""
        self._map = step.map
        self._stream.set_time("flight", duration=step.time)
        first = not self._flown
        self._flown.append(step.position)
        self._log("uav", self._rr.Points3D(step.position[None], colors=_WHITE, radii=2.0))
        if first or step.events or step.waypoints is not self._waypoints:
            self._note_events(step)
        self._note_plans(step)
        if step.path_changed:
            strips = [step.path] if len(step.path) else []
            self._log("plan", self._rr.LineStrips3D(strips, colors=_YELLOW, radii=0.7))
        scans = [scan for scan in step.scans if scan is not None]
        if scans and step.time >= self._next_scan - 1e-9:
            self._next_scan += _SCAN_EVERY
            self._note_scans(scans)
            self._note_flown()
        if step.time >= self._next_cells - 1e-9:
            self._next_cells += _CELLS_EVERY
            self._note_map()

    def on_end(self, record: FlightRecord) -> None:
        """Write the last state and give the file its name."""
        self._note_flown()
        self._note_map()
        text = f"{record.outcome.value}: mean priority {record.mean_priority:.2f}, "
        text += f"length ratio {record.length_ratio:.2f}, {len(record.dropped)} waypoints dropped"
        text += f", {len(record.skipped)} too far" if record.skipped else ""
        text += f"; {record.reason}" if record.reason else ""
        self._log("events", self._rr.TextLog(text, level="INFO"))
        if record.collision is not None:
            spot = np.array([record.collision])
            self._log("mission/collision", self._rr.Points3D(spot, colors=_RED, radii=4.0))
        self._close()
        self._part.replace(self._path)

    def _note_events(self, step: Step) -> None:
        if step.waypoints is not self._waypoints:
            self._waypoints = step.waypoints
            self._colours = np.tile(np.array(_CYAN, dtype=np.uint8), (len(step.waypoints), 1))
        for event in step.events:
            why = "" if event.reached else f": {event.why.text}"
            near = f", {event.distance:.1f} m from it" if event.reached else ""
            level = "INFO" if event.reached else "WARN"
            text = f"waypoint {event.index + 1} {fate_of(event)}{why}{near}"
            self._log("events", self._rr.TextLog(text, level=level))
            self._colours[event.index] = _FATES[fate_of(event)]
        goals = self._rr.Points3D(self._waypoints, colors=self._colours, radii=2.0)
        self._log("mission/waypoints", goals)

    def _note_plans(self, step: Step) -> None:
        for answer in step.plans:
            plan = answer.plan
            milliseconds = 1e3 * plan.stats.seconds
            self._log("plots/search/milliseconds", self._rr.Scalars(milliseconds))
            if len(plan.path):
                self._log("plots/penalty/plan", self._rr.Scalars(plan.penalty))
                self._log("plots/priority/of_plan", self._rr.Scalars(plan.tally.mean_priority))

    def _note_scans(self, scans: list[Scan]) -> None:
        hits = np.concatenate([scan.hits for scan in scans])
        hits = hits[:: max(1, -(-len(hits) // _MOST_HITS))]
        self._log("lidar", self._rr.Points3D(hits, colors=_RED, radii=0.25))

    def _note_flown(self) -> None:
        flown = np.array(self._flown)
        if len(flown) > 1 and path_length(flown) > 0.0:
            self._log("flown", self._rr.LineStrips3D([flown], colors=_BLUE, radii=0.8))
            so_far = tally(flown, self._setup.priority).mean_priority
            self._log("plots/priority/flown_so_far", self._rr.Scalars(so_far))

    def _note_map(self) -> None:
        grid = self._map.occupied
        frame = grid.frame
        if self._window is None or np.any(frame.origin != self._window):
            self._window = np.array(frame.origin)
            box = self._rr.Boxes3D(
                mins=[frame.origin],
                sizes=[frame.upper - frame.origin],
                colors=_GREY,
                fill_mode="majorwireframe",
            )
            self._log("map/window", box)
        centres = _cell_centres(grid)
        state = (len(centres), centres.tobytes())
        if state == self._cells:
            return
        self._cells = state
        half = np.tile(np.array(frame.cell, dtype=np.float32) / 2.0, (len(centres), 1))
        boxes = self._rr.Boxes3D(
            centers=centres, half_sizes=half, colors=_by_height(centres), fill_mode="solid"
        )
        self._log("map/occupied", boxes)

    def _mesh(self, mesh: Mesh) -> Any:
        return self._rr.Mesh3D(
            vertex_positions=mesh.vertices,
            triangle_indices=mesh.triangles,
            vertex_colors=mesh.colours,
        )

    def _log(self, entity: str, value: Any) -> None:
        self._stream.log(entity, value)

    def _static(self, entity: str, value: Any) -> None:
        self._stream.log(entity, value, static=True)

    def _close(self) -> None:
        if self._stream is not None:
            self._stream.flush()
            self._stream.disconnect()
            self._stream = None

    def _blueprint(self, setup: MissionSetup) -> Any:
        """A 3-D view that looks along the global path, the curves beside it."""
        rrb: Any = require_rerun("rerun.blueprint")
        start, end = setup.global_path[0], setup.global_path[-1]
        length = np.linalg.norm(end - start)
        along = (end - start) / length if length > 0.0 else np.array([1.0, 0.0, 0.0])
        eye = rrb.EyeControls3D(
            position=start - 120.0 * along + (0.0, 0.0, 220.0),
            look_target=start + 180.0 * along,
            eye_up=(0.0, 0.0, 1.0),
        )
        view = rrb.Spatial3DView(
            origin="/",
            contents=["+ /**", "- /plots/**", "- /events"],
            name=f"{setup.world.name}: {setup.config.planner}",
            eye_controls=eye,
            line_grid=False,
            background=(236, 240, 244),
        )
        curves = rrb.Vertical(
            rrb.TimeSeriesView(origin="/plots/penalty", name="penalty, Eq. (5)"),
            rrb.TimeSeriesView(origin="/plots/priority", name="mean priority"),
            rrb.TimeSeriesView(origin="/plots/search", name="search time [ms]"),
            rrb.TextLogView(origin="/events", name="waypoints"),
            rrb.TextDocumentView(origin="/about", name="about"),
        )
        return rrb.Blueprint(
            rrb.Horizontal(view, curves, column_shares=[3, 1]),
            rrb.TimePanel(state="collapsed", timeline="flight"),
            collapse_panels=True,
        )


def _cell_centres(grid: OccupancyGrid) -> NDArray[np.float32]:
    """(n, 3) centres of the occupied cells [m]."""
    columns = grid.columns
    frame = grid.frame
    found = []
    ix, iy, word = np.nonzero(columns)
    bits = columns[ix, iy, word]
    for bit in range(64):
        here = (bits >> np.uint64(bit) & np.uint64(1)).astype(bool)
        if here.any():
            found.append(np.stack([ix[here], iy[here], 64 * word[here] + bit], axis=-1))
    cells = np.concatenate(found) if found else np.empty((0, 3))
    return np.asarray(frame.origin + (cells + 0.5) * frame.cell, dtype=np.float32)


def _by_height(centres: NDArray[np.float32]) -> NDArray[np.uint8]:
    """Low cells orange, high ones violet."""
    low, high = np.array((242, 150, 60)), np.array((110, 50, 140))
    share = np.clip(centres[:, 2:] / 100.0, 0.0, 1.0)
    return np.asarray(low * (1.0 - share) + high * share).round().astype(np.uint8)
