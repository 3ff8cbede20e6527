# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tests roll no dice: the same examples whatever else is loaded, and every seed is written."""

import os
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
from hypothesis import settings

ROOT = Path(__file__).parents[2]

_DRAW = """
from hypothesis import given, strategies as st

@given(st.floats(), st.integers(), st.text(max_size=3))
def test_draw(number, whole, text):
    print("drew", repr(number), whole, repr(text))
"""


def drawn(folder: Path, *options: str, before: str = "") -> list[str]:
    """What hypothesis draws in a process of its own that has loaded other modules, too."""
    folder.mkdir(exist_ok=True)
    (folder / "conftest.py").write_text((ROOT / "tests/python/conftest.py").read_text() + before)
    (folder / "test_draw.py").write_text(_DRAW)
    (folder / "constants.py").write_text("A = [123456.789012, 987654321987654321, 'xyzzy']\n")
    command = [sys.executable, "-m", "pytest", "-q", "-s", "-p", "no:cacheprovider", *options, "."]
    environment = {**os.environ, "PYTHONPATH": str(folder), "PYTEST_ADDOPTS": ""}
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return [line for line in done.stdout.splitlines() if "drew" in line]


def test_examples_repeat_whatever_is_loaded(tmp_path: Path) -> None:
    first = drawn(tmp_path)
    assert len(first) > 50
    assert drawn(tmp_path, before="\nimport constants, wave\n") == first
    # A random run draws others, and its seed repeats it.
    random = ("--hypothesis-profile=random", "--hypothesis-seed=1")
    one, again = drawn(tmp_path / "one", *random), drawn(tmp_path / "again", *random)
    assert one == again
    assert one != first


def test_this_run_is_of_a_profile(request: pytest.FixtureRequest) -> None:
    if request.config.getoption("--hypothesis-profile", None) == "random":
        pytest.skip("a random run")
    assert settings.default is not None
    assert settings.default.derandomize
    assert settings.default.database is None


def test_every_generator_has_a_seed() -> None:
    unseeded = re.compile(
        r"default_rng\(\)|random\.seed\(|np\.random\.(?!default_rng|Generator)\w+\("
        r"|(?<![\w.])random\.(?:random|randint|choice|uniform|shuffle)\(|random\.Random\(\)"
    )
    cpp = re.compile(r"std::random_device|std::rand\(|srand\(|time\(nullptr\)|time\(NULL\)")
    found = []
    files = [*(ROOT / "tests").rglob("*.py"), *(ROOT / "tests").rglob("*_test.cpp")]
    for path in files:
        pattern = unseeded if path.suffix == ".py" else cpp
        for number, line in enumerate(path.read_text().splitlines(), 1):
            # The name of a folder may differ from run to run.
            if pattern.search(line) and path != Path(__file__) and "to_string(" not in line:
                found.append(f"{path.relative_to(ROOT)}:{number}: {line.strip()}")
    assert found == []
    assert len(files) > 80


def test_the_lowest_versions_are_those_of_the_project() -> None:
    script = [sys.executable, ROOT / ".ci/lowest.py", "geo", "viewer", "test"]
    printed = subprocess.run(script, capture_output=True, text=True, check=True).stdout.split()
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    extras = project["optional-dependencies"]
    wanted = {*project["dependencies"], *extras["geo"], *extras["viewer"], *extras["test"]}
    assert set(printed) == {requirement.replace(">=", "==") for requirement in wanted}
    assert "typer==0.16" in printed
