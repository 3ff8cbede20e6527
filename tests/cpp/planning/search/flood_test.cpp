// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The flood over bit columns against a flood over 26 neighbours, cell by cell.
#include "planning/search/flood.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <stdexcept>
#include <vector>

#include "ltp/planning/grid_planner.hpp"
#include "scenes.hpp"
#include "slow_distances.hpp"

namespace ltp::planning {
namespace {

void expect_like_slow(Flood& flood, const OccupancyGrid& grid, const Cell& from,
                      const LevelRange& levels) {
  flood.fill(grid, from, levels);
  const std::vector<char> expected = test::reachable(grid, from, levels);
  const GridFrame& frame = grid.frame();
  std::int64_t count = 0;
  bool edge = false;
  for (std::int64_t i = 0; i < frame.size(); ++i) {
    const Cell cell = frame.cell_at(i);
    ASSERT_EQ(flood.reached(cell), expected[i] != 0) << cell.transpose();
    if (!expected[i]) continue;
    ++count;
    for (int axis = 0; axis < 3; ++axis) {
      edge |= cell[axis] == 0 || cell[axis] == frame.dims()[axis] - 1;
    }
  }
  ASSERT_EQ(flood.count(), count);
  ASSERT_EQ(flood.touched_edge(), edge);
}

TEST(Flood, ReachesWhat26NeighboursReach) {
  std::mt19937_64 random(1);
  Flood flood;  // one for all: it must forget the last grid
  int compared = 0;
  for (const int nz : {1, 2, 6, 63, 64, 65, 130}) {
    for (int k = 0; k < 40; ++k) {
      const GridFrame frame(
          Point(0, 0, 0), Point(2, 2, 4),
          {1 + static_cast<int>(random() % 8), 1 + static_cast<int>(random() % 8), nz});
      OccupancyGrid grid(frame);
      const std::uint64_t density = 3 + random() % 5;
      for (std::int64_t i = 0; i < frame.size(); ++i) {
        if (random() % 10 < density) grid.set(frame.cell_at(i));
      }
      // Sometimes from a blocked cell: a UAV may stand in one.
      const Cell from = frame.cell_at(static_cast<std::int64_t>(random() % frame.size()));
      LevelRange levels{0, nz - 1};
      if (k % 3 == 1) levels = {from.z(), from.z()};
      if (k % 3 == 2) {
        levels.lowest = from.z() - static_cast<int>(random() % (from.z() + 1));
        levels.highest = from.z() + static_cast<int>(random() % (nz - from.z()));
      }
      expect_like_slow(flood, grid, from, levels);
      if (HasFatalFailure()) return;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 7 * 40);
}

TEST(Flood, AgreesOnTheScenesOfThePlanners) {
  Flood flood;
  for (const test::Situation& situation : test::situations()) {
    const GridFrame& frame = situation.grid.frame();
    if (!frame.contains(situation.query.start) || !frame.contains(situation.query.goal)) continue;
    SCOPED_TRACE(situation.name);
    expect_like_slow(flood, situation.grid, frame.cell_of(situation.query.start),
                     levels_of(frame, situation.query));
    if (HasFatalFailure()) return;
  }
}

TEST(Flood, ForgetsTheLastFillHoweverLargeItWas) {
  // Rooms of many sizes on one grid, so that large fills follow small ones and small ones large
  // ones; and grids of one size whose shapes differ.
  std::mt19937_64 random(2);
  Flood flood;
  int small = 0;
  int large = 0;
  for (const std::array<int, 3>& dims :
       {std::array<int, 3>{24, 10, 5}, {10, 24, 5}, {24, 10, 70}, {24, 10, 5}}) {
    const GridFrame frame(Point(0, 0, 0), Point(1, 1, 1), dims);
    OccupancyGrid grid(frame);
    for (const int wall : {2, 5, 8}) {
      for (int iy = 0; iy < frame.ny(); ++iy) {
        for (int iz = 0; iz < frame.nz(); ++iz) grid.set(Cell(wall, iy, iz));
      }
    }
    for (int k = 0; k < 40; ++k) {
      const Cell from = frame.cell_at(static_cast<std::int64_t>(random() % frame.size()));
      expect_like_slow(flood, grid, from, {0, frame.nz() - 1});
      if (HasFatalFailure()) return;
      (flood.count() * 8 > frame.size() ? large : small) += 1;
    }
  }
  EXPECT_GT(small, 20);
  EXPECT_GT(large, 20);
}

TEST(Flood, EndsEarlyOnlyWhereTheAnswerIsKnown) {
  std::mt19937_64 random(3);
  Flood whole;
  Flood brief;  // one for all: it must forget where it was left
  int walled_off = 0;
  int spared = 0;
  for (int k = 0; k < 400; ++k) {
    const GridFrame frame(Point(0, 0, 0), Point(2, 2, 4), {12, 12, k % 2 == 0 ? 9 : 70});
    OccupancyGrid grid(frame);
    for (std::int64_t i = 0; i < frame.size(); ++i) {
      if (random() % 20 < 4 + static_cast<unsigned>(k % 14)) grid.set(frame.cell_at(i));
    }
    const Cell from(6, 6, 4);
    const Cell until = frame.cell_at(static_cast<std::int64_t>(random() % frame.size()));
    const LevelRange levels{0, frame.nz() - 1};
    whole.fill(grid, from, levels);
    brief.fill(grid, from, levels, until);
    const bool open = whole.touched_edge() || whole.reached(until);
    ASSERT_EQ(brief.touched_edge() || brief.reached(until), open);
    for (std::int64_t i = 0; i < frame.size(); ++i) {
      const Cell cell = frame.cell_at(i);
      ASSERT_LE(brief.reached(cell), whole.reached(cell)) << cell.transpose();
    }
    if (!open) {
      ASSERT_EQ(brief.count(), whole.count());
      ++walled_off;
    }
    spared += brief.count() < whole.count();
  }
  EXPECT_GT(walled_off, 50);
  EXPECT_GT(spared, 50);
}

TEST(Flood, PartsNothingThatItWouldJoin) {
  std::mt19937_64 random(1);
  Flood brief;
  int parted = 0;
  int joined = 0;
  for (int k = 0; k < 2000; ++k) {
    OccupancyGrid grid = test::random_grid(random);
    const Cell inside = test::random_cell(random, grid.frame());
    const Cell outside = test::random_cell(random, grid.frame());
    if (inside == outside) continue;
    grid.set(inside, false);
    grid.set(outside, false);
    const LevelRange levels{std::min(inside.z(), outside.z()), grid.frame().nz() - 1};
    Flood flood;
    flood.fill(grid, inside, levels);
    const bool answer = brief.parts(grid, inside, outside, levels, random() % 200);
    if (flood.reached(outside)) {
      ASSERT_FALSE(answer) << k;
    }
    ASSERT_EQ(brief.parts(grid, inside, outside, levels, 1 << 20), !flood.reached(outside)) << k;
    (answer ? parted : joined) += 1;
  }
  EXPECT_GT(parted, 200);
  EXPECT_GT(joined, 500);
}

TEST(Flood, PartsAClosedRoomFromTheRest) {
  OccupancyGrid grid(GridFrame({0, 0, 0}, {2, 2, 4}, {80, 80, 20}));
  for (int x = 30; x <= 50; ++x) {
    for (int y = 30; y <= 50; ++y) {
      for (int z = 0; z <= 15; ++z) {
        grid.set(Cell(x, y, z), x % 20 == 10 || y % 20 == 10 || z % 15 == 0);
      }
    }
  }
  const LevelRange all{0, 19};
  Flood flood;
  EXPECT_TRUE(flood.parts(grid, Cell(40, 40, 8), Cell(3, 3, 8), all, 1024));
  EXPECT_TRUE(flood.parts(grid, Cell(40, 40, 8), Cell(3, 3, 8), {8, 8}, 1024));
  EXPECT_FALSE(flood.parts(grid, Cell(40, 40, 8), Cell(45, 32, 2), all, 1024));
  EXPECT_FALSE(flood.parts(grid, Cell(3, 3, 8), Cell(40, 40, 8), all, 1024))
      << "the rest is too much";
  grid.set(Cell(30, 42, 1), false);
  EXPECT_FALSE(flood.parts(grid, Cell(40, 40, 8), Cell(3, 3, 8), all, 1024));
  EXPECT_TRUE(flood.parts(grid, Cell(40, 40, 8), Cell(3, 3, 8), {8, 8}, 1024));
}

TEST(Flood, FollowsACorridorAllTheWay) {
  // A serpentine through 31 columns and 70 levels: news come back to a column again and again.
  const int nz = 70;
  OccupancyGrid grid(GridFrame(Point(0, 0, 0), Point(1, 1, 1), {31, 31, nz}));
  for (int iz = 1; iz < nz; iz += 2) {
    for (int ix = 0; ix < 31; ++ix) {
      for (int iy = 0; iy < 31; ++iy) grid.set(Cell(ix, iy, iz));
    }
    const int end = iz / 2 % 2 == 0 ? 30 : 0;
    grid.set(Cell(end, end, iz), false);
  }
  for (int iz = 0; iz < nz; iz += 2) {
    for (int ix = 1; ix < 31; ix += 2) {
      for (int iy = 0; iy < 31; ++iy) {
        if (iy != (ix / 2 % 2 == 0 ? 30 : 0)) grid.set(Cell(ix, iy, iz));
      }
    }
  }
  Flood flood;
  expect_like_slow(flood, grid, Cell(0, 0, 0), {0, nz - 1});
  EXPECT_TRUE(flood.reached(Cell(0, 0, nz - 2)));
  EXPECT_GT(flood.count(), 35 * 500);
}

TEST(Flood, FollowsACorridorOfMoreThanAMillionColumns) {
  // One column is news at a time: none may be lost on the way.
  const GridFrame frame(Point(0, 0, 0), Point(1, 1, 1), {1500, 1501, 1});
  OccupancyGrid grid(frame);
  for (int iy = 1; iy < 1501; iy += 2) {
    for (int ix = 0; ix < 1500; ++ix) grid.set(Cell(ix, iy, 0));
    grid.set(Cell(iy % 4 == 1 ? 1499 : 0, iy, 0), false);
  }
  Flood flood;
  flood.fill(grid, Cell(0, 0, 0), {0, 0});
  EXPECT_EQ(flood.count(), 751 * 1500 + 750);
  EXPECT_TRUE(flood.reached(Cell(0, 1500, 0)));
}

TEST(Flood, ProvesNothingAtTheEdgeOfTheWindow) {
  const GridFrame frame(Point(0, 0, 0), Point(1, 1, 1), {9, 9, 66});
  const Cell middle(4, 4, 33);
  OccupancyGrid box(frame);
  for (std::int64_t i = 0; i < frame.size(); ++i) {
    const Cell cell = frame.cell_at(i);
    const bool wall = ((cell - middle).cwiseAbs().array() - Cell(2, 2, 20).array()).maxCoeff() == 0;
    if (wall) box.set(cell);
  }
  Flood flood;
  flood.fill(box, middle, {0, 65});
  EXPECT_FALSE(flood.touched_edge());
  EXPECT_EQ(flood.count(), 3 * 3 * 39);
  flood.fill(box, Cell(0, 0, 0), {0, 65});
  EXPECT_TRUE(flood.touched_edge());
  // Shafts to each side in turn.
  for (int axis = 0; axis < 3; ++axis) {
    for (const int step : {-1, 1}) {
      OccupancyGrid shaft(frame);
      for (std::int64_t i = 0; i < frame.size(); ++i) shaft.set(frame.cell_at(i));
      for (Cell cell = middle; frame.contains(cell); cell[axis] += step) shaft.set(cell, false);
      flood.fill(shaft, middle, {0, 65});
      EXPECT_TRUE(flood.touched_edge());
      Cell end = middle;
      end[axis] = step < 0 ? 0 : frame.dims()[axis] - 1;
      shaft.set(end);
      flood.fill(shaft, middle, {0, 65});
      EXPECT_FALSE(flood.touched_edge());
    }
  }
}

TEST(Flood, RefusesToBeginOutside) {
  const GridFrame frame(Point(0, 0, 0), Point(1, 1, 1), {3, 3, 5});
  const OccupancyGrid grid(frame);
  Flood flood;
  EXPECT_FALSE(flood.reached(Cell(0, 0, 0))) << "nothing is reached before the first fill";
  for (const Cell& from :
       {Cell(-1, 0, 2), Cell(0, 3, 2), Cell(0, 0, 5), Cell(0, 0, 1), Cell(0, 0, 4)}) {
    EXPECT_THROW(flood.fill(grid, from, {2, 3}), std::invalid_argument) << from.transpose();
  }
  // Levels beyond the frame are those of the frame.
  flood.fill(grid, Cell(1, 1, 1), {-100, 1000});
  EXPECT_EQ(flood.count(), 45);
  for (const Cell& cell : {Cell(-1, 0, 0), Cell(0, 3, 0), Cell(0, 0, 5), Cell(0, 0, 63)}) {
    EXPECT_FALSE(flood.reached(cell));
  }
}

}  // namespace
}  // namespace ltp::planning
