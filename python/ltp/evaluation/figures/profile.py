# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Altitude profiles: a strip a flight, its altitude over what stands below it."""

import itertools
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ltp.drawing.maps import INK, plain_axes
from ltp.sim.record import FlightRecord
from ltp.world import World

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

STRIP = 0.62  # height of a strip [inch]
_AXIS_ROOM = 0.5  # of the maps' own axis [inch]
_GROUND, _SURFACE = "#8d8576", "#c9c3b8"


def strips_height(count: int) -> float:
    """What `draw_strips` needs below the maps [inch]."""
    return count * STRIP + _AXIS_ROOM


def draw_strips(
    figure: "Figure",
    world: World,
    records: Sequence[FlightRecord],
    colours: Sequence[str],
) -> None:
    """Altitude over the way flown, one strip a record, all to one scale.

    Args:
        figure: to draw into.
        world: that was flown over: the ground and what stands on it, below the path, are filled.
        records: of the flights.
        colours: of their lines, in turn.
    """
    from matplotlib.ticker import MaxNLocator

    height = figure.get_size_inches()[1]
    pars = figure.subplotpars  # the strips lie below the maps, in the room that `below` has left
    top = pars.bottom * height - _AXIS_ROOM
    profiles = [_profile(world, record) for record in records]
    low = min(float(ground.min()) for _, _, ground, _ in profiles)
    high = max(float(np.maximum(z, surface).max()) for _, z, _, surface in profiles)
    room = 0.08 * max(high - low, 1.0)
    end = max(float(way[-1]) for way, *_ in profiles)
    rows = zip(records, profiles, itertools.cycle(colours))
    for index, (record, profile, colour) in enumerate(rows):
        bottom = top - (index + 1) * STRIP
        box = (pars.left, bottom / height, pars.right - pars.left, 0.86 * STRIP / height)
        axes = figure.add_axes(box)
        _draw(axes, record, profile, colour)
        axes.set(xlim=(0.0, max(end, 1.0)), ylim=(low - room, high + room))
        axes.yaxis.set_major_locator(MaxNLocator(nbins=2, integer=True))
        plain_axes(axes)
        axes.tick_params(labelbottom=index == len(records) - 1, labelsize=8)
    axes.set_xlabel("way flown [m]: altitude z [m] over ground and obstacles", color=INK)


def _profile(world: World, record: FlightRecord) -> tuple[NDArray[np.float64], ...]:
    """Way flown, altitude, ground and surface below, at every position (n,) [m]."""
    steps = np.linalg.norm(np.diff(record.positions, axis=0), axis=1)
    way = np.concatenate([[0.0], np.cumsum(steps)])
    cells = np.floor((record.positions[:, :2] - world.origin) / world.cell).astype(int)
    i, j = np.clip(cells, 0, np.array(world.shape) - 1).T
    return way, record.positions[:, 2], world.ground[i, j], world.surface[i, j]


def _draw(
    axes: "Axes", record: FlightRecord, profile: tuple[NDArray[np.float64], ...], colour: str
) -> None:
    way, z, ground, surface = profile
    axes.fill_between(way, surface, ground, color=_SURFACE, lw=0.0, step="mid")
    axes.fill_between(way, ground, -1e6, color=_GROUND, lw=0.0, step="mid")
    axes.plot(way, z, color=colour, lw=1.8, solid_capstyle="round", clip_on=False, zorder=4)
    if record.collision is not None:
        axes.plot(way[-1:], z[-1:], marker="x", ms=8, mew=2.2, color="#c1121f", zorder=5)
