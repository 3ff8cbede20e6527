# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writing a file so that a full disk, a crash or Ctrl-C leaves the old one whole."""

import contextlib
import os
import secrets
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO


@contextlib.contextmanager
def atomic_write(path: str | os.PathLike[str]) -> Iterator[BinaryIO]:
    """Give a binary file whose content appears under `path` all at once, or not at all.

    The bytes go to a temporary file in the folder of `path`, are flushed and synced to the disk,
    and take the name `path` in one step when the block ends. If anything is raised inside the block
    or on the way (a full disk, KeyboardInterrupt), the temporary file is removed, whatever stood
    under `path` before is untouched, and the exception goes on. A symbolic link is written through,
    not replaced.

    Raises:
        OSError: from the file system; its `filename` is `path` where the system gave none.
    """
    target = Path(path).resolve()
    temporary = target.with_name(f".ltp-{secrets.token_hex(8)}.tmp")
    try:
        with temporary.open("xb") as file:
            yield file
            file.flush()
            os.fsync(file.fileno())
        temporary.replace(target)
    except BaseException as error:
        with contextlib.suppress(OSError):
            temporary.unlink()
        if isinstance(error, OSError) and (
            error.filename is None or str(error.filename) == str(temporary)
        ):
            error.filename = str(path)  # a write that fails does not say which file it was
            error.filename2 = None
        raise
    _sync_folder(target.parent)


def _sync_folder(folder: Path) -> None:
    """Make the new name survive a power cut, where the system can sync a folder."""
    with contextlib.suppress(OSError):
        descriptor = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)
