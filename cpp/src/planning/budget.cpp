// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/budget.hpp"

#include "ltp/geometry/check.hpp"

namespace ltp {

void Budget::check() const {
  if (max_expansions < 0) check::fail("max_expansions", max_expansions, "a number >= 0");
  check::not_negative("time_limit", time_limit);
}

BudgetWatch::BudgetWatch(const Budget& budget) : budget_(budget) {
  budget.check();
  if (budget.max_expansions > 0) budget_limit_ = budget.max_expansions;
  limit_ = budget_limit_;
}

bool BudgetWatch::must_stop() {
  stopped_ = stopped_ || (budget_.interrupted && budget_.interrupted()) ||
             (budget_.time_limit > 0.0 && since_.seconds() >= budget_.time_limit);
  return stopped_;
}

}  // namespace ltp
