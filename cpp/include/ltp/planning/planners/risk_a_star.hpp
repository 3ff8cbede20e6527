// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// riskA*: the path of least risk over the ground, risk being what priority lacks.
#pragma once

#include <memory>

#include "ltp/planning/planner.hpp"

namespace ltp {

struct RiskOptions {
  double length_factor = 0.1;  ///< what a metre costs beside its risk (0 to 1 a metre), > 0

  void check() const;  ///< throws `std::invalid_argument` that names the field
};

/// Primatesta, Guglieri, Rizzo, "A risk-aware path planning strategy for UAVs in urban
/// environments", J. Intell. Robot. Syst. 95 (2019): A* whose edges cost the risk integrated along
/// them. Their risk map is our priority map turned round: a path costs the integral of (1 - p +
/// `length_factor`) dl. The second part is the time in the air, without which a path over the best
/// ground would cost nothing however long it is. The weights of Eq. (5) play no part in the search.
/// Where a priority exceeds 1, the largest one takes the place of 1, so that no risk is negative.
std::unique_ptr<Planner> make_risk_a_star(const PlannerInfo& info, const PenaltyWeights& weights,
                                          const RiskOptions& options);

}  // namespace ltp
