// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The distance in the open against a textbook's Dijkstra near by and its own formula far off.
#include "planning/search/octile_distance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <random>
#include <vector>

#include "planning/search/length_units.hpp"
#include "slow_distances.hpp"

namespace ltp::planning {
namespace {

using Units = OctileDistance::Units;

const Point kEdges[] = {{2, 2, 4}, {1, 1, 1}, {1, 2, 3}, {5, 0.1, 1}};

Cell by(const Step& step) { return step.offset(); }

int bit_of(const Cell& cell) { return neighbour_bit(cell.x(), cell.y(), cell.z()); }

/// Somewhere in a cell; in its centre every other time.
Point random_point(std::mt19937_64& random, const GridFrame& frame, const Cell& cell) {
  std::uniform_real_distribution<double> unit(0.01, 0.99);
  if (random() % 2 == 0) return frame.centre(cell);
  const Point in_cell(unit(random), unit(random), unit(random));
  return frame.origin() + (cell.cast<double>() + in_cell).cwiseProduct(frame.cell());
}

Cell random_offset(std::mt19937_64& random, int reach) {
  std::uniform_int_distribution<int> any(-reach, reach);
  return Cell(any(random), any(random), any(random));
}

/// Of the steps along three axes, two, one, as many as there can be.
Units octile(const std::array<Units, kSteps>& lengths, Cell offset) {
  Units sum = 0;
  while (offset != Cell::Zero()) {
    const Cell step = offset.cwiseMin(1).cwiseMax(-1);
    for (int i = 0; i < kSteps; ++i) sum += by(steps()[i]) == step ? lengths[i] : 0;
    offset -= step;
  }
  return sum;
}

TEST(OctileDistance, IsTheTextbooksWhereNothingIsInTheWay) {
  std::mt19937_64 random(1);
  OctileDistance distance;
  const LengthUnits units(1e4);
  for (const Point& edges : kEdges) {
    for (int k = 0; k < 30; ++k) {
      const GridFrame frame({0, 0, 0}, edges, {13, 12, k % 3 == 0 ? 1 : 11});
      const Cell target = test::random_cell(random, frame);
      const Point point = random_point(random, frame, target);
      std::array<Units, 27> last{};
      for (const Step& step : steps()) {
        const Cell from = target + by(step);
        last[bit_of(by(step))] = frame.contains(from) ? units((frame.centre(from) - point).norm())
                                                      : OctileDistance::kNoStep;
      }
      distance.aim(target, units.of_steps(edges), last);
      const std::vector<double> expected = test::slow_distances(
          OccupancyGrid(frame), target, {0, frame.nz() - 1},
          [&](const Cell& cell) { return cell == target ? point : frame.centre(cell); });
      for (std::int64_t i = 0; i < frame.size(); ++i) {
        if (frame.cell_at(i) == target) continue;
        ASSERT_NEAR(units.metres(distance(frame.cell_at(i))), expected[i], 1e-9);
      }
    }
  }
}

TEST(OctileDistance, EndsWithTheBestOfAnyLastSteps) {
  // Whatever the last steps cost, and where there is but one of them.
  std::mt19937_64 random(2);
  OctileDistance distance;
  for (int k = 0; k < 40; ++k) {
    const std::array<Units, kSteps> lengths = LengthUnits(1e4).of_steps(kEdges[k % 4]);
    const Cell target = random_offset(random, 50);
    std::array<Units, 27> last;
    last.fill(OctileDistance::kNoStep);
    const std::size_t only = random() % kSteps;
    for (std::size_t i = 0; i < kSteps; ++i) {
      const Units any = 1 + random() % (2 * lengths[kSteps - 1]);
      if (k % 2 == 0 || i == only) last[bit_of(by(steps()[i]))] = any;
    }
    distance.aim(target, lengths, last);
    for (int n = 0; n < 100; ++n) {
      const Cell offset = random_offset(random, n % 2 == 0 ? 4 : 40);
      if (offset == Cell::Zero()) continue;
      Units expected = OctileDistance::kNoStep;
      for (const Step& step : steps()) {
        expected = std::min(expected, octile(lengths, offset - by(step)) + last[bit_of(by(step))]);
      }
      ASSERT_EQ(distance(target + offset), expected) << offset.transpose();
    }
  }
}

TEST(OctileDistance, IsOctileToACentreAndConsistentFarOff) {
  std::mt19937_64 random(3);
  OctileDistance distance;
  for (const Point& edges : kEdges) {
    const LengthUnits units(1e6);
    const std::array<Units, kSteps> lengths = units.of_steps(edges);
    const Cell target = random_offset(random, 1000);
    std::array<Units, 27> last{};
    for (std::size_t i = 0; i < kSteps; ++i) last[bit_of(by(steps()[i]))] = lengths[i];
    distance.aim(target, lengths, last);
    for (int n = 0; n < 300; ++n) {
      const Cell cell = target + random_offset(random, n % 3 == 0 ? 3 : 500);
      if (cell == target) continue;
      const Units here = distance(cell);
      ASSERT_EQ(here, octile(lengths, cell - target));
      ASSERT_NEAR(octile_distance(edges, cell - target), units.metres(here), 1e-6);
      ASSERT_EQ(here, distance(target + target - cell));
      for (int i = 0; i < kSteps; ++i) {
        const Cell next = cell + by(steps()[i]);
        ASSERT_LE(here, lengths[i] + (next == target ? 0 : distance(next)));
      }
    }
  }
}

}  // namespace
}  // namespace ltp::planning
