# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reading what the benchmarks wrote: one figure by its name, whoever measured it."""

import json
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

_SECONDS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}
#: What Google Benchmark appends to a name for how it was run.
_HOW = re.compile(
    r"/(repeats|iterations|min_time|min_warmup_time):[^/]+|/(real|process|manual)_time"
)


@dataclass(frozen=True)
class Figure:
    """One measured value: a time [s], a rate [1/s] or memory [B]."""

    value: float
    kind: str = "time"

    def __str__(self) -> str:
        if self.kind == "rate":
            return f"{_three(self.value / 1e6)} M/s"
        if self.kind == "memory":
            return f"{_three(self.value / 1e6)} MB"
        for limit, unit in ((1e-6, "ns"), (1e-3, "µs"), (1.0, "ms")):
            if self.value < 0.9995 * limit:
                return f"{_three(self.value / _SECONDS[unit.replace('µ', 'u')])} {unit}"
        return f"{_three(self.value)} s"

    def better_than(self, other: "Figure") -> float:
        """How many times better."""
        if self.kind != other.kind:
            raise ValueError(f"a {self.kind} cannot be compared with a {other.kind}")
        ratio = self.value / other.value
        return ratio if self.kind == "rate" else 1.0 / ratio


def figure(value: float, unit: str) -> Figure:
    """A figure from a value and its unit: ns, us, ms, s, MB, or M .../s."""
    if unit in _SECONDS:
        return Figure(value * _SECONDS[unit])
    if unit == "MB":
        return Figure(value * 1e6, "memory")
    if unit.startswith("M ") and unit.endswith("/s"):
        return Figure(value * 1e6, "rate")
    raise ValueError(f"unit {unit!r}: expected ns, us, ms, s, MB or M .../s")


@dataclass(frozen=True)
class Results:
    """Everything that was measured; an empty part was not."""

    cpp: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)  # by Google Benchmark's name
    python: Mapping[str, Any] = field(default_factory=dict)  # of `peers`
    scale: Mapping[str, Any] = field(default_factory=dict)  # of `scale`
    latency: Mapping[str, Any] = field(default_factory=dict)

    def of_cpp(self, name: str, rate: str = "", each: str = "") -> Figure | None:
        """CPU time of a C++ benchmark, or a rate that it counts, or a time [s] that it counts."""
        row = self.cpp.get(name, {})
        if (rate or each or "cpu_time") not in row:
            return None
        if rate:
            return Figure(row[rate], "rate")
        return Figure(row[each]) if each else figure(row["cpu_time"], row["time_unit"])

    def of_python(self, work: str, name: str) -> Figure | None:
        """Median of a contestant."""
        for row in self.python.get("rows", []):
            if (row["work"], row["name"]) == (work, name) and "median" in row:
                return figure(row["median"], row["unit"])
        return None

    def of_scale(self, name: str) -> Figure | None:
        """One of the single figures of `scale`."""
        row = self.scale.get("figures", {}).get(name)
        return None if row is None else figure(row["value"], row["unit"])


def load(folder: Path) -> Results:
    """Read cpp.json, python.json, scale.json and latency.json; whichever are there."""
    return Results(
        cpp=_cpp_rows(_json(folder / "cpp.json")),
        python=_json(folder / "python.json"),
        scale=_json(folder / "scale.json"),
        latency=_json(folder / "latency.json"),
    )


def _json(path: Path) -> dict[str, Any]:
    if not path.exists():
        return {}
    values: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    return values


def _cpp_rows(document: dict[str, Any]) -> dict[str, dict[str, Any]]:
    """Rows by name; of repeated ones the median, of failed ones only what they say."""
    rows: dict[str, dict[str, Any]] = {}
    for row in document.get("benchmarks", []):
        name = _HOW.sub("", row.get("run_name", row["name"]))
        if row.get("error_occurred"):
            rows[name] = {"error": row.get("error_message", "failed")}
        elif row.get("aggregate_name") == "median":
            rows[name] = row
        elif row.get("run_type", "iteration") == "iteration":
            rows.setdefault(name, row)
    return rows


def _three(value: float) -> str:
    """Three digits that mean something."""
    return f"{value:.0f}" if value >= 99.95 else f"{value:.3g}"
