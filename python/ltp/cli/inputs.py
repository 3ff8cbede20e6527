# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Turning what stands on the command line into values."""

import os
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from .output import note

if TYPE_CHECKING:
    from ltp._core import Raster
    from ltp.evaluation.campaign.rows import FlightRow
    from ltp.world import World


def open_world(source: str) -> "World":
    """The world that an argument names."""
    from ltp.world import World

    name, _, seed = source.partition(":")
    if name == "city" and not Path(source).is_file():  # a folder of that name is no world
        from ltp.world.city import make_city

        if seed and not seed.isdecimal():
            raise ValueError(f"{source}: the seed of the city must be a whole number >= 0")
        return make_city(seed=int(seed) if seed else 1)
    if not Path(source).is_file():
        raise ValueError(f"{source}: no such world file (the built-in world is called `city`)")
    return World.load(source)


def open_priority(path: Path | None, world: "World") -> "Raster | None":
    """The priority map in a file, if one is given; what is worth knowing of it goes to stderr."""
    from ltp.world.importers.priority import read_priority

    if path is None:
        return None
    if not path.exists():
        raise ValueError(f"--priority: {path}: no such file")
    given = read_priority(path, world)
    for finding in given.report:
        note(finding)
    return given.raster


@contextmanager
def telling_old_names(where: object) -> Iterator[None]:
    """Tell on stderr of the old names that are used within, and `where` they stand."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", DeprecationWarning)
        yield
    for warning in caught:
        note(f"{where}: {warning.message}")


def read_flights(path: Path) -> "list[FlightRow]":
    """The rows of a campaign, by its folder or its CSV."""
    from ltp.evaluation.campaign import TABLE
    from ltp.evaluation.campaign.rows import read_rows

    rows = read_rows(path / TABLE if path.is_dir() else path)
    if not rows:
        raise ValueError(f"{path} holds no flights")
    return rows


def read_flights_over(path: Path, source: str) -> "tuple[list[FlightRow], World]":
    """The rows of a campaign, and the world that it was flown over, as an argument names it."""
    rows, world = read_flights(path), open_world(source)
    if rows[0].world != world.name:
        raise ValueError(f"{path} was flown over {rows[0].world}, not over {world.name}")
    return rows, world


def numbers(name: str, text: str) -> list[float]:
    """The numbers in a text with commas between."""
    try:
        return [float(part) for part in text.split(",")]
    except ValueError:
        raise ValueError(f"{name}: expected numbers with commas between, not {text!r}") from None


def names(text: str) -> list[str]:
    """The names in a text with commas between."""
    return [part.strip() for part in text.split(",") if part.strip()]


def map_names(text: str) -> list[str]:
    """The priority maps in the text of --maps; each is one."""
    from ltp.evaluation.conditions import PRIORITY_MAPS

    kinds = names(text)
    if strange := [kind for kind in kinds if kind not in PRIORITY_MAPS]:
        raise ValueError(f"--maps: {strange[0]!r} is none of {', '.join(PRIORITY_MAPS)}")
    return kinds


def planner_name(option: str, name: str) -> str:
    """A contender's current name; an old one is told on stderr."""
    from ltp.evaluation.contenders import current_name

    with telling_old_names(option):
        return current_name(name)


def planner_names(option: str, text: str) -> list[str]:
    """The same for the names in a text with commas between."""
    return [planner_name(option, name) for name in names(text)]


def workers(processes: int) -> int:
    """The number of processes that is meant: 0 is one per processor."""
    if processes < 0:
        raise ValueError(f"--processes must be >= 0, not {processes}")
    return processes or len(os.sched_getaffinity(0))
