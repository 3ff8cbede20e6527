# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Errors in an option's value name the option, whatever the library calls its argument."""

import re
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def naming(*names: str, **others: str) -> Iterator[None]:
    """Tell mistakes in terms of options.

    Args:
        names: arguments of which the option has the same name: `max_gap` is told as `--max-gap`.
        others: arguments, or words of an error, of which it has another: `count="--paths"`.

    Raises:
        ValueError: in place of one raised within, each of the words replaced by its option.
    """
    options = {name: f"--{name.replace('_', '-')}" for name in names} | others
    # Not within a longer name, a file's path or an option.
    words = re.compile(rf"(?<![\w./-])({'|'.join(map(re.escape, options))})(?![\w/-]|\.\w)")
    try:
        yield
    except ValueError as error:
        raise ValueError(words.sub(lambda found: options[found[1]], str(error))) from error
