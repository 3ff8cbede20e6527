# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the tables of docs/performance.md from the results: `python -m tests.bench.report`.

Only what stands between markers is replaced: `<!-- bench:NAME -->` ... `<!-- bench:end -->`.
"""

import argparse
import re
import sys
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from .goals import GOALS
from .results import Figure, Results, figure, load
from .scoring import Score, score

_MARKED = re.compile(r"(<!-- bench:(?!end)(\w+) -->\n).*?(<!-- bench:end -->)", re.DOTALL)


def main() -> int:
    """Write the page and print the summary."""
    parser = argparse.ArgumentParser(prog="python -m tests.bench.report", description=__doc__)
    parser.add_argument("--results", type=Path, default=Path("build/bench"), metavar="FOLDER")
    parser.add_argument("--page", type=Path, default=Path("docs/performance.md"))
    options = parser.parse_args()
    results = load(options.results)
    scores = [score(goal, results) for goal in GOALS]
    if results.python.get("quick") or results.scale.get("quick"):
        print(f"{options.page} is left alone: quick runs measure nothing", file=sys.stderr)
    else:
        page = options.page.read_text(encoding="utf-8")
        options.page.write_text(fill(page, results), encoding="utf-8")
    for line in summary(scores):
        print(line)
    met = sum(item.verdict == "yes" for item in scores)
    missing = sum(item.verdict.startswith("missing") for item in scores)
    print(f"\n{met} of {len(scores)} goals met, {missing} missing")
    return 0


def fill(page: str, results: Results) -> str:
    """The page with every marked section written anew; the rest stays as it is.

    Raises:
        ValueError: naming a marker that is not known.
    """
    sections = {
        "machine": _machine,
        "summary": lambda found: summary([score(goal, found) for goal in GOALS]),
        "python": _python,
        "cpp": _cpp,
        "scale": _scale,
        "latency": _latency,
    }

    def write(match: re.Match[str]) -> str:
        if match[2] not in sections:
            raise ValueError(f"marker {match[2]!r}: expected one of {', '.join(sections)}")
        lines = list(sections[match[2]](results)) or ["Not measured."]
        return match[1] + "\n".join(lines) + "\n" + match[3]

    return _MARKED.sub(write, page)


def summary(scores: Sequence[Score]) -> list[str]:
    """One row a goal."""
    head = ("work", "ltp", "best peer", "its median", "ratio", "goal", "met")
    return _markdown(head, (_summary_row(item) for item in scores))


def _summary_row(item: Score) -> list[str]:
    return [
        item.goal.work,
        str(item.ours or "missing"),
        item.peer or ("missing" if item.goal.peers else "-"),
        str(item.theirs or "-"),
        "-" if item.ratio is None else f"{item.ratio:.3g}x",
        item.goal.words,
        item.verdict,
    ]


def _machine(results: Results) -> list[str]:
    machine = results.python.get("machine")
    if not machine:
        return []
    peers = ", ".join(f"{name} {version}" for name, version in machine["peers"].items())
    vectors = ", ".join(machine["vectors"]) or "neither AVX2 nor AVX-512"
    return [
        f"- {machine['processor']}, {machine['cores']} cores, of which one is used; {vectors}",
        f"- {machine['system']}, {machine['compiler']}, Python {machine['python']}",
        f"- ltp {machine['ltp']} beside {peers}",
    ]


def _python(results: Results) -> list[str]:
    head = ("work", "who", "median", "95th percentile", "n", "memory", "its answers beside ours")
    rows = results.python.get("rows", [])
    works = [row["work"] for row in rows]
    cells = []
    for number, row in enumerate(rows):
        first = row["work"] if works.index(row["work"]) == number else ""
        name = " ".join([row["name"], *([row["version"]] if "version" in row else [])])
        measured = [_of(row, "median"), _of(row, "p95"), str(row.get("questions", ""))]
        memory = row.get("memory_mb")
        remark = "; ".join(str(row[key]) for key in ("error", "agreement", "note") if row.get(key))
        cells.append([first, name, *measured, f"{memory:.0f} MB" if memory else "", remark])
    return _markdown(head, cells) if rows else []


def _of(row: dict[str, Any], key: str) -> str:
    return str(figure(row[key], row["unit"])) if key in row else "-"


_KEYS_OF_GOOGLE = {
    *("name", "run_name", "run_type", "repetitions", "repetition_index", "threads", "iterations"),
    *("real_time", "cpu_time", "time_unit", "family_index", "per_family_instance_index", "label"),
    *("aggregate_name", "aggregate_unit"),
}


def _cpp(results: Results) -> list[str]:
    rows = []
    for name, row in results.cpp.items():
        time = results.of_cpp(name)
        remarks = [row.get("error", ""), *_counters(row), row.get("label", "")]
        rows.append([f"`{name}`", str(time or "-"), "; ".join(filter(None, remarks))])
    return _markdown(("benchmark", "CPU time", "counters"), rows) if rows else []


def _counters(row: Mapping[str, Any]) -> list[str]:
    return [
        f"{key} {_counter(key, value)}"
        for key, value in row.items()
        if key not in _KEYS_OF_GOOGLE and isinstance(value, int | float)
    ]


def _counter(key: str, value: float) -> str:
    """By its name: a rate, the time that one thing takes [s], or a number."""
    if key.endswith("per_second"):
        return str(Figure(value, "rate"))
    timed = key.startswith(("a_", "worst_", "seconds_"))
    return str(Figure(value)) if timed else f"{value:.6g}"


def _scale(results: Results) -> list[str]:
    lines: list[str] = []
    for table in results.scale.get("tables", []):
        rows = [[_cell(value) for value in row] for row in table["rows"]]
        lines += [f"**{table['title']}**", "", *_markdown(table["columns"], rows), ""]
    return lines[:-1]


def _cell(value: Any) -> str:
    return (
        f"{value:.4g}"
        if isinstance(value, float)
        else f"{value:,}"
        if isinstance(value, int)
        else str(value)
    )


def _latency(results: Results) -> list[str]:
    columns = {"median_ms": "median", "p99_ms": "99 %", "p999_ms": "99.9 %", "worst_ms": "worst"}
    rows = [
        [row["name"], *(_milliseconds(row.get(key)) for key in columns)]
        for row in results.latency.get("rows", [])
    ]
    return _markdown(("", *columns.values()), rows) if rows else []


def _milliseconds(value: float | None) -> str:
    return "-" if value is None else str(figure(value, "ms"))


def _markdown(head: Sequence[str], rows: Iterable[Sequence[str]]) -> list[str]:
    return [
        "| " + " | ".join(head) + " |",
        "|" + "---|" * len(head),
        *("| " + " | ".join(row) + " |" for row in rows),
    ]


if __name__ == "__main__":
    sys.exit(main())
