# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`Standing`: how a flight would end if it ended now, and why."""

from collections.abc import Sequence
from dataclasses import dataclass

from ltp._core import NavigationReason, NavigationStatus
from ltp.sim.record import Outcome, WaypointEntry
from ltp.sim.setup import MissionSetup
from ltp.sim.step import Step

_ALL_DROPPED = NavigationReason.ALL_DROPPED.text


@dataclass(frozen=True, eq=False)
class Standing:
    """What has come of a flight by now."""

    setup: MissionSetup
    step: Step | None  # the last one
    held: float  # for how long there has been no path [s]
    fates: Sequence[WaypointEntry]  # waypoints reached and dropped

    @property
    def outcome(self) -> Outcome:
        """`STOPPED` while the flight is under way."""
        step = self.step
        if step is None:
            return Outcome.STOPPED
        if step.collision is not None:
            return Outcome.COLLIDED
        if step.status == NavigationStatus.FINISHED and self.fates:
            return Outcome.REACHED if self._reached else Outcome.NOTHING_REACHED
        if step.time >= self.setup.time_limit or self._held_too_long:
            return Outcome.TIMED_OUT
        return Outcome.STOPPED

    @property
    def reason(self) -> str:
        """Why it ends so, a sentence without its full stop."""
        outcome = self.outcome
        if outcome is Outcome.COLLIDED:
            return "the true world was touched"
        if outcome is Outcome.NOTHING_REACHED:
            too_far = self._count("skipped")
            return f"no waypoint was reached: {self._others}" if too_far else _ALL_DROPPED
        if outcome is Outcome.REACHED:
            if self._reached == len(self.fates):
                return "every waypoint was reached"
            of = f"{self._reached} of {len(self.fates)}"
            return f"{of} waypoints were reached, {self._others}"
        if self.step is None or outcome is Outcome.STOPPED:
            return "it was stopped on its way"
        if self.step.status == NavigationStatus.HOLDING:
            since = f" for {self.held:.0f} s" if self._held_too_long else ""
            return f"held{since}: {self.step.reason.text}"
        return f"no more time: the limit of {self.setup.time_limit:.0f} s is over"

    @property
    def _reached(self) -> int:
        return self._count("reached")

    @property
    def _others(self) -> str:
        """What became of those that were not reached: a proof is told from a limit."""
        dropped, too_far = self._count("dropped"), self._count("skipped")
        if not too_far:
            return "the others dropped"
        return f"{dropped} dropped, {too_far} too far" if dropped else "the others too far"

    def _count(self, fate: str) -> int:
        return sum(entry.outcome == fate for entry in self.fates)

    @property
    def _held_too_long(self) -> bool:
        return self.held >= self.setup.config.hold_limit
