# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The paper's figure of GGWP: a bug trap is left again, a goal inside an obstacle is given up."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ltp._core import (
    HeightSurface,
    OccupancyGrid,
    PenaltyWeights,
    PlannerOptions,
    Query,
    flood_fill,
)
from ltp.config import MissionConfig
from ltp.sim.mission import fly
from ltp.sim.record import FlightRecord
from ltp.world import LandClass, World

from ..sensed import Snapshot, SnapshotTaker
from .backdrop import INK, caption, panel_title, plain_axes
from .sensing import INFLATED, SENSED, SOLID, draw_cells, draw_moment

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_ALTITUDE = 40.0  # of the flights [m]
_WAVE = "#9ed8f0"
_TRAP = ((90, 150, 58, 68), (90, 150, 132, 142), (140, 150, 58, 142))  # x0, x1, y0, y1 [m]
_MOUTH = (120, 140, 68, 132)  # the deep end of the trap
_BLOCK = ((105, 165, 70, 130),)
_START, _BEYOND, _INSIDE = (15.0, 100.0), (215.0, 100.0), (135.0, 100.0)


def trap_world(boxes: Sequence[tuple[int, int, int, int]], name: str) -> World:
    """Flat ground, 240 m x 200 m, with solid boxes (x0, x1, y0, y1) [m] 80 m high."""
    surface = np.zeros((240, 200))
    classes = np.full(surface.shape, LandClass.PAVED, dtype=np.uint8)
    for x0, x1, y0, y1 in boxes:
        surface[x0:x1, y0:y1] = 80.0
        classes[x0:x1, y0:y1] = LandClass.BUILDING
    return World(name, np.zeros_like(surface), surface, classes, 1.0, attribution="Made-up scenes")


def trap_figure() -> "Figure":
    """Fly both scenes with GGWP and draw the telling moments; takes some seconds."""
    from matplotlib.figure import Figure

    trap, hollow = trap_world(_TRAP, "bug trap"), trap_world(_BLOCK, "hollow goal")
    _, in_trap = _fly(trap, _BEYOND)
    record, at_block = _fly(hollow, _INSIDE)
    figure = Figure(figsize=(11.4, 10.3), facecolor="white")
    panels = figure.subplots(2, 2).reshape(-1)
    figure.subplots_adjust(
        left=0.07, right=0.975, bottom=0.085, top=0.877, wspace=0.14, hspace=0.13
    )
    caught, freed = _turning(in_trap)
    believed = _through_solid(hollow, at_block)
    scenes = (
        (trap, caught, "(a) Bug trap, partly sensed: the plan runs into it"),
        (trap, freed, "(b) Its back is sensed: the plan leads out and round"),
        (hollow, believed, "(c) Goal inside, surface partly sensed: a path"),
        (hollow, at_block[-1], f"(d) Surface complete: given up, {_reason(record)}"),
    )
    for axes, (world, snapshot, title) in zip(panels, scenes, strict=True):
        _draw(axes, world, snapshot)
        panel_title(axes, f"{title}  ({snapshot.time:.1f} s)")
    for axes in panels[:2]:
        axes.set_xlabel("")
    figure.legend(
        handles=_handles(panels[2]),
        loc="upper center",
        bbox_to_anchor=(0.52, 0.938),
        ncols=8,
        fontsize=9,
        frameon=False,
        labelcolor=INK,
        columnspacing=1.2,
        handletextpad=0.5,
    )
    caption(
        figure,
        "GGWP under surface sensing: what was not touched counts as free",
        f"slices at z = {_ALTITUDE:g} m; dashed: the LiDAR's range, "
        f"{MissionConfig().lidar.max_range:g} m",
        trap.attribution,
    )
    return figure


def _fly(world: World, goal: tuple[float, float]) -> tuple[FlightRecord, list[Snapshot]]:
    shortest = PlannerOptions(weights=PenaltyWeights(length=1.0, priority=0.0))
    config = MissionConfig(planner="ggwp", planner_options=shortest)
    taker = SnapshotTaker()
    path = [(*_START, _ALTITUDE), (*goal, _ALTITUDE)]
    record = fly(world, config, path, observers=(taker,))
    return record, taker.snapshots


def _turning(snapshots: Sequence[Snapshot]) -> tuple[Snapshot, Snapshot]:
    """The last moment at which the plan led into the trap's mouth, and the next one."""
    x0, x1, y0, y1 = _MOUTH
    inside = []
    for index, snapshot in enumerate(snapshots[:-1]):
        x, y, _ = snapshot.path.T
        if np.any((x > x0) & (x < x1) & (y > y0) & (y < y1)):
            inside.append(index)
    if not inside:
        raise RuntimeError("no plan led into the bug trap")
    return snapshots[inside[-1]], snapshots[inside[-1] + 1]


def _through_solid(world: World, snapshots: Sequence[Snapshot]) -> Snapshot:
    """Of the moments at which the plan led through what had not been sensed yet, one halfway."""
    surface = HeightSurface(world.surface_raster())
    blind = [s for s in snapshots if len(s.path) and surface.first_collision(s.path) is not None]
    if not blind:
        raise RuntimeError(f"no plan of the flight at the {world.name} led into it")
    return blind[len(blind) // 2]


def _reason(record: FlightRecord) -> str:
    drops = record.dropped
    return drops[0].reason.replace("_", " ") if drops else record.outcome.value


def _draw(axes: "Axes", world: World, snapshot: Snapshot) -> None:
    x_min, y_min, x_max, y_max = world.extent
    solid = world.surface > _ALTITUDE
    draw_cells(axes, (x_min, x_max, y_min, y_max), solid, SOLID)
    extent = snapshot.blocked.extent
    if snapshot.dropped:
        draw_cells(axes, extent, _wave(snapshot), _WAVE)
    draw_cells(axes, extent, snapshot.blocked.level(_ALTITUDE), INFLATED)
    draw_cells(axes, extent, snapshot.occupied.level(_ALTITUDE), SENSED)
    draw_moment(axes, snapshot, MissionConfig().lidar.max_range)
    axes.set(xlim=(x_min, x_max), ylim=(y_min, y_max), aspect="equal")
    axes.set_xlabel("east x [m]", color=INK)
    axes.set_ylabel("north y [m]", color=INK)
    plain_axes(axes)


def _wave(snapshot: Snapshot) -> NDArray[np.bool_]:
    """(nx, ny): the cells that a wave from the goal comes to."""
    frame = snapshot.blocked.frame
    level = int(np.floor((_ALTITUDE - frame.origin[2]) / frame.cell[2]))
    blocked = np.zeros(tuple(frame.dims), dtype=np.bool_)
    blocked[:, :, level] = snapshot.blocked.level(_ALTITUDE)
    grid = OccupancyGrid.from_array(blocked, frame)
    reached = flood_fill(grid, Query(snapshot.goal, snapshot.goal, band=(0.0, 0.0)))
    return np.asarray(reached[:, :, level])


def _handles(axes: "Axes") -> list[object]:
    from matplotlib.patches import Patch

    return [
        Patch(facecolor=SOLID, label="solid, not sensed"),
        Patch(facecolor=SENSED, label="sensed"),
        Patch(facecolor=INFLATED, label="blocked by inflation"),
        Patch(facecolor=_WAVE, label="the wave from the goal"),
        *axes.get_legend_handles_labels()[0],
    ]
