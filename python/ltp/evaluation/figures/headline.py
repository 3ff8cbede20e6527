# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The headline of a picture of flights: what happened, the bad first."""

from collections.abc import Sequence

from ltp._core import HeightSurface
from ltp.sim.record import FlightRecord, Outcome
from ltp.world import World

from ..contenders import Contender


def headline(world: World, records: Sequence[FlightRecord]) -> str:
    """What became of flights along one global path, in a sentence."""
    drops = [len(record.dropped) for record in records]
    count = len(records[0].global_path) - 1
    flown = (Outcome.REACHED, Outcome.NOTHING_REACHED)
    if min(drops) == count and all(record.outcome in flown for record in records):
        return "No waypoint could be reached"
    for outcome, what in _BAD.items():
        bad = [record for record in records if record.outcome is outcome]
        if not bad:
            continue
        if len(records) == 1:
            return f"The flight {what}{_where(bad[0])}"
        good = sum(record.outcome is Outcome.REACHED for record in records)
        rest = f"; {good} of {len(records)} fly to the end" if good else ""
        if len(bad) == 1:
            return f"{record_title(bad[0])} {what}{_where(bad[0])}{rest}"
        return f"{len(bad)} of {len(records)} flights: each {what}{rest}"
    crosses = HeightSurface(world.surface_raster()).first_collision(records[0].global_path)
    way = "Flown to the end" if crosses is None else "Round the buildings on the global path"
    most = f"{'up to ' * (min(drops) < max(drops))}{max(drops)} of {count}"
    far = [len(record.skipped) for record in records]
    return (
        way
        + (f"; {most} waypoints out of reach" if max(drops) else "")
        + (f"; {'up to ' * (min(far) < max(far))}{max(far)} too far" if max(far) else "")
    )


def record_title(record: FlightRecord) -> str:
    """Who flew, for labels."""
    options = record.config.planner_options
    return Contender.of(record.config.planner, options.refine).title


def worth(record: FlightRecord) -> str:
    """What a flight was worth, for labels; of one that did not come to its end, how it ended."""
    if record.outcome is not Outcome.REACHED:
        return record.outcome.value.replace("_", " ")
    return f"P = {record.mean_priority:.2f},  L/L_GP = {record.length_ratio:.2f}"


def _where(record: FlightRecord) -> str:
    if record.outcome is Outcome.COLLIDED:
        return f" after {record.length:.0f} m, {record.duration:.0f} s"
    return f", {record.length:.0f} m flown in {record.duration:.0f} s"


#: What is bad, the worst first, and how it is said.
_BAD = {
    Outcome.COLLIDED: "hits an obstacle",
    Outcome.TIMED_OUT: "runs out of time",
    Outcome.NOTHING_REACHED: "reaches no waypoint",
}
