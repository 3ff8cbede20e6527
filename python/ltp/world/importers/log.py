# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What every importer tells Python's logging: what it was asked, and what it found."""

import functools
import logging
import time
from collections.abc import Callable
from typing import ParamSpec

from ltp.world.world import World

Arguments = ParamSpec("Arguments")


def logged(read: Callable[Arguments, World]) -> Callable[Arguments, World]:
    """An importer that logs, under the name of its module."""
    log = logging.getLogger(read.__module__)

    @functools.wraps(read)
    def wrapper(*arguments: Arguments.args, **options: Arguments.kwargs) -> World:
        given = [str(value) for value in arguments] + [f"{k}={v}" for k, v in options.items()]
        log.info("reading %s", ", ".join(given))
        begun = time.perf_counter()
        world = read(*arguments, **options)
        log.info("%r after %.1f s", world, time.perf_counter() - begun)
        for finding in world.report:
            log.info("%s", finding)
        return world

    return wrapper
