# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every planner on every recorded query, held against the exact optimum of Eq. 5; resumable.

The folder holds `journal.jsonl`, one line a plan as it was made, and `gap.csv`, the rows of the
last command in a fixed order, each with the optimum of its query.
"""

import dataclasses
import functools
import hashlib
import itertools
import json
import math
import os
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from ltp import _core
from ltp._core import LinearisedOptions, ParetoOptions, Plan, Planner, PlanStatus, Scene, penalty
from ltp.planners import PLANNERS, make_planner

from .journal import RowJournal
from .queries import BANDS, QuerySet
from .row_table import RowTable
from .variants import PRIORITY_MAPS, REFINE, at_ratio

JOURNAL = "journal.jsonl"
TABLE = "gap.csv"

#: The contender that knows lengths only: LP-Dijkstra with W_P = 0, judged by the weights at hand.
SHORTEST = "shortest"
BASELINE = "lp-dijkstra"
#: In the column `planner`: the reference planner, given the time that it needs.
OPTIMUM = "optimum"

PROVED = 1e-6  # of Eq. 5: an answer so close to its own bound is the optimum
_OFF_GRID = ("bezier", "bug", "hermite")  # their paths need not follow the grid's steps
_KEY_LENGTH = 20


@dataclass(frozen=True, kw_only=True)
class GapRow:
    """One plan for one query. None is an empty field."""

    key: str  # of everything that decides the plan
    world: str
    query: int  # its place in the set
    scenario: int
    priority_map: str
    band: str  # see `queries.BANDS`
    ratio: float  # W_P / W_L
    planner: str  # see `Contender`, or `OPTIMUM`
    status: str  # of `ltp.PlanStatus`, in lower case
    penalty: float | None  # Eq. 5
    length: float | None  # L [m]
    mean_priority: float | None  # of the path, -Eq. 4
    direct_length: float  # L_direct [m]
    bound: float | None  # the planner's certificate: no grid path has a smaller penalty
    expanded: int  # cells
    time_plan: float  # wall time of the search [ms]
    optimum: float | None = None  # of the query; the best known where it is not proved
    optimum_bound: float | None = None  # within `PROVED` of `optimum` where it is proved
    gap: float | None = None  # penalty - optimum

    @property
    def case(self) -> "Case":
        """What it was planned under."""
        return Case(self.priority_map, self.band, self.ratio)

    @property
    def proved(self) -> bool:
        """Whether `optimum` is known to be the optimum."""
        known = self.optimum is not None and self.optimum_bound is not None
        return known and self.optimum - self.optimum_bound <= PROVED  # type: ignore[operator]


PLANS = RowTable(GapRow, "a table of gaps")
read_gaps = PLANS.read


@dataclass(frozen=True)
class Case:
    """What all planners of one table share."""

    priority_map: str
    band: str
    ratio: float  # W_P / W_L


@dataclass(frozen=True)
class Contender:
    """A planner as the command line names it: a planner's name, the same with `+refine`, or
    `shortest`.
    """

    name: str

    def __post_init__(self) -> None:
        if self.name != SHORTEST and self.planner not in PLANNERS:
            known = ", ".join((SHORTEST, *PLANNERS))
            raise ValueError(f"planner {self.name!r} is none of {known} (or one with {REFINE})")

    @property
    def planner(self) -> str:
        """Its planner, one of `ltp.PLANNERS`."""
        return BASELINE if self.name == SHORTEST else self.name.removesuffix(REFINE)

    @property
    def refined(self) -> bool:
        """Whether paths are shortened between cells, and may so be better than any grid path."""
        return self.name.endswith(REFINE)

    def make(self, ratio: float, **options: Any) -> Planner:
        """The planner for weights of this ratio."""
        variant = at_ratio(0.0 if self.name == SHORTEST else ratio)
        if self.refined:
            options["refine"] = True
        return make_planner(
            self.planner,
            length_weight=variant.length_weight,
            priority_weight=variant.priority_weight,
            **options,
        )

    def judge(self, plan: Plan, direct: float, ratio: float) -> tuple[float, float | None]:
        """Eq. 5 of a path found, by the weights of this ratio, and the bound that holds for it."""
        weights = at_ratio(ratio)
        judged = penalty(plan.tally, direct, weights.length_weight, weights.priority_weight)
        # What is proved for W_P = 0 says nothing about other weights.
        return judged, None if self.name == SHORTEST else plan.bound


@dataclass(frozen=True, kw_only=True)
class GapOptions:
    """What to plan, and with what.

    Raises:
        ValueError: naming the field that is out of range.
    """

    planners: Sequence[str] = (SHORTEST, *PLANNERS)
    ratios: Sequence[float] = (0.5, 1.0, 2.0, 5.0)  # W_P / W_L
    maps: Sequence[str] = PRIORITY_MAPS
    bands: Sequence[str] = tuple(BANDS)
    reference: str = "pareto"  # the planner whose answer is the optimum where it proves it
    expansions: int = 0  # the reference gives up after so many; 0: no limit
    memory: float = 2048.0  # the reference, if it is `pareto`, gives up beyond it [MB]

    def __post_init__(self) -> None:
        for name, given, known in (
            ("maps", self.maps, PRIORITY_MAPS),
            ("bands", self.bands, tuple(BANDS)),
            ("reference", (self.reference,), PLANNERS),
        ):
            if not given or (strange := [value for value in given if value not in known]):
                wrong = repr(strange[0]) if given else "nothing"
                raise ValueError(f"{name}: {wrong} is none of {', '.join(known)}")
        if not self.planners:
            raise ValueError("planners: nothing to compare")
        for ratio in self.ratios:
            at_ratio(ratio)
        if self.expansions < 0:
            raise ValueError(f"expansions must be >= 0, not {self.expansions!r}")
        if not (math.isfinite(self.memory) and self.memory > 0.0):
            raise ValueError(f"memory must be above zero [MB], not {self.memory!r}")
        self.contenders()

    def contenders(self) -> list[Contender]:
        """Each once; the reference is there anyway, as `OPTIMUM`."""
        names = dict.fromkeys(name for name in self.planners if name != self.reference)
        return [Contender(name) for name in names]

    def cases(self) -> list[Case]:
        """Every combination of map, band and ratio, each once."""
        axes = (self.maps, self.bands, self.ratios)
        return list(dict.fromkeys(itertools.starmap(Case, itertools.product(*axes))))


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


def with_optimum(rows: Sequence[GapRow]) -> list[GapRow]:
    """Give each row its query's optimum.

    That is the answer of the reference where it meets its own bound. Elsewhere `optimum` is the
    best penalty that any planner found on the grid, and `optimum_bound` the best bound: the truth
    lies between.
    """
    groups: dict[tuple[Case, int], list[GapRow]] = {}
    for row in rows:
        groups.setdefault((row.case, row.query), []).append(row)
    found = {key: _optimum(group) for key, group in groups.items()}
    return [_against(row, *found[row.case, row.query]) for row in rows]


def _against(row: GapRow, optimum: float | None, bound: float | None) -> GapRow:
    gap = None if row.penalty is None or optimum is None else row.penalty - optimum
    return dataclasses.replace(row, optimum=optimum, optimum_bound=bound, gap=gap)


def _optimum(group: Sequence[GapRow]) -> tuple[float | None, float | None]:
    """The optimum or the best known penalty, and the bound below it."""
    for row in group:
        if row.planner != OPTIMUM or row.penalty is None or row.bound is None:
            continue
        if row.penalty - row.bound <= PROVED:
            return row.penalty, row.bound
    on_grid = [row for row in group if not row.planner.endswith((*_OFF_GRID, REFINE))]
    penalties = [row.penalty for row in on_grid if row.penalty is not None]
    bounds = [row.bound for row in on_grid if row.bound is not None]
    return min(penalties, default=None), max(bounds, default=None)


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


@functools.cache
def _program() -> str:
    """Digest of the compiled core: a planner that was changed plans anew, whatever its version."""
    return hashlib.sha256(Path(_core.__file__).read_bytes()).hexdigest()


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
        if contender is None:
            self._options["max_expansions"] = options.expansions
            if options.reference == "pareto":
                self._options["pareto"] = ParetoOptions(memory=options.memory)
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
        plan = planner.plan(scene, query.query(BANDS[self._case.band]))
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
        facts = {
            "program": _program(),
            "query": digest,
            "case": dataclasses.astuple(self._case),
            "planner": [self._name, self._contender.name],
            "options": {name: repr(value) for name, value in self._options.items()},
        }
        text = json.dumps(facts, sort_keys=True)
        return hashlib.sha256(text.encode()).hexdigest()[:_KEY_LENGTH]
