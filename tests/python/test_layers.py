# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The floors of the house: a file may use its own room or a lower floor, never its neighbours."""

import ast
import os
import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest

ROOT = Path(__file__).parents[2]

# Bottom to top. Rooms on one floor do not know each other.
CPP_FLOORS = [
    {"geometry"},
    {"grid"},
    {"sensing", "mapping", "cost"},
    {"planning"},
    {"navigation"},
    {"bindings"},
]
PYTHON_FLOORS = [
    {"_core", "files"},
    {"world", "config", "planners"},
    {"sim"},
    {"landing", "bridges"},
    {"evaluation", "viewer"},
    {"__init__"},  # the public names, for the users of the package and the command line
    {"cli"},
    {"__main__"},
]


class Use(NamedTuple):
    """One file's use of a room."""

    where: str  # file:line
    user: str  # the room that the file is in
    used: str


def complaints(uses: list[Use], floors: list[set[str]]) -> list[str]:
    """The uses that the house does not allow, one sentence each."""
    floor_of = {room: floor for floor, rooms in enumerate(floors) for room in rooms}
    found = []
    for use in uses:
        unknown = [room for room in (use.user, use.used) if room not in floor_of]
        if unknown:
            found.append(f"{use.where}: {unknown[0]} has no floor")
        elif use.used != use.user and floor_of[use.used] >= floor_of[use.user]:
            found.append(f"{use.where}: {use.user} must not know {use.used}")
    return found


def cpp_files(root: Path) -> list[Path]:
    return sorted(path for path in (root / "cpp").rglob("*.[ch]pp"))


def cpp_room(root: Path, path: Path) -> str:
    """The folder below cpp/include/ltp or cpp/src that holds a file, or its own name if none."""
    inside = path.relative_to(root / "cpp").parts
    return inside[2] if inside[:2] == ("include", "ltp") else inside[1]


def cpp_uses(root: Path) -> list[Use]:
    """Every include of the project's own headers; a file also stands for its own room."""
    uses = []
    for path in cpp_files(root):
        user = cpp_room(root, path)
        uses.append(Use(f"{path.relative_to(root)}:1", user, user))
        for number, line in enumerate(path.read_text().splitlines(), start=1):
            match = re.match(r'\s*#\s*include\s*(?:"([^"]+)"|<(ltp/[^>]+)>)', line)
            if not match:
                continue
            header = match[1] or match[2]
            folder = root / "cpp/include" if header.startswith("ltp/") else path.parent
            target = Path(os.path.normpath(folder / header))
            uses.append(Use(f"{path.relative_to(root)}:{number}", user, cpp_room(root, target)))
    return uses


def python_files(root: Path) -> list[Path]:
    return sorted((root / "python/ltp").rglob("*.py"))


def imported_modules(tree: ast.AST, package: list[str]) -> Iterator[tuple[int, list[str]]]:
    """Line and dotted name of each import, wherever it stands; `from a import b` gives a.b."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            for alias in node.names:
                yield node.lineno, alias.name.split(".")
        elif isinstance(node, ast.ImportFrom):
            base = package[: len(package) - node.level + 1] if node.level else []
            base = base + (node.module.split(".") if node.module else [])
            for alias in node.names:
                yield node.lineno, [*base, alias.name]
        elif isinstance(node, ast.Call) and node.args:
            name = node.func.attr if isinstance(node.func, ast.Attribute) else ""
            name = node.func.id if isinstance(node.func, ast.Name) else name
            value = getattr(node.args[0], "value", None)
            if name in ("import_module", "__import__") and isinstance(value, str):
                yield node.lineno, value.split(".")


def python_uses(root: Path) -> list[Use]:
    """Every import of the package's own modules; a file also stands for its own room."""
    uses = []
    known = {room for rooms in PYTHON_FLOORS for room in rooms}
    folder = root / "python/ltp"
    known |= {path.stem for path in folder.glob("*.py")} | {path.name for path in folder.iterdir()}
    for path in python_files(root):
        inside = path.relative_to(folder)
        user = inside.parts[0].removesuffix(".py")
        uses.append(Use(f"{path.relative_to(root)}:1", user, user))
        package = ["ltp", *inside.parts[:-1]]
        for line, module in imported_modules(ast.parse(path.read_text()), package):
            if module[0] != "ltp":
                continue
            # `from ltp import World` asks the package's root, `from ltp import world` the room.
            used = module[1] if len(module) > 1 and module[1] in known else "__init__"
            uses.append(Use(f"{path.relative_to(root)}:{line}", user, used))
    return uses


def test_cpp_floors() -> None:
    uses = cpp_uses(ROOT)
    assert complaints(uses, CPP_FLOORS) == []
    assert {use.user for use in uses} == set().union(*CPP_FLOORS)
    assert len(uses) > 2 * len(cpp_files(ROOT)) > 60


def test_python_floors() -> None:
    uses = python_uses(ROOT)
    assert complaints(uses, PYTHON_FLOORS) == []
    assert {use.user for use in uses} >= {"__init__", "files", "world", "sim", "evaluation", "cli"}
    assert len(uses) > 2 * len(python_files(ROOT)) > 60


def test_octomap_has_one_door() -> None:
    pattern = re.compile(r"#\s*include\s*[<\"]octomap")
    users = [path for path in cpp_files(ROOT) if pattern.search(path.read_text())]
    assert users == [ROOT / "cpp/src/grid/octree_file.cpp"]


def write(root: Path, name: str, text: str) -> None:
    (root / name).parent.mkdir(parents=True, exist_ok=True)
    (root / name).write_text(text)


@pytest.mark.parametrize(
    ("name", "include", "complaint"),
    [
        ("include/ltp/grid/a.hpp", '"ltp/geometry/types.hpp"', None),
        ("include/ltp/grid/a.hpp", '"ltp/grid/b.hpp"', None),
        ("src/grid/a.cpp", '"b.hpp"', None),
        ("src/grid/a.cpp", "<vector>", None),
        ("include/ltp/grid/a.hpp", '"ltp/planning/planner.hpp"', "grid must not know planning"),
        ("src/cost/a.cpp", "<ltp/mapping/m.hpp>", "cost must not know mapping"),
        ("src/cost/a.cpp", '"../sensing/private.hpp"', "cost must not know sensing"),
        ("src/navigation/a.cpp", '"../bindings/b.hpp"', "navigation must not know bindings"),
        ("src/magic/a.cpp", '"ltp/grid/b.hpp"', "magic has no floor"),
        ("include/ltp/all.hpp", "<vector>", "all.hpp has no floor"),
    ],
)
def test_a_planted_include_is_found(
    tmp_path: Path, name: str, include: str, complaint: str | None
) -> None:
    write(tmp_path, f"cpp/{name}", f"// a file\n#include {include}\n")
    found = complaints(cpp_uses(tmp_path), CPP_FLOORS)
    if complaint is None:
        assert found == []
    else:
        assert found
        assert found[-1].startswith(f"cpp/{name}:")
        assert found[-1].endswith(f": {complaint}")


@pytest.mark.parametrize(
    ("name", "text", "complaint"),
    [
        ("sim/mission.py", "from ltp._core import Pose", None),
        ("sim/mission.py", "from .guidance import x\nfrom ..world import World", None),
        ("evaluation/tables.py", "def f():\n    from ltp.sim.record import FlightRecord", None),
        ("__init__.py", "from ltp.sim.mission import fly", None),
        ("cli/main.py", "import ltp\nimport ltp.viewer.rerun", None),
        ("world/a.py", "import numpy as np\nimport ltplike.sim", None),
        ("world/a.py", "import ltp.sim.mission", "world must not know sim"),
        ("world/a.py", "from ltp import config", "world must not know config"),
        ("world/a.py", "from ltp import World", "world must not know __init__"),
        ("world/a.py", "from .. import planners", "world must not know planners"),
        ("world/sub/a.py", "from ...sim import record", "world must not know sim"),
        ("files.py", "def f():\n    from ltp._core import Raster", "files must not know _core"),
        ("sim/a.py", "class A:\n    import ltp.viewer.rerun as r", "sim must not know viewer"),
        (
            "viewer/a.py",
            "import importlib\nimportlib.import_module('ltp.evaluation.tables')",
            "viewer must not know evaluation",
        ),
        ("__init__.py", "from ltp.cli import main", "__init__ must not know cli"),
        ("magic/a.py", "from ltp import world", "magic has no floor"),
        ("magic.py", "", "magic has no floor"),
        ("cli/main.py", "from ltp import magic", "magic has no floor"),
    ],
)
def test_a_planted_import_is_found(
    tmp_path: Path, name: str, text: str, complaint: str | None
) -> None:
    write(tmp_path, f"python/ltp/{name}", text)
    if "from ltp import magic" in text:
        (tmp_path / "python/ltp/magic").mkdir()
    found = complaints(python_uses(tmp_path), PYTHON_FLOORS)
    if complaint is None:
        assert found == []
    else:
        assert found
        assert found[-1].startswith(f"python/ltp/{name}:")
        assert found[-1].endswith(f": {complaint}")
