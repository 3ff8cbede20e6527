# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A campaign: every variant over every scenario of one world, in parallel, resumable, repeatable.

The folder of a campaign holds `journal.jsonl`, one line a finished flight in the order in which
they finished; `flights.csv`, the same rows in a fixed order, written at the end; `campaign.json`,
what they were flown for; and, if wanted, `records/`, one `FlightRecord` a flight. The same campaign
gives the same bytes of `flights.csv` on any number of processes, but for the columns that begin
with `time_`. Another campaign of the same world, settings and global paths adds its rows; any other
is refused: see `folder`. Another build of the program flies anew: see `digests`.
"""

import contextlib
import logging
import os
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from ltp._core import Raster
from ltp.brief import brief
from ltp.config import MissionConfig
from ltp.world import World

from ..digests import world_digest
from ..journal import RowJournal
from ..scenarios import Scenario
from .flights import Flight, flight_key, mission_config, record_path
from .folder import open_folder
from .rows import FLIGHTS, FlightRow, write_rows
from .variants import Variant, unique
from .workers import Crew, ProcessCrew, SoloCrew

_log = logging.getLogger(__name__)

JOURNAL = "journal.jsonl"
TABLE = "flights.csv"
RECORDS = "records"


class FlightJournal(RowJournal[FlightRow]):
    """Of a campaign's flights."""

    def __init__(self, path: str | os.PathLike[str]) -> None:
        super().__init__(path, FLIGHTS, "campaign", "fly flight")


class CampaignObserver(Protocol):
    """Is told how a campaign goes: a progress bar, a log."""

    def on_start(self, total: int, done: int) -> None:
        """`total` flights in all, of which an earlier run left `done`."""
        ...

    def on_flight(self, row: FlightRow) -> None:
        """A flight is finished and kept."""
        ...

    def on_end(self) -> None:
        """The campaign ended, or was interrupted."""
        ...


@dataclass(frozen=True)
class Campaign:
    """What to fly. `variants` and `scenarios` give the order of the rows."""

    world: World
    variants: Sequence[Variant]
    scenarios: Sequence[Scenario]
    base: MissionConfig  # the variants are put into it
    priority: Raster | None = None  # the map to fly with, if it is not that of the world

    __repr__ = brief

    def flights(self) -> list[Flight]:
        """Every flight once, variant by variant."""
        digest = world_digest(self.world)
        return [
            Flight(
                flight_key(digest, mission_config(self.base, variant), scenario, self.priority),
                variant,
                scenario,
            )
            for variant in unique(self.variants)
            for scenario in self.scenarios
        ]


def run_campaign(
    campaign: Campaign,
    folder: str | os.PathLike[str],
    *,
    processes: int = 1,
    keep_records: bool = False,
    observers: Iterable[CampaignObserver] = (),
    crew: Crew | None = None,
) -> list[FlightRow]:
    """Fly what is not in the folder's journal yet; return the campaign's rows in a fixed order.

    The folder's table holds them too, beside those of earlier campaigns in this folder.

    Args:
        campaign: what to fly.
        folder: of this campaign; made if it is not there. What was flown in it is gone on with.
        processes: to fly in; 1 flies in this one.
        keep_records: also keep each flight's record. A flight that has a row but no record is flown
            again for it; its row stays as it is.
        observers: are told how it goes.
        crew: flies instead of `processes` processes.

    Raises:
        KeyboardInterrupt: after Ctrl-C, when all that was flown is in the journal and in the CSV.
        RuntimeError: if another campaign writes in this folder, or a process was killed.
        ValueError: if `processes` is below 1, the journal is damaged, or the folder holds flights
            of another world, of other settings or along other global paths.
    """
    if processes < 1:
        raise ValueError(f"processes must be >= 1, not {processes!r}")
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    records = folder / RECORDS if keep_records else None
    if records is not None:
        records.mkdir(exist_ok=True)
    observers = list(observers)
    flights = campaign.flights()
    with FlightJournal(folder / JOURNAL) as journal:
        held = open_folder(folder, TABLE, campaign.world, campaign.base, flights, campaign.priority)
        # Scenario by scenario: slow and fast planners take turns, which steadies the time left.
        waiting = [flight for flight in flights if not _kept(flight, journal, records)]
        waiting.sort(key=lambda flight: flight.scenario.index)
        crew = crew or _crew(campaign, records, min(processes, len(waiting)))
        _log.info(
            "%s: %d flights to fly, %d flown before, in %d processes",
            folder,
            len(waiting),
            len(flights) - len(waiting),
            processes,
        )
        for observer in observers:
            observer.on_start(len(flights), len(flights) - len(waiting))
        try:
            with contextlib.closing(crew.fly(waiting)) as finished:
                for row in finished:
                    if row.key not in journal.rows:
                        journal.append(row)
                    for observer in observers:
                        observer.on_flight(row)
        finally:
            write_rows(
                folder / TABLE, [journal.rows[key] for key in held.flights if key in journal.rows]
            )
            for observer in observers:
                observer.on_end()
    return [journal.rows[flight.key] for flight in flights]


def _kept(flight: Flight, journal: FlightJournal, records: Path | None) -> bool:
    return flight.key in journal.rows and (
        records is None or record_path(records, flight.key).exists()
    )


def _crew(campaign: Campaign, records: Path | None, processes: int) -> Crew:
    if processes > 1:
        return ProcessCrew(campaign.world, campaign.base, records, processes, campaign.priority)
    return SoloCrew(campaign.world, campaign.base, records, campaign.priority)
