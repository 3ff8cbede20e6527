# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`FlightRecord`: written, read back as it was, and refused by name."""

import errno
import functools
import json
import os
import warnings
from pathlib import Path

import numpy as np
import pytest

import ltp.sim
from ltp.config import MissionConfig
from ltp.config.moved import MOVED
from ltp.sim.record import FlightRecord, Outcome, PlanEntry, WaypointEntry


def make_record(plans: int = 2) -> FlightRecord:
    times = np.arange(4) * 0.1
    return FlightRecord(
        config=MissionConfig(planner="ggwp"),
        world_name="test",
        attribution="nobody",
        global_path=np.array([[0.0, 0, 50], [3, 4, 50]]),
        times=times,
        positions=np.stack([times, times, 0 * times + 50], axis=1),
        velocities=np.ones((4, 3)),
        plan_index=np.array([-1, 0, 0, 1]),
        waypoint_index=np.zeros(4, dtype=np.int64),
        waypoints=[
            WaypointEntry(0, "dropped", "unreachable", 0.2, (0, 0, 50), (3, 4, 50), (-1, -1, 0))
        ],
        plans=[
            PlanEntry(0.1 * i, 0, "found", np.full((i + 2, 3), i), 0.5, 3.0, 1.0, 2.5, 7, 1e-3)
            for i in range(plans)
        ],
        outcome=Outcome.REACHED,
        collision=None,
        min_clearance=4.5,
        mean_priority=0.25,
        length=6.0,
        metadata={"scenario": 3},
        map_totals={"marked": 7},
        map_losses=["1 of 8 hits ..."],
    )


@pytest.mark.parametrize("plans", [0, 1, 3])
def test_record_round_trip(tmp_path, plans: int) -> None:
    record = make_record(plans)
    record.save(tmp_path / "flight.npz")
    again = FlightRecord.load(tmp_path / "flight.npz")
    assert again.config.to_dict() == record.config.to_dict()
    assert again.waypoints == record.waypoints
    assert again.metadata == {"scenario": 3}
    assert [len(plan.path) for plan in again.plans] == [i + 2 for i in range(plans)]
    for name in ("times", "positions", "velocities", "plan_index", "waypoint_index"):
        np.testing.assert_array_equal(getattr(again, name), getattr(record, name))
    assert again.outcome is Outcome.REACHED
    assert again.length_ratio == pytest.approx(6.0 / 5.0)
    assert not again.complete
    assert [event.reason for event in again.dropped] == ["unreachable"]
    assert [event.distance for event in again.waypoints] == [5.0]
    assert (again.map_totals, again.map_losses) == ({"marked": 7}, ["1 of 8 hits ..."])


def test_a_record_from_before_maps_were_counted_is_read(tmp_path) -> None:
    make_record().save(tmp_path / "new.npz")
    with np.load(tmp_path / "new.npz") as archive:
        arrays = {name: archive[name] for name in archive.files}
    header = json.loads(arrays.pop("header").tobytes())
    del header["map_totals"], header["map_losses"]
    arrays["header"] = np.frombuffer(json.dumps(header).encode(), dtype=np.uint8)
    np.savez_compressed(tmp_path / "old.npz", **arrays)
    old = FlightRecord.load(tmp_path / "old.npz")
    assert (old.map_totals, old.map_losses) == ({}, [])
    assert [event.distance for event in old.waypoints] == [5.0]


def as_format_1(new: Path, old: Path) -> None:
    """Rewrite a record as version 0.1 wrote it: other names, the planner's options laid flat."""
    with np.load(new) as archive:
        arrays = {name: archive[name] for name in archive.files}
    header = json.loads(arrays.pop("header").tobytes())
    assert header["format"] == 2
    header["format"] = 1
    header["way_points"] = header.pop("waypoints")
    for plan in header["plans"]:
        plan["way_point"] = plan.pop("waypoint")
    for name, moved in MOVED.items():
        *tables, key = moved.split(".")
        header["config"][name] = functools.reduce(dict.get, tables, header["config"]).pop(key)
    del header["config"]["planner_options"]
    arrays["way_point_index"] = arrays.pop("waypoint_index")
    arrays["header"] = np.frombuffer(json.dumps(header).encode(), dtype=np.uint8)
    np.savez_compressed(old, **arrays)


def test_a_record_of_format_1_is_read_as_it_was(tmp_path) -> None:
    record = make_record(2)
    record.config.planner_options.weights.length = 0.25
    record.config.planner_options.bezier.offsets = 21
    record.save(tmp_path / "new.npz")
    as_format_1(tmp_path / "new.npz", tmp_path / "old.npz")
    with warnings.catch_warnings():
        warnings.simplefilter("error")  # it is no mistake of the reader's
        again = FlightRecord.load(tmp_path / "old.npz")
    assert again.config.to_dict() == record.config.to_dict()
    assert again.waypoints == record.waypoints
    assert [plan.waypoint for plan in again.plans] == [0, 0]
    np.testing.assert_array_equal(again.waypoint_index, record.waypoint_index)
    again.save(tmp_path / "again.npz")
    assert FlightRecord.load(tmp_path / "again.npz").waypoints == record.waypoints


def test_a_record_of_a_format_to_come_is_refused(tmp_path, monkeypatch) -> None:
    monkeypatch.setattr("ltp.sim.record.FORMAT", 3)
    make_record().save(tmp_path / "flight.npz")
    monkeypatch.undo()
    with pytest.raises(ValueError, match=r"flight\.npz.*format = 3: expected 1 or 2"):
        FlightRecord.load(tmp_path / "flight.npz")


def test_a_truncated_record_is_refused_by_name(tmp_path) -> None:
    path = tmp_path / "flight.npz"
    make_record().save(path)
    whole = path.read_bytes()
    for size in range(0, len(whole) - 1, 97):
        path.write_bytes(whole[:size])
        with pytest.raises(ValueError, match=r"flight\.npz"):
            FlightRecord.load(path)


def test_a_full_disk_keeps_the_older_flight(tmp_path, monkeypatch) -> None:
    path = tmp_path / "flight.npz"
    make_record(1).save(path)

    def full(_descriptor: int) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(OSError, match="No space left"):
        make_record(3).save(path)
    assert len(FlightRecord.load(path).plans) == 1
    assert [file.name for file in tmp_path.iterdir()] == ["flight.npz"]


def test_the_old_name_of_a_waypoints_entry_says_the_new_one() -> None:
    with pytest.warns(DeprecationWarning, match="WaypointEntry"):
        assert ltp.sim.WaypointEvent is WaypointEntry
    with pytest.raises(AttributeError, match="Waypoints"):
        ltp.sim.Waypoints  # noqa: B018
