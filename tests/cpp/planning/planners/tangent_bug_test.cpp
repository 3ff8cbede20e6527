// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Tangent Bug: it arrives where a flood does, and flies what the algorithm's rules say.
#include "ltp/planning/planners/tangent_bug.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "ltp/planning/planners.hpp"
#include "scenes.hpp"

namespace ltp {
namespace {

using test::Drawing;
using test::Situation;

Plan fly(const Situation& situation, double range = 50.0) {
  PlannerOptions options;
  options.tangent_bug.range = range;
  return make_planner("tangent-bug", options)->plan(situation.scene(), situation.query);
}

double direct(const Situation& situation) {
  return (situation.query.goal - situation.query.start).norm();
}

/// Cells of one level, blocked at random; the ends lie anywhere in free ones.
Situation random_maze(std::mt19937_64& random, int size, double density) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const GridFrame frame(Point(3, -5, 0), Point(2, 2, 4), {size, size, 1});
  Situation made{"", OccupancyGrid(frame), test::random_priority(frame, 1), {}};
  const auto place = [&] {
    return Point(3 + 2 * size * unit(random), -5 + 2 * size * unit(random), 4 * unit(random));
  };
  made.query.start = place();
  made.query.goal = place();
  for (std::int64_t i = 0; i < frame.size(); ++i) {
    if (unit(random) < density) made.grid.set(frame.cell_at(i));
  }
  made.grid.set(frame.cell_of(made.query.start), false);
  made.grid.set(frame.cell_of(made.query.goal), false);
  return made;
}

TEST(Bug, OnOneLevelArrivesWhereverAFloodDoes) {
  std::mt19937_64 random(1);
  for (const double range : {0.0, 7.0, 50.0}) {
    int reachable = 0;
    int sealed = 0;
    for (int i = 0; i < 400; ++i) {
      const Situation maze = random_maze(random, 12 + i % 12, 0.1 + 0.1 * (i % 5));
      const Plan plan = fly(maze, range);
      const bool expected = test::slow_status(maze) == PlanStatus::Found;
      EXPECT_EQ(plan.status == PlanStatus::Found, expected) << i << " at " << range;
      (expected ? reachable : sealed) += 1;
      if (plan.status != PlanStatus::Found) {
        EXPECT_EQ(to_string(plan.status), "none_found");
        continue;
      }
      EXPECT_FALSE(test::meets_blocked(maze.grid, plan.path, -1e-9)) << i;
      EXPECT_EQ(plan.path.row(plan.path.rows() - 1).transpose(), maze.query.goal);
    }
    EXPECT_GT(reachable, 200);
    EXPECT_GT(sealed, 20);
  }
}

TEST(Bug, FliesStraightWhereNothingIsInTheWay) {
  Situation open = Drawing{{2, 2, 4}, 6, 1}("open", {"S.......", "........", "......G."});
  open.query.goal.z() += 17.0;
  const Plan plan = fly(open);
  ASSERT_EQ(plan.status, PlanStatus::Found);
  EXPECT_EQ(plan.path.rows(), 2);
  EXPECT_DOUBLE_EQ(plan.tally.length, direct(open));
}

TEST(Bug, PassesAConvexObstacleByTheShorterSide) {
  const Situation block = Drawing{}("block", {
                                                 "....................",
                                                 "........###.........",
                                                 "........###.........",
                                                 "........###.........",
                                                 "S.......###........G",
                                                 "........###.........",
                                                 "....................",
                                                 "....................",
                                             });
  const Plan plan = fly(block);
  ASSERT_EQ(plan.status, PlanStatus::Found);
  EXPECT_LT(plan.path.col(1).minCoeff(), block.query.start.y() - 2.0) << "south is shorter";
  EXPECT_LE(plan.path.col(1).maxCoeff(), block.query.start.y());
  EXPECT_LT(plan.tally.length, 1.05 * direct(block));
  EXPECT_LE(plan.path.rows(), 5) << "from corner to corner";
  // By touch alone the way is longer.
  const Plan blind = fly(block, 0.0);
  ASSERT_EQ(blind.status, PlanStatus::Found);
  EXPECT_GT(blind.tally.length, plan.tally.length);
}

TEST(Bug, GetsOutOfATrap) {
  const Situation trap = Drawing{}("trap", {
                                               "......................",
                                               "...############.......",
                                               "..............#.......",
                                               "..............#.......",
                                               ".....S........#.....G.",
                                               "..............#.......",
                                               "..............#.......",
                                               "...############.......",
                                               "......................",
                                           });
  for (const double range : {0.0, 5.0, 12.0, 50.0}) {
    const Plan plan = fly(trap, range);
    ASSERT_EQ(plan.status, PlanStatus::Found) << range;
    EXPECT_LT(plan.path.col(0).minCoeff(), trap.query.start.x()) << "it turns back first";
    EXPECT_FALSE(test::meets_blocked(trap.grid, plan.path, 0.0));
    EXPECT_LT(plan.tally.length, 5.0 * direct(trap)) << range;
  }
}

TEST(Bug, SeesNoFartherThanItsRange) {
  // A wall far ahead: until it is seen, the way is straight at the goal.
  std::vector<std::string> lines(11, std::string(60, '.'));
  lines[5].front() = 'S';
  lines[5].back() = 'G';
  for (int i = 2; i < 9; ++i) lines[i][45] = '#';
  const Situation far = Drawing{}("far", lines);
  for (const double range : {10.0, 30.0, 60.0, 200.0}) {
    const Plan plan = fly(far, range);
    ASSERT_EQ(plan.status, PlanStatus::Found);
    double straight = 0.0;  // how far it flies before it turns
    for (Eigen::Index i = 0; i < plan.path.rows(); ++i) {
      if (std::abs(plan.path(i, 1) - far.query.start.y()) > 1e-9) break;
      straight = plan.path(i, 0) - far.query.start.x();
    }
    EXPECT_GE(straight, 89.0 - range - 1e-9) << range;
    EXPECT_EQ(straight == 0.0, range == 200.0);
  }
}

TEST(Bug, FindsItsWayBetweenNestedWalls) {
  // Out of the inner walls into a corridor one cell wide, and on away from the goal.
  const Situation corridor = Drawing{}("corridor", {
                                                       "....................",
                                                       ".##################.",
                                                       ".#................#.",
                                                       ".#.##############.#.",
                                                       ".#.#............#.#.",
                                                       ".#.#.....S......#.#.",
                                                       ".#.#............#.#.",
                                                       ".#.######.#######.#.",
                                                       ".#................#.",
                                                       ".###.##############.",
                                                       "....................",
                                                       "..................G.",
                                                   });
  for (const double range : {0.0, 6.0, 50.0}) {
    EXPECT_EQ(to_string(fly(corridor, range).status), "found") << range;
  }
}

TEST(Bug, ClimbsAtTheGoalOrElseAtTheStart) {
  const GridFrame frame(Point(0, 0, 0), Point(2, 2, 4), {20, 9, 4});
  const auto wall = [&](Situation& made, int ix, int low, int high) {
    for (int iy = 1; iy < 8; ++iy) {
      for (int iz = low; iz <= high; ++iz) made.grid.set(Cell(ix, iy, iz));
    }
  };
  Situation step{"", OccupancyGrid(frame), test::random_priority(frame, 1), {}};
  step.query.start = frame.centre(Cell(2, 4, 0));
  step.query.goal = frame.centre(Cell(17, 4, 3));
  wall(step, 10, 0, 3);
  const Plan low = fly(step);
  ASSERT_EQ(low.status, PlanStatus::Found);
  EXPECT_EQ(low.path(low.path.rows() - 2, 2), step.query.start.z());
  EXPECT_EQ(low.path(low.path.rows() - 2, 0), step.query.goal.x());

  step.grid.set(Cell(17, 4, 1));  // no climb at the goal
  const Plan high = fly(step);
  ASSERT_EQ(high.status, PlanStatus::Found);
  EXPECT_EQ(high.path(1, 2), step.query.goal.z());
  EXPECT_EQ(high.path(1, 0), step.query.start.x());

  step.grid.set(Cell(2, 4, 2));  // nor at the start
  EXPECT_EQ(to_string(fly(step).status), "none_found");
}

TEST(Bug, IgnoresPriority) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 20; ++i) {
    Situation maze = random_maze(random, 20, 0.25);
    const Plan plan = fly(maze);
    maze.priority = test::random_priority(maze.grid.frame(), 99);
    const Plan other = fly(maze);
    ASSERT_EQ(plan.path.rows(), other.path.rows());
    EXPECT_EQ(plan.path, other.path);
  }
}

}  // namespace
}  // namespace ltp
