# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What commands say on the terminal, and the files that they write."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

import typer

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from rich.console import Console
    from rich.table import Table

    from ltp.world import World

GREY = "bright_black"


@cache
def console() -> "Console":
    """The terminal; made when first needed, as `rich` takes longer to load than typer."""
    from rich.console import Console

    return Console(highlight=False)


def say(text: str, style: str | None = None) -> None:
    """Print a text as it stands."""
    console().print(text, style=style, markup=False)


def note(text: str) -> None:
    """Tell on stderr what is no part of the answer."""
    typer.echo(f"ltp: {text}", err=True)


def remark(text: str) -> None:
    """Print what explains the numbers above it, in grey."""
    say(text, GREY)


def tell(what: str, path: Path) -> None:
    """Say where a file was written."""
    console().print(f"{what:<12} {path}", markup=False, soft_wrap=True)


def tell_report(world: "World") -> None:
    """Print what the import of a world read, guessed and dropped, a line each."""
    for finding in world.report:
        console().print(f"  {finding}", markup=False, soft_wrap=True)


def tell_recording(path: Path) -> None:
    """Say where a recording was written, and how to look at it."""
    tell("recording", path)
    console().print(f"{'':<12} open it with: ltp replay {path}", markup=False, soft_wrap=True)


@contextmanager
def resumable(folder: Path, done: str) -> Iterator[None]:
    """Say after Ctrl-C that what was `done` is not lost."""
    try:
        yield
    except KeyboardInterrupt:
        say(f"stopped; what was {done} is kept in {folder}: the same command goes on")
        raise


def narrow_table(title: str, columns: Sequence[str]) -> "Table":
    """A table for the terminal: names at the left, numbers at the right of their columns."""
    from rich import box
    from rich.table import Table

    table = Table(title=title, title_justify="left", box=box.SIMPLE_HEAD, padding=0)
    for index, name in enumerate(columns):
        table.add_column(name, justify="right" if index else "left", no_wrap=True)
    return table


def write_text(text: str, path: Path) -> None:
    """Write a file, all or nothing."""
    from ltp.files import atomic_write

    with atomic_write(path) as file:
        file.write(text.encode())


def write_figure(figure: "Figure", out: Path) -> None:
    """Write a picture, its folder too, and say where."""
    from ltp.evaluation.figures.backdrop import save_figure

    out.parent.mkdir(parents=True, exist_ok=True)
    save_figure(figure, out)
    tell("figure", out)
