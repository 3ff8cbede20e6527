# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Filling holes: planes come back exactly, gaps are as wide as a disc, neighbours decide kinds."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from ltp.world.importers.fill import fill_linear, fill_nearest, grow, wide_gaps
from ltp.world.importers.geotiff.coarsen import coarsen


@settings(max_examples=50, deadline=None)
@given(seed=st.integers(0, 2**32 - 1), share=st.floats(0.05, 0.7))
def test_holes_in_a_plane_are_filled_exactly(seed: int, share: float) -> None:
    rng = np.random.default_rng(seed)
    i, j = np.meshgrid(np.arange(17.0), np.arange(12.0), indexing="ij")
    plane = 3.0 + 0.5 * i - 0.25 * j
    holes = rng.random(plane.shape) < share
    holes[[0, 0, -1, -1], [0, -1, 0, -1]] = False  # so that no hole lies beyond the known cells
    filled = fill_linear(np.where(holes, np.nan, plane))
    np.testing.assert_allclose(filled, plane, atol=1e-9)


def test_beyond_the_last_known_cells_the_nearest_counts() -> None:
    values = np.full((5, 3), np.nan)
    values[1] = 7.0
    values[2] = 9.0
    filled = fill_linear(values)
    assert np.array_equal(filled[:, 0], [7.0, 7.0, 9.0, 9.0, 9.0])
    assert np.array_equal(fill_nearest(values), filled)


def test_one_known_cell_fills_everything() -> None:
    values = np.full((4, 4), np.nan)
    values[2, 1] = 5.0
    assert np.array_equal(fill_linear(values), np.full((4, 4), 5.0))


def test_nothing_known_is_an_error() -> None:
    with pytest.raises(ValueError, match="all of them are missing"):
        fill_linear(np.full((2, 2), np.nan))


@pytest.mark.parametrize("side", [1, 2, 3, 4, 5, 6, 9])
def test_a_square_gap_counts_from_the_width_of_the_disc_that_fits(side: int) -> None:
    empty = np.zeros((30, 30), dtype=bool)
    empty[10 : 10 + side, 12 : 12 + side] = True
    assert wide_gaps(empty, 5.0).any() == (side >= 5)


def test_a_gap_on_the_rim_counts_as_wide_as_it_would_go_on() -> None:
    empty = np.zeros((30, 30), dtype=bool)
    empty[:, :3] = True
    assert np.array_equal(wide_gaps(empty, 5.0), empty)


def test_scattered_empty_cells_are_no_gap() -> None:
    empty = np.random.default_rng(1).random((200, 200)) < 0.36
    assert not wide_gaps(empty, 12.0).any()


def _grow_slowly(
    kinds: NDArray[np.uint8], known: NDArray[np.bool_], solid: tuple[int, ...]
) -> NDArray[np.uint8]:
    kinds, known = kinds.copy(), known.copy()
    while not known.all():
        ring = {}
        for i, j in np.argwhere(~known):
            near = [
                int(kinds[a, b])
                for a in range(max(i - 1, 0), min(i + 2, kinds.shape[0]))
                for b in range(max(j - 1, 0), min(j + 2, kinds.shape[1]))
                if known[a, b]
            ]
            if near:
                ring[i, j] = min(
                    set(near),
                    key=lambda kind: (
                        -near.count(kind),
                        solid.index(kind) if kind in solid else len(solid),
                        kind,
                    ),
                )
        if not ring:
            break
        for cell, kind in ring.items():
            kinds[cell], known[cell] = kind, True
    return kinds


@settings(max_examples=40, deadline=None)
@given(seed=st.integers(0, 2**32 - 1))
def test_growing_agrees_with_counting_neighbours_one_by_one(seed: int) -> None:
    rng = np.random.default_rng(seed)
    kinds = rng.integers(1, 5, (9, 11)).astype(np.uint8)
    known = rng.random(kinds.shape) < 0.4
    known[4, 4] = True
    grown, _ = grow(kinds, np.zeros(kinds.shape), known, ~known, (3, 1))
    assert np.array_equal(grown, _grow_slowly(kinds, known, (3, 1)))


def test_a_filled_cell_is_as_high_as_the_highest_neighbour_of_its_kind() -> None:
    kinds = np.array([[1, 1, 2], [1, 0, 2], [1, 2, 2]], dtype=np.uint8)
    heights = np.array([[3.0, 4.0, 50.0], [5.0, 0.0, 60.0], [6.0, 70.0, 80.0]])
    hole = kinds == 0
    grown, raised = grow(kinds, heights, ~hole, hole, (1,))
    assert (grown[1, 1], raised[1, 1]) == (1, 6.0)
    assert np.array_equal(np.delete(raised, 4), np.delete(heights, 4))


def test_what_no_ring_reaches_stays_as_it_is() -> None:
    kinds = np.array([[1, 0, 0]], dtype=np.uint8)
    grown, _ = grow(kinds, np.zeros((1, 3)), kinds == 1, np.array([[False, False, True]]), solid=())
    assert np.array_equal(grown, kinds)


def test_coarse_cells_keep_the_mean_ground_the_top_and_the_commonest_class() -> None:
    rng = np.random.default_rng(3)
    ground = rng.random((7, 5))
    surface = ground + rng.random((7, 5)) * 10
    classes = rng.integers(0, 4, (7, 5)).astype(np.uint8)
    coarse_ground, coarse_surface, coarse_classes = coarsen(ground, surface, classes, 2)
    assert coarse_ground.shape == coarse_surface.shape == coarse_classes.shape == (3, 2)
    for i in range(3):
        for j in range(2):
            block = np.s_[2 * i : 2 * i + 2, 2 * j : 2 * j + 2]
            counts = np.bincount(classes[block].ravel(), minlength=4)
            assert coarse_ground[i, j] == pytest.approx(ground[block].mean())
            assert coarse_surface[i, j] == surface[block].max()
            assert coarse_classes[i, j] == 3 - np.argmax(counts[::-1])


def test_blocks_larger_than_the_world_are_an_error() -> None:
    flat = np.zeros((3, 3))
    with pytest.raises(ValueError, match="factor"):
        coarsen(flat, flat, flat.astype(np.uint8), 4)
