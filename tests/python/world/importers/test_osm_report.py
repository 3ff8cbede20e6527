# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""An import of OpenStreetMap ends with a summary: what was read, guessed, left out, and why."""

from pathlib import Path

import pytest

from ltp.world import World
from tests.python.world.importers.osm_extract import Extract, box, read


def line(world: World, start: str) -> str:
    """The one sentence that starts like that."""
    found = [text for text in world.report if text.startswith(start)]
    assert len(found) == 1, world.report
    return found[0]


def town() -> Extract:
    """Buildings of 900, 400, 300 and 100 m2 whose height is told, in storeys, by parts, guessed."""
    extract = Extract()
    extract.way(box(0, 0, 30, 30), {"building": "yes", "height": "12"})
    extract.way(box(40, 0, 60, 20), {"building": "yes", "building:levels": "3"})
    extract.way(box(70, 0, 90, 20), {"building": "yes"})
    extract.way(box(70, 0, 80, 20), {"building:part": "yes", "height": "20"})
    extract.way(box(70, 40, 80, 50), {"building": "yes"})
    extract.way(box(10, 40, 30, 60), {"leisure": "park"})
    extract.way(box(10, 70, 30, 80), {"natural": "water"})
    extract.way([(-20, 90), (120, 90)], {"highway": "residential"})
    extract.way([(-20, 95), (120, 95)], {"highway": "footway"})
    extract.node(50, 70, {"natural": "tree"})
    extract.node(55, 70, {"natural": "tree", "height": "8"})
    extract.node(60, 70, {"man_made": "mast"})
    extract.way(box(500, 500, 600, 600), {"building": "yes"})  # not in the bounds
    return extract


def test_it_counts_what_lies_in_the_bounds(tmp_path: Path) -> None:
    world = read(town().write_xml(tmp_path / "a.osm"))
    assert line(world, "Read:") == (
        "Read: 4 buildings and 1 building parts; 1 other tall things; 2 trees and rows of trees, "
        "0 woods; 1 areas of water, 0 streams, 0 coast lines; 1 roads, 1 paths, 0 rails; 1 other "
        "areas of ground."
    )


def test_it_says_which_heights_were_guessed(tmp_path: Path) -> None:
    world = read(town().write_xml(tmp_path / "a.osm"), default_height=14.0)
    # 900 + 400 + (200 + 200) + 100 m2 built, 100 of them guessed.
    assert line(world, "Heights of buildings:") == (
        "Heights of buildings: 2 of 4 buildings tell theirs. Of 5 blocks (parts, and what they "
        "leave of their building), 2 have it from a height tag, 1 from the number of storeys "
        "(x 3 m), 1 from the rest of their building; 1 are guessed (usual for the kind, else "
        "14 m): 5.6 % of the built area."
    )
    assert line(world, "Heights of other") == "Heights of other tall things: 1 of 1 are guessed."
    assert line(world, "Heights of trees") == "Heights of trees and woods: 1 of 2 are guessed."


@pytest.mark.parametrize(
    ("tags", "words"),
    [
        ({"building": "yes", "height": "tall"}, "height='tall' (w11)"),
        ({"building": "yes", "height": "1,234"}, "height='1,234' (w11)"),
        ({"building": "yes", "building:levels": "-1"}, "building:levels='-1' (w11)"),
        ({"building:part": "yes", "min_height": "low"}, "min_height='low' (w11)"),
        ({"man_made": "tower", "est_height": "huge"}, "est_height='huge' (w11)"),
    ],
)
def test_a_height_that_nobody_can_read_is_never_silent(
    tmp_path: Path, tags: dict[str, str], words: str
) -> None:
    extract = town()
    extract.way(box(40, 40, 60, 60), tags)
    world = read(extract.write_xml(tmp_path / "a.osm"))
    assert line(world, "Heights not understood") == (
        f"Heights not understood, and left aside: 1, such as {words}."
    )


def test_a_sound_file_leaves_nothing_out(tmp_path: Path) -> None:
    world = read(town().write_xml(tmp_path / "a.osm"))
    assert not any(text.startswith(("Left out", "Not raised")) for text in world.report)
    assert not any("not understood" in text for text in world.report)


def test_a_coast_that_floods_nothing_is_told(tmp_path: Path) -> None:
    extract = town()
    extract.way([(35, -30), (35, 65)], {"natural": "coastline"})
    world = read(extract.write_xml(tmp_path / "a.osm"))
    assert any("a coast line that ends within the bounds: no sea read" in s for s in world.report)


def test_the_summary_is_saved_with_the_world(tmp_path: Path) -> None:
    world = read(town().write_xml(tmp_path / "a.osm"))
    world.save(tmp_path / "a.npz")
    assert World.load(tmp_path / "a.npz").report == world.report
    assert len(world.report) == 5
