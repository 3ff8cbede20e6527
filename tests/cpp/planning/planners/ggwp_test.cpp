// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// GGWP: its wave against a slow one, its paths within their bound.
#include "ltp/planning/planners/ggwp.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

#include "all_vectors.hpp"
#include "budgets.hpp"
#include "ltp/planning/planners.hpp"
#include "planning/search/bit_wave.hpp"
#include "planning/search/wave_kernels.hpp"
#include "scenes.hpp"

namespace ltp {
namespace {

using namespace planning;  // NOLINT: the wave behind the planner

using test::Situation;

/// Of every cell, told cell by cell: the generation that first reaches it; -1: none does.
std::vector<int> slow_generations(const OccupancyGrid& grid, const LevelRange& levels,
                                  const Cell& from) {
  const GridFrame& frame = grid.frame();
  const Point edge = frame.cell();
  const bool flat = levels.lowest == levels.highest;
  const double pace = flat ? std::min(edge.x(), edge.y()) : edge.minCoeff();
  std::vector<int> found(frame.size(), -1);
  found[frame.index(from)] = 0;
  const int longest = static_cast<int>(std::ceil(edge.maxCoeff() / pace));
  int idle = 0;
  for (int generation = 1; idle <= longest; ++generation) {
    const auto due = [&](double rate) {
      return std::floor(rate * generation) > std::floor(rate * (generation - 1));
    };
    std::vector<std::int64_t> added;
    for (std::int64_t i = 0; i < frame.size(); ++i) {
      const Cell cell = frame.cell_at(i);
      if (found[i] >= 0 || cell.z() < levels.lowest || cell.z() > levels.highest ||
          grid.blocked(cell)) {
        continue;
      }
      const std::uint32_t blocked = blocked_surroundings(grid, cell, levels);
      for (const Step& step : steps()) {
        const int axes = std::abs(step.dx) + std::abs(step.dy) + std::abs(step.dz);
        bool taken = (blocked & step.box) == 0 && (axes == 1 || (axes == 2 && step.dz == 0));
        if (step.dx != 0) taken &= due(pace / edge.x());
        if (step.dy != 0) taken &= due(pace / edge.y());
        if (step.dz != 0) taken &= due(pace / edge.z());
        if (axes == 2) taken &= due(std::sqrt(2.0) - 1.0);
        if (!taken) continue;
        if (found[frame.index(cell + step.offset())] < 0) continue;
        added.push_back(i);
        break;
      }
    }
    for (const std::int64_t i : added) found[i] = generation;
    idle = added.empty() ? idle + 1 : 0;
  }
  return found;
}

TEST(Ggwp, ReachesEveryCellInTheGenerationOfTheSlowWave) {
  std::mt19937_64 random(7);
  BitWave wave;
  test::Limit unlimited;
  int compared = 0;
  int steps_told = 0;
  const Point edges[] = {{2, 2, 4}, {1, 1, 1}, {1, 2, 3}, {4, 3, 1}};
  for (int k = 0; k < 60; ++k) {
    // Rows of more than a word, levels of more than a word, a single level.
    const std::array<int, 3> dims[] = {{6, 70, 5}, {5, 9, 70}, {20, 20, 1}, {9, 64, 3}};
    const GridFrame frame(Point(0, 0, 0), edges[k % 4], dims[k / 4 % 4]);
    OccupancyGrid grid(frame);
    for (std::int64_t i = 0; i < frame.size(); ++i) {
      if (random() % 10 < static_cast<unsigned>(k % 5)) grid.set(frame.cell_at(i));
    }
    const LevelRange levels{frame.nz() > 2 ? 1 : 0, frame.nz() - 1};
    const Cell from(2, 5, levels.lowest);
    grid.set(from, false);
    const std::vector<int> slow = slow_generations(grid, levels, from);
    for (int goal = 0; goal < 20; ++goal) {
      const Cell to(static_cast<int>(random() % frame.nx()),
                    static_cast<int>(random() % frame.ny()),
                    levels.lowest + static_cast<int>(random() % (frame.nz() - levels.lowest)));
      if (grid.blocked(to)) continue;
      SearchStats stats;
      const PlanStatus status = wave.run(grid, levels, from, to, *unlimited, stats);
      const int expected = slow[frame.index(to)];
      ASSERT_EQ(status, expected >= 0 ? PlanStatus::Found : PlanStatus::Unreachable);
      std::int64_t reached = 0;
      for (const int generation : slow) {
        reached += generation >= 0 && (expected < 0 || generation <= expected);
      }
      EXPECT_EQ(stats.expanded, reached);
      ++compared;
      if (expected < 0) continue;
      ASSERT_EQ(wave.generation(), expected);
      const std::uint32_t blocked = blocked_surroundings(grid, to, levels);
      for (const Step& step : steps()) {
        if (blocked & step.box) continue;
        const Cell other = to + step.offset();
        const int theirs = slow[frame.index(other)];
        const bool known = theirs >= 0 && theirs < expected;
        ASSERT_EQ(wave.earlier(other, expected), known ? expected - theirs : 0);
        ++steps_told;
      }
    }
  }
  EXPECT_GT(compared, 500);
  EXPECT_GT(steps_told, 3000);
}

TEST(Ggwp, IsTheSameForRegistersOfEveryWidth) {
  std::mt19937_64 random(11);
  constexpr int kSize = 200;
  for (int k = 0; k < 500; ++k) {
    std::vector<std::uint64_t> free(kSize), reached(kSize);
    for (int i = 0; i < kSize; ++i) {
      free[i] = random() | random();
      reached[i] = random() & random() & free[i];
    }
    const int count = 1 + k % 45;
    const wave::Words words{free.data() + 70, reached.data() + 70, 60, 10, 1, count};
    const auto mask = [&] { return random() % 2 == 0 ? ~std::uint64_t{0} : 0; };
    const std::uint64_t masks[] = {mask(), mask(), mask()};
    std::vector<std::uint64_t> plain;
    test::with_all_vectors([&] {
      const wave::Kernels& kernels = wave::kernels();
      std::vector<std::uint64_t> result(kSize, 0);
      const std::uint64_t any =
          kernels.spread_straight(words, masks[0], masks[1], masks[2], result.data() + 70);
      kernels.spread_diagonally(words, result.data() + 70);
      std::vector<std::uint64_t> after = reached;
      const std::int64_t bits = kernels.take(result.data() + 70, count, after.data() + 70);
      result.insert(result.end(), after.begin(), after.end());
      result.push_back(any);
      result.push_back(static_cast<std::uint64_t>(bits));
      if (plain.empty()) plain = result;
      ASSERT_EQ(result, plain);
    });
  }
}

TEST(Ggwp, IsAtMostTheLongestOverTheShortestStepTooLong) {
  PlannerOptions shortest;
  shortest.weights = {1.0, 0.0};
  const std::unique_ptr<Planner> dijkstra = make_planner("lp-dijkstra", shortest);
  const auto planner = make_planner("ggwp");
  int compared = 0;
  int longer = 0;
  std::vector<Situation> all = test::situations();
  std::mt19937_64 random(1);
  for (int k = 0; k < 200; ++k) {
    const GridFrame frame(Point(0, 0, 0), Point(2, 2, k % 2 == 0 ? 2 : 4), {12, 12, 6});
    Situation clutter{"more clutter", OccupancyGrid(frame), test::random_priority(frame, 1), {}};
    for (std::int64_t i = 0; i < frame.size(); ++i) {
      if (random() % 10 < 3) clutter.grid.set(frame.cell_at(i));
    }
    clutter.query.start = frame.centre(Cell(1, 2, 3));
    clutter.query.goal = frame.centre(Cell(10, 9, 2));
    clutter.grid.set(Cell(1, 2, 3), false);
    clutter.grid.set(Cell(10, 9, 2), false);
    all.push_back(clutter);
  }
  for (const Situation& situation : all) {
    if (!situation.centred) continue;
    const Plan plan = planner->plan(situation.scene(), situation.query);
    if (plan.status != PlanStatus::Found) continue;
    const Plan best = dijkstra->plan(situation.scene(), situation.query);
    const LevelRange levels = test::slow_levels(situation.grid.frame(), situation.query);
    const Point cell = situation.grid.frame().cell();
    const bool flat = levels.lowest == levels.highest;
    const double longest = flat ? cell.head<2>().norm() : cell.norm();
    const double least = flat ? cell.head<2>().minCoeff() : cell.minCoeff();
    EXPECT_GE(plan.tally.length, best.tally.length * (1 - 1e-12)) << situation.name;
    EXPECT_LE(plan.tally.length, longest / least * best.tally.length * (1 + 1e-12))
        << situation.name;
    longer += plan.tally.length > best.tally.length * (1 + 1e-9);
    ++compared;
  }
  EXPECT_GT(compared, 50);
  EXPECT_GT(longer, 0) << "it is greedy";
}

TEST(Ggwp, IsShortestInTheOpenPlane) {
  const GridFrame frame(Point(0, 0, 0), Point(2, 2, 4), {20, 15, 3});
  Situation field{"", OccupancyGrid(frame), test::random_priority(frame, 1), {}};
  field.query.band = test::kPlanar;
  const auto planner = make_planner("ggwp");
  for (int x = 0; x < 20; x += 3) {
    for (int y = 0; y < 15; y += 2) {
      field.query.start = frame.centre(Cell(x, y, 1));
      field.query.goal = frame.centre(Cell(11, 6, 1));
      const int dx = std::abs(x - 11);
      const int dy = std::abs(y - 6);
      const double expected =
          2.0 * (std::max(dx, dy) - std::min(dx, dy)) + 2.0 * std::sqrt(2.0) * std::min(dx, dy);
      const Plan plan = planner->plan(field.scene(), field.query);
      EXPECT_NEAR(plan.tally.length, expected, 1e-9);
    }
  }
}

TEST(Ggwp, KnowsNothingOfPriority) {
  PlannerOptions heavy;
  heavy.weights = {0.1, 50.0};
  const auto plain = make_planner("ggwp");
  const auto weighted = make_planner("ggwp", heavy);
  for (Situation& situation : test::built_situations()) {
    const Plan plan = plain->plan(situation.scene(), situation.query);
    EXPECT_EQ(plan.path, weighted->plan(situation.scene(), situation.query).path);
    const Raster none(Raster::Values::Zero(1, 1), {0, 0}, 1.0);
    EXPECT_EQ(plan.path, plain->plan({situation.grid, none}, situation.query).path);
  }
}

}  // namespace
}  // namespace ltp
