# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The rasters of a world while shapes are painted on them."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ltp.world.archive import MAX_CELLS
from ltp.world.classes import LandClass

from ..optional import require
from .source import Box

_PURPOSE = "reading OpenStreetMap files"


@dataclass(frozen=True)
class Canvas:
    """Surface and classes, [x, y], over flat ground."""

    bounds: Box
    cell: float
    box: Any  # the bounds as a shapely polygon
    surface: NDArray[np.float64]
    classes: NDArray[np.uint8]

    @staticmethod
    def over(bounds: Box, cell: float) -> "Canvas":
        """An empty one.

        Raises:
            ValueError: naming what of the bounds and the cell makes no sense.
        """
        if not (math.isfinite(cell) and cell > 0.0):
            raise ValueError(f"cell must be above zero, not {cell!r}")
        if len(bounds) != 4 or not all(math.isfinite(value) for value in bounds):
            raise ValueError(f"bounds must be x_min, y_min, x_max, y_max in metres, not {bounds}")
        x0, y0, x1, y1 = bounds
        cells = np.array([(x1 - x0) / cell, (y1 - y0) / cell])
        whole = np.rint(cells)
        if (whole < 1).any() or (np.abs(cells - whole) > 1e-6).any():
            raise ValueError(f"bounds must span whole cells of {cell:g} m, not {cells} of them")
        if whole.prod() > MAX_CELLS:
            raise ValueError(f"bounds hold {whole.prod():.0f} cells, more than {MAX_CELLS:,}")
        shape = (int(whole[0]), int(whole[1]))
        box = require("shapely", _PURPOSE).box(x0, y0, x1, y1)
        classes = np.full(shape, LandClass.UNKNOWN, dtype=np.uint8)
        return Canvas(bounds, cell, box, np.zeros(shape), classes)

    @property
    def shape(self) -> tuple[int, int]:
        """Cells along x and y."""
        return self.surface.shape[0], self.surface.shape[1]

    def paint(
        self,
        areas: Sequence[tuple[Any, LandClass]],
        where: NDArray[np.bool_] | None = None,
    ) -> None:
        """Lay `areas` on the ground, the last on top, and only `where` it is true."""
        none = 255
        burnt = self.burn([(area, float(kind)) for area, kind in areas], none)
        laid = burnt != none if where is None else (burnt != none) & where
        self.classes[laid] = burnt[laid].astype(np.uint8)

    def mask(self, areas: Sequence[tuple[Any, bool]]) -> NDArray[np.bool_]:
        """The cells that `areas` cover, the last deciding, by its flag."""
        return np.asarray(self.burn([(area, float(flag)) for area, flag in areas], 0.0) > 0.0)

    def raise_to(
        self,
        solids: Sequence[tuple[Any, float]],
        kind: LandClass,
        *,
        thin: bool = False,
    ) -> None:
        """Put up solids of a height each; where they overlap, the highest is seen.

        What is `thin` fills every cell that it touches, and gives its kind only to those where
        nothing stands higher.
        """
        ordered = sorted(solids, key=lambda solid: solid[1])
        height = self.burn(ordered, 0.0, all_touched=thin)
        seen = (height > 0.0) & (height >= self.surface) if thin else height > 0.0
        np.maximum(self.surface, height, out=self.surface)
        self.classes[seen] = kind

    def burn(
        self, areas: Sequence[tuple[Any, float]], fill: float, *, all_touched: bool = False
    ) -> NDArray[np.float64]:
        """The value of the last of `areas` that covers each cell's centre, or else `fill`."""
        features = require("rasterio.features", _PURPOSE)
        affine = require("rasterio", _PURPOSE).Affine
        near = [(area, value) for area, value in areas if area.intersects(self.box)]
        if not near:
            return np.full(self.shape, fill)
        image = features.rasterize(
            near,
            out_shape=self.shape[::-1],
            fill=fill,
            transform=affine(self.cell, 0.0, self.bounds[0], 0.0, -self.cell, self.bounds[3]),
            all_touched=all_touched,
            dtype="float64",
        )
        # Image order is [row, column] from the north-west corner.
        return np.asarray(image[::-1].T)
