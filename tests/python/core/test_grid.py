# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Frames, rasters and occupancy grids from Python: numpy says what each must answer."""

import gc
import itertools
import math

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

import ltp

NAN, INF = math.nan, math.inf
SHAPES = st.tuples(
    st.integers(1, 6), st.integers(1, 6), st.sampled_from([1, 2, 5, 63, 64, 65, 130])
)


def frame_of(shape: tuple[int, ...], origin: tuple[float, ...] = (0, 0, 0)) -> ltp.GridFrame:
    return ltp.GridFrame(origin=origin, cell=(2, 2, 4), dims=shape)


# --- GridFrame


def test_a_frame_takes_any_triple_and_gives_it_back() -> None:
    for kind in (tuple, list, np.array):
        frame = ltp.GridFrame(origin=kind([-1, 2, 3]), cell=kind([2, 2, 4]), dims=kind([5, 6, 7]))
        np.testing.assert_array_equal(frame.origin, [-1, 2, 3])
        np.testing.assert_array_equal(frame.cell, [2, 2, 4])
        np.testing.assert_array_equal(frame.dims, [5, 6, 7])
        np.testing.assert_array_equal(frame.upper, [9, 14, 31])
    assert repr(frame) == "GridFrame(origin=(-1, 2, 3), cell=(2, 2, 4), dims=(5, 6, 7))"


def test_a_frame_finds_cells_and_centres() -> None:
    frame = frame_of((5, 6, 7), (-1, 2, 3)).shifted((10, -10, 1))
    np.testing.assert_array_equal(frame.origin, [19, -18, 7])
    for cell in itertools.product(range(5), range(6), range(7)):
        centre = frame.centre(cell)
        np.testing.assert_array_equal(frame.cell_of(centre), cell)
        np.testing.assert_allclose(centre, frame.origin + (np.array(cell) + 0.5) * (2, 2, 4))
        assert frame.contains(centre)
    for bad in ([NAN, 0, 0], [0, INF, 0], [0, 0, -1e300], [29, -18, 7]):
        assert not frame.contains(bad)


@pytest.mark.parametrize(
    ("name", "arguments"),
    [
        ("origin", {"origin": (0, NAN, 0)}),
        ("cell.x", {"cell": (0, 1, 1)}),
        ("cell.y", {"cell": (1, -2, 1)}),
        ("cell.z", {"cell": (1, 1, NAN)}),
        ("cell.z", {"cell": (1, 1, INF)}),
        ("dims.x", {"dims": (0, 1, 1)}),
        ("dims.y", {"dims": (1, -1, 1)}),
        ("dims", {"dims": (2**20, 2**20, 2**20)}),
    ],
)
def test_a_frame_names_what_is_wrong(name: str, arguments: dict[str, tuple[float, ...]]) -> None:
    good = {"origin": (0, 0, 0), "cell": (1, 1, 1), "dims": (3, 3, 3)}
    with pytest.raises(ValueError, match=rf"^{name} = "):
        ltp.GridFrame(**(good | arguments))


@pytest.mark.parametrize(
    "arguments",
    [
        {"origin": (0, 0)},
        {"cell": 2.0},
        {"dims": (1, 2)},
        {"dims": (1.5, 2, 3)},
        {"dims": (2**40, 1, 1)},
        {"origin": "abc"},
        {"resolution": 1.0},
    ],
)
def test_a_frame_refuses_wrong_types(arguments: dict[str, object]) -> None:
    good = {"origin": (0, 0, 0), "cell": (1, 1, 1), "dims": (3, 3, 3)}
    with pytest.raises((TypeError, ValueError)):
        ltp.GridFrame(**(good | arguments))


def test_a_frame_is_not_shifted_off_its_lattice() -> None:
    with pytest.raises(ValueError, match=r"^by = "):
        frame_of((3, 3, 3)).shifted((2**31 - 1, 0, 0))


def test_equality_is_a_question_and_never_an_error() -> None:
    frame = frame_of((3, 3, 3))
    grid = ltp.OccupancyGrid(frame)
    assert frame == frame_of((3, 3, 3))
    assert frame != frame.shifted((1, 0, 0))
    assert grid == ltp.OccupancyGrid(frame)
    for other in (None, 3, "frame", (0, 0, 0), object()):
        assert frame != other
        assert grid != other
    assert frame != grid


# --- Raster


def test_a_raster_samples_cells() -> None:
    values = np.arange(12.0).reshape(3, 4)
    raster = ltp.Raster(values, origin=(10, -4), cell=2.0, outside=-1.0)
    x, y = np.meshgrid(np.linspace(8, 18, 41), np.linspace(-6, 6, 49), indexing="ij")
    i = np.floor((x - 10) / 2).astype(int)
    j = np.floor((y + 4) / 2).astype(int)
    inside = (i >= 0) & (i < 3) & (j >= 0) & (j < 4)
    expected = np.where(inside, values[i.clip(0, 2), j.clip(0, 3)], -1.0)
    np.testing.assert_array_equal(raster.at(x, y), expected)
    assert raster.at(x, y).shape == x.shape
    assert isinstance(raster.at(11.0, -3.0), float)
    np.testing.assert_array_equal(raster.at([11, 13], -3.0), [0, 4])
    np.testing.assert_array_equal(raster.at([NAN, INF, -INF, 1e300], 0.0), [-1, -1, -1, -1])
    centres_x, centres_y = np.meshgrid([11, 13, 15], [-3, -1, 1, 3], indexing="ij")
    np.testing.assert_array_equal(raster.bilinear(centres_x, centres_y), values)
    assert raster.bilinear(12.0, -2.0) == np.mean([0, 1, 4, 5])
    assert raster.bilinear(9.9, -2.0) == -1


@pytest.mark.parametrize("dtype", ["f8", "f4", "f2", "i8", "u2", "i1", "?"])
def test_a_raster_takes_real_numbers_of_any_kind(dtype: str) -> None:
    values = np.array([[0, 1], [1, 0], [1, 1]], dtype)
    raster = ltp.Raster(values)
    assert raster.values.dtype == np.float64
    assert raster.shape == (3, 2)
    np.testing.assert_array_equal(raster.values, values.astype(float))
    for laid_out in (np.asfortranarray(values), np.repeat(values, 2, axis=1)[:, ::2], values[:]):
        np.testing.assert_array_equal(ltp.Raster(laid_out).values, raster.values)


def test_a_raster_owns_its_values() -> None:
    values = np.zeros((3, 2))
    raster = ltp.Raster(values)
    values[:] = 7
    assert not raster.values.any()
    view = raster.values
    with pytest.raises(ValueError, match="read-only"):
        view[0, 0] = 1
    with pytest.raises(ValueError, match="WRITEABLE"):
        view.flags.writeable = True
    assert np.shares_memory(view, raster.values)
    del raster
    gc.collect()
    assert not view.any()


@pytest.mark.parametrize(
    ("error", "text", "arguments"),
    [
        (TypeError, "complex128", {"values": np.zeros((2, 2), complex)}),
        (TypeError, "object", {"values": np.array([[None, 1]])}),
        (TypeError, "<U1", {"values": np.array([["a"]])}),
        (TypeError, "datetime64", {"values": np.zeros((2, 2), "M8[s]")}),
        (ValueError, r"^values.shape = \(4,\)", {"values": np.zeros(4)}),
        (ValueError, r"^values.shape = \(2, 2, 2\)", {"values": np.zeros((2, 2, 2))}),
        (ValueError, r"^values.shape = \(0, 3\)", {"values": np.zeros((0, 3))}),
        (ValueError, r"^values\[1, 0\] = nan", {"values": np.array([[0, 1], [NAN, 2]])}),
        (ValueError, r"^values\[0, 1\] = inf", {"values": np.array([[0, INF], [0, 2]])}),
        (ValueError, r"^cell = 0", {"cell": 0.0}),
        (ValueError, r"^cell = -1", {"cell": -1}),
        (ValueError, r"^cell = nan", {"cell": NAN}),
        (ValueError, r"^origin.y = ", {"origin": (0, NAN)}),
        (ValueError, r"^outside = ", {"outside": -INF}),
        (TypeError, "incompatible", {"origin": (0, 0, 0)}),
        (TypeError, "incompatible", {"cell": "2"}),
        (TypeError, "incompatible", {"unknown": 2}),
    ],
)
def test_a_raster_names_what_is_wrong(
    error: type[Exception], text: str, arguments: dict[str, object]
) -> None:
    with pytest.raises(error, match=text):
        ltp.Raster(**({"values": np.zeros((2, 2))} | arguments))


def slow_integral(raster: ltp.Raster, a: np.ndarray, b: np.ndarray) -> float:
    """The segment is cut at every line of the lattice; each piece counts by its middle."""
    cuts = [0.0, 1.0]
    for axis, count in enumerate(raster.shape):
        lines = raster.origin[axis] + raster.cell * np.arange(count + 1)
        if a[axis] != b[axis]:
            with np.errstate(over="ignore"):
                times = (lines - a[axis]) / (b[axis] - a[axis])
            cuts += [t for t in times if 0 < t < 1]
    t = np.sort(cuts)
    middles = a + (0.5 * (t[1:] + t[:-1]))[:, None] * (b - a)
    values = raster.at(middles[:, 0], middles[:, 1])
    return float(np.sum(np.diff(t) * values) * np.linalg.norm(b - a))


COORDINATES = st.one_of(
    st.integers(-12, 12).map(lambda n: n / 2), st.floats(-6, 6, allow_subnormal=True)
)


@settings(deadline=None, max_examples=300)
@given(
    ends=st.tuples(*[COORDINATES] * 6),
    shape=st.tuples(st.integers(1, 5), st.integers(1, 5)),
    cell=st.sampled_from([0.5, 1.0, 2.0, 0.7]),
    seed=st.integers(0, 2**32 - 1),
)
def test_integrals_are_sums_over_pieces(
    ends: tuple[float, ...], shape: tuple[int, int], cell: float, seed: int
) -> None:
    values = np.random.default_rng(seed).random(shape)
    raster = ltp.Raster(values, origin=(-1, -2), cell=cell, outside=0.3)
    a, b = np.array(ends[:3]), np.array(ends[3:])
    expected = slow_integral(raster, a, b)
    assert raster.integral(a, b) == pytest.approx(expected, abs=1e-8)


def test_integrals_of_any_length_return_at_once() -> None:
    raster = ltp.Raster(np.ones((10, 10)))
    assert raster.integral((-1e9, 5, 0), (1e9, 5, 0)) == pytest.approx(10, abs=1e-3)
    assert raster.integral((0, 0, 0), (1e150, 1e150, 0)) == pytest.approx(10 * 2**0.5, rel=1e-3)
    assert math.isfinite(raster.integral((-1e150, 3, 0), (1e150, 3, 0)))
    for bad in ((NAN, 0, 0), (0, 0, INF)):
        with pytest.raises(ValueError, match=r"^a = "):
            raster.integral(bad, (0, 0, 0))
        with pytest.raises(ValueError, match=r"^b = "):
            raster.integral((0, 0, 0), bad)


# --- OccupancyGrid


@settings(deadline=None, max_examples=100)
@given(shape=SHAPES, seed=st.integers(0, 2**32 - 1), layout=st.sampled_from("CFTS"))
def test_an_array_becomes_a_grid_and_back(
    shape: tuple[int, int, int], seed: int, layout: str
) -> None:
    blocked = np.random.default_rng(seed).random(shape) < 0.4
    given_array = {
        "C": blocked,
        "F": np.asfortranarray(blocked),
        "T": np.ascontiguousarray(blocked.T).T,
        "S": np.repeat(blocked, 3, axis=2)[:, :, ::3],
    }[layout]
    grid = ltp.OccupancyGrid.from_array(given_array, frame_of(shape))
    assert grid.count() == blocked.sum()
    dense = grid.to_array()
    assert dense.dtype == bool
    np.testing.assert_array_equal(dense, blocked)
    dense[:] = True  # a copy
    np.testing.assert_array_equal(grid.to_array(), blocked)
    # The columns' bits are the same cells.
    bits = np.unpackbits(grid.columns.view(np.uint8), axis=2, bitorder="little")
    np.testing.assert_array_equal(bits[:, :, : shape[2]], blocked)
    assert not bits[:, :, shape[2] :].any()
    points = frame_of(shape).centre((0, 0, 0)) + np.argwhere(np.ones(shape)) * (2.0, 2.0, 4.0)
    np.testing.assert_array_equal(grid.blocked_at(points), blocked.ravel())


def test_bytes_seen_as_bools_are_true_or_false() -> None:
    raw = np.array([[[0, 1, 2, 128, 255, 0, 64]]], np.uint8)
    grid = ltp.OccupancyGrid.from_array(raw.view(bool), frame_of((1, 1, 7)))
    np.testing.assert_array_equal(grid.to_array(), raw > 0)


@pytest.mark.parametrize(
    ("error", "text", "array"),
    [
        (TypeError, r"^blocked.dtype = uint8", np.zeros((2, 3, 4), np.uint8)),
        (TypeError, r"^blocked.dtype = float64", np.zeros((2, 3, 4))),
        (TypeError, r"^blocked.dtype = object", np.full((2, 3, 4), None)),
        (ValueError, r"^blocked.shape = \(4, 3, 2\)", np.zeros((4, 3, 2), bool)),
        (ValueError, r"^blocked.shape = \(2, 3\)", np.zeros((2, 3), bool)),
        (ValueError, r"^blocked.shape = \(\)", np.array(True)),
        (ValueError, r"^blocked.shape = \(2, 3, 4, 1\)", np.zeros((2, 3, 4, 1), bool)),
        (ValueError, r"^blocked.shape = \(0, 3, 4\)", np.zeros((0, 3, 4), bool)),
    ],
)
def test_a_grid_names_what_is_wrong(error: type[Exception], text: str, array: np.ndarray) -> None:
    with pytest.raises(error, match=text):
        ltp.OccupancyGrid.from_array(array, frame_of((2, 3, 4)))


def test_the_columns_are_a_read_only_view_that_keeps_the_grid_alive() -> None:
    blocked = np.random.default_rng(1).random((20, 30, 70)) < 0.5
    grid = ltp.OccupancyGrid.from_array(blocked, frame_of((20, 30, 70)))
    view = grid.columns
    assert (view.shape, view.dtype) == ((20, 30, 2), np.uint64)
    assert np.shares_memory(view, grid.columns)
    assert not view.flags.owndata
    with pytest.raises(ValueError, match="read-only"):
        view[0, 0, 0] = 1
    with pytest.raises(ValueError, match="WRITEABLE"):
        view.flags.writeable = True
    before = view.copy()
    grid.roll((1, 0, 0))  # seen through the view: nothing was copied
    np.testing.assert_array_equal(view[:-1], before[1:])
    assert not view[-1].any()
    after = view.copy()
    del grid
    gc.collect()
    noise = [np.random.default_rng(i).random((20, 30, 2)) for i in range(20)]
    np.testing.assert_array_equal(view, after)
    assert len(noise) == 20


@settings(deadline=None, max_examples=150)
@given(
    shape=SHAPES,
    shift=st.tuples(st.integers(-8, 8), st.integers(-8, 8), st.integers(-140, 140)),
    seed=st.integers(0, 2**32 - 1),
)
@example(shape=(3, 3, 130), shift=(0, 0, 64), seed=0)
@example(shape=(3, 3, 130), shift=(1, -1, -128), seed=0)
@example(shape=(3, 3, 64), shift=(-1, 2, 63), seed=0)
def test_rolling_moves_the_window(
    shape: tuple[int, int, int], shift: tuple[int, int, int], seed: int
) -> None:
    blocked = np.random.default_rng(seed).random(shape) < 0.5
    expected = np.zeros(shape, bool)
    for cell in np.argwhere(blocked):
        target = cell - shift
        if (target >= 0).all() and (target < shape).all():
            expected[tuple(target)] = True
    grid = ltp.OccupancyGrid.from_array(blocked, frame_of(shape, (5, 5, 5)))
    grid.roll(shift)
    np.testing.assert_array_equal(grid.to_array(), expected)
    np.testing.assert_array_equal(
        grid.frame.origin, np.array((5, 5, 5)) + shift * np.array((2, 2, 4))
    )


def test_a_refused_roll_changes_nothing() -> None:
    grid = ltp.OccupancyGrid.from_array(np.ones((2, 2, 2), bool), frame_of((2, 2, 2)))
    with pytest.raises(ValueError, match=r"^by = "):
        grid.roll((0, 2**31 - 1, 0))
    assert grid.count() == 8


def test_cells_are_whole_numbers() -> None:
    grid = ltp.OccupancyGrid.from_array(np.ones((3, 3, 3), bool), frame_of((3, 3, 3)))
    for function in (grid.roll, grid.frame.shifted, grid.frame.centre):
        for wrong in ((0.5, 0, 0), (2**32, 0, 0), np.array([1.0, 0, 0]), (1, 0), 1, "abc", None):
            with pytest.raises(TypeError):
                function(wrong)
        for right in ((1, 0, 0), [1, 0, 0], np.array([1, 0, 0]), np.array([1, 0, 0], np.int8)):
            function(right)


def test_the_first_touch_of_a_path() -> None:
    blocked = np.zeros((10, 10, 5), bool)
    blocked[5] = True
    grid = ltp.OccupancyGrid.from_array(blocked, frame_of((10, 10, 5)))
    path = np.array([[1.0, 1, 2], [1, 7, 2], [19, 7, 2]])
    assert grid.first_blocked(path) == pytest.approx(6 + 9)
    assert grid.first_blocked(path, from_arc_length=16.5) == pytest.approx(16.5)
    assert grid.first_blocked(path, from_arc_length=17.5) is None
    assert grid.first_blocked(path[:2]) is None
    assert grid.first_blocked(np.empty((0, 3))) is None
    assert grid.first_blocked(np.array([[-1e12, 5, 5], [1e12, 5, 5]])) == pytest.approx(1e12 + 10)
    for bad in (NAN, INF):
        broken = path.copy()
        broken[1, 2] = bad
        with pytest.raises(ValueError, match=r"^path\[1\] = "):
            grid.first_blocked(broken)
    with pytest.raises(ValueError, match=r"^from = nan"):
        grid.first_blocked(path, from_arc_length=NAN)
    for wrong in (np.zeros((4, 2)), np.zeros(4), "path", None):
        with pytest.raises(TypeError):
            grid.first_blocked(wrong)
