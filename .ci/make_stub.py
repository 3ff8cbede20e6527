# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the type stub of the installed ltp._core to a file: make_stub.py FILE."""

import subprocess
import sys
import tempfile
from pathlib import Path

import ltp._core

HEADER = """\
# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
# Generated from the compiled module by `make stub`; do not edit.
"""


def make_stub() -> str:
    """The stub's text; nothing in it depends on the version of ltp or on the machine."""
    with tempfile.TemporaryDirectory() as folder:
        generator = [sys.executable, "-m", "pybind11_stubgen", "ltp._core", "-o", folder]
        # Whatever cannot be written as a type is a mistake of the bindings.
        done = subprocess.run(
            [*generator, "--exit-code"], capture_output=True, text=True, check=False
        )
        if done.returncode != 0:
            sys.exit(done.stderr)
        text = (Path(folder) / "ltp" / "_core.pyi").read_text(encoding="utf-8")
    text = text.replace(repr(ltp._core.__version__), "...")
    return HEADER + "\n".join(line.rstrip() for line in text.splitlines()) + "\n"


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: make_stub.py FILE")
    Path(sys.argv[1]).write_text(make_stub(), encoding="utf-8")
