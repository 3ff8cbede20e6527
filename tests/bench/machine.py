# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the figures were measured on: processor, compiler, Python, versions of the peers."""

import os
import platform
import subprocess
from importlib import metadata
from pathlib import Path

PEERS = (
    "numpy",
    "dijkstra3d",
    "scikit-image",
    "scikit-fmm",
    "scipy",
    "tcod",
    "ompl",
    "embreex",
    "open3d",
    "pyoctomap",
    "octomap-python",
)


def describe() -> dict[str, object]:
    """The machine and the versions, as plain values; `peers` lists those that are installed."""
    return {
        "processor": _processor(),
        "cores": os.cpu_count(),
        "vectors": [flag for flag in ("avx2", "avx512f") if flag in _cpuinfo("flags").split()],
        "system": _system(),
        "compiler": _first_line([os.environ.get("CXX") or "c++", "--version"]),
        "python": platform.python_version(),
        "ltp": metadata.version("ltp-uav"),
        "peers": {name: version for name in PEERS if (version := _version(name))},
    }


def _processor() -> str:
    name = _cpuinfo("model name") or platform.processor() or platform.machine()
    family, model = _cpuinfo("cpu family"), _cpuinfo("model")
    return f"{name} (family {family}, model {model})" if family else name


def _cpuinfo(key: str) -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        return ""
    return next((line.split(":", 1)[1].strip() for line in lines if _key(line) == key), "")


def _key(line: str) -> str:
    return line.split(":", 1)[0].strip()


def _system() -> str:
    try:
        return platform.freedesktop_os_release()["PRETTY_NAME"]
    except OSError:
        return platform.system()


def _version(name: str) -> str | None:
    try:
        return metadata.version(name)
    except metadata.PackageNotFoundError:
        return None


def _first_line(command: list[str]) -> str:
    try:
        output = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError):
        return "unknown"
    return output.splitlines()[0] if output else "unknown"
