# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Campaigns: the same to the byte, resumed after any kill, no flight lost or flown twice."""

import csv
import dataclasses
import json
import multiprocessing
import os
import signal
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path

import numpy as np
import pytest

from ltp._core import Raster
from ltp.config import MissionConfig
from ltp.evaluation import digests
from ltp.evaluation.campaign import (
    JOURNAL,
    RECORDS,
    TABLE,
    Campaign,
    FlightRow,
    Variant,
    read_rows,
    run_campaign,
)
from ltp.evaluation.campaign.campaign import FlightJournal
from ltp.evaluation.campaign.flights import record_path
from ltp.evaluation.campaign.rows import COLUMNS, TIME_PREFIX
from ltp.evaluation.campaign.workers import SoloCrew
from ltp.evaluation.scenarios import ScenarioOptions, make_scenarios
from ltp.sim.record import FlightRecord
from tests.python.scenes import town

VARIANTS = (Variant("lp-a-star", 0.5, 1.0), Variant("ggwp", 1.0, 0.0))


def small_campaign(count: int = 3, variants: tuple[Variant, ...] = VARIANTS) -> Campaign:
    options = ScenarioOptions(count=count, length=80.0, spacing=40.0, altitude=30.0, margin=10.0)
    world = town()
    return Campaign(world, variants, make_scenarios(world, options), MissionConfig())


class Log:
    """Counts what a campaign tells."""

    def __init__(self) -> None:
        self.keys: list[str] = []
        self.start: tuple[int, int] | None = None
        self.ends = 0

    def on_start(self, total: int, done: int) -> None:
        self.start = (total, done)

    def on_flight(self, row: FlightRow) -> None:
        self.keys.append(row.key)

    def on_end(self) -> None:
        self.ends += 1


def untimed(path: Path) -> list[list[str]]:
    """The CSV without the columns that hold measured times."""
    with path.open(newline="") as file:
        table = list(csv.reader(file))
    kept = [i for i, name in enumerate(table[0]) if not name.startswith(TIME_PREFIX)]
    assert len(kept) == len(COLUMNS) - 5
    return [[line[i] for i in kept] for line in table]


def journal_keys(folder: Path) -> list[str]:
    lines = (folder / JOURNAL).read_bytes().splitlines()[1:]
    return [json.loads(line)["key"] for line in lines]


def test_one_and_two_processes_give_the_same_rows(tmp_path: Path) -> None:
    campaign = small_campaign()
    log = Log()
    alone = run_campaign(campaign, tmp_path / "one", observers=[log])
    run_campaign(campaign, tmp_path / "two", processes=2)
    assert untimed(tmp_path / "one" / TABLE) == untimed(tmp_path / "two" / TABLE)
    assert read_rows(tmp_path / "one" / TABLE) == alone
    order = [(row.planner, row.scenario) for row in alone]
    assert order == [(v.planner, i) for v in VARIANTS for i in range(3)]
    assert log.start == (6, 0) and log.ends == 1
    assert sorted(log.keys) == sorted(row.key for row in alone)
    assert {row.outcome for row in alone} == {"reached"}
    assert sum(row.plans for row in alone) >= 6


def test_a_finished_campaign_flies_nothing_again_and_a_larger_one_only_what_is_new(
    tmp_path: Path,
) -> None:
    first = run_campaign(small_campaign(2, VARIANTS[:1]), tmp_path)
    again, more = Log(), Log()
    assert run_campaign(small_campaign(2, VARIANTS[:1]), tmp_path, observers=[again]) == first
    assert again.start == (2, 2) and again.keys == []
    larger = run_campaign(small_campaign(3), tmp_path, observers=[more])
    assert more.start == (6, 2) and len(more.keys) == 4
    assert larger[:2] == first
    assert max(Counter(journal_keys(tmp_path)).values()) == 1


def test_another_setting_is_another_flight(tmp_path: Path) -> None:
    campaign = small_campaign(1)
    faster = MissionConfig()
    faster.lidar.max_range = 40.0
    keys = {flight.key for flight in campaign.flights()}
    others = {flight.key for flight in dataclasses.replace(campaign, base=faster).flights()}
    assert len(keys) == 2 and not keys & others
    assert keys == {flight.key for flight in small_campaign(1).flights()}


def test_a_priority_map_of_ones_own_is_another_flight_in_every_process(tmp_path: Path) -> None:
    campaign = small_campaign(2, VARIANTS[:1])
    values = np.random.default_rng(3).uniform(0.0, 0.4, (130, 110))
    own = dataclasses.replace(campaign, priority=Raster(values, cell=2.0))
    other = dataclasses.replace(campaign, priority=Raster(values / 2.0, cell=2.0))
    keys = [{f.key for f in each.flights()} for each in (campaign, own, other)]
    assert len(set.union(*keys)) == 6
    alone = run_campaign(own, tmp_path / "one")
    assert all(row.mean_priority < 0.4 for row in alone)
    with pytest.raises(ValueError, match=r"holds flights with other settings \(priority\)"):
        run_campaign(other, tmp_path / "one")
    run_campaign(own, tmp_path / "two", processes=2)
    assert untimed(tmp_path / "one" / TABLE) == untimed(tmp_path / "two" / TABLE)


def test_another_build_flies_anew(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    first = run_campaign(small_campaign(1), tmp_path)
    monkeypatch.setattr(digests, "program_digest", lambda: "another build")
    log = Log()
    second = run_campaign(small_campaign(1), tmp_path, observers=[log])
    assert log.start == (2, 0) and len(log.keys) == 2
    assert not {row.key for row in first} & {row.key for row in second}
    assert len(journal_keys(tmp_path)) == 4
    assert read_rows(tmp_path / TABLE) == second  # the table never mixes them
    (older,) = tmp_path.glob("flights-*.csv")
    assert read_rows(older) == first  # nor loses any


def test_another_command_adds_its_rows(tmp_path: Path) -> None:
    first = run_campaign(small_campaign(2, VARIANTS[:1]), tmp_path)
    second = run_campaign(small_campaign(1, VARIANTS[1:]), tmp_path)
    assert [row.planner for row in second] == ["ggwp"]
    assert read_rows(tmp_path / TABLE) == first + second
    run_campaign(small_campaign(1, VARIANTS[:1]), tmp_path)  # a part of it, once more
    assert read_rows(tmp_path / TABLE) == first + second


def test_another_world_setting_or_path_is_refused_by_name(tmp_path: Path) -> None:
    campaign = small_campaign(1, VARIANTS[:1])
    first = run_campaign(campaign, tmp_path)
    flatter = dataclasses.replace(campaign.world, surface=campaign.world.surface * 0.9)
    elsewhere = dataclasses.replace(campaign.world, name="elsewhere")
    faster = MissionConfig()
    faster.lidar.max_range = 40.0
    moved = [dataclasses.replace(s, global_path=s.global_path + 1.0) for s in campaign.scenarios]
    for changes, found in (
        ({"world": elsewhere}, "flights over town, not over elsewhere"),
        ({"world": flatter}, r"over town \(another one of that name\)"),
        ({"base": faster}, r"with other settings \(lidar.max_range\)"),
        ({"scenarios": moved}, r"other global paths \(number 0 of seed"),
    ):
        with pytest.raises(ValueError, match=found):
            run_campaign(dataclasses.replace(campaign, **changes), tmp_path)
        assert read_rows(tmp_path / TABLE) == first
    (tmp_path / "campaign.json").write_text('{"format": "ltp.campaign", "version": 1}')
    with pytest.raises(ValueError, match=r"campaign\.json is not what a campaign writes"):
        run_campaign(campaign, tmp_path)


def test_records_are_kept_on_request(tmp_path: Path) -> None:
    rows = run_campaign(small_campaign(1), tmp_path, keep_records=True)
    for line in rows:
        record = FlightRecord.load(record_path(tmp_path / RECORDS, line.key))
        assert record.config.planner == line.planner
        assert record.length == line.length
    record_path(tmp_path / RECORDS, rows[0].key).unlink()
    log = Log()
    assert run_campaign(small_campaign(1), tmp_path, keep_records=True, observers=[log]) == rows
    assert log.keys == [rows[0].key]
    assert len(journal_keys(tmp_path)) == 2


def test_a_worker_that_is_killed_ends_the_campaign_in_order(tmp_path: Path) -> None:
    class Saboteur(Log):
        def on_flight(self, row: FlightRow) -> None:
            super().on_flight(row)
            if len(self.keys) == 1:
                os.kill(multiprocessing.active_children()[0].pid, signal.SIGKILL)

    saboteur = Saboteur()
    campaign = small_campaign(6)
    with pytest.raises(RuntimeError, match="a process of the campaign was killed"):
        run_campaign(campaign, tmp_path, processes=2, observers=[saboteur])
    assert 1 <= len(saboteur.keys) < 12
    assert sorted(row.key for row in read_rows(tmp_path / TABLE)) == sorted(saboteur.keys)
    assert multiprocessing.active_children() == []


PROGRAM = """
import sys
from ltp.config import MissionConfig
from ltp.evaluation import Campaign, ScenarioOptions, Variant, make_scenarios, run_campaign
from ltp.world import World

if __name__ == "__main__":
    world = World.load(sys.argv[1])
    variants = [Variant("lp-a-star", 0.5, 1.0), Variant("ggwp", 1.0, 0.0)]
    options = ScenarioOptions(count=8, length=80.0, spacing=40.0, altitude=30.0, margin=10.0)
    campaign = Campaign(world, variants, make_scenarios(world, options), MissionConfig())
    run_campaign(campaign, sys.argv[2], processes=2)
"""


def start(tmp_path: Path, folder: Path) -> "subprocess.Popen[bytes]":
    """Run what `small_campaign(8)` is, in a process of its own."""
    program, world = tmp_path / "program.py", tmp_path / "town.npz"
    program.write_text(PROGRAM)
    town().save(world)
    return subprocess.Popen(
        [sys.executable, str(program), str(world), str(folder)],
        stderr=subprocess.PIPE,
        start_new_session=True,
    )


def wait_for_flights(folder: Path, count: int, process: "subprocess.Popen[bytes]") -> None:
    for _ in range(1200):
        if (folder / JOURNAL).exists() and len(journal_keys(folder)) >= count:
            return
        assert process.poll() is None, process.communicate()[1].decode()
        time.sleep(0.05)
    raise AssertionError("the campaign did not fly")


def members(group: int) -> list[int]:
    """The living processes of a process group."""
    found = []
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = stat.read_text().rpartition(")")[2].split()
        except OSError:
            continue
        if int(fields[2]) == group and fields[0] != "Z":
            found.append(int(stat.parent.name))
    return found


def wait_until_gone(group: int) -> None:
    for _ in range(200):
        if not members(group):
            return
        time.sleep(0.05)
    raise AssertionError(f"processes {members(group)} live on")


def test_a_killed_campaign_goes_on_without_losing_or_repeating_a_flight(tmp_path: Path) -> None:
    folder = tmp_path / "campaign"
    process = start(tmp_path, folder)
    wait_for_flights(folder, 3, process)
    os.kill(process.pid, signal.SIGKILL)
    process.communicate()
    kept = journal_keys(folder)
    wait_until_gone(process.pid)  # its workers notice, and die
    assert 3 <= len(kept) < 16
    assert not (folder / TABLE).exists()

    log = Log()
    rows = run_campaign(small_campaign(8), folder, processes=2, observers=[log])
    assert log.start == (16, len(kept))
    assert not set(log.keys) & set(kept)
    assert Counter(journal_keys(folder)) == Counter({row.key: 1 for row in rows})
    run_campaign(small_campaign(8), tmp_path / "undisturbed")
    assert untimed(folder / TABLE) == untimed(tmp_path / "undisturbed" / TABLE)


def test_ctrl_c_ends_in_order_with_what_was_flown(tmp_path: Path) -> None:
    folder = tmp_path / "campaign"
    process = start(tmp_path, folder)
    wait_for_flights(folder, 2, process)
    os.killpg(process.pid, signal.SIGINT)  # as the terminal does: to all of them
    errors = process.communicate(timeout=60)[1].decode()
    assert "KeyboardInterrupt" in errors and "Traceback" in errors  # the API's way to say so
    wait_until_gone(process.pid)
    kept = journal_keys(folder)
    assert 2 <= len(kept) < 16
    assert sorted(row.key for row in read_rows(folder / TABLE)) == sorted(kept)


def test_a_failing_flight_ends_the_campaign_and_keeps_the_others(tmp_path: Path) -> None:
    class Failing(SoloCrew):
        def fly(self, flights):  # type: ignore[no-untyped-def]
            yield from super().fly(flights[:2])
            raise OSError("the disk is gone")

    campaign = small_campaign(2)
    log = Log()
    crew = Failing(campaign.world, campaign.base, None)
    with pytest.raises(OSError, match="the disk is gone"):
        run_campaign(campaign, tmp_path, crew=crew, observers=[log])
    assert len(read_rows(tmp_path / TABLE)) == 2 and log.ends == 1
    assert len(run_campaign(campaign, tmp_path)) == 4


def test_two_campaigns_do_not_write_one_folder(tmp_path: Path) -> None:
    with (
        FlightJournal(tmp_path / JOURNAL),
        pytest.raises(RuntimeError, match=r"another campaign is writing .*journal"),
    ):
        run_campaign(small_campaign(1), tmp_path)


def test_processes_must_be_some(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="processes"):
        run_campaign(small_campaign(1), tmp_path, processes=0)
