# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints pip's requirements of the lowest versions that pyproject.toml allows, for some extras."""

import re
import sys
import tomllib
from pathlib import Path

_REQUIREMENT = re.compile(r"(?P<name>[\w.-]+(?:\[[\w,]+\])?)(?:>=|==)(?P<version>[\w.*]+)")


def lowest(requirement: str) -> str:
    """`numpy>=1.24` as `numpy==1.24`."""
    match = _REQUIREMENT.fullmatch(requirement)
    if not match:
        raise SystemExit(f"{requirement}: expected NAME>=VERSION or NAME==VERSION")
    return f"{match['name']}=={match['version']}"


def requirements(extras: list[str]) -> list[str]:
    """The lowest of all that the package and its extras need, each once."""
    path = Path(__file__).parents[1] / "pyproject.toml"
    project = tomllib.loads(path.read_text(encoding="utf-8"))["project"]
    wanted = list(project["dependencies"])
    for extra in extras:
        wanted += project["optional-dependencies"][extra]
    return sorted({lowest(requirement) for requirement in wanted})


if __name__ == "__main__":
    print("\n".join(requirements(sys.argv[1:])))
