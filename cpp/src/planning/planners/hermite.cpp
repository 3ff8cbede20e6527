// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/planners/hermite.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "ltp/geometry/check.hpp"
#include "planning/search/curve_planner.hpp"

namespace ltp {
namespace planning {
namespace {

constexpr int kAskAfterPieces = 1 << 12;
constexpr double kGain = 1e-9;            // of Eq. (5); less is rounding
constexpr double kFirstStep = 0.5;        // of the tangents ahead and up [direct lengths]
constexpr double kLeastStep = 1.0 / 256;  // of the first one: curves then differ by centimetres

/// What one poll of a round changes: one coordinate, or both ends at once into a bulge.
struct Move {
  int first;
  int second;  ///< moved the other way; -1: none
};
constexpr Move kMoves[] = {{0, -1}, {3, -1}, {1, -1}, {4, -1}, {1, 4}, {2, -1}, {5, -1}, {2, 5}};
constexpr int kPlanarMoves = 5;  // the others climb

/// In direct lengths: ahead, to the left and up, at the start and at the goal.
using Tangents = std::array<double, 6>;

struct Curve {
  Tangents tangents{};
  int blocked = 0;  ///< pieces that touch an obstacle or leave the window
  double penalty = 0.0;

  /// By more than rounding, so that equals stay what they are.
  bool better_than(const Curve& other) const {
    if (blocked != other.blocked) return blocked < other.blocked;
    return penalty < other.penalty - kGain;
  }
};

class HermitePlanner final : public CurvePlanner {
 public:
  HermitePlanner(const PlannerInfo& info, const PenaltyWeights& weights,
                 const HermiteOptions& options)
      : CurvePlanner(info, weights, options.segments, &hermite), options_(options) {}

 private:
  class Search;

  /// h10, h11, h01; h00 is what is missing from 1.
  static Eigen::RowVector3d hermite(double s) {
    const double r = 1.0 - s;
    return {s * r * r, -s * s * r, s * s * (3.0 - 2.0 * s)};
  }

  const Path& draw_tangents(const Query& query, const Tangents& tangents) {
    const Point direct = query.goal - query.start;
    const double length = direct.norm();
    const Point side = sideways(direct);
    const auto tangent = [&](const double* t) -> Point {
      return t[0] * direct + length * (t[1] * side + t[2] * Point::UnitZ().eval());
    };
    return draw(query, tangent(tangents.data()), tangent(tangents.data() + 3));
  }

  void search(const Problem& problem, Answer& answer) override;

  HermiteOptions options_;
};

/// One query's curves: judges them, counts them, keeps the best free one.
class HermitePlanner::Search {
 public:
  Search(HermitePlanner& planner, const Problem& problem, Answer& answer)
      : planner_(planner),
        options_(planner.options_),
        problem_(problem),
        answer_(answer),
        ask_every_(std::max(1, kAskAfterPieces / planner.options_.segments)) {}

  /// The best free curve's tangents, if there is one.
  std::optional<Tangents> run() {
    std::vector<Curve> curves = lattice();
    std::stable_sort(curves.begin(), curves.end(), [](const Curve& a, const Curve& b) {
      return std::make_pair(a.blocked, a.penalty) < std::make_pair(b.blocked, b.penalty);
    });
    const std::size_t refined = options_.refined;
    if (problem_.direct_length > 0.0) {
      if (curves.size() > refined) curves.resize(refined);
      for (const Curve& curve : curves) improve(curve);
    }
    if (!found_) return std::nullopt;
    return best_.tangents;
  }

  bool stopped() const { return stopped_; }

 private:
  const Path& drawn(const Tangents& tangents) {
    return planner_.draw_tangents(problem_.query, tangents);
  }

  /// The straight line, then all pairs of sideways tangents.
  std::vector<Curve> lattice() {
    // Eq. (3) has no price for a loop back to where the UAV is: it stays there.
    const int half = problem_.direct_length > 0.0 ? options_.starts / 2 : 0;
    std::vector<Curve> curves = {judge({1, 0, 0, 1, 0, 0}, nullptr)};
    for (int i = -half; i <= half; ++i) {
      for (int j = -half; j <= half && !stopped_; ++j) {
        if (i == 0 && j == 0) continue;
        const double unit = options_.reach / half;
        curves.push_back(judge({1, unit * i, 0, 1, unit * j, 0}, nullptr));
      }
    }
    return curves;
  }

  /// Hooke and Jeeves' search from one curve.
  void improve(Curve curve) {
    const int moves =
        problem_.levels.count() == 1 ? kPlanarMoves : static_cast<int>(std::size(kMoves));
    const double sideways_step = options_.reach / std::max(2, options_.starts - 1);
    double scale = 1.0;
    for (int round = 0; round < options_.iterations && scale >= kLeastStep; ++round) {
      bool moved = false;
      for (int i = 0; i < moves; ++i) {
        const Move& move = kMoves[i];
        const double step = scale * (move.first % 3 == 1 ? sideways_step : kFirstStep);
        for (const double way : {step, -step}) {
          Tangents tangents = curve.tangents;
          tangents[move.first] += way;
          if (move.second >= 0) tangents[move.second] -= way;
          const Curve next = judge(tangents, &curve);
          if (stopped_) return;
          if (!next.better_than(curve)) continue;
          curve = next;
          moved = true;
          break;
        }
      }
      if (!moved) scale *= 0.5;
    }
  }

  /// Tallies and tests a curve. Given a free `rival`, a curve that is worse for certain is not
  /// tested to the end.
  Curve judge(const Tangents& tangents, const Curve* rival) {
    Curve curve{tangents};
    stopped_ = stopped_ || answer_.budget.spent(answer_.stats.expanded, ask_every_);
    if (stopped_) return curve;
    ++answer_.stats.expanded;
    const Path& points = drawn(tangents);
    curve.penalty = penalty(problem_, points);
    const bool only_free = rival != nullptr && rival->blocked == 0;
    if (only_free && !curve.better_than(*rival)) return curve;
    curve.blocked = blocked_pieces(points, only_free);
    if (curve.blocked == 0 && (!found_ || curve.better_than(best_))) {
      best_ = curve;
      found_ = true;
    }
    return curve;
  }

  /// How many pieces are blocked; 1 for any number where that is enough.
  int blocked_pieces(const Path& points, bool any_is_enough) const {
    if (clear(problem_, points)) return 0;
    if (any_is_enough) return 1;
    int count = 0;
    for (Eigen::Index i = 0; i + 1 < points.rows(); ++i) {
      count += !clear(problem_, points.middleRows(i, 2));
    }
    return count;
  }

  HermitePlanner& planner_;
  const HermiteOptions& options_;
  const Problem& problem_;
  Answer& answer_;
  std::int64_t ask_every_;
  Curve best_;  ///< if `found_`
  bool found_ = false;
  bool stopped_ = false;
};

void HermitePlanner::search(const Problem& problem, Answer& answer) {
  Search search(*this, problem, answer);
  const std::optional<Tangents> best = search.run();
  if (search.stopped()) {
    answer.end(PlanStatus::OutOfBudget);
  } else if (best) {
    answer.offer(draw_tangents(problem.query, *best));
  }
}

}  // namespace
}  // namespace planning

void HermiteOptions::check() const {
  check::between("hermite.segments", segments, planning::kLeastSegments, planning::kMostSegments);
  check::odd("hermite.starts", starts);
  if (!(reach > 0.0 && reach <= 1000.0)) {
    check::fail("hermite.reach", reach, "a number over 0, at most 1000");
  }
  check::at_least("hermite.refined", refined, 1);
  check::at_least("hermite.iterations", iterations, 0);
}

std::unique_ptr<Planner> make_hermite(const PlannerInfo& info, const PenaltyWeights& weights,
                                      const HermiteOptions& options) {
  options.check();
  return std::make_unique<planning::HermitePlanner>(info, weights, options);
}

}  // namespace ltp
