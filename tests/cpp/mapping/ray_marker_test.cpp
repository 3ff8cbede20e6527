// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Marking what a ray passes is the exact walk, whatever the ray: any, almost along an axis, through
// edges and corners, between two points of the lattice, and a hair beside all that.
#include "ltp/mapping/ray_marker.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "ltp/grid/ray_walk.hpp"

namespace ltp {
namespace {

OccupancyGrid walked(const GridFrame& frame, const Point& a, const Point& b) {
  OccupancyGrid passed(frame);
  const Cell last = b.array().floor().cast<int>().matrix() - frame.first();
  walk_segment<3>(a, b, [&](const Cell& lattice, double t_in, double t_out) {
    const Cell cell = lattice - frame.first();
    if (t_in < t_out && cell != last && frame.contains(cell)) passed.set(cell);
    return true;
  });
  return passed;
}

TEST(RayMarker, MarksWhatTheExactWalkPasses) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const std::array<int, 3> shapes[] = {
      {30, 25, 20}, {12, 12, 130}, {60, 50, 64}, {1, 40, 7}, {3, 3, 3}};
  const Cell firsts[] = {Cell(0, 0, 0), Cell(-15, -12, -10), Cell(123456789, -987654321, 77777)};
  std::int64_t marked = 0;
  for (int round = 0; round < 60000; ++round) {
    const std::array<int, 3>& dims = shapes[round % 5];
    const Cell first = firsts[round / 5 % 3];
    const GridFrame frame = GridFrame(Point(0, 0, 0), Point(2, 2, 2), dims).shifted(first);
    Point a, b;
    const int kind = round / 15 % 6;
    for (int axis = 0; axis < 3; ++axis) {
      const int n = dims[axis];
      a[axis] = n * unit(random);
      b[axis] = n * unit(random);
      const auto hair = [&] {
        return std::pow(10.0, -4.0 - 13.0 * unit(random)) * (unit(random) - 0.5);
      };
      if (kind == 1) {  // halves: edges and corners
        a[axis] = std::floor(2.0 * a[axis]) / 2.0;
        b[axis] = std::floor(2.0 * b[axis]) / 2.0;
      } else if (kind == 2) {  // a hair beside them
        a[axis] = std::floor(2.0 * a[axis]) / 2.0 + hair();
        b[axis] = std::floor(2.0 * b[axis]) / 2.0 + hair();
      } else if (kind == 3 && random() % 2 == 0) {  // almost, or quite, along an axis
        b[axis] = a[axis] + (random() % 2 == 0 ? 0.0 : hair());
      } else if (kind == 4) {  // from the lattice to anywhere
        a[axis] = std::floor(a[axis]);
      } else if (kind == 5) {  // from a hair beside it, on some axes, to a face
        a[axis] = std::floor(a[axis]) + (random() % 2 == 0 ? 0.0 : hair());
        if (random() % 2 == 0) b[axis] = std::floor(b[axis]);
      }
      const double end = std::nextafter(static_cast<double>(n), 0.0);
      a[axis] = std::clamp(a[axis], 0.0, end) + first[axis];
      b[axis] = std::clamp(b[axis], 0.0, end) + first[axis];
    }
    const auto inside = [&](const Point& point) {  // adding `first` may have rounded out of it
      return frame.contains(Cell(point.array().floor().cast<int>().matrix() - first));
    };
    if (!inside(a) || !inside(b)) continue;
    OccupancyGrid passed(frame);
    mark_passed(a, b, first, passed);
    const OccupancyGrid expected = walked(frame, a, b);
    ASSERT_TRUE(passed == expected) << "round " << round << ", kind " << kind << "\n"
                                    << (a - first.cast<double>()).transpose() << "\n"
                                    << (b - first.cast<double>()).transpose();
    marked += passed.count();
  }
  EXPECT_GT(marked, 500000);
}

TEST(RayMarker, AddsToWhatOtherRaysPassed) {
  const GridFrame frame(Point(0, 0, 0), Point(1, 1, 1), {5, 1, 1});
  OccupancyGrid passed(frame);
  passed.set(Cell(4, 0, 0));
  mark_passed(Point(0.5, 0.5, 0.5), Point(2.5, 0.5, 0.5), Cell::Zero(), passed);
  EXPECT_EQ(passed.count(), 3);
  EXPECT_FALSE(passed.blocked(Cell(2, 0, 0))) << "in which the ray ends";
}

}  // namespace
}  // namespace ltp
