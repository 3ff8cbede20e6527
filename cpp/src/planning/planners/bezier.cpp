// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/planners/bezier.hpp"

#include <algorithm>
#include <limits>

#include "ltp/geometry/check.hpp"
#include "planning/search/curve_planner.hpp"

namespace ltp {
namespace planning {
namespace {

constexpr int kAskAfterPieces = 1 << 14;

/// The i-th of `count` offsets spread evenly over [-reach, reach]; the middle one is 0.
double offset(int i, int count, double reach) {
  return count > 1 ? reach * (2.0 * i / (count - 1) - 1.0) : 0.0;
}

class BezierPlanner final : public CurvePlanner {
 public:
  BezierPlanner(const PlannerInfo& info, const PenaltyWeights& weights,
                const BezierOptions& options)
      : CurvePlanner(info, weights, options.segments, &bernstein), options_(options) {}

 private:
  /// Eq. (6): the weights of P1 and P2, and that of P3.
  static Eigen::RowVector3d bernstein(double s) {
    const double r = 1.0 - s;
    return {3.0 * r * r * s, 3.0 * r * s * s, s * s * s};
  }

  void search(const Problem& problem, Answer& answer) override {
    // Eq. (3) has no price for a loop back to where the UAV is: it stays there.
    const bool moves = problem.direct_length > 0.0;
    const int offsets = moves ? options_.offsets : 1;
    const int z_offsets = moves ? options_.z_offsets : 1;
    // Curves are dear: the caller is asked after so many pieces of them.
    const std::int64_t ask_every = std::max(1, kAskAfterPieces / options_.segments);
    const Point direct = problem.query.goal - problem.query.start;
    const Point side = sideways(direct);
    double best = std::numeric_limits<double>::infinity();
    Path path;
    for (int k = 0; k < z_offsets; ++k) {
      const Point up(0.0, 0.0, offset(k, z_offsets, options_.z_reach));
      for (int i = 0; i < offsets; ++i) {
        const Point first = direct / 3.0 + offset(i, offsets, options_.reach) * side + up;
        for (int j = 0; j < offsets; ++j) {
          if (answer.budget.spent(answer.stats.expanded, ask_every)) {
            return answer.end(PlanStatus::OutOfBudget);
          }
          ++answer.stats.expanded;
          const Point second =
              direct * (2.0 / 3.0) + offset(j, offsets, options_.reach) * side + up;
          const Path& curve = draw(problem.query, first, second);
          const double cost = penalty(problem, curve);  // Eq. (7)
          if (cost >= best || !clear(problem, curve)) continue;
          best = cost;
          path = curve;
        }
      }
    }
    if (path.rows() > 0) answer.offer(std::move(path));
  }

  BezierOptions options_;
};

}  // namespace
}  // namespace planning

void BezierOptions::check() const {
  check::odd("bezier.offsets", offsets);
  check::odd("bezier.z_offsets", z_offsets);
  check::positive("bezier.reach", reach);
  check::not_negative("bezier.z_reach", z_reach);
  check::between("bezier.segments", segments, planning::kLeastSegments, planning::kMostSegments);
}

std::unique_ptr<Planner> make_bezier(const PlannerInfo& info, const PenaltyWeights& weights,
                                     const BezierOptions& options) {
  options.check();
  return std::make_unique<planning::BezierPlanner>(info, weights, options);
}

}  // namespace ltp
