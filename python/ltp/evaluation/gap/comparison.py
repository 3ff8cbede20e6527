# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every planner on every recorded query, held against the exact optimum of Eq. 5; resumable.

The folder holds `journal.jsonl`, one line a plan as it was made, and `gap.csv`, the rows of the
last command in a fixed order, each with the optimum of its query.
"""

import dataclasses
import hashlib
import os
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from ltp._core import Budget, ExactOptions, LinearisedOptions, Planner, PlanStatus, Scene

from ..conditions import PRIORITY_MAPS
from ..contenders import OPTIMUM, Contender
from ..digests import row_key
from ..journal import RowJournal
from .cases import Case, GapOptions
from .queries import BANDS, QuerySet
from .rows import PLANS, GapRow, with_optimum

JOURNAL = "journal.jsonl"
TABLE = "gap.csv"


class GapObserver(Protocol):
    """Is told how the comparison goes."""

    def on_start(self, total: int, done: int) -> None:
        """`total` plans in all, of which an earlier run left `done`."""
        ...

    def on_plan(self, row: GapRow) -> None:
        """A plan is made and kept."""
        ...

    def on_end(self) -> None:
        """All is done, or was interrupted."""
        ...


def run_gap(
    queries: QuerySet,
    options: GapOptions,
    folder: str | os.PathLike[str],
    observers: Iterable[GapObserver] = (),
) -> list[GapRow]:
    """Make the plans that are not in the folder's journal yet; return and write all rows.

    Planner after planner, in this process, one plan at a time: the times are those of a planner
    with a core to itself. One planner answers all queries of a case, in the order of the flights:
    what it remembers of the last plan serves it here as it does in the air.

    Args:
        queries: recorded in flight.
        options: planners, weights, maps, bands.
        folder: where it is kept; made if it is not there.
        observers: are told how it goes.

    Raises:
        KeyboardInterrupt: after Ctrl-C, when all that was planned is in the journal and the CSV.
        RuntimeError: if another comparison writes in this folder.
        ValueError: if the journal is damaged, or the set holds no queries.
    """
    if not queries.queries:
        raise ValueError("no queries were recorded: fly more or longer paths")
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    observers = list(observers)
    digests = _digests(queries)
    series = [
        _Series(queries, digests[case.priority_map], options, case, contender)
        for case in options.cases()
        for contender in (None, *options.contenders())
    ]
    with RowJournal(folder / JOURNAL, PLANS, "gap", "make plan") as journal:
        keys = [key for one in series for key in one.keys]
        for observer in observers:
            observer.on_start(len(keys), sum(key in journal.rows for key in keys))
        try:
            for one in series:
                for row in one.plan(journal.rows.keys()):
                    journal.append(row)
                    for observer in observers:
                        observer.on_plan(row)
        finally:
            rows = with_optimum([journal.rows[key] for key in keys if key in journal.rows])
            PLANS.write(folder / TABLE, rows)
            for observer in observers:
                observer.on_end()
    return rows


def _digests(queries: QuerySet) -> dict[str, list[str]]:
    """By map: a digest of each query with its priority map."""
    maps = {
        (scenario, name): hashlib.sha256(np.ascontiguousarray(raster.values).data).hexdigest()
        for scenario, rasters in queries.priorities.items()
        for name, raster in rasters.items()
    }
    own = [query.digest() for query in queries.queries]
    return {
        name: [
            digest + maps[query.scenario, name]
            for digest, query in zip(own, queries.queries, strict=True)
        ]
        for name in PRIORITY_MAPS
    }


class _Series:
    """One contender, or with None the reference, through all queries under one case."""

    def __init__(
        self,
        queries: QuerySet,
        digests: Sequence[str],
        options: GapOptions,
        case: Case,
        contender: Contender | None,
    ) -> None:
        self._queries = queries
        self._case = case
        self._contender = contender or Contender(options.reference)
        self._name = contender.name if contender else OPTIMUM
        self._options: dict[str, Any] = {}
        self._budget = Budget()
        if contender is None:
            self._budget = Budget(max_expansions=options.expansions)
            if options.reference == "exact":
                self._options["exact"] = ExactOptions(memory=options.memory)
            if options.reference == "sweep":  # not content with less than can be proved
                self._options["linearised"] = LinearisedOptions(tolerance=0.0, searches=100)
        self.keys = [self._key(digest) for digest in digests]

    def plan(self, kept: Iterable[str]) -> Iterable[GapRow]:
        """Make the rows that are not kept yet."""
        known = set(kept)
        waiting = [i for i, key in enumerate(self.keys) if key not in known]
        if not waiting:
            return
        planner = self._contender.make(self._case.ratio, **self._options)
        if self._name != OPTIMUM:
            self._answer(planner, waiting[0])  # a planner in flight has its memory already
        for index in waiting:
            yield self._answer(planner, index)

    def _answer(self, planner: Planner, index: int) -> GapRow:
        query = self._queries.queries[index]
        scene: Scene = self._queries.scene(query, self._case.priority_map)
        plan = planner.plan(scene, query.query(BANDS[self._case.band]), self._budget)
        found = plan.status == PlanStatus.FOUND
        judged, bound = self._contender.judge(plan, query.direct_length, self._case.ratio)
        return GapRow(
            key=self.keys[index],
            world=self._queries.world,
            query=index,
            scenario=query.scenario,
            priority_map=self._case.priority_map,
            band=self._case.band,
            ratio=self._case.ratio,
            planner=self._name,
            status=plan.status.name.lower(),
            penalty=judged if found else None,
            length=plan.tally.length if found else None,
            mean_priority=plan.tally.mean_priority if found else None,
            direct_length=query.direct_length,
            bound=bound,
            expanded=plan.stats.expanded,
            time_plan=1e3 * plan.stats.seconds,
        )

    def _key(self, digest: str) -> str:
        return row_key(
            {
                "query": digest,
                "case": dataclasses.astuple(self._case),
                "planner": [self._name, self._contender.name],
                "options": {name: repr(value) for name, value in self._options.items()},
                "budget": repr(self._budget),
            }
        )
