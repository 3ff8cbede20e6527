// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// riskA*: the path of least risk over the ground, risk being what priority lacks.
#pragma once

#include "ltp/planning/additive_search.hpp"
#include "ltp/planning/planner.hpp"

namespace ltp {

/// Primatesta, Guglieri, Rizzo, "A risk-aware path planning strategy for UAVs in urban
/// environments", J. Intell. Robot. Syst. 95 (2019): A* whose edges cost the risk integrated along
/// them. Their risk map is our priority map turned round: a path costs the integral of (1 - p +
/// `length_factor`) dl. The second part is the time in the air, without which a path over the best
/// ground would cost nothing however long it is. The weights of Eq. (5) play no part in the search.
/// Where a priority exceeds 1, the largest one takes the place of 1, so that no risk is negative.
class RiskAStarPlanner final : public Planner {
 public:
  explicit RiskAStarPlanner(const PlannerOptions& options);

  std::string_view name() const override { return "risk-a-star"; }
  bool complete() const override { return true; }
  Plan plan(const Scene& scene, const Query& query) override;

 private:
  PlannerOptions options_;
  AdditiveSearch search_;
};

}  // namespace ltp
