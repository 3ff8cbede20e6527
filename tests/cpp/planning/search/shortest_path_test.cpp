// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The search for one shortest path against a textbook's Dijkstra, with ends that are no centres.
#include "planning/search/shortest_path.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "allocations.hpp"
#include "budgets.hpp"
#include "scenes.hpp"
#include "slow_distances.hpp"

namespace ltp::planning {
namespace {

using test::kInfinity;

const Raster kNoPriority(Raster::Values::Zero(1, 1), {0, 0}, 1.0);

/// Somewhere in a free cell; in its centre every other time.
Point random_point(std::mt19937_64& random, const GridFrame& frame, const Cell& cell) {
  std::uniform_real_distribution<double> unit(0.01, 0.99);
  if (random() % 2 == 0) return frame.centre(cell);
  const Point in_cell(unit(random), unit(random), unit(random));
  return frame.origin() + (cell.cast<double>() + in_cell).cwiseProduct(frame.cell());
}

double length_of(const Problem& problem, const std::vector<Cell>& chain) {
  return tally(path_through(problem, chain), kNoPriority).length;
}

TEST(ShortestPath, IsAsLongAsTheTextbooks) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> unit(0.0, 3.0);
  ShortestPath search;
  int found = 0;
  int sealed = 0;
  for (int k = 0; k < 4000; ++k) {
    OccupancyGrid grid = test::random_grid(random);
    const GridFrame& frame = grid.frame();
    const Cell start = test::random_cell(random, frame);
    const Cell goal = test::random_cell(random, frame);
    if (start == goal) continue;
    grid.set(start, false);
    grid.set(goal, false);
    Query query{random_point(random, frame, start), random_point(random, frame, goal), {}};
    if (k % 5 == 0) query.band = {frame.cell().z() * (k % 3), frame.cell().z() * (k % 4)};
    if (k % 5 == 1) query.band = {frame.cell().z() * unit(random), frame.cell().z() * unit(random)};
    const Scene scene{grid, kNoPriority};
    const Problem problem(scene, query, {});
    const double expected =
        test::slow_distances(grid, start, problem.levels, [&](const Cell& cell) -> Point {
          return cell == start  ? query.start
                 : cell == goal ? query.goal
                                : test::slow_vertex(frame, query, cell);
        })[static_cast<std::size_t>(frame.index(goal))];
    SearchStats stats;
    const PlanStatus status = search.run(problem, *test::Limit(), stats);
    ASSERT_EQ(to_string(status), expected < kInfinity ? "found" : "unreachable") << k;
    (status == PlanStatus::Found ? found : sealed) += 1;
    if (status != PlanStatus::Found) continue;
    ASSERT_EQ(search.chain().front(), start);
    ASSERT_EQ(search.chain().back(), goal);
    ASSERT_NEAR(length_of(problem, search.chain()), expected, 1e-9) << k;
    accepted(problem, path_through(problem, search.chain()));
  }
  EXPECT_GT(found, 2000);
  EXPECT_GT(sealed, 200);
}

TEST(ShortestPath, RunsStraightWhereNothingIsInTheWay) {
  const GridFrame frame({0, 0, 0}, {2, 2, 4}, {200, 200, 40});
  const OccupancyGrid grid(frame);
  const Scene scene{grid, kNoPriority};
  ShortestPath search;
  for (const Point& goal : {Point(391, 13, 90), Point(390.2, 12.9, 91.7)}) {
    const Query query{{11, 311, 50}, goal, {}};
    SearchStats stats;
    search.run(Problem(scene, query, {}), *test::Limit(), stats);
    EXPECT_LE(stats.expanded, static_cast<std::int64_t>(search.chain().size()));
  }
}

TEST(ShortestPath, HoldsTheLengthsOfAMaze) {
  const OccupancyGrid grid = test::serpentine(251);
  const Scene scene{grid, kNoPriority};
  const Query query{grid.frame().centre(Cell(0, 0, 0)), grid.frame().centre(Cell(250, 0, 0)), {}};
  ShortestPath search;
  SearchStats stats;
  const Problem problem(scene, query, {});
  ASSERT_EQ(search.run(problem, *test::Limit(), stats), PlanStatus::Found);
  EXPECT_EQ(length_of(problem, search.chain()), 2.0 * (126 * 250 + 125 * 2));
}

TEST(ShortestPath, ProvesFromEitherSideThatNoWayExists) {
  for (const bool goal : {false, true}) {
    const GridFrame frame({0, 0, 0}, {2, 2, 4}, {60, 60, 20});
    OccupancyGrid grid(frame);
    for (int x = 10; x <= 20; ++x) {
      for (int y = 10; y <= 20; ++y) {
        for (int z = 3; z <= 9; ++z) {
          grid.set(Cell(x, y, z), x % 10 == 0 || y % 10 == 0 || z % 6 == 3);
        }
      }
    }
    const Scene scene{grid, kNoPriority};
    Query query{frame.centre(Cell(15, 15, 6)), frame.centre(Cell(50, 50, 6)), {}};
    if (goal) std::swap(query.start, query.goal);
    ShortestPath search;
    SearchStats stats;
    EXPECT_EQ(search.run(Problem(scene, query, {}), *test::Limit(), stats),
              PlanStatus::Unreachable);
    EXPECT_LT(stats.expanded, goal ? 500 : 20000);
  }
}

TEST(ShortestPath, GivesUpWhenItIsTold) {
  const OccupancyGrid grid(GridFrame({0, 0, 0}, {2, 2, 4}, {60, 60, 20}));
  const Scene scene{grid, kNoPriority};
  const Query query{{1, 1, 1}, {99, 80, 40}, {}};
  ShortestPath search;
  SearchStats stats;
  const Problem problem(scene, query, {});
  EXPECT_EQ(search.run(problem, *test::Limit(5), stats), PlanStatus::OutOfBudget);
  EXPECT_EQ(stats.expanded, 5);
}

TEST(ShortestPath, AllocatesNothingTheSecondTime) {
  std::mt19937_64 random(3);
  OccupancyGrid grid(GridFrame({0, 0, 0}, {2, 2, 4}, {40, 40, 10}));
  for (int k = 0; k < 4000; ++k) grid.set(test::random_cell(random, grid.frame()));
  const Query query{{1, 1, 1}, {79, 77, 38}, {}};
  grid.set(grid.frame().cell_of(query.start), false);
  grid.set(grid.frame().cell_of(query.goal), false);
  const Scene scene{grid, kNoPriority};
  const Problem problem(scene, query, {});
  ShortestPath search;
  std::int64_t before = 0;
  for (int round = 0; round < 3; ++round) {
    SearchStats stats;
    before = test::allocations();
    ASSERT_EQ(search.run(problem, *test::Limit(), stats), PlanStatus::Found);
  }
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace ltp::planning
