// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// However fast they find it, `GridFrame` and `CellFinder` agree on a point's cell with its
// definition.
#include "ltp/grid/cell_finder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <vector>

namespace ltp {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The definition: the lattice coordinate, rounded down.
Cell cell_by_definition(const GridFrame& frame, const Point& point) {
  Cell cell;
  for (int axis = 0; axis < 3; ++axis) {
    const double number = std::floor(frame.lattice(point)[axis]);
    const bool near = std::abs(number) < kFarthestCell;
    cell[axis] =
        near ? static_cast<int>(number) - frame.first()[axis] : std::numeric_limits<int>::min();
  }
  return cell;
}

/// Asks every way there is. Returns for how many points the finder was not sure.
int expect_cells(const GridFrame& frame, const std::vector<Point>& points) {
  std::vector<Cell> expected;
  for (const Point& point : points) {
    expected.push_back(cell_by_definition(frame, point));
    const bool inside = frame.contains(expected.back());
    EXPECT_EQ(frame.cell_of(point), expected.back()) << point.transpose();
    EXPECT_EQ(frame.contains(point), inside) << point.transpose();
    EXPECT_EQ(frame.find(point), inside ? std::optional(expected.back()) : std::nullopt);
  }
  const Eigen::Map<const Path> rows(points.front().data(), static_cast<Eigen::Index>(points.size()),
                                    3);
  Eigen::Index next = 0;
  int unsure = 0;
  CellFinder(frame).for_each(
      rows,
      [&](Eigen::Index i, const Cell& cell) {
        EXPECT_EQ(i, next++);
        EXPECT_EQ(cell, expected[i]) << points[i].transpose();
        EXPECT_TRUE(frame.contains(cell));
      },
      [&](Eigen::Index i) {
        EXPECT_EQ(i, next++);
        ++unsure;
      });
  EXPECT_EQ(next, rows.rows());
  return unsure;
}

TEST(CellFinder, IsRightOnAndNextToEveryFace) {
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
    std::vector<Point> points;
    for (int i = 0; i < 301; ++i) {
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
      points.push_back(point);
    }
    expect_cells(frame, points);
    compared += static_cast<int>(points.size());
  }
  EXPECT_EQ(compared, 60200);
}

TEST(CellFinder, IsSureOfNearlyEveryPointInTheWindow) {
  std::mt19937_64 random(2);
  const GridFrame frame =
      GridFrame(Point(0, 0, 0), Point(2, 2, 4), {200, 200, 40}).shifted(Cell(3000, -20000, 100));
  std::vector<Point> points;
  for (int i = 0; i < 100001; ++i) {
    points.push_back(frame.origin() + (Point::Random().array() * 0.5 + 0.5)
                                          .matrix()
                                          .cwiseProduct(frame.upper() - frame.origin()));
  }
  EXPECT_LT(expect_cells(frame, points), 10);
}

TEST(CellFinder, LooksOnlyBetweenItsBalls) {
  const GridFrame frame(Point(-20, -20, -20), Point(2, 2, 2), {20, 20, 20});
  const Point centre(1.5, -2.5, 0.5);
  // Rows of a wider table: three columns in the middle of five.
  const Eigen::Matrix<double, Eigen::Dynamic, 5, Eigen::RowMajor> table =
      12.0 * Eigen::Matrix<double, 999, 5, Eigen::RowMajor>::Random();
  int inside = 0;
  CellFinder(frame, {centre, 3.0, 8.0})
      .for_each(
          table.middleCols<3>(1),
          [&](Eigen::Index i, const Cell& cell) {
            const Point point = table.row(i).segment<3>(1).transpose();
            EXPECT_LT((point - centre).squaredNorm(), 64.0);
            EXPECT_GT((point - centre).squaredNorm(), 9.0);
            EXPECT_EQ(cell, frame.cell_of(point));
            ++inside;
          },
          [&](Eigen::Index i) {
            const double square = (table.row(i).segment<3>(1).transpose() - centre).squaredNorm();
            EXPECT_TRUE(square >= 64.0 || square <= 9.0) << square;
          });
  EXPECT_GT(inside, 100);
  EXPECT_LT(inside, 900);
  CellFinder(frame).for_each(
      Path(0, 3), [](Eigen::Index, const Cell&) { FAIL(); }, [](Eigen::Index) { FAIL(); });
}

TEST(CellFinder, IsRightAboutStrangePointsAndFrames) {
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
    std::vector<Point> points;
    for (const double x : values) {
      for (const double y : values) {
        for (const double z : values) {
          points.push_back(Point(x, y, z));
          points.push_back(frame.origin() + points.back());
        }
      }
    }
    expect_cells(frame, points);
    for (const Point& point : points) inside += frame.contains(point);
  }
  EXPECT_GT(inside, 100);
}

}  // namespace
}  // namespace ltp
