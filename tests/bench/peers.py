# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""ltp beside its peers on the same seeded work, through Python: `python -m tests.bench.peers`.

Every answer is compared with ours before anything is timed. Times are CPU time of all threads, on
one core.
"""

import argparse
import json
import os
import sys
from pathlib import Path
from typing import Any

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn
from rich.table import Table

from . import machine
from .contest import OURS, Limits, Outcome, Shared, Work, compete
from .contestants import fields, flight, maps, paths, rays, windows

WORKS: tuple[Work, ...] = (
    paths.shortest,
    paths.dijkstra,
    fields.field,
    paths.ggwp,
    paths.unreachable,
    rays.level,
    rays.tilted,
    maps.update,
    maps.query,
    windows.inflation,
    windows.rolling,
)

Row = dict[str, Any]


def main() -> int:
    """Run the contest; 1 if an answer was wrong, so that nobody reads the times."""
    options = _options()
    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})  # before any library counts the cores
    console = Console(stderr=True)
    rows = _run(options, console)
    result = {"machine": machine.describe(), "quick": options.quick, "rows": rows}
    if options.out:
        options.out.parent.mkdir(parents=True, exist_ok=True)
        options.out.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    Console(width=None if sys.stdout.isatty() else 150).print(_table(rows))
    wrong = [row for row in rows if str(row.get("error", "")).startswith("disagrees")]
    for row in wrong:
        console.print(f"[red]{row['work']}: {row['name']} {row['error']}[/red]")
    return 1 if wrong else 0


def _options() -> argparse.Namespace:
    names = [*(work.name for work in WORKS), flight.NAME]
    parser = argparse.ArgumentParser(prog="python -m tests.bench.peers", description=__doc__)
    parser.add_argument("--only", metavar="WORK,...", help=f"of: {', '.join(names)}")
    parser.add_argument(
        "--peers", metavar="PACKAGE,...", help=f"of: {', '.join(machine.PEERS)}; or none"
    )
    parser.add_argument("--queries", type=int, default=50, help="asked of everybody, at most")
    parser.add_argument("--seconds", type=float, default=12.0, help="CPU time for each, about")
    parser.add_argument("--quick", action="store_true", help="only that it runs: 3 queries, 1 s")
    parser.add_argument("--out", type=Path, metavar="JSON", help="where the results go")
    options = parser.parse_args()
    for name, known in (("only", names), ("peers", [*machine.PEERS, "none"])):
        given = getattr(options, name)
        chosen = known if given is None else given.split(",")
        if unknown := [item for item in chosen if item not in known]:
            parser.error(f"--{name}: unknown {', '.join(unknown)}; known: {', '.join(known)}")
        setattr(options, name, chosen)
    return options


def _run(options: argparse.Namespace, console: Console) -> list[Row]:
    limits = Limits(questions=options.queries, seconds=options.seconds)
    if options.quick:
        limits = Limits(questions=3, seconds=1.0, repeats=3)
    allowed = {OURS, *options.peers}
    shared = Shared()
    works = [work for work in WORKS if work.name in options.only]
    entries = [(work, c) for work in works for c in work.contestants if c.package in allowed]
    bar = Progress(
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        TimeElapsedColumn(),
        console=console,
    )
    rows: list[Row] = []
    ours: dict[str, Outcome] = {}
    with bar:
        task = bar.add_task("", total=len(entries) + (flight.NAME in options.only))
        for work, contestant in entries:
            bar.update(task, description=f"{work.name}: {contestant.name}")
            reference = ours[work.name].answers if work.name in ours else []
            outcome = compete(work, contestant, shared, limits, reference or None)
            ours.setdefault(work.name, outcome)
            rows.append(outcome.row)
            bar.advance(task)
        if flight.NAME in options.only:
            bar.update(task, description=flight.NAME)
            rows += _fly(options, allowed)
            bar.advance(task)
    return rows


def _fly(options: argparse.Namespace, allowed: set[str]) -> list[Row]:
    row, flown = flight.fly_ours(60.0 if options.quick else 500.0)
    rows = [row]
    for name in ("Open3D", "embreex"):
        if {name.lower(), "pyoctomap"} <= allowed:
            try:
                rows.append(flight.sense_and_map(flown, name, 3 if options.quick else 50))
            except ImportError as reason:
                rows.append(
                    {"work": flight.NAME, "name": f"{name} + pyoctomap", "unit": "s"}
                    | {"package": name.lower(), "error": f"not available: {reason}"}
                )
    return rows


def _table(rows: list[Row]) -> Table:
    table = Table("work", "who", "median", "p95", "unit", "beside ours", box=None)
    before = ""
    for row in rows:
        same = row["work"] == before
        before = row["work"]
        median, p95 = (f"{row[key]:.4g}" if key in row else "" for key in ("median", "p95"))
        remark = row.get("error") or row.get("agreement") or row.get("note", "")
        table.add_row("" if same else before, row["name"], median, p95, row["unit"], remark)
    return table


if __name__ == "__main__":
    code = main()
    sys.stdout.flush()
    os._exit(code)  # some peers' libraries talk when they are unloaded
