# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`make_city`: a seeded procedural city, the world to fly in when nothing is imported."""

import math

import numpy as np
from numpy.typing import NDArray

from ..checks import positive
from ..classes import LandClass
from ..world import Datum, World
from .blocks import fill_block
from .canvas import Canvas
from .parts import PAVEMENT, Site, tower
from .plan import EMBANKMENT_ROAD, Boulevard, CityPlan, Rect, River, draw_plan

_SMALLEST, _MOST_CELLS = 100.0, 100_000_000


def make_city(
    seed: int = 1, size: float = 1000.0, cell: float = 1.0, max_height: float = 120.0
) -> World:
    """Build a city: streets, blocks, towers, parks, squares, trees, car parks, a river.

    Args:
        seed: the same seed (with the same other arguments) gives the same city, to the bit.
        size: edge of the square map, a whole number of cells, at least 100 [m].
        cell: edge of a cell [m].
        max_height: nothing stands higher; the landmark tower reaches it, where there is room [m].

    Returns:
        A `World` with flat ground at z = 0, origin (0, 0) in the south-west, no CRS.

    Raises:
        ValueError: naming the argument that is out of range.
    """
    size, cell, max_height = _checked(size, cell, max_height)
    rng = np.random.default_rng(_seed(seed))
    plan = draw_plan(rng, size)
    canvas = Canvas(round(size / cell), cell, plan.angle)

    if plan.boulevard is not None:
        _reserve(canvas, plan.boulevard)
    _blocks(canvas, rng, plan, size, max_height)
    for park in plan.parks:
        _park(canvas, rng, park)
    canvas.reserved[:] = False
    if plan.river is not None:
        _riverside(canvas, rng, plan.river)
    if plan.boulevard is not None:
        _boulevard(canvas, rng, plan.boulevard)
        _roundabout(canvas, rng, plan.boulevard)
    _street_trees(canvas, rng, plan)
    canvas.grow_trees()

    return World(
        name=f"built-in city, seed {seed}",
        ground=np.zeros_like(canvas.height),
        surface=np.minimum(canvas.height, max_height),
        classes=canvas.classes,
        cell=cell,
        datum=Datum(),
        attribution=f"Made-up city (ltp, seed {seed})",
    )


def _seed(seed: int) -> int:
    if isinstance(seed, bool) or not isinstance(seed, int | np.integer) or seed < 0:
        raise ValueError(f"seed must be a whole number >= 0, not {seed!r}")
    return int(seed)


def _checked(size: float, cell: float, max_height: float) -> tuple[float, float, float]:
    size, cell = positive("size", size), positive("cell", cell)
    if size < _SMALLEST:
        raise ValueError(f"size must be at least {_SMALLEST:g} m, not {size!r}")
    if (size / cell) ** 2 > _MOST_CELLS:
        raise ValueError(
            f"size / cell must not exceed {math.isqrt(_MOST_CELLS)}, not {size / cell}"
        )
    if cell > size / 10.0 or abs(size / cell - round(size / cell)) > 1e-9 * size / cell:
        raise ValueError(f"cell must divide size = {size:g} m into 10 or more cells, not {cell!r}")
    return size, cell, positive("max_height", max_height)


def _reserve(canvas: Canvas, line: Boulevard) -> None:
    """Keep the blocks out of the diagonal and its roundabout."""
    away = np.hypot(canvas.u - line.u, canvas.v - line.v)
    canvas.reserved |= np.abs(_off_axis(canvas, line)) < line.width / 2
    canvas.reserved |= away < line.roundabout


def _blocks(
    canvas: Canvas, rng: np.random.Generator, plan: CityPlan, size: float, max_height: float
) -> None:
    """Fill every block by how central it is; the most central free one gets the landmark."""
    centres = np.array([(0.10, 0.10, 0.31), (-0.12, -0.40, 0.17), (0.38, -0.06, 0.17)]) * size
    for block in plan.blocks:
        u, v = block.centre
        away = np.hypot(centres[:, 0] - u, centres[:, 1] - v)
        centrality = float(np.exp(-((away / centres[:, 2]) ** 2)).max())
        fill_block(Site(canvas, rng, block, centrality))
    middle = tuple(centres[0, :2])
    for block in sorted(plan.blocks, key=lambda rect: math.dist(rect.centre, middle)):
        patch = canvas.rect(block)
        if patch is not None and not canvas.reserved[patch.window].any():
            site = Site(canvas, rng, block, 1.0)
            site.cover(block, LandClass.SQUARE)
            side = min(46.0, 0.6 * min(block.width, block.depth))
            tower(site, *block.centre, side, max_height, "stepped")
            break


def _park(canvas: Canvas, rng: np.random.Generator, area: Rect) -> None:
    """Lawns, groves, winding paths, a pond, a pitch and a pavilion."""
    site = Site(canvas, rng, area, 0.0)
    site.cover(area, LandClass.PAVED)
    lawn = area.inset(PAVEMENT)
    patch = canvas.rect(lawn)
    if patch is None:
        return
    canvas.lay(patch, LandClass.GRASS)
    u, v = area.centre
    a, b = 0.36 * lawn.width, 0.36 * lawn.depth
    ring = np.abs(np.hypot(patch.s / a, patch.t / b) - 1.0) * min(a, b) < 1.8
    wave = np.abs(patch.t - 0.16 * lawn.depth * np.sin(patch.s / lawn.width * 7.0)) < 1.6
    slope = lawn.depth / lawn.width
    cross = np.abs(patch.t + slope * patch.s) < 2.0
    canvas.lay(patch, LandClass.PATH, where=ring | wave | cross)
    pond_u, pond_v = u + 0.17 * lawn.width, v + 0.17 * lawn.depth
    pond = canvas.box(pond_u, pond_v, 0.27 * lawn.width, 0.24 * lawn.depth)
    if pond is not None:
        bearing = np.arctan2(pond.t, pond.s)
        shore = 0.42 + 0.06 * np.sin(3.0 * bearing + 1.0)
        inside = np.hypot(pond.s / (0.3 * lawn.width), pond.t / (0.26 * lawn.depth)) < shore
        canvas.lay(pond, LandClass.WATER, where=inside)
    pitch = canvas.box(u - 0.22 * lawn.width, v - 0.24 * lawn.depth, 64.0, 40.0, 0.1)
    canvas.lay(pitch, LandClass.PITCH)
    canvas.build(canvas.disc(u - 0.05 * lawn.width, v + 0.30 * lawn.depth, 8.0), 9.0)
    spots = rng.uniform(-0.5, 0.5, (int(lawn.width * lawn.depth / 28.0), 2))
    tree_u, tree_v = u + spots[:, 0] * lawn.width, v + spots[:, 1] * lawn.depth
    grove = np.sin(tree_u / 23.0 + 1.0) * np.sin(tree_v / 19.0) + np.sin((tree_u + tree_v) / 41.0)
    edge = np.abs(spots).max(axis=1) > 0.475
    chance = np.where(grove > 0.75, 1.0, np.where(edge, 0.5, 0.05))
    kept = rng.random(len(spots)) < chance
    canvas.plant(rng, tree_u[kept], tree_v[kept], 17.0)


def _riverside(canvas: Canvas, rng: np.random.Generator, river: River) -> None:
    """The corridor: a road on each bank, lawns with trees, promenades, water, bridges."""
    corridor = river.corridor
    patch = canvas.rect(corridor)
    if patch is None:
        return
    window = patch.window
    u, v = canvas.u[window], canvas.v[window]
    off = np.abs(v - river.middle(u)) - river.width / 2  # from the water's edge [m]
    to_rim = corridor.depth / 2 - np.abs(v - corridor.centre[1])
    canvas.lay(patch, LandClass.GRASS)
    canvas.lay(patch, LandClass.PATH, where=off < 5.0)
    canvas.lay(patch, LandClass.WATER, where=off < 0.0)
    canvas.lay(patch, LandClass.PAVED, where=to_rim < EMBANKMENT_ROAD + PAVEMENT)
    canvas.lay(patch, LandClass.ROAD, where=to_rim < EMBANKMENT_ROAD)
    for deck in river.bridges:
        site = Site(canvas, rng, deck, 0.0)
        site.cover(deck, LandClass.PAVED)
        site.cover(Rect(deck.u0 + 3.0, deck.v0, deck.u1 - 3.0, deck.v1), LandClass.ROAD)
    along = np.arange(corridor.u0, corridor.u1, 9.0)
    bank = river.middle(along)
    for side in (-1.0, 1.0):
        canvas.plant(rng, along, bank + side * (river.width / 2 + 7.5), 14.0)
        rim = corridor.centre[1] + side * (corridor.depth / 2 - EMBANKMENT_ROAD - 1.5)
        canvas.plant(rng, along, np.full(along.size, rim), 13.0)


def _off_axis(canvas: Canvas, line: Boulevard) -> NDArray[np.float64]:
    """How far each cell lies to the left of the boulevard's axis [m]."""
    c, s = math.cos(line.direction), math.sin(line.direction)
    return np.asarray(c * (canvas.v - line.v) - s * (canvas.u - line.u))


def _boulevard(canvas: Canvas, rng: np.random.Generator, line: Boulevard) -> None:
    """Two carriageways, a green middle, broad pavements with two rows of trees."""
    off = np.abs(_off_axis(canvas, line))
    bridge = canvas.classes == LandClass.WATER
    band = off < line.width / 2
    canvas.classes[band] = LandClass.PAVED
    canvas.height[band] = 0.0
    canvas.classes[band & (off < 11.5)] = LandClass.ROAD
    canvas.classes[band & (off < 2.5) & ~bridge] = LandClass.GRASS
    position = np.arange(-canvas.half * 1.5, canvas.half * 1.5, 10.0)
    c, s = math.cos(line.direction), math.sin(line.direction)
    for row in (-14.5, 0.0, 14.5):
        canvas.plant(rng, line.u + c * position - s * row, line.v + s * position + c * row, 15.0)


def _roundabout(canvas: Canvas, rng: np.random.Generator, line: Boulevard) -> None:
    """A round square where the boulevard widens, with a column in its middle."""
    for radius, land in (
        (line.roundabout, LandClass.PAVED),
        (line.roundabout - 9.0, LandClass.ROAD),
        (line.roundabout - 22.0, LandClass.SQUARE),
        (line.roundabout - 34.0, LandClass.GRASS),
        (9.0, LandClass.SQUARE),
    ):
        canvas.lay(canvas.disc(line.u, line.v, radius), land)
    canvas.build(canvas.disc(line.u, line.v, 4.0), 12.0)
    canvas.build(canvas.disc(line.u, line.v, 2.0), 46.0)
    bearing = np.linspace(0.0, 2.0 * np.pi, 28, endpoint=False)
    for radius in (line.roundabout - 4.5, line.roundabout - 26.0):
        u, v = line.u + radius * np.cos(bearing), line.v + radius * np.sin(bearing)
        canvas.plant(rng, u, v, 11.0)


def _street_trees(canvas: Canvas, rng: np.random.Generator, plan: CityPlan) -> None:
    """Rows of trees on the pavements of the wider streets, with gaps."""
    for street in plan.streets:
        area = street.area
        breadth = area.depth if street.along_u else area.width
        if breadth < 10.0:
            continue
        start, stop = (area.u0, area.u1) if street.along_u else (area.v0, area.v1)
        along = np.arange(start + 6.0, stop - 6.0, 10.0)
        middle = area.centre[1] if street.along_u else area.centre[0]
        for side in (-1.0, 1.0):
            kept = along[rng.random(along.size) < 0.7]
            across = np.full(kept.size, middle + side * (breadth / 2 + 1.2))
            u, v = (kept, across) if street.along_u else (across, kept)
            canvas.plant(rng, u, v, 11.0)
