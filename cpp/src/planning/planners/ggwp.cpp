// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/planners/ggwp.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <vector>

#include "ltp/planning/grid_planner.hpp"
#include "planning/search/bit_wave.hpp"
#include "planning/search/octile_distance.hpp"

namespace ltp {
namespace planning {
namespace {

class GgwpPlanner final : public GridPlanner {
 public:
  GgwpPlanner(const PlannerInfo& info, const PenaltyWeights& weights)
      : GridPlanner(info, weights) {}

 private:
  void search(const Problem& problem, Answer& answer) override {
    const PlanStatus status = wave_.run(problem.grid(), problem.levels, problem.goal, problem.start,
                                        answer.budget, answer.stats);
    if (status != PlanStatus::Found) return answer.end(status);
    answer.offer(descend(problem));
  }

  std::vector<Cell> descend(const Problem& problem) {
    const std::array<double, kSteps> lengths = step_lengths(problem.frame().cell());
    std::vector<Cell> chain{problem.start};
    int here = wave_.generation();
    while (chain.back() != problem.goal) {
      const Cell cell = chain.back();
      const std::uint32_t blocked = blocked_surroundings(problem.grid(), cell, problem.levels);
      double best = std::numeric_limits<double>::infinity();
      Cell next = cell;
      int gone = 0;
      for (int i = 0; i < kSteps; ++i) {
        const Step& step = steps()[i];
        if (blocked & step.box) continue;
        const Cell candidate = cell + step.offset();
        const int earlier = wave_.earlier(candidate, here);
        if (earlier == 0) continue;
        // A generation is counted when it begins, so what is left is half a one less on average.
        const double in_the_open =
            octile_distance(problem.frame().cell(), candidate - problem.goal);
        const double left = std::max(in_the_open, wave_.pace() * (here - earlier - 0.5));
        if (lengths[i] + left < best) {
          best = lengths[i] + left;
          next = candidate;
          gone = earlier;
        }
      }
      assert(gone > 0);  // the wave came from somewhere
      here -= gone;
      chain.push_back(next);
    }
    return chain;
  }

  BitWave wave_;
};

}  // namespace
}  // namespace planning

std::unique_ptr<Planner> make_ggwp(const PlannerInfo& info, const PenaltyWeights& weights) {
  return std::make_unique<planning::GgwpPlanner>(info, weights);
}

}  // namespace ltp
