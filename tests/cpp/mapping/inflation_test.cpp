// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Inflation against the distance between every two boxes, and against points drawn at random.
#include "ltp/mapping/inflation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "allocations.hpp"

namespace ltp {
namespace {

OccupancyGrid random_grid(const GridFrame& frame, int count, std::mt19937_64& random) {
  OccupancyGrid grid(frame);
  for (int i = 0; i < count; ++i) {
    grid.set(frame.cell_at(static_cast<std::int64_t>(random() % frame.size())));
  }
  return grid;
}

std::vector<Cell> cells_of(const OccupancyGrid& grid) {
  std::vector<Cell> cells;
  for (std::int64_t i = 0; i < grid.frame().size(); ++i) {
    const Cell cell = grid.frame().cell_at(i);
    if (grid.blocked(cell)) cells.push_back(cell);
  }
  return cells;
}

/// Cell by cell, box by box.
OccupancyGrid slow_inflation(const OccupancyGrid& occupied, double radius) {
  const GridFrame& frame = occupied.frame();
  OccupancyGrid blocked(frame);
  for (const Cell& source : cells_of(occupied)) {
    for (std::int64_t i = 0; i < frame.size(); ++i) {
      const Cell cell = frame.cell_at(i);
      double squares = 0.0;
      for (int axis = 0; axis < 3; ++axis) {
        const double gap =
            std::max(0, std::abs(cell[axis] - source[axis]) - 1) * frame.cell()[axis];
        squares += gap * gap;
      }
      const bool near = radius > 0.0 && std::sqrt(squares) <= radius * (1.0 + 1e-9);
      if (near || cell == source) blocked.set(cell);
    }
  }
  return blocked;
}

struct Shape {
  Point cell;
  std::array<int, 3> dims;
};

const Shape kShapes[] = {
    {{2, 2, 4}, {13, 11, 9}},      {{2, 2, 4}, {9, 8, 80}}, {{1, 1, 1}, {7, 9, 1}},
    {{1, 1, 1}, {6, 5, 64}},       {{1, 1, 1}, {6, 5, 65}}, {{0.3, 0.1, 0.2}, {8, 12, 130}},
    {{0.5, 3.0, 1.5}, {17, 1, 6}}, {{2, 2, 2}, {1, 1, 1}},
};

TEST(Inflation, EqualsTheDistanceBetweenEveryTwoBoxes) {
  std::mt19937_64 random(2);
  int compared = 0;
  for (const Shape& shape : kShapes) {
    const GridFrame frame(Point(5, -3, 1), shape.cell, shape.dims);
    const double smallest = shape.cell.minCoeff();
    // Zero, tiny, whole edges (a gap of exactly the radius counts), 3-4-5, between, and beyond the
    // grid.
    for (const double edges : {0.0, 1e-12, 0.5, 1.0, 2.0, 3.0, 5.0, 2.7, 1e4}) {
      for (const int count : {0, 1, 6}) {
        const OccupancyGrid occupied = random_grid(frame, count, random);
        const double radius = edges * smallest;
        const OccupancyGrid expected = slow_inflation(occupied, radius);
        EXPECT_TRUE(inflate(occupied, radius) == expected)
            << "cell " << shape.cell.transpose() << ", nz " << shape.dims[2] << ", radius "
            << radius;

        // One cell after the other gives the same.
        Inflation inflation(frame, radius);
        OccupancyGrid grown(frame);
        for (const Cell& cell : cells_of(occupied)) inflation.add(cell, grown);
        EXPECT_TRUE(grown == expected) << "radius " << radius;
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 8 * 9 * 3);
}

/// What the cells of parts are, if those parts are blocked that are within reach of one another.
OccupancyGrid slow_inflation(const OccupancyGrid& sources, double radius, const GridFrame& frame,
                             const std::array<int, 3>& parts) {
  OccupancyGrid blocked(frame);
  for (const Cell& part : cells_of(slow_inflation(sources, radius))) {
    blocked.set(Cell(part.x() / parts[0], part.y() / parts[1], part.z() / parts[2]));
  }
  return blocked;
}

const std::array<int, 3> kParts[] = {{1, 1, 2}, {2, 3, 1}, {1, 2, 5}, {3, 1, 2}};

GridFrame parts_of(const GridFrame& frame, const std::array<int, 3>& parts) {
  std::array<int, 3> dims;
  Point cell;
  for (int axis = 0; axis < 3; ++axis) {
    dims[axis] = frame.dims()[axis] * parts[axis];
    cell[axis] = frame.cell()[axis] / parts[axis];
  }
  return GridFrame(frame.origin(), cell, dims);
}

TEST(Inflation, OfPartsEqualsTheDistanceBetweenEveryTwoBoxes) {
  std::mt19937_64 random(12);
  int compared = 0;
  for (const std::array<int, 3>& dims :
       {std::array<int, 3>{7, 6, 5}, {3, 4, 40}, {2, 3, 65}, {4, 1, 64}}) {
    for (const std::array<int, 3>& parts : kParts) {
      const GridFrame frame(Point(0, 0, 0), Point(6, 6, 10), dims);
      const GridFrame fine = parts_of(frame, parts);
      const double smallest = fine.cell().minCoeff();
      for (const double edges : {0.0, 0.5, 1.0, 2.0, 2.7, 30.0}) {
        const OccupancyGrid sources = random_grid(fine, 1 + compared % 4, random);
        const double radius = edges * smallest;
        const OccupancyGrid expected = slow_inflation(sources, radius, frame, parts);
        ASSERT_TRUE(inflate(sources, radius, parts).words() == expected.words())
            << "parts " << parts[0] << parts[1] << parts[2] << ", radius " << radius;
        Inflation inflation(frame, radius, parts);
        OccupancyGrid grown(frame);
        for (const Cell& source : cells_of(sources)) {
          const OccupancyGrid before = grown;
          const bool added = inflation.add(source, grown);
          ASSERT_EQ(added, !(before == grown));
        }
        ASSERT_TRUE(grown == expected) << "radius " << radius;
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 4 * 4 * 6);
}

TEST(Inflation, OfASourceBeyondTheGridIsCutOffAtTheGrid) {
  std::mt19937_64 random(13);
  int compared = 0;
  for (int round = 0; round < 60; ++round) {
    const std::array<int, 3>& parts = kParts[round % 4];
    const int levels = round % 3 == 0 ? 70 : 9;
    const GridFrame wide(Point(0, 0, 0), Point(6, 6, 10), {15, 15, levels});
    const GridFrame inner =
        GridFrame(Point(0, 0, 0), Point(6, 6, 10), {7, 7, levels - 4}).shifted(Cell(4, 4, 2));
    const double radius = 0.5 * static_cast<double>(random() % 50);
    const OccupancyGrid sources = random_grid(parts_of(wide, parts), 3, random);
    const OccupancyGrid all = slow_inflation(sources, radius, wide, parts);
    Inflation inflation(inner, radius, parts);
    OccupancyGrid blocked(inner);
    const Cell first(4 * parts[0], 4 * parts[1], 2 * parts[2]);
    for (const Cell& source : cells_of(sources)) inflation.add(source - first, blocked);
    for (std::int64_t i = 0; i < inner.size(); ++i) {
      const Cell cell = inner.cell_at(i);
      ASSERT_EQ(blocked.blocked(cell), all.blocked(cell + Cell(4, 4, 2))) << "round " << round;
      ++compared;
    }
  }
  EXPECT_GT(compared, 10000);
}

TEST(Inflation, NoPointThatIsNearIsLeftFree) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::normal_distribution<double> normal;
  const GridFrame frame(Point(-20, -20, 0), Point(2, 2, 4), {20, 20, 10});
  const OccupancyGrid occupied = random_grid(frame, 30, random);
  int inside = 0;
  for (const double radius : {0.3, 1.0, 2.5, 6.0}) {
    const OccupancyGrid blocked = inflate(occupied, radius);
    for (const Cell& cell : cells_of(occupied)) {
      for (int i = 0; i < 200; ++i) {
        const Point offset(unit(random) - 0.5, unit(random) - 0.5, unit(random) - 0.5);
        const Point source = frame.centre(cell) + offset.cwiseProduct(frame.cell());
        const Point direction = Point(normal(random), normal(random), normal(random)).normalized();
        const Point near = source + radius * unit(random) * direction;
        if (!frame.contains(near)) continue;
        ++inside;
        ASSERT_TRUE(blocked.blocked_at(near));
      }
    }
  }
  EXPECT_GT(inside, 10000);
}

TEST(Inflation, OfTheDefaultCellsIsWhatTheManualSays) {
  const GridFrame frame(Point(0, 0, 0), Point(2, 2, 4), {9, 9, 9});
  OccupancyGrid occupied(frame);
  occupied.set(Cell(4, 4, 4));
  EXPECT_EQ(inflate(occupied, 0.0).count(), 1);
  EXPECT_EQ(inflate(occupied, 1.0).count(), 27);       // itself and its 26 neighbours
  EXPECT_EQ(inflate(occupied, 2.0).count(), 27 + 36);  // and one cell further along x or y
}

TEST(Inflation, ApplyForgetsWhatWasBlockedBefore) {
  std::mt19937_64 random(4);
  const GridFrame frame(Point(0, 0, 0), Point(1, 1, 1), {10, 10, 70});
  Inflation inflation(frame, 1.5);
  OccupancyGrid blocked = random_grid(frame, 500, random);
  const OccupancyGrid occupied = random_grid(frame, 5, random);
  inflation.apply(occupied, blocked);
  EXPECT_TRUE(blocked == slow_inflation(occupied, 1.5));
  inflation.apply(OccupancyGrid(frame), blocked);
  EXPECT_EQ(blocked.count(), 0);
}

TEST(Inflation, RepairsTheCellsOfABoxAndNoOthers) {
  std::mt19937_64 random(5);
  int repaired = 0;
  for (int round = 0; round < 400; ++round) {
    const Shape& shape = kShapes[round % 8];
    const GridFrame frame(Point(0, 0, 0), shape.cell, shape.dims);
    const OccupancyGrid occupied = random_grid(frame, 5, random);
    const OccupancyGrid before = random_grid(frame, 100, random);
    Inflation inflation(frame, 0.5 * static_cast<double>(random() % 8));
    const OccupancyGrid expected = inflate(occupied, inflation.radius());
    Cell low, high;
    for (int axis = 0; axis < 3; ++axis) {
      const int n = shape.dims[axis];
      low[axis] = static_cast<int>(random() % (n + 4)) - 2;
      high[axis] = low[axis] + static_cast<int>(random() % (n + 2)) - 1;
    }
    OccupancyGrid blocked = before;
    inflation.repair(occupied, low, high, blocked);
    for (std::int64_t i = 0; i < frame.size(); ++i) {
      const Cell cell = frame.cell_at(i);
      const bool in_box =
          (cell.array() >= low.array()).all() && (cell.array() < high.array()).all();
      ASSERT_EQ(blocked.blocked(cell), (in_box ? expected : before).blocked(cell))
          << "round " << round << ", cell " << cell.transpose();
      repaired += in_box;
    }
  }
  EXPECT_GT(repaired, 10000);
}

TEST(Inflation, RollsAsIfMadeAnew) {
  std::mt19937_64 random(6);
  const Shape shapes[] = {{{2, 2, 4}, {24, 19, 12}},
                          {{2, 2, 4}, {9, 30, 70}},
                          {{1, 1, 1}, {12, 7, 64}},
                          {{2, 2, 2}, {3, 4, 5}}};
  int rolls = 0;
  for (const Shape& shape : shapes) {
    for (int radius = 0; radius <= 8; ++radius) {
      const GridFrame frame(Point(-7, 9, 2), shape.cell, shape.dims);
      Inflation inflation(frame, radius);
      OccupancyGrid occupied(frame);
      OccupancyGrid blocked(frame);
      for (int step = 0; step < 60; ++step) {
        for (int i = 0; i < 6; ++i) {
          const Cell cell = frame.cell_at(static_cast<std::int64_t>(random() % frame.size()));
          occupied.set(cell);
          inflation.add(cell, blocked);
        }
        // By one cell or a few, along one axis or several; now and then out of the window.
        Cell shift;
        const int most = step % 15 == 14 ? 40 : step % 3 == 2 ? 6 : 1;
        for (int axis = 0; axis < 3; ++axis) {
          const bool still = random() % 2 == 0;
          shift[axis] = still ? 0 : static_cast<int>(random() % (2 * most + 1)) - most;
        }
        const std::int64_t before = test::allocations();
        occupied.roll(shift);
        inflation.roll(occupied, shift, blocked);
        ASSERT_EQ(test::allocations() - before, 0);
        ASSERT_TRUE(blocked == inflate(occupied, radius))
            << "dims.z " << shape.dims[2] << ", radius " << radius << ", shift "
            << shift.transpose();
        ++rolls;
      }
    }
  }
  EXPECT_EQ(rolls, 4 * 9 * 60);
}

TEST(Inflation, OfPartsRollsAsIfMadeAnew) {
  std::mt19937_64 random(14);
  for (const std::array<int, 3>& parts : kParts) {
    for (const int levels : {9, 66}) {
      const GridFrame frame(Point(-7, 9, 2), Point(6, 6, 10), {14, 11, levels});
      for (const double radius : {0.0, 1.0, 7.5}) {
        Inflation inflation(frame, radius, parts);
        OccupancyGrid sources(parts_of(frame, parts));
        OccupancyGrid blocked(frame);
        for (int step = 0; step < 40; ++step) {
          for (int i = 0; i < 6; ++i) {
            const Cell source = sources.frame().cell_at(
                static_cast<std::int64_t>(random() % sources.frame().size()));
            sources.set(source);
            inflation.add(source, blocked);
          }
          const int most = step % 9 == 8 ? 15 : 2;
          Cell shift;
          for (int axis = 0; axis < 3; ++axis) {
            shift[axis] = static_cast<int>(random() % (2 * most + 1)) - most;
          }
          sources.roll(shift.cwiseProduct(Cell(parts[0], parts[1], parts[2])));
          inflation.roll(sources, shift, blocked);
          ASSERT_TRUE(blocked.words() == inflate(sources, radius, parts).words());
        }
      }
    }
  }
}

TEST(Inflation, RefusesARadiusThatIsNone) {
  const OccupancyGrid grid(GridFrame(Point(0, 0, 0), Point(1, 1, 1), {2, 2, 2}));
  for (const double radius :
       {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(inflate(grid, radius), std::invalid_argument) << radius;
  }
  EXPECT_THROW(inflate(grid, 1.0, {1, 1, 3}), std::invalid_argument) << "no whole cells";
  EXPECT_THROW(inflate(grid, 1.0, {0, 1, 1}), std::invalid_argument);
}

}  // namespace
}  // namespace ltp
