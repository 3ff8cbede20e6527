# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A long plan lets other threads run, and ends soon after Ctrl-C."""

import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

import numpy as np
import pytest

import ltp

# On the target machine within 0.2 s; here the processor may be shared with much else.
LIMIT = 1.0  # [s]

FOREVER = """
import sys, time
import numpy as np, ltp
frame = ltp.GridFrame((0, 0, 0), (2, 2, 4), (200, 200, 40))
scene = ltp.Scene(ltp.OccupancyGrid(frame), ltp.Raster(np.full((200, 200), 0.5), cell=2.0))
query = ltp.Query((1, 1, 2), (399, 399, 158))
bezier = ltp.BezierOptions(offsets=2001, segments=int(sys.argv[2]))
planner = ltp.make_planner(sys.argv[1], bezier=bezier)
print("ready", flush=True)
try:
    while True:
        planner.plan(scene, query)
except KeyboardInterrupt:
    print("interrupted", time.time(), flush=True)
"""


@pytest.mark.parametrize(
    ("name", "segments"), [*((name, 64) for name in ltp.PLANNERS), ("bezier", 100_000)]
)
def test_ctrl_c_ends_a_search_over_a_million_cells(
    name: str, segments: int, capsys: pytest.CaptureFixture
) -> None:
    with subprocess.Popen(
        [sys.executable, "-c", FOREVER, name, str(segments)], stdout=subprocess.PIPE, text=True
    ) as process:
        try:
            assert process.stdout is not None
            assert process.stdout.readline() == "ready\n"
            time.sleep(0.5)
            pressed = time.time()
            process.send_signal(signal.SIGINT)
            answer = process.communicate(timeout=60)[0].split()
            assert process.returncode == 0
        finally:
            process.kill()
    assert answer[0] == "interrupted"
    delay = float(answer[1]) - pressed
    with capsys.disabled():
        print(f" [{name}: {1000 * delay:.0f} ms after Ctrl-C]", end="")
    assert delay < LIMIT


def big_scene() -> tuple[ltp.Scene, ltp.Query]:
    frame = ltp.GridFrame((0, 0, 0), (2, 2, 4), (200, 200, 40))
    blocked = np.zeros((200, 200, 40), bool)
    blocked[197:, 197:, 37:] = True  # a closed corner with the start in it
    blocked[199, 199, 39] = False
    raster = ltp.Raster(np.full((200, 200), 0.5), cell=2.0)
    scene = ltp.Scene(ltp.OccupancyGrid.from_array(blocked, frame), raster)
    return scene, ltp.Query((399, 399, 158), (1, 1, 2))


def test_other_threads_run_while_a_planner_searches() -> None:
    scene, query = big_scene()
    planner = ltp.make_planner("lp-dijkstra")
    ticks: list[float] = []
    done = threading.Event()

    def tick() -> None:
        while not done.wait(0.001):
            ticks.append(time.perf_counter())

    thread = threading.Thread(target=tick)
    thread.start()
    begin = time.perf_counter()
    plan = planner.plan(scene, query)
    end = time.perf_counter()
    done.set()
    thread.join()
    assert plan.status == ltp.PlanStatus.UNREACHABLE
    assert plan.stats.expanded == 200 * 200 * 40 - 27
    within = [t for t in ticks if begin < t < end]
    # Not only at its beginning and its end.
    assert len(within) >= 5
    assert any(begin + 0.25 * (end - begin) < t < end - 0.25 * (end - begin) for t in within)


class AlarmError(Exception):
    """What the handler of an alarm raises."""


def raise_alarm(number: int, frame: object) -> None:
    raise AlarmError


@contextmanager
def alarm(handler: Callable[[int, object], None], first: float, again: float = 0.0) -> Iterator:
    """Call `handler` after `first` seconds, and every `again` seconds from then on."""
    old = signal.signal(signal.SIGALRM, handler)
    try:
        signal.setitimer(signal.ITIMER_REAL, first, again)
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, old)


def test_a_handler_that_does_not_raise_does_not_stop_the_search() -> None:
    scene, query = big_scene()
    planner = ltp.make_planner("lp-dijkstra")
    calls: list[int] = []
    with alarm(lambda number, _: calls.append(number), 0.01, 0.01):
        plan = planner.plan(scene, query)
    assert plan.status == ltp.PlanStatus.UNREACHABLE
    assert len(calls) >= 2


def test_what_a_handler_raises_is_raised() -> None:
    scene, query = big_scene()
    planner = ltp.make_planner("lp-dijkstra")
    expected = planner.plan(scene, query)
    with alarm(raise_alarm, 0.02), pytest.raises(AlarmError):
        for _ in range(1000):
            planner.plan(scene, query)
    # The planner is as good as new.
    again = planner.plan(scene, query)
    assert (again.status, again.stats.expanded) == (expected.status, expected.stats.expanded)


def test_a_plan_in_another_thread_is_not_disturbed_by_signals() -> None:
    scene, query = big_scene()
    planner = ltp.make_planner("lp-dijkstra")
    plans: list[ltp.Plan] = []
    thread = threading.Thread(target=lambda: plans.append(planner.plan(scene, query)))
    thread.start()  # before the alarm is set: under load it might ring first
    with alarm(raise_alarm, 0.02), pytest.raises(AlarmError):
        while True:  # signals belong to the main thread
            time.sleep(0.001)
    thread.join()
    assert plans[0].status == ltp.PlanStatus.UNREACHABLE
