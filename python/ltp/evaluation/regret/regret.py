# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The flights of a campaign's folder against the best routes over known ground; resumable.

Beside what the campaign keeps, its records too, the folder then holds `regret.jsonl`, one line a
flight as it was judged, and `regret.csv`, the rows of the last command in a fixed order.
"""

import logging
import os
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Protocol

from ltp._core import Raster
from ltp.sim.record import FlightRecord
from ltp.world import World

from ..campaign.campaign import RECORDS
from ..campaign.flights import record_path
from ..campaign.rows import FlightRow
from ..digests import row_key
from ..journal import RowJournal
from .judge import RegretJudge, check_gate
from .rows import REGRETS, RegretRow

_log = logging.getLogger(__name__)

JOURNAL = "regret.jsonl"
TABLE = "regret.csv"


class RegretObserver(Protocol):
    """Is told how the judging goes."""

    def on_start(self, total: int, done: int) -> None:
        """`total` flights in all, of which an earlier run judged `done`."""
        ...

    def on_regret(self, row: RegretRow) -> None:
        """A flight is judged and kept."""
        ...

    def on_end(self) -> None:
        """All is done, or was interrupted."""
        ...


def run_regret(
    world: World,
    flights: Sequence[FlightRow],
    folder: str | os.PathLike[str],
    *,
    gate: float | None = None,
    priority: Raster | None = None,
    observers: Iterable[RegretObserver] = (),
) -> list[RegretRow]:
    """Judge the flights that are not in the folder's journal yet; return and write all rows.

    Args:
        world: that was flown over.
        flights: of a campaign that kept its records in this folder, with the same `priority`.
        folder: of that campaign.
        gate: see `RegretJudge` [m].
        priority: the map that was flown with, if it is not that of the world.
        observers: are told how it goes.

    Raises:
        KeyboardInterrupt: after Ctrl-C, when all that was judged is in the journal and the CSV.
        OSError: if a flight has no record.
        RuntimeError: if another command judges in this folder.
        ValueError: if the gate is negative or the journal is damaged.
    """
    check_gate(gate)
    folder, observers = Path(folder), list(observers)
    keys = [row_key({"flight": flight.key, "gate": gate}) for flight in flights]
    judge = RegretJudge(world, gate, priority)
    with RowJournal(folder / JOURNAL, REGRETS, "regret", "judge flight") as journal:
        done = sum(key in journal.rows for key in keys)
        _log.info("%s: %d flights to judge, %d judged before", folder, len(keys) - done, done)
        for observer in observers:
            observer.on_start(len(keys), done)
        try:
            for flight, key in zip(flights, keys, strict=True):
                if key in journal.rows:
                    continue
                record = FlightRecord.load(record_path(folder / RECORDS, flight.key))
                row = judge.row(flight, record, key)
                journal.append(row)
                for observer in observers:
                    observer.on_regret(row)
        finally:
            rows = [journal.rows[key] for key in keys if key in journal.rows]
            REGRETS.write(folder / TABLE, rows)
            for observer in observers:
                observer.on_end()
    return rows
