# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The distribution is `ltp-uav`: every message says so, and a stranger named `ltp` is noticed."""

import json
import os
import re
import shutil
import subprocess
import sys
import tomllib
import warnings
from pathlib import Path

import pytest

import ltp
from ltp import installed
from ltp.installed import DISTRIBUTION, warn_of_strangers

ROOT = Path(__file__).parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]


def test_what_is_built_is_called_by_the_name_in_the_messages() -> None:
    assert PROJECT["name"] == DISTRIBUTION == "ltp-uav"
    assert PROJECT["scripts"] == {"ltp": "ltp.cli:main"}


def a_copy(folder: Path) -> Path:
    """The module as it lies in a package of its own."""
    package = folder / "ltp"
    package.mkdir(parents=True)
    copy = package / "installed.py"
    copy.write_text(Path(installed.__file__).read_text())
    return copy


def said_by(copy: Path, where: Path, path: str = "") -> str:
    """`pip_install("geo")` of a copy, asked in a folder."""
    script = "import runpy, sys; print(runpy.run_path(sys.argv[1])['pip_install']('geo'))"
    done = subprocess.run(
        [sys.executable, "-S", "-c", script, str(copy)],
        cwd=where,
        env={**os.environ, "PYTHONPATH": path},
        capture_output=True,
        text=True,
        check=True,
    )
    return done.stdout.strip()


def test_an_installed_package_names_the_distribution_a_checkout_its_folder(tmp_path: Path) -> None:
    site = tmp_path / "site-packages"
    assert said_by(a_copy(site), tmp_path) == 'pip install "ltp-uav[geo]"'
    checkout = tmp_path / "checkout"
    copy = a_copy(checkout / "python")
    for name in ("pyproject.toml", "CMakeLists.txt"):
        (checkout / name).touch()
    assert said_by(copy, checkout) == 'pip install ".[geo]"'
    assert said_by(copy, tmp_path) == f'pip install "{checkout}[geo]"'
    (site / "ltp_uav-0.2.0.dist-info").mkdir()  # installed from the checkout
    assert said_by(copy, checkout, str(site)) == 'pip install "ltp-uav[geo]"'


def test_the_extras_in_messages_exist() -> None:
    sources = [*(ROOT / "python").rglob("*.py"), ROOT / "README.md", *(ROOT / "docs").glob("*.md")]
    asked = {
        extra
        for path in sources
        for extra in re.findall(
            r"""(?:pip_install\(["']|ltp-uav\[|"\.\[)(\w+)""", path.read_text("utf-8")
        )
    }
    assert {"geo", "viewer"} <= asked <= PROJECT["optional-dependencies"].keys()


def test_nothing_tells_anybody_to_install_the_stranger() -> None:
    suffixes = (".py", ".md", ".toml", ".cff", ".yml", ".pyi", ".txt", ".hpp", ".cpp", "")
    folders = ("python", "docs", "examples", ".ci", ".github", "third_party", "tests", "cpp")
    files = [path for folder in folders for path in (ROOT / folder).rglob("*") if path.is_file()]
    files += [path for path in ROOT.iterdir() if path.is_file()]
    wrong = re.compile(r"ltp\[\w|pip install (?:-\S+ )*[\"']?ltp(?![-\w/.])")
    # What warns of it may name it.
    excused = re.compile(r"[Dd]o not `pip install ltp`")
    found = []
    for path in files:
        if path.suffix not in suffixes or path in (Path(__file__), ROOT / "CHANGELOG.md"):
            continue
        if any(part in ("build", "out", "dist", "__pycache__", "figures") for part in path.parts):
            continue
        for number, line in enumerate(path.read_text("utf-8", errors="replace").splitlines(), 1):
            if wrong.search(excused.sub("", line)):
                found.append(f"{path.relative_to(ROOT)}:{number}: {line.strip()[:100]}")
    assert found == []
    assert len(files) > 200


@pytest.mark.parametrize("kind", ["dist-info", "egg-info", "py3.egg-info", "py3.11.egg-info"])
@pytest.mark.parametrize("version", ["4.2.3", "0.2.0", "1.0rc1"])
def test_a_distribution_with_our_import_name_is_noticed(
    kind: str, version: str, tmp_path: Path
) -> None:
    stranger = tmp_path / f"ltp-{version}{'-' if kind.startswith('py') else '.'}{kind}"
    stranger.mkdir()
    with pytest.warns(RuntimeWarning, match="distribution named `ltp`") as caught:
        warn_of_strangers([str(tmp_path), str(tmp_path)])
    assert len(caught) == 1
    said = str(caught[0].message)
    assert str(stranger) in said
    assert "pip uninstall ltp" in said
    assert DISTRIBUTION in said


@pytest.mark.parametrize(
    "name",
    ["ltp_uav-0.3.0.dist-info", "ltp-uav.dist-info", "ltpy-1.0.dist-info", "ltp", "ltp-1.0.txt"],
)
def test_ourselves_and_others_are_not(name: str, tmp_path: Path) -> None:
    (tmp_path / name).mkdir()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        warn_of_strangers([str(tmp_path), str(tmp_path / "nowhere"), ""])


def test_the_import_says_so_once(tmp_path: Path) -> None:
    (tmp_path / "ltp-4.2.3.dist-info").mkdir()
    script = "import ltp, importlib; from ltp import installed; import ltp.cli"
    environment = {
        **os.environ,
        "PYTHONPATH": os.pathsep.join([str(Path(ltp.__file__).parents[1]), str(tmp_path)]),
    }
    done = subprocess.run(
        [sys.executable, "-c", script], env=environment, capture_output=True, text=True, check=True
    )
    assert done.stderr.count("belongs to a distribution named `ltp`") == 1


def test_looking_for_it_loads_nothing() -> None:
    script = (
        "import sys, json; before = set(sys.modules); import ltp;"
        "print(json.dumps(sorted(set(sys.modules) - before)))"
    )
    environment = {**os.environ, "PYTHONPATH": str(Path(ltp.__file__).parents[1])}
    command = [sys.executable, "-S", "-c", script]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    loaded = set(json.loads(done.stdout))
    assert not loaded & {"importlib.metadata", "email", "zipfile", "pathlib", "numpy"}
    assert "ltp.installed" in loaded


def test_the_command_warns_where_a_stranger_has_replaced_the_package(tmp_path: Path) -> None:
    ours = Path(installed.__file__).parent
    shutil.copytree(ours, tmp_path / "ltp", ignore=shutil.ignore_patterns("*.so", "__pycache__"))
    (tmp_path / "ltp-4.2.14.dist-info").mkdir()
    command = [sys.executable, "-c", "from ltp.cli import main; main()", "--help"]
    for overwritten in (False, True):
        if overwritten:
            (tmp_path / "ltp" / "__init__.py").write_text('__version__ = "4.2.13"\n')
        done = subprocess.run(
            command,
            env={**os.environ, "PYTHONPATH": str(tmp_path)},
            capture_output=True,
            text=True,
            check=True,
        )
        assert done.stderr.count("pip uninstall ltp, then pip install --force-reinstall") == 1
        assert "Local trajectory planning" in done.stdout
