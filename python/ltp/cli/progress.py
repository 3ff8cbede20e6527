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
    from ltp.evaluation.gap import GapRow
    from ltp.evaluation.rows import FlightRow
    from ltp.sim.mission import Mission
    from ltp.sim.record import FlightRecord


def counting_bar(console: Console, what: str) -> Progress:
    """A bar over things that are counted, with the time left."""
    return Progress(
        TextColumn(what),
        BarColumn(bar_width=None),
        MofNCompleteColumn(),
        TextColumn("{task.fields[note]}"),
        TimeElapsedColumn(),
        TextColumn("left"),
        TimeRemainingColumn(),
        console=console,
    )


class CampaignProgress:
    """A bar over the flights of a campaign."""

    def __init__(self, console: Console) -> None:
        self._console = console
        self._bar = counting_bar(console, "flights")
        self._task = self._bar.add_task("flights", total=None, note="")
        self._collisions = 0
        self._wrong = 0

    def on_start(self, total: int, done: int) -> None:
        """See `CampaignObserver`."""
        if done:
            self._console.print(f"{done} of {total} flights were flown before; going on")
        self._bar.start()
        # The flights of an earlier run must not make this one look fast.
        self._bar.reset(self._task, total=total - done, visible=total > done)

    def on_flight(self, row: "FlightRow") -> None:
        """See `CampaignObserver`."""
        self._collisions += row.collided
        self._wrong += row.wrongly_dropped
        note = "" if not self._collisions else f"{self._collisions} collided"
        note += "" if not self._wrong else f" {self._wrong} wrongly dropped"
        self._bar.update(self._task, advance=1, note=note)

    def on_end(self) -> None:
        """See `CampaignObserver`."""
        self._bar.stop()


class GapProgress:
    """A bar over the plans of a comparison."""

    def __init__(self, console: Console) -> None:
        self._console = console
        self._bar = counting_bar(console, "plans")
        self._task = self._bar.add_task("plans", total=None, note="")

    def on_start(self, total: int, done: int) -> None:
        """See `GapObserver`."""
        if done:
            self._console.print(f"{done} of {total} plans were made before; going on")
        self._bar.start()
        self._bar.reset(self._task, total=total - done, visible=total > done)

    def on_plan(self, row: "GapRow") -> None:
        """See `GapObserver`."""
        note = f"{row.planner}, {row.priority_map}, {row.band}, {row.ratio:g}"
        self._bar.update(self._task, advance=1, note=note)

    def on_end(self) -> None:
        """See `GapObserver`."""
        self._bar.stop()


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

    def on_start(self, mission: "Mission") -> None:
        """See `Observer`."""
        self._bar.update(self._task, total=len(mission.global_path) - 1)

    def on_step(self, mission: "Mission") -> None:
        """See `Observer`."""
        note = f"{mission.time:.0f} s, {mission.planner.plans_made} plans"
        self._bar.update(self._task, completed=mission.planner.waypoint_index, note=note)

    def on_end(self, mission: "Mission", record: "FlightRecord") -> None:
        """See `Observer`."""
        note = f"{record.outcome.value} after {record.duration:.0f} s"
        self._bar.update(self._task, completed=len(mission.global_path) - 1, note=note)
