# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The package as a user meets it: what it imports, what it holds, how it is called."""

import ast
import importlib.metadata
import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

import ltp

ROOT = Path(__file__).parents[2]


def run(*command: str | Path) -> str:
    """The standard output of a command that succeeds."""
    done = subprocess.run(command, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    return done.stdout


def modules_brought_by(statement: str) -> set[str]:
    """Top-level modules outside the standard library that a statement loads."""
    script = (
        "import json, sys\nbefore = set(sys.modules)\n"
        f"{statement}\nprint(json.dumps(sorted(set(sys.modules) - before)))"
    )
    loaded = {name.partition(".")[0] for name in json.loads(run(sys.executable, "-c", script))}
    return {name for name in loaded if name not in sys.stdlib_module_names}


def distribution() -> importlib.metadata.Distribution:
    """The installed package, if it is that which the tests import."""
    try:
        found = importlib.metadata.distribution("ltp-uav")
    except importlib.metadata.PackageNotFoundError:
        pytest.skip("ltp-uav is not installed, only on the path")
    if Path(str(found.locate_file("ltp"))).resolve() != Path(ltp.__file__).resolve().parent:
        pytest.skip("another ltp stands before the installed one on the path")
    return found


def test_import_needs_nothing_and_a_name_numpy_only() -> None:
    assert modules_brought_by("import ltp") == {"ltp"}
    brought = modules_brought_by("from ltp import World, make_planner")
    assert {"ltp", "numpy"} <= brought
    # numpy.random brings along what Cython made of it.
    assert brought - {"ltp"} <= modules_brought_by("import numpy.random")
    assert "matplotlib" in modules_brought_by("import matplotlib")  # so the above can fail


def test_every_public_name_is_there() -> None:
    missing = [name for name in ltp.__all__ if not hasattr(ltp, name)]
    assert missing == []
    assert len(set(ltp.__all__)) == len(ltp.__all__) > 4


def test_names_are_found_listed_and_told_from_others() -> None:
    assert set(ltp.__all__) <= set(dir(ltp))
    everything: dict[str, object] = {}
    exec("from ltp import *", everything)
    assert set(ltp.__all__) <= set(everything)
    for script in ("import ltp\nltp.World", "import ltp\nltp.world.World", "from ltp import sim"):
        run(sys.executable, "-c", script)  # also when it is the first that is asked for
    with pytest.raises(AttributeError, match="module 'ltp' has no attribute 'Wrold'"):
        ltp.Wrold  # noqa: B018
    with pytest.raises(ImportError, match="cannot import name 'Wrold'"):
        exec("from ltp import Wrold")


def test_public_objects_explain_themselves() -> None:
    silent = [
        name
        for name in ltp.__all__
        if callable(getattr(ltp, name)) and not (getattr(ltp, name).__doc__ or "").strip()
    ]
    assert silent == []


def test_no_two_types_share_a_name_across_the_border() -> None:
    compiled = {name for name, value in vars(ltp._core).items() if isinstance(value, type)}
    written = {
        node.name: path.name
        for path in (ROOT / "python/ltp").rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text()))
        if isinstance(node, ast.ClassDef)
    }
    assert {name: written[name] for name in compiled & written.keys()} == {}
    assert len(compiled) > 20
    assert len(written) > 40


def test_one_version_number() -> None:
    match = re.search(r"project\(ltp VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())
    assert match is not None
    assert ltp.__version__ == match[1]
    assert f"\nversion: {match[1]}\n" in (ROOT / "CITATION.cff").read_text()
    assert f"\n## [{match[1]}] - " in (ROOT / "CHANGELOG.md").read_text()


def test_installed_version_is_the_modules() -> None:
    assert distribution().version == ltp.__version__


def test_installed_files_are_the_package_and_nothing_else() -> None:
    files = {str(file) for file in distribution().files or []}
    inside = {name for name in files if name.startswith("ltp/") and "__pycache__" not in name}
    sources = (ROOT / "python/ltp").rglob("*")
    expected = {
        f"ltp/{path.relative_to(ROOT / 'python/ltp').as_posix()}"
        for path in sources
        if path.suffix in (".py", ".pyi") or path.name == "py.typed"
    }
    assert {"ltp/__init__.py", "ltp/_core.pyi", "ltp/py.typed"} <= expected
    assert expected <= inside
    module = inside - expected
    assert len(module) == 1
    assert re.fullmatch(r"ltp/_core\.[\w.-]+\.so", module.pop())
    elsewhere = {name.partition("/")[0] for name in files - inside}
    assert all(
        name in ("..", "ltp", "__pycache__") or name.endswith(".dist-info") for name in elsewhere
    )


def test_command_and_module_are_one() -> None:
    (command,) = distribution().entry_points.select(group="console_scripts")
    assert (command.name, command.value) == ("ltp", "ltp.cli:main")
    by_command = run(Path(sys.executable).with_name("ltp"), "--help")
    by_module = run(sys.executable, "-m", "ltp", "--help")
    assert "Usage: ltp [OPTIONS]" in by_command
    # They differ in the name that they were called by.
    assert [line for line in by_command.splitlines() if "Usage:" not in line] == [
        line for line in by_module.splitlines() if "Usage:" not in line
    ]


def code_in_readme(language: str) -> str:
    """The first block of a language."""
    match = re.search(rf"```{language}\n(.*?)```", (ROOT / "README.md").read_text(), re.DOTALL)
    assert match is not None
    return match[1]


def test_the_readme_shows_the_examples_that_are_tested() -> None:
    program = (ROOT / "examples/01_plan.cpp").read_text()
    assert code_in_readme("cpp") == program[program.index("#include") :]
    script = (ROOT / "examples/01_plan.py").read_text()
    assert code_in_readme("python") == script[script.index("import") :]


def test_every_source_names_its_licence() -> None:
    header = re.compile(
        r"(#!.*\n)?(#|//) SPDX-FileCopyrightText: \d{4} The ltp authors\n"
        r"(#|//) SPDX-License-Identifier: BSD-3-Clause\n"
    )
    sources = [
        path
        for folder in ("cpp", "python", "examples", "tests", "docs", ".ci")
        for path in (ROOT / folder).rglob("*")
        if path.suffix in (".py", ".pyi", ".cpp", ".hpp", ".in") or path.name == "CMakeLists.txt"
    ]
    unnamed = [str(path) for path in sources if not header.match(path.read_text())]
    assert unnamed == []
    assert len(sources) > 60
