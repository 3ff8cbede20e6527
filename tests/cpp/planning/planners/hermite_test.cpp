// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The Hermite planner against its curve's definition, a search of its lattice and the straight
// line.
#include "ltp/planning/planners/hermite.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "ltp/planning/planners.hpp"
#include "scenes.hpp"

namespace ltp {
namespace {

using test::kInfinity;
using test::Situation;

Situation field(std::uint64_t seed = 5) {
  const GridFrame frame(Point(-20, -20, 10), Point(2, 2, 4), {30, 24, 5});
  Situation made{"", OccupancyGrid(frame), test::random_priority(frame, seed), {}};
  made.query.start = Point(-17.3, 3.1, 21.7);
  made.query.goal = Point(34.9, 7.7, 18.2);
  return made;
}

/// A field with random ends and pillars.
Situation woods(std::mt19937_64& random, int pillars) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Situation made = field(random());
  const GridFrame& frame = made.grid.frame();
  const auto place = [&] {
    return Point(-18 + 55 * unit(random), -18 + 43 * unit(random), 11 + 18 * unit(random));
  };
  made.query.start = place();
  made.query.goal = place();
  for (int i = 0; i < pillars; ++i) {
    const Cell foot(static_cast<int>(random() % 30), static_cast<int>(random() % 24), 0);
    for (int iz = 0; iz < 4; ++iz) made.grid.set(foot + Cell(0, 0, iz));
  }
  for (const Point& end : {made.query.start, made.query.goal}) {
    made.grid.set(frame.cell_of(end), false);
  }
  return made;
}

/// The cubic with these ends and end tangents, by its definition.
Point hermite(const Point& p0, const Point& m0, const Point& p1, const Point& m1, double s) {
  return (2 * s * s * s - 3 * s * s + 1) * p0 + (s * s * s - 2 * s * s + s) * m0 +
         (-2 * s * s * s + 3 * s * s) * p1 + (s * s * s - s * s) * m1;
}

/// The best free curve of the lattice.
Path slow_lattice(const Situation& situation, const PlannerOptions& options) {
  const HermiteOptions& hermite_options = options.hermite;
  const Query& query = situation.query;
  const GridFrame& frame = situation.grid.frame();
  const LevelRange levels = test::slow_levels(frame, query);
  const Point direct = query.goal - query.start;
  const Point left = Point(-direct.y(), direct.x(), 0.0) / direct.head<2>().norm() * direct.norm();
  const Penalty penalty(options.weights, direct.norm());
  const int half = hermite_options.starts / 2;
  double least = kInfinity;
  Path best(0, 3);
  for (int i = -half; i <= half; ++i) {
    for (int j = -half; j <= half; ++j) {
      const double unit = half > 0 ? hermite_options.reach / half : 0.0;
      Path path(hermite_options.segments + 1, 3);
      bool inside = true;
      for (int k = 0; k <= hermite_options.segments; ++k) {
        const Point point =
            hermite(query.start, direct + i * unit * left, query.goal, direct + j * unit * left,
                    static_cast<double>(k) / hermite_options.segments);
        path.row(k) = point.transpose();
        const Cell cell = frame.cell_of(point);
        inside &= frame.contains(cell) && cell.z() >= levels.lowest && cell.z() <= levels.highest;
      }
      if (!inside || test::meets_blocked(situation.grid, path, 0.0)) continue;
      const double value = penalty(tally(path, situation.priority));
      if (value < least) best = path;
      least = std::min(least, value);
    }
  }
  return best;
}

TEST(Hermite, BeginsWithTheBestCurveOfItsLattice) {
  std::mt19937_64 random(1);
  int found = 0;
  int none = 0;
  for (int i = 0; i < 60; ++i) {
    const Situation scene = woods(random, 40 * (i % 5));
    PlannerOptions options;
    options.weights = {0.5, i % 2 == 0 ? 1.0 : 5.0};
    options.hermite = {16, 7, 2.0, 3, 0};
    const Plan plan = make_planner("hermite", options)->plan(scene.scene(), scene.query);
    const Path best = slow_lattice(scene, options);
    EXPECT_EQ(plan.stats.expanded, 49);
    ASSERT_EQ(plan.status == PlanStatus::Found, best.rows() > 0) << i;
    none += best.rows() == 0;
    if (best.rows() == 0) continue;
    ++found;
    EXPECT_LT((plan.path - best).cwiseAbs().maxCoeff(), 1e-9) << i;
    // Optimised it is no worse.
    options.hermite.iterations = 20;
    const Plan better = make_planner("hermite", options)->plan(scene.scene(), scene.query);
    ASSERT_EQ(better.status, PlanStatus::Found);
    EXPECT_LE(better.penalty, plan.penalty);
    EXPECT_FALSE(test::meets_blocked(scene.grid, better.path, 0.0));
  }
  EXPECT_GT(found, 30);
  EXPECT_GT(none, 3);
}

TEST(Hermite, IsNeverWorseThanAFreeStraightLineAndMostlyBetter) {
  std::mt19937_64 random(2);
  int judged = 0;
  int better = 0;
  for (int i = 0; i < 60; ++i) {
    const Situation scene = woods(random, i);
    Path line(2, 3);
    line << scene.query.start.transpose(), scene.query.goal.transpose();
    if (scene.grid.first_blocked(line)) continue;
    const PlannerOptions options;
    const Plan plan = make_planner("hermite", options)->plan(scene.scene(), scene.query);
    ASSERT_EQ(plan.status, PlanStatus::Found) << i;
    const double direct = (scene.query.goal - scene.query.start).norm();
    const double straight = Penalty(options.weights, direct)(tally(line, scene.priority));
    EXPECT_LE(plan.penalty, straight + 1e-9) << i;
    ++judged;
    better += plan.penalty < straight - 0.01;
  }
  EXPECT_GT(judged, 25);
  EXPECT_GT(better, judged / 2);
}

TEST(Hermite, OverGroundOfOnePriorityIsTheStraightLine) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 20; ++i) {
    Situation scene = woods(random, 0);
    scene.priority = Raster(Raster::Values::Constant(1, 1, 0.4), {0, 0}, 2.0, 0.4);
    const Plan plan = make_planner("hermite")->plan(scene.scene(), scene.query);
    ASSERT_EQ(plan.status, PlanStatus::Found);
    EXPECT_NEAR(plan.tally.length, (scene.query.goal - scene.query.start).norm(), 1e-9);
  }
}

TEST(Hermite, GoesRoundAHouseAndOverAWall) {
  Situation scene = field();
  const GridFrame& frame = scene.grid.frame();
  const Cell middle = frame.cell_of(0.5 * (scene.query.start + scene.query.goal));
  for (int k = 0; k < 25 * frame.nz(); ++k) {
    scene.grid.set(Cell(middle.x() + k % 5 - 2, middle.y() + k / 5 % 5 - 2, k / 25));
  }
  const auto planner = make_planner("hermite");
  const Plan round = planner->plan(scene.scene(), scene.query);
  ASSERT_EQ(round.status, PlanStatus::Found);
  EXPECT_FALSE(test::meets_blocked(scene.grid, round.path, 0.0));

  // A wall from edge to edge, open above: the search climbs though no curve of the lattice does.
  scene.grid.clear();
  for (int k = 0; k < 4 * frame.ny(); ++k) scene.grid.set(Cell(middle.x(), k / 4, k % 4));
  const Plan over = planner->plan(scene.scene(), scene.query);
  ASSERT_EQ(over.status, PlanStatus::Found);
  EXPECT_GT(over.path.col(2).maxCoeff(), 26.0);
  EXPECT_FALSE(test::meets_blocked(scene.grid, over.path, 0.0));
  scene.query.band = test::kPlanar;
  EXPECT_EQ(planner->plan(scene.scene(), scene.query).status, PlanStatus::NoneFound);
}

TEST(Hermite, FindsWhereTheBezierPlannerDoesAndScoresAsWell) {
  // Its curves are the Bezier planner's and more, its search is a search: it may lose some.
  std::mt19937_64 random(4);
  int bezier_found = 0;
  int both = 0;
  double gain = 0.0;
  PlannerOptions options;
  options.bezier = {21, 30.0, 1, 0.0, 64};
  const auto bezier = make_planner("bezier", options);
  const auto planner = make_planner("hermite", options);
  for (int i = 0; i < 30; ++i) {
    Situation scene = woods(random, 60);
    scene.query.goal.z() = scene.query.start.z();
    scene.grid.set(scene.grid.frame().cell_of(scene.query.goal), false);
    const Plan a = bezier->plan(scene.scene(), scene.query);
    const Plan b = planner->plan(scene.scene(), scene.query);
    if (a.status != PlanStatus::Found) continue;
    ++bezier_found;
    if (b.status != PlanStatus::Found) continue;
    ++both;
    gain += a.penalty - b.penalty;
  }
  EXPECT_GT(bezier_found, 15);
  EXPECT_GE(both, bezier_found - 2);
  EXPECT_GT(gain, 0.0);
}

TEST(Hermite, FliesStraightUp) {
  Situation scene = field();
  scene.query.start = Point(1, 1, 12);
  scene.query.goal = Point(1, 1, 28);
  const Plan plan = make_planner("hermite")->plan(scene.scene(), scene.query);
  ASSERT_EQ(plan.status, PlanStatus::Found);
  EXPECT_TRUE(plan.path.allFinite());
}

}  // namespace
}  // namespace ltp
