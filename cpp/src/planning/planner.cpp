// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The planners by name, and what their options and queries must satisfy.
#include "ltp/planning/planner.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "ltp/geometry/check.hpp"
#include "ltp/planning/ara_star.hpp"
#include "ltp/planning/bezier.hpp"
#include "ltp/planning/bug.hpp"
#include "ltp/planning/hermite.hpp"
#include "ltp/planning/incremental.hpp"
#include "ltp/planning/length_priority.hpp"
#include "ltp/planning/linearised.hpp"
#include "ltp/planning/pareto.hpp"
#include "ltp/planning/refine.hpp"
#include "ltp/planning/risk_a_star.hpp"
#include "ltp/planning/wavefront.hpp"

namespace ltp {
namespace {

using Maker = std::unique_ptr<Planner> (*)(std::string_view, const PlannerOptions&);

struct Entry {
  std::string_view name;
  Maker make;
};

template <int kHeuristicWeightSquared>
std::unique_ptr<Planner> length_priority(std::string_view name, const PlannerOptions& options) {
  return std::make_unique<LengthPriorityPlanner>(
      std::string(name), std::sqrt(double{kHeuristicWeightSquared}), options);
}

std::unique_ptr<Planner> additive(std::string_view name, const PlannerOptions& options) {
  return std::make_unique<LinearisedPlanner>(std::string(name), 1, options);
}

std::unique_ptr<Planner> sweep(std::string_view name, const PlannerOptions& options) {
  return std::make_unique<LinearisedPlanner>(std::string(name), options.linearised.searches,
                                             options);
}

/// What a UAV should fly: a sweep whose last searches cannot take much longer than its first.
std::unique_ptr<Planner> automatic(std::string_view name, const PlannerOptions& options) {
  constexpr std::int64_t kEffort = 20000;
  options.check();
  PlannerOptions bounded = options;
  LinearisedOptions& limits = bounded.linearised;
  if (limits.effort == 0) limits.effort = kEffort;
  limits.closing = 0;
  return sweep(name, bounded);
}

template <typename Kind>
std::unique_ptr<Planner> plain(std::string_view, const PlannerOptions& options) {
  return std::make_unique<Kind>(options);
}

constexpr Entry kPlanners[] = {
    {"lp-dijkstra", length_priority<0>},  // W_A* = 0
    {"lp-a-star", length_priority<1>},    // W_A* = 1
    {"wlp-a-star", length_priority<3>},   // W_A* = sqrt(3)
    {"ggwp", plain<WavefrontPlanner>},
    {"bezier", plain<BezierPlanner>},
    {"additive", additive},  // beyond the paper
    {"sweep", sweep},
    {"pareto", plain<ParetoPlanner>},
    {"incremental", plain<IncrementalPlanner>},
    {"ara-star", plain<AraStarPlanner>},  // the paper's neighbours
    {"risk-a-star", plain<RiskAStarPlanner>},
    {"bug", plain<BugPlanner>},
    {"hermite", plain<HermitePlanner>},
    {"auto", automatic},
};

void odd(const std::string& name, int value) {
  if (value < 1 || value % 2 == 0) check::fail(name, value, "an odd number >= 1");
}

void pieces(const std::string& name, int value) {
  if (value < 2 || value > 100000) check::fail(name, value, "a number from 2 to 100000");
}

}  // namespace

std::string_view to_string(PlanStatus status) {
  switch (status) {
    case PlanStatus::Found:
      return "found";
    case PlanStatus::OutsideMap:
      return "outside_map";
    case PlanStatus::StartBlocked:
      return "start_blocked";
    case PlanStatus::GoalBlocked:
      return "goal_blocked";
    case PlanStatus::Unreachable:
      return "unreachable";
    case PlanStatus::NoneFound:
      return "none_found";
    case PlanStatus::OutOfBudget:
      return "out_of_budget";
  }
  return "unknown";
}

void PlannerOptions::check() const {
  weights.check();
  if (max_expansions < 0) check::fail("max_expansions", max_expansions, "a number >= 0");
  odd("bezier.offsets", bezier.offsets);
  odd("bezier.z_offsets", bezier.z_offsets);
  check::positive("bezier.reach", bezier.reach);
  check::not_negative("bezier.z_reach", bezier.z_reach);
  pieces("bezier.segments", bezier.segments);
  check::not_negative("linearised.alpha", linearised.alpha);
  check::not_negative("linearised.tolerance", linearised.tolerance);
  if (linearised.searches < 1) {
    check::fail("linearised.searches", linearised.searches, "a number >= 1");
  }
  if (linearised.effort < 0) {
    check::fail("linearised.effort", linearised.effort, "a number >= 0");
  }
  if (linearised.closing < 0) {
    check::fail("linearised.closing", linearised.closing, "a number >= 0");
  }
  check::positive("pareto.memory", pareto.memory);
  check::not_negative("pareto.eps", pareto.eps);
  if (!(ara.first_weight >= 1.0 && ara.first_weight <= 100.0)) {
    check::fail("ara.first_weight", ara.first_weight, "a number from 1 to 100");
  }
  if (!(ara.step >= 0.01) || !std::isfinite(ara.step)) {
    check::fail("ara.step", ara.step, "a finite number >= 0.01");
  }
  check::positive("risk.length_factor", risk.length_factor);
  check::not_negative("bug.range", bug.range);
  pieces("hermite.segments", hermite.segments);
  odd("hermite.starts", hermite.starts);
  if (!(hermite.reach > 0.0 && hermite.reach <= 1000.0)) {
    check::fail("hermite.reach", hermite.reach, "a number over 0, at most 1000");
  }
  if (hermite.refined < 1) check::fail("hermite.refined", hermite.refined, "a number >= 1");
  if (hermite.iterations < 0) {
    check::fail("hermite.iterations", hermite.iterations, "a number >= 0");
  }
}

LevelRange levels_of(const GridFrame& frame, const Query& query) {
  const double low = std::min(query.start.z(), query.goal.z()) - query.band.below;
  const double high = std::max(query.start.z(), query.goal.z()) + query.band.above;
  const auto level = [&](double z) {
    if (z <= frame.origin().z()) return 0;  // an open band has no cell of its own
    if (z >= frame.upper().z()) return frame.nz() - 1;
    return std::clamp(frame.cell_of(Point(query.start.x(), query.start.y(), z)).z(), 0,
                      frame.nz() - 1);
  };
  return {level(low), level(high)};
}

const std::vector<std::string_view>& planner_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> all;
    for (const Entry& entry : kPlanners) all.push_back(entry.name);
    return all;
  }();
  return names;
}

std::unique_ptr<Planner> make_planner(std::string_view name, const PlannerOptions& options) {
  std::string known;
  for (const Entry& entry : kPlanners) {
    if (entry.name == name) {
      std::unique_ptr<Planner> planner = entry.make(name, options);
      if (!options.refine) return planner;
      return std::make_unique<RefinedPlanner>(std::move(planner), options.weights);
    }
    known += (known.empty() ? "" : ", ") + std::string(entry.name);
  }
  check::fail("planner", "'" + std::string(name) + "'", ("one of " + known).c_str());
}

}  // namespace ltp
