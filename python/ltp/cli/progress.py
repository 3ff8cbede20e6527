# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Progress on the terminal, as observers of a flight and of a campaign."""

from types import TracebackType
from typing import TYPE_CHECKING

from rich.console import Console
from rich.progress import (
    BarColumn,
    MofNCompleteColumn,
    Progress,
    TextColumn,
    TimeElapsedColumn,
    TimeRemainingColumn,
)

if TYPE_CHECKING:
    from ltp.evaluation.campaign.rows import FlightRow
    from ltp.evaluation.gap.rows import GapRow
    from ltp.evaluation.regret.rows import RegretRow
    from ltp.sim import FlightRecord, MissionSetup, Step


class _CountedProgress:
    """A bar over things that are counted, with the time left."""

    def __init__(self, console: Console, what: str, made: str) -> None:
        self._console = console
        self._before = f"{what} were {made} before; going on"
        self._bar = Progress(
            TextColumn(what),
            BarColumn(bar_width=None),
            MofNCompleteColumn(),
            TextColumn("{task.fields[note]}"),
            TimeElapsedColumn(),
            TextColumn("left"),
            TimeRemainingColumn(),
            console=console,
        )
        self._task = self._bar.add_task(what, total=None, note="")

    def on_start(self, total: int, done: int) -> None:
        """See `CampaignObserver`, `GapObserver`, `RegretObserver`."""
        if done:
            self._console.print(f"{done} of {total} {self._before}")
        self._bar.start()
        # What an earlier run did must not make this one look fast.
        self._bar.reset(self._task, total=total - done, visible=total > done)

    def on_end(self) -> None:
        """See `CampaignObserver`, `GapObserver`, `RegretObserver`."""
        self._bar.stop()

    def _advance(self, note: str) -> None:
        self._bar.update(self._task, advance=1, note=note)


class CampaignProgress(_CountedProgress):
    """A bar over the flights of a campaign."""

    def __init__(self, console: Console) -> None:
        super().__init__(console, "flights", "flown")
        self._collisions = 0
        self._wrong = 0

    def on_flight(self, row: "FlightRow") -> None:
        """See `CampaignObserver`."""
        self._collisions += row.collided
        self._wrong += row.wrongly_dropped
        note = "" if not self._collisions else f"{self._collisions} collided"
        note += "" if not self._wrong else f" {self._wrong} wrongly dropped"
        self._advance(note)


class GapProgress(_CountedProgress):
    """A bar over the plans of a comparison."""

    def __init__(self, console: Console) -> None:
        super().__init__(console, "plans", "made")

    def on_plan(self, row: "GapRow") -> None:
        """See `GapObserver`."""
        self._advance(f"{row.planner}, {row.priority_map}, {row.band}, {row.ratio:g}")


class RegretProgress(_CountedProgress):
    """A bar over the flights that are held against the best routes."""

    def __init__(self, console: Console) -> None:
        super().__init__(console, "regrets", "judged")

    def on_regret(self, row: "RegretRow") -> None:
        """See `RegretObserver`."""
        self._advance(f"{row.planner}, {row.priority_map}")


class FlightProgress:
    """A bar along one flight's waypoints."""

    def __init__(self, console: Console, title: str) -> None:
        self._title = title
        self._bar = Progress(
            TextColumn("{task.description}"),
            BarColumn(bar_width=None),
            TextColumn("{task.fields[note]}"),
            TimeElapsedColumn(),
            console=console,
        )
        self._task = self._bar.add_task(title, total=None, note="")
        self._plans = 0

    def __enter__(self) -> "FlightProgress":
        self._bar.start()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._bar.stop()

    def on_start(self, setup: "MissionSetup") -> None:
        """See `Observer`."""
        self._bar.update(self._task, total=len(setup.waypoints))

    def on_step(self, step: "Step") -> None:
        """See `Observer`."""
        self._plans += len(step.plans)
        note = f"{step.time:.0f} s, {self._plans} plans"
        self._bar.update(self._task, completed=step.waypoint_index, note=note)

    def on_end(self, record: "FlightRecord") -> None:
        """See `Observer`."""
        note = f"{record.outcome.value} after {record.duration:.0f} s"
        self._bar.update(self._task, completed=len(record.global_path) - 1, note=note)
