# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that a wheel holds the package, its compiled module, its stub, and nothing else."""

import re
import sys
import zipfile
from pathlib import Path

PACKAGE = Path(__file__).parents[1] / "python" / "ltp"
METADATA = ("METADATA", "RECORD", "WHEEL", "entry_points.txt", "licenses/LICENSE")


def expected_names() -> set[str]:
    """Every file of the package in the source tree that users need."""
    files = [*PACKAGE.rglob("*.py"), PACKAGE / "_core.pyi", PACKAGE / "py.typed"]
    return {f"ltp/{file.relative_to(PACKAGE).as_posix()}" for file in files}


def complaints(wheel: Path) -> list[str]:
    """What is missing from a wheel and what should not be in it, one sentence each."""
    with zipfile.ZipFile(wheel) as archive:
        names = {name for name in archive.namelist() if not name.endswith("/")}
    information = "-".join(wheel.name.split("-")[:2]) + ".dist-info"
    modules = {name for name in names if re.fullmatch(r"ltp/_core\.[\w.-]+\.so", name)}
    expected = expected_names() | {f"{information}/{name}" for name in METADATA}
    found = [f"{name} is missing" for name in sorted(expected - names)]
    found += [f"{name} does not belong there" for name in sorted(names - expected - modules)]
    if len(modules) != 1:
        found.append(f"one compiled module expected, found {sorted(modules) or 'none'}")
    return found


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: check_wheel.py WHEEL")
    problems = complaints(Path(sys.argv[1]))
    if problems:
        sys.exit("\n".join([f"{sys.argv[1]}:", *problems]))
    print(f"{sys.argv[1]}: the package, its module, its stub, and nothing else")
