# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The exact mean of a raster over a square round each cell: the low-pass filter of the camera."""

import numpy as np
from numpy.typing import ArrayLike, NDArray


def box_mean(values: ArrayLike, side: ArrayLike) -> NDArray[np.float64]:
    """Mean of a piecewise constant field over a square round the middle of each cell, exactly.

    The square is clipped at the border of the field and the mean is over what is left. A square
    no wider than a cell sees only its own cell.

    Args:
        values: the field, (nx, ny), finite.
        side: edge of the square [cells]; one number, or (nx, ny) of them. Not negative.

    Returns:
        (nx, ny), within the range of `values`.
    """
    field = np.asarray(values, dtype=np.float64)
    sides = np.asarray(side, dtype=np.float64)
    if field.ndim != 2 or field.size == 0 or not np.isfinite(field).all():
        raise ValueError(f"values must be finite, of shape (nx, ny), found shape {field.shape}")
    if sides.shape not in ((), field.shape):
        raise ValueError(f"side must be a number or of shape {field.shape}, found {sides.shape}")
    if not (np.isfinite(sides) & (sides >= 0.0)).all():
        raise ValueError("side must be finite and not negative")
    nx, ny = field.shape
    integral = np.zeros((nx + 1, ny + 1))  # of the field, from the corner (0, 0) to each corner
    integral[1:, 1:] = field.cumsum(axis=0).cumsum(axis=1)
    x, y = np.arange(nx)[:, None] + 0.5, np.arange(ny)[None, :] + 0.5
    x0, x1 = np.clip(x - sides / 2, 0.0, nx), np.clip(x + sides / 2, 0.0, nx)
    y0, y1 = np.clip(y - sides / 2, 0.0, ny), np.clip(y + sides / 2, 0.0, ny)
    total = _bilinear(integral, x1, y1) + _bilinear(integral, x0, y0)
    total -= _bilinear(integral, x0, y1) + _bilinear(integral, x1, y0)
    own = sides <= 1.0  # also keeps a vanishing square from dividing 0 by 0
    mean = np.where(own, field, total / np.where(own, 1.0, (x1 - x0) * (y1 - y0)))
    return np.clip(mean, field.min(), field.max())  # rounding of the integral


def _bilinear(
    corners: NDArray[np.float64], x: NDArray[np.float64], y: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Interpolate between corners: for an integral of a piecewise constant field, exact."""
    i = np.minimum(x.astype(np.int64), corners.shape[0] - 2)
    j = np.minimum(y.astype(np.int64), corners.shape[1] - 2)
    s, t = x - i, y - j
    low = corners[i, j] * (1.0 - t) + corners[i, j + 1] * t
    high = corners[i + 1, j] * (1.0 - t) + corners[i + 1, j + 1] * t
    return np.asarray(low * (1.0 - s) + high * s)
