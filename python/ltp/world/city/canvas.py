# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Painting boxes, discs and trees into the rasters of a city."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..classes import LandClass
from .plan import Rect

_TREE_GROUND = (
    LandClass.GRASS,
    LandClass.BARE,
    LandClass.PAVED,
    LandClass.SQUARE,
    LandClass.PATH,
    LandClass.PARKING,
)


@dataclass(frozen=True)
class Patch:
    """A shape on the raster: where it is, and local coordinates of the cells around it."""

    window: tuple[slice, slice]
    s: NDArray[np.float64]  # from the middle, along the length [m]
    t: NDArray[np.float64]  # from the middle, across [m]
    inside: NDArray[np.bool_]


class Canvas:
    """Height and land class of a square map, painted in the street frame (u, v)."""

    def __init__(self, cells: int, cell: float, angle: float) -> None:
        self.cells, self.cell = cells, cell
        self.cos, self.sin = math.cos(angle), math.sin(angle)
        self.half = 0.5 * cells * cell
        centre = (np.arange(cells) + 0.5) * cell - self.half
        self.u = self.cos * centre[:, None] + self.sin * centre[None, :]
        self.v = -self.sin * centre[:, None] + self.cos * centre[None, :]
        self.height = np.zeros((cells, cells))
        self.classes = np.full((cells, cells), LandClass.ROAD, dtype=np.uint8)
        self.reserved = np.zeros((cells, cells), dtype=np.bool_)  # blocks must not build here
        self._trees: list[NDArray[np.float64]] = []  # rows of u, v, height, radius

    def box(
        self, u: float, v: float, length: float, depth: float, turn: float = 0.0
    ) -> Patch | None:
        """A rectangle round (u, v), turned by `turn` [rad] against u; None if outside."""
        c, s = math.cos(turn), math.sin(turn)
        reach_u = 0.5 * (length * abs(c) + depth * abs(s))
        reach_v = 0.5 * (length * abs(s) + depth * abs(c))
        window = self._window(u, v, reach_u, reach_v)
        if window is None:
            return None
        du, dv = self.u[window] - u, self.v[window] - v
        along, across = c * du + s * dv, c * dv - s * du
        inside = (np.abs(along) <= length / 2) & (np.abs(across) <= depth / 2)
        return Patch(window, along, across, inside)

    def rect(self, area: Rect) -> Patch | None:
        """The patch of a rectangle of the plan; None if outside or empty."""
        return self.box(*area.centre, area.width, area.depth)

    def disc(self, u: float, v: float, radius: float) -> Patch | None:
        """A disc; None if outside."""
        window = self._window(u, v, radius, radius)
        if window is None:
            return None
        du, dv = self.u[window] - u, self.v[window] - v
        return Patch(window, du, dv, du * du + dv * dv <= radius * radius)

    def lay(
        self,
        patch: Patch | None,
        land: LandClass,
        height: float | NDArray[np.float64] = 0.0,
        where: NDArray[np.bool_] | None = None,
    ) -> None:
        """Cover the free part of `patch` with `land`, replacing what was there."""
        if patch is None:
            return
        chosen = patch.inside & ~self.reserved[patch.window]
        if where is not None:
            chosen &= where
        self.classes[patch.window][chosen] = land
        heights = np.broadcast_to(height, chosen.shape)
        self.height[patch.window][chosen] = heights[chosen]

    def build(self, patch: Patch | None, height: float | NDArray[np.float64]) -> None:
        """Raise a building over `patch`; one that a corridor cuts to a sliver is left out."""
        if patch is None:
            return
        chosen = patch.inside & ~self.reserved[patch.window]
        if chosen.sum() <= 0.6 * patch.inside.sum():
            return
        self.classes[patch.window][chosen] = LandClass.BUILDING
        tops = self.height[patch.window]
        np.maximum(tops, height, out=tops, where=chosen)

    def plant(
        self,
        rng: np.random.Generator,
        u: NDArray[np.float64],
        v: NDArray[np.float64],
        tallest: float = 15.0,
    ) -> None:
        """Mark trees at (u, v); those on unfit ground are dropped when they are grown."""
        height = rng.uniform(0.5, 1.0, u.size) * tallest
        radius = np.clip(height * rng.uniform(0.22, 0.36, u.size), 1.5, 5.0)
        self._trees.append(np.column_stack([u, v, height, radius]))

    def grow_trees(self) -> None:
        """Stamp all planted trees as domes; crowns stop at houses and water."""
        if not self._trees:
            return
        u, v, height, radius = np.concatenate(self._trees).T
        x = self.cos * u - self.sin * v + self.half
        y = self.sin * u + self.cos * v + self.half
        i, j = np.floor(x / self.cell).astype(int), np.floor(y / self.cell).astype(int)
        kept = (i >= 0) & (j >= 0) & (i < self.cells) & (j < self.cells)
        kept[kept] = np.isin(self.classes[i[kept], j[kept]], _TREE_GROUND)
        x, y, i, j, height, radius = (a[kept] for a in (x, y, i, j, height, radius))
        solid = np.isin(self.classes, (LandClass.BUILDING, LandClass.WATER, LandClass.PITCH))
        reach = math.ceil(radius.max(initial=0.0) / self.cell)
        for di in range(-reach, reach + 1):
            for dj in range(-reach, reach + 1):
                a, b = i + di, j + dj
                off = np.hypot((a + 0.5) * self.cell - x, (b + 0.5) * self.cell - y) / radius
                hit = (off < 1.0) & (a >= 0) & (b >= 0) & (a < self.cells) & (b < self.cells)
                hit[hit] = ~solid[a[hit], b[hit]]
                dome = height[hit] * (0.6 + 0.4 * np.sqrt(1.0 - off[hit] ** 2))
                np.maximum.at(self.height, (a[hit], b[hit]), dome)
                self.classes[a[hit], b[hit]] = LandClass.TREES

    def _window(
        self, u: float, v: float, reach_u: float, reach_v: float
    ) -> tuple[slice, slice] | None:
        if min(reach_u, reach_v) <= 0.0:
            return None
        x = self.cos * u - self.sin * v + self.half
        y = self.sin * u + self.cos * v + self.half
        reach_x = reach_u * abs(self.cos) + reach_v * abs(self.sin)
        reach_y = reach_u * abs(self.sin) + reach_v * abs(self.cos)
        i, j = self._span(x, reach_x), self._span(y, reach_y)
        return (i, j) if i.start < i.stop and j.start < j.stop else None

    def _span(self, middle: float, reach: float) -> slice:
        first = max(0, math.floor((middle - reach) / self.cell))
        return slice(first, min(self.cells, math.ceil((middle + reach) / self.cell)))
