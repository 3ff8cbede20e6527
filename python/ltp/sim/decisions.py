# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`DecisionLog`: an observer that tells Python's logging what was decided in flight, and why."""

import logging

from ltp._core import PlanStatus
from ltp.sim.record import FlightRecord, fate_of
from ltp.sim.setup import MissionSetup
from ltp.sim.step import Step

_log = logging.getLogger(__name__)


class DecisionLog:
    """Logs waypoints reached and dropped, plans that found no path, changes of status, the end."""

    def __init__(self) -> None:
        self._status: object = None

    def on_start(self, setup: MissionSetup) -> None:
        """See `Observer`."""
        _log.info(
            "%s over %s: %d waypoints, at most %.0f s",
            setup.config.planner,
            setup.world.name,
            len(setup.waypoints),
            setup.time_limit,
        )

    def on_step(self, step: Step) -> None:
        """See `Observer`."""
        if not _log.isEnabledFor(logging.INFO):
            return
        for answer in step.plans:
            plan = answer.plan
            if plan.status != PlanStatus.FOUND:
                text = "%.1f s: no path to waypoint %d (%s, %d cells expanded)"
                name = plan.status.name.lower()
                _log.info(text, step.time, answer.waypoint, name, plan.stats.expanded)
        for event in step.events:
            why = "" if event.reached else f" ({event.why.name.lower()})"
            fate = f"{fate_of(event)}{why}"
            _log.info("%.1f s: waypoint %d %s", step.time, event.index, fate)
        if step.status != self._status:
            where = tuple(round(float(value), 1) for value in step.position)
            why = f": {step.reason.text}" if step.reason.text else ""
            _log.info("%.1f s: %s at %s%s", step.time, step.status.name.lower(), where, why)
            self._status = step.status

    def on_end(self, record: FlightRecord) -> None:
        """See `Observer`."""
        _log.info("%r", record)
