# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Slope and roughness under the landing gear are those of the plane that fits best."""

import numpy as np
import pytest
from numpy.typing import NDArray

from ltp.world.flatness import flatness


def footprint_offsets(cell: float, radius: float) -> NDArray[np.int64]:
    """The cells (n, 2) whose middles are under the disc, or among the 3 x 3."""
    reach = max(1, int(radius / cell + 1e-9))
    steps = range(-reach, reach + 1)
    return np.array(
        [
            (i, j)
            for i in steps
            for j in steps
            if np.hypot(i, j) * cell <= radius + 1e-9 or max(abs(i), abs(j)) <= 1
        ]
    )


@pytest.mark.parametrize("shape", [(9, 7), (3, 3), (1, 5), (2, 1), (1, 1), (30, 4)])
@pytest.mark.parametrize(("cell", "radius"), [(1.0, 1.0), (0.3, 1.0), (5.0, 1.0), (0.5, 2.2)])
def test_it_is_the_plane_of_least_squares(
    shape: tuple[int, int], cell: float, radius: float
) -> None:
    surface = 1000.0 + np.random.default_rng(3).normal(size=shape)
    offsets = footprint_offsets(cell, radius)
    found = flatness(surface, cell, radius)
    for i, j in np.ndindex(shape):
        cells = offsets + np.array([i, j])
        there = ((cells >= 0) & (cells < shape)).all(axis=1)
        around, heights = offsets[there], surface[tuple(cells[there].T)]
        matrix = np.c_[np.ones(len(around)), around * cell]
        plane = np.linalg.lstsq(matrix, heights, rcond=None)[0]
        slope = np.degrees(np.arctan(np.hypot(*plane[1:])))
        assert found.slope[i, j] == pytest.approx(slope, abs=1e-8)
        rest = np.abs(heights - matrix @ plane).max()
        assert found.roughness[i, j] == pytest.approx(rest, abs=1e-8)


@pytest.mark.parametrize("cell", [0.1, 0.25, 0.5, 1.0, 2.0, 5.0])
@pytest.mark.parametrize("degrees", [0.0, 5.0, 30.0, 60.0])
@pytest.mark.parametrize("heading", [0.0, 30.0, 135.0, 290.0])
def test_a_plane_has_its_slope_and_no_roughness_up_to_the_border(
    cell: float, degrees: float, heading: float
) -> None:
    x, y = (np.arange(n) * cell for n in (30, 20))
    uphill = np.add.outer(x * np.cos(np.radians(heading)), y * np.sin(np.radians(heading)))
    found = flatness(4000.0 + np.tan(np.radians(degrees)) * uphill, cell, 1.0)
    np.testing.assert_allclose(found.slope, degrees, atol=1e-7)
    np.testing.assert_allclose(found.roughness, 0.0, atol=1e-9)


def test_many_blocks_are_as_one() -> None:
    surface = np.random.default_rng(1).normal(size=(300, 400))
    whole = flatness(surface, 0.5, 1.0)
    part = flatness(surface[100:140, 150:200], 0.5, 1.0)
    for a, b in zip(whole, part, strict=True):
        np.testing.assert_allclose(a[104:136, 154:196], b[4:36, 4:46], atol=1e-9)


def test_a_footprint_of_too_many_cells_is_refused() -> None:
    with pytest.raises(ValueError, match=r"gear_radius must be at most 256 cells of 0.001 m"):
        flatness(np.zeros((3, 3)), 0.001, 1.0)
