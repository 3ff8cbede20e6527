// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The Bezier planner against de Casteljau's construction and a search of all its curves.
#include "ltp/planning/planners/bezier.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "ltp/planning/planners.hpp"
#include "scenes.hpp"

namespace ltp {
namespace {

using test::kInfinity;
using test::Situation;

/// A cubic curve's point by repeated interpolation.
Point casteljau(std::vector<Point> points, double s) {
  while (points.size() > 1) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      points[i] = (1.0 - s) * points[i] + s * points[i + 1];
    }
    points.pop_back();
  }
  return points.front();
}

double spread(int i, int count, double reach) {
  return count == 1 ? 0.0 : -reach + 2.0 * reach * i / (count - 1);
}

struct Best {
  double penalty = kInfinity;
  Path path = Path(0, 3);
  int free = 0;
};

/// Every curve of the family, tallied by sampling and tested box by box.
Best slow_search(const Situation& situation, const PlannerOptions& options) {
  const BezierOptions& bezier = options.bezier;
  const Query& query = situation.query;
  const GridFrame& frame = situation.grid.frame();
  const LevelRange levels = test::slow_levels(frame, query);
  const Point direct = query.goal - query.start;
  const Point side = Point(-direct.y(), direct.x(), 0.0) / direct.head<2>().norm();
  Best best;
  for (int k = 0; k < bezier.z_offsets; ++k) {
    for (int i = 0; i < bezier.offsets; ++i) {
      for (int j = 0; j < bezier.offsets; ++j) {
        const Point up(0, 0, spread(k, bezier.z_offsets, bezier.z_reach));
        const std::vector<Point> control = {
            query.start,
            query.start + direct / 3 + spread(i, bezier.offsets, bezier.reach) * side + up,
            query.start + direct * 2 / 3 + spread(j, bezier.offsets, bezier.reach) * side + up,
            query.goal};
        Path path(bezier.segments + 1, 3);
        bool inside = true;
        for (int s = 0; s <= bezier.segments; ++s) {
          const Point point = casteljau(control, static_cast<double>(s) / bezier.segments);
          path.row(s) = point.transpose();
          const Cell cell = frame.cell_of(point);
          inside &= frame.contains(cell) && cell.z() >= levels.lowest && cell.z() <= levels.highest;
        }
        if (!inside || test::meets_blocked(situation.grid, path, 0.0)) continue;
        ++best.free;
        double length = 0.0;
        double priority = 0.0;
        for (int s = 0; s < bezier.segments; ++s) {
          const Point a = path.row(s).transpose();
          const Point b = path.row(s + 1).transpose();
          length += (b - a).norm();
          priority += situation.priority.integral(a, b);
        }
        const double penalty = options.weights.length * length / direct.norm() -
                               options.weights.priority * priority / length;
        if (penalty < best.penalty) {
          best.penalty = penalty;
          best.path = path;
        }
      }
    }
  }
  return best;
}

Situation field(const std::array<int, 3>& dims = {30, 24, 5}) {
  const GridFrame frame(Point(-20, -20, 10), Point(2, 2, 4), dims);
  Situation made{"", OccupancyGrid(frame), test::random_priority(frame, 5), {}};
  made.query.start = Point(-17.3, 3.1, 21.7);
  made.query.goal = Point(34.9, 7.7, 18.2);
  return made;
}

TEST(Bezier, WithOneOffsetIsTheStraightLine) {
  Situation scene = field();
  PlannerOptions options;
  options.bezier.offsets = 1;
  const auto planner = make_planner("bezier", options);
  const Plan plan = planner->plan(scene.scene(), scene.query);
  ASSERT_EQ(plan.status, PlanStatus::Found);
  EXPECT_EQ(plan.stats.expanded, 1);
  EXPECT_EQ(plan.path.rows(), options.bezier.segments + 1);
  const Point direct = scene.query.goal - scene.query.start;
  EXPECT_NEAR(plan.tally.length, direct.norm(), 1e-9);
  for (Eigen::Index i = 0; i < plan.path.rows(); ++i) {
    const Point off = plan.path.row(i).transpose() - scene.query.start;
    EXPECT_LT(off.cross(direct.normalized()).norm(), 1e-9);
    EXPECT_NEAR(off.dot(direct) / direct.squaredNorm(), i / 64.0, 1e-12);
  }
  scene.grid.set(scene.grid.frame().cell_of(scene.query.start + 0.37 * direct));
  EXPECT_EQ(planner->plan(scene.scene(), scene.query).status, PlanStatus::NoneFound);
}

TEST(Bezier, FindsTheBestOfAllItsCurves) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int found = 0;
  int none = 0;
  int high = 0;
  for (int k = 0; k < 40; ++k) {
    Situation scene = field();
    const GridFrame& frame = scene.grid.frame();
    scene.priority = test::random_priority(frame, k);
    const auto place = [&] {
      return Point(-18 + 55 * unit(random), -18 + 43 * unit(random), 11 + 18 * unit(random));
    };
    scene.query.start = place();
    scene.query.goal = place();
    // Pillars, so that most curves are blocked.
    for (int i = 0; i < 45 * (k % 4); ++i) {
      const Cell foot(static_cast<int>(random() % 30), static_cast<int>(random() % 24), 0);
      for (int iz = 0; iz < 5 - k % 3; ++iz) scene.grid.set(foot + Cell(0, 0, iz));
    }
    for (const Point& end : {scene.query.start, scene.query.goal}) {
      scene.grid.set(frame.cell_of(end), false);
    }
    PlannerOptions options;
    options.weights = {0.5, k % 2 == 0 ? 1.0 : 5.0};
    options.bezier = {7, 17.0, k % 3 == 0 ? 1 : 3, 8.0, 16};
    const auto planner = make_planner("bezier", options);
    const Plan plan = planner->plan(scene.scene(), scene.query);
    const Best best = slow_search(scene, options);
    EXPECT_EQ(plan.stats.expanded, 49 * options.bezier.z_offsets);
    if (best.free == 0) {
      EXPECT_EQ(plan.status, PlanStatus::NoneFound);
      ++none;
      continue;
    }
    ASSERT_EQ(plan.status, PlanStatus::Found) << k;
    ++found;
    EXPECT_NEAR(plan.penalty, best.penalty, 1e-9) << k;
    EXPECT_LT((plan.path - best.path).cwiseAbs().maxCoeff(), 1e-9) << k;
    const Point middle = plan.path.row(8).transpose();
    high += std::abs(middle.z() - 0.5 * (scene.query.start + scene.query.goal).z()) > 1.0;
  }
  EXPECT_GT(found, 20);
  EXPECT_GT(none, 2);
  EXPECT_GT(high, 2) << "offsets in height are used";
}

TEST(Bezier, GoesRoundAHouseAndOverAWall) {
  Situation scene = field();
  const GridFrame& frame = scene.grid.frame();
  const Cell middle = frame.cell_of(0.5 * (scene.query.start + scene.query.goal));
  for (int dx = -2; dx <= 2; ++dx) {
    for (int dy = -2; dy <= 2; ++dy) {
      for (int iz = 0; iz < frame.nz(); ++iz) {
        scene.grid.set(Cell(middle.x() + dx, middle.y() + dy, iz));
      }
    }
  }
  PlannerOptions options;
  options.bezier = {15, 20.0, 1, 0.0, 32};
  const auto planner = make_planner("bezier", options);
  const Plan round = planner->plan(scene.scene(), scene.query);
  ASSERT_EQ(round.status, PlanStatus::Found);
  EXPECT_FALSE(test::meets_blocked(scene.grid, round.path, 0.0));
  EXPECT_GT(round.tally.length, (scene.query.goal - scene.query.start).norm() + 0.1);

  // A wall from edge to edge, open above: only the search in height gets over it.
  scene.grid.clear();
  for (int iy = 0; iy < frame.ny(); ++iy) {
    for (int iz = 0; iz < 4; ++iz) scene.grid.set(Cell(middle.x(), iy, iz));
  }
  EXPECT_EQ(planner->plan(scene.scene(), scene.query).status, PlanStatus::NoneFound);
  options.bezier = {3, 5.0, 5, 12.0, 32};
  const auto climber = make_planner("bezier", options);
  const Plan over = climber->plan(scene.scene(), scene.query);
  ASSERT_EQ(over.status, PlanStatus::Found);
  EXPECT_GT(over.path.col(2).maxCoeff(), 26.0);
  // Not out of its band.
  scene.query.band = test::kPlanar;
  EXPECT_EQ(climber->plan(scene.scene(), scene.query).status, PlanStatus::NoneFound);
}

TEST(Bezier, SeesTheThinnestObstacle) {
  // A single cell, however few pieces the curve has and however small the cell is.
  const GridFrame frame(Point(0, 0, 0), Point(0.1, 0.1, 0.1), {400, 20, 1});
  Situation scene{"", OccupancyGrid(frame), test::random_priority(frame, 1), {}};
  scene.query.start = Point(0.55, 1.03, 0.05);
  scene.query.goal = Point(39.55, 0.97, 0.05);
  PlannerOptions options;
  options.bezier = {1, 1.0, 1, 0.0, 2};
  const auto planner = make_planner("bezier", options);
  ASSERT_EQ(planner->plan(scene.scene(), scene.query).status, PlanStatus::Found);
  int refused = 0;
  for (int ix = 6; ix < 395; ++ix) {
    Situation spot = scene;
    const Point on =
        scene.query.start + (0.1 * ix - 0.5) / 39.0 * (scene.query.goal - scene.query.start);
    spot.grid.set(frame.cell_of(on));
    refused += planner->plan(spot.scene(), spot.query).status == PlanStatus::NoneFound;
  }
  EXPECT_EQ(refused, 389);
}

TEST(Bezier, FliesStraightUpAndDown) {
  Situation scene = field();
  scene.query.start = Point(1, 1, 12);
  scene.query.goal = Point(1, 1, 28);
  PlannerOptions options;
  options.bezier.offsets = 3;
  options.bezier.reach = 10.0;
  const auto planner = make_planner("bezier", options);
  const Plan up = planner->plan(scene.scene(), scene.query);
  ASSERT_EQ(up.status, PlanStatus::Found);
  EXPECT_TRUE(up.path.allFinite());
  scene.grid.set(scene.grid.frame().cell_of(Point(1, 1, 20)));
  const Plan round = planner->plan(scene.scene(), scene.query);
  ASSERT_EQ(round.status, PlanStatus::Found);
  EXPECT_GT((round.path.col(0).array() - 1.0).abs().maxCoeff(), 1.0) << "sideways is east";
  EXPECT_LT((round.path.col(1).array() - 1.0).abs().maxCoeff(), 1e-9);
}

TEST(Bezier, DoesNotWalkToTheEndOfItsReach) {
  // Curves out of the window are many and long: they are not followed there.
  Situation scene = field();
  PlannerOptions options;
  options.bezier.offsets = 5;
  options.bezier.reach = 1e13;
  const auto planner = make_planner("bezier", options);
  const Plan plan = planner->plan(scene.scene(), scene.query);
  ASSERT_EQ(plan.status, PlanStatus::Found);
  EXPECT_NEAR(plan.tally.length, (scene.query.goal - scene.query.start).norm(), 1e-9);
}

}  // namespace
}  // namespace ltp
