# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""One flight of a campaign: what decides it, flying it, and its row."""

import dataclasses
import time
from dataclasses import dataclass
from pathlib import Path

from ltp._core import Raster
from ltp.config import MissionConfig
from ltp.sim.mission import fly
from ltp.world import World

from ..digests import raster_digest, row_key
from ..scenarios import Scenario
from .drops import DropJudge
from .metrics import flight_row
from .rows import FlightRow
from .variants import Variant


@dataclass(frozen=True)
class Flight:
    """A flight to be flown."""

    key: str
    variant: Variant
    scenario: Scenario


def mission_config(base: MissionConfig, variant: Variant) -> MissionConfig:
    """The base configuration with the variant's planner, weights, map and refinement."""
    config = dataclasses.replace(base, planner=variant.planner, priority_map=variant.priority_map)
    config.planner_options.weights = variant.weights.of_core
    config.planner_options.refine = variant.refine
    config.check()
    return config


def flight_key(
    digest: str, config: MissionConfig, scenario: Scenario, priority: Raster | None = None
) -> str:
    """A digest of everything that decides a flight: program, world, configuration, global path.

    Args:
        digest: of the world, see `digests.world_digest`.
        config: of this flight.
        scenario: its global path; the index and the seed of the set count too, as they are in the
            row.
        priority: the map that it is given, if it is not that of the world.
    """
    facts = {
        "world": digest,
        "config": config.to_dict(),
        "scenario": [scenario.index, scenario.seed],
        "global_path": scenario.global_path.tolist(),
    }
    if priority is not None:
        facts["priority"] = raster_digest(priority)
    return row_key(facts)


def record_path(folder: Path, key: str) -> Path:
    """Where the record of a flight is kept."""
    return folder / f"{key}.npz"


class Pilot:
    """Flies flights over one world; keeps what they share: the judge of drops.

    Args:
        world: where.
        base: the configuration that the variants are put into.
        records: folder for one `FlightRecord` file a flight, named by its key; None keeps none.
        priority: the map to fly with, if it is not that of the world.
    """

    def __init__(
        self,
        world: World,
        base: MissionConfig,
        records: Path | None = None,
        priority: Raster | None = None,
    ) -> None:
        self._world = world
        self._base = base
        self._records = records
        self._priority = priority
        self._judge = DropJudge(world, base)

    def fly(self, flight: Flight) -> FlightRow:
        """Fly one flight; its record is on the disk before its row is returned."""
        config = mission_config(self._base, flight.variant)
        begin = time.perf_counter()
        record = fly(self._world, config, flight.scenario.global_path, priority=self._priority)
        seconds = time.perf_counter() - begin
        if self._records is not None:
            record.save(record_path(self._records, flight.key))
        return flight_row(record, flight.scenario, flight.key, seconds, self._judge)
