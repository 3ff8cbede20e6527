# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The `ltp` application: its help, and how mistakes are told in one line."""

import os
from typing import Any

import typer
from typer.core import TyperGroup

from .log import log_mistake
from .output import note

#: Set to anything, this environment variable lets a mistake show its whole traceback.
TRACEBACK = "LTP_TRACEBACK"

_INTERRUPTED = 130  # the shell's status of a command ended by Ctrl-C


class PoliteGroup(TyperGroup):
    """Tells a user's mistakes in one line, with exit status 2, instead of a traceback."""

    def invoke(self, ctx: Any) -> Any:
        """Run the command."""
        try:
            return super().invoke(ctx)
        except (typer.Exit, typer.Abort, BrokenPipeError):
            raise  # no mistakes: the end of `--help`, `ltp ... | head`
        except KeyboardInterrupt:
            note("interrupted")
            raise typer.Exit(_INTERRUPTED) from None
        except (ValueError, OSError, ImportError, RuntimeError, MemoryError) as error:
            log_mistake(error)
            if TRACEBACK in os.environ:
                raise
            note(f"error: {_one_line(error)}")
            raise typer.Exit(2) from error


def make_group(name: str, text: str) -> typer.Typer:
    """A command with commands below it.

    Its help is plain text: boxes and colours would take longer to load than all else in `--help`.
    """
    return typer.Typer(
        name=name,
        cls=PoliteGroup,
        help=text,
        no_args_is_help=True,
        add_completion=False,
        pretty_exceptions_enable=False,
        rich_markup_mode=None,
        context_settings={"max_content_width": 100},
    )


def _one_line(error: BaseException) -> str:
    if isinstance(error, OSError) and error.strerror:
        return f"{error.filename}: {error.strerror}" if error.filename else error.strerror
    text = " ".join(str(error).split()) or type(error).__name__
    return f"not enough memory: {text}" if isinstance(error, MemoryError) else text
