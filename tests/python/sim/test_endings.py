# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""How flights end, why, and which cannot begin."""

import json

import numpy as np
import pytest

import ltp
from ltp._core import NavigationReason, NavigationStatus
from ltp.sim import FlightRecord, Mission, Outcome
from ltp.sim.record import WaypointEntry
from ltp.world import LandClass, World


def make_world(surface: np.ndarray, ground: float | np.ndarray = 0.0) -> World:
    base = np.zeros_like(surface) + ground
    classes = np.where(surface > base, LandClass.BUILDING, LandClass.GRASS).astype(np.uint8)
    return World("test", base, np.maximum(surface, base), classes, cell=1.0)


def flat(size: int = 160) -> np.ndarray:
    return np.zeros((size, size))


def line(*points: tuple[float, float], altitude: float = 30.0) -> np.ndarray:
    return np.array([(x, y, altitude) for x, y in points])


def small_config(**values) -> ltp.MissionConfig:
    config = ltp.MissionConfig(**values)
    config.mapping.dims = [80, 80, 20]
    return config


def test_a_flight_whose_waypoints_are_all_dropped_has_reached_nothing(tmp_path) -> None:
    surface = flat()
    surface[70:100, 50:90] = 60.0
    record = ltp.fly(make_world(surface), small_config(), line((30, 70), (85, 70)))
    assert record.outcome is Outcome.NOTHING_REACHED
    assert record.outcome.value == "nothing_reached"
    assert not record.complete
    assert record.reason == NavigationReason.ALL_DROPPED.text
    assert record.dropped[0].reason in ("goal_blocked", "unreachable")
    assert record.dropped[0].reason_text.startswith("the waypoint")
    record.save(tmp_path / "flight.npz")
    again = FlightRecord.load(tmp_path / "flight.npz")
    assert (again.outcome, again.reason) == (record.outcome, record.reason)
    assert again.dropped[0].reason_text == record.dropped[0].reason_text


def test_too_far_is_no_proof() -> None:
    # A wall across the way: round it is farther than the detour allows. The waypoint beyond it
    # is skipped, and never counted among those dropped.
    surface = flat(200)
    surface[:, 100:106] = 60.0
    config = small_config()
    config.navigation.max_detour = 60.0
    events = []

    class Watch:
        def on_start(self, setup) -> None: ...

        def on_step(self, step) -> None:
            events.extend(step.events)

        def on_end(self, record) -> None: ...

    path = line((95, 70), (95, 80), (95, 130))
    record = ltp.fly(make_world(surface), config, path, [Watch()])
    assert [entry.outcome for entry in record.waypoints] == ["reached", "skipped"]
    assert (len(record.reached), record.dropped, len(record.skipped)) == (1, [], 1)
    assert record.skipped[0].reason == "too_far" and "too far" in record.skipped[0].reason_text
    assert record.reason == "1 of 2 waypoints were reached, the others too far"
    assert "0 dropped, 1 too far" in repr(record)
    assert [entry.distance for entry in record.waypoints] == pytest.approx(
        [event.distance for event in events]
    )
    nowhere = ltp.fly(make_world(surface), config, line((95, 80), (95, 130)))
    assert nowhere.outcome is Outcome.NOTHING_REACHED
    assert nowhere.reason == "no waypoint was reached: the others too far"


def test_what_the_map_lost_is_in_the_record() -> None:
    surface = flat()
    surface[70:100, 50:90] = 60.0
    config = small_config()
    whole = ltp.fly(make_world(surface), config, line((30, 70), (40, 70)))
    assert whole.map_totals["marked"] > 0 and whole.map_totals["outside"] == 0
    assert whole.map_losses == []
    config.mapping.dims = [10, 10, 20]
    config.mapping.remember = False
    small = ltp.fly(make_world(surface), config, line((30, 70), (40, 70)))
    assert small.map_totals["outside"] > 0
    assert "hits lie outside the map's window of 20 m x 20 m" in small.map_losses[0]


def test_one_waypoint_reached_is_not_nothing() -> None:
    surface = flat()
    surface[70:100, 50:90] = 60.0
    record = ltp.fly(make_world(surface), small_config(), line((30, 70), (50, 70), (85, 70)))
    assert record.outcome is Outcome.REACHED
    assert record.reason == "1 of 2 waypoints were reached, the others dropped"
    assert [entry.reason_text != "" for entry in record.waypoints] == [False, True]


def test_a_flight_that_got_there_says_so() -> None:
    record = ltp.fly(make_world(flat()), small_config(), line((30, 70), (40, 70), (50, 70)))
    assert record.complete
    assert record.reason == "every waypoint was reached"


def test_a_record_without_a_reason_is_read_as_it_was(tmp_path) -> None:
    path = tmp_path / "flight.npz"
    ltp.fly(make_world(flat()), small_config(), line((30, 70), (50, 70))).save(path)
    with np.load(path) as archive:
        arrays = {name: archive[name] for name in archive.files}
    header = json.loads(arrays["header"].tobytes())
    del header["reason"], header["config"]["guidance"]
    arrays["header"] = np.frombuffer(json.dumps(header).encode(), dtype=np.uint8)
    np.savez_compressed(path, **arrays)
    assert FlightRecord.load(path).reason == ""


def test_a_reason_of_another_time_is_told_by_its_name() -> None:
    entry = WaypointEntry(0, "dropped", "too_windy", 0.0, (0, 0, 0), (0, 0, 0), (0, 0, 0))
    assert entry.reason_text == "too windy"


class Steps:
    def __init__(self) -> None:
        self.reasons: list[NavigationReason] = []

    def on_start(self, setup) -> None: ...

    def on_step(self, step) -> None:
        self.reasons.append(step.reason)

    def on_end(self, record) -> None: ...


def test_a_flight_that_is_walled_in_says_so() -> None:
    surface = flat()
    surface[50:110, 50:110] = 60.0
    surface[54:106, 54:106] = 0.0  # a courtyard, and the UAV in it
    config, steps = small_config(planner="bezier", hold_limit=2.0), Steps()
    record = ltp.fly(make_world(surface), config, line((80, 80), (150, 80)), [steps])
    assert record.outcome is Outcome.TIMED_OUT
    assert record.reason == f"held for 2 s: {NavigationReason.WALLED_IN.text}"
    assert steps.reasons[-1] == NavigationReason.WALLED_IN


def test_a_flight_whose_time_is_over_says_so() -> None:
    config = small_config(time_limit_factor=0.2)
    record = ltp.fly(make_world(flat()), config, line((30, 70), (120, 70)))
    assert record.outcome is Outcome.TIMED_OUT
    assert record.reason == "no more time: the limit of 6 s is over"


def test_a_collision_says_so() -> None:
    surface = flat()
    surface[60:90, 50:90] = 60.0
    record = ltp.fly(make_world(surface), small_config(), line((75, 75), (150, 75)))
    assert record.outcome is Outcome.COLLIDED
    assert record.reason == "the true world was touched"


class Scripted:
    """A planner that is told when to hold."""

    def __init__(self, planner, holds) -> None:
        self._planner, self._holds, self._tick = planner, holds, -1

    def __getattr__(self, name):
        return getattr(self._planner, name)

    def update(self, position):
        self._tick += 1
        status = self._planner.update(position)
        return NavigationStatus.HOLDING if self._holds(self._tick) else status


@pytest.mark.parametrize(
    ("holds", "outcome"),
    [
        (lambda tick: 10 <= tick < 25 or 30 <= tick < 45, Outcome.REACHED),  # 1.5 s each
        (lambda tick: tick % 19 < 18, Outcome.REACHED),  # for ever, but never for 2 s on end
        (lambda tick: 10 <= tick < 35, Outcome.TIMED_OUT),
    ],
)
def test_only_a_hold_without_a_break_times_out(holds, outcome) -> None:
    config = small_config(hold_limit=2.0, time_limit_factor=100.0)
    mission = Mission(make_world(flat()), config, line((30, 70), (60, 70)))
    mission.planner = Scripted(mission.planner, holds)
    assert mission.fly().outcome is outcome


# What stands at a start: the ground's cell blocks the one above it (inflation).
@pytest.mark.parametrize(
    ("ground", "altitude", "least"),
    [
        (0.0, 2.0, 4.0),
        (0.0, 0.5, 4.0),
        (0.0, 3.99, 4.0),
        (3.0, 6.0, 8.0),
        (17.3, 19.0, 20.0),
        (-12.5, -10.0, -8.0),
        (20.0, 15.0, 24.0),  # below the ground
    ],
)
def test_a_start_too_low_is_refused_and_the_least_altitude_works(ground, altitude, least) -> None:
    world = make_world(flat() + ground, ground)
    with pytest.raises(ValueError, match=rf"altitude is {altitude:g} m.*at least {least:g} m"):
        ltp.fly(world, small_config(), line((40, 40), (70, 40), altitude=altitude))
    record = ltp.fly(world, small_config(), line((40, 40), (70, 40), altitude=least))
    assert record.outcome is Outcome.REACHED


def test_small_cells_and_no_inflation_fly_lower() -> None:
    world = make_world(flat())
    config = small_config()
    config.mapping.cell = [1.0, 1.0, 1.0]
    assert ltp.fly(world, config, line((40, 40), (50, 40), altitude=2.5)).outcome == "reached"
    with pytest.raises(ValueError, match="at least 2 m"):
        ltp.fly(world, config, line((40, 40), (50, 40), altitude=1.0))
    config.mapping.inflation_radius = 0.0
    assert ltp.fly(world, config, line((40, 40), (50, 40), altitude=1.0)).outcome == "reached"


def test_an_open_band_takes_off_from_the_ground() -> None:
    config = small_config()
    config.navigation.band = (0.0, 20.0)
    path = np.array([[40.0, 40, 2], [60, 40, 10]])
    record = ltp.fly(make_world(flat()), config, path)
    assert record.outcome is Outcome.REACHED
    assert record.positions[:, 2].max() > 3.0


@pytest.mark.parametrize(
    ("priority_map", "carve", "band"),
    [("lpf", False, (0.0, 0.0)), ("binary", True, (0.0, 0.0)), ("lpf", True, (12.0, 12.0))],
)
def test_missions_with_other_options_over_hilly_ground(priority_map, carve, band) -> None:
    x, y = np.meshgrid(np.arange(160), np.arange(160), indexing="ij")
    ground = 50.0 + 4.0 * np.sin(x / 15) * np.cos(y / 20)
    surface = ground.copy()
    surface[80:95, 40:100] += 45.0
    config = small_config(priority_map=priority_map)
    config.lidar.pattern.azimuths = 120
    config.mapping.carve_free_space = carve
    config.navigation.band = band
    mission = Mission(make_world(surface, ground), config, line((40, 70), (130, 70), altitude=85.0))
    misses: list[int] = []

    class Sensing(Scripted):
        def sense(self, origin, hits, rays):
            misses.append(len(rays))
            return self._planner.sense(origin, hits, rays)

    mission.planner = Sensing(mission.planner, lambda tick: False)
    record = mission.fly()
    assert record.outcome is Outcome.REACHED
    assert record.min_clearance > 1.0
    assert (min(misses) > 0) is carve, "only a carving map is told of rays without a return"
    away = np.abs(record.positions[:, 2] - 85.0).max()
    assert away <= band[1] + 2.0
