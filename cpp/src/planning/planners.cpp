// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/planners.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "ltp/geometry/check.hpp"
#include "ltp/planning/planners/gated.hpp"
#include "ltp/planning/planners/ggwp.hpp"
#include "ltp/planning/planners/length_priority.hpp"
#include "planning/planners/refine.hpp"

namespace ltp {
namespace {

constexpr std::int64_t kAutoEffort = 20000;  // expansions: some milliseconds

/// One engine, three presets.
LinearisedOptions one_search(LinearisedOptions options) {
  options.searches = 1;
  return options;
}

/// What a UAV should fly: a sweep whose last searches cannot take much longer than its first.
LinearisedOptions brief(LinearisedOptions options) {
  if (options.effort == 0) options.effort = kAutoEffort;
  options.closing = 0;
  return options;
}

template <int kHeuristicWeightSquared>
std::unique_ptr<Planner> length_priority(const PlannerInfo& info, const PlannerOptions& options) {
  const double weight = std::sqrt(double{kHeuristicWeightSquared});  // W_A*
  return make_length_priority(info, options.weights, {weight, options.scaled_heuristic});
}

struct Row {
  PlannerInfo info;
  std::unique_ptr<Planner> (*make)(const PlannerInfo& info, const PlannerOptions& options);
};

constexpr auto Paper = PlannerFamily::Paper;
constexpr auto Ours = PlannerFamily::Ours;
constexpr auto Baseline = PlannerFamily::Baseline;
constexpr unsigned kExactGrid = Trait::Complete | Trait::OnGrid;
constexpr unsigned kPriority = Trait::UsesPriority;
constexpr unsigned kCertified = kExactGrid | kPriority | Trait::Bounds;
constexpr unsigned kGates = Trait::Regions | Trait::Horizon;
constexpr unsigned kLiteral = kExactGrid | kPriority | Trait::Regions;

constexpr Row kRows[] = {
    {{"lp-dijkstra", "LP-Dijkstra", Paper, kLiteral}, length_priority<0>},
    {{"lp-a-star", "LP-A*", Paper, kLiteral}, length_priority<1>},
    {{"wlp-a-star", "WLP-A* (√3)", Paper, kLiteral}, length_priority<3>},
    {{"ggwp", "GGWP", Paper, kExactGrid},
     [](const PlannerInfo& i, const PlannerOptions& o) { return make_ggwp(i, o.weights); }},
    {{"bezier", "Bézier", Paper, kPriority},
     [](const PlannerInfo& i, const PlannerOptions& o) {
       return make_bezier(i, o.weights, o.bezier);
     }},
    {{"additive", "Additive A*", Ours, kCertified | Trait::Remembers | kGates},
     [](const PlannerInfo& i, const PlannerOptions& o) {
       return make_linearised(i, o.weights, one_search(o.linearised));
     }},
    {{"sweep", "Sweep", Ours, kCertified | Trait::Remembers | Trait::Anytime | kGates},
     [](const PlannerInfo& i, const PlannerOptions& o) {
       return make_linearised(i, o.weights, o.linearised);
     }},
    {{"exact", "Exact", Ours, kCertified | kGates},
     [](const PlannerInfo& i, const PlannerOptions& o) {
       return make_exact(i, o.weights, o.exact, o.linearised);
     }},
    {{"ara-star", "ARA*", Baseline, kCertified | Trait::Anytime},
     [](const PlannerInfo& i, const PlannerOptions& o) {
       return make_ara_star(i, o.weights, o.ara, o.linearised.alpha);
     }},
    {{"risk-a-star", "riskA*", Baseline, kExactGrid | kPriority | kGates},
     [](const PlannerInfo& i, const PlannerOptions& o) {
       return make_risk_a_star(i, o.weights, o.risk);
     }},
    {{"tangent-bug", "Tangent Bug", Baseline, 0},
     [](const PlannerInfo& i, const PlannerOptions& o) {
       return make_tangent_bug(i, o.weights, o.tangent_bug);
     }},
    {{"hermite", "Hermite", Baseline, kPriority},
     [](const PlannerInfo& i, const PlannerOptions& o) {
       return make_hermite(i, o.weights, o.hermite);
     }},
    {{"auto", "Auto", Ours, kCertified | Trait::Remembers | Trait::Anytime | kGates},
     [](const PlannerInfo& i, const PlannerOptions& o) {
       return make_linearised(i, o.weights, brief(o.linearised));
     }},
};

/// Names of the release before, for one release.
constexpr std::pair<std::string_view, std::string_view> kOldNames[] = {{"pareto", "exact"},
                                                                       {"bug", "tangent-bug"}};

const Row& row_of(std::string_view name) {
  std::string_view wanted = name;
  for (const auto& [old_name, new_name] : kOldNames) {
    if (name == old_name) wanted = new_name;
  }
  std::string known;
  for (const Row& row : kRows) {
    if (row.info.name == wanted) return row;
    known += (known.empty() ? "" : ", ") + std::string(row.info.name);
  }
  check::fail("planner", "'" + std::string(name) + "'", ("one of " + known).c_str());
}

}  // namespace

void PlannerOptions::check() const {
  weights.check();
  bezier.check();
  linearised.check();
  exact.check();
  ara.check();
  risk.check();
  tangent_bug.check();
  hermite.check();
}

const std::vector<PlannerInfo>& planners() {
  static const std::vector<PlannerInfo> all = [] {
    std::vector<PlannerInfo> infos;
    for (const Row& row : kRows) infos.push_back(row.info);
    return infos;
  }();
  return all;
}

const PlannerInfo& planner_info(std::string_view name) { return row_of(name).info; }

std::unique_ptr<Planner> make_planner(std::string_view name, const PlannerOptions& options) {
  const Row& row = row_of(name);
  options.check();
  std::unique_ptr<Planner> planner = make_gated(row.make(row.info, options), options.weights);
  if (!options.refine) return planner;
  return planning::make_refined(std::move(planner), options.weights);
}

}  // namespace ltp
