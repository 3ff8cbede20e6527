# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A world as triangles for a 3-D view: flat tops, vertical walls, few enough for a small file."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ltp._core import Raster
from ltp.drawing.shading import sunlight
from ltp.world import CLASS_COLOURS, LandClass, World

_MOST_CELLS = 500  # along an axis, to begin with
_MOST_QUADS = 160_000
_STEP = 0.5  # heights are rounded to it [m]
_LIFT = 0.4  # of the priority map over the ground, so that it is seen [m]
_DARK, _BRIGHT = (35, 42, 68), (243, 243, 207)  # priority 0 and 1, as in the figures
_LOW_ROOF, _HIGH_ROOF = (222, 212, 198), (98, 102, 122)
_HIGH = 90.0  # height of a roof that is as dark as any [m]
_WALLS = {(-1, 0): 0.86, (1, 0): 0.62, (0, -1): 0.58, (0, 1): 0.80}  # light by outward normal


@dataclass(frozen=True)
class Mesh:
    """Triangles, two for each quad of four vertices."""

    vertices: NDArray[np.float32]  # (4 n, 3) world [m]
    colours: NDArray[np.uint8]  # (4 n, 3) RGB

    @property
    def triangles(self) -> NDArray[np.uint32]:
        """(2 n, 3) indices of vertices."""
        first = np.arange(0, len(self.vertices), 4, dtype=np.uint32)[:, None, None]
        halves = np.array([(0, 1, 2), (0, 2, 3)], dtype=np.uint32)
        return (first + halves).reshape(-1, 3)


@dataclass(frozen=True)
class _Blocks:
    """Solid columns over a lattice."""

    world: World  # that they are cut off with
    edge: float  # of a column [m]
    heights: NDArray[np.float64]  # (nx, ny) [m]
    colours: NDArray[np.float64]  # (nx, ny, 3) of the tops


def surface_mesh(world: World) -> Mesh:
    """What stands on the ground: land classes under the sun, roofs the darker the higher."""
    return _coarse_enough(world, lambda step: _columns_mesh(_surface_blocks(world, step)))


def priority_mesh(world: World, priority: Raster) -> Mesh:
    """The priority map, laid on the bare ground."""
    return _coarse_enough(world, lambda step: _tops(_priority_blocks(world, priority, step)))


def _coarse_enough(world: World, build: Callable[[int], Mesh]) -> Mesh:
    """What `build` makes of so many cells a column that the mesh stays small."""
    step = max(1, math.ceil(max(world.shape) / _MOST_CELLS))
    while len((mesh := build(step)).vertices) > 4 * _MOST_QUADS:
        step += 1
    return mesh


def _priority_blocks(world: World, priority: Raster, step: int) -> _Blocks:
    heights = _patches(world.ground, step).max(axis=(1, 3))
    edge = step * world.cell
    x, y = (world.origin[a] + (np.arange(heights.shape[a]) + 0.5) * edge for a in (0, 1))
    # 16 shades: equal neighbours become one quad.
    value = np.round(np.asarray(priority.at(x[:, None], y[None, :])) * 15.0)[..., None] / 15.0
    colours = np.array(_DARK) * (1.0 - value) + np.array(_BRIGHT) * value
    flat = np.round(heights / _STEP) * _STEP
    return _Blocks(world, edge, flat + _LIFT, colours)


def _surface_blocks(world: World, step: int) -> _Blocks:
    # Of each patch its highest cell, so that walls get the colour of their roof.
    stacks = [
        patch.swapaxes(1, 2).reshape(patch.shape[0], patch.shape[2], -1)
        for patch in (
            _patches(values, step)
            for values in (world.surface, world.classes, sunlight(world.surface, world.cell))
        )
    ]
    top = stacks[0].argmax(axis=-1)[..., None]
    heights, classes, light = (np.take_along_axis(s, top, axis=-1)[..., 0] for s in stacks)
    above = heights - _patches(world.ground, step).max(axis=(1, 3))
    table = np.array([CLASS_COLOURS[land] for land in sorted(LandClass)], dtype=np.float64)
    share = np.clip(np.round(above / _HIGH, 1), 0.0, 1.0)[..., None]
    roofs = np.array(_LOW_ROOF) * (1.0 - share) + np.array(_HIGH_ROOF) * share
    built = (classes == LandClass.BUILDING)[..., None]
    colours = np.where(built, roofs, table[classes]) * np.where(light < 0.7, 0.7, 1.0)[..., None]
    rounded = np.round(heights / _STEP) * _STEP
    return _Blocks(world, step * world.cell, rounded, colours)


def _patches(values: NDArray[Any], step: int) -> NDArray[Any]:
    """(nx, step, ny, step): patches of cells, the border repeated where they stick out."""
    pad = [(0, -n % step) for n in values.shape]
    padded = np.pad(values, pad, mode="edge")
    return padded.reshape(padded.shape[0] // step, step, padded.shape[1] // step, step)


def _columns_mesh(blocks: _Blocks) -> Mesh:
    parts = [_tops(blocks), *(_walls(blocks, *normal) for normal in _WALLS)]
    return Mesh(
        np.concatenate([part.vertices for part in parts]),
        np.concatenate([part.colours for part in parts]),
    )


def _runs(*keys: NDArray[Any]) -> tuple[NDArray[np.int64], ...]:
    """Runs of equal keys along axis 1: their row, first column, and the column after the last."""
    new = np.ones(keys[0].shape[:2], dtype=np.bool_)
    new[:, 1:] = False
    for key in keys:
        change = key[:, 1:] != key[:, :-1]
        new[:, 1:] |= change.any(axis=-1) if change.ndim == 3 else change
    row, first = np.nonzero(new)
    last = np.append(first[1:], 0)
    last[np.append(row[1:] != row[:-1], True)] = keys[0].shape[1]
    return row, first, last


def _tops(blocks: _Blocks) -> Mesh:
    i, j0, j1 = _runs(blocks.heights, blocks.colours)
    z = blocks.heights[i, j0]
    corners = [(i, j0, z), (i + 1, j0, z), (i + 1, j1, z), (i, j1, z)]
    return _quads(blocks, corners, blocks.colours[i, j0])


def _walls(blocks: _Blocks, nx: int, ny: int) -> Mesh:
    """The walls whose outward normal is (nx, ny), in runs along the other axis."""
    heights, colours = blocks.heights, blocks.colours
    if ny:
        heights, colours = heights.T, colours.swapaxes(0, 1)
    up = nx + ny > 0
    high, low = (heights[:-1], heights[1:]) if up else (heights[1:], heights[:-1])
    colours = colours[:-1] if up else colours[1:]
    i, j0, j1 = _runs(high, low, colours)
    wall = high[i, j0] > low[i, j0]
    i, j0, j1 = i[wall], j0[wall], j1[wall]
    bottom, top, side = low[i, j0], high[i, j0], i + 1
    corners = [(side, j0, bottom), (side, j1, bottom), (side, j1, top), (side, j0, top)]
    if ny:
        corners = [(b, a, z) for a, b, z in corners]
    return _quads(blocks, corners, colours[i, j0] * _WALLS[nx, ny])


def _quads(
    blocks: _Blocks,
    corners: list[tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.float64]]],
    colours: NDArray[np.float64],
) -> Mesh:
    points: NDArray[np.float64] = np.stack([np.stack(c, axis=-1) for c in corners], axis=1)
    x_min, y_min, x_max, y_max = blocks.world.extent
    points = points * (blocks.edge, blocks.edge, 1.0) + (x_min, y_min, 0.0)
    points = np.minimum(points, (x_max, y_max, np.inf))
    return Mesh(
        points.reshape(-1, 3).astype(np.float32),
        np.repeat(colours.round(), 4, axis=0).astype(np.uint8),
    )
