// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/wavefront.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "ltp/planning/stopwatch.hpp"

namespace ltp {
namespace {

/// The shortest way between two cells without obstacles [m]: the longest steps first.
class OpenDistance {
 public:
  explicit OpenDistance(const Point& cell) : cell_(cell) {}
  double operator()(const Cell& a, const Cell& b) const {
    std::array<int, 3> steps = {std::abs(a.x() - b.x()), std::abs(a.y() - b.y()),
                                std::abs(a.z() - b.z())};
    const int all = std::min({steps[0], steps[1], steps[2]});
    for (int& left : steps) left -= all;
    double length = all * cell_.norm();
    for (int axis = 0; axis < 3; ++axis) {  // one of them is used up
      const int next = (axis + 1) % 3;
      const int both = std::min(steps[axis], steps[next]);
      length += both * std::hypot(cell_[axis], cell_[next]);
      steps[axis] -= both;
      steps[next] -= both;
    }
    for (int axis = 0; axis < 3; ++axis) length += steps[axis] * cell_[axis];
    return length;
  }

 private:
  Point cell_;
};

}  // namespace

WavefrontPlanner::WavefrontPlanner(const PlannerOptions& options) : options_(options) {
  options.check();
}

Plan WavefrontPlanner::plan(const Scene& scene, const Query& query) {
  const Stopwatch watch;
  Plan plan;
  const auto [refused, cells] = resolve(scene, query);
  plan.status = refused ? *refused
                        : wave_.run(scene.occupancy, cells.levels, cells.goal, cells.start,
                                    Budget(options_.max_expansions, query.interrupted), plan.stats);
  if (plan.status == PlanStatus::Found) {
    Path path = path_through(scene.occupancy.frame(), query, descend(scene, cells));
    accept(scene, query, cells, options_.weights, std::move(path), plan);
  }
  plan.stats.seconds = watch.seconds();
  return plan;
}

std::vector<Cell> WavefrontPlanner::descend(const Scene& scene, const GridQuery& cells) const {
  const std::array<double, kSteps> lengths = step_lengths(scene.occupancy.frame().cell());
  const OpenDistance open(scene.occupancy.frame().cell());
  std::vector<Cell> chain{cells.start};
  int here = wave_.generation();
  while (chain.back() != cells.goal) {
    const Cell cell = chain.back();
    const std::uint32_t blocked = blocked_surroundings(scene.occupancy, cell, cells.levels);
    double best = std::numeric_limits<double>::infinity();
    Cell next = cell;
    int gone = 0;
    for (int i = 0; i < kSteps; ++i) {
      const Step& step = steps()[i];
      if (blocked & step.box) continue;
      const Cell candidate = cell + Cell(step.dx, step.dy, step.dz);
      const int earlier = wave_.earlier(candidate, here);
      if (earlier == 0) continue;
      // A generation is counted when it begins, so what is left is half a one less on average.
      const double left =
          std::max(open(candidate, cells.goal), wave_.pace() * (here - earlier - 0.5));
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

}  // namespace ltp
