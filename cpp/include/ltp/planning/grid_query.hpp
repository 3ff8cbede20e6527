// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// What every grid planner does before and after its search: resolve the query, check and tally the
// path.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "ltp/planning/planner.hpp"
#include "ltp/planning/stopwatch.hpp"

namespace ltp {

/// A query on the cells of a grid.
struct GridQuery {
  Cell start;
  Cell goal;
  LevelRange levels;
  double direct_length = 0.0;  ///< L_direct [m]
};

/// Throws `std::invalid_argument` for a point that is not finite or a band below zero.
void check_query(const Query& query);

/// The query's cells; or the status that answers it without a search: `OutsideMap`, `GoalBlocked`,
/// `StartBlocked` (in this order: a blocked goal is a proof even where the start is blocked too).
struct ResolvedQuery {
  std::optional<PlanStatus> refused;
  GridQuery cells;
};
ResolvedQuery resolve(const Scene& scene, const Query& query);

/// The frame of every planner's `plan`: resolves the query, lets `search(const GridQuery&, Plan&)`
/// answer it unless that is answered already, and takes the time.
template <typename Search>
Plan answer(const Scene& scene, const Query& query, Search&& search) {
  const Stopwatch watch;
  Plan plan;
  const ResolvedQuery resolved = resolve(scene, query);
  if (resolved.refused) {
    plan.status = *resolved.refused;
  } else {
    search(resolved.cells, plan);
  }
  plan.stats.seconds = watch.seconds();
  return plan;
}

/// Makes `plan` a `Found` one: stores the path, tallies it, evaluates Eq. (5). The path is first
/// checked by an exact walk that shares nothing with the searches: throws `std::logic_error` if it
/// touches a blocked cell, leaves the window or its levels, or does not lead from start to goal.
void accept(const Scene& scene, const Query& query, const GridQuery& cells,
            const PenaltyWeights& weights, Path path, Plan& plan);

/// The polyline through the centres of a chain of cells, with its ends moved to the query's start
/// and goal.
Path path_through(const GridFrame& frame, const Query& query, const std::vector<Cell>& chain);

/// The same for the polyline through a chain of cells.
void accept(const Scene& scene, const Query& query, const GridQuery& cells,
            const PenaltyWeights& weights, const std::vector<Cell>& chain, Plan& plan);

/// The priority under each column of a grid: the raster's value at the column's centre, which is
/// exact where the raster's cells are the grid's columns.
class ColumnPriority {
 public:
  /// Reads `raster` as long as it is used; keeps its memory from query to query.
  void reset(const GridFrame& frame, const Raster& raster);
  double operator()(int ix, int iy) const { return (*raster_)(rows_[ix], columns_[iy]); }

 private:
  const Raster* raster_ = nullptr;
  std::vector<int> rows_;
  std::vector<int> columns_;
};

/// Counts expansions and says when a search must end early.
class Budget {
 public:
  Budget(std::int64_t limit, const std::function<bool()>& interrupted)
      : limit_(limit), interrupted_(interrupted) {}
  /// Whether the search, having expanded so many cells, must stop.
  bool spent(std::int64_t expanded) const {
    if (limit_ > 0 && expanded >= limit_) return true;
    return interrupted_ && (expanded & kAskEvery) == kAskEvery && interrupted_();
  }
  /// The same where many cells are expanded at once, `before` of them when it was last asked.
  bool spent_since(std::int64_t before, std::int64_t expanded) const {
    if (limit_ > 0 && expanded >= limit_) return true;
    return interrupted_ && before / (kAskEvery + 1) != expanded / (kAskEvery + 1) && interrupted_();
  }
  /// No more than there may be.
  std::int64_t capped(std::int64_t expanded) const {
    return limit_ > 0 ? std::min(limit_, expanded) : expanded;
  }

 private:
  static constexpr std::int64_t kAskEvery = (1 << 10) - 1;
  std::int64_t limit_;
  const std::function<bool()>& interrupted_;
};

}  // namespace ltp
