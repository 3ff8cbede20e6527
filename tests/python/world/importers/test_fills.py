# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fill values are found in any land, and land is not taken for them."""

import time
from collections.abc import Callable

import numpy as np
import pytest
from numpy.typing import NDArray

from ltp.world.importers.geotiff.fills import find_fills, is_code

ndimage = pytest.importorskip("scipy.ndimage")

Heights = NDArray[np.float64]


def land(seed: int, base: float, slope: float, cell: float, n: int = 60) -> Heights:
    """Smooth land around a height whose steepest cells rise by `slope`."""
    waves = ndimage.gaussian_filter(np.random.default_rng(seed).standard_normal((n, n)), 5.0)
    steepest = max(np.abs(np.diff(waves, axis=axis)).max() for axis in (0, 1))
    return np.asarray(base + waves * (slope * cell / steepest))


KINDS: dict[str, Callable[[Heights], Heights]] = {
    "as it is": lambda z: z,
    "whole metres": np.round,
    "steps of 5 m": lambda z: np.round(z / 5.0) * 5.0,
    "a lake": lambda z: np.maximum(z, np.percentile(z, 30.0)),
    "the sea": lambda z: np.maximum(z - np.percentile(z, 40.0), 0.0),
    "a plateau": lambda z: np.minimum(z, np.percentile(z, 70.0)),
    "a lake in whole metres": lambda z: np.maximum(np.round(z), np.round(np.median(z))),
}


@pytest.mark.parametrize("cell", [0.25, 1.0, 5.0, 30.0])
@pytest.mark.parametrize("kind", KINDS)
def test_land_is_no_fill(kind: str, cell: float) -> None:
    for seed, base in enumerate((-3.0, 0.0, 50.0, 300.0, 999.0, 2500.0)):
        for slope in (0.05, 0.5, 2.5):
            fills = find_fills(KINDS[kind](land(seed, base, slope, cell)), cell)
            assert not fills.found and not fills.doubted, (base, slope, fills.found)
            assert not fills.holes.any() and not fills.doubtful.any()


@pytest.mark.parametrize("fill", [-99.0, -200.0, -321.0, 255.0, 999.0, 8888.0, 1234.0, 5000.0])
@pytest.mark.parametrize("kind", KINDS)
def test_a_fill_is_found_in_any_land(kind: str, fill: float) -> None:
    for seed in range(4):
        z = KINDS[kind](land(seed, 60.0, 0.5, 1.0))
        hole = ndimage.gaussian_filter(np.random.default_rng(seed + 9).random(z.shape), 4.0)
        hole = hole > np.percentile(hole, 75.0)
        z[hole] = fill
        fills = find_fills(z, 1.0)
        assert np.array_equal(fills.holes, hole)
        assert [(f.value, f.n_cells) for f in fills.found] == [(fill, np.count_nonzero(hole))]
        assert abs(fills.found[0].jump - (60.0 - fill)) < 60.0


def test_an_island_among_holes_is_judged_by_the_rest() -> None:
    z = land(1, 60.0, 0.3, 1.0)
    z[20:40, 20:40] = np.nan
    z[25:35, 25:35] = -99.0
    assert np.count_nonzero(find_fills(z, 1.0).holes) == 0  # nothing beside it: nothing shows
    z[5:8, 5:8] = -99.0
    assert np.array_equal(find_fills(z, 1.0).holes, z == -99.0)


@pytest.mark.parametrize("cell", [1.0, 30.0])
def test_a_wall_of_rock_grows_with_the_cell(cell: float) -> None:
    z = land(3, 200.0, 0.1, 1.0)
    z[20:30, 20:30] = 0.0
    z[40:50, 40:50] = -250.0
    found = {fill.value for fill in find_fills(z, cell).found}
    assert found == {0.0, -250.0}
    z = land(3, 70.0, 0.1, 1.0)
    z[20:30, 20:30] = 0.0
    assert bool(find_fills(z, cell).found) == (cell == 1.0)


@pytest.mark.parametrize(
    ("stored", "largest", "code"),
    [
        (-99.0, None, True),
        (-9999.9, None, True),
        (float(np.float32(-999.9)), None, True),
        (999.0, None, True),
        (8888.0, None, True),
        (99.0, None, False),
        (255.0, 255.0, True),
        (255.0, None, False),
        (-32768.0, 32767.0, True),
        (9.0, None, False),
        (0.0, None, False),
        (998.0, None, False),
    ],
)
def test_numbers_that_files_are_filled_with(
    stored: float, largest: float | None, code: bool
) -> None:
    assert is_code(stored, largest) == code


def test_noise_takes_no_longer_than_a_few_seconds() -> None:
    noise = np.random.default_rng(0).integers(0, 8000, (300, 300)).astype(np.float64)
    begin = time.process_time()
    find_fills(noise, 1.0)
    assert time.process_time() - begin < 5.0
