// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// LP-Dijkstra, LP-A* and WLP-A*: shortest paths where priority does not matter, and what priority
// and heuristic do where they do.
#include "ltp/planning/planners/length_priority.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "ltp/planning/planners.hpp"
#include "scenes.hpp"

namespace ltp {
namespace {

using test::Situation;

/// Lengths of the shortest paths from a cell [m], by relaxing every step until nothing changes.
std::vector<double> shortest_from(const OccupancyGrid& grid, const Cell& from) {
  const GridFrame& frame = grid.frame();
  const LevelRange all{0, frame.nz() - 1};
  std::vector<double> lengths(frame.size(), test::kInfinity);
  lengths[frame.index(from)] = 0.0;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::int64_t i = 0; i < frame.size(); ++i) {
      const Cell cell = frame.cell_at(i);
      if (lengths[i] == test::kInfinity) continue;
      const std::uint32_t blocked = blocked_surroundings(grid, cell, all);
      for (const Step& step : steps()) {
        if (blocked & step.box) continue;
        const Cell offset(step.dx, step.dy, step.dz);
        const double length = lengths[i] + offset.cast<double>().cwiseProduct(frame.cell()).norm();
        double& other = lengths[frame.index(cell + offset)];
        if (length < other - 1e-12) {
          other = length;
          changed = true;
        }
      }
    }
  }
  return lengths;
}

Situation random_situation(std::mt19937_64& random) {
  const Point edges[] = {{2, 2, 4}, {1, 1, 1}, {3, 1, 2}};
  const GridFrame frame(Point(0, 0, 0), edges[random() % 3], {8, 7, 4});
  const Cell from = frame.cell_at(static_cast<std::int64_t>(random() % frame.size()));
  const Cell to = frame.cell_at(static_cast<std::int64_t>(random() % frame.size()));
  Situation made{"", OccupancyGrid(frame), test::random_priority(frame, random()), {}};
  made.query.start = frame.centre(from);
  made.query.goal = frame.centre(to);
  for (std::int64_t i = 0; i < frame.size(); ++i) {
    const Cell cell = frame.cell_at(i);
    if (random() % 4 == 0 && cell != from && cell != to) made.grid.set(cell);
  }
  return made;
}

Plan plan(const Situation& situation, double heuristic_weight, const PenaltyWeights& weights,
          bool scaled = false) {
  return make_length_priority({"test", "Test"}, weights, {heuristic_weight, scaled})
      ->plan(situation.scene(), situation.query);
}

TEST(LengthPriority, IsTheShortestPathWherePriorityHasNoWeight) {
  std::mt19937_64 random(1);
  int found = 0;
  for (int k = 0; k < 150; ++k) {
    const Situation situation = random_situation(random);
    const GridFrame& frame = situation.grid.frame();
    const double shortest = shortest_from(
        situation.grid,
        frame.cell_of(situation.query.goal))[frame.index(frame.cell_of(situation.query.start))];
    const double weights[] = {0.0, 1.0, std::sqrt(3.0)};
    for (const double weight : weights) {
      const Plan answer = plan(situation, weight, {1.0, 0.0});
      ASSERT_EQ(answer.status == PlanStatus::Found, shortest < test::kInfinity);
      if (answer.status != PlanStatus::Found) continue;
      ++found;
      if (weight <= 1.0) {
        ASSERT_NEAR(answer.tally.length, shortest, 1e-9);
      } else {
        ASSERT_LE(answer.tally.length, weight * shortest * (1 + 1e-12));
      }
      // Eq. (9) lacks W_L: with W_L = 1/2 the heuristic counts twice, unless it is scaled.
      const Plan half = plan(situation, weight, {0.5, 0.0});
      ASSERT_LE(half.tally.length, std::max(1.0, 2.0 * weight) * shortest * (1 + 1e-12));
      const Plan scaled = plan(situation, weight, {0.5, 0.0}, true);
      ASSERT_NEAR(scaled.tally.length, answer.tally.length, 1e-9);
    }
  }
  EXPECT_GT(found, 200);
}

TEST(LengthPriority, IsTheShortestPathWherePriorityIsTheSameEverywhere) {
  std::mt19937_64 random(2);
  for (int k = 0; k < 60; ++k) {
    Situation situation = random_situation(random);
    situation.priority = Raster(Raster::Values::Constant(1, 1, 0.7), {0, 0}, 1.0, 0.7);
    for (const double weight : {0.0, 1.0}) {
      const Plan without = plan(situation, weight, {1.0, 0.0});
      const Plan with = plan(situation, weight, {1.0, 5.0});
      ASSERT_EQ(without.status, with.status);
      ASSERT_NEAR(without.tally.length, with.tally.length, 1e-9);
    }
  }
}

/// The paper's search with nothing but loops: penalty of the path that it finds, if any.
std::optional<double> slow_search(const Situation& situation, double heuristic_weight,
                                  const PenaltyWeights& weights, bool scaled) {
  struct Label {
    double length = 0.0;
    double priority = 0.0;
    std::int64_t to_goal = -1;
    bool open = false;
    bool closed = false;
  };
  const GridFrame& frame = situation.grid.frame();
  const Query& query = situation.query;
  const LevelRange all{0, frame.nz() - 1};
  const double direct = (query.goal - query.start).norm();
  const auto priority_at = [&](std::int64_t i) {
    const Point centre = frame.centre(frame.cell_at(i));
    return situation.priority.at(centre.x(), centre.y());
  };
  const std::int64_t start = frame.index(frame.cell_of(query.start));
  const std::int64_t goal = frame.index(frame.cell_of(query.goal));
  std::vector<Label> labels(frame.size());
  labels[goal].open = true;
  const auto g = [&](const Label& label) {  // Eq. (8)
    const double mean = label.length > 0.0 ? label.priority / label.length : priority_at(goal);
    return weights.length * label.length / direct - weights.priority * mean;
  };
  const auto f = [&](std::int64_t i) {                                                // Eq. (10)
    const double h = (frame.centre(frame.cell_at(i)) - query.start).norm() / direct;  // Eq. (9)
    return g(labels[i]) + heuristic_weight * (scaled ? weights.length : 1.0) * h;
  };
  while (!labels[start].closed) {
    std::int64_t best = -1;
    for (std::int64_t i = 0; i < frame.size(); ++i) {
      if (labels[i].open && (best < 0 || f(i) < f(best))) best = i;
    }
    if (best < 0) return std::nullopt;
    labels[best].open = false;
    labels[best].closed = true;
    const Cell cell = frame.cell_at(best);
    const std::uint32_t blocked = blocked_surroundings(situation.grid, cell, all);
    for (const Step& step : steps()) {
      if (blocked & step.box) continue;
      const std::int64_t next = frame.index(cell + step.offset());
      if (labels[next].closed) continue;
      const double length = Point(step.dx, step.dy, step.dz).cwiseProduct(frame.cell()).norm();
      Label label = labels[best];
      label.length += length;
      label.priority += length * (priority_at(best) + priority_at(next)) / 2;
      label.to_goal = best;
      label.open = true;
      label.closed = false;
      if (!labels[next].open || g(label) < g(labels[next]) - 1e-12) labels[next] = label;
    }
  }
  // Not the label's penalty but the path's: no squares may fill the columns.
  std::vector<Point> points;
  for (std::int64_t i = start; i >= 0; i = labels[i].to_goal) {
    points.push_back(frame.centre(frame.cell_at(i)));
  }
  double length = 0.0;
  double priority = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += (points[i] - points[i - 1]).norm();
    priority += situation.priority.integral(points[i - 1], points[i]);
  }
  return weights.length * length / direct - weights.priority * priority / length;
}

TEST(LengthPriority, IsThePapersSearch) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int found = 0;
  for (int k = 0; k < 120; ++k) {
    Situation situation = random_situation(random);
    if (situation.query.start == situation.query.goal) continue;
    // A raster of its own: finer or coarser than the columns, and shifted against them.
    Raster::Values values(15, 13);
    for (Eigen::Index i = 0; i < values.size(); ++i) values.data()[i] = unit(random);
    situation.priority = Raster(values, {-1.3 + unit(random), -2.9}, 0.4 + 2.0 * unit(random), 0.3);
    const double heuristic_weight = std::sqrt(std::array<double, 3>{0.0, 1.0, 3.0}[k % 3]);
    const PenaltyWeights weights{0.5, std::array<double, 4>{0.2, 1.0, 3.0, 10.0}[k % 4]};
    const bool scaled = k % 5 == 0;
    const Plan answer = plan(situation, heuristic_weight, weights, scaled);
    situation.priority = test::seen_priority(answer, situation);
    const std::optional<double> expected =
        slow_search(situation, heuristic_weight, weights, scaled);
    ASSERT_EQ(answer.status == PlanStatus::Found, expected.has_value());
    if (!expected) continue;
    ASSERT_NEAR(answer.penalty, *expected, 1e-9) << k;
    ++found;
  }
  EXPECT_GT(found, 60);
}

TEST(LengthPriority, NeverComesBackToACell) {
  // Priority so heavy that circling would pay.
  std::mt19937_64 random(3);
  int found = 0;
  for (int k = 0; k < 200; ++k) {
    const Situation situation = random_situation(random);
    const Plan answer = plan(situation, k % 2, {0.1, 100.0});
    std::set<std::tuple<int, int, int>> cells;
    for (Eigen::Index i = 0; i < answer.path.rows(); ++i) {
      const Cell cell = situation.grid.frame().cell_of(answer.path.row(i).transpose());
      const bool fresh = cells.insert({cell.x(), cell.y(), cell.z()}).second;
      ASSERT_TRUE(fresh || answer.path.rows() == 2) << answer.path;
    }
    found += answer.status == PlanStatus::Found;
  }
  EXPECT_GT(found, 100);
}

/// 21 x 7 cells with a strip of priority 1 along the north; start and goal in the south.
Situation strip() {
  const GridFrame frame(Point(0, 0, 0), Point(2, 2, 4), {21, 7, 1});
  Raster::Values values = Raster::Values::Zero(21, 7);
  values.rightCols(2).setOnes();
  Situation made{"", OccupancyGrid(frame), Raster(values, {0, 0}, 2.0), {}};
  made.query.start = frame.centre(Cell(0, 1, 0));
  made.query.goal = frame.centre(Cell(20, 1, 0));
  return made;
}

TEST(LengthPriority, GoesOutOfItsWayForPriority) {
  const Situation scene = strip();
  double last = -1.0;
  for (const double weight : {0.0, 0.1, 1.0, 10.0}) {
    const Plan answer = plan(scene, 0.0, {0.5, weight});
    ASSERT_EQ(answer.status, PlanStatus::Found);
    EXPECT_GE(answer.tally.mean_priority(), last) << weight;
    last = answer.tally.mean_priority();
    if (weight == 0.0) {
      EXPECT_DOUBLE_EQ(answer.tally.length, 40.0);
    }
  }
  // Four steps up to the strip and four down, diagonally, and along it: 12 of 20 columns.
  const Plan heavy = plan(scene, 0.0, {0.5, 10.0});
  EXPECT_GT(heavy.tally.mean_priority(), 0.5);
  EXPECT_GT(heavy.tally.length, 40.0);
}

TEST(LengthPriority, ExpandsLessWithAHeuristic) {
  const GridFrame frame(Point(0, 0, 0), Point(2, 2, 4), {30, 30, 3});
  Situation field{"", OccupancyGrid(frame), test::random_priority(frame, 1), {}};
  field.query.start = frame.centre(Cell(2, 2, 1));
  field.query.goal = frame.centre(Cell(27, 20, 1));
  // Next to no priority; without any, the first two are one search for the shortest path.
  const Plan without = plan(field, 0.0, {1.0, 1e-6});
  const Plan with = plan(field, 1.0, {1.0, 1e-6});
  const Plan weighted = plan(field, std::sqrt(3.0), {1.0, 1e-6});
  EXPECT_LT(with.stats.expanded, without.stats.expanded / 2);
  EXPECT_LE(weighted.stats.expanded, with.stats.expanded);
  // The three names are these three weights.
  const double weights[] = {0.0, 1.0, std::sqrt(3.0)};
  for (int i = 0; i < 3; ++i) {
    const std::string_view name = planners()[i].name;
    const Plan by_name = make_planner(name)->plan(field.scene(), field.query);
    const Plan by_weight = plan(field, weights[i], PenaltyWeights{});
    EXPECT_EQ(by_name.path, by_weight.path) << name;
    EXPECT_EQ(by_name.stats.expanded, by_weight.stats.expanded) << name;
  }
}

TEST(LengthPriority, BearsTheLargestAndSmallestNumbers) {
  std::mt19937_64 random(4);
  for (int k = 0; k < 40; ++k) {
    const Situation situation = random_situation(random);
    const PlanStatus expected = test::slow_status(situation);
    for (const double heuristic_weight : {0.0, 1e-300, 1e300}) {
      for (const PenaltyWeights& weights :
           {PenaltyWeights{1e300, 1e-300}, {1e-300, 1e300}, {0.0, 1.0}, {5e-324, 0.0}}) {
        EXPECT_EQ(plan(situation, heuristic_weight, weights).status, expected);
      }
    }
  }
}

TEST(LengthPriority, RefusesAHeuristicWeightThatIsNone) {
  for (const double weight : {-1.0, test::kNan, test::kInfinity}) {
    EXPECT_THROW(make_length_priority({}, {}, {weight}), std::invalid_argument) << weight;
  }
}

}  // namespace
}  // namespace ltp
