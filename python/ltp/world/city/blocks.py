# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What stands on one block of the built-in city: one function per kind of block."""

import math
from collections.abc import Callable

import numpy as np

from ..classes import LandClass
from .parts import Site, lots, park_cars, pitched, row, tower, turned
from .plan import Rect

_INNER = (0.10, 0.30)  # centrality from which a block is inner town, and the middle


def fill_block(site: Site) -> None:
    """Pave the block's edge, choose a kind by how central it is, and build it."""
    site.cover(site.area, LandClass.PAVED)
    plot = site.plot
    if min(plot.width, plot.depth) < 22.0:
        _green(site)
        return
    kinds = _MIX[int(np.searchsorted(_INNER, site.centrality))]
    names = list(kinds)
    weights = np.array([kinds[name] for name in names])
    name = names[int(site.rng.choice(len(names), p=weights / weights.sum()))]
    _KINDS[name](site)


def _downtown(site: Site) -> None:
    """Towers on podiums, lot by lot, with a plaza now and then."""
    rng, canvas = site.rng, site.canvas
    for lot in lots(rng, site.plot, rng.uniform(46.0, 78.0), 3.5):
        site.cover(lot, LandClass.PAVED)
        roll = rng.random()
        side = min(lot.width, lot.depth)
        if roll < 0.07:
            _plaza(site, lot)
            continue
        podium = lot.inset(rng.uniform(0.0, 2.0))
        low = rng.uniform(9.0, 26.0)
        canvas.build(canvas.rect(podium), low)
        if roll < 0.22 or side < 20.0:  # an office house without a tower
            canvas.build(canvas.rect(podium.inset(4.0)), low + rng.uniform(6.0, 26.0))
            continue
        u, v = podium.centre
        style = str(rng.choice(["plain", "plain", "plain", "stepped", "round", "turned", "cross"]))
        height = 50.0 + 68.0 * rng.beta(1.1, 2.2) * (0.5 + 0.5 * site.centrality)
        if max(lot.width, lot.depth) > 1.5 * side and style in ("plain", "stepped"):
            across = lot.depth > lot.width
            canvas.build(
                canvas.box(u, v, *turned(across, 0.9 * max(lot.width, lot.depth), 0.7 * side)),
                height,
            )
            continue
        tower(site, u, v, min(50.0, rng.uniform(0.82, 0.97) * side), height, style)


def _perimeter(site: Site) -> None:
    """Houses wall to wall along the streets, round a courtyard."""
    rng, canvas, plot = site.rng, site.canvas, site.plot
    depth = rng.uniform(11.0, 14.0)
    yard = plot.inset(depth)
    storey = rng.uniform(15.0, 24.0) + 9.0 * site.centrality
    roomy = min(yard.width, yard.depth) > 12.0
    if not roomy:
        for lot in lots(rng, plot, 26.0, 0.0):
            canvas.build(canvas.rect(lot), storey + rng.normal(0.0, 2.5))
        return
    site.cover(yard, LandClass.GRASS if rng.random() < 0.6 else LandClass.PAVED)
    site.scatter(yard.inset(3.0), 70.0, 11.0)
    for bar in (
        Rect(plot.u0, plot.v0, plot.u1, yard.v0),
        Rect(plot.u0, yard.v1, plot.u1, plot.v1),
        Rect(plot.u0, yard.v0, yard.u0, yard.v1),
        Rect(yard.u1, yard.v0, plot.u1, yard.v1),
    ):
        for house in row(rng, bar, 13.0, 28.0):
            if rng.random() < 0.93:  # a gap lets one look into the yard
                pitched(site, house, max(9.0, storey + rng.normal(0.0, 2.2)), 0.25)
    if min(yard.width, yard.depth) > 34.0:
        u, v = yard.centre
        wing = canvas.box(u, v, *turned(yard.depth > yard.width, 0.6 * yard.width, 11.0))
        canvas.build(wing, rng.uniform(5.0, 14.0))
    if rng.random() < 0.55 * (0.5 + site.centrality):  # one corner house grew into a tower
        side = rng.uniform(20.0, 27.0)
        u = rng.choice([plot.u0 + side / 2, plot.u1 - side / 2])
        v = rng.choice([plot.v0 + side / 2, plot.v1 - side / 2])
        tower(site, float(u), float(v), side, rng.uniform(52.0, 84.0), "plain")


def _estate(site: Site) -> None:
    """Slabs and point blocks standing free on lawns, all turned the same way."""
    rng, canvas, plot = site.rng, site.canvas, site.plot
    site.cover(plot, LandClass.GRASS)
    turn = float(rng.choice([0.0, rng.uniform(0.3, 0.6), -rng.uniform(0.3, 0.6)]))
    pitch = rng.uniform(40.0, 48.0)
    slabs = rng.random() < 0.5
    height = rng.uniform(50.0, 78.0)
    parking = Rect(plot.u0, plot.v0, plot.u1, plot.v0 + 17.0)
    cells = lots(rng, Rect(plot.u0, parking.v1 + 4.0, plot.u1, plot.v1), 1.3 * pitch, 6.0)
    for cell in cells:  # all paths before the first house, or they would cut through it
        u, v = cell.centre
        canvas.lay(canvas.box(u, (parking.v1 + v) / 2, 2.5, v - parking.v1), LandClass.PATH)
    for cell in cells:
        u, v = cell.centre
        tall = height * rng.uniform(0.82, 1.12)
        if slabs:
            reach = min(cell.width, cell.depth) / max(0.7, abs(math.sin(turn)) + math.cos(turn))
            slab = canvas.box(u, v, *turned(cell.depth > cell.width, 0.95 * reach, 16.0), turn)
            canvas.build(slab, tall)
        else:
            side = min(30.0, 0.66 * min(cell.width, cell.depth))
            tower(site, u, v, side, tall, str(rng.choice(["plain", "cross", "turned"])))
    park_cars(site, parking)
    site.scatter(Rect(plot.u0, parking.v1, plot.u1, plot.v1).inset(2.0), 55.0)


def _houses(site: Site) -> None:
    """Two rows of low houses with gabled roofs and gardens between."""
    rng, plot = site.rng, site.plot
    site.cover(plot, LandClass.GRASS)
    along_u = plot.width >= plot.depth
    length = plot.width if along_u else plot.depth
    breadth = plot.depth if along_u else plot.width
    rows = max(1, round(breadth / 36.0)) if breadth > 30.0 else 1
    lane = breadth / (2 * rows)
    for number in range(2 * rows):
        near = number * lane + (4.0 if number % 2 == 0 else lane - 14.0)
        position = 2.0
        while position + 8.0 < length:
            front = rng.uniform(7.0, 12.0)
            if position + front > length:
                break
            u0, v0, du, dv = position, near + rng.uniform(0.0, 1.5), front, rng.uniform(8.5, 10.5)
            if not along_u:
                u0, v0, du, dv = v0, u0, dv, du
            house = Rect(plot.u0 + u0, plot.v0 + v0, plot.u0 + u0 + du, plot.v0 + v0 + dv)
            pitched(site, house, rng.uniform(5.0, 7.5), 0.7)
            position += front + rng.choice([0.0, 0.0, 3.0, 4.5])
    site.scatter(plot, 45.0, 9.0)


def _shed(site: Site) -> None:
    """A large low hall with its car park."""
    rng, plot = site.rng, site.plot
    site.cover(plot, LandClass.PAVED)
    share = rng.uniform(0.42, 0.58)
    if plot.width > plot.depth:
        cut = plot.u0 + share * plot.width
        hall, lot = Rect(plot.u0, plot.v0, cut, plot.v1), Rect(cut, plot.v0, plot.u1, plot.v1)
    else:
        cut = plot.v0 + share * plot.depth
        hall, lot = Rect(plot.u0, plot.v0, plot.u1, cut), Rect(plot.u0, cut, plot.u1, plot.v1)
    patch = site.canvas.rect(hall.inset(3.0))
    if patch is not None:
        sawtooth = rng.uniform(7.0, 10.0) + 0.22 * np.mod(patch.s, 12.0)
        site.canvas.build(patch, sawtooth)
    park_cars(site, lot.inset(2.0))


def _school(site: Site) -> None:
    """A pitch, a hall and a long low house."""
    rng, canvas, plot = site.rng, site.canvas, site.plot
    site.cover(plot, LandClass.GRASS)
    across = plot.depth > plot.width
    length, breadth = max(plot.width, plot.depth), min(plot.width, plot.depth)
    u, v = plot.centre
    field = canvas.box(u, v, *turned(across, length - 10.0, 0.52 * breadth))
    canvas.lay(field, LandClass.PITCH)
    offset = 0.38 * breadth
    du, dv = (offset, 0.0) if across else (0.0, offset)
    canvas.build(canvas.box(u + du, v + dv, *turned(across, 0.7 * length, 12.0)), 13.0)
    hall = canvas.box(u - du, v - dv, *turned(across, 0.3 * length, 0.16 * breadth))
    canvas.build(hall, rng.uniform(7.0, 9.0))
    site.scatter(plot, 35.0)


def _square(site: Site) -> None:
    """A paved square with trees round it and a church or a column in the middle."""
    rng, canvas, plot = site.rng, site.canvas, site.plot
    site.cover(plot, LandClass.SQUARE)
    u, v = plot.centre
    if rng.random() < 0.6 and min(plot.width, plot.depth) > 40.0:
        nave = canvas.box(u, v, 38.0, 15.0)
        if nave is not None:
            canvas.build(nave, 13.0 + 0.9 * (7.5 - np.abs(nave.t)))
            canvas.build(canvas.box(u + 5.0, v, 11.0, 28.0), 15.0)
            canvas.build(canvas.box(u - 22.0, v, 9.0, 9.0), 44.0)
            canvas.build(canvas.box(u - 22.0, v, 4.0, 4.0), 62.0)
    else:
        canvas.build(canvas.disc(u, v, 2.5), 28.0)
        canvas.lay(canvas.disc(u + 0.3 * plot.width, v, 6.0), LandClass.WATER)
    rim = plot.inset(4.0)
    for s in np.arange(rim.u0, rim.u1, 8.0):
        canvas.plant(rng, np.array([s, s]), np.array([rim.v0, rim.v1]), 10.0)


def _green(site: Site) -> None:
    """A small garden for plots too narrow to build on, and for a rest in between."""
    plot = site.plot
    if min(plot.width, plot.depth) < 4.0:
        return
    site.cover(plot, LandClass.GRASS)
    u, v = plot.centre
    canvas = site.canvas
    canvas.lay(canvas.box(u, v, math.hypot(plot.width, plot.depth), 2.5, 0.7), LandClass.PATH)
    site.scatter(plot.inset(2.0), 60.0)


def _car_park(site: Site) -> None:
    """A surface car park with a hedge of trees."""
    park_cars(site, site.plot)
    rim = site.plot.inset(1.0)
    u = np.arange(rim.u0, rim.u1, 11.0)
    site.canvas.plant(site.rng, u, np.full(u.size, rim.v0), 9.0)
    site.canvas.plant(site.rng, u, np.full(u.size, rim.v1), 9.0)


def _construction(site: Site) -> None:
    """Bare ground, a shell of a building, heaps of earth."""
    rng, canvas, plot = site.rng, site.canvas, site.plot
    site.cover(plot, LandClass.CONSTRUCTION)
    u, v = plot.centre
    canvas.build(canvas.box(u, v, 0.45 * plot.width, 0.4 * plot.depth), rng.uniform(12.0, 30.0))
    canvas.build(canvas.box(u, v, 6.0, 6.0), rng.uniform(32.0, 46.0))
    for _ in range(4):
        heap_u = rng.uniform(plot.u0 + 8.0, plot.u1 - 8.0)
        heap_v = rng.choice([plot.v0 + 9.0, plot.v1 - 9.0])
        heap = canvas.disc(heap_u, float(heap_v), rng.uniform(4.0, 8.0))
        if heap is not None:
            cone = np.maximum(0.0, 4.0 - 0.5 * np.hypot(heap.s, heap.t))
            canvas.lay(heap, LandClass.CONSTRUCTION, cone)
    canvas.lay(canvas.box(plot.u0 + 6.0, v, 9.0, 0.6 * plot.depth), LandClass.BARE)


def _plaza(site: Site, lot: Rect) -> None:
    """A paved lot with a few trees."""
    site.cover(lot, LandClass.SQUARE)
    site.scatter(lot.inset(4.0), 50.0, 9.0)


_KINDS: dict[str, Callable[[Site], None]] = {
    "downtown": _downtown,
    "perimeter": _perimeter,
    "estate": _estate,
    "houses": _houses,
    "shed": _shed,
    "school": _school,
    "square": _square,
    "green": _green,
    "car park": _car_park,
    "construction": _construction,
}

# How often each kind stands at the edge of town, in the inner town, in the middle.
_MIX: tuple[dict[str, float], ...] = (
    {
        "estate": 38,
        "houses": 22,
        "perimeter": 20,
        "shed": 7,
        "school": 6,
        "green": 3,
        "car park": 4,
    },
    {"perimeter": 36, "downtown": 42, "estate": 14, "square": 3, "car park": 3, "school": 2},
    {"downtown": 86, "perimeter": 8, "square": 4, "construction": 2},
)
