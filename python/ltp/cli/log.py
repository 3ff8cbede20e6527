# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The log of a command, `--log FILE`: all that the package tells Python's logging.

Loggers are named after modules (`ltp.sim.decisions`), so programs of your own may listen to them
without this.
"""

import sys
from collections.abc import Callable, Sequence
from pathlib import Path

_FORMAT = "%(asctime)s %(levelname)s %(name)s: %(message)s"


def log_to(path: Path, command: Sequence[str]) -> Callable[[], None]:
    """Add what is logged from now on to a file.

    Args:
        path: of the file; made if it is not there, gone on with if it is.
        command: to begin with.

    Returns:
        What ends it.

    Raises:
        OSError: if the file cannot be written.
    """
    import logging
    import shlex

    from ltp._core import __version__

    handler = logging.FileHandler(path, encoding="utf-8")
    handler.setFormatter(logging.Formatter(_FORMAT))
    logger = logging.getLogger("ltp")
    before = logger.level
    logger.addHandler(handler)
    logger.setLevel(logging.INFO)
    logging.getLogger(__name__).info("ltp %s: %s", __version__, shlex.join(command))

    def end() -> None:
        logger.removeHandler(handler)
        logger.setLevel(before)
        handler.close()

    return end


def log_mistake(error: BaseException) -> None:
    """Log why a command fails, with its traceback, if anybody listens."""
    if "logging" in sys.modules:
        import logging

        if logging.getLogger("ltp").handlers:
            logging.getLogger(__name__).error("%s", error, exc_info=error)
