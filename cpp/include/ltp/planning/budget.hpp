// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `Budget`: what a call of `plan` may spend; `BudgetWatch`: whether it has.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <limits>

namespace ltp {

/// The limits of one call. A search that reaches one ends with `OutOfBudget`, or with the best path
/// that it has.
struct Budget {
  std::int64_t max_expansions = 0;  ///< cells, curves or labels examined; 0: no limit
  double time_limit = 0.0;          ///< wall time [s]; 0: no limit
  /// Asked now and then, like the clock; `true` ends the search.
  std::function<bool()> interrupted = nullptr;

  /// Throws `std::invalid_argument` for a limit that is negative or not finite.
  void check() const;
};

/// Wall time since it was made; read outside of the searches' loops only.
class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// Watches over a budget from the moment that it is made. A search that was told to stop once is
/// told so ever after.
class BudgetWatch {
 public:
  /// Throws as `Budget::check` does.
  explicit BudgetWatch(const Budget& budget);

  /// Whether a search must stop that has expanded so many.
  /// @param every  after so many expansions the clock is read and the caller asked
  bool spent(std::int64_t expanded, std::int64_t every = kEvery) {
    if (expanded >= limit_) return true;
    const auto done = static_cast<std::uint64_t>(expanded);
    const auto period = static_cast<std::uint64_t>(every);
    return done % period == period - 1 && must_stop();
  }
  /// The same where many cells are expanded at once, `before` of them when it was last asked.
  bool spent_since(std::int64_t before, std::int64_t expanded) {
    if (expanded >= limit_) return true;
    return before / kEvery != expanded / kEvery && must_stop();
  }
  /// The same, the clock read and the caller asked at once.
  bool spent_now(std::int64_t expanded) { return expanded >= limit_ || must_stop(); }

  /// Whether a search has been told to stop already.
  bool is_spent(std::int64_t expanded) const { return stopped_ || expanded >= limit_; }

  /// No more than there may be.
  std::int64_t capped(std::int64_t expanded) const { return std::min(limit_, expanded); }
  /// From now on no more than `most` expansions in all, nor more than the budget allows.
  void allow(std::int64_t most) { limit_ = std::min(budget_limit_, most); }
  /// What another planner may spend that is asked at the very beginning; it must not outlive this.
  Budget rest() {
    return {budget_.max_expansions, 0.0, [this] { return must_stop(); }};
  }

 private:
  static constexpr std::int64_t kEvery = 1024;

  bool must_stop();

  Budget budget_;
  Stopwatch since_;
  std::int64_t budget_limit_ = std::numeric_limits<std::int64_t>::max();
  std::int64_t limit_;
  bool stopped_ = false;
};

}  // namespace ltp
