// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `GridFrame`: points, cells and indices agree wherever the window lies, and beyond it.
#include "ltp/grid/frame.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <string>

namespace ltp {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kMax = std::numeric_limits<int>::max();
constexpr int kMin = std::numeric_limits<int>::min();

TEST(GridFrame, FindsTheCellOfEveryCentreAndIndex) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int round = 0; round < 50; ++round) {
    const double far = std::pow(10.0, 7.0 * unit(random) - 1.0);
    const Point anchor(far * (unit(random) - 0.5), -far * unit(random), far * unit(random));
    const Point edge(0.1 + unit(random), 2.0, 0.1 + 9.0 * unit(random));
    const Cell shift(static_cast<int>(random() % 20001) - 10000, round, -round);
    const GridFrame frame = GridFrame(anchor, edge, {5, 3, 7}).shifted(shift);
    std::set<std::int64_t> indices;
    for (int ix = 0; ix < 5; ++ix) {
      for (int iy = 0; iy < 3; ++iy) {
        for (int iz = 0; iz < 7; ++iz) {
          const Cell cell(ix, iy, iz);
          ASSERT_EQ(frame.cell_of(frame.centre(cell)), cell);
          ASSERT_EQ(frame.cell_at(frame.index(cell)), cell);
          ASSERT_TRUE(frame.contains(cell));
          ASSERT_TRUE(frame.contains(frame.centre(cell)));
          ASSERT_LT((frame.centre(cell) - frame.origin() -
                     (Point(ix, iy, iz).array() + 0.5).matrix().cwiseProduct(edge))
                        .norm(),
                    1e-6 * edge.norm());
          ASSERT_TRUE(indices.insert(frame.index(cell)).second);
        }
      }
    }
    EXPECT_EQ(*indices.begin(), 0);
    EXPECT_EQ(*indices.rbegin(), frame.size() - 1);
    EXPECT_EQ(frame.index(Cell(0, 0, 1)), 1) << "z runs fastest";
  }
}

TEST(GridFrame, GivesAFaceToTheUpperCell) {
  // Edges and origins that doubles hold exactly.
  const GridFrame frame =
      GridFrame(Point(-7, 3.5, 10), Point(2, 0.5, 4), {6, 5, 4}).shifted({3, -9, 2});
  const Point origin = frame.origin();
  EXPECT_EQ(origin, Point(-1, -1, 18));
  EXPECT_EQ(frame.upper(), Point(11, 1.5, 34));
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = -3; i <= 8; ++i) {
      Point point = frame.centre(Cell(1, 1, 1));
      point[axis] = origin[axis] + i * frame.cell()[axis];
      EXPECT_EQ(frame.cell_of(point)[axis], i);
      point[axis] = point[axis] - 1e-9;
      EXPECT_EQ(frame.cell_of(point)[axis], i - 1);
    }
  }
  EXPECT_TRUE(frame.contains(origin));
  EXPECT_FALSE(frame.contains(frame.upper()));
}

TEST(GridFrame, PutsFarAndStrangePointsOutside) {
  const double values[] = {
      kNan,          kInfinity,
      -kInfinity,    1e9,
      -1e9,          1e300,
      -1e300,        4.3e9 /* 2^32 + a little: wraps into the window in 32 bits */,
      -4294967295.0, 1.8446744073709552e19};
  for (const Cell& shift : {Cell(0, 0, 0), Cell(1000000, -1000000, 7)}) {
    const GridFrame frame = GridFrame(Point(0, 0, 0), Point(1, 1, 1), {10, 10, 10}).shifted(shift);
    for (int axis = 0; axis < 3; ++axis) {
      for (const double value : values) {
        Point point = frame.centre(Cell(5, 5, 5));
        point[axis] = value;
        EXPECT_FALSE(frame.contains(point)) << point.transpose();
        EXPECT_FALSE(frame.contains(frame.cell_of(point))) << point.transpose();
      }
    }
    for (const Cell& cell : {Cell(kMin, 0, 0), Cell(0, kMax, 0), Cell(0, 0, -1), Cell(10, 0, 0)}) {
      EXPECT_FALSE(frame.contains(cell));
    }
    // A saturated cell has a centre too; it must not wrap into the window.
    EXPECT_FALSE(frame.contains(frame.centre(Cell(kMin, 0, 0))));
    EXPECT_FALSE(frame.contains(frame.centre(Cell(kMax, 0, 0))));
  }
}

TEST(GridFrame, RollsWithoutAddingUpErrors) {
  const GridFrame start(Point(0.3, -0.7, 12.1), Point(0.1, 0.3, 0.7), {20, 20, 20});
  GridFrame frame = start;
  for (int i = 0; i < 1000; ++i) frame = frame.shifted({7, -3, 1});
  EXPECT_TRUE(frame != start);
  EXPECT_NEAR(frame.origin().x(), 0.3 + 700.0, 1e-9);
  for (int i = 0; i < 1000; ++i) frame = frame.shifted({-7, 3, -1});
  EXPECT_TRUE(frame == start);
  EXPECT_EQ(frame.origin(), start.origin());
  // Cells are the same boxes in both windows.
  const GridFrame moved = start.shifted({5, 6, 7});
  EXPECT_EQ(moved.centre(Cell(0, 0, 0)), start.centre(Cell(5, 6, 7)));
}

TEST(GridFrame, CentresTheWindowToTheNearestCell) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal(0.0, 100.0);
  for (const std::array<int, 3>& dims : {std::array<int, 3>{10, 11, 1}, {200, 3, 64}}) {
    GridFrame frame(Point(1, 2, 3), Point(2, 2, 4), dims);
    for (int i = 0; i < 300; ++i) {
      const Point point(normal(random), normal(random), normal(random));
      frame = frame.shifted(frame.shift_to_centre(point));
      const Point off =
          (0.5 * (frame.origin() + frame.upper()) - point).cwiseQuotient(frame.cell());
      ASSERT_LE(off.cwiseAbs().maxCoeff(), 0.5 + 1e-9);
      ASSERT_TRUE(frame.contains(point));
      ASSERT_EQ(frame.shift_to_centre(point), Cell(0, 0, 0));
    }
  }
  const GridFrame frame(Point(0, 0, 0), Point(1, 1, 1), {4, 4, 4});
  for (const Point& point : {Point(kNan, 0, 0), Point(0, -kInfinity, 0), Point(0, 0, 1e10)}) {
    EXPECT_THROW(frame.shift_to_centre(point), std::invalid_argument) << point.transpose();
  }
}

TEST(GridFrame, RefusesToBeShiftedOffTheLattice) {
  const GridFrame frame(Point(0, 0, 0), Point(1, 1, 1), {4, 4, 4});
  EXPECT_THROW(frame.shifted({kMax, 0, 0}), std::invalid_argument);
  EXPECT_THROW(frame.shifted({0, kMin, 0}), std::invalid_argument);
  EXPECT_THROW(frame.shifted({900000000, 0, 0}).shifted({900000000, 0, 0}), std::invalid_argument);
  const GridFrame far = frame.shifted({0, 0, 900000000});
  EXPECT_EQ(far.cell_of(far.centre(Cell(1, 2, 3))), Cell(1, 2, 3));
}

/// Checks that a frame is refused with a message that begins with the argument's name.
void expect_refused(const Point& origin, const Point& cell, const std::array<int, 3>& dims,
                    const std::string& name) {
  try {
    const GridFrame frame(origin, cell, dims);
    ADD_FAILURE() << name << " was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()).rfind(name + " = ", 0), 0u) << error.what();
  }
}

TEST(GridFrame, NamesTheArgumentThatIsWrong) {
  const Point zero = Point::Zero();
  const Point one(1, 1, 1);
  expect_refused(Point(0, kNan, 0), one, {1, 1, 1}, "origin");
  expect_refused(Point(kInfinity, 0, 0), one, {1, 1, 1}, "origin");
  expect_refused(zero, Point(0, 1, 1), {1, 1, 1}, "cell.x");
  expect_refused(zero, Point(1, -1, 1), {1, 1, 1}, "cell.y");
  expect_refused(zero, Point(1, 1, kNan), {1, 1, 1}, "cell.z");
  expect_refused(zero, Point(1, kInfinity, 1), {1, 1, 1}, "cell.y");
  expect_refused(zero, one, {0, 1, 1}, "dims.x");
  expect_refused(zero, one, {1, -5, 1}, "dims.y");
  expect_refused(zero, one, {1, 1, kMin}, "dims.z");
  // Products that overflow 32 bits, and 64.
  expect_refused(zero, one, {65536, 32768, 1}, "dims");
  expect_refused(zero, one, {65536, 65536, 1}, "dims");
  expect_refused(zero, one, {kMax, kMax, kMax}, "dims");
  expect_refused(zero, one, {1, 2, 1073741824}, "dims");
  EXPECT_EQ(GridFrame(zero, one, {1, 1, kMax}).size(), kMax);
  EXPECT_EQ(GridFrame(zero, one, {46340, 46340, 1}).size(), 46340LL * 46340LL);
}

}  // namespace
}  // namespace ltp
