# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tables: statistics by hand, the paper's numbers beside them, the best marked."""

import csv
import io
import math
import re
import statistics

import numpy as np
import pytest

from ltp.evaluation.campaign.paper import PAPER
from ltp.evaluation.campaign.summary import Spread, summarise
from ltp.evaluation.campaign.tables import (
    averaged_over,
    brief_cells,
    csv_table,
    markdown_table,
    table_cells,
    table_variants,
)
from ltp.evaluation.campaign.variants import TABLE_I, TABLE_II, TABLES, Variant
from tests.python.scenes import row

DIJKSTRA = TABLE_I[1]


def flights(variant: Variant, priorities: list[float], **changes: object) -> list:
    kind = {
        "planner": variant.planner,
        "length_weight": variant.length_weight,
        "priority_weight": variant.priority_weight,
        "priority_map": variant.priority_map,
        "refine": variant.refine,
    }
    return [
        row(key=f"{variant}{i}", scenario=i, mean_priority=value, **(kind | changes))
        for i, value in enumerate(priorities)
    ]


def test_a_summary_is_mean_and_sample_sd_of_the_flights_that_ended() -> None:
    rows = flights(DIJKSTRA, [0.5, 0.7, 0.9])
    rows[0] = row(mean_priority=0.5, length_ratio=1.3, time_plans="1|2|9", dropped=2, plans=3)
    late = {"outcome": "timed_out", "time_plans": "100", "min_clearance": 0.25}
    rows += flights(DIJKSTRA, [0.0], seed=2, length_ratio=9.0, **late)
    rows += flights(DIJKSTRA, [0.0], seed=3, outcome="collided", collided=True, time_plans="")
    rows += flights(TABLE_I[0], [0.1])
    summary, lost = summarise([DIJKSTRA], rows)
    assert (summary.flights, summary.completed, summary.common) == (5, 3, 3)
    assert (summary.timed_out, summary.collisions) == (1, 1)
    assert summary.dropped == 6
    assert summary.mean_priority.mean == pytest.approx(0.7)
    assert summary.mean_priority.sd == pytest.approx(statistics.stdev([0.5, 0.7, 0.9]))
    assert summary.length_ratio.mean == pytest.approx((1.3 + 1.1 + 1.1) / 3)
    assert summary.min_clearance == 0.25
    times = [1, 2, 9, 1, 2, 3, 1, 2, 3, 100]
    assert summary.time_mean == pytest.approx(np.mean(times))
    assert summary.time_median == pytest.approx(np.median(times))
    assert summary.time_p95 == pytest.approx(np.percentile(times, 95))
    # What timed out has a row of its own.
    assert lost.timed_out_only and not summary.timed_out_only
    assert (lost.flights, lost.completed, lost.length_ratio.mean) == (1, 0, 9.0)
    assert "LP-Dijkstra: timed out" in markdown_table([summary, lost])


def test_means_are_over_the_paths_that_all_rows_flew_to_the_end() -> None:
    easy, hard = {"length_ratio": 1.1}, {"length_ratio": 2.0}
    other = TABLE_I[0]
    rows = flights(DIJKSTRA, [0.5, 0.5], **easy) + flights(DIJKSTRA, [0.9], seed=2, **hard)
    # The other strands on the hard path, and looks no shorter for it.
    rows += flights(other, [0.4, 0.4], length_ratio=1.2)
    rows += flights(other, [0.1], seed=2, outcome="timed_out", length_ratio=0.3)
    ours, theirs, lost = summarise([DIJKSTRA, other], iter(rows))  # any iterable, read once
    assert [s.common for s in (ours, theirs)] == [2, 2]
    assert ours.length_ratio.mean == pytest.approx(1.1)
    assert theirs.length_ratio.mean == pytest.approx(1.2)
    assert ours.mean_priority.mean == pytest.approx(0.5)
    assert (ours.completed, theirs.completed, lost.flights) == (3, 2, 1)
    text = markdown_table([ours, theirs, lost])
    assert "over the 2 of 3 paths that all rows flew to the end" in text
    assert "**0.30**" not in text  # what timed out is never the best


def test_what_is_flown_by_nobody_else_leaves_nothing_to_average() -> None:
    rows = flights(DIJKSTRA, [0.5]) + flights(TABLE_I[0], [0.5], seed=2)
    summaries = summarise([DIJKSTRA, TABLE_I[0]], rows)
    assert all(math.isnan(s.length_ratio.mean) and s.common == 0 for s in summaries)
    assert "over the 0 of 1" in averaged_over(summaries)


def test_drops_are_judged_twice_where_they_were() -> None:
    rows = flights(DIJKSTRA, [0.5, 0.6], wrongly_dropped=1, wrongly_dropped_fine=2)
    assert "| 2 (2, 4) |" in markdown_table(summarise([DIJKSTRA], rows))
    rows += flights(DIJKSTRA, [0.5], seed=2)  # of a file older than the column
    (summary,) = summarise([DIJKSTRA], rows)
    assert summary.wrongly_dropped_fine is None
    assert "| 3 (2, –) |" in markdown_table([summary])


def test_the_distance_from_the_global_path_is_told_where_it_was_measured() -> None:
    rows = flights(DIJKSTRA, [0.5], path_distance_mean=7.0, path_distance_max=40.0)
    rows += flights(DIJKSTRA, [0.5], seed=2, path_distance_mean=9.0, path_distance_max=31.0)
    (summary,) = summarise([DIJKSTRA], rows)
    assert "| 8.0 (1.4) | 40 |" in markdown_table([summary])
    (line,) = csv.DictReader(io.StringIO(csv_table([summary])))
    assert (line["path_distance_mean"], line["path_distance_max"]) == ("8.0", "40.0")
    (older,) = summarise([DIJKSTRA], [*rows, *flights(DIJKSTRA, [0.5], seed=3)])
    assert older.path_distance is None and older.path_distance_max is None
    assert "| – | – |" in markdown_table([older])
    (line,) = csv.DictReader(io.StringIO(csv_table([older])))
    assert line["path_distance_mean"] == line["path_distance_max"] == ""


def test_the_papers_numbers_stand_beside_ours() -> None:
    assert set(PAPER) == set(TABLES)
    assert PAPER[DIJKSTRA].mean_priority / PAPER[TABLE_I[0]].mean_priority == pytest.approx(
        1.34, abs=0.01
    )  # "by ~34 %"
    assert PAPER[DIJKSTRA].length_ratio / PAPER[TABLE_I[0]].length_ratio == pytest.approx(
        1.072, abs=0.001
    )  # "by only ~7.2 %"
    rows = [r for variant in TABLE_I for r in flights(variant, [0.5, 0.6])]
    summaries = summarise(TABLE_I, rows)
    titles, lines = table_cells(summaries)
    column = titles.index("paper: P")
    assert [line[column][0] for line in lines] == [
        "0.61 (0.11)",
        "0.82 (0.06)",
        "0.62 (0.11)",
        "0.76 (0.09)",
        "0.61 (0.10)",
        "0.66 (0.12)",
        "0.59 (0.12)",
    ]
    assert [line[titles.index("paper: ms")][0] for line in lines][-1] == "8.4"


def test_the_best_values_are_marked() -> None:
    rows = flights(TABLE_I[0], [0.5], length_ratio=1.05, time_plans="9")
    rows += flights(TABLE_I[1], [0.8], length_ratio=1.20, time_plans="9")
    rows += flights(TABLE_I[6], [0.4], length_ratio=1.054, time_plans="3")
    text = markdown_table(summarise([TABLE_I[i] for i in (0, 1, 6)], rows))
    assert re.findall(r"\*\*(.*?)\*\*", text) == ["1.05", "0.80", "1.05", "3.00"]
    assert {line.count("|") for line in text.splitlines()} - {0} == {19}
    alone = markdown_table(summarise([TABLE_I[0]], rows))
    assert "**" not in alone  # nothing to compare with


def test_rows_find_their_tables() -> None:
    bezier = Variant("bezier", 0.5, 1.0)
    rows = [r for v in (*reversed(TABLES), bezier) for r in flights(v, [0.5])]
    assert table_variants(rows) == {
        "Table I: binary priority map": list(TABLE_I),
        "Table II: low-pass priority map": list(TABLE_II),
        "Not in the paper's tables: binary priority map": [bezier],
    }
    steep = Variant("lp-dijkstra", 0.5, 5.0, "lpf")
    assert table_variants(flights(steep, [0.5])) == {
        "Not in the paper's tables: low-pass priority map": [steep]
    }


def test_refined_rows_follow_the_plain_ones() -> None:
    ggwp, bezier = TABLE_I[6], Variant("bezier", 0.5, 1.0)
    flown = [ggwp.refined, bezier, bezier.refined, DIJKSTRA, ggwp]
    rows = [r for variant in flown for r in flights(variant, [0.5, 0.6])]
    assert list(table_variants(rows).values()) == [
        [DIJKSTRA, ggwp, ggwp.refined],
        [bezier, bezier.refined],
    ]
    (summary,) = summarise([ggwp.refined], rows)
    assert summary.flights == 2 and summary.paper is None
    assert "| GGWP, refined | 1 | 0 |" in markdown_table([summary])
    assert [line["refine"] for line in csv.DictReader(io.StringIO(csv_table([summary])))] == ["yes"]


def test_the_csv_has_the_same_numbers_unrounded() -> None:
    (summary,) = summarise([DIJKSTRA], flights(DIJKSTRA, [0.1, 0.2, 0.6]))
    (line,) = csv.DictReader(io.StringIO(csv_table([summary])))
    assert float(line["mean_priority"]) == summary.mean_priority.mean
    assert float(line["paper_time_plan_ms"]) == 20.0
    assert line["world"] == "boxes" and line["flights"] == "3"
    (empty,) = csv.DictReader(io.StringIO(csv_table(summarise([TABLE_II[0]], []))))
    assert empty["mean_priority"] == "" and empty["paper_time_plan_ms"] == ""


def test_two_worlds_do_not_mix() -> None:
    rows = [row(), row(world="elsewhere")]
    with pytest.raises(ValueError, match="boxes, elsewhere"):
        summarise([DIJKSTRA], rows)


def test_what_was_too_far_stands_beside_what_was_dropped() -> None:
    rows = flights(DIJKSTRA, [0.5, 0.7], dropped=2, too_far=3)
    (summary,) = summarise([DIJKSTRA], rows)
    assert (summary.dropped, summary.too_far) == (4, 6)
    titles, lines = table_cells([summary])
    assert lines[0][titles.index("too far")] == ("6", False)
    assert "Waypoints skipped as too far: 6." in markdown_table([summary])
    assert "too far:" not in markdown_table(summarise([DIJKSTRA], flights(DIJKSTRA, [0.5])))
    header, line = csv_table([summary]).splitlines()
    assert dict(zip(header.split(","), line.split(","), strict=True))["too_far"] == "6"


def test_too_few_values_have_no_spread() -> None:
    assert Spread.of([0.4]).mean == 0.4 and math.isnan(Spread.of([0.4]).sd)
    assert math.isnan(Spread.of([]).mean)
    assert "–" in markdown_table(summarise([DIJKSTRA], []))


def test_the_brief_table_fits_80_columns() -> None:
    rows = flights(TABLE_I[4], [0.5, 0.6], dropped=50, wrongly_dropped_fine=10, length_ratio=1.25)
    rows += flights(TABLE_I[4], [0.5], seed=2, outcome="timed_out")
    titles, lines = brief_cells(summarise([TABLE_I[4]], rows))
    shown = [
        [titles],
        *([[cell for cell, _ in ours], *([paper] if paper else [])] for ours, paper in lines),
    ]
    cells = [line for group in shown for line in group]
    widths = [max(len(line[i]) for line in cells) for i in range(len(titles))]
    assert sum(widths) + len(widths) + 1 <= 80
    assert lines[1][0][0][0] == "  timed out"
