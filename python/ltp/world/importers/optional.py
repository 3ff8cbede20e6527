# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Libraries that only the importers need: imported when used, missed with a message that helps."""

import importlib
from types import ModuleType

from ltp.installed import pip_install


def require(module: str, purpose: str, extra: str = "geo") -> ModuleType:
    """Import `module`, or say what is missing for `purpose` and how to get it.

    `module` is the dotted name, `purpose` starts the sentence ("reading GeoTIFF"), `extra` is the
    optional dependency set of this package that brings the module.

    Raises:
        ImportError: if the module cannot be imported; the message holds the pip command.
    """
    try:
        return importlib.import_module(module)
    except ImportError as error:
        package = module.partition(".")[0]
        raise ImportError(
            f"{purpose} needs {package}: {pip_install(extra)} ({error})", name=package
        ) from error
