# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The core's options as Python sees them: every field listed, set, copied, and named in errors."""

import copy
import inspect

import pytest

import ltp
from ltp import _core

OPTIONS = [
    kind
    for kind in vars(_core).values()
    if inspect.isclass(kind) and (kind.__name__.endswith("Options") or "check" in vars(kind))
]
LISTED = [kind for kind in vars(_core).values() if hasattr(kind, "__fields__")]
DEPRECATED = {
    ltp.PlannerOptions: {"length_weight", "priority_weight", "pareto", "bug"},
    ltp.NavigationOptions: {"memory_widths"},
}


def test_there_are_options_to_look_at() -> None:
    assert {ltp.PlannerOptions, ltp.LidarOptions, ltp.LidarPattern} < set(OPTIONS)
    assert set(OPTIONS) < set(LISTED)
    assert len(OPTIONS) > 10


@pytest.mark.parametrize("kind", OPTIONS)
def test_every_attribute_that_can_be_set_is_listed(kind: type) -> None:
    writable = {
        name
        for name, value in vars(kind).items()
        if isinstance(value, property) and value.fset is not None
    }
    assert writable - DEPRECATED.get(kind, set()) == set(kind.__fields__)
    assert len(kind.__fields__) == len(set(kind.__fields__)) > 0


@pytest.mark.parametrize("kind", LISTED)
def test_every_field_is_explained(kind: type) -> None:
    assert kind.__fields__
    silent = [name for name in kind.__fields__ if not (getattr(kind, name).__doc__ or "").strip()]
    assert silent == []


@pytest.mark.parametrize("kind", OPTIONS)
def test_the_repr_shows_every_field(kind: type) -> None:
    text = repr(kind())
    assert text.startswith(f"{kind.__name__}(")
    assert all(f"{name}=" in text for name in kind.__fields__)


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy])
def test_a_copy_of_options_is_a_value_of_its_own(copied) -> None:
    first = ltp.PlannerOptions(refine=True)
    second = copied(first)
    second.weights.length = 3.0
    second.bezier.offsets = 5
    assert (first.weights.length, first.bezier.offsets) == (0.5, 41)
    assert (second.weights.length, second.bezier.offsets, second.refine) == (3.0, 5, True)


def test_keywords_are_fields() -> None:
    options = ltp.PlannerOptions(weights=ltp.PenaltyWeights(length=0.25, priority=2.0))
    assert (options.weights.length, options.weights.priority) == (0.25, 2.0)
    with pytest.raises(TypeError, match=r"PenaltyWeights has no field 'lenght'"):
        ltp.PenaltyWeights(lenght=1.0)
    with pytest.raises(TypeError):
        ltp.PlannerOptions(weights=(0.25, 2.0))


@pytest.mark.parametrize(
    ("weights", "culprit"),
    [
        ({"length": -1.0}, "weights.length = -1"),
        ({"priority": float("nan")}, "weights.priority = "),
        ({"length": 0.0, "priority": 0.0}, r"weights.length \+ weights.priority = 0"),
    ],
)
def test_wrong_weights_are_named(weights: dict[str, float], culprit: str) -> None:
    wrong = ltp.PenaltyWeights(**weights)
    for check in (wrong.check, ltp.PlannerOptions(weights=wrong).check):
        with pytest.raises(ValueError, match=culprit):
            check()


@pytest.mark.parametrize("name", ["length", "priority"])
def test_the_old_names_of_the_weights_say_the_new_ones(name: str) -> None:
    old = f"{name}_weight"
    with pytest.warns(DeprecationWarning, match=rf"`{old}` is now `weights\.{name}`") as caught:
        options = ltp.PlannerOptions(**{old: 0.25})
    assert len(caught) == 1
    assert getattr(options.weights, name) == 0.25
    with pytest.warns(DeprecationWarning, match=old) as caught:
        setattr(options, old, 0.75)
    assert [warning.filename for warning in caught] == [__file__]
    assert getattr(options.weights, name) == 0.75
    with pytest.warns(DeprecationWarning, match=old):
        assert getattr(options, old) == 0.75
    assert old not in repr(options)


def test_the_old_weights_of_a_penalty_say_the_new_ones() -> None:
    tally = ltp.PathTally()
    weights = ltp.PenaltyWeights(length=0.25, priority=2.0)
    with pytest.warns(DeprecationWarning, match=r"weights=PenaltyWeights"):
        old = ltp.penalty(tally, 0.0, length_weight=0.25, priority_weight=2.0)
    assert old == ltp.penalty(tally, 0.0, weights) == 0.25
