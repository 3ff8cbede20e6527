// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Refinement: never worse, never longer, never through anything; and as good as one can say by
// hand.
#include "planning/planners/refine.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "allocations.hpp"
#include "ltp/geometry/polyline.hpp"
#include "ltp/planning/planners.hpp"
#include "scenes.hpp"

namespace ltp {
namespace {

using planning::Refiner;
using test::kPlanar;
using test::Situation;

PlannerOptions quick_options(const PenaltyWeights& weights) {
  PlannerOptions options;
  options.weights = weights;
  options.bezier.offsets = 9;
  options.bezier.reach = 12.0;
  options.bezier.segments = 12;
  // Without a length term the longest way round is the best: `pareto` shall give up soon.
  options.exact.memory = weights.length == 0.0 ? 0.1 : 2.0;
  return options;
}

/// Boxes of all heights over a priority of good and bad ground.
Situation town(std::uint64_t seed, bool planar) {
  std::mt19937_64 random(seed);
  const GridFrame frame(Point(-31, 12, 0), Point(2, 2, 4), {36, 34, 6});
  Raster::Values values(36, 34);
  for (Eigen::Index i = 0; i < values.size(); ++i) values.data()[i] = 0.2;
  for (int k = 0; k < 12; ++k) {
    values.block(random() % 28, random() % 26, 3 + random() % 5, 3 + random() % 5) = 1.0;
  }
  Situation made{"town " + std::to_string(seed),
                 OccupancyGrid(frame),
                 Raster(values, frame.origin().head<2>(), 2.0),
                 {}};
  for (int k = 0; k < 14; ++k) {
    const Cell corner(3 + random() % 26, 3 + random() % 24, 0);
    const Cell size(1 + random() % 6, 1 + random() % 6, 1 + random() % 6);
    for (int x = 0; x < size.x(); ++x) {
      for (int y = 0; y < size.y(); ++y) {
        for (int z = 0; z < size.z(); ++z) made.grid.set(corner + Cell(x, y, z));
      }
    }
  }
  std::uniform_real_distribution<double> unit(0.05, 0.95);
  const auto inside = [&](int ix, int iy) -> Point {
    const Point offset(unit(random), unit(random), unit(random));
    return frame.origin() + (Cell(ix, iy, 2).cast<double>() + offset).cwiseProduct(frame.cell());
  };
  made.query.start = inside(random() % 3, random() % 34);
  made.query.goal = inside(33 + random() % 3, random() % 34);
  made.centred = false;
  if (planar) made.query.band = kPlanar;
  return made;
}

/// Plans with and without refinement; checks what refinement promises. Whether a path was found.
/// Each by a planner of its own: some begin where their last plan ended.
bool compare(std::string_view name, PlannerOptions options, const Situation& situation,
             double& gain) {
  SCOPED_TRACE(situation.name + ", " + std::string(name));
  const auto plain = make_planner(name, options);
  options.refine = true;
  const auto refined = make_planner(name, options);
  const Query& query = situation.query;
  const Plan old = plain->plan(situation.scene(), query);
  const Plan plan = refined->plan(situation.scene(), query);
  EXPECT_EQ(to_string(plan.status), to_string(old.status));
  EXPECT_EQ(plan.bound, old.bound);
  EXPECT_EQ(plan.stats.expanded, old.stats.expanded);
  if (old.status != PlanStatus::Found || plan.status != PlanStatus::Found) return false;
  EXPECT_LE(plan.penalty, old.penalty + 1e-12);
  EXPECT_LE(plan.tally.length, old.tally.length * (1.0 + 1e-12));
  const PathTally walked = tally(plan.path, test::seen_priority(plan, situation));
  EXPECT_EQ(plan.tally.length, walked.length);
  EXPECT_EQ(plan.tally.priority, walked.priority);
  EXPECT_LE(plan.path.rows(), old.path.rows());
  EXPECT_GE(plan.path.rows(), 2);
  EXPECT_EQ(plan.path.row(0).transpose(), query.start);
  EXPECT_EQ(plan.path.row(plan.path.rows() - 1).transpose(), query.goal);
  const GridFrame& frame = situation.grid.frame();
  const LevelRange levels = test::slow_levels(frame, query);
  for (Eigen::Index i = 0; i < plan.path.rows(); ++i) {
    const Cell cell = frame.cell_of(plan.path.row(i).transpose());
    EXPECT_TRUE(frame.contains(cell));
    EXPECT_GE(cell.z(), levels.lowest);
    EXPECT_LE(cell.z(), levels.highest);
  }
  // A path through centres keeps its distance; a curve may have touched a face before.
  const bool clear = situation.centred && plain->complete();
  const double margin = (clear ? 0.9 * Refiner::kClearance : -1e-9) * frame.cell().minCoeff();
  EXPECT_FALSE(test::meets_blocked(situation.grid, plan.path, margin)) << plan.path;
  const Plan again = make_planner(name, options)->plan(situation.scene(), query);
  EXPECT_EQ(again.path, plan.path);
  EXPECT_EQ(again.penalty, plan.penalty);
  gain += old.penalty - plan.penalty;
  return true;
}

std::vector<std::string_view> names() {
  std::vector<std::string_view> all;
  for (const PlannerInfo& info : planners()) all.push_back(info.name);
  return all;
}

class Refinement : public ::testing::TestWithParam<std::string_view> {};

TEST_P(Refinement, IsNeverWorseAndNeverTouchesAnything) {
  static const std::vector<Situation> situations = test::situations();
  int found = 0;
  double gain = 0.0;
  for (const PenaltyWeights& weights : {PenaltyWeights{0.5, 1.0}, {1.0, 0.0}, {0.0, 2.0}}) {
    PlannerOptions options = quick_options(weights);
    const auto plain = make_planner(GetParam(), options);
    options.refine = true;
    const auto refined = make_planner(GetParam(), options);
    EXPECT_EQ(refined->name(), plain->name());
    EXPECT_EQ(refined->complete(), plain->complete());
    for (const Situation& situation : situations) {
      found += compare(GetParam(), quick_options(weights), situation, gain);
    }
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      found += compare(GetParam(), quick_options(weights), town(seed, seed % 2 == 0), gain);
    }
  }
  EXPECT_GT(found, 200);
  EXPECT_GT(gain, 1.0);
}

INSTANTIATE_TEST_SUITE_P(All, Refinement, ::testing::ValuesIn(names()),
                         [](const ::testing::TestParamInfo<std::string_view>& planner) {
                           std::string name(planner.param);
                           for (char& letter : name) letter = letter == '-' ? '_' : letter;
                           return name;
                         });

/// Refines what a planner finds for a situation.
Plan refined_plan(const Situation& situation, const PenaltyWeights& weights) {
  PlannerOptions options;
  options.weights = weights;
  options.refine = true;
  return make_planner("additive", options)->plan(situation.scene(), situation.query);
}

TEST(Refinement, IsAStraightLineWhereNothingIsInTheWay) {
  const GridFrame frame(Point(0, 0, 0), Point(2, 2, 4), {60, 60, 12});
  Situation open{"", OccupancyGrid(frame), test::random_priority(frame, 1), {}};
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto anywhere = [&] {
    return Point(120 * unit(random), 120 * unit(random), 48 * unit(random));
  };
  for (int i = 0; i < 50; ++i) {
    open.query.start = anywhere();
    open.query.goal = anywhere();
    const Plan plan = refined_plan(open, {1.0, 0.0});
    ASSERT_EQ(to_string(plan.status), "found");
    EXPECT_NEAR(plan.penalty, 1.0, 1e-9);
    EXPECT_EQ(plan.path.rows(), 2);
  }
}

TEST(Refinement, PullsAPathTautRoundABlock) {
  const GridFrame frame(Point(0, 0, 0), Point(2, 2, 4), {40, 40, 1});
  Situation block{"", OccupancyGrid(frame), test::random_priority(frame, 1), {}};
  for (int x = 15; x < 25; ++x) {
    for (int y = 0; y < 30; ++y) block.grid.set(Cell(x, y, 0));
  }
  block.query.start = frame.centre(Cell(5, 10, 0));
  block.query.goal = frame.centre(Cell(36, 16, 0));
  // Over the block's two upper corners: no shorter way exists.
  const Point left(30, 60, 2);
  const Point right(50, 60, 2);
  const double shortest =
      (left - block.query.start).norm() + (right - left).norm() + (block.query.goal - right).norm();
  PlannerOptions options;
  options.weights = {1.0, 0.0};
  const Plan grid = make_planner("additive", options)->plan(block.scene(), block.query);
  const Plan plan = refined_plan(block, {1.0, 0.0});
  EXPECT_GT(grid.tally.length, 1.05 * shortest);
  EXPECT_GT(plan.tally.length, shortest);
  EXPECT_LT(plan.tally.length, 1.01 * shortest);
}

TEST(Refinement, TakesTheWayOverALowWall) {
  const GridFrame frame(Point(0, 0, 0), Point(2, 2, 4), {40, 21, 8});
  Situation wall{"", OccupancyGrid(frame), test::random_priority(frame, 1), {}};
  for (int y = 0; y < 21; ++y) {
    for (int z = 0; z < 5; ++z) wall.grid.set(Cell(20, y, z));
  }
  wall.query.start = frame.centre(Cell(4, 10, 1));
  wall.query.goal = frame.centre(Cell(35, 10, 2));
  const Point near_edge(40, 21, 20);
  const Point far_edge(42, 21, 20);
  const double shortest =
      (near_edge - wall.query.start).norm() + 2.0 + (wall.query.goal - far_edge).norm();
  const Plan plan = refined_plan(wall, {1.0, 0.0});
  EXPECT_GT(plan.tally.length, shortest);
  EXPECT_LT(plan.tally.length, 1.03 * shortest);
}

TEST(Refinement, StaysOnGoodGroundWhereThatPays) {
  // A road of priority 1 with one bend, over ground of priority 0: cutting the bend is shorter,
  // staying better.
  const GridFrame frame(Point(0, 0, 0), Point(2, 2, 4), {40, 40, 1});
  Raster::Values values = Raster::Values::Zero(40, 40);
  values.block(2, 2, 36, 5) = 1.0;
  values.block(33, 2, 5, 36) = 1.0;
  Situation road{"", OccupancyGrid(frame), Raster(values, {0, 0}, 2.0), {}};
  road.query.start = frame.centre(Cell(3, 4, 0));
  road.query.goal = frame.centre(Cell(35, 36, 0));
  const Plan plan = refined_plan(road, {0.5, 4.0});
  EXPECT_DOUBLE_EQ(plan.tally.mean_priority(), 1.0);
  EXPECT_LT(plan.tally.length, 120.0);
  const Plan hasty = refined_plan(road, {1.0, 0.0});
  EXPECT_NEAR(hasty.penalty, 1.0, 1e-9);
}

TEST(Refinement, LeavesNextToNothingForASecondTime) {
  double first = 0.0;
  double second = 0.0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Situation situation = town(seed, seed % 2 == 0);
    PlannerOptions options;
    const Plan grid = make_planner("additive", options)->plan(situation.scene(), situation.query);
    if (grid.status != PlanStatus::Found) continue;
    const Problem problem(situation.scene(), situation.query, {});
    const Penalty judge(options.weights, problem.direct_length);
    const auto value = [&](const Path& path) { return judge(tally(path, situation.priority)); };
    Refiner refiner(options.weights);
    const Path once = refiner.refine(problem, grid.path);
    const Path twice = refiner.refine(problem, once);
    EXPECT_LE(value(twice), value(once));
    first += grid.penalty - value(once);
    second += value(once) - value(twice);
  }
  EXPECT_GT(first, 0.5);
  EXPECT_LT(second, 0.05 * first);
}

TEST(Refinement, AllocatesOnlyWhatItReturns) {
  const Situation situation = town(3, false);
  const Plan grid = make_planner("additive")->plan(situation.scene(), situation.query);
  ASSERT_EQ(to_string(grid.status), "found");
  const Problem problem(situation.scene(), situation.query, {});
  Refiner refiner(PenaltyWeights{});
  refiner.refine(problem, grid.path);
  const std::int64_t before = test::allocations();
  const Path path = refiner.refine(problem, grid.path);
  EXPECT_EQ(test::allocations() - before, 1);
  EXPECT_LT(length(path), grid.tally.length);
}

}  // namespace
}  // namespace ltp
