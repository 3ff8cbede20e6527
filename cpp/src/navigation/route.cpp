// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "navigation/route.hpp"

#include <algorithm>

#include "ltp/geometry/polyline.hpp"
#include "ltp/grid/lattice.hpp"

namespace ltp {
namespace {

constexpr int kMargin = 2;  ///< cells between a stopover and the window's faces
constexpr int kLooks = 32;  ///< lines of sight that are tried
constexpr int kNeverFlood = 0;
constexpr std::size_t kGlance = 1024;  ///< columns of a UAV's court, some 20 us

/// The window without its outermost cells; of a window that is small, without fewer.
GridFrame inner(const GridFrame& window) {
  Cell margin;
  for (int axis = 0; axis < 3; ++axis) {
    const int most = axis == 2 ? 0 : kMargin;
    margin[axis] = std::min(most, (window.dims()[axis] - 1) / 4);
  }
  return on_lattice_of(window, window.first() + margin, dims_of(window) - 2 * margin);
}

/// The last point in a frame of the straight way from one in it to another, to half a cell.
Point last_inside(const GridFrame& frame, const Point& from, const Point& to) {
  const int count =
      static_cast<int>(std::min(1e6, 2.0 * (to - from).norm() / frame.cell().minCoeff())) + 1;
  int low = 0;
  int high = count;  // a box is convex
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    const Point point = from + (to - from) * (static_cast<double>(middle) / count);
    (frame.contains(point) ? low : high) = middle;
  }
  return from + (to - from) * (static_cast<double>(low) / count);
}

}  // namespace

Route::Route() : search_(kNeverFlood) {}

PlanStatus Route::find(const OccupancyGrid& known, const Query& query,
                       const std::function<bool()>& interrupted) {
  path_.resize(0, 3);
  length_ = 0.0;
  // No priority, in a raster that is plainly one with the columns.
  const GridFrame& frame = known.frame();
  const Raster nothing(Raster::Values::Zero(1, 1), frame.origin().head<2>(), frame.cell().x());
  const Problem problem({known, nothing}, query, {});
  if (const std::optional<PlanStatus> refused = problem.refused()) return *refused;
  if (problem.within_a_cell()) {
    path_ = path_through(problem, {});
  } else if (flood_.parts(known, problem.start, problem.goal, problem.levels, kGlance)) {
    return PlanStatus::Unreachable;  // the search begins at the other end
  } else {
    BudgetWatch budget(Budget{0, 0.0, interrupted});
    SearchStats stats;
    const PlanStatus status = search_.run(problem, budget, stats);
    if (status != PlanStatus::Found) return status;
    path_ = path_through(problem, search_.chain());
  }
  length_ = ltp::length(path_);
  return PlanStatus::Found;
}

/// The first vertex that is too near to a face of the window or beyond it; their number if none is.
Eigen::Index Route::first_outside(const GridFrame& window) const {
  const GridFrame frame = inner(window);
  Eigen::Index i = 1;
  while (i < path_.rows() && frame.contains(Point(path_.row(i).transpose()))) ++i;
  return i;
}

bool Route::stays_in(const GridFrame& window) const {
  for (Eigen::Index i = 0; i < path_.rows(); ++i) {
    if (!window.contains(Point(path_.row(i).transpose()))) return false;
  }
  return true;
}

Point Route::stopover(const OccupancyGrid& known, const GridFrame& window) const {
  const Eigen::Index exit = first_outside(window);
  const Eigen::Index last = path_.rows() - 1;
  Path line(2, 3);
  line.row(0) = path_.row(0);
  for (int look = 0; look < kLooks; ++look) {
    const Eigen::Index to = last - (last - exit) * look / kLooks;
    line.row(1) = path_.row(to);
    if (known.first_blocked(line)) continue;
    return last_inside(inner(window), line.row(0).transpose(), line.row(1).transpose());
  }
  return path_.row(std::max<Eigen::Index>(exit - 1, 1)).transpose();
}

Path Route::beginning(const GridFrame& window) const {
  return path_.topRows(std::max<Eigen::Index>(first_outside(window), 2));
}

}  // namespace ltp
