# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every help text is a sentence with a subject, and the shared options are the same everywhere."""

import re
from collections.abc import Iterator
from dataclasses import fields
from typing import Any

import pytest
from typer.main import get_command

from ltp.cli import app
from ltp.cli.global_paths import GlobalPaths
from ltp.evaluation.scenarios import ScenarioOptions

from .runner import succeed

#: Words that begin a fragment: prepositions, pronouns and conjunctions that want a noun before.
FRAGMENTS = {
    *("About", "Above", "After", "Also", "As", "At", "Before", "Below", "Between", "By", "During"),
    *("For", "From", "If", "In", "Instead", "Into", "Of", "On", "Over", "Through", "To", "Under"),
    *("Until", "Up", "When", "Where", "With", "Within", "Without"),
    *("How", "That", "What", "Which", "Who", "Whose", "Why"),
}


def walk(command: Any = None, path: tuple[str, ...] = ()) -> Iterator[tuple[str, Any]]:
    """Every command and group, by what is typed to reach it."""
    command = command or get_command(app)
    yield " ".join(("ltp", *path)), command
    for name, below in getattr(command, "commands", {}).items():
        yield from walk(below, (*path, name))


COMMANDS = dict(walk())


def options(command: Any) -> list[Any]:
    return [parameter for parameter in command.params if parameter.name != "help"]


def faults(text: str) -> list[str]:
    """What keeps a help text from being a sentence with a subject."""
    first = re.split(r"\W", text, maxsplit=1)[0]
    found = []
    if not text[:1].isupper():
        found.append("no capital letter in front")
    if not text.endswith("."):
        found.append("no full stop at the end")
    if first in FRAGMENTS:
        found.append(f"begins with {first!r}")
    return found


@pytest.mark.parametrize(
    ("text", "sound"),
    [
        ("Seed of the set of global paths.", True),
        ("Keep each flight's record too, for replays.", True),
        ("Of the set of global paths.", False),
        ("That flies and is judged.", False),
        ("How many to record.", False),
        ("Which of the seeded global paths, from 0.", False),
        ("`planar` or `open`.", False),
        (".png, .pdf or .svg", False),
        ("Priority maps (default: all)", False),
        ("", False),
    ],
)
def test_a_fragment_is_told_from_a_sentence(text: str, sound: bool) -> None:
    assert (faults(text) == []) is sound


def test_every_option_is_explained_by_a_sentence() -> None:
    wrong = {
        f"{name} {option.name}": found
        for name, command in COMMANDS.items()
        for option in options(command)
        # typer 0.16 beside a new click loses the help of arguments.
        if option.help is not None or option.param_type_name != "argument"
        if (found := faults(option.help or ""))
    }
    assert wrong == {}
    assert sum(len(options(command)) for command in COMMANDS.values()) > 100


def test_every_command_is_summed_up_in_one_sentence() -> None:
    summaries = {name: command.help.partition("\n\n")[0] for name, command in COMMANDS.items()}
    assert {name: found for name, text in summaries.items() if (found := faults(text))} == {}
    assert [name for name, text in summaries.items() if re.search(r"\. +\S", text)] == []
    assert len(summaries) > 25


@pytest.mark.parametrize("name", [name for name in COMMANDS if hasattr(COMMANDS[name], "commands")])
def test_no_summary_is_cut_in_a_list_of_80_columns(name: str) -> None:
    said = succeed(*name.split()[1:], "--help")
    below = COMMANDS[name].commands
    assert len(below) > 1
    for command, text in ((key, value.help.partition("\n\n")[0]) for key, value in below.items()):
        assert re.search(rf"^  {command} +{re.escape(text)}$", said, re.MULTILINE), command


def test_the_global_paths_are_the_same_options_in_the_same_order_everywhere() -> None:
    names = [item.name for item in fields(GlobalPaths)]
    users = {}
    for name, command in COMMANDS.items():
        found = [option for option in options(command) if option.name in names]
        if len(found) > 3:
            users[name] = [(option.name, option.help, option.default) for option in found]
    assert set(users) == {
        "ltp fly",
        "ltp evaluate",
        "ltp gap",
        "ltp regret",
        *(f"ltp figure {kind}" for kind in ("paths", "scenarios", "sensing", "summary")),
    }
    assert all(found == users["ltp fly"] for found in users.values())
    assert [name for name, _, _ in users["ltp fly"]] == names


def test_the_global_paths_have_the_defaults_of_the_library() -> None:
    assert GlobalPaths().options(50) == ScenarioOptions()
