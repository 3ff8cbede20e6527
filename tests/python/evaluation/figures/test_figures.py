# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The figures: written whole, showing what they say, with the attribution of their world."""

import dataclasses
from pathlib import Path

import numpy as np
import pytest
from matplotlib import image as images
from matplotlib.collections import PathCollection
from matplotlib.figure import Figure
from matplotlib.text import Text

from ltp._core import HeightSurface, PenaltyWeights, Raster
from ltp.config import MissionConfig
from ltp.evaluation.campaign.variants import at_ratio, sweep
from ltp.evaluation.figures.backdrop import (
    make_page,
    nested_widths,
    quiet_corner,
    save_figure,
    view_round,
)
from ltp.evaluation.figures.flights import flown_paths_figure, global_paths_figure, sweep_figure
from ltp.evaluation.figures.headline import headline, record_title
from ltp.evaluation.figures.sensing import sensing_figure
from ltp.evaluation.figures.summary import summary_figure
from ltp.evaluation.figures.traps import trap_figure
from ltp.evaluation.scenarios import ScenarioOptions, make_scenarios
from ltp.evaluation.sensed import CellMap, SensedTrace, SnapshotTaker
from ltp.sim import fly
from ltp.sim.mission import Mission
from ltp.sim.record import Outcome
from tests.python.scenes import ATTRIBUTION, event, row, town

OPTIONS = ScenarioOptions(count=3, length=120.0, spacing=40.0, altitude=30.0, margin=10.0)


@pytest.fixture(scope="module")
def flown():
    """A flight of the town with what it sensed: record, snapshots, trace, setup."""
    world = town()
    path = make_scenarios(world, OPTIONS)[0].global_path
    taker, trace = SnapshotTaker(), SensedTrace()
    mission = Mission(world, MissionConfig(), path, [taker, trace])
    return mission.fly(), taker.snapshots, trace, mission.setup


def texts(figure: Figure) -> str:
    """Everything that is written on a figure."""
    return "\n".join(text.get_text() for text in figure.findobj(Text))


def picture(figure: Figure, path: Path) -> np.ndarray:
    """Write a figure and read it back: (height, width, 3) in 0...1."""
    save_figure(figure, path)
    return images.imread(path)[..., :3]


def test_flown_paths_over_surface_and_priority(flown, tmp_path: Path) -> None:
    record, _, _, setup = flown
    shortest = MissionConfig()
    shortest.planner_options.weights = PenaltyWeights(length=1.0, priority=0.0)
    other = fly(setup.world, shortest, setup.global_path)
    figure = flown_paths_figure(setup.world, [other, record], setup.priority)
    written = texts(figure)
    assert ATTRIBUTION in written
    assert "W_P/W_L = 0:" in written and "W_P/W_L = 2:" in written
    assert f"P = {record.mean_priority:.2f}" in written
    assert "east x [m]" in written and "surface height [m]" in written
    left, right = figure.axes[:2]
    for axes in (left, right):
        drawn = [line.get_xydata() for line in axes.lines]
        for path in (record.global_path, other.positions, record.positions):
            assert any(np.array_equal(xy, path[:, :2]) for xy in drawn)
    pixels = picture(figure, tmp_path / "paths.png")
    assert pixels.std() > 0.1 and min(pixels.shape[:2]) > 600


def test_a_waypoint_too_far_is_not_marked_as_proved_unreachable(flown) -> None:
    record, _, _, setup = flown
    fates = [event(0, "dropped", "unreachable"), event(1, "skipped", "too_far")]
    both = texts(
        flown_paths_figure(
            setup.world, [dataclasses.replace(record, waypoints=fates)], setup.priority
        )
    )
    assert "waypoint proved unreachable" in both and "waypoint too far" in both
    far = dataclasses.replace(record, waypoints=fates[1:])
    assert "proved" not in texts(flown_paths_figure(setup.world, [far], setup.priority))


def test_the_same_figure_gives_the_same_bytes(flown, tmp_path: Path) -> None:
    record, _, trace, setup = flown
    for name in ("a.png", "b.png", "a.svg", "a.pdf"):
        save_figure(summary_figure(setup.world, [record], trace), tmp_path / name)
    assert (tmp_path / "a.png").read_bytes() == (tmp_path / "b.png").read_bytes()
    assert b"<svg" in (tmp_path / "a.svg").read_bytes()
    assert (tmp_path / "a.pdf").read_bytes().startswith(b"%PDF")
    with pytest.raises(ValueError, match=r"must end in .png.*figure\.bmp"):
        save_figure(Figure(), tmp_path / "figure.bmp")


def test_global_paths_over_three_maps(tmp_path: Path) -> None:
    world = town()
    scenarios = make_scenarios(world, OPTIONS)
    values = np.zeros((130, 110))
    values[:65] = 1.0
    binary, lowpass = Raster(values, cell=2.0), Raster(values * 0.5, cell=2.0)
    figure = global_paths_figure(world, scenarios, binary, lowpass)
    written = texts(figure)
    assert "3 straight global paths, 3 of them through buildings" in written
    assert "Binary priority, mean 0.50" in written and "mean 0.25" in written
    assert ATTRIBUTION in written
    starts = np.array([scenario.global_path[0, :2] for scenario in scenarios])
    for axes in figure.axes[:3]:
        (dots,) = [c for c in axes.collections if isinstance(c, PathCollection)]
        np.testing.assert_array_equal(dots.get_offsets(), starts)
    assert picture(figure, tmp_path / "scenarios.png").std() > 0.1


def sweep_rows() -> list:
    """Rows whose priority and length grow with the ratio, by a known law."""
    return [
        row(
            key=f"{variant}{i}",
            planner=variant.planner,
            length_weight=variant.length_weight,
            priority_weight=variant.priority_weight,
            priority_map=variant.priority_map,
            mean_priority=0.5 + 0.01 * variant.ratio + 0.02 * i,
            length_ratio=1.2 + 0.05 * variant.ratio,
        )
        for variant in sweep((0.0, 2.0, 5.0))
        for i in range(3)
    ]


def test_the_sweep_shows_means_and_bands_of_both_maps(tmp_path: Path) -> None:
    figure = sweep_figure(sweep_rows(), ATTRIBUTION)
    assert len(figure.axes) == 4 and ATTRIBUTION in texts(figure)
    top, bottom = figure.axes[0], figure.axes[2]
    means = [line.get_xydata() for line in top.lines if line.get_marker() == "o"]
    np.testing.assert_allclose(means[0], [(0.0, 0.52), (2.0, 0.54), (5.0, 0.57)])
    edges = [line.get_ydata() for line in top.lines if line.get_linestyle() == "--"]
    np.testing.assert_allclose(sorted(edge[0] for edge in edges[-2:]), [0.5, 0.54])
    lengths = [line.get_ydata() for line in bottom.lines if line.get_marker() == "o"]
    np.testing.assert_allclose(lengths[0], [1.2, 1.3, 1.45])
    assert picture(figure, tmp_path / "sweep.png").std() > 0.03


def test_no_sweep_no_figure() -> None:
    with pytest.raises(ValueError, match="the rows hold no sweep"):
        sweep_figure([row()], ATTRIBUTION)
    with pytest.raises(ValueError, match="several worlds"):
        sweep_figure([*sweep_rows(), row(world="elsewhere")], ATTRIBUTION)


def test_volume_against_surface_sensing(flown, tmp_path: Path) -> None:
    _, snapshots, _, setup = flown
    figure = sensing_figure(setup.world, snapshots, 50.0)
    written = texts(figure)
    assert "Volume: all that there is" in written and "Surface: what the LiDAR" in written
    assert ATTRIBUTION in written
    assert picture(figure, tmp_path / "sensing.png").std() > 0.05
    with pytest.raises(ValueError, match="snapshots"):
        sensing_figure(setup.world, [], 50.0)


def test_the_figure_of_weights_does_not_hide_a_collision(flown) -> None:
    record, _, _, setup = flown
    hit = dataclasses.replace(record, outcome=Outcome.COLLIDED, collision=(1.0, 2.0, 3.0))
    figure = flown_paths_figure(setup.world, [record, hit], setup.priority)
    written = texts(figure)
    assert "hits an obstacle after" in written and ":  collided" in written
    assert written.count(f"P = {record.mean_priority:.2f}") == 1


def test_what_was_sensed_is_part_of_what_there_is(flown) -> None:
    _, snapshots, trace, setup = flown
    surface = HeightSurface(setup.world.surface_raster())
    for snapshot in snapshots:
        z = float(snapshot.position[2])
        truth = CellMap.of(surface.occupancy(snapshot.occupied.frame)).level(z)
        known, blocked = snapshot.occupied.level(z), snapshot.blocked.level(z)
        assert not np.any(known & ~truth)
        assert not np.any(known & ~blocked)
    assert snapshots[-1].occupied.level(30.0).sum() > 10
    assert not snapshots[-1].occupied.level(1e6).any()
    # The trace is in the world's frame: each of its cells holds some of a tower.
    for x, y in trace.corners:
        i, j = int(x), int(y)
        assert setup.world.surface[i : i + 2, j : j + 2].max() > 28.0
    assert len(trace.corners) >= snapshots[-1].occupied.level(30.0).sum()


def test_the_trap_figure_tells_both_stories(tmp_path: Path) -> None:
    figure = trap_figure()
    written = texts(figure)
    assert "(d) Surface complete: given up, unreachable" in written
    assert "Made-up scenes" in written
    assert picture(figure, tmp_path / "traps.png").std() > 0.05


def test_the_summary_names_planners_and_what_they_reached(flown, tmp_path: Path) -> None:
    record, _, trace, setup = flown
    figure = summary_figure(setup.world, [record], trace)
    written = texts(figure)
    assert f"Auto:  P = {record.mean_priority:.2f}" in written
    assert "obstacle cells sensed" in written and ATTRIBUTION in written
    assert picture(figure, tmp_path / "summary.png").std() > 0.1


def test_a_view_holds_its_path_and_stays_in_the_world() -> None:
    world = town()  # 260 m x 220 m
    path = np.array([(10.0, 100.0, 30.0), (100.0, 120.0, 30.0)])
    x0, y0, x1, y1 = view_round(path, world, 20.0, aspect=1.5)
    assert 0.0 <= x0 <= 10.0 and x1 >= 120.0 and y0 <= 80.0 and y1 >= 140.0
    assert (x1 - x0) / (y1 - y0) == pytest.approx(1.5)
    assert view_round(path, world, 1000.0) == (0.0, 0.0, 260.0, 220.0)


def test_a_legend_keeps_out_of_the_way() -> None:
    box = (0.0, 0.0, 10.0, 10.0)
    rising = np.linspace((0.0, 0.0), (10.0, 10.0), 50)
    assert quiet_corner(box, rising) in ("upper left", "lower right")
    assert quiet_corner(box, rising * (1.0, -1.0) + (0.0, 10.0)) in ("upper right", "lower left")
    assert quiet_corner(box, [(9.0, 9.0), (1.0, 9.0), (9.0, 1.0)]) == "lower left"


def test_the_operating_points_of_the_paper_are_in_the_sweep() -> None:
    assert {0.0, 2.0, 5.0} <= {variant.ratio for variant in sweep()}
    with pytest.raises(ValueError, match="ratio"):
        at_ratio(-1.0)


def test_the_headline_says_what_happened(flown) -> None:
    record, _, _, setup = flown
    world = setup.world

    def said(*changes: dict) -> str:
        return headline(world, [dataclasses.replace(record, **change) for change in changes])

    hit = {"outcome": Outcome.COLLIDED, "collision": (1.0, 2.0, 3.0)}
    late = {"outcome": Outcome.TIMED_OUT}
    record = dataclasses.replace(record, waypoints=[])
    assert said({}) == "Round the buildings on the global path"
    assert said(hit).startswith("The flight hits an obstacle after")
    assert said({}, hit).startswith(f"{record_title(record)} hits an obstacle after")
    assert said({}, hit, {}).endswith("; 2 of 3 fly to the end")
    assert said(hit, late, hit) == "2 of 3 flights: each hits an obstacle"
    assert said(late, {}).startswith(f"{record_title(record)} runs out of time, ")
    drops = [event(i, "dropped", "unreachable") for i in range(len(record.global_path) - 1)]
    assert said({"waypoints": drops[:1]}).endswith(f"; 1 of {len(drops)} waypoints out of reach")
    assert said({"waypoints": drops}) == "No waypoint could be reached"
    none = {"waypoints": drops, "outcome": Outcome.NOTHING_REACHED}
    assert said(none, none) == "No waypoint could be reached"
    # What one planner drops another may reach.
    assert said({}, none).startswith(f"{record_title(record)} reaches no waypoint, ")
    assert said({}, none, {}).endswith("; 2 of 3 fly to the end")
    assert said(none, hit).startswith(f"{record_title(record)} hits an obstacle after")
    assert said({}, {"waypoints": drops[:1]}).endswith(
        f"; up to 1 of {len(drops)} waypoints out of reach"
    )
    far = [event(9, "skipped", "too_far")]
    assert said({"waypoints": far}) == "Round the buildings on the global path; 1 too far"
    over = record.global_path + np.array([0.0, 0.0, 100.0])
    assert said({"global_path": over}) == "Flown to the end"


def test_each_flight_has_an_altitude_profile_and_a_line_that_is_seen(flown) -> None:
    record, _, trace, setup = flown
    twice = dataclasses.replace(record, collision=(1.0, 2.0, 3.0), outcome=Outcome.COLLIDED)
    figure = summary_figure(setup.world, [record, twice], trace)
    map_axes, *strips = figure.axes
    assert len(strips) == 2
    for axes, flight in zip(strips, [record, twice], strict=True):
        way, z = axes.lines[0].get_data()
        np.testing.assert_array_equal(z, flight.positions[:, 2])
        assert way[-1] == pytest.approx(record.length, rel=1e-6)
    assert len(strips[1].lines) == 2  # and where it hit
    # The two coincide: the lower one is the wider.
    lines = [line for line in map_axes.lines if len(line.get_xdata()) == len(record.positions)]
    assert lines[0].get_linewidth() > lines[1].get_linewidth()
    assert "reaches the flight altitude, 30 m" in texts(figure)
    assert nested_widths([record.positions, record.positions + 50.0], 2.0) == [2.0, 2.0]


def test_no_caption_is_cut_off() -> None:
    world = dataclasses.replace(town(), attribution="Data of many owners, " * 20)
    figure, _ = make_page(
        world, 1, "A headline that says more than it should " * 5, "and so on" * 30
    )
    figure.canvas.draw()
    edge = figure.get_window_extent().x1
    assert all(text.get_window_extent().x1 <= edge for text in figure.texts)
