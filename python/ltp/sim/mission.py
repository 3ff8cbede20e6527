# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`Mission`: a flight with a global path, flown until it is used up; `fly`."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from numpy.typing import ArrayLike

from ltp._core import Raster, Surface
from ltp.config import MissionConfig
from ltp.sim.flight import Flight
from ltp.sim.observer import Observer
from ltp.sim.record import FlightRecord
from ltp.sim.sensors import Sensor
from ltp.sim.setup import MissionSetup
from ltp.world import World


class Mission(Flight):
    """One UAV, one world, one global path."""

    def __init__(
        self,
        world: World | Surface,
        config: MissionConfig,
        global_path: ArrayLike,
        observers: Sequence[Observer] = (),
        priority: Raster | None = None,
        *,
        sensors: Sequence[Sensor] | None = None,
        known_map: Path | str | None = None,
    ) -> None:
        super().__init__(
            world,
            config,
            global_path,
            sensors=sensors,
            priority=priority,
            known_map=known_map,
            observers=observers,
        )

    def _set_up(self, *arguments: Any) -> MissionSetup:
        return MissionSetup.of(*arguments)

    def fly(self) -> FlightRecord:
        """Fly until the waypoints are used up, the time is over, or something is hit.

        A mission begun by hand is flown to its end; one that has ended is flown anew.
        """
        if self._ended:
            self.reset()
        self.run()
        return self.end()


def fly(
    world: World | Surface,
    config: MissionConfig,
    global_path: ArrayLike,
    observers: Sequence[Observer] = (),
    priority: Raster | None = None,
    *,
    known_map: Path | str | None = None,
) -> FlightRecord:
    """Fly a mission over a world.

    Args:
        world: what is really there; the UAV learns of it through its LiDAR only. A `World`, or any
            `Surface`: an octree, a window in a wall, wires.
        config: planner, weights, sensor, map, vehicle.
        global_path: (n, 3), n >= 2, world [m]; the UAV starts at its first point, the others are
            its waypoints. It may lead through buildings.
        observers: told of every step, in order.
        priority: a priority map in [0, 1] to fly with instead of that of the world and the
            configuration; `priority_map` "lpf" averages it over the camera's footprint.
            Over a bare surface the priority is 0 unless one is given.
        known_map: an OctoMap file, `.bt` or `.ot`, of what was seen before, in world coordinates
            and voxels of the map's size: begin with that. `ObstacleMap.save` writes one.

    Returns:
        The record of the flight; the same for the same arguments, but for wall times.

    Raises:
        ValueError: for a configuration, a map or a global path that cannot be flown; it is named.
            So is the least altitude that works, for a start too low above the ground.
    """
    return Mission(world, config, global_path, observers, priority, known_map=known_map).fly()
