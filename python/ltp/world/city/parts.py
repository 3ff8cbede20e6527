# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Parts that the blocks of the built-in city are made of: towers, houses, car parks, lots."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..classes import LandClass
from .canvas import Canvas
from .plan import Rect

PAVEMENT = 3.0  # width of the pavement round a block [m]


@dataclass(frozen=True)
class Site:
    """One block, kerb to kerb, and how central it is."""

    canvas: Canvas
    rng: np.random.Generator
    area: Rect
    centrality: float  # 0 at the edge of town ... 1 in the middle

    @property
    def plot(self) -> Rect:
        """The block inside its pavement."""
        return self.area.inset(PAVEMENT)

    def cover(self, area: Rect, land: LandClass) -> None:
        """Cover a rectangle of this block."""
        self.canvas.lay(self.canvas.rect(area), land)

    def scatter(self, area: Rect, per_hectare: float, tallest: float = 14.0) -> None:
        """Plant trees at random over a rectangle."""
        count = self.rng.poisson(max(0.0, area.width * area.depth) / 1e4 * per_hectare)
        u = self.rng.uniform(area.u0, area.u1, count)
        v = self.rng.uniform(area.v0, area.v1, count)
        self.canvas.plant(self.rng, u, v, tallest)


def tower(site: Site, u: float, v: float, side: float, height: float, style: str) -> None:
    """Raise a tower that fits a square of `side` metres round (u, v)."""
    canvas, rng = site.canvas, site.rng
    slim = rng.uniform(0.72, 1.0)
    if style == "round":
        canvas.build(canvas.disc(u, v, 0.5 * side), height)
        canvas.build(canvas.disc(u, v, 0.22 * side), height + 4.0)
        return
    if style == "stepped":
        for share, level in ((1.0, 0.66), (0.86, 0.86), (0.62, 0.95), (0.34, 1.0)):
            canvas.build(canvas.box(u, v, share * side, share * slim * side), level * height)
        return
    turn = 0.0
    if style == "turned":  # a turned square needs more room than an upright one
        turn = rng.uniform(0.25, math.pi / 2 - 0.25)
        side *= 0.86
    elif style == "cross":
        canvas.build(canvas.box(u, v, side, 0.45 * side), height)
        canvas.build(canvas.box(u, v, 0.45 * side, side), height)
        return
    canvas.build(canvas.box(u, v, side, slim * side, turn), height)
    canvas.build(canvas.box(u, v, 0.4 * side, 0.4 * slim * side, turn), height + 4.0)


def pitched(site: Site, house: Rect, eaves: float, slope: float) -> None:
    """A house under a gabled roof, its ridge along the longer side."""
    patch = site.canvas.rect(house)
    if patch is None:
        return
    across, breadth = (
        (patch.t, house.depth) if house.width >= house.depth else (patch.s, house.width)
    )
    site.canvas.build(patch, eaves + slope * np.maximum(0.0, breadth / 2 - np.abs(across)))


def park_cars(site: Site, lot: Rect) -> None:
    """Cover `lot` with parking: aisles every 16 m, two bays of 2.5 m stalls, two in three taken."""
    patch = site.canvas.rect(lot)
    if patch is None:
        return
    s, t = patch.s + lot.width / 2, patch.t + lot.depth / 2
    bay, across = np.floor(t / 8.0).astype(int), np.mod(t, 16.0)
    stall = np.floor(s / 2.5).astype(int)
    taken = site.rng.random((max(1, bay.max() + 1), max(1, stall.max() + 1))) < 0.66
    car = taken[np.clip(bay, 0, None), np.clip(stall, 0, None)]
    car &= (np.abs(across - 8.0) > 3.4) & (np.abs(across - 8.0) < 7.6)
    car &= (np.abs(np.mod(s, 2.5) - 1.25) < 0.95) & (s > 4.0) & (s < lot.width - 4.0)
    site.canvas.lay(patch, LandClass.PARKING, np.where(car, 1.5, 0.0))


def lots(rng: np.random.Generator, area: Rect, longest: float, gap: float) -> list[Rect]:
    """Cut `area` into lots no longer than `longest`, `gap` metres apart."""
    if min(area.width, area.depth) <= 0.0:
        return []
    across = max(1, math.ceil(area.width / longest))
    along = max(1, math.ceil(area.depth / longest))
    u, v = _cuts(rng, area.u0, area.u1, across), _cuts(rng, area.v0, area.v1, along)
    return [
        Rect(u[a] + gap / 2, v[b] + gap / 2, u[a + 1] - gap / 2, v[b + 1] - gap / 2)
        for a in range(across)
        for b in range(along)
    ]


def row(rng: np.random.Generator, bar: Rect, shortest: float, longest: float) -> list[Rect]:
    """Cut a bar along its longer side into houses."""
    count = max(1, round(max(bar.width, bar.depth) / rng.uniform(shortest, longest)))
    if bar.width >= bar.depth:
        u = _cuts(rng, bar.u0, bar.u1, count)
        return [Rect(u[k], bar.v0, u[k + 1], bar.v1) for k in range(count)]
    v = _cuts(rng, bar.v0, bar.v1, count)
    return [Rect(bar.u0, v[k], bar.u1, v[k + 1]) for k in range(count)]


def turned(across: bool, length: float, depth: float) -> tuple[float, float]:
    """(length, depth) along (u, v), or exchanged for a shape whose length runs along v."""
    return (depth, length) if across else (length, depth)


def _cuts(rng: np.random.Generator, start: float, stop: float, count: int) -> NDArray[np.float64]:
    """`count` + 1 places from `start` to `stop`, the inner ones shifted a little at random."""
    places = np.linspace(start, stop, count + 1)
    places[1:-1] += rng.uniform(-0.14, 0.14, count - 1) * (stop - start) / count
    return places
