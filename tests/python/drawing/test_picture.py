# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The picture of a world: light falls as it should, and the file is a picture."""

import struct
from pathlib import Path

import numpy as np
import pytest

from ltp.drawing.picture import world_picture
from ltp.drawing.shading import sunlight
from ltp.world import Datum, World, make_city


def test_a_picture_is_drawn(tmp_path: Path) -> None:
    path = tmp_path / "city.png"
    world_picture(make_city(1, size=200.0), path)
    data = path.read_bytes()
    assert data.startswith(b"\x89PNG")
    width, height = struct.unpack(">II", data[16:24])
    assert width > 1500
    assert height > 1500


def test_the_attribution_stands_on_the_page(tmp_path: Path) -> None:
    flat = np.full((30, 12), 4.0)  # a long map, nothing on it, far from the local zero
    world = World(
        "marsh", flat, flat, np.ones((30, 12), int), 5.0, datum=Datum("EPSG:2154", 2.9e5, 6.8e6)
    )
    worded = World(
        "marsh", flat, flat, world.classes, 5.0, datum=world.datum, attribution="(c) the herons"
    )
    path = tmp_path / "marsh.svg"
    for drawn, expected in ((world, False), (worded, True)):
        world_picture(drawn, path, altitude=20.0)
        assert ("(c) the herons" in path.read_text()) == expected


def test_a_bad_ending_or_altitude_is_named(tmp_path: Path) -> None:
    world = make_city(1, size=100.0)
    with pytest.raises(ValueError, match=r"path must end in .png, .pdf or .svg"):
        world_picture(world, tmp_path / "city.exe")
    with pytest.raises(ValueError, match="altitude must be above zero"):
        world_picture(world, tmp_path / "city.png", altitude=0.0)
    assert list(tmp_path.iterdir()) == []


def test_level_ground_is_fully_lit_and_a_tower_casts_its_shadow_to_the_south_east() -> None:
    surface = np.zeros((60, 60))
    np.testing.assert_allclose(sunlight(surface, 1.0), 1.0)
    surface[30, 30] = 9.0  # tan(42 deg) = 0.9: the shadow is 10 m long, 7 cells along each axis
    light = sunlight(surface, 1.0)
    dark = light < 0.7
    away = [(i - 30, 30 - j) for i, j in np.argwhere(dark) if max(abs(i - 30), abs(j - 30)) > 1]
    assert away == [(k, k) for k in range(2, 8)]


def test_a_slope_towards_the_sun_is_brighter() -> None:
    x, y = np.meshgrid(np.arange(20.0), np.arange(20.0), indexing="ij")
    towards, aside = sunlight(0.2 * (x - y), 1.0), sunlight(0.2 * (y - x), 1.0)
    assert towards.min() > 1.0 > aside.max()
