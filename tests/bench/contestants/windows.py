# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The window's works: blocking what is near to obstacles, and moving on by one cell."""

import itertools
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ltp import OccupancyGrid, inflate

from ..contest import Shared, Solver, Work
from ..judges import near
from ..workload import CELL

_RADIUS = 4.0  # [m]

inflation = Work("inflate", "inflate the window by 4 m", lambda _: 5)
rolling = Work("roll", "roll the window by one cell along x", lambda _: 9)
rolling.once = True


@inflation.enter("ltp inflate")
def _(shared: Shared) -> Solver:
    grid = shared.town.hollow_grid
    return Solver(lambda _: inflate(grid, _RADIUS), OccupancyGrid.to_array)


@inflation.enter("scipy binary_dilation", "scipy", near(0, 0))
def _(shared: Shared) -> Solver:
    from scipy.ndimage import binary_dilation

    reach = [int(_RADIUS // edge) + 1 for edge in CELL]
    ball = np.zeros([2 * n + 1 for n in reach], dtype=bool)
    for offset in itertools.product(*(range(-n, n + 1) for n in reach)):
        gaps = [max(abs(o) - 1, 0) * edge for o, edge in zip(offset, CELL, strict=True)]
        ball[tuple(np.add(offset, reach))] = math.hypot(*gaps) <= _RADIUS

    def solve(_: int) -> NDArray[Any]:
        grown: NDArray[Any] = binary_dilation(shared.town.hollow, ball)
        return grown

    return Solver(solve)


@rolling.enter("ltp roll")
def _(shared: Shared) -> Solver:
    grid = OccupancyGrid.from_array(shared.town.hollow, shared.town.frame)
    return Solver(lambda _: grid.roll([1, 0, 0]), lambda _: grid.to_array())


@rolling.enter("numpy, slices of bytes", "numpy", near(0, 0))
def _(shared: Shared) -> Solver:
    cells = shared.town.hollow.copy()

    def solve(_: int) -> None:
        cells[:-1] = cells[1:]
        cells[-1] = False

    return Solver(solve, lambda _: cells.copy())
