// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Budgets for searches that are tested by themselves.
#pragma once

#include <cstdint>
#include <functional>

#include "ltp/planning/budget.hpp"

namespace ltp::test {

/// `*Limit(100)` is a fresh budget of so many expansions, for one call; 0: without a limit.
class Limit {
 public:
  explicit Limit(std::int64_t most = 0, const std::function<bool()>& interrupted = nullptr)
      : watch_(Budget{most, 0.0, interrupted}) {}
  BudgetWatch& operator*() { return watch_; }

 private:
  BudgetWatch watch_;
};

}  // namespace ltp::test
