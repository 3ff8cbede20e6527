# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp` and the help of every command come without what only the commands need."""

import json
import subprocess
import sys

HEAVY = ("numpy", "ltp._core", "matplotlib", "rich", "scipy", "rerun", "rasterio", "laspy")

_SCRIPT = """
import json, sys
from typer.main import get_command
from typer.testing import CliRunner

typers_own = set(sys.modules)  # some versions of it bring rich
from ltp.cli import app

def helped(command, path=()):
    result = CliRunner().invoke(app, [*path, "--help"])
    assert result.exit_code == 0 and "Usage:" in result.output, path
    below = getattr(command, "commands", {})
    return 1 + sum(helped(below[name], (*path, name)) for name in below)

asked = helped(get_command(app)) if sys.argv[1] == "help" else 0
if sys.argv[1] == "version":
    assert CliRunner().invoke(app, ["version"]).exit_code == 0
heavy = [name for name in sys.argv[2:] if name in sys.modules and name not in typers_own]
print(json.dumps([asked, heavy]))
"""


def brought(what: str) -> tuple[int, list[str]]:
    """How many commands were asked for their help, and what heavy modules a process then holds."""
    command = [sys.executable, "-c", _SCRIPT, what, *HEAVY]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    asked, heavy = json.loads(done.stdout)
    return asked, heavy


def test_the_app_is_made_without_the_heavy_libraries() -> None:
    assert brought("nothing") == (0, [])


def test_help_of_every_command_comes_without_the_heavy_libraries() -> None:
    asked, heavy = brought("help")
    assert heavy == []
    assert asked > 25


def test_a_command_that_needs_the_core_brings_it() -> None:
    assert brought("version") == (0, ["numpy", "ltp._core"])  # so the above can fail
