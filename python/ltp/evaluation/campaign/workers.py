# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Flying many flights, in this process or spread over several: one small interface."""

import multiprocessing
import os
import signal
import threading
from collections.abc import Generator, Sequence
from concurrent.futures import FIRST_COMPLETED, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from multiprocessing.process import BaseProcess
from pathlib import Path
from typing import Any, Protocol

from ltp._core import Raster
from ltp.config import MissionConfig
from ltp.world import World

from .flights import Flight, Pilot
from .rows import FlightRow


class Crew(Protocol):
    """Flies flights and gives their rows back as they are done, in any order."""

    def fly(self, flights: Sequence[Flight]) -> Generator[FlightRow, None, None]:
        """Fly them all. Closing the generator ends the work."""
        ...


class SoloCrew:
    """One flight after the other, in this process."""

    def __init__(
        self,
        world: World,
        base: MissionConfig,
        records: Path | None,
        priority: Raster | None = None,
    ) -> None:
        self._pilot = Pilot(world, base, records, priority)

    def fly(self, flights: Sequence[Flight]) -> Generator[FlightRow, None, None]:
        """See `Crew`."""
        for flight in flights:
            yield self._pilot.fly(flight)


class ProcessCrew:
    """Flights spread over processes; each has its own copy of the world, and dies with its parent.

    On Ctrl-C no flight is begun any more, those in the air are finished and given back, then
    KeyboardInterrupt goes on; a second Ctrl-C drops them too.
    """

    def __init__(
        self,
        world: World,
        base: MissionConfig,
        records: Path | None,
        processes: int,
        priority: Raster | None = None,
    ) -> None:
        # A raster cannot be sent to a process, what it is made of can.
        parts = ("values", "origin", "cell", "outside")
        sent = {name: getattr(priority, name) for name in parts} if priority is not None else None
        self._arguments = (world, base.to_dict(), records, sent)
        self._processes = processes

    def fly(self, flights: Sequence[Flight]) -> Generator[FlightRow, None, None]:
        """See `Crew`.

        Raises:
            RuntimeError: if a process was killed from outside; what was given back stays good.
        """
        others = multiprocessing.active_children()
        pool = ProcessPoolExecutor(
            min(self._processes, max(1, len(flights))),
            mp_context=multiprocessing.get_context("spawn"),
            initializer=_begin,
            initargs=self._arguments,
        )
        try:
            with _Interrupt() as interrupt:
                pending = {pool.submit(_fly, flight) for flight in flights}
                while pending:
                    done, pending = wait(pending, return_when=FIRST_COMPLETED)
                    for future in done:
                        yield future.result()
                    if interrupt.asked:
                        pending = {future for future in pending if not future.cancel()}
                if interrupt.asked:
                    raise KeyboardInterrupt
        except BrokenProcessPool as error:
            raise RuntimeError(
                "a process of the campaign was killed (out of memory?); the flights that were "
                "finished are kept, start it again to fly the others"
            ) from error
        except BaseException:
            _terminate([p for p in multiprocessing.active_children() if p not in others])
            raise
        finally:
            pool.shutdown(wait=True, cancel_futures=True)


class _Interrupt:
    """Notes the first Ctrl-C instead of raising it anywhere; lets the second one through."""

    def __init__(self) -> None:
        self.asked = False
        self._before: Any = None

    def __enter__(self) -> "_Interrupt":
        if threading.current_thread() is threading.main_thread():  # the only one that may
            self._before = signal.signal(signal.SIGINT, self._note)
        return self

    def __exit__(self, *_: object) -> None:
        self._restore()

    def _note(self, *_: object) -> None:
        self.asked = True
        self._restore()

    def _restore(self) -> None:
        if self._before is not None:
            signal.signal(signal.SIGINT, self._before)
            self._before = None


def _terminate(processes: Sequence[BaseProcess]) -> None:
    for process in processes:
        process.terminate()


_pilot: Pilot | None = None  # of a worker process


def _begin(
    world: World, base: dict[str, object], records: Path | None, sent: dict[str, Any] | None
) -> None:
    """Set a worker up; every flight in it shares the world."""
    global _pilot
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the parent decides what Ctrl-C means
    threading.Thread(target=_die_with_parent, daemon=True).start()
    priority = None if sent is None else Raster(**sent)
    _pilot = Pilot(world, MissionConfig.from_dict(base), records, priority)


def _die_with_parent() -> None:
    """A killed parent cannot tell its workers, and their queue never ends by itself."""
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)


def _fly(flight: Flight) -> FlightRow:
    assert _pilot is not None
    return _pilot.fly(flight)
