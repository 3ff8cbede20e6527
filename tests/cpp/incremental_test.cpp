// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The planner that remembers against a search from scratch, at every step of random flights.
#include "ltp/planning/incremental.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "ltp/planning/additive_search.hpp"
#include "ltp/planning/grid_query.hpp"
#include "scenes.hpp"

namespace ltp {
namespace {

constexpr double kAlpha = 1.2;

PlannerOptions options_with(double alpha = kAlpha) {
  PlannerOptions options;
  options.linearised.alpha = alpha;
  return options;
}

Raster random_ground(std::mt19937_64& random, int size, bool binary) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Raster::Values values(size, size);
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const double value = unit(random);
    values.data()[i] = binary ? std::round(value) : value;
  }
  return Raster(values, {-2.0 * (size / 2), -2.0 * (size / 2)}, 2.0);
}

/// What a search from scratch answers.
struct Scratch {
  PlanStatus status;
  double cost = 0.0;
  std::int64_t expanded = 0;
};

Scratch from_scratch(const Scene& scene, const Query& query, double alpha) {
  const ResolvedQuery resolved = resolve(scene, query);
  if (resolved.refused) return {*resolved.refused};
  AdditiveSearch search;
  SearchStats stats;
  const std::function<bool()> never;
  const AdditiveResult result =
      search.run(scene, query, resolved.cells, {alpha, 1.0}, Budget(0, never), stats);
  return {result.status, result.cost, stats.expanded};
}

/// A flight through a window that rolls, over a world that changes as it pleases.
class Flight {
 public:
  Flight(std::uint64_t seed, const std::array<int, 3>& dims)
      : random_(seed),
        grid_(GridFrame({-8, -8, -8}, {2, 2, 4}, dims)),
        ground_(random_ground(random_, 64, seed % 2 == 0)) {
    const GridFrame& frame = grid_.frame();
    for (std::int64_t i = 0; i < frame.size(); ++i) {
      if (chance(0.15)) grid_.set(frame.cell_at(i));
    }
    query_.start = anywhere();
    query_.goal = anywhere();
    if (seed % 3 == 0) query_.band = {4.0, 5.0};
  }

  double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }
  bool chance(double share) { return unit() < share; }
  Point anywhere() {
    const GridFrame& frame = grid_.frame();
    return frame.origin() +
           Point(unit(), unit(), unit()).cwiseProduct(frame.upper() - frame.origin());
  }
  Cell any_cell() { return grid_.frame().cell_of(anywhere()); }

  /// One scan later.
  void change(const Path& path) {
    if (chance(0.5)) {
      for (int i = 0; i < 3; ++i) grid_.set(any_cell());
    }
    if (chance(0.4)) {
      for (int i = 0; i < 3; ++i) grid_.set(any_cell(), false);
    }
    if (chance(0.2) && path.rows() > 2) {  // right on the path
      const Eigen::Index row = 1 + static_cast<Eigen::Index>(unit() * (path.rows() - 2));
      grid_.set(grid_.frame().cell_of(path.row(row).transpose()));
    }
    if (chance(0.3)) {
      const auto step = [&] { return static_cast<int>(unit() * 5.0) - 2; };
      grid_.roll(Cell(step(), step(), chance(0.3) ? step() / 2 : 0));
      if (chance(0.5)) {  // what has entered need not be free
        for (int i = 0; i < 10; ++i) grid_.set(any_cell());
      }
    }
    if (path.rows() >= 2 && chance(0.7)) {
      const Point ahead = path.row(1).transpose();
      query_.start += (ahead - query_.start) * std::min(1.0, 2.0 * unit());
    } else if (chance(0.1)) {
      query_.start = anywhere();
    }
    if (chance(0.03)) query_.goal = anywhere();
    if (chance(0.02)) query_.goal += Point(1e-3, 0, 0);
    if (chance(0.02)) ground_ = random_ground(random_, 64, chance(0.5));
    const GridFrame& frame = grid_.frame();
    if (frame.contains(query_.start) && chance(0.9)) {
      grid_.set(frame.cell_of(query_.start), false);
    }
    if (frame.contains(query_.goal) && chance(0.9)) grid_.set(frame.cell_of(query_.goal), false);
    if (!frame.contains(query_.goal) && chance(0.5)) query_.goal = anywhere();
    if (!frame.contains(query_.start) && chance(0.9)) query_.start = anywhere();
  }

  Scene scene() const { return {grid_, ground_}; }
  const Query& query() const { return query_; }

 private:
  std::mt19937_64 random_;
  OccupancyGrid grid_;
  Raster ground_;
  Query query_;
};

TEST(Incremental, CostsWhatASearchFromScratchCostsAtEveryStep) {
  const std::array<int, 3> shapes[] = {{16, 14, 1}, {10, 9, 5}, {7, 12, 70}, {24, 24, 3}};
  int steps_made = 0;
  int found = 0;
  int unreachable = 0;
  for (std::uint64_t seed = 0; seed < 48; ++seed) {
    Flight flight(seed, shapes[seed % 4]);
    const double alpha = seed % 5 == 0 ? 1.001 : kAlpha;
    IncrementalPlanner planner(options_with(alpha));
    Path path(0, 3);
    for (int step = 0; step < 150; ++step) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", step " + std::to_string(step));
      const Scene scene = flight.scene();
      const Plan plan = planner.plan(scene, flight.query());
      const Scratch scratch = from_scratch(scene, flight.query(), alpha);
      ASSERT_EQ(to_string(plan.status), to_string(scratch.status));
      ++steps_made;
      unreachable += plan.status == PlanStatus::Unreachable;
      path = plan.path;
      if (plan.status == PlanStatus::Found &&
          scene.occupancy.frame().cell_of(flight.query().start) !=
              scene.occupancy.frame().cell_of(flight.query().goal)) {
        ++found;
        ASSERT_NEAR(alpha * plan.tally.length - plan.tally.priority, scratch.cost, 1e-9);
      }
      flight.change(path);
    }
  }
  EXPECT_EQ(steps_made, 48 * 150);
  EXPECT_GT(found, 4000);
  EXPECT_GT(unreachable, 100);
}

/// An open field with a wall across, seen from the start side; the way leads round it.
struct Field {
  Field() : grid(GridFrame({0, 0, 0}, {2, 2, 4}, {60, 60, 5})), ground(ground_of()) {
    for (int iy = 10; iy < 45; ++iy) {
      for (int iz = 0; iz < 5; ++iz) grid.set(Cell(30, iy, iz));
    }
    query.start = grid.frame().centre(Cell(10, 25, 2));
    query.goal = grid.frame().centre(Cell(50, 27, 2));
    query.band = test::kPlanar;
  }
  static Raster ground_of() {
    std::mt19937_64 random(5);
    return random_ground(random, 120, false);
  }
  Scene scene() const { return {grid, ground}; }

  OccupancyGrid grid;
  Raster ground;
  Query query;
};

TEST(Incremental, SettlesNothingWhileItsPathStands) {
  Field field;
  IncrementalPlanner planner(options_with());
  Plan plan = planner.plan(field.scene(), field.query);
  ASSERT_EQ(plan.status, PlanStatus::Found);
  EXPECT_GT(plan.stats.expanded, 100);
  const Path path = plan.path;
  for (Eigen::Index i = 0; i + 1 < path.rows(); ++i) {  // along it, while the window rolls
    field.query.start = path.row(i).transpose();
    if (i % 8 == 7) field.grid.roll(Cell(1, 0, 0));
    plan = planner.plan(field.scene(), field.query);
    ASSERT_EQ(plan.status, PlanStatus::Found);
    EXPECT_LE(plan.stats.expanded, 30) << "point " << i;
    EXPECT_NEAR(kAlpha * plan.tally.length - plan.tally.priority,
                from_scratch(field.scene(), field.query, kAlpha).cost, 1e-9);
  }
  plan = planner.plan(field.scene(), field.query);
  EXPECT_EQ(plan.stats.expanded, 0);
  // An obstacle off the path changes nothing.
  field.grid.set(Cell(5, 55, 2));
  EXPECT_EQ(planner.plan(field.scene(), field.query).stats.expanded, 0);
}

TEST(Incremental, TakesAShortCutThatHasOpened) {
  Field field;
  IncrementalPlanner planner(options_with());
  const Plan around = planner.plan(field.scene(), field.query);
  field.grid.set(Cell(30, 26, 2), false);
  const Plan through = planner.plan(field.scene(), field.query);
  EXPECT_LT(through.tally.length, around.tally.length);
  EXPECT_NEAR(kAlpha * through.tally.length - through.tally.priority,
              from_scratch(field.scene(), field.query, kAlpha).cost, 1e-9);
}

TEST(Incremental, BeginsAnewWhenTheQuestionIsAnother) {
  Field field;
  const auto begins_anew = [&](const Field& next) {
    IncrementalPlanner planner(options_with());
    planner.plan(field.scene(), field.query);
    const Plan plan = planner.plan(next.scene(), next.query);
    const Plan fresh = IncrementalPlanner(options_with()).plan(next.scene(), next.query);
    EXPECT_EQ(plan.status, fresh.status);
    EXPECT_EQ(plan.tally.length, fresh.tally.length);
    EXPECT_EQ(plan.tally.priority, fresh.tally.priority);
    EXPECT_EQ(plan.stats.expanded, fresh.stats.expanded);
    EXPECT_EQ(plan.stats.pushed, fresh.stats.pushed);
  };
  Field next;  // its priority map holds the same, but is not a copy
  begins_anew(next);
  next = field;
  next.query.goal += Point(1e-9, 0, 0);
  begins_anew(next);
  next = field;
  next.grid = OccupancyGrid(GridFrame({0.5, 0, 0}, {2, 2, 4}, {60, 60, 5}));
  begins_anew(next);
  next.grid = OccupancyGrid(GridFrame({0, 0, 0}, {2, 2, 4}, {60, 61, 5}));
  begins_anew(next);
  next.grid = OccupancyGrid(GridFrame({0, 0, 0}, {2, 2.5, 4}, {60, 60, 5}));
  begins_anew(next);
}

TEST(Incremental, KeepsWhatItKnowsWhileAQueryIsRefused) {
  Field field;
  IncrementalPlanner planner(options_with());
  planner.plan(field.scene(), field.query);
  field.grid.set(Cell(50, 27, 2));
  EXPECT_EQ(planner.plan(field.scene(), field.query).status, PlanStatus::GoalBlocked);
  field.grid.set(Cell(50, 27, 2), false);
  EXPECT_EQ(planner.plan(field.scene(), field.query).stats.expanded, 0);
}

TEST(Incremental, IsExactAfterABudgetThatWasTooSmall) {
  int stopped = 0;
  for (const std::int64_t limit : {3, 40, 200}) {
    Flight flight(7, {24, 24, 3});
    PlannerOptions options = options_with();
    options.max_expansions = limit;
    IncrementalPlanner planner(options);
    for (int step = 0; step < 300; ++step) {
      const Scene scene = flight.scene();
      const Plan plan = planner.plan(scene, flight.query());
      const Scratch scratch = from_scratch(scene, flight.query(), kAlpha);
      EXPECT_LE(plan.stats.expanded, limit);
      if (plan.status == PlanStatus::OutOfBudget) {
        ++stopped;
      } else {
        ASSERT_EQ(to_string(plan.status), to_string(scratch.status)) << step;
        if (plan.tally.length > 0.0 && scratch.cost > 0.0) {
          ASSERT_NEAR(kAlpha * plan.tally.length - plan.tally.priority, scratch.cost, 1e-9);
        }
      }
      flight.change(plan.path);
    }
  }
  EXPECT_GT(stopped, 30);
}

}  // namespace
}  // namespace ltp
