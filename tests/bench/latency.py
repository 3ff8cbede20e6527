# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""From a scan to the plan that knows it, over whole flights: on one thread and on two.

    python -m tests.bench.latency [--world WORLD.npz] [--flights 5]

Flies paths of 500 m with scans of 65,536 rays over the built-in city or over a world of yours, and
writes what the scans had to wait for. The times are those of the wall, but for one row.
"""

import argparse
import json
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ltp import (
    ConcurrentTrajectoryPlanner,
    FlightRecord,
    LocalTrajectoryPlanner,
    MissionConfig,
    NavigationStatus,
    ObstacleMap,
    World,
)
from ltp.evaluation.scenarios import ScenarioOptions, make_scenario
from ltp.sim.mission import Mission
from ltp.world.city import make_city


class OneThread:
    """Stands in for the planner of a mission, and looks at the clock."""

    def __init__(self, planner: LocalTrajectoryPlanner) -> None:
        self._planner = planner
        self.wall: list[float] = []  # sense and update [s]
        self.cpu: list[float] = []

    def __getattr__(self, name: str) -> Any:
        return getattr(self._planner, name)

    def sense(self, *scan: NDArray[np.float64]) -> None:
        self._begin = time.perf_counter(), time.thread_time()
        self._planner.sense(*scan)

    def update(self, position: NDArray[np.float64]) -> NavigationStatus:
        status = self._planner.update(position)
        self.wall.append(time.perf_counter() - self._begin[0])
        self.cpu.append(time.thread_time() - self._begin[1])
        return status


class TwoThreads:
    """The same for a planner beside the mission.

    The next scan comes when there is a plan that knows the last one, but after `patience` seconds
    at the latest.
    """

    def __init__(self, planner: ConcurrentTrajectoryPlanner, patience: float) -> None:
        self._planner = planner
        self._patience = patience
        self._decision = planner.decision
        self._stopped = False
        self._arrived: list[float] = []  # when each scan came
        self.wall: list[float] = []  # from a scan to the first plan that knows it [s]
        self.sensing: list[float] = []  # what a scan keeps the sensor's thread [s]
        planner.start()

    def __getattr__(self, name: str) -> Any:
        return getattr(self._decision, name)

    @property
    def map(self) -> ObstacleMap:
        return self._planner.map

    @property
    def events_count(self) -> int:
        return len(self._decision.events)

    @property
    def path(self) -> NDArray[np.float64]:
        return np.empty((0, 3)) if self._stopped else self._decision.path

    @property
    def path_id(self) -> tuple[int, bool]:
        return self._decision.path_id, self._stopped

    def sense(self, *scan: NDArray[np.float64]) -> None:
        self._arrived.append(time.perf_counter())
        self._planner.sense(*scan)
        self._take()
        self.sensing.append(time.perf_counter() - self._arrived[-1])

    def update(self, position: NDArray[np.float64]) -> NavigationStatus:
        self._planner.wait(self._patience)
        self._take()
        return self._decision.status

    def _take(self) -> None:
        """Take the newest decision; stop where the newest scan has blocked its path."""
        self._decision = self._planner.decision
        now = time.perf_counter()
        self.wall += [now - begin for begin in self._arrived[len(self.wall) : self._decision.scan]]
        self._stopped = self._planner.blocked_at is not None


def fly(world: World, index: int, make: Callable[[Mission], Any]) -> tuple[Any, FlightRecord]:
    """Fly path `index` over a world by a stand-in for the mission's planner, made from it."""
    path = make_scenario(world, ScenarioOptions(), index).global_path
    config = MissionConfig()
    config.lidar.pattern.azimuths, config.lidar.pattern.rows = 1024, 64
    mission = Mission(world, config, path)
    mission.planner = planner = make(mission)
    return planner, mission.fly()


def beside(patience: float) -> Callable[[Mission], TwoThreads]:
    def make(mission: Mission) -> TwoThreads:
        setup = mission.setup
        planner = ConcurrentTrajectoryPlanner(
            setup.priority,
            setup.global_path[0],
            planner=setup.config.planner,
            planner_options=setup.config.planner_options,
            map_options=setup.config.mapping,
            options=setup.config.navigation,
        )
        planner.set_waypoints(setup.waypoints)
        return TwoThreads(planner, patience)

    return make


def measure(world: World, flights: int) -> list[dict[str, Any]]:
    """The rows of one world. Stops if two threads decide otherwise than one, or hit something."""
    times: dict[str, list[float]] = {}
    for index in range(flights):
        one, alone = fly(world, index, lambda mission: OneThread(mission.planner))
        two, waiting = fly(world, index, beside(patience=60.0))
        if waiting.positions.tobytes() != alone.positions.tobytes():
            raise SystemExit(f"{world.name}, path {index}: two threads fly another way than one")
        hasty, overtaking = fly(world, index, beside(patience=0.0))
        if overtaking.outcome != alone.outcome:
            raise SystemExit(f"{world.name}, path {index}: {overtaking.outcome}")
        for name, seconds in {
            "one thread, scan to plan": one.wall,
            "one thread, scan to plan, CPU time": one.cpu,
            "two threads, scan to plan": two.wall,
            "two threads, the sensor's": two.sensing,
            "two threads, the sensor's, no scan waits": hasty.sensing,
        }.items():
            times.setdefault(name, []).extend(seconds)
    return [row(f"{world.name}: {name}", seconds) for name, seconds in times.items()]


def row(name: str, seconds: list[float]) -> dict[str, Any]:
    median, p99, p999, worst = 1e3 * np.quantile(seconds, [0.5, 0.99, 0.999, 1.0])
    return {
        "name": name,
        "median_ms": median,
        "p99_ms": p99,
        "p999_ms": p999,
        "worst_ms": worst,
        "scans": len(seconds),
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--world", type=Path, action="append", default=[], help="also over it")
    parser.add_argument("--flights", type=int, default=5, help="over each world")
    parser.add_argument("--out", type=Path, default=Path("build/bench/latency.json"))
    options = parser.parse_args()
    rows = []
    for world in (make_city(seed=1), *map(World.load, options.world)):
        for each in measure(world, options.flights):
            rows.append(each)
            print(
                "  ".join(
                    f"{value:.3f}" if isinstance(value, float) else f"{value}"
                    for value in each.values()
                )
            )
    options.out.parent.mkdir(parents=True, exist_ok=True)
    options.out.write_text(json.dumps({"rows": rows}, indent=2) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
