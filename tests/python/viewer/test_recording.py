# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Recordings for the viewer: read back by the viewer's own tools; replayed in private."""

import os
import re
import stat
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ltp._core import GridFrame, OccupancyGrid
from ltp.config import MissionConfig
from ltp.evaluation.scenarios import ScenarioOptions, make_scenario
from ltp.installed import pip_install
from ltp.sim import Flight, fly
from ltp.viewer import FlightRecording, replay
from ltp.viewer.recording import _cell_centres
from ltp.viewer.scenery import priority_mesh, surface_mesh
from ltp.world import World, priority_map
from tests.python.scenes import box_world, town

pytest.importorskip("rerun")

OPTIONS = ScenarioOptions(count=1, length=120.0, spacing=40.0, altitude=30.0, margin=10.0)


def rerun(tmp_path: Path, *arguments: str) -> str:
    """Run rerun's own tool, its settings kept here."""
    return subprocess.run(
        [sys.executable, "-m", "rerun_cli", *arguments],
        env=os.environ | {"XDG_CONFIG_HOME": str(tmp_path / "settings")},
        check=True,
        capture_output=True,
        text=True,
    ).stdout


def rows_of(statistics: str) -> dict[str, int]:
    """Chunks by entity, as `rerun rrd stats` lists them."""
    return {name: int(count) for name, count in re.findall(r"^(/[\w/]*): (\d+)$", statistics, re.M)}


def test_waypoints_that_change_in_flight_are_recorded(tmp_path: Path) -> None:
    path = tmp_path / "flight.rrd"
    with (
        FlightRecording(path) as recording,
        Flight(town(), MissionConfig(), (20.0, 20.0, 30.0), observers=[recording]) as flight,
    ):
        flight.step()
        flight.set_waypoints([(26.0, 20.0, 30.0)])
        flight.run()
        flight.set_waypoints([(30.0, 24.0, 30.0), (34.0, 24.0, 30.0)])
        flight.run()
    rows = rows_of(rerun(tmp_path, "rrd", "stats", str(path)))
    assert rows["/mission/waypoints"] >= 1
    assert rows["/events"] >= 1


def test_the_list_of_waypoints_says_how_near_and_what_was_too_far(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    config = MissionConfig()
    config.navigation.max_detour = 1.0
    config.mapping.dims = [12, 12, 20]  # what stands in the way is seen late
    told = []
    path = np.array([[20.0, 65.0, 30.0], [40.0, 65.0, 30.0], [130.0, 65.0, 30.0]])
    with FlightRecording(tmp_path / "flight.rrd") as recording:
        log = recording._log

        def listen(name: str, value: object) -> None:
            if name == "events":
                told.append(value.text.as_arrow_array()[0].as_py())
            log(name, value)

        monkeypatch.setattr(recording, "_log", listen)
        fly(town(), config, path, [recording])
    assert re.fullmatch(r"waypoint 1 reached, 2\.\d m from it", told[0])
    assert told[1].startswith("waypoint 2 skipped: the waypoint is too far")
    assert "0 waypoints dropped, 1 too far" in told[2]


def test_a_recording_holds_the_whole_flight(tmp_path: Path) -> None:
    world, path = town(), tmp_path / "flight.rrd"
    with FlightRecording(path) as recording:
        record = fly(
            world, MissionConfig(), make_scenario(world, OPTIONS, 0).global_path, [recording]
        )
    assert [file.name for file in tmp_path.iterdir()] == ["flight.rrd"]
    assert path.stat().st_size < 4e6
    rerun(tmp_path, "rrd", "verify", str(path))
    statistics = rerun(tmp_path, "rrd", "stats", str(path))
    entities = rows_of(statistics)
    assert {
        "/world/surface",
        "/world/priority",
        "/mission/global_path",
        "/mission/waypoints",
        "/map/window",
        "/map/occupied",
        "/lidar",
        "/plan",
        "/flown",
        "/uav",
        "/plots/penalty/plan",
        "/plots/priority/flown_so_far",
        "/plots/search/milliseconds",
        "/events",
    } <= set(entities)
    rows = int(re.search(r"^num_rows = ([\d ]+)$", statistics, re.M)[1].replace(" ", ""))
    assert rows > len(record.times)  # the UAV at every step, and more


def test_a_flight_that_fails_leaves_the_old_recording(tmp_path: Path) -> None:
    path = tmp_path / "flight.rrd"
    path.write_bytes(b"an older one")

    class Failing:
        def on_start(self, setup) -> None: ...

        def on_step(self, step) -> None:
            if step.time >= 0.5:
                raise RuntimeError("engine failure")

        def on_end(self, record) -> None: ...

    world = town()
    with pytest.raises(RuntimeError, match="engine failure"), FlightRecording(path) as recording:
        fly(
            world,
            MissionConfig(),
            make_scenario(world, OPTIONS, 0).global_path,
            [recording, Failing()],
        )
    assert path.read_bytes() == b"an older one"
    assert list(tmp_path.iterdir()) == [path]


def test_a_file_that_cannot_be_is_refused_before_the_flight(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"must end in .rrd.*flight\.npz"):
        FlightRecording(tmp_path / "flight.npz")
    with pytest.raises(OSError, match="nowhere"):
        FlightRecording(tmp_path / "nowhere" / "flight.rrd")


def test_without_rerun_the_message_says_what_to_install(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "rerun", None)
    with pytest.raises(ImportError, match=re.escape(pip_install("viewer"))):
        FlightRecording(tmp_path / "flight.rrd")
    assert list(tmp_path.iterdir()) == []


def test_replay_is_private(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    recording = tmp_path / "flight.rrd"
    recording.write_bytes(b"RRF2" + bytes(12))
    log = tmp_path / "log"
    viewer = tmp_path / "viewer"  # stands in for the viewer; rerun's wrapper starts it
    viewer.write_text(
        f'#!/bin/sh\necho "$XDG_CONFIG_HOME $@" >> "{log}"\n[ "$1" = analytics ] || exit 7\n'
    )
    viewer.chmod(viewer.stat().st_mode | stat.S_IXUSR)
    monkeypatch.setenv("RERUN_CLI_PATH", str(viewer))
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "mine"))
    assert replay(recording) == 7
    first, second = log.read_text().splitlines()
    settings_folder, *analytics = first.split()
    assert analytics == ["analytics", "disable"]
    assert settings_folder != str(tmp_path / "mine")
    assert second.split() == [
        settings_folder,
        str(recording),
        "--bind",
        "127.0.0.1",
        "--port",
        "auto",
    ]
    assert not Path(settings_folder).exists()
    assert not (tmp_path / "mine").exists()


def test_only_recordings_are_replayed(tmp_path: Path) -> None:
    other = tmp_path / "flight.npz"
    other.write_bytes(b"PK\x03\x04")
    with pytest.raises(ValueError, match=r"flight\.npz is not a recording"):
        replay(other)
    with pytest.raises(FileNotFoundError):
        replay(tmp_path / "none.rrd")


def test_cell_centres_are_those_of_the_array() -> None:
    rng = np.random.default_rng(3)
    frame = GridFrame(origin=(4.0, -8.0, 2.0), cell=(2.0, 2.0, 4.0), dims=(7, 9, 70))
    blocked = rng.random((7, 9, 70)) < 0.1
    centres = _cell_centres(OccupancyGrid.from_array(blocked, frame))
    expected = np.array([frame.centre(cell) for cell in np.argwhere(blocked)])
    assert set(map(tuple, centres)) == set(map(tuple, expected.astype(np.float32)))
    assert len(_cell_centres(OccupancyGrid(frame))) == 0


def area_by_normal(mesh) -> dict[tuple[int, int, int], float]:
    """Area of all triangles of a mesh by the axis that they face, either way."""
    corners = mesh.vertices[mesh.triangles].astype(float)
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) / 2.0
    area = np.linalg.norm(normal, axis=1)
    axis = np.abs(normal).argmax(axis=1)
    assert np.allclose(np.abs(normal).max(axis=1), area)
    return {i: float(area[axis == i].sum()) for i in range(3)}


@settings(max_examples=25)
@given(st.integers(0, 10**6))
def test_a_mesh_has_the_area_of_its_tops_and_walls(seed: int) -> None:
    rng = np.random.default_rng(seed)
    nx, ny = rng.integers(2, 12, 2)
    surface = rng.integers(0, 4, (nx, ny)) * 5.0
    classes = rng.integers(0, 15, (nx, ny)).astype(np.uint8)
    world = World("blocks", np.zeros((nx, ny)), surface, classes, 2.0, origin=(10.0, -4.0))
    mesh = surface_mesh(world)
    area = area_by_normal(mesh)
    assert area[2] == pytest.approx(nx * ny * 4.0)
    assert area[0] == pytest.approx(2.0 * np.abs(np.diff(surface, axis=0)).sum())
    assert area[1] == pytest.approx(2.0 * np.abs(np.diff(surface, axis=1)).sum())
    assert mesh.vertices[:, :2].min(axis=0).tolist() == [10.0, -4.0]
    assert mesh.vertices[:, 2].max() == surface.max()


def test_a_large_world_becomes_a_small_mesh() -> None:
    world = box_world([(0, 300, 0, 300)], size=(1400, 1200))
    noise = np.random.default_rng(1).uniform(0.0, 30.0, world.shape)
    rough = World("rough", world.ground, noise, world.classes, 1.0)
    assert len(surface_mesh(rough).triangles) <= 320_000
    flat = priority_mesh(world, priority_map(world))
    assert area_by_normal(flat)[2] == pytest.approx(1400.0 * 1200.0)
    assert len({tuple(colour) for colour in flat.colours}) == 2
