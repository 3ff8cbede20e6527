# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A dataclass among a command's parameters becomes the options that are its fields."""

import inspect
from dataclasses import dataclass
from typing import Annotated

import pytest
import typer
from typer.testing import CliRunner

from ltp.cli.spread import spread


@dataclass(frozen=True)
class Box:
    width: Annotated[float, typer.Option(help="Width of the box.")] = 1.0
    height: Annotated[float, typer.Option("--height", "-h", help="Height of the box.")] = 2.0


@spread
def pack(*, first: int = 0, box: Box, last: str = "z") -> None:
    """Pack a box."""
    print(first, box, last)


def test_the_fields_stand_where_the_dataclass_stood() -> None:
    assert list(inspect.signature(pack).parameters) == ["first", "width", "height", "last"]
    assert pack.__doc__ == "Pack a box."


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ([], "0 Box(width=1.0, height=2.0) z\n"),
        (["--width", "3", "-h", "4", "--last", "y"], "0 Box(width=3.0, height=4.0) y\n"),
    ],
)
def test_the_command_gets_the_dataclass(given: list[str], said: str) -> None:
    app = typer.Typer()
    app.command()(pack)
    assert CliRunner().invoke(app, given).output == said
