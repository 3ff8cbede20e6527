# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A global path from a table."""

import csv
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


def read_waypoints(path: Path) -> "NDArray[np.float64]":
    """The waypoints in a CSV, (n, 3) [m]: x,y,z a line; lines with # in front are left out."""
    import numpy as np

    try:
        with path.open(newline="", encoding="utf-8-sig") as file:
            lines = [line for line in csv.reader(file) if line and not line[0].startswith("#")]
        points = np.array([[float(value) for value in line] for line in lines])
    except (ValueError, csv.Error) as error:
        raise ValueError(f"{path}: not a list of numbers x,y,z: {error}") from None
    if points.ndim != 2 or points.shape[1] != 3 or len(points) < 2:
        raise ValueError(f"{path}: expected two lines x,y,z or more")
    if not np.isfinite(points).all():
        where = int(np.flatnonzero(~np.isfinite(points).all(axis=1))[0])
        raise ValueError(f"{path}: waypoint {where} is not finite: {tuple(points[where].tolist())}")
    return points
