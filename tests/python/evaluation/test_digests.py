# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Digests: another byte of the program is another program, another cell another world."""

import shutil
from pathlib import Path

import pytest

import ltp
from ltp.evaluation.digests import build_digest, program_digest, row_key, world_digest
from tests.python.scenes import box_world

PACKAGE = Path(ltp.__file__).parent
CORE = Path(ltp._core.__file__)


@pytest.fixture
def copy(tmp_path: Path) -> Path:
    """A copy of this build, the compiled module inside."""
    ignored = shutil.ignore_patterns("__pycache__", CORE.name)
    shutil.copytree(PACKAGE, tmp_path / "ltp", ignore=ignored)
    shutil.copy(CORE, tmp_path / "ltp/core")
    return tmp_path / "ltp"


def test_a_copy_of_the_program_has_its_digest(copy: Path) -> None:
    assert build_digest(copy / "core", copy) == program_digest() == program_digest()


@pytest.mark.parametrize("name", ["core", "config/mission.py", "sim/mission.py"])
def test_a_changed_byte_changes_the_digest(copy: Path, name: str) -> None:
    path = copy / name
    content = bytearray(path.read_bytes())
    content[len(content) // 2] ^= 1
    path.write_bytes(content)
    assert build_digest(copy / "core", copy) != program_digest()


def test_a_new_a_moved_and_a_lost_file_change_the_digest(copy: Path) -> None:
    whole = program_digest()
    (copy / "new.py").write_bytes(b"")
    assert build_digest(copy / "core", copy) != whole
    (copy / "new.py").unlink()
    (copy / "renamed.py").rename(copy / "renamer.py")
    assert build_digest(copy / "core", copy) != whole
    (copy / "renamer.py").unlink()
    assert build_digest(copy / "core", copy) != whole


def test_a_key_is_of_the_program_and_of_all_facts(monkeypatch: pytest.MonkeyPatch) -> None:
    facts = {"world": "a", "planner": ["auto", 1]}
    key = row_key(facts)
    assert key == row_key(dict(reversed(facts.items()))) and len(key) == 20
    assert key != row_key(facts | {"world": "b"})
    monkeypatch.setattr("ltp.evaluation.digests.program_digest", lambda: "another build")
    assert key != row_key(facts)


def test_another_cell_is_another_world() -> None:
    boxes = [(10, 20, 10, 20)]
    digest = world_digest(box_world(boxes))
    assert digest == world_digest(box_world(boxes))
    assert digest != world_digest(box_world([(10, 20, 10, 21)]))
    assert digest != world_digest(box_world(boxes, name="other"))
