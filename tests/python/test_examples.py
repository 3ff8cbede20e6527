# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The examples in Python run as they stand and say what they promise; ctest runs those in C++."""

import re
import subprocess
import sys
from pathlib import Path

EXAMPLES = Path(__file__).parents[2] / "examples"


def output_of(name: str) -> str:
    """What an example prints, if it succeeds."""
    done = subprocess.run(
        [sys.executable, EXAMPLES / name], capture_output=True, text=True, timeout=120
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_a_path_is_planned() -> None:
    assert re.match(r"PlanStatus.FOUND \d", output_of("01_plan.py"))


def test_a_city_is_flown_to_its_far_corner() -> None:
    lines = output_of("02_fly_a_city.py").splitlines()
    assert "2 of them in buildings" in lines[0]
    assert sum(" dropped (" in line for line in lines) == 2
    assert lines[-5].endswith("waypoint 13 reached")
    assert lines[-4].startswith("reached: ")


def test_a_cloud_is_read_as_it_comes() -> None:
    lines = output_of("05_a_real_sensor.py").splitlines()
    assert "too_near=9," in lines[0]
    assert lines[1].startswith("NavigationStatus.FOLLOWING")
    assert [line.rsplit("map's ", 1)[1].split(" ")[0] for line in lines[2:]] == [
        "max_range",
        "blind_distance",
    ]


def test_a_flight_is_driven_by_hand() -> None:
    lines = output_of("06_fly_by_hand.py").splitlines()
    assert [line.split(" s  ")[1].split(" ")[0] for line in lines[:3]] == [
        "first",
        "there;",
        "touched",
    ]
    assert lines[2].endswith("0.0 m")
    assert lines[3].startswith("collided: ")


def test_examples_are_short() -> None:
    examples = [path for path in EXAMPLES.iterdir() if path.suffix in (".py", ".cpp")]
    assert len(examples) >= 5
    long = [path.name for path in examples if len(path.read_text().splitlines()) >= 60]
    assert long == []


def test_every_example_in_cpp_is_built() -> None:
    project = (EXAMPLES / "CMakeLists.txt").read_text()
    assert [path.stem for path in EXAMPLES.glob("*.cpp") if path.stem not in project] == []
