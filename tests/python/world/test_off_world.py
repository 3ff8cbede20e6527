# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Waypoints off the world, in degrees or in map coordinates are refused, saying what is covered."""

from typing import Any

import numpy as np
import pytest

from ltp.config import MissionConfig
from ltp.sim import MissionSetup
from ltp.world import Datum, World
from ltp.world.off_world import refuse_off_world

LONDON = Datum("EPSG:27700", 532000.0, 181600.0, "ODN")
NOWHERE = Datum()
NEW_YORK = Datum("EPSG:32618", 583950.0, 4511100.0)


def field(datum: Datum = NOWHERE, origin: tuple[float, float] = (0.0, 0.0)) -> World:
    flat = np.zeros((60, 50))
    return World("field", flat, flat, flat.astype(np.uint8) + 1, 10.0, origin, datum)


def points(*flat: tuple[float, float]) -> Any:
    return np.array([(x, y, 30.0) for x, y in flat])


@pytest.mark.parametrize("origin", [(0.0, 0.0), (-300.0, 4000.0)])
def test_what_lies_over_the_world_is_taken(origin: tuple[float, float]) -> None:
    x, y = origin
    for datum in (NOWHERE, LONDON):
        world = field(datum, origin)
        for inside in (
            points((x, y), (x + 600, y + 500)),  # the very corners
            points((x + 2.5, y + 48.8), (x + 2.5, y + 48.8)),  # straight up
            points((x + 1, y + 2), (x + 3, y + 90)),
        ):
            refuse_off_world(world, inside)


@pytest.mark.parametrize(
    ("flat", "index"),
    [
        (((-0.01, 5.0), (9.0, 5.0)), 0),
        (((5.0, 5.0), (600.01, 5.0)), 1),
        (((5.0, 5.0), (5.0, 250.0), (5.0, -700.0)), 2),
        (((5.0, 5.0), (5.0, 1e300)), 1),
    ],
)
def test_the_first_point_off_the_world_is_named(flat: Any, index: int) -> None:
    covers = r"which covers x = 0 \.\.\. 600 m, y = 0 \.\.\. 500 m"
    with pytest.raises(ValueError, match=rf"track\[{index}\] = \(.*\) lies off field, {covers}"):
        refuse_off_world(field(), points(*flat), "track")


@pytest.mark.parametrize(
    ("datum", "flat"),
    [
        (LONDON, ((-0.0975, 51.5185), (-0.0945, 51.5205))),  # off the world, x < 0
        (LONDON, ((51.5185, -0.0975), (51.5205, -0.0945))),  # latitude first
        (NEW_YORK, ((-74.004, 40.746), (-74.001, 40.748))),
        (NEW_YORK, ((40.746, -74.004), (40.748, -74.001))),
        (NOWHERE, ((2.3501, 48.8502), (2.3522, 48.8544))),  # over the world, if these were metres
        (NOWHERE, ((48.8502, 2.3501), (48.8502, 2.3522))),
        (NOWHERE, ((-0.0975, 51.5185), (-0.0945, 51.5205))),
    ],
)
def test_degrees_are_told(datum: Datum, flat: Any) -> None:
    if datum.crs is not None:
        pytest.importorskip("pyproj")
    with pytest.raises(ValueError, match=r"global_path\[0\].*covers.*look like degrees"):
        refuse_off_world(field(datum), points(*flat))


def test_degrees_of_the_world_are_told_even_where_these_metres_exist() -> None:
    pytest.importorskip("pyproj")
    paris = Datum("EPSG:32631", 448000.0, 5411000.0)
    with pytest.raises(ValueError, match=r"is not in the metres of field, which.*degrees"):
        refuse_off_world(field(paris), points((2.2925, 48.8501), (2.2975, 48.8522)))
    refuse_off_world(field(paris), points((2.5, 48.8), (500.0, 400.0)))


def test_map_coordinates_are_told() -> None:
    at = points((584100.0, 4511200.0), (584300.0, 4511500.0))
    told = r"coordinates of EPSG:32618: subtract \(583950, 4511100\)"
    with pytest.raises(ValueError, match=told):
        refuse_off_world(field(NEW_YORK), at)
    with pytest.raises(ValueError, match="look like map coordinates"):
        refuse_off_world(field(), at)
    with pytest.raises(ValueError, match="look like map coordinates"):
        refuse_off_world(field(LONDON), at)


def test_a_crs_that_nobody_knows_stops_nothing() -> None:
    pytest.importorskip("pyproj")
    refuse_off_world(field(Datum("LOCAL:1", 5.0, 5.0)), points((2.5, 48.8), (2.9, 49.8)))


def test_a_mission_asks_first() -> None:
    with pytest.raises(ValueError, match=r"global_path\[1\] = \(700, 20\) lies off field"):
        MissionSetup.of(field(), MissionConfig(), points((20.0, 20.0), (700.0, 20.0)))
