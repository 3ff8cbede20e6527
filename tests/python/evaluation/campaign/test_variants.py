# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a campaign varies: the rows of the paper's tables, the sweep, what is refused."""

import pytest

from ltp.evaluation.campaign.variants import (
    SWEEP_RATIOS,
    TABLE_I,
    TABLE_II,
    TABLES,
    Variant,
    at_ratio,
    rows_of,
    sweep,
    unique,
    with_refined,
)
from ltp.evaluation.conditions import Weights
from ltp.registry import PLANNERS


def test_the_rows_of_the_papers_tables() -> None:
    assert len(TABLE_I) == 7 and len(TABLE_II) == 3 and len(set(TABLES)) == 10
    assert {variant.planner for variant in TABLES} == set(PLANNERS[:4])
    assert at_ratio(0.0) == TABLE_I[0] and at_ratio(2.0) == TABLE_I[1]
    assert at_ratio(2.0, priority_map="lpf") == TABLE_II[0]
    assert [at_ratio(ratio).ratio for ratio in SWEEP_RATIOS] == list(SWEEP_RATIOS)
    assert len(unique([*TABLES, *sweep()])) == 10 + 2 * len(SWEEP_RATIOS) - 3
    assert rows_of("ggwp") == [TABLE_I[6]]
    twins = with_refined(TABLE_II)
    assert twins[::2] == list(TABLE_II) and all(variant.refine for variant in twins[1::2])
    assert twins[1] == TABLE_II[0].refined != TABLE_II[0]
    assert {v.priority_map for v in rows_of("bezier")} == {"binary", "lpf"}


@pytest.mark.parametrize(
    ("arguments", "complaint"),
    [
        (("a-star", 1.0, 0.0), "planner .*lp-a-star.*'a-star'"),
        (("ggwp", -1.0, 0.0), "weights"),
        (("ggwp", 0.0, 0.0), "weights"),
        (("ggwp", float("nan"), 0.0), "weights"),
        (("ggwp", 1.0, 0.0, "blurred"), "priority_map"),
    ],
)
def test_a_bad_variant_is_refused(arguments: tuple[object, ...], complaint: str) -> None:
    with pytest.raises(ValueError, match=complaint):
        Variant(*arguments)  # type: ignore[arg-type]


def test_a_variant_has_weights_and_a_contender() -> None:
    variant = at_ratio(5.0, "ggwp+refine", "lpf")
    assert variant == Variant("ggwp", 0.5, 2.5, "lpf", refine=True)
    assert (variant.weights, variant.ratio) == (Weights(0.5, 2.5), 5.0)
    assert (variant.contender.name, variant.contender.title) == ("ggwp+refine", "GGWP, refined")
    assert Variant("ggwp", 0.0, 1.0).ratio == float("inf")
