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

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from ltp.config import MissionConfig
from ltp.evaluation.campaign import JOURNAL, RECORDS, TABLE, Campaign, run_campaign
from ltp.evaluation.flights import record_path
from ltp.evaluation.journal import Journal
from ltp.evaluation.rows import COLUMNS, TIME_PREFIX, FlightRow, read_rows, write_rows
from ltp.evaluation.scenarios import ScenarioOptions, make_scenarios
from ltp.evaluation.variants import (
    SWEEP_RATIOS,
    TABLE_I,
    TABLE_II,
    TABLES,
    Variant,
    at_ratio,
    rows_of,
    sweep,
    unique,
    with_refined,
)
from ltp.evaluation.workers import SoloCrew
from ltp.planners import PLANNERS
from ltp.sim.record import FlightRecord

from .scenes import row, town

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
from ltp.evaluation.campaign import Campaign, run_campaign
from ltp.evaluation.scenarios import ScenarioOptions, make_scenarios
from ltp.evaluation.variants import Variant
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
        Journal(tmp_path / JOURNAL),
        pytest.raises(RuntimeError, match=r"another campaign is writing .*journal"),
    ):
        run_campaign(small_campaign(1), tmp_path)


@given(st.data())
def test_a_journal_cut_anywhere_keeps_its_whole_lines(data: st.DataObject) -> None:
    import tempfile

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / JOURNAL
        rows = [row(key=f"k{i}", world="Zürich | « »") for i in range(4)]
        with Journal(path) as journal:
            for line in rows:
                journal.append(line)
        whole = path.read_bytes()
        cut = data.draw(st.integers(0, len(whole)))
        path.write_bytes(whole[:cut])
        lines = whole[:cut].count(b"\n")
        with Journal(path) as journal:
            assert list(journal.rows.values()) == rows[: max(0, lines - 1)]
            journal.append(row(key="new"))
        with Journal(path) as journal:
            assert list(journal.rows) == [f"k{i}" for i in range(max(0, lines - 1))] + ["new"]


def test_a_journal_takes_each_flight_once(tmp_path: Path) -> None:
    with Journal(tmp_path / JOURNAL) as journal:
        journal.append(row())
        with pytest.raises(ValueError, match="k0"):
            journal.append(row())


def test_a_damaged_journal_is_told_by_line(tmp_path: Path) -> None:
    path = tmp_path / JOURNAL
    with Journal(path) as journal:
        for i in range(3):
            journal.append(row(key=f"k{i}"))
    lines = path.read_bytes().splitlines(keepends=True)
    lines[2] = lines[2].replace(b'"length": 550.0', b'"length": "far"')
    path.write_bytes(b"".join(lines))
    with pytest.raises(ValueError, match=r"journal.jsonl, line 3 is damaged .*length: 'far'"):
        Journal(path)
    for content in (b"world,planner\n1,2\n", b"world", b"[]\n", b"\xff\xfe\n"):
        path.write_bytes(content)
        with pytest.raises(ValueError, match=r"journal\.jsonl"):
            Journal(path)
        assert path.read_bytes() == content  # a stranger's file is left alone


texts = st.text(st.characters(codec="utf-8", exclude_characters="\x00"), max_size=20)
reals = st.floats(allow_nan=False)


@example(
    world='a\rb\nc,"d"',
    length=0.1,
    priority=0.0,
    clearance=1e300,
    time=None,
    collided=False,
    scenario=0,
)
@given(
    world=texts,
    length=reals,
    priority=st.floats(0, 1),
    clearance=reals,
    time=st.none() | reals,
    collided=st.booleans(),
    scenario=st.integers(0, 10**9),
)
def test_rows_survive_the_csv_exactly(
    world: str,
    length: float,
    priority: float,
    clearance: float,
    time: float | None,
    collided: bool,
    scenario: int,
) -> None:
    import tempfile

    line = row(
        world=world,
        length=length,
        mean_priority=priority,
        min_clearance=clearance,
        time_plan_mean=time,
        collided=collided,
        scenario=scenario,
    )
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "flights.csv"
        write_rows(path, [line, row()])
        assert read_rows(path) == [line, row()]


def test_a_csv_from_before_refinement_was_flown_without(tmp_path: Path) -> None:
    path = tmp_path / "flights.csv"
    write_rows(path, [row(), row(refine=True)])
    table = [line.split(",") for line in path.read_text().splitlines()]
    column = table[0].index("refine")
    assert [line[column] for line in table[1:]] == ["no", "yes"]
    path.write_text("".join(",".join(x[:column] + x[column + 1 :]) + "\n" for x in table[:2]))
    assert read_rows(path) == [row()]


@pytest.mark.parametrize(
    ("old", "new", "complaint"),
    [
        ("550.0", "far", "line 2: length: 'far'"),
        ("550.0", "nan", "line 2: length"),
        ("yes", "maybe", "line 2: crosses_building: 'maybe'"),
        ("length_ratio", "ratio", "missing columns: length_ratio"),
        ("0.5\n", "0.5,7\n", "line 2: unknown columns"),
    ],
)
def test_a_damaged_csv_is_told_by_line(tmp_path: Path, old: str, new: str, complaint: str) -> None:
    path = tmp_path / "flights.csv"
    write_rows(path, [row()])
    path.write_text(path.read_text().replace(old, new, 1))
    with pytest.raises(ValueError, match=complaint) as error:
        read_rows(path)
    assert "flights.csv" in str(error.value)


def test_the_rows_of_the_papers_tables() -> None:
    assert len(TABLE_I) == 7 and len(TABLE_II) == 3 and len(set(TABLES)) == 10
    assert {variant.planner for variant in TABLES} == set(PLANNERS[:4])
    assert at_ratio(0.0) == TABLE_I[0] and at_ratio(2.0) == TABLE_I[1]
    assert at_ratio(2.0, priority_map="lpf") == TABLE_II[0]
    assert [at_ratio(ratio).ratio for ratio in SWEEP_RATIOS] == list(SWEEP_RATIOS)
    assert len(unique([*TABLES, *sweep()])) == 10 + 2 * len(SWEEP_RATIOS) - 3
    assert rows_of("ggwp") == [TABLE_I[6]]
    twins = with_refined(TABLE_II)
    assert twins[::2] == list(TABLE_II) and all(variant.refine for variant in twins[1::2])
    assert twins[1] == TABLE_II[0].refined != TABLE_II[0]
    assert {v.priority_map for v in rows_of("bezier")} == {"binary", "lpf"}


@pytest.mark.parametrize(
    ("arguments", "complaint"),
    [
        (("a-star", 1.0, 0.0), "planner .*lp-a-star.*'a-star'"),
        (("ggwp", -1.0, 0.0), "weights"),
        (("ggwp", 0.0, 0.0), "weights"),
        (("ggwp", float("nan"), 0.0), "weights"),
        (("ggwp", 1.0, 0.0, "blurred"), "priority_map"),
    ],
)
def test_a_bad_variant_is_refused(arguments: tuple[object, ...], complaint: str) -> None:
    with pytest.raises(ValueError, match=complaint):
        Variant(*arguments)  # type: ignore[arg-type]


def test_processes_must_be_some(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="processes"):
        run_campaign(small_campaign(1), tmp_path, processes=0)
