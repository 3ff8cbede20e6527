// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// ARA* on the linearised penalty: a path soon, a better one as long as there is time.
#pragma once

#include <memory>

#include "ltp/planning/planner.hpp"

namespace ltp {

struct AraOptions {
  double first_weight = 3.0;  ///< of the heuristic in the first round, 1 to 100
  double step = 0.5;          ///< by which it falls from round to round, to 1; >= 0.01

  void check() const;  ///< throws `std::invalid_argument` that names the field
};

/// Likhachev, Gordon, Thrun, NIPS 2003, over the additive cost at the first guess of `additive`;
/// its least value bounds Eq. (5) as there. Of the rounds' paths the one with the smallest penalty
/// is the answer: a budget that ends after the first round leaves a path and a bound, before that
/// `OutOfBudget`.
/// @param alpha  the factor of a metre; 0: from the weights
std::unique_ptr<Planner> make_ara_star(const PlannerInfo& info, const PenaltyWeights& weights,
                                       const AraOptions& options, double alpha);

}  // namespace ltp
