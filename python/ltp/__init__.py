# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Local trajectory planning for autonomous UAV landing.

The public names stand in `ltp/_public.py`. They are loaded, numpy and the compiled core with them,
when the first of them is asked for: `ltp --help` needs none.
"""

import warnings
from typing import TYPE_CHECKING

from ltp.installed import warn_of_strangers

warn_of_strangers()
del warn_of_strangers

if TYPE_CHECKING:
    from ltp._public import *  # noqa: F403
else:

    def __getattr__(name):
        if name.startswith("__") and name not in ("__all__", "__version__"):
            raise AttributeError(f"module 'ltp' has no attribute {name!r}")
        public = _load()
        if name == "__all__" or name in public.__all__:
            return getattr(public, name)
        if name in public.OLD_NAMES:
            new = public.OLD_NAMES[name]
            text = f"`{name}` is now `{new}`; the old name goes with the next release"
            warnings.warn(text, DeprecationWarning, stacklevel=2)
            return getattr(public, new)
        if name in globals():  # a room, e.g. `ltp.sim`: it came with the names
            return globals()[name]
        raise AttributeError(f"module 'ltp' has no attribute {name!r}")

    def __dir__():
        return sorted({*_load().__all__, *globals()})

    def _load():
        from importlib import import_module

        return import_module("ltp._public")
