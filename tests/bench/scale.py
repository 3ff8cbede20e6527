# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""How time and memory grow: with cells, range, rays, waypoints. `python -m tests.bench.scale`.

Everything is measured in the built-in city. Each point runs in a process of its own, so that its
memory is its own; times are CPU times.
"""

import argparse
import json
import multiprocessing
import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

from rich.console import Console
from rich.progress import track

from . import growth, machine
from .scale_figure import draw, save

Row = dict[str, Any]

#: Cells along x, y, z of the same 400 x 400 x 160 m of city: 0.2 M to 67 M.
CELLS = (
    (100, 100, 20),
    (141, 141, 28),
    (200, 200, 40),
    (283, 283, 56),
    (400, 400, 80),
    (566, 566, 113),
    (696, 696, 139),
)
TEN_HERTZ = (400, 400, 80)  # 1 x 1 x 2 m
RANGES = (25.0, 50.0, 100.0, 150.0, 200.0)  # [m]
RAYS = ((16, 256), (32, 360), (64, 1024), (128, 2048), (256, 4096))  # rows, azimuths
WAYPOINTS = (10, 100, 1000, 10000, 100000)
QUICK = 2  # points of each series, the smallest


def main() -> int:
    """Measure all series, write them and draw them."""
    parser = argparse.ArgumentParser(prog="python -m tests.bench.scale", description=__doc__)
    parser.add_argument("--out", type=Path, default=Path("build/bench/scale.json"))
    parser.add_argument("--figure", type=Path, help="where the plot goes (.png)")
    parser.add_argument("--draw-only", action="store_true", help="the plot of the last results")
    parser.add_argument("--queries", type=int, default=60, help="plans at each number of cells")
    parser.add_argument("--quick", action="store_true", help="only that it runs")
    options = parser.parse_args()
    if options.draw_only:
        last = json.loads(options.out.read_text(encoding="utf-8"))
        save(draw(last["series"]), options.figure)
        return 0
    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    queries = 3 if options.quick else options.queries
    few = QUICK if options.quick else None
    tasks: list[tuple[str, Callable[..., Row], tuple[Any, ...]]] = [
        *(("cells", growth.cells, (dims, queries)) for dims in CELLS[:few]),
        *(("range", growth.sensing, (64, 1024, reach)) for reach in RANGES[:few]),
        *(("rays", growth.sensing, (rows, azimuths, 50.0)) for rows, azimuths in RAYS[:few]),
        *(("waypoints", growth.waypoints, (count,)) for count in WAYPOINTS[:few]),
        ("memory", growth.memory, ()),
    ]
    series: dict[str, list[Row]] = {name: [] for name, _, _ in tasks}
    spawn = multiprocessing.get_context("spawn")
    for name, measure, arguments in track(tasks, "scale", console=Console(stderr=True)):
        with spawn.Pool(1) as alone:
            series[name].append(alone.apply(measure, arguments))
    result = {
        "machine": machine.describe(),
        "quick": options.quick,
        "series": series,
        "figures": _figures(series),
        "tables": _tables(series),
    }
    options.out.parent.mkdir(parents=True, exist_ok=True)
    options.out.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    if options.figure:
        save(draw(series), options.figure)
    return 0


def _figures(series: dict[str, list[Row]]) -> dict[str, Row]:
    """What goals are held against."""
    figures = {"memory": {"value": series["memory"][0]["memory_mb"], "unit": "MB"}}
    for row in series["cells"]:
        if tuple(row["dims"]) == TEN_HERTZ:
            for which in ("median", "worst"):
                figures[f"plan_12.8M_{which}"] = {"value": row[f"plan_{which}_ms"], "unit": "ms"}
    return figures


def _tables(series: dict[str, list[Row]]) -> list[dict[str, Any]]:
    """The series as tables of plain values; the raw times of single plans stay in `series`."""
    titles = {
        "cells": "Cells: the same city, finer and finer; plans by `auto` in the open band",
        "range": "Range of the LiDAR, 65,536 rays",
        "rays": "Rays of a scan, 50 m",
        "waypoints": "Waypoints of a global path of 500 m",
    }
    return [
        {
            "title": title,
            "columns": [key.replace("_", " ") for key in _plain(series[name][0])],
            "rows": [list(_plain(row).values()) for row in series[name]],
        }
        for name, title in titles.items()
    ]


def _plain(row: Row) -> Row:
    return {key: value for key, value in row.items() if not isinstance(value, list)}


if __name__ == "__main__":
    sys.exit(main())
