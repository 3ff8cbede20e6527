# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A world as triangles for a 3-D view: surface and ground, coarse enough for a small file."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ltp._core import Raster
from ltp.world import CLASS_COLOURS, LandClass, World
from ltp.world.shading import sunlight

_MOST_CELLS = 420  # along an axis of the mesh
_LIFT = 0.4  # of the priority map over the ground, so that it is seen [m]
_DARK, _BRIGHT = (35, 42, 68), (243, 243, 207)  # priority 0 and 1, as in the figures


@dataclass(frozen=True)
class Mesh:
    """Triangles over the ground."""

    vertices: NDArray[np.float32]  # (n, 3) world [m]
    triangles: NDArray[np.uint32]  # (m, 3) indices of vertices
    colours: NDArray[np.uint8]  # (n, 3) RGB


def surface_mesh(world: World) -> Mesh:
    """What stands on the ground, in the colours of the land classes under the sun."""
    step = _step(world)
    heights = _blocks(world.surface, step).max(axis=(1, 3))
    table = np.array([CLASS_COLOURS[land] for land in sorted(LandClass)], dtype=np.float64)
    # Class and light of the highest cell of each block: what one sees from above.
    light = 0.35 + 0.65 * sunlight(world.surface, world.cell)
    colours = table[world.classes] * light[..., None]
    mean = np.stack([_blocks(colours[..., i], step).mean(axis=(1, 3)) for i in range(3)], axis=-1)
    return _mesh(world, heights, np.clip(mean, 0, 255), step)


def priority_mesh(world: World, priority: Raster) -> Mesh:
    """The priority map, laid on the bare ground."""
    step = _step(world)
    heights = _blocks(world.ground, step).max(axis=(1, 3)) + _LIFT
    x, y = _centres(world, heights.shape, step)
    value = np.asarray(priority.at(x[:, None], y[None, :]))[..., None]
    colours = np.array(_DARK) * (1.0 - value) + np.array(_BRIGHT) * value
    return _mesh(world, heights, colours, step)


def _step(world: World) -> int:
    return max(1, math.ceil(max(world.shape) / _MOST_CELLS))


def _blocks(values: NDArray[np.float64], step: int) -> NDArray[np.float64]:
    """(nx, step, ny, step): blocks of cells, the border repeated where they stick out."""
    pad = [(0, -n % step) for n in values.shape]
    padded = np.pad(values, pad, mode="edge")
    return padded.reshape(padded.shape[0] // step, step, padded.shape[1] // step, step)


def _centres(
    world: World, shape: tuple[int, ...], step: int
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    edge = step * world.cell
    x, y = (world.origin[axis] + (np.arange(shape[axis]) + 0.5) * edge for axis in (0, 1))
    return x, y


def _mesh(
    world: World, heights: NDArray[np.float64], colours: NDArray[np.float64], step: int
) -> Mesh:
    nx, ny = heights.shape
    x, y = _centres(world, heights.shape, step)
    vertices = np.stack([*np.meshgrid(x, y, indexing="ij"), heights], axis=-1).reshape(-1, 3)
    corner = np.arange(nx * ny, dtype=np.uint32).reshape(nx, ny)
    a, b, c, d = corner[:-1, :-1], corner[1:, :-1], corner[1:, 1:], corner[:-1, 1:]
    triangles = np.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3)
    return Mesh(
        vertices.astype(np.float32), triangles, colours.reshape(-1, 3).round().astype(np.uint8)
    )
