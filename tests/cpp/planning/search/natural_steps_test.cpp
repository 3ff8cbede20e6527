// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Natural steps against their definition, cell by cell, and against Dijkstra that takes every step.
#include "planning/search/natural_steps.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <queue>
#include <random>
#include <tuple>
#include <vector>

#include "planning/search/length_units.hpp"
#include "slow_distances.hpp"

namespace ltp::planning {
namespace {

constexpr std::uint64_t kFar = std::numeric_limits<std::uint64_t>::max();
const std::uint32_t kAllSteps = (1u << kSteps) - 1;

Cell by(const Step& step) { return step.offset(); }

/// The 27 cells round a middle, as a mask of those that are blocked.
bool is_blocked(std::uint32_t mask, const Cell& cell) {
  return (mask >> neighbour_bit(cell.x(), cell.y(), cell.z()) & 1u) != 0;
}

bool is_inside(const Cell& cell) { return cell.cwiseAbs().maxCoeff() <= 1; }

/// Whether one may go from a cell to a neighbour: no other cell of the box round both is blocked.
bool is_legal(std::uint32_t mask, const Cell& from, const Cell& to) {
  if (!is_inside(to)) return false;
  const Cell low = from.cwiseMin(to);
  const Cell high = from.cwiseMax(to);
  for (int x = low.x(); x <= high.x(); ++x) {
    for (int y = low.y(); y <= high.y(); ++y) {
      for (int z = low.z(); z <= high.z(); ++z) {
        if (Cell(x, y, z) != from && is_blocked(mask, Cell(x, y, z))) return false;
      }
    }
  }
  return true;
}

/// The definition: the legal steps on from the middle, without those to which another way of at
/// most two steps is shorter, or as long and ends with a lower step.
std::uint32_t slow_steps(const std::array<std::uint64_t, kSteps>& lengths, int arrived,
                         std::uint32_t mask) {
  const Cell from = -by(steps()[arrived]);
  std::uint32_t natural = 0;
  for (int j = 0; j < kSteps; ++j) {
    const Cell to = by(steps()[j]);
    if (!is_legal(mask, Cell::Zero(), to)) continue;
    const auto here = std::make_tuple(lengths[arrived] + lengths[j], j);
    bool is_natural = to != from;
    for (int k = 0; k < kSteps; ++k) {
      const Cell middle = from + by(steps()[k]);
      if (!is_legal(mask, from, middle)) continue;
      if (middle == to && std::make_tuple(lengths[k], k) < here) is_natural = false;
      for (int last = 0; last < kSteps; ++last) {
        if (middle + by(steps()[last]) != to || !is_legal(mask, middle, to)) continue;
        if (std::make_tuple(lengths[k] + lengths[last], last) < here) is_natural = false;
      }
    }
    if (is_natural) natural |= 1u << j;
  }
  return natural;
}

TEST(NaturalSteps, AreFewInTheOpen) {
  for (const Point& edges : {Point(2, 2, 4), Point(1, 1, 1), Point(1, 2, 3)}) {
    NaturalSteps natural(LengthUnits(1e4).of_steps(edges));
    for (int i = 0; i < kSteps; ++i) {
      const Step& step = steps()[i];
      const int axes = std::abs(step.dx) + std::abs(step.dy) + std::abs(step.dz);
      // On along the same way, or along a part of it.
      EXPECT_EQ(__builtin_popcount(natural.after(i, 0)), (1 << axes) - 1);
      EXPECT_EQ(natural.in_the_open(i), natural.after(i, 0));
      EXPECT_NE(natural.after(i, 0) >> i & 1u, 0u);
    }
    EXPECT_EQ(natural.after(NaturalSteps::kRoot, 0), kAllSteps);
  }
}

TEST(NaturalSteps, AreThoseToWhichNoOtherWayIsAsGood) {
  std::mt19937_64 random(1);
  int dropped = 0;
  int kept = 0;
  for (const Point& edges : {Point(2, 2, 4), Point(1, 1, 1), Point(1, 2, 3), test::kNeedle}) {
    const std::array<std::uint64_t, kSteps> lengths = LengthUnits(1e4).of_steps(edges);
    NaturalSteps natural(lengths);
    std::vector<std::uint32_t> masks;
    for (int k = 0; k < 60; ++k) {
      std::uint32_t mask = 0;
      for (int bit = 0; bit < 27; ++bit) mask |= (random() % 20 < k % 8u ? 1u : 0u) << bit;
      masks.push_back(mask);
    }
    for (int round = 0; round < 2; ++round) {  // what is remembered is the same
      for (const std::uint32_t mask : masks) {
        const std::uint32_t around = mask & ~(1u << neighbour_bit(0, 0, 0));
        std::uint32_t legal = 0;
        for (int i = 0; i < kSteps; ++i) {
          if (is_legal(around, Cell::Zero(), by(steps()[i]))) legal |= 1u << i;
        }
        ASSERT_EQ(natural.after(NaturalSteps::kRoot, mask), legal);
        for (int i = 0; i < kSteps; ++i) {
          const std::uint32_t expected = slow_steps(lengths, i, around);
          ASSERT_EQ(natural.after(i, mask), expected);
          kept += __builtin_popcount(expected);
          dropped += __builtin_popcount(legal & ~expected);
        }
      }
    }
  }
  EXPECT_GT(kept, 10000);
  EXPECT_GT(dropped, 10000);
}

/// Dijkstra that takes natural steps only; of equal ways to a cell it keeps the one with the lower
/// last step.
std::vector<std::uint64_t> distances_over(NaturalSteps& natural, const OccupancyGrid& grid,
                                          const Cell& source, std::int64_t& taken) {
  const GridFrame& frame = grid.frame();
  using Label = std::tuple<std::uint64_t, int>;
  using Entry = std::tuple<std::uint64_t, int, std::int64_t>;
  std::vector<Label> labels(static_cast<std::size_t>(frame.size()), Label(kFar, 0));
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto offer = [&](const Label& label, const Cell& cell) {
    Label& mine = labels[static_cast<std::size_t>(frame.index(cell))];
    if (mine <= label) return;
    mine = label;
    open.push({std::get<0>(label), std::get<1>(label), frame.index(cell)});
  };
  offer({0, NaturalSteps::kRoot}, source);
  while (!open.empty()) {
    const auto [distance, arrived, index] = open.top();
    open.pop();
    if (Label(distance, arrived) != labels[static_cast<std::size_t>(index)]) continue;
    const Cell cell = frame.cell_at(index);
    const std::uint32_t on =
        natural.after(arrived, blocked_surroundings(grid, cell, {0, frame.nz() - 1}));
    for (int i = 0; i < kSteps; ++i) {
      if ((on >> i & 1u) == 0) continue;
      offer({distance + natural.lengths()[i], i}, cell + by(steps()[i]));
      ++taken;
    }
  }
  std::vector<std::uint64_t> distances;
  for (const Label& label : labels) distances.push_back(std::get<0>(label));
  return distances;
}

TEST(NaturalSteps, LoseNoShortestDistance) {
  std::mt19937_64 random(2);
  const LengthUnits units(1e4);
  int reached = 0;
  std::int64_t taken = 0;
  for (int k = 0; k < 150; ++k) {
    const OccupancyGrid grid = test::random_grid(random);
    const GridFrame& frame = grid.frame();
    const Cell source = test::random_cell(random, frame);  // it may be blocked
    NaturalSteps natural(units.of_steps(frame.cell()));
    const std::vector<std::uint64_t> distances = distances_over(natural, grid, source, taken);
    const std::vector<double> expected = test::slow_distances(grid, source, {0, frame.nz() - 1});
    for (std::size_t i = 0; i < expected.size(); ++i) {
      ASSERT_EQ(distances[i] == kFar, std::isinf(expected[i])) << "grid " << k;
      if (distances[i] == kFar) continue;
      ASSERT_NEAR(units.metres(distances[i]), expected[i], 1e-9) << "grid " << k;
      ++reached;
    }
  }
  EXPECT_GT(reached, 20000);
  EXPECT_LT(taken, 6 * reached);  // all legal ones are some 20 a cell
}

}  // namespace
}  // namespace ltp::planning
