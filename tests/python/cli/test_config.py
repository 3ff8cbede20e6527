# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp config`, `ltp version`: what the program is and what it flies with."""

import re
import subprocess
import sys
from pathlib import Path

import ltp
from ltp.config import MissionConfig

from .runner import run, succeed


def test_settings_are_printed_as_toml_that_reads_back(tmp_path: Path) -> None:
    text = succeed("config")
    assert MissionConfig.from_toml(text).to_dict() == MissionConfig().to_dict()
    file = tmp_path / "mine.toml"
    file.write_text('planner = "ggwp"\n')
    assert 'planner = "ggwp"' in succeed("config", "--config", file)


def test_a_preset_goes_over_a_file(tmp_path: Path) -> None:
    file = tmp_path / "mine.toml"
    file.write_text('planner = "ggwp"\nmapping = { cell = [4.0, 4.0, 4.0], margin = 0.5 }\n')
    config = MissionConfig.from_toml(succeed("config", "--config", file, "--preset", "low"))
    assert config.planner == "ggwp"
    assert list(config.mapping.cell) == [1.0, 1.0, 1.0]
    assert config.mapping.margin == 0.5


def test_old_settings_are_read_told_of_and_printed_anew(tmp_path: Path) -> None:
    file = tmp_path / "old.toml"
    file.write_text("length_weight = 0.25\n[bezier]\noffsets = 21\n")
    result = run("config", "--config", file)
    assert result.exit_code == 0, result.output
    assert result.stderr.count("\n") == 2
    for old, new in (("length_weight", "weights.length"), ("bezier", "planner_options.bezier")):
        assert re.search(rf"old\.toml: .*'{old}' is now '[\w.]*{new}'", result.stderr)
    config = MissionConfig.from_toml(result.stdout)
    assert config.planner_options.weights.length == 0.25
    assert config.planner_options.bezier.offsets == 21


def test_version_and_module_are_the_same_program() -> None:
    assert succeed("version").strip() == ltp.__version__
    command = [sys.executable, "-m", "ltp", "version"]
    assert subprocess.run(command, capture_output=True, text=True, check=True).stdout == (
        f"{ltp.__version__}\n"
    )
