# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The built-in city repeats itself to the bit, and is a city worth flying in."""

import hashlib
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy import ndimage

from ltp.world import LandClass, World, landable_mask, make_city

SEEDS = (1, 2, 3, 4)


@pytest.fixture(scope="module", params=SEEDS)
def city(request: pytest.FixtureRequest) -> World:
    return make_city(request.param)


def digest(world: World) -> str:
    data = world.surface.tobytes() + world.classes.tobytes() + world.ground.tobytes()
    return hashlib.sha256(data).hexdigest()


def test_the_same_seed_gives_the_same_bytes(tmp_path: Path) -> None:
    make_city(7, size=400.0).save(tmp_path / "a.npz")
    make_city(7, size=400.0).save(tmp_path / "b.npz")
    assert (tmp_path / "a.npz").read_bytes() == (tmp_path / "b.npz").read_bytes()


def test_another_process_builds_the_same_city() -> None:
    code = (
        "import hashlib, ltp.world\n"
        "w = ltp.world.make_city(7, size=400.0)\n"
        "d = w.surface.tobytes() + w.classes.tobytes() + w.ground.tobytes()\n"
        "print(hashlib.sha256(d).hexdigest())"
    )
    environment = {**os.environ, "PYTHONHASHSEED": "77"}
    result = subprocess.run(
        [sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=True
    )
    assert result.stdout.strip() == digest(make_city(7, size=400.0))


def test_worlds_need_numpy_only() -> None:
    code = (
        "import sys, ltp.world; ltp.world.make_city(1, size=100.0)\n"
        "print(sorted({'matplotlib', 'scipy', 'rasterio', 'laspy', 'osmium'} & set(sys.modules)))"
    )
    result = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True
    )
    assert result.stdout.strip() == "[]"


def test_seeds_differ() -> None:
    assert len({digest(make_city(seed, size=300.0)) for seed in range(6)}) == 6


def test_frame_and_ground(city: World) -> None:
    assert city.shape == (1000, 1000)
    assert city.extent == (0.0, 0.0, 1000.0, 1000.0)
    assert not city.ground.any()
    assert city.datum.crs is None
    assert city.attribution


def test_heights_fit_the_classes(city: World) -> None:
    height = city.height_above_ground
    assert height.max() == 120.0  # the landmark
    for land in (LandClass.ROAD, LandClass.PITCH, LandClass.GRASS, LandClass.WATER):
        assert not height[city.classes == land].any()
    for land in (LandClass.PAVED, LandClass.SQUARE, LandClass.PATH, LandClass.BARE):
        assert not height[city.classes == land].any()
    assert set(np.unique(height[city.classes == LandClass.PARKING])) == {0.0, 1.5}  # cars
    assert height[city.classes == LandClass.BUILDING].min() > 2.5
    trees = height[city.classes == LandClass.TREES]
    assert trees.min() > 2.0
    assert trees.max() < 20.0


def test_a_city_has_everything(city: World) -> None:
    share = np.bincount(city.classes.ravel(), minlength=len(LandClass)) / city.classes.size
    for land, least, most in (
        (LandClass.BUILDING, 0.20, 0.35),
        (LandClass.ROAD, 0.20, 0.32),
        (LandClass.GRASS, 0.06, 0.20),
        (LandClass.TREES, 0.04, 0.12),
        (LandClass.WATER, 0.03, 0.08),
        (LandClass.PAVED, 0.10, 0.22),
        (LandClass.SQUARE, 0.01, 0.08),
        (LandClass.PARKING, 0.01, 0.08),
        (LandClass.PATH, 0.005, 0.03),
        (LandClass.PITCH, 0.002, 0.03),
    ):
        assert least < share[land] < most, land.name
    assert share[LandClass.UNKNOWN] == 0.0
    assert 0.35 < landable_mask(city, "wide").mean() < 0.65
    assert 0.04 < landable_mask(city, "strict").mean() < 0.20


def test_a_straight_flight_at_50_m_meets_buildings(city: World) -> None:
    assert 0.06 < (city.surface > 50.0).mean() < 0.20
    rng = np.random.default_rng(9)
    lines = blocked = 0
    while lines < 400:
        start, bearing = rng.uniform(0.0, 1000.0, 2), rng.uniform(0.0, 2.0 * np.pi)
        stop = start + 500.0 * np.array([np.cos(bearing), np.sin(bearing)])
        if (stop < 0.0).any() or (stop >= 1000.0).any():
            continue
        points = start + np.linspace(0.0, 1.0, 2001)[:, None] * (stop - start)
        i, j = points.astype(int).T
        lines += 1
        blocked += bool((city.surface[i, j] >= 50.0).any())
    assert blocked / lines >= 0.80


@pytest.mark.parametrize("altitude", [20.0, 50.0, 80.0])
def test_the_free_space_hangs_together(city: World, altitude: float) -> None:
    labels, _ = ndimage.label(city.surface < altitude)  # steps over an edge, not over a corner
    sizes = np.bincount(labels.ravel())[1:]
    assert sizes.max() / sizes.sum() > (0.999 if altitude >= 50.0 else 0.9)


@pytest.mark.parametrize(
    ("arguments", "shape", "highest"),
    [
        ({"size": 100.0}, (100, 100), 120.0),
        ({"size": 250.0, "cell": 2.5}, (100, 100), 120.0),
        ({"size": 300.0, "cell": 0.5}, (600, 600), 120.0),
        ({"size": 600, "max_height": 30.0}, (600, 600), 30.0),
        ({"size": 1500.0, "cell": 3.0}, (500, 500), 120.0),
    ],
)
def test_other_sizes(arguments: dict[str, Any], shape: tuple[int, int], highest: float) -> None:
    world = make_city(3, **arguments)
    assert world.shape == shape
    assert 5.0 < world.surface.max() <= highest
    assert (world.classes == LandClass.BUILDING).mean() > 0.08


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"seed": -1}, "seed must be a whole number"),
        ({"seed": 1.5}, "seed must be a whole number"),
        ({"seed": None}, "seed must be a whole number"),
        ({"size": 50.0}, "size must be at least 100 m"),
        ({"size": np.nan}, "size must be a finite number"),
        ({"size": 1e7}, "size / cell must not exceed"),
        ({"cell": 0.0}, "cell must be above zero"),
        ({"cell": 0.3}, "cell must divide size"),
        ({"cell": 500.0}, "cell must divide size"),
        ({"cell": 1e-9}, "size / cell must not exceed"),
        ({"max_height": -5.0}, "max_height must be above zero"),
    ],
)
def test_a_bad_argument_is_named(arguments: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        make_city(**arguments)
