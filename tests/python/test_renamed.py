# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What has moved is found under its old name, the very same, and the user is told once a place."""

import importlib
import subprocess
import sys
import warnings

import pytest

import ltp
from ltp import renamed


def run(statement: str) -> str:
    """What a fresh interpreter prints to stdout and stderr."""
    done = subprocess.run(
        [sys.executable, "-W", "default", "-c", statement],
        capture_output=True,
        text=True,
        check=True,
    )
    return done.stdout + done.stderr


def test_there_are_old_names() -> None:
    assert "ltp.world.geotiff" in renamed.MODULES
    assert "ltp.world.world_picture" in renamed.THINGS


@pytest.mark.parametrize("old", renamed.MODULES)
def test_an_old_module_is_the_new_one(old: str) -> None:
    sys.modules.pop(old, None)  # it warns at its first import only
    new = importlib.import_module(renamed.MODULES[old])
    spec = new.__spec__
    told = f"{old} has moved to {renamed.MODULES[old]}; its old name goes with the next release"
    with pytest.warns(DeprecationWarning) as warned:
        assert importlib.import_module(old) is new
    assert [str(warning.message) for warning in warned] == [told]
    assert new.__spec__ is spec
    assert new.__name__ == renamed.MODULES[old]


@pytest.mark.parametrize("old", renamed.THINGS)
def test_an_old_thing_is_the_new_one(old: str) -> None:
    room, _, name = old.rpartition(".")
    with pytest.warns(DeprecationWarning, match=f"{old} has moved to {renamed.THINGS[old]};"):
        found = getattr(importlib.import_module(room), name)
    assert found is getattr(importlib.import_module(renamed.THINGS[old]), name)


@pytest.mark.parametrize(
    "statement",
    [
        "import ltp.world.geotiff; read = ltp.world.geotiff.read",
        "import ltp.world.geotiff as geotiff; read = geotiff.read",
        "from ltp.world import geotiff; read = geotiff.read",
        "from ltp.world.geotiff import read",
        "import ltp.world; read = ltp.world.geotiff.read",
    ],
)
def test_an_import_works_however_it_is_written(statement: str) -> None:
    said = run(f"{statement}; print(read.__module__)")
    assert said.startswith("ltp.world.importers.geotiff")
    # The warning stands where the user wrote the name, not somewhere in this package.
    assert "<string>:1: DeprecationWarning: ltp.world.geotiff has moved" in said
    assert said.count("DeprecationWarning") == 1


def test_new_names_are_silent_and_wrong_ones_an_error() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        importlib.import_module("ltp.world.importers.geotiff")
        assert ltp.World is importlib.import_module("ltp.world").World
        with pytest.raises(AttributeError, match=r"'ltp\.world' has no attribute 'geotif'"):
            _ = importlib.import_module("ltp.world").geotif
        with pytest.raises(ModuleNotFoundError, match=r"ltp\.world\.geotif"):
            importlib.import_module("ltp.world.geotif")


def test_old_names_load_no_library_of_the_importers() -> None:
    code = (
        "import sys, ltp.world.geotiff, ltp.world.osm, ltp.world.point_cloud, ltp.drawing.picture\n"
        "heavy = {'matplotlib', 'scipy', 'rasterio', 'laspy', 'osmium', 'shapely', 'pyproj'}\n"
        "print(sorted(heavy & set(sys.modules)))"
    )
    assert run(code).startswith("[]\n")
