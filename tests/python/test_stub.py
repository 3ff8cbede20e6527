# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The committed stub says what the compiled module is: keyword names go wrong quietly."""

import ast
import difflib
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import ltp._core

ROOT = Path(__file__).parents[2]
STUB = ROOT / "python/ltp/_core.pyi"


@pytest.mark.skipif(np.__version__.startswith("1."), reason="it is written in NumPy 2's names")
def test_stub_has_not_drifted(tmp_path: Path) -> None:
    pytest.importorskip("pybind11_stubgen", reason="install ltp-uav[test]")
    fresh = tmp_path / "_core.pyi"
    done = subprocess.run(
        [sys.executable, ROOT / ".ci/make_stub.py", fresh],
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert done.returncode == 0, done.stderr
    drift = difflib.unified_diff(
        STUB.read_text().splitlines(),
        fresh.read_text().splitlines(),
        "committed",
        "compiled",
        lineterm="",
        n=1,
    )
    assert list(drift) == [], "run `make stub` and commit python/ltp/_core.pyi"


def test_stub_names_every_class_and_function() -> None:
    body = ast.parse(STUB.read_text()).body
    defined = {node.name for node in body if isinstance(node, ast.ClassDef | ast.FunctionDef)}
    public = {
        name
        for name, value in vars(ltp._core).items()
        if callable(value) and not name.startswith("_")
    }
    assert defined == public
    assert len(public) > 20
