# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`DropJudge`: which dropped waypoints the true world has a way to, by coarse and by fine cells."""

import numpy as np

from ltp.config import MissionConfig
from ltp.sim.record import FlightRecord, WaypointEntry
from ltp.world import World

from ..served import served_radius
from .fine_cells import FineCells
from .reachability import TrueCells


class DropJudge:
    """Judges the dropped waypoints of flights over one world, all with one map.

    Args:
        world: that is flown over.
        config: of the flights: their map's cells, the vehicle's radius (`mapping.inflation_radius`)
            and the altitude band.
    """

    def __init__(self, world: World, config: MissionConfig) -> None:
        self._world = world
        self._mapping = config.mapping
        self._coarse: TrueCells | None = None  # made when the first waypoint is dropped
        self._fine: FineCells | None = None

    def wrong_by_the_maps_cells(self, record: FlightRecord) -> list[WaypointEntry]:
        """The dropped waypoints to which the true world's own cells have a way.

        For each drop, a flood over the cells that the solid world itself blocks (the same lattice,
        inflation and altitude band as the mission's map, but the whole world instead of the window,
        and all of its surface instead of what was sensed) from where the UAV was. If it reaches the
        waypoint's cell, or a cell of its gate that was to be planned to (half a cell smaller than
        the gate), the map or the search dropped it wrongly.

        Raises:
            ValueError: if the map's window was not on the lattice of the cells.
        """
        if not record.dropped:
            return []
        self._coarse = self._coarse or TrueCells(self._world, self._mapping)
        for drop in record.dropped:
            if not self._coarse.on_lattice(drop.window_origin):
                raise ValueError(
                    f"window_origin {drop.window_origin} is not on the world's lattice"
                )
        bands = [_band_of(drop, record) for drop in record.dropped]
        half = 0.5 * float(np.hypot(*self._mapping.cell[:2]))
        return [
            drop
            for drop, (below, above) in zip(record.dropped, bands, strict=True)
            if self._coarse.reachable(
                drop.position,
                drop.goal,
                below=below,
                above=above,
                radius=max(0.0, _gate_radius(record, drop) - half),
            )
        ]

    def wrong_by_fine_cells(self, record: FlightRecord) -> list[WaypointEntry]:
        """The dropped waypoints to which the vehicle fits through the true world: see `FineCells`.

        Or into whose gate. What the map's cells are too coarse for counts here too.
        """
        if not record.dropped:
            return []
        self._fine = self._fine or FineCells(self._world, self._mapping.inflation_radius)
        return [
            drop
            for drop in record.dropped
            if self._fine.reachable(
                drop.position,
                drop.goal,
                above=_band_of(drop, record)[1],
                radius=_gate_radius(record, drop),
            )
        ]


def _band_of(drop: WaypointEntry, record: FlightRecord) -> tuple[float, float]:
    """(below, above): how far a way from the UAV to a waypoint could leave their altitudes [m]."""
    return record.config.navigation.band_from(drop.position[2], drop.goal[2])


def _gate_radius(record: FlightRecord, drop: WaypointEntry) -> float:
    """Of a waypoint's gate [m]; 0 where the gate is no wider than a point is served from."""
    return drop.gate_radius if drop.gate_radius > served_radius(record.config) else 0.0
