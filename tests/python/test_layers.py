# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The floors of the house: a file may use its own room or a lower floor, never its neighbours.

And nowhere a circle, not even between the files of one room.
"""

import ast
import graphlib
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
# Inside planning: its files at the top, its folders, and the registry above all of them.
PLANNING_FLOORS = [
    {"budget"},
    {"planner"},
    {"altitudes", "column_scene"},
    {"gate_region"},
    {"grid_planner"},
    {"search"},
    {"additive"},
    {"exact"},
    {"planners/"},
    {"planners"},
]
PYTHON_FLOORS = [
    {"_core", "brief", "files", "installed", "renamed"},
    {"world", "registry"},
    {"config"},
    {"sim", "drawing"},
    {"landing", "bridges"},
    {"evaluation", "viewer"},
    {"_public"},  # the public names
    {"__init__"},  # hands them to the users of the package, when they ask
    {"cli"},
    {"__main__"},
]
# Inside evaluation; a file outside of the folders belongs to all of them.
EVALUATION_FLOORS = [{"shared"}, {"campaign", "gap"}, {"regret"}, {"figures"}, {"__init__"}]


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
        for number, target in included_files(root, path):
            uses.append(Use(f"{path.relative_to(root)}:{number}", user, cpp_room(root, target)))
    return uses


def included_files(root: Path, path: Path) -> Iterator[tuple[int, Path]]:
    """Line and file of each include of the project's own headers."""
    for number, line in enumerate(path.read_text().splitlines(), start=1):
        match = re.match(r'\s*#\s*include\s*(?:"([^"]+)"|<(ltp/[^>]+)>)', line)
        if match:
            header = match[1] or match[2]
            first = header.split("/")[0] if "/" in header else ".."
            folder = {"ltp": root / "cpp/include", "..": path.parent}.get(first, root / "cpp/src")
            yield number, Path(os.path.normpath(folder / header))


def planning_room(root: Path, path: Path) -> str | None:
    """The part of planning that a file belongs to; None outside of planning."""
    for folder in ("cpp/include/ltp/planning", "cpp/src/planning"):
        if path.is_relative_to(root / folder):
            inside = path.relative_to(root / folder)
            names = {"planners": "planners/"}  # one planner each; planners.hpp is the registry
            first = inside.parts[0]
            return inside.stem if len(inside.parts) == 1 else names.get(first, first)
    return None


def planning_uses(root: Path) -> list[Use]:
    """Every include from planning to planning; a file also stands for its own part."""
    uses = []
    for path in cpp_files(root):
        user = planning_room(root, path)
        if user is None:
            continue
        uses.append(Use(f"{path.relative_to(root)}:1", user, user))
        for number, target in included_files(root, path):
            used = planning_room(root, target)
            if used is not None:
                uses.append(Use(f"{path.relative_to(root)}:{number}", user, used))
    return uses


def private_includes(root: Path) -> list[str]:
    """The installed headers that need one that is not installed, one sentence each."""
    return [
        f"{path.relative_to(root)}:{number}: {target.relative_to(root)} is private"
        for path in cpp_files(root)
        if path.is_relative_to(root / "cpp/include")
        for number, target in included_files(root, path)
        if not target.is_relative_to(root / "cpp/include")
    ]


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


def evaluation_room(parts: list[str]) -> str:
    """The folder below ltp/evaluation that holds a module; `__init__` for the public names."""
    folder = ROOT / "python/ltp/evaluation"
    if not parts or parts[0] == "__init__":
        return "__init__"
    if (folder / parts[0]).is_dir():
        return parts[0]
    return "shared" if (folder / f"{parts[0]}.py").exists() else "__init__"


def evaluation_uses(root: Path) -> list[Use]:
    """As `python_uses`, between the folders of ltp/evaluation."""
    uses = []
    folder = root / "python/ltp/evaluation"
    for path in sorted(folder.rglob("*.py")):
        inside = list(path.relative_to(folder).with_suffix("").parts)
        user = evaluation_room(inside)
        uses.append(Use(f"{path.relative_to(root)}:1", user, user))
        package = ["ltp", "evaluation", *inside[:-1]]
        for line, module in imported_modules(ast.parse(path.read_text()), package):
            if module[:2] == ["ltp", "evaluation"]:
                where = f"{path.relative_to(root)}:{line}"
                uses.append(Use(where, user, evaluation_room(module[2:])))
    return uses


def test_cpp_floors() -> None:
    uses = cpp_uses(ROOT)
    assert complaints(uses, CPP_FLOORS) == []
    assert {use.user for use in uses} == set().union(*CPP_FLOORS)
    assert len(uses) > 2 * len(cpp_files(ROOT)) > 60


def test_planning_floors() -> None:
    uses = planning_uses(ROOT)
    assert complaints(uses, PLANNING_FLOORS) == []
    assert {use.user for use in uses} == set().union(*PLANNING_FLOORS)
    assert len(uses) > 200


def test_installed_headers_need_no_private_ones() -> None:
    assert private_includes(ROOT) == []


def test_planning_installs_what_its_users_include_and_no_more() -> None:
    """The interface, the driver for planners of one's own, the registry; a header a planner."""
    public, sources = ROOT / "cpp/include/ltp/planning", ROOT / "cpp/src/planning"
    assert {path.name for path in public.iterdir()} == {
        "budget.hpp",
        "planner.hpp",
        "altitudes.hpp",
        "column_scene.hpp",
        "gate_region.hpp",
        "grid_planner.hpp",
        "planners.hpp",
        "planners",
    }
    headers = {path.stem for path in (public / "planners").iterdir()}
    assert len(headers) > 5
    beside = {path.name for path in (sources / "planners").iterdir()}
    assert beside == {f"{name}.cpp" for name in headers} | {"refine.cpp", "refine.hpp"}


def test_python_floors() -> None:
    uses = python_uses(ROOT)
    assert complaints(uses, PYTHON_FLOORS) == []
    assert {use.user for use in uses} >= {"__init__", "files", "world", "sim", "evaluation", "cli"}
    assert len(uses) > 2 * len(python_files(ROOT)) > 60


def test_evaluation_floors() -> None:
    uses = evaluation_uses(ROOT)
    assert complaints(uses, EVALUATION_FLOORS) == []
    assert {use.user for use in uses} == set().union(*EVALUATION_FLOORS)
    assert len(uses) > 60


def test_octomap_has_one_door() -> None:
    pattern = re.compile(r"#\s*include\s*[<\"]octomap")
    users = [path for path in cpp_files(ROOT) if pattern.search(path.read_text())]
    assert users == [ROOT / "cpp/src/grid/octree.cpp"]


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
    ("name", "include", "complaint"),
    [
        ("src/planning/exact/a.cpp", '"planning/additive/b.hpp"', None),
        ("src/planning/planners/a.cpp", '"ltp/planning/planners/b.hpp"', None),
        ("src/planning/planners.cpp", '"planning/planners/refine.hpp"', None),
        ("src/planning/search/a.cpp", '"ltp/grid/frame.hpp"', None),
        ("src/planning/search/a.cpp", '"planning/exact/b.hpp"', "search must not know exact"),
        ("src/planning/search/a.cpp", '"../exact/b.hpp"', "search must not know exact"),
        (
            "src/planning/exact/a.cpp",
            '"ltp/planning/planners/b.hpp"',
            "exact must not know planners/",
        ),
        (
            "include/ltp/planning/planners/a.hpp",
            '"ltp/planning/planners.hpp"',
            "planners/ must not know planners",
        ),
        (
            "include/ltp/planning/planner.hpp",
            "<ltp/planning/grid_planner.hpp>",
            "planner must not know grid_planner",
        ),
        ("src/planning/magic.cpp", "<vector>", "magic has no floor"),
    ],
)
def test_a_planted_include_inside_planning_is_found(
    tmp_path: Path, name: str, include: str, complaint: str | None
) -> None:
    write(tmp_path, f"cpp/{name}", f"#include {include}\n")
    found = complaints(planning_uses(tmp_path), PLANNING_FLOORS)
    if complaint is None:
        assert found == []
    else:
        assert found[-1].startswith(f"cpp/{name}:")
        assert found[-1].endswith(f": {complaint}")


def test_a_planted_private_include_is_found(tmp_path: Path) -> None:
    write(tmp_path, "cpp/include/ltp/planning/a.hpp", '#include "planning/search/flood.hpp"\n')
    write(tmp_path, "cpp/include/ltp/planning/b.hpp", '#include "ltp/planning/a.hpp"\n')
    assert private_includes(tmp_path) == [
        "cpp/include/ltp/planning/a.hpp:1: cpp/src/planning/search/flood.hpp is private"
    ]


@pytest.mark.parametrize(
    ("name", "text", "complaint"),
    [
        ("sim/mission.py", "from ltp._core import Pose", None),
        ("sim/mission.py", "from .guidance import x\nfrom ..world import World", None),
        ("evaluation/tables.py", "def f():\n    from ltp.sim.record import FlightRecord", None),
        ("_public.py", "from ltp.sim.mission import fly", None),
        ("__init__.py", "import importlib\nimportlib.import_module('ltp._public')", None),
        ("_public.py", "import ltp.cli", "_public must not know cli"),
        ("cli/main.py", "import ltp\nimport ltp.viewer.rerun", None),
        ("world/a.py", "import numpy as np\nimport ltplike.sim", None),
        ("world/a.py", "import ltp.sim.mission", "world must not know sim"),
        ("world/a.py", "from ltp import config", "world must not know config"),
        ("world/a.py", "from ltp import World", "world must not know __init__"),
        ("world/a.py", "from .. import registry", "world must not know registry"),
        ("world/sub/a.py", "from ...sim import record", "world must not know sim"),
        ("files.py", "def f():\n    from ltp._core import Raster", "files must not know _core"),
        ("sim/a.py", "class A:\n    import ltp.viewer.rerun as r", "sim must not know viewer"),
        (
            "viewer/a.py",
            "import importlib\nimportlib.import_module('ltp.evaluation.campaign.tables')",
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


@pytest.mark.parametrize(
    ("name", "text", "complaint"),
    [
        ("gap/a.py", "from ..scenarios import Scenario\nfrom .rows import GapRow", None),
        ("figures/a.py", "from ..gap.rows import GapRow\nimport ltp.evaluation.campaign", None),
        ("__init__.py", "from .campaign import Campaign", None),
        ("journal.py", "from .campaign.rows import FlightRow", "shared must not know campaign"),
        ("gap/a.py", "from ltp.evaluation.campaign import x", "gap must not know campaign"),
        ("campaign/a.py", "def f():\n    from .. import gap", "campaign must not know gap"),
        ("gap/a.py", "from ..figures.backdrop import INK", "gap must not know figures"),
        ("figures/a.py", "from ltp.evaluation import Variant", "figures must not know __init__"),
    ],
)
def test_a_planted_import_inside_evaluation_is_found(
    tmp_path: Path, name: str, text: str, complaint: str | None
) -> None:
    write(tmp_path, f"python/ltp/evaluation/{name}", text)
    found = complaints(evaluation_uses(tmp_path), EVALUATION_FLOORS)
    if complaint is None:
        assert found == []
    else:
        assert found[-1].startswith(f"python/ltp/evaluation/{name}:")
        assert found[-1].endswith(f": {complaint}")


# --- circles ---

Graph = dict[str, set[str]]  # file -> the files that it uses


def circles(graph: Graph) -> list[str]:
    """Circles in a graph, each as a chain of files; once each is cut somewhere, none is left."""
    graph = {file: set(used) for file, used in graph.items()}
    found = []
    while True:
        try:
            graphlib.TopologicalSorter(graph).prepare()
        except graphlib.CycleError as error:
            ring = error.args[1][:0:-1]  # each uses the next, the last the first
            start = ring.index(min(ring))
            ring = ring[start:] + ring[:start]
            found.append(" -> ".join([*ring, ring[0]]))
            graph[ring[-1]].remove(ring[0])
        else:
            return found


def cpp_graph(root: Path) -> Graph:
    """Who includes whom."""
    return {
        str(path.relative_to(root)): {
            os.path.relpath(target, root) for _, target in included_files(root, path)
        }
        for path in cpp_files(root)
    }


def python_graph(root: Path) -> Graph:
    """Who imports whom, wherever the import stands: in a function, or for type checkers only.

    A package stands for its `__init__.py`, which also runs for whoever imports a file of it from
    outside; the compiled module stands for its stub.
    """
    folder = root / "python"
    files = {}  # dotted name -> file
    for path in [*python_files(root), *(folder / "ltp").glob("*.pyi")]:
        parts = path.relative_to(folder).with_suffix("").parts
        files[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    graph: Graph = {str(path.relative_to(root)): set() for path in files.values()}
    for path in python_files(root):
        package = list(path.relative_to(folder).parts[:-1])
        for _, module in imported_modules(ast.parse(path.read_text()), package):
            # `from a import b` asks for the file a.b, or else for a name in a.
            name = module if ".".join(module) in files else module[:-1]
            if ".".join(name) not in files:
                continue
            outer = [name[:n] for n in range(1, len(name)) if name[:n] != package[:n]]
            used = {str(files[".".join(part)].relative_to(root)) for part in [*outer, name]}
            graph[str(path.relative_to(root))] |= used - {str(path.relative_to(root))}
    return graph


def test_no_circle_in_cpp() -> None:
    graph = cpp_graph(ROOT)
    assert circles(graph) == []
    assert sum(map(len, graph.values())) > 2 * len(graph) > 60


def test_no_circle_in_python() -> None:
    graph = python_graph(ROOT)
    assert circles(graph) == []
    assert sum(map(len, graph.values())) > 2 * len(graph) > 60


def chain(folder: str, files: str | None) -> list[str]:
    """How `circles` tells of a circle of files, if there is one."""
    return [" -> ".join(f"{folder}/{name}" for name in files.split())] if files else []


@pytest.mark.parametrize(
    ("files", "circle"),
    [
        ({"a.py": "from .b import x", "b.py": "from ltp._core import Pose"}, None),
        ({"a.py": "from .b import x", "b.py": "from ltp.world.a import y"}, "a.py b.py a.py"),
        ({"a.py": "from . import b", "b.py": "def f():\n    from . import a"}, "a.py b.py a.py"),
        (
            {"a.py": "from .b import x", "b.py": "if TYPE_CHECKING:\n    import ltp.world.a"},
            "a.py b.py a.py",
        ),
        (
            {"a.py": "from .b import x", "b.py": "from .c import y", "c.py": "from .a import z"},
            "a.py b.py c.py a.py",
        ),
        (  # The package knows its files, they know each other, and what lies below.
            {
                "a.py": "",
                "room/__init__.py": "from .b import x",
                "room/b.py": "from .c import y",
                "room/c.py": "from ..a import z",
            },
            None,
        ),
        (
            {
                "a.py": "from .room import x",
                "room/__init__.py": "from .b import x",
                "room/b.py": "from ..a import z",
            },
            "a.py room/__init__.py room/b.py a.py",
        ),
        (
            {
                "a.py": "from .room.b import x",
                "room/__init__.py": "from ..a import z",
                "room/b.py": "",
            },
            "a.py room/__init__.py a.py",
        ),
    ],
)
def test_a_planted_circle_of_imports_is_found(
    tmp_path: Path, files: dict[str, str], circle: str | None
) -> None:
    for name, text in files.items():
        write(tmp_path, f"python/ltp/world/{name}", text)
    assert circles(python_graph(tmp_path)) == chain("python/ltp/world", circle)


@pytest.mark.parametrize(
    ("files", "circle"),
    [
        ({"src/a.cpp": '"b.hpp"', "src/b.hpp": "<vector>"}, None),
        ({"src/a.hpp": '"b.hpp"', "src/b.hpp": '"../src/a.hpp"'}, "src/a.hpp src/b.hpp src/a.hpp"),
        (
            {
                "include/ltp/a.hpp": "<ltp/b.hpp>",
                "include/ltp/b.hpp": '"ltp/grid/c.hpp"',
                "include/ltp/grid/c.hpp": '"../a.hpp"',
                "src/a.cpp": '"ltp/a.hpp"',
            },
            "include/ltp/a.hpp include/ltp/b.hpp include/ltp/grid/c.hpp include/ltp/a.hpp",
        ),
    ],
)
def test_a_planted_circle_of_includes_is_found(
    tmp_path: Path, files: dict[str, str], circle: str | None
) -> None:
    for name, header in files.items():
        write(tmp_path, f"cpp/{name}", f"#include {header}\n")
    assert circles(cpp_graph(tmp_path)) == chain("cpp", circle)


def test_every_circle_is_found() -> None:
    graph = {"a": {"b"}, "b": {"a", "c"}, "c": {"d"}, "d": {"c"}, "e": {"e"}, "f": {"a"}}
    assert sorted(circles(graph)) == ["a -> b -> a", "c -> d -> c", "e -> e"]
