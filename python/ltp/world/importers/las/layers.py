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

Bounds = tuple[float, float, float, float]

# ASPRS classes (LAS 1.4 R15, tables 9 and 10), and those of the French national survey from 64 on.
_GROUND = (2, 8, 9, 10, 11)  # ground, its key points, water, rail, road surface
_KINDS = {9: LandClass.WATER, 10: LandClass.RAIL, 11: LandClass.ROAD}
_VEGETATION = (3, 4, 5)
_STRUCTURES = (6, 13, 14, 15, 16, 17, 64)  # buildings, wires, masts, bridges, permanent objects
_DROPPED = (7, 12, 18, 65, 66, 67)  # noise, overlap, high noise, artefacts, virtual points, other

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
            raise ValueError(
                f"{source} needs {nx} x {ny} cells of {cell:g} m, more than {most:,} for "
                f"{n_points:,} returns"
            )
        # Some writers took the extent before they rounded the returns, by up to half a step.
        slack = 0.0 if bounds is not None else float(max(header.scales[:2]))
        return Lattice(i0 * cell, j0 * cell, cell, (nx, ny), slack)


class Layers:
    """What the returns of a survey say about each cell, gathered chunk by chunk."""

    def __init__(self, lattice: Lattice, height_unit: float = 1.0) -> None:
        self.lattice = lattice
        self._height_unit = height_unit  # [m]
        n = lattice.shape[0] * lattice.shape[1]
        self._sum, self._count = np.zeros(n), np.zeros(n)
        self._seen = np.zeros(n, dtype=bool)
        self._plant, self._structure, self._clutter = np.full((3, n), -np.inf)
        self._kinds = {kind: np.zeros(n, dtype=bool) for kind in _KINDS.values()}

    def add(self, path: Path, points: Any, *, cropped: bool) -> None:
        """Take in one chunk of returns; those outside the lattice only if it was cut out."""
        lattice = self.lattice
        x, y, z = (np.asarray(axis) for axis in (points.x, points.y, points.z))
        z = z * self._height_unit
        kind = np.asarray(points.classification)
        keep = ~np.isin(kind, _DROPPED) & ~np.asarray(points.withheld, dtype=bool)
        keep &= (z >= HEIGHTS[0]) & (z <= HEIGHTS[1])
        i = lattice.index(x, 0)
        j = lattice.index(y, 1)
        inside = (i >= 0) & (i < lattice.shape[0]) & (j >= 0) & (j < lattice.shape[1])
        if not cropped and not inside[keep].all():
            where = np.flatnonzero(keep & ~inside)[0]
            raise ValueError(
                f"{path} has a return at ({x[where]:.2f}, {y[where]:.2f}), outside of the extent "
                "in its header"
            )
        keep &= inside
        at = i[keep].astype(np.intp) * lattice.shape[1] + j[keep].astype(np.intp)
        kind, z = kind[keep], z[keep]

        self._seen[at] = True
        is_ground = np.isin(kind, _GROUND)
        n = self._seen.size
        self._count += np.bincount(at[is_ground], minlength=n)
        self._sum += np.bincount(at[is_ground], weights=z[is_ground], minlength=n)
        is_plant, is_structure = np.isin(kind, _VEGETATION), np.isin(kind, _STRUCTURES)
        # Unclassified, or of a class that nobody knows: an obstacle as well.
        is_clutter = ~(is_ground | is_plant | is_structure)
        for top, of in (
            (self._plant, is_plant),
            (self._structure, is_structure),
            (self._clutter, is_clutter),
        ):
            np.maximum.at(top, at[of], z[of])
        for code, land in _KINDS.items():
            self._kinds[land][at[kind == code]] = True

    def _shaped(self, flat: NDArray[Any]) -> NDArray[Any]:
        return flat.reshape(self.lattice.shape)

    def ground(self) -> NDArray[np.float64]:
        """(nx, ny) mean height of the ground returns [m], NaN where there is none."""
        with np.errstate(invalid="ignore"):
            return self._shaped(self._sum / self._count)

    @property
    def seen(self) -> NDArray[np.bool_]:
        """(nx, ny) whether any return came from the cell."""
        return self._shaped(self._seen)

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
