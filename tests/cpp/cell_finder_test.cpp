// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `CellFinder` never disagrees with `GridFrame::cell_of`.
#include "ltp/grid/cell_finder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace ltp {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(CellFinder, AgreesWithTheFrameOnAndNextToEveryFace) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const double edges[] = {0.1, 1.0 / 3.0, 0.5, 2.0, 4.0, 7.3};
  int compared = 0;
  for (int round = 0; round < 200; ++round) {
    const double far = std::pow(10.0, 9.0 * unit(random) - 1.0);
    const Point edge(edges[random() % 6], edges[random() % 6], edges[random() % 6]);
    const Point anchor =
        round % 2 == 0 ? Point(0, 0, 0)
                       : Point(far * (unit(random) - 0.5), far * unit(random), -far * unit(random));
    const Cell shift(static_cast<int>(random() % 2000001) - 1000000,
                     static_cast<int>(random() % 2001) - 1000, static_cast<int>(random() % 21));
    const GridFrame frame = GridFrame(anchor, edge, {40, 70, 9}).shifted(shift);
    const CellFinder finder(frame);
    for (int i = 0; i < 300; ++i) {
      Point point;
      for (int axis = 0; axis < 3; ++axis) {
        const int cell = static_cast<int>(random() % (frame.dims()[axis] + 3)) - 1;
        // A face, the numbers beside it, something within a millionth of a cell of it, any point.
        double at = anchor[axis] + (cell + shift[axis]) * edge[axis];
        switch (random() % 5) {
          case 0:
            at = std::nextafter(at, kInfinity);
            break;
          case 1:
            at = std::nextafter(at, -kInfinity);
            break;
          case 2:
            at += 1e-6 * (unit(random) - 0.5) * edge[axis];
            break;
          case 3:
            at += unit(random) * edge[axis];
            break;
          default:
            break;
        }
        point[axis] = at;
      }
      ASSERT_EQ(finder(point), frame.cell_of(point)) << point.transpose();
      ++compared;
    }
  }
  EXPECT_EQ(compared, 60000);
}

TEST(CellFinder, AgreesWithTheFrameOnStrangePointsAndFrames) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double values[] = {nan,  kInfinity, -kInfinity, 1e300, -1e300, 1e10, -1e10,  0.0,
                           -0.0, 5e-324,    -5e-324,    4.5,   27.5,   2e9,  2e9 - 7};
  const GridFrame frames[] = {
      GridFrame(Point(-10, 0, 3), Point(2, 2, 4), {10, 12, 5}),
      // On the edge of where cells have numbers; edges and anchors at the end of numbers.
      GridFrame(Point(0, 0, 0), Point(2, 2, 2), {20, 20, 20})
          .shifted(Cell(999999990, -999999999, 0)),
      GridFrame(Point(0, 1, 0), Point(1e-310, 1e300, 5e-324), {10, 12, 5}),
      GridFrame(Point(1e18, -1e300, 1e10), Point(1, 1e290, 1e-9), {10, 12, 5}),
  };
  int inside = 0;
  for (const GridFrame& frame : frames) {
    const CellFinder finder(frame);
    for (const double x : values) {
      for (const double y : values) {
        for (const double z : values) {
          for (const Point& point : {Point(x, y, z), Point(frame.origin() + Point(x, y, z))}) {
            ASSERT_EQ(finder(point), frame.cell_of(point)) << point.transpose();
            inside += frame.contains(finder(point));
          }
        }
      }
    }
  }
  EXPECT_GT(inside, 100);
}

}  // namespace
}  // namespace ltp
