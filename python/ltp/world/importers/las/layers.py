# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the returns of a laser survey say about each cell of a lattice, by their class."""

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ltp.world.archive import MAX_CELLS
from ltp.world.classes import LandClass

from ..limits import HEIGHTS
from .meanings import Codes, Role

Bounds = tuple[float, float, float, float]

_CELLS_PER_POINT = 100  # with more, the extent in the header is a lie, or the cell a slip


@dataclass(frozen=True)
class Lattice:
    """The cells of the world in the CRS of the survey."""

    xmin: float
    ymin: float
    cell: float
    shape: tuple[int, int]
    slack: float = 0.0  # a return may lie this far outside: its coordinates were rounded [m]

    def index(self, coordinate: NDArray[np.float64], axis: int) -> NDArray[np.float64]:
        """The cell along `axis` of each coordinate, as a whole number; the rim has `slack`."""
        start, n = (self.xmin, self.ymin)[axis], self.shape[axis]
        at = (coordinate - start) / self.cell
        slack = self.slack / self.cell
        at = np.where((at < 0.0) & (at >= -slack), 0.0, at)
        return np.floor(np.where((at >= n) & (at <= n + slack), n - 1.0, at))

    @staticmethod
    def around(path: Path, header: Any, cell: float, bounds: Bounds | None) -> "Lattice":
        """The cells that cover `bounds`, or else the extent in the header of a survey.

        Raises:
            ValueError: naming `bounds` or the file, if that is no area or takes too many cells.
        """
        if bounds is None:
            (x0, y0), (x1, y1) = header.mins[:2], header.maxs[:2]
            source = f"{path}: the extent in the header"
        else:
            x0, y0, x1, y1 = bounds
            source = "bounds"
        if not (np.isfinite([x0, y0, x1, y1]).all() and x0 <= x1 and y0 <= y1):
            raise ValueError(f"{source} must be x_min, y_min, x_max, y_max, not {(x0, y0, x1, y1)}")
        if bounds is not None and (x0 == x1 or y0 == y1):
            raise ValueError(f"bounds must span an area, not {bounds}")
        i0, j0 = math.floor(x0 / cell), math.floor(y0 / cell)
        if bounds is None:  # a return on the northern rim needs a cell
            nx, ny = math.floor(x1 / cell) - i0 + 1, math.floor(y1 / cell) - j0 + 1
        else:
            nx, ny = math.ceil(x1 / cell) - i0, math.ceil(y1 / cell) - j0
        n_points = int(header.point_count)
        most = MAX_CELLS if bounds is not None else min(MAX_CELLS, _CELLS_PER_POINT * n_points)
        if nx * ny > most:
            larger = _larger(cell, nx * ny / most)
            raise ValueError(
                f"{source} needs {nx} x {ny} cells of {cell:g} m, more than {most:,} for "
                f"{n_points:,} returns; a larger cell would help, of {larger:g} m, unless the "
                "extent is wrong"
            )
        # Some writers took the extent before they rounded the returns, by up to half a step.
        slack = 0.0 if bounds is not None else float(max(header.scales[:2]))
        return Lattice(i0 * cell, j0 * cell, cell, (nx, ny), slack)


def _larger(cell: float, times: float) -> float:
    """A cell with so many times fewer on the same area, in two digits [m]."""
    wanted = 1.05 * cell * math.sqrt(times)  # the cells at the rim count whole
    step = 10.0 ** (math.floor(math.log10(wanted)) - 1)
    return math.ceil(wanted / step) * step


class Layers:
    """What the returns of a survey say about each cell, gathered chunk by chunk."""

    def __init__(self, lattice: Lattice, codes: Codes, height_unit: float = 1.0) -> None:
        self.lattice, self.codes = lattice, codes
        self._height_unit = height_unit  # [m]
        n = lattice.shape[0] * lattice.shape[1]
        self._sum, self._count = np.zeros(n), np.zeros(n)
        self._seen, self._drawn, self._undefined = np.zeros((3, n), dtype=bool)
        self._plant, self._structure, self._clutter = np.full((3, n), -np.inf)
        self._kinds = {
            LandClass(int(kind)): np.zeros(n, dtype=bool)
            for kind in np.unique(codes.kinds)
            if kind != LandClass.UNKNOWN
        }
        self._counts = np.zeros(256, dtype=np.int64)
        self._n_withheld = self._n_absurd = self._n_drawn = self._n_outside = 0
        self._ground_observed = False

    def add(self, path: Path, points: Any, *, cropped: bool) -> None:
        """Take in one chunk of returns; those outside the lattice only if it was cut out."""
        lattice = self.lattice
        x, y, z = (np.asarray(axis) for axis in (points.x, points.y, points.z))
        z = z * self._height_unit
        kind = np.asarray(points.classification)
        role = self.codes.roles[kind]
        withheld = np.asarray(points.withheld, dtype=bool)
        plausible = (z >= HEIGHTS[0]) & (z <= HEIGHTS[1])
        keep = (role != Role.DROPPED) & ~withheld & plausible
        i = lattice.index(x, 0)
        j = lattice.index(y, 1)
        inside = (i >= 0) & (i < lattice.shape[0]) & (j >= 0) & (j < lattice.shape[1])
        if not cropped and not inside[keep].all():
            where = np.flatnonzero(keep & ~inside)[0]
            raise ValueError(
                f"{path} has a return at ({x[where]:.2f}, {y[where]:.2f}), outside of the extent "
                "in its header"
            )
        self._counts += np.bincount(kind[inside], minlength=256)
        self._n_outside += int(np.count_nonzero(~inside))
        self._n_withheld += int(np.count_nonzero(inside & withheld))
        self._n_absurd += int(np.count_nonzero(inside & ~withheld & ~plausible))
        keep &= inside
        at = i[keep].astype(np.intp) * lattice.shape[1] + j[keep].astype(np.intp)
        kind, role, z = kind[keep], role[keep], z[keep]

        is_ground = role == Role.GROUND
        # Ground that nobody saw, drawn in to close a lake or a river: a height, no evidence.
        drawn = is_ground & np.asarray(points.synthetic, dtype=bool)[keep]
        self._n_drawn += int(np.count_nonzero(drawn))
        self._ground_observed |= bool((is_ground & ~drawn).any())
        self._seen[at[~drawn]] = True
        self._drawn[at[drawn]] = True
        n = self._seen.size
        self._count += np.bincount(at[is_ground], minlength=n)
        self._sum += np.bincount(at[is_ground], weights=z[is_ground], minlength=n)
        for top, of in (
            (self._plant, role == Role.PLANT),
            (self._structure, role == Role.STRUCTURE),
            (self._clutter, (role == Role.CLUTTER) | (role == Role.UNDEFINED)),
        ):
            np.maximum.at(top, at[of], z[of])
        self._undefined[at[role == Role.UNDEFINED]] = True
        land = self.codes.kinds[kind]
        for of_kind, where in self._kinds.items():
            where[at[is_ground & (land == of_kind)]] = True

    def report(self) -> list[str]:
        """Which classes there were and what became of them, a sentence each."""
        told = self.codes.describe(self._counts)
        for n, what in (
            (self._n_withheld, "marked as withheld: dropped"),
            (self._n_absurd, f"outside of {HEIGHTS[0]:g} ... {HEIGHTS[1]:g} m: dropped as noise"),
            (self._n_outside, "outside of the bounds: dropped"),
        ):
            if n:
                told.append(f"{n:,} returns {what}")
        if self._n_drawn and self._ground_observed:
            told.append(
                f"{self._n_drawn:,} ground returns are synthetic: they give the ground its height; "
                "cells that hold nothing else are UNKNOWN"
            )
        return told

    def _shaped(self, flat: NDArray[Any]) -> NDArray[Any]:
        return flat.reshape(self.lattice.shape)

    def ground(self) -> NDArray[np.float64]:
        """(nx, ny) mean height of the ground returns [m], NaN where there is none."""
        with np.errstate(invalid="ignore"):
            return self._shaped(self._sum / self._count)

    @property
    def seen(self) -> NDArray[np.bool_]:
        """(nx, ny) whether any return came from the cell, synthetic ones included."""
        return self._shaped(self._seen | self._drawn)

    @property
    def drawn(self) -> NDArray[np.bool_]:
        """(nx, ny) whether the cell holds synthetic ground only, in a survey that saw ground."""
        return self._shaped(self._drawn & ~self._seen & self._ground_observed)

    @property
    def undefined(self) -> NDArray[np.bool_]:
        """(nx, ny) whether the cell holds a return of a class that nobody defines."""
        return self._shaped(self._undefined)

    @property
    def vegetation(self) -> NDArray[np.float64]:
        """(nx, ny) highest return of a plant [m], -inf where there is none."""
        return self._shaped(self._plant)

    @property
    def structure(self) -> NDArray[np.float64]:
        """(nx, ny) highest return of a building, bridge or other lasting object [m], or -inf."""
        return self._shaped(self._structure)

    @property
    def clutter(self) -> NDArray[np.float64]:
        """(nx, ny) highest unclassified return [m], -inf where there is none."""
        return self._shaped(self._clutter)

    @property
    def kinds(self) -> dict[LandClass, NDArray[np.bool_]]:
        """Where the survey says what the ground is, by class."""
        return {kind: self._shaped(where) for kind, where in self._kinds.items()}
