# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whatever a reader or a library under it raises on garbage, told as one error naming the file."""

import contextlib
import errno
import os
from collections.abc import Iterator

_LONGEST = 300  # of a message, which may hold what the file does


@contextlib.contextmanager
def blamed_on(path: str | os.PathLike[str], what: str) -> Iterator[None]:
    """Turn what is raised within, because of the bytes of a file, into one kind of error.

    Garbage makes parsers raise nearly anything: `RecursionError`, `MemoryError`, `zlib.error`,
    `struct.error`, a panic of a library written in Rust. What is not about the bytes goes on as it
    is: an `OSError` of the system, a missing library (`ImportError`), Ctrl-C.

    Args:
        path: of the file.
        what: it should be: "a sound world file".

    Raises:
        ValueError: "PATH is not WHAT: why"; one that begins with the path already goes on as it is.
    """
    try:
        yield
    except (KeyboardInterrupt, SystemExit, GeneratorExit, ImportError):
        raise
    except BaseException as error:
        if _of_the_system(error):
            raise
        if isinstance(error, ValueError) and str(error).startswith(str(path)):
            raise
        why = " ".join(str(error).split())[:_LONGEST] or type(error).__name__
        raise ValueError(f"{path} is not {what}: {why}") from error


def _of_the_system(error: BaseException) -> bool:
    """Whether the system failed, and not the file's content."""
    # EINVAL: the content led before the file's begin. Libraries raise theirs without a number.
    return isinstance(error, OSError) and error.errno not in (None, errno.EINVAL)
