# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Old names of modules and of what is in them: they work for one release more, with a warning."""

import importlib
import sys
import warnings
from collections.abc import Callable, Sequence
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec
from types import ModuleType

#: Old name of a module -> where it is now.
MODULES = {
    "ltp.world.geotiff": "ltp.world.importers.geotiff",
    "ltp.world.osm": "ltp.world.importers.osm",
    "ltp.world.picture": "ltp.drawing.picture",
    "ltp.world.point_cloud": "ltp.world.importers.las",
    "ltp.world.shading": "ltp.drawing.shading",
}

#: Old name of a thing in a module -> module where it is now; it is still called the same.
THINGS = {
    "ltp.world.world_picture": "ltp.drawing.picture",
}


class _OldModules(MetaPathFinder, Loader):
    """Python asks here last: finds the new module under its old name."""

    def find_spec(
        self, name: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        return ModuleSpec(name, self) if name in MODULES else None

    def exec_module(self, module: ModuleType) -> None:
        # What a module leaves under its name is what the importer gets.
        sys.modules[module.__name__] = _moved(module.__name__, MODULES[module.__name__], 2)


def old_names(module: str) -> Callable[[str], object]:
    """The `__getattr__` of a package that some of `MODULES` and `THINGS` have left.

    From then on `import` finds the modules too, however it is written.
    """
    if not any(isinstance(finder, _OldModules) for finder in sys.meta_path):
        sys.meta_path.append(_OldModules())

    def find(name: str) -> object:
        old = f"{module}.{name}"
        if old in MODULES:
            return _moved(old, MODULES[old], 2)
        if old in THINGS:
            return getattr(_moved(old, THINGS[old], 2), name)
        raise AttributeError(f"module {module!r} has no attribute {name!r}")

    return find


def _moved(old: str, now: str, depth: int) -> ModuleType:
    """The module `now`, and a warning where the user wrote `old`, `depth` calls above."""
    warnings.warn(
        f"{old} has moved to {now}; its old name goes with the next release",
        DeprecationWarning,
        stacklevel=depth + 1,
    )
    return importlib.import_module(now)
