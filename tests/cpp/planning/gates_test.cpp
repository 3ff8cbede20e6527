// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Regions and several gates against the slow answer: the least over all ways through all of their
// free cells; and one contract for every planner.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <queue>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "budgets.hpp"
#include "ltp/planning/planners.hpp"
#include "ltp/planning/planners/gated.hpp"
#include "planning/additive/additive_search.hpp"
#include "small_grids.hpp"

namespace ltp {
namespace {

using planning::AdditiveCost;
using test::kInfinity;
using test::SmallGrid;

constexpr std::array<int, 3> kPlane{9, 8, 1};
constexpr std::array<int, 3> kSpace{5, 4, 3};

/// A small grid whose query has gates: one, or so many more.
SmallGrid random_gates(std::mt19937_64& random, const std::array<int, 3>& dims, int more,
                       double density = 0.2) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  SmallGrid made = test::random_small_grid(random, dims, density);
  const auto radius = [&] { return unit(random) < 0.2 ? 0.0 : 5.0 * unit(random); };
  const auto height = [&] { return 5.0 * unit(random); };
  made.query.gate_radius = more > 0 ? radius() : 0.1 + 5.0 * unit(random);
  made.query.gate_height = height();
  for (int i = 0; i < more; ++i) {
    const Point point(unit(random) * 2 * dims[0], unit(random) * 2 * dims[1],
                      unit(random) * 4 * dims[2]);
    made.query.then.push_back({point, radius(), height()});
  }
  return made;
}

/// Where a path serves a gate, from the definition.
bool serves(const GridFrame& frame, const Gate& gate, const Point& point, bool last) {
  const Point offset = point - gate.point;
  if (offset.head<2>().norm() <= gate.radius + 1e-9 && std::abs(offset.z()) <= gate.height + 1e-9) {
    return true;
  }
  return last ? point == gate.point : frame.cell_of(point) == frame.cell_of(gate.point);
}

std::vector<Gate> gates_of(const Query& query) {
  std::vector<Gate> gates{{query.goal, query.gate_radius, query.gate_height}};
  gates.insert(gates.end(), query.then.begin(), query.then.end());
  return gates;
}

/// The least alpha L - P from the start through all gates, by a textbook's Dijkstra over cells and
/// gates passed, each step tallied; infinite if there is no way.
double slow_cost(const SmallGrid& small, const Problem& problem, double alpha, double beta) {
  const GridFrame& frame = small.grid.frame();
  const std::vector<Gate> gates = gates_of(problem.query);
  const std::size_t ends = gates.size();
  const auto advance = [&](const Point& point, std::size_t passed) {
    while (passed < ends && serves(frame, gates[passed], point, passed + 1 == ends)) ++passed;
    return passed;
  };
  const auto cost = [&](const Point& a, const Point& b) {
    Path path(2, 3);
    path << a.transpose(), b.transpose();
    const PathTally sums = tally(path, small.priority);
    return alpha * sums.length - beta * sums.priority;
  };
  const Cell start = frame.cell_of(problem.query.start);
  const std::size_t first = advance(problem.query.start, 0);
  if (first == ends) return 0.0;
  const Cell last = frame.cell_of(gates.back().point);
  if (first + 1 == ends && start == last) return cost(problem.query.start, gates.back().point);
  using Entry = std::pair<double, std::int64_t>;
  const std::int64_t size = frame.size();
  std::vector<double> costs(static_cast<std::size_t>(size) * (ends + 1) + 1, kInfinity);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto offer = [&](std::int64_t state, double total) {
    if (total >= costs[state]) return;
    costs[state] = total;
    open.push({total, state});
  };
  const std::int64_t begin = size * static_cast<std::int64_t>(ends + 1);  // the start itself
  costs[begin] = 0.0;
  open.push({0.0, begin});
  while (!open.empty()) {
    const auto [total, state] = open.top();
    open.pop();
    if (total > costs[state]) continue;
    const std::size_t passed = state == begin ? first : static_cast<std::size_t>(state / size);
    if (passed == ends) return total;
    const Cell cell = state == begin ? start : frame.cell_at(state % size);
    const Point from = state == begin ? problem.query.start : problem.vertex(cell);
    const std::uint32_t blocked = blocked_surroundings(small.grid, cell, problem.levels);
    const auto step = [&](const Cell& next) {
      const Point vertex = problem.vertex(next);
      const Point& point = gates.back().point;
      // All but the last are passed at vertices; the last at one, or at its point.
      std::size_t now = passed;
      while (now + 1 < ends && serves(frame, gates[now], vertex, false)) ++now;
      const std::int64_t end = static_cast<std::int64_t>(ends) * size;
      if (now + 1 == ends && next == last) {
        const bool direct = now == passed || advance(point, passed) == ends;
        const double on =
            direct || serves(frame, gates.back(), vertex, true) ? 0.0 : cost(vertex, point);
        offer(end, total + cost(from, direct ? point : vertex) + on);
      } else if (now + 1 == ends && serves(frame, gates.back(), vertex, true)) {
        offer(end, total + cost(from, vertex));
      } else if (next != start || now > first) {  // there the start stands for the vertex
        offer(static_cast<std::int64_t>(now) * size + frame.index(next),
              total + cost(from, vertex));
      }
    };
    for (const Step& one : steps()) {
      if ((blocked & one.box) == 0) step(cell + one.offset());
    }
    if (state == begin && advance(problem.vertex(start), first) > first) step(start);  // in place
  }
  return kInfinity;
}

class Gates : public ::testing::TestWithParam<int> {};  // so many more than one

TEST_P(Gates, TheAdditiveSearchFindsTheLeastCostThroughThem) {
  std::mt19937_64 random(1 + GetParam());
  planning::AdditiveSearch search;
  int found = 0;
  for (int i = 0; i < 600; ++i) {
    const SmallGrid small = random_gates(random, i % 2 ? kPlane : kSpace, GetParam());
    const Problem problem(small.scene(), small.query, {});
    if (problem.refused() || !problem.has_gates() || problem.served()) continue;
    const double alpha = i % 3 == 0 ? 1.001 : 1.05 + 0.01 * (i % 50);
    const bool shortest = i % 5 == 0;
    const AdditiveCost cost = shortest ? AdditiveCost{1.0, 0.0} : AdditiveCost{alpha, 1.0};
    SearchStats stats;
    const planning::AdditiveResult result = search.run(problem, cost, *test::Limit(), stats);
    const double least = slow_cost(small, problem, cost.length, cost.priority);
    SCOPED_TRACE("grid " + std::to_string(i));
    ASSERT_EQ(result.status == PlanStatus::Found, least < kInfinity);
    if (result.status != PlanStatus::Found) continue;
    ++found;
    EXPECT_NEAR(result.cost, least, 1e-9);
    const Path path = path_through(problem, result.chain);
    const PathTally sums = tally(path, small.priority);
    EXPECT_NEAR(cost.length * sums.length - cost.priority * sums.priority, least, 1e-9);
    EXPECT_NO_THROW(accepted(problem, path));
  }
  EXPECT_GT(found, 150);
}

TEST_P(Gates, TheBoundIsBelowEveryPathThroughThem) {
  std::mt19937_64 random(20 + GetParam());
  int judged = 0;
  for (int i = 0; i < 300; ++i) {
    const SmallGrid small = random_gates(random, i % 2 ? kPlane : kSpace, GetParam());
    PlannerOptions options;
    options.weights = {0.5, i % 3 == 0 ? 0.5 : i % 3 == 1 ? 1.0 : 3.0};
    options.linearised.tolerance = 0.0;
    const Plan plan = make_planner("sweep", options)->plan(small.scene(), small.query);
    if (plan.status != PlanStatus::Found) continue;
    SCOPED_TRACE("grid " + std::to_string(i));
    ASSERT_TRUE(plan.bound.has_value());
    EXPECT_LE(*plan.bound, plan.penalty);
    Query served = small.query;
    served.then.resize(plan.passed.size() - 1);
    const Problem problem(small.scene(), served, options.weights);
    if (problem.served()) continue;
    planning::AdditiveSearch search;
    for (const double alpha : {1.001, 1.02, 1.1, 1.3, 2.0, 20.0}) {
      SearchStats stats;
      const planning::AdditiveResult other =
          search.run(problem, {alpha, 1.0}, *test::Limit(), stats);
      ASSERT_EQ(other.status, PlanStatus::Found);
      const Plan upper = accepted(problem, path_through(problem, other.chain));
      EXPECT_GE(upper.penalty, *plan.bound - 1e-9) << alpha;
      EXPECT_GE(upper.tally.length, problem.least_length - 1e-9);
      ++judged;
    }
  }
  EXPECT_GT(judged, 500);
}

INSTANTIATE_TEST_SUITE_P(More, Gates, ::testing::Values(0, 1, 2));

/// All simple paths that end where they enter the region.
double region_optimum(const SmallGrid& small, const Problem& problem,
                      const PenaltyWeights& weights) {
  const GridFrame& frame = small.grid.frame();
  const Penalty penalty(weights, problem.direct_length);
  const GateRegion& region = problem.gates.front();
  double best = kInfinity;
  std::vector<char> used(static_cast<std::size_t>(frame.size()), 0);
  std::vector<Cell> chain{problem.start};
  const auto extend = [&](const auto& self, const PathTally& sums) -> void {
    const Cell cell = chain.back();
    const Point from = chain.size() == 1 ? problem.query.start : problem.vertex(cell);
    const auto go = [&](const Cell& next) {
      const bool ends = region.contains(next);
      const Point to = next == region.own() ? region.gate().point : problem.vertex(next);
      Path step(2, 3);
      step << from.transpose(), to.transpose();
      const PathTally more = tally(step, small.priority);
      const PathTally total{sums.length + more.length, sums.priority + more.priority};
      if (ends) {
        best = std::min(best, penalty(total));
        return;
      }
      used[frame.index(next)] = 1;
      chain.push_back(next);
      self(self, total);
      chain.pop_back();
      used[frame.index(next)] = 0;
    };
    const std::uint32_t blocked = blocked_surroundings(small.grid, cell, problem.levels);
    for (const Step& one : steps()) {
      const Cell next = cell + one.offset();
      if ((blocked & one.box) == 0 && used[frame.index(next)] == 0) go(next);
    }
    if (chain.size() == 1 && region.contains(problem.start)) go(problem.start);
  };
  used[frame.index(problem.start)] = 1;
  extend(extend, {});
  return best;
}

TEST(Regions, SweepAndExactAreBoundedByTheOptimumOverAllPathsIntoIt) {
  std::mt19937_64 random(3);
  int judged = 0;
  double gap = 0.0;
  for (int i = 0; i < 300; ++i) {
    SmallGrid small =
        random_gates(random, i % 2 ? std::array<int, 3>{4, 4, 1} : std::array<int, 3>{2, 2, 2}, 0);
    small.query.gate_radius *= 0.5;
    PlannerOptions options;
    options.weights = {0.5, i % 3 == 0 ? 0.5 : i % 3 == 1 ? 1.0 : 3.0};
    options.linearised.tolerance = 0.0;
    const Problem problem(small.scene(), small.query, options.weights);
    if (problem.refused() || problem.within_a_cell()) continue;
    const double optimum = region_optimum(small, problem, options.weights);
    for (const char* name : {"additive", "sweep", "exact", "auto"}) {
      const Plan plan = make_planner(name, options)->plan(small.scene(), small.query);
      SCOPED_TRACE(std::string(name) + ", grid " + std::to_string(i));
      ASSERT_EQ(plan.status == PlanStatus::Found, optimum < kInfinity);
      if (plan.status != PlanStatus::Found) continue;
      ++judged;
      EXPECT_GE(plan.penalty, optimum - 1e-9);
      ASSERT_TRUE(plan.bound.has_value());
      EXPECT_LE(*plan.bound, optimum + 1e-9);
      if (std::string(name) == "sweep") gap += plan.penalty - optimum;
    }
  }
  EXPECT_GT(judged, 400);
  EXPECT_LT(gap / (judged / 4.0), 0.02);
}

TEST(Regions, AWiderOneIsNeverFarther) {
  std::mt19937_64 random(4);
  PlannerOptions options;
  options.weights = {1.0, 0.0};
  const auto planner = make_planner("sweep", options);
  int judged = 0;
  for (int i = 0; i < 300; ++i) {
    SmallGrid small = test::random_small_grid(random, i % 2 ? kPlane : kSpace);
    double before = kInfinity;
    for (const double radius : {0.0, 0.5, 1.5, 3.0, 6.0, 30.0}) {
      small.query.gate_radius = radius;
      small.query.gate_height = radius;
      const Plan plan = planner->plan(small.scene(), small.query);
      const double length = plan.status == PlanStatus::Found ? plan.tally.length : kInfinity;
      EXPECT_LE(length, before + 1e-9) << "grid " << i << ", radius " << radius;
      judged += length < before;
      before = length;
    }
    EXPECT_EQ(before, 0.0);
  }
  EXPECT_GT(judged, 600);
}

TEST(Regions, OfRadiusZeroArePoints) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 50; ++i) {
    SmallGrid small = test::random_small_grid(random, kPlane);
    const Plan point = make_planner()->plan(small.scene(), small.query);
    small.query.gate_height = 3.0;
    const Plan same = make_planner()->plan(small.scene(), small.query);
    EXPECT_EQ(point.penalty, same.penalty);
    EXPECT_EQ(point.path, same.path);
    EXPECT_EQ(point.stats.expanded, same.stats.expanded);
    EXPECT_EQ(point.passed.size(), point.status == PlanStatus::Found ? 1u : 0u);
  }
}

TEST(Regions, LeadPastABlockedPoint) {
  SmallGrid small{OccupancyGrid(GridFrame({0, 0, 0}, {2, 2, 4}, {20, 20, 1})),
                  Raster(Raster::Values::Zero(20, 20), {0, 0}, 2.0), Query{}};
  small.query = {Point(3, 3, 2), Point(31, 31, 2), {}};
  small.grid.set(small.grid.frame().cell_of(small.query.goal));
  for (const PlannerInfo& info : planners()) {
    SCOPED_TRACE(info.name);
    small.query.gate_radius = 0.0;
    const auto planner = make_planner(info.name);
    EXPECT_EQ(planner->plan(small.scene(), small.query).status, PlanStatus::GoalBlocked);
    small.query.gate_radius = 5.0;
    const Plan plan = planner->plan(small.scene(), small.query);
    ASSERT_EQ(plan.status, PlanStatus::Found);
    const Point end = plan.path.row(plan.path.rows() - 1).transpose();
    EXPECT_LE((end - small.query.goal).norm(), 5.0 + 1e-9);
  }
}

std::vector<std::string_view> names() {
  std::vector<std::string_view> all;
  for (const PlannerInfo& info : planners()) all.push_back(info.name);
  return all;
}

class GatesContract : public ::testing::TestWithParam<std::string_view> {};

TEST_P(GatesContract, PathsPassAllGatesInOrderAndEndWhereTheyEnterTheLast) {
  PlannerOptions options;
  options.bezier = {9, 12.0, 1, 0.0, 12};
  options.hermite = {12, 3, 2.0, 2, 8};
  options.exact.memory = 2.0;
  std::mt19937_64 random(6);
  int found = 0;
  int all = 0;
  for (const bool refine : {false, true}) {
    options.refine = refine;
    const auto planner = make_planner(GetParam(), options);
    for (int i = 0; i < 150; ++i) {
      SCOPED_TRACE(std::to_string(i) + (refine ? " refined" : ""));
      const SmallGrid small = random_gates(random, i % 2 ? kPlane : kSpace, i % 3, 0.1);
      const GridFrame& frame = small.grid.frame();
      const Plan plan = planner->plan(small.scene(), small.query);
      EXPECT_EQ(plan.passed.empty(), plan.status != PlanStatus::Found);
      if (plan.status != PlanStatus::Found) continue;
      ++found;
      const std::vector<Gate> gates = gates_of(small.query);
      ASSERT_LE(plan.passed.size(), gates.size());
      all += plan.passed.size() == gates.size();
      EXPECT_EQ(plan.path.row(0).transpose(), small.query.start);
      EXPECT_FALSE(test::meets_blocked(small.grid, plan.path, -1e-9));
      EXPECT_EQ(plan.passed.back(), plan.tally.length);
      EXPECT_TRUE(std::is_sorted(plan.passed.begin(), plan.passed.end()));
      Query served = small.query;
      served.then.resize(plan.passed.size() - 1);
      EXPECT_DOUBLE_EQ(plan.penalty,
                       Penalty(options.weights, direct_length(served))(
                           plan.tally, small.priority.at(plan.path(plan.path.rows() - 1, 0),
                                                         plan.path(plan.path.rows() - 1, 1))));
      const bool region = served.has_gates();
      std::size_t passed = 0;
      double arc = 0.0;
      for (Eigen::Index k = 0; k < plan.path.rows() && region; ++k) {
        const Point here = plan.path.row(k).transpose();
        if (k > 0) arc += (here - Point(plan.path.row(k - 1).transpose())).norm();
        const bool moved = k > 0 && plan.path.row(k) != plan.path.row(k - 1);
        EXPECT_FALSE(passed == plan.passed.size() && moved) << "it goes on";
        while (passed < plan.passed.size() &&
               serves(frame, gates[passed], here, passed + 1 == plan.passed.size())) {
          EXPECT_NEAR(plan.passed[passed], arc, 1e-9);
          ++passed;
        }
      }
      EXPECT_TRUE(!region || passed == plan.passed.size());
      if (plan.bound && !refine) {
        EXPECT_LE(*plan.bound, plan.penalty + 1e-12);
      }
      const bool native = planner->info().has(Trait::Horizon) || !small.query.has_gates();
      EXPECT_EQ(plan.bound.has_value(), planner->info().has(Trait::Bounds) && native);
    }
  }
  EXPECT_GT(found, 120);
  EXPECT_GT(all, 80);
}

TEST_P(GatesContract, StopBeforeAGateThatIsWalledIn) {
  SmallGrid small{OccupancyGrid(GridFrame({0, 0, 0}, {2, 2, 4}, {30, 30, 1})),
                  Raster(Raster::Values::Zero(30, 30), {0, 0}, 2.0), Query{}};
  small.query = {Point(5, 5, 2), Point(25, 5, 2), {}, 3.0, 1.0, {}};
  small.query.then = {{Point(45, 5, 2), 3.0, 1.0}, {Point(45, 45, 2), 1.0, 1.0}};
  const Cell closed = small.grid.frame().cell_of(Point(45, 45, 2));
  for (const Step& step : steps()) {
    const Cell beside = closed + step.offset();
    if (step.dz == 0) small.grid.set(beside);
  }
  const auto planner = make_planner(GetParam());
  const Plan plan = planner->plan(small.scene(), small.query);
  ASSERT_EQ(plan.status, PlanStatus::Found);
  EXPECT_EQ(plan.passed.size(), 2u);
  small.grid.set(closed);  // blocked altogether
  EXPECT_EQ(planner->plan(small.scene(), small.query).passed.size(), 2u);
  small.query.then[1].point = Point(500, 5, 2);  // beyond the window
  EXPECT_EQ(planner->plan(small.scene(), small.query).passed.size(), 2u);
  small.query.then[0].point = Point(45, 45, 2);
  EXPECT_EQ(planner->plan(small.scene(), small.query).passed.size(), 1u);
  small.query.goal = Point(500, 5, 2);
  EXPECT_EQ(planner->plan(small.scene(), small.query).status, PlanStatus::OutsideMap);
}

TEST_P(GatesContract, NameWhatIsWrong) {
  const auto planner = make_planner(GetParam());
  std::mt19937_64 random(7);
  const SmallGrid small = test::random_small_grid(random, kPlane);
  const auto message = [&](void (*spoil)(Query&)) {
    Query query = small.query;
    spoil(query);
    try {
      planner->plan(small.scene(), query);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("nothing was thrown");
  };
  EXPECT_EQ(message([](Query& q) { q.gate_radius = -1.0; }).rfind("gate_radius = -1", 0), 0u);
  EXPECT_EQ(message([](Query& q) { q.gate_height = test::kNan; }).rfind("gate_height = nan", 0),
            0u);
  EXPECT_EQ(message([](Query& q) {
              q.then = {{}, {Point::Zero(), -2.0}};
            }).rfind("then[1].radius = -2", 0),
            0u);
}

INSTANTIATE_TEST_SUITE_P(All, GatesContract, ::testing::ValuesIn(names()),
                         [](const ::testing::TestParamInfo<std::string_view>& planner) {
                           std::string name(planner.param);
                           for (char& letter : name) letter = letter == '-' ? '_' : letter;
                           return name;
                         });

TEST(MakeGated, LeavesPlannersAloneThatNeedItNot) {
  EXPECT_THROW(make_gated(nullptr, {}), std::invalid_argument);
  auto planner = make_planner("additive");
  const Planner* const itself = planner.get();
  EXPECT_EQ(make_gated(std::move(planner), {}).get(), itself);
}

}  // namespace
}  // namespace ltp
