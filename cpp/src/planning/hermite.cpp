// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/hermite.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "ltp/planning/curve.hpp"

namespace ltp {
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

}  // namespace

bool HermitePlanner::Curve::better_than(const Curve& other) const {
  if (blocked != other.blocked) return blocked < other.blocked;
  return penalty < other.penalty - kGain;
}

/// One query's curves: judges them, counts them, keeps the best free one.
class HermitePlanner::Search {
 public:
  Search(HermitePlanner& planner, const Scene& scene, const Query& query, const GridQuery& cells,
         SearchStats& stats)
      : planner_(planner),
        options_(planner.options_),
        scene_(scene),
        query_(query),
        cells_(cells),
        stats_(stats),
        penalty_(options_.weights, cells.direct_length),
        goal_priority_(scene.priority.at(query.goal.x(), query.goal.y())),
        ask_every_(std::max(1, kAskAfterPieces / options_.hermite.segments)) {}

  /// The best free curve's tangents, if there is one.
  std::optional<Tangents> run() {
    std::vector<Curve> curves = lattice();
    std::stable_sort(curves.begin(), curves.end(), [](const Curve& a, const Curve& b) {
      return std::make_pair(a.blocked, a.penalty) < std::make_pair(b.blocked, b.penalty);
    });
    const std::size_t refined = options_.hermite.refined;
    if (cells_.direct_length > 0.0) {
      if (curves.size() > refined) curves.resize(refined);
      for (const Curve& curve : curves) improve(curve);
    }
    if (!best_) return std::nullopt;
    return best_->tangents;
  }

  bool stopped() const { return stopped_; }

 private:
  /// The straight line, then all pairs of sideways tangents.
  std::vector<Curve> lattice() {
    const HermiteOptions& options = options_.hermite;
    // Eq. (3) has no price for a loop back to where the UAV is: it stays there.
    const bool moves = cells_.direct_length > 0.0;
    const int half = moves ? options.starts / 2 : 0;
    std::vector<Curve> curves = {judge({1, 0, 0, 1, 0, 0}, nullptr)};
    for (int i = -half; i <= half; ++i) {
      for (int j = -half; j <= half && !stopped_; ++j) {
        if (i == 0 && j == 0) continue;
        const double unit = options.reach / half;
        curves.push_back(judge({1, unit * i, 0, 1, unit * j, 0}, nullptr));
      }
    }
    return curves;
  }

  /// Hooke and Jeeves' search from one curve.
  void improve(Curve curve) {
    const HermiteOptions& options = options_.hermite;
    const int moves = cells_.levels.lowest == cells_.levels.highest
                          ? kPlanarMoves
                          : static_cast<int>(std::size(kMoves));
    const double sideways_step = options.reach / std::max(2, options.starts - 1);
    double scale = 1.0;
    for (int round = 0; round < options.iterations && scale >= kLeastStep; ++round) {
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
    stopped_ = stopped_ ||
               (options_.max_expansions > 0 && stats_.expanded >= options_.max_expansions) ||
               (query_.interrupted && stats_.expanded % ask_every_ == ask_every_ - 1 &&
                query_.interrupted());
    if (stopped_) return curve;
    ++stats_.expanded;
    planner_.draw(query_, tangents);
    const Path& points = planner_.curve_;
    curve.penalty = penalty_(tally(points, scene_.priority), goal_priority_);
    const bool only_free = rival != nullptr && rival->blocked == 0;
    if (only_free && !curve.better_than(*rival)) return curve;
    curve.blocked = blocked_pieces(points, only_free);
    if (curve.blocked == 0 && (!best_ || curve.better_than(*best_))) best_ = curve;
    return curve;
  }

  /// How many pieces are blocked; 1 for any number where that is enough.
  int blocked_pieces(const Path& points, bool any_is_enough) const {
    const GridFrame& frame = scene_.occupancy.frame();
    if (inside(frame, cells_.levels, points) && !scene_.occupancy.first_blocked(points)) return 0;
    if (any_is_enough) return 1;
    int count = 0;
    for (Eigen::Index i = 0; i + 1 < points.rows(); ++i) {
      const auto piece = points.middleRows(i, 2);
      count += !inside(frame, cells_.levels, piece) || scene_.occupancy.first_blocked(piece);
    }
    return count;
  }

  HermitePlanner& planner_;
  const PlannerOptions& options_;
  const Scene& scene_;
  const Query& query_;
  const GridQuery& cells_;
  SearchStats& stats_;
  Penalty penalty_;
  double goal_priority_;
  std::int64_t ask_every_;
  std::optional<Curve> best_;
  bool stopped_ = false;
};

HermitePlanner::HermitePlanner(const PlannerOptions& options) : options_(options) {
  options.check();
  basis_.resize(options.hermite.segments + 1, 3);
  curve_.resize(options.hermite.segments + 1, 3);
  for (int i = 0; i < basis_.rows(); ++i) {
    const double s = static_cast<double>(i) / options.hermite.segments;
    const double r = 1.0 - s;
    basis_.row(i) << s * r * r, -s * s * r, s * s * (3.0 - 2.0 * s);
  }
}

void HermitePlanner::draw(const Query& query, const Tangents& tangents) {
  const Point direct = query.goal - query.start;
  const double length = direct.norm();
  const Point side = sideways(direct);
  // All relative to the start, whose weight is therefore not needed.
  Eigen::Matrix3d control;
  for (int end = 0; end < 2; ++end) {
    const double* tangent = tangents.data() + 3 * end;
    control.row(end) =
        (tangent[0] * direct + length * (tangent[1] * side + tangent[2] * Point::UnitZ().eval()))
            .transpose();
  }
  control.row(2) = direct.transpose();
  curve_.noalias() = basis_ * control;
  curve_.rowwise() += query.start.transpose();
  curve_.row(0) = query.start.transpose();
  curve_.row(curve_.rows() - 1) = query.goal.transpose();
}

Plan HermitePlanner::plan(const Scene& scene, const Query& query) {
  return answer(scene, query, [&](const GridQuery& cells, Plan& plan) {
    Search search(*this, scene, query, cells, plan.stats);
    const std::optional<Tangents> best = search.run();
    if (search.stopped()) {
      plan.status = PlanStatus::OutOfBudget;
    } else if (best) {
      draw(query, *best);
      accept(scene, query, cells, options_.weights, curve_, plan);
    }
  });
}

}  // namespace ltp
