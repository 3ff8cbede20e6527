# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""An obstacle map seen in a slice at flight altitude: volume against surface sensing."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ltp._core import HeightSurface
from ltp.world import World

from ..sensed import CellMap, Snapshot
from .backdrop import INK, draw_legend, draw_path, make_page, panel_title, plain_axes

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

SENSED, INFLATED, SOLID = "#c1272d", "#f4b183", "#c9ced6"
PLAN, FLOWN, GOAL = "#1f6fd0", "#22262b", "#0b8f5a"


def sensing_figure(world: World, snapshots: Sequence[Snapshot], max_range: float) -> "Figure":
    """What there is against what was sensed, where most was sensed at flight altitude.

    Args:
        world: that was flown over.
        snapshots: of one flight.
        max_range: of its LiDAR [m].

    Raises:
        ValueError: if no snapshot has a plan.
    """
    planned = [snapshot for snapshot in snapshots if len(snapshot.path)]
    if not planned:
        raise ValueError("snapshots: expected one or more with a plan")
    seen = [int(s.occupied.level(float(s.position[2])).sum()) for s in planned]
    snapshot = planned[int(np.argmax(seen))]
    frame, z = snapshot.occupied.frame, float(snapshot.position[2])
    truth = CellMap.of(HeightSurface(world.surface_raster()).occupancy(frame)).level(z)
    cells = " x ".join(f"{edge:g}" for edge in frame.cell)
    figure, (left, right) = make_page(
        world,
        2,
        f"Obstacle map, slice at z = {z:.0f} m: volume against surface sensing",
        f"{world.name}  ·  cells {cells} m, window {frame.dims[0]} x {frame.dims[1]} x "
        f"{frame.dims[2]}  ·  after {snapshot.time:.0f} s of flight",
        gap=0.9,
        bars=False,
    )
    known = snapshot.occupied.level(z)
    draw_cells(left, snapshot.occupied.extent, truth, SENSED)
    panel_title(left, f"Volume: all that there is, {truth.sum():,} cells")
    draw_cells(right, snapshot.occupied.extent, snapshot.blocked.level(z), INFLATED)
    draw_cells(right, snapshot.occupied.extent, known, SENSED)
    panel_title(right, f"Surface: what the LiDAR has touched, {known.sum():,} cells")
    for axes in (left, right):
        draw_moment(axes, snapshot, max_range)
        axes.set(xlim=_limits(snapshot, 0), ylim=_limits(snapshot, 1), aspect="equal")
        axes.set_xlabel("east x [m]", color=INK)
        axes.set_ylabel("north y [m]", color=INK)
        plain_axes(axes)
    draw_legend(right, handles=_handles(right), loc="upper right")
    return figure


def draw_cells(
    axes: "Axes", extent: tuple[float, float, float, float], cells: NDArray[np.bool_], colour: str
) -> None:
    """Coloured cells (nx, ny), clear elsewhere."""
    from matplotlib.colors import to_rgba

    image = np.zeros((*cells.shape, 4))
    image[cells] = to_rgba(colour)
    axes.imshow(image.swapaxes(0, 1), origin="lower", extent=extent, interpolation="nearest")


def draw_moment(axes: "Axes", snapshot: Snapshot, max_range: float) -> None:
    """UAV, its sensor's range, what it has flown and what it plans, its goal."""
    from matplotlib.patches import Circle

    x, y = (float(value) for value in snapshot.position[:2])
    axes.add_patch(Circle((x, y), max_range, fill=False, ec="#6d7480", lw=1.0, ls=(0, (4, 3))))
    axes.plot(*snapshot.flown[:, :2].T, color=FLOWN, lw=1.6, zorder=4, label="flown")
    if len(snapshot.path):
        draw_path(axes, snapshot.path, PLAN, "plan", 2.0)
    style: dict[str, Any] = {"zorder": 6, "edgecolor": "white", "lw": 1.0}
    axes.scatter(x, y, s=70, color=FLOWN, label="UAV", **style)
    axes.scatter(
        snapshot.goal[0],
        snapshot.goal[1],
        s=150,
        marker="*",
        color=GOAL,
        label="waypoint",
        **style,
    )


def _handles(axes: "Axes") -> list[object]:
    from matplotlib.patches import Patch

    return [
        Patch(facecolor=SENSED, label="occupied"),
        Patch(facecolor=INFLATED, label="blocked by inflation"),
        *axes.get_legend_handles_labels()[0],
    ]


def _limits(snapshot: Snapshot, axis: int) -> tuple[float, float]:
    """A view that is not all window: 130 m to each side of the UAV."""
    half = 130.0
    low, high = snapshot.occupied.extent[2 * axis : 2 * axis + 2]
    middle = float(np.clip(snapshot.position[axis], low + half, high - half))
    return middle - half, middle + half
