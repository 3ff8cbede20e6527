# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`QuerySet`: the questions that planners were asked in flight, kept to be asked again."""

import dataclasses
import hashlib
import json
import math
import operator
import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self

import numpy as np
from numpy.typing import NDArray

from ltp._core import GridFrame, OccupancyGrid, PlanRecord, PlanStatus, Query, Raster, Scene
from ltp.brief import brief
from ltp.config import MissionConfig
from ltp.files import atomic_write, blamed_on
from ltp.files.npz import NpzReader
from ltp.files.typed import typed
from ltp.sim import Mission, MissionSetup, Step
from ltp.world import World

from ..conditions import PRIORITY_MAPS
from ..scenarios import Scenario
from ..sensed import CellMap
from .points_only import refuse_gates

if TYPE_CHECKING:
    from ltp.sim.record import FlightRecord

#: How far a query may leave the altitudes of its ends, by name: (below, above) [m].
BANDS: Mapping[str, tuple[float, float]] = {"planar": (0.0, 0.0), "open": (math.inf, math.inf)}

_FORMAT = 1

# A window's cells, or a raster's. A thousand windows of 320 kB are a large set; their bits are
# packed 20 to 100 times, their headers 5 times (assumed to be less than four times that).
_MAX_CELLS = 20_000_000
_MAX_BYTES, _MAX_PACKING = 256 << 20, 400
_MAX_HEADER, _MAX_HEADER_PACKING = 1 << 20, 20


@dataclass(frozen=True, eq=False)
class RecordedQuery:
    """One question: the map as the planner saw it, from where to where."""

    scenario: int  # which of the global paths was flown; its priority maps are the set's
    time: float  # of the flight [s]
    waypoint: int  # that was flown to
    start: NDArray[np.float64]  # (3,) [m]
    goal: NDArray[np.float64]  # (3,): the waypoint, or a stop-over inside the window [m]
    band: tuple[float, float]  # as flown
    flown: float  # Eq. 5 of the plan that was flown; inf if there was none
    blocked: CellMap  # the window: every level that was sensed, also those outside the band

    __repr__ = brief

    @property
    def direct_length(self) -> float:
        """L_direct [m]."""
        return float(np.linalg.norm(self.goal - self.start))

    @property
    def grid(self) -> OccupancyGrid:
        """The blocked cells as planners take them."""
        columns = np.ascontiguousarray(self.blocked.columns, dtype="<u8")
        bits = np.unpackbits(columns.view(np.uint8), axis=2, bitorder="little")
        levels = self.blocked.frame.dims[2]
        return OccupancyGrid.from_array(bits[:, :, :levels].astype(np.bool_), self.blocked.frame)

    def query(self, band: tuple[float, float] | None = None) -> Query:
        """The question, in the band that was flown in or in another (below, above) [m]."""
        return Query(self.start, self.goal, self.band if band is None else band)

    def digest(self) -> str:
        """Of the question, and of when it was asked."""
        frame = self.blocked.frame
        facts = (self.scenario, self.time, self.waypoint, tuple(frame.dims))
        digest = hashlib.sha256(repr(facts).encode())
        for values in (frame.origin, frame.cell, self.start, self.goal, self.blocked.columns):
            digest.update(np.ascontiguousarray(values).data)
        return digest.hexdigest()


@dataclass(eq=False)
class QuerySet:
    """Queries of several flights over one world."""

    world: str  # its name
    attribution: str
    source: str  # digest of everything that the recording was made of
    queries: list[RecordedQuery]
    priorities: dict[int, dict[str, Raster]]  # of each scenario: by the name of the map

    def __repr__(self) -> str:
        flights = ", ".join(map(str, sorted(self.priorities)))
        return (
            f"QuerySet({len(self.queries)} queries over {self.world!r}, of global paths {flights})"
        )

    def scene(self, query: RecordedQuery, priority_map: str) -> Scene:
        """What a planner looked at, with either priority map."""
        return Scene(query.grid, self.priorities[query.scenario][priority_map])

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write one `.npz` file, all at once or not at all; equal priority maps are kept once."""
        kept: dict[bytes, int] = {}
        rasters: list[Raster] = []
        numbers: dict[int, dict[str, int]] = {}
        for scenario, maps in self.priorities.items():
            for name, raster in maps.items():
                content = hashlib.sha256(np.ascontiguousarray(raster.values).data).digest()
                index = kept.setdefault(content, len(kept))
                rasters += [raster] if index == len(rasters) else []
                numbers.setdefault(scenario, {})[name] = index
        header = {
            "format": _FORMAT,
            "world": self.world,
            "attribution": self.attribution,
            "source": self.source,
            "priorities": numbers,
            "rasters": [_raster_header(raster) for raster in rasters],
            "queries": [_query_header(query) for query in self.queries],
        }
        # Query by query: one array of all of them would be as large as all windows together.
        arrays: dict[str, Any] = {
            f"columns_{i}": query.blocked.columns for i, query in enumerate(self.queries)
        }
        arrays |= {f"raster_{i}": raster.values for i, raster in enumerate(rasters)}
        with atomic_write(path) as file:
            np.savez_compressed(
                file, header=np.frombuffer(json.dumps(header).encode(), np.uint8), **arrays
            )

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Self:
        """Read a set.

        Raises:
            OSError: if the file cannot be read.
            ValueError: that names the file and what is wrong with it.
        """
        with Path(path).open("rb") as file, blamed_on(path, "a set of recorded queries"):
            reader = NpzReader(file, _MAX_BYTES, _MAX_PACKING)
            header = reader.json("header", _MAX_HEADER, _MAX_HEADER_PACKING)
            if header["format"] != _FORMAT:
                raise ValueError("another version of the format")
            names = [f"raster_{i}" for i in range(len(header["rasters"]))]
            names += [f"columns_{i}" for i in range(len(header["queries"]))]
            reader.expect({"header", *names})
            rasters = [
                Raster(reader.array(f"raster_{i}", "<f8", (None, None), _MAX_CELLS), **values)
                for i, values in enumerate(header["rasters"])
            ]
            queries = [_query(reader, i, values) for i, values in enumerate(header["queries"])]
            for name in ("world", "attribution", "source"):
                if not isinstance(header[name], str):
                    raise ValueError(f"{name}: expected a text, not {header[name]!r:.80}")
            priorities = {
                int(scenario): {name: rasters[operator.index(i)] for name, i in maps.items()}
                for scenario, maps in header["priorities"].items()
            }
            for query in queries:
                if query.scenario not in priorities:
                    raise ValueError(f"no priority map of scenario {query.scenario}")
            return cls(
                header["world"], header["attribution"], header["source"], queries, priorities
            )


class QueryRecorder:
    """Observer that keeps each question with both ends inside the window and free."""

    def __init__(self, scenario: int) -> None:
        self.queries: list[RecordedQuery] = []
        self._scenario = scenario

    def on_start(self, setup: MissionSetup) -> None:
        """See `Observer`; `ValueError` for a flight through gates or with a horizon."""
        refuse_gates(setup.config)
        self._setup = setup

    def on_step(self, step: Step) -> None:
        """See `Observer`."""
        if not step.plans:
            return
        blocked = step.map.blocked
        cells = CellMap.of(blocked)
        for answer in step.plans:
            start, goal = step.position, _goal(self._setup.waypoints, answer)
            ends = np.stack([start, goal])
            if not all(map(blocked.frame.contains, ends)) or blocked.blocked_at(ends).any():
                continue
            self.queries.append(
                RecordedQuery(
                    scenario=self._scenario,
                    time=step.time,
                    waypoint=answer.waypoint,
                    start=start,
                    goal=goal,
                    band=self._setup.config.navigation.band_from(start[2], goal[2]),
                    flown=answer.plan.penalty,
                    blocked=cells,
                )
            )

    def on_end(self, record: "FlightRecord") -> None:
        """See `Observer`."""


def record_queries(
    world: World,
    scenarios: Sequence[Scenario],
    config: MissionConfig,
    count: int,
    source: str = "",
    on_flight: Callable[[int], None] = lambda done: None,
) -> QuerySet:
    """Fly the scenarios and keep what the planner was asked.

    Args:
        world: to fly over.
        scenarios: the global paths.
        config: planner, weights and map that are flown with.
        count: of queries to keep, spread evenly over the flights and along them; fewer, if fewer
            were asked.
        source: see `QuerySet`.
        on_flight: told how many flights are done.

    Raises:
        ValueError: for no queries, or a configuration with gates or a horizon; it is named.
    """
    refuse_gates(config)
    if count < 1:
        raise ValueError(f"the number of queries must be >= 1, not {count!r}")
    share = math.ceil(count / len(scenarios))
    queries: list[RecordedQuery] = []
    priorities = {}
    for done, scenario in enumerate(scenarios):
        recorder = QueryRecorder(scenario.index)
        missions = {
            name: Mission(
                world,
                dataclasses.replace(config, priority_map=name),
                scenario.global_path,
                [recorder],
            )
            for name in PRIORITY_MAPS
        }
        missions[config.priority_map].fly()
        queries += evenly(recorder.queries, share)
        priorities[scenario.index] = {
            name: flight.setup.priority for name, flight in missions.items()
        }
        on_flight(done + 1)
    return QuerySet(world.name, world.attribution, source, evenly(queries, count), priorities)


def evenly(items: Sequence[RecordedQuery], count: int) -> list[RecordedQuery]:
    """At most `count` of the items, evenly spread, the first and the last among them."""
    if len(items) <= count:
        return list(items)
    return [items[i] for i in np.linspace(0, len(items) - 1, count).round().astype(int)]


def _goal(waypoints: NDArray[np.float64], answer: PlanRecord) -> NDArray[np.float64]:
    """A waypoint beyond the window was replaced by a stop-over: the plan ends there."""
    if answer.plan.status == PlanStatus.FOUND:
        return np.array(answer.plan.path[-1])
    return np.array(waypoints[answer.waypoint])


def _raster_header(raster: Raster) -> dict[str, Any]:
    return {
        "origin": raster.origin.tolist(),
        "cell": raster.cell,
        "outside": raster.outside,
    }


def _query_header(query: RecordedQuery) -> dict[str, Any]:
    frame = query.blocked.frame
    return {
        "scenario": query.scenario,
        "time": query.time,
        "waypoint": query.waypoint,
        "start": query.start.tolist(),
        "goal": query.goal.tolist(),
        "band": query.band,
        "flown": query.flown,
        # The window lies on the lattice through the world's origin: whole cells from there.
        "first": np.round(frame.origin / frame.cell).astype(int).tolist(),
        "cell": frame.cell.tolist(),
        "dims": list(frame.dims),
    }


def _query(reader: NpzReader, number: int, values: dict[str, Any]) -> RecordedQuery:
    lattice = GridFrame((0.0, 0.0, 0.0), values.pop("cell"), values.pop("dims"))
    frame = lattice.shifted(values.pop("first"))
    nx, ny, levels = frame.dims
    words = -(-levels // 64)
    columns = reader.array(f"columns_{number}", "<u8", (nx, ny, words), _MAX_CELLS)
    if "way_point" in values:  # as older versions wrote it
        values["waypoint"] = values.pop("way_point")
    start, goal = (_finite_point(name, values.pop(name)) for name in ("start", "goal"))
    values = typed(RecordedQuery, values, without=("blocked", "start", "goal"))
    return RecordedQuery(start=start, goal=goal, blocked=CellMap(frame, columns), **values)


def _finite_point(name: str, values: Any) -> NDArray[np.float64]:
    point = np.array(values, dtype=np.float64)
    if point.shape != (3,) or not np.isfinite(point).all():
        raise ValueError(f"{name}: expected x, y, z in metres, not {values!r:.80}")
    return point
