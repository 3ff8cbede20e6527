# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""rerun, imported when it is used and missed with a message that helps."""

import importlib
import importlib.util
from types import ModuleType

from ltp.installed import pip_install


def has_rerun() -> bool:
    """Whether recordings can be made here."""
    return importlib.util.find_spec("rerun") is not None


def require_rerun(module: str = "rerun") -> ModuleType:
    """Import rerun, or one of its modules.

    Raises:
        ImportError: with the pip command, if rerun is not installed.
    """
    try:
        return importlib.import_module(module)
    except ImportError as error:
        raise ImportError(
            f"recordings need the rerun viewer: {pip_install('viewer')} ({error})", name="rerun"
        ) from error
