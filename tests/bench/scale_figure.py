# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The plot of how time and memory grow."""

import io
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ltp.evaluation.figures.backdrop import FAINT, INK
from ltp.evaluation.figures.flights import PATH_COLOURS

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Row = dict[str, Any]
_TEN_HERTZ = 100.0  # [ms]
_TITLE: dict[str, Any] = {"loc": "left", "fontsize": 10, "fontweight": "bold", "color": INK}
_COLOURS = 64  # of the picture


def draw(series: dict[str, list[Row]]) -> "Figure":
    """Six panels: time and memory against cells, single plans, range, rays, waypoints."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(11.0, 6.4), facecolor="white", layout="constrained")
    axes = figure.subplots(2, 3)
    cells = series["cells"]
    _lines(
        axes[0, 0],
        "cells of the window",
        [row["cells"] for row in cells],
        {
            "plan, worst": [row["plan_worst_ms"] for row in cells],
            "plan, median": [row["plan_median_ms"] for row in cells],
            "shortest path": [row["shortest_median_ms"] for row in cells],
            "distance field": [row.get("field_ms", np.nan) for row in cells],
        },
    )
    axes[0, 0].set_title("The same city, finer and finer", **_TITLE)
    axes[0, 1].set_title("Memory of window and planner", **_TITLE)
    axes[0, 2].set_title("Plans by auto, open band", **_TITLE)
    axes[1, 0].set_title("Range, 65,536 rays", **_TITLE)
    axes[1, 1].set_title("Rays, 50 m", **_TITLE)
    axes[1, 2].set_title("Waypoints", **_TITLE)
    axes[0, 0].axhline(_TEN_HERTZ, color=FAINT, lw=0.8, ls="--")
    axes[0, 0].set_ylim(top=1e6)  # room for the legend
    axes[0, 0].annotate("10 Hz", (cells[0]["cells"], _TEN_HERTZ), color=FAINT, va="bottom", size=8)
    memory = {"window and planner": [row["memory_mb"] for row in cells]}
    _lines(axes[0, 1], "cells of the window", [row["cells"] for row in cells], memory, "MB")
    _plans(axes[0, 2], cells)
    for panel, name, key, label in (
        (axes[1, 0], "range", "range_m", "range of the LiDAR [m]"),
        (axes[1, 1], "rays", "rays", "rays of a scan"),
    ):
        rows = series[name]
        _lines(
            panel,
            label,
            [row[key] for row in rows],
            {"scan": [r["scan_ms"] for r in rows], "map update": [r["map_ms"] for r in rows]},
        )
    rows = series["waypoints"]
    _lines(
        axes[1, 2],
        "waypoints of the global path",
        [row["waypoints"] for row in rows],
        {
            "take the path over": [row["set_ms"] for row in rows],
            "first decision, with a plan": [row["first_update_ms"] for row in rows],
            "decision": [row["update_ms"] for row in rows],
        },
    )
    axes[1, 0].set(xscale="linear", yscale="linear", xlim=0.0, ylim=0.0)
    return figure


def save(figure: "Figure", path: Path) -> None:
    """Write a PNG of few colours: a third of the bytes."""
    from PIL import Image

    picture = io.BytesIO()
    figure.savefig(picture, format="png", dpi=100)
    Image.open(picture).convert("RGB").quantize(_COLOURS).save(path, optimize=True)


def _lines(
    axes: "Axes",
    label: str,
    x: Sequence[float],
    lines: dict[str, list[float]],
    unit: str = "CPU time [ms]",
) -> None:
    for (name, y), colour in zip(lines.items(), PATH_COLOURS, strict=False):
        if np.isfinite(y).any():
            axes.plot(x, y, "o-", color=colour, ms=3.5, lw=1.4, label=name)
    axes.set_xscale("log")
    axes.set_yscale("log")
    _dress(axes, label, unit)
    axes.legend(frameon=False, fontsize=8)


def _plans(axes: "Axes", cells: list[Row]) -> None:
    """Which share of the plans takes how long, for every second window."""
    for row, colour in zip(cells[::2], PATH_COLOURS, strict=False):
        times = np.sort(row["times_ms"])
        share = np.arange(1, len(times) + 1) / len(times)
        axes.step(
            times, share, where="post", color=colour, label=f"{row['cells'] / 1e6:.1f} M cells"
        )
    axes.axvline(_TEN_HERTZ, color=FAINT, lw=0.8, ls="--")
    axes.set_xscale("log")
    axes.set(ylim=(0.0, 1.02), xlim=(None, 1e4))  # room for the legend
    _dress(axes, "time of a plan [ms]", "share of the plans")
    axes.legend(frameon=False, fontsize=8, loc="lower right")


def _dress(axes: "Axes", x_label: str, y_label: str) -> None:
    axes.set_xlabel(x_label, color=INK)
    axes.set_ylabel(y_label, color=INK)
    axes.grid(alpha=0.25, which="major", lw=0.5)
    axes.spines[["top", "right"]].set_visible(False)
    axes.tick_params(colors=INK, labelsize=8)
