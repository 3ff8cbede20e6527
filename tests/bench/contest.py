# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a contestant is, and how one is asked: its answers are judged first, then it is timed."""

import statistics
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from importlib import metadata
from typing import Any

import numpy as np

from .judges import Judge
from .memory import peak, resident
from .workload import Sensing, Town, make_sensing, make_town

OURS = "ltp-uav"


class Unavailable(Exception):  # noqa: N818 - it is no error
    """A contestant cannot take part; the message says why."""


@dataclass
class Shared:
    """What the contestants share: the work, made once and when it is first needed."""

    quick: bool = False

    @cached_property
    def town(self) -> Town:
        """The maps and queries of the planning rows."""
        return make_town()

    @cached_property
    def sensing(self) -> Sensing:
        """The raster and flight of the sensing rows."""
        return make_sensing()


@dataclass(frozen=True)
class Solver:
    """A contestant that is ready."""

    solve: Callable[[int], Any]  # question -> raw answer; this is timed
    answer: Callable[[Any], Any] = lambda raw: raw  # raw answer -> what is compared


@dataclass(frozen=True)
class Contestant:
    """One way of doing one work."""

    name: str
    package: str  # on PyPI
    prepare: Callable[[Shared], Solver]
    judge: Judge | None = None  # of its answers beside ours; None: it is ours


@dataclass
class Work:
    """One kind of work, and who does it; ours comes first."""

    name: str
    title: str
    questions: Callable[[Shared], int]
    unit: str = "ms"
    per_question: Callable[[float], float] = lambda ms: ms  # CPU milliseconds -> value in `unit`
    once: bool = False  # questions change the contestant: each is asked once, in order
    contestants: list[Contestant] = field(default_factory=list)

    def enter(
        self, name: str, package: str = OURS, judge: Judge | None = None
    ) -> Callable[[Callable[[Shared], Solver]], Callable[[Shared], Solver]]:
        """Enter a contestant: decorates the function that makes it ready."""

        def decorate(prepare: Callable[[Shared], Solver]) -> Callable[[Shared], Solver]:
            self.contestants.append(Contestant(name, package, prepare, judge))
            return prepare

        return decorate


@dataclass(frozen=True)
class Limits:
    """How much is asked of a contestant."""

    questions: int = 50
    seconds: float = 12.0  # CPU, for the judged round and for the timed one each
    repeats: int = 9  # of a question that takes less than 5 ms; fewer of longer ones


@dataclass(frozen=True)
class Outcome:
    """What became of a contestant, and its answers for those who are compared with them."""

    row: dict[str, Any]
    answers: list[Any]


def compete(
    work: Work, contestant: Contestant, shared: Shared, limits: Limits, ours: list[Any] | None
) -> Outcome:
    """Let a contestant answer, judge that, then time it.

    Args:
        ours: our answers, by question; None while ours are being found.

    Returns:
        A row of results; `error` in it says what kept it from being timed.
    """
    row: dict[str, Any] = {"work": work.name, "name": contestant.name, "unit": work.unit}
    row["package"] = contestant.package
    try:
        if contestant.package != OURS:
            row["version"] = metadata.version(contestant.package)
        answers = _answers(work, contestant, shared, limits)
    except (ImportError, Unavailable) as reason:
        return Outcome(row | {"error": f"not available: {reason}"}, [])
    if contestant.judge is not None and ours is None:
        row["agreement"] = "nothing of ours to compare with"
    elif contestant.judge is not None and ours is not None:
        asked = min(len(ours), len(answers))
        verdict = contestant.judge(ours[:asked], answers[:asked])
        row["agreement"] = verdict.text
        if not verdict.ok:
            return Outcome(row | {"error": f"disagrees: {verdict.text}"}, answers)
    return Outcome(row | _timed(work, contestant, shared, limits), answers)


def _answers(work: Work, contestant: Contestant, shared: Shared, limits: Limits) -> list[Any]:
    solver = contestant.prepare(shared)
    deadline = time.process_time() + limits.seconds
    answers: list[Any] = []
    for question in range(min(limits.questions, work.questions(shared))):
        answers.append(solver.answer(solver.solve(question)))
        if time.process_time() > deadline:
            break
    return answers


def _timed(work: Work, contestant: Contestant, shared: Shared, limits: Limits) -> dict[str, Any]:
    before = resident()
    set_up = time.process_time()
    solver = contestant.prepare(shared)
    set_up = time.process_time() - set_up
    if not work.once:
        solver.solve(0)  # some libraries build what they search only then
    deadline = time.process_time() + limits.seconds
    times: list[float] = []
    for question in range(min(limits.questions, work.questions(shared))):
        first = cpu_ms(solver.solve, question)
        repeats = 1 if work.once or first > 100.0 else 3 if first > 5.0 else limits.repeats
        again = [cpu_ms(solver.solve, question) for _ in range(repeats - 1)]
        times.append(statistics.median([first, *again]))
        if time.process_time() > deadline:
            break
    values = np.array([work.per_question(ms) for ms in times])
    slow = 5 if work.per_question(1.0) > work.per_question(2.0) else 95  # of a rate, or of a time
    return {
        "median": float(np.median(values)),
        "p95": float(np.percentile(values, slow)),
        "mean": float(values.mean()),
        "questions": len(times),
        "set_up_ms": set_up * 1e3,
        "memory_mb": (peak() - before) / 1e6 if before else None,
    }


def cpu_ms(call: Callable[[int], Any], question: int) -> float:
    """CPU time that one call takes, of all its threads [ms]."""
    begin = time.process_time_ns()
    call(question)
    return (time.process_time_ns() - begin) / 1e6
