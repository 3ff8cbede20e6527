// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/grid_query.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "ltp/geometry/check.hpp"

namespace ltp {
namespace {

[[noreturn]] void broken(const std::string& what) {
  throw std::logic_error("ltp: a planner returned a path that " + what + " (please report this)");
}

void verify(const Scene& scene, const Query& query, const LevelRange& levels, const PathRef& path) {
  const GridFrame& frame = scene.occupancy.frame();
  if (path.rows() < 2 || path.row(0) != query.start.transpose() ||
      path.row(path.rows() - 1) != query.goal.transpose()) {
    broken("does not lead from start to goal");
  }
  for (Eigen::Index i = 0; i < path.rows(); ++i) {
    const Cell cell = frame.cell_of(path.row(i).transpose());
    if (!frame.contains(cell)) broken("leaves the window");
    if (cell.z() < levels.lowest || cell.z() > levels.highest) broken("leaves its levels");
  }
  if (scene.occupancy.first_blocked(path)) broken("touches a blocked cell");
}

}  // namespace

void check_query(const Query& query) {
  check::finite("start", query.start);
  check::finite("goal", query.goal);
  // An infinite band is open to the whole window.
  if (!(query.band.below >= 0.0)) check::fail("band.below", query.band.below, "a number >= 0");
  if (!(query.band.above >= 0.0)) check::fail("band.above", query.band.above, "a number >= 0");
}

ResolvedQuery resolve(const Scene& scene, const Query& query) {
  check_query(query);
  const GridFrame& frame = scene.occupancy.frame();
  ResolvedQuery resolved;
  resolved.cells = {frame.cell_of(query.start), frame.cell_of(query.goal), levels_of(frame, query),
                    (query.goal - query.start).norm()};
  if (!frame.contains(resolved.cells.start) || !frame.contains(resolved.cells.goal)) {
    resolved.refused = PlanStatus::OutsideMap;
  } else if (scene.occupancy.blocked(resolved.cells.goal)) {
    resolved.refused = PlanStatus::GoalBlocked;
  } else if (scene.occupancy.blocked(resolved.cells.start)) {
    resolved.refused = PlanStatus::StartBlocked;
  }
  return resolved;
}

void accept(const Scene& scene, const Query& query, const GridQuery& cells,
            const PenaltyWeights& weights, Path path, Plan& plan) {
  verify(scene, query, cells.levels, path);
  plan.status = PlanStatus::Found;
  plan.path = std::move(path);
  plan.tally = tally(plan.path, scene.priority);
  plan.penalty = Penalty(weights, cells.direct_length)(
      plan.tally, scene.priority.at(query.goal.x(), query.goal.y()));
}

void accept(const Scene& scene, const Query& query, const GridQuery& cells,
            const PenaltyWeights& weights, const std::vector<Cell>& chain, Plan& plan) {
  accept(scene, query, cells, weights, path_through(scene.occupancy.frame(), query, chain), plan);
}

Path path_through(const GridFrame& frame, const Query& query, const std::vector<Cell>& chain) {
  const auto size = static_cast<Eigen::Index>(chain.size());
  Path path(std::max<Eigen::Index>(size, 2), 3);
  for (Eigen::Index i = 1; i + 1 < size; ++i) path.row(i) = frame.centre(chain[i]).transpose();
  path.row(0) = query.start.transpose();
  path.row(path.rows() - 1) = query.goal.transpose();
  return path;
}

void ColumnPriority::reset(const GridFrame& frame, const Raster& raster) {
  raster_ = &raster;
  rows_.resize(frame.nx());
  columns_.resize(frame.ny());
  for (int ix = 0; ix < frame.nx(); ++ix) {
    rows_[ix] = raster.index_of(0, frame.centre(Cell(ix, 0, 0)).x());
  }
  for (int iy = 0; iy < frame.ny(); ++iy) {
    columns_[iy] = raster.index_of(1, frame.centre(Cell(0, iy, 0)).y());
  }
}

}  // namespace ltp
