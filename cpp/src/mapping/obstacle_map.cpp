// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/mapping/obstacle_map.hpp"

#include <algorithm>

#include "ltp/geometry/check.hpp"
#include "ltp/grid/cell_finder.hpp"

namespace ltp {
namespace {

const ObstacleMapOptions& checked(const ObstacleMapOptions& options) {
  options.check();
  return options;
}

/// The window of planning cells round a centre. Anchored at the world's origin, so that the windows
/// of two maps share one lattice.
GridFrame planning_frame(const ObstacleMapOptions& options, const Point& centre) {
  check::finite("centre", centre);
  const GridFrame at_origin(Point::Zero(), options.cell, options.dims);
  return at_origin.shifted(at_origin.shift_to_centre(centre));
}

Cell scaled(const Cell& cells, const std::array<int, 3>& ratio) {
  return Cell(cells.x() * ratio[0], cells.y() * ratio[1], cells.z() * ratio[2]);
}

/// The same window in voxels.
GridFrame voxel_frame(const ObstacleMapOptions& options, const Point& centre) {
  const std::array<int, 3> ratio = options.voxels_per_cell();
  const GridFrame at_origin(
      Point::Zero(), Point::Constant(options.cell.minCoeff()),
      {options.dims[0] * ratio[0], options.dims[1] * ratio[1], options.dims[2] * ratio[2]});
  at_origin.shift_to_centre(centre);  // throws where voxel coordinates would overflow
  const GridFrame cells(Point::Zero(), options.cell, options.dims);
  return at_origin.shifted(scaled(cells.shift_to_centre(centre), ratio));
}

void check_sensor(const Pose& sensor) {
  check::finite("origin", sensor.position);
  check::finite("sensor", sensor);
}

/// Points that are not finite.
std::int64_t count_invalid(const PointsView& points) {
  if (points.stride() == 3 && points.scalar() == PointsView::Scalar::Double) {
    // Times zero, all that is finite vanishes, and nothing else does.
    const Eigen::Map<const Eigen::ArrayXd> numbers(points.data<double>(), 3 * points.rows());
    if ((numbers * 0.0).sum() == 0.0) return 0;
  }
  std::int64_t count = 0;
  for (Eigen::Index i = 0; i < points.rows(); ++i) count += !points[i].allFinite();
  return count;
}

}  // namespace

ObstacleMap::ObstacleMap(const ObstacleMapOptions& options, const Point& centre)
    : options_(checked(options)),
      ratio_(options.voxels_per_cell()),
      occupied_(planning_frame(options, centre)),
      blocked_(occupied_.frame()),
      voxels_(voxel_frame(options, centre)),
      inflation_(occupied_.frame(), options.inflation_radius) {
  if (options.carve_free_space) carver_.emplace(voxels_.frame(), options);
}

InsertStatistics ObstacleMap::insert(const Pose& sensor, const PointsView& hits,
                                     const PointsView& misses) {
  check_sensor(sensor);
  const Point& origin = sensor.position;
  const OwnReturns own(options_, sensor);
  InsertStatistics statistics;
  const double range = Carver::hit_range(options_);
  using Verdict = OwnReturns::Verdict;
  const auto mark = [&](const Cell& voxel) {
    ++statistics.marked;
    if (carver_) return carver_->mark(voxel);
    if (voxels_.blocked(voxel)) return;
    voxels_.set(voxel);
    statistics.new_cells += occupy_cell_of(voxel);
  };
  CellFinder(voxels_.frame(), {origin, own.reach(), range})
      .for_each(
          hits, [&](Eigen::Index, const Cell& voxel) { mark(voxel); },
          [&](Eigen::Index i) {
            const Point hit = hits[i];
            const Point offset = hit - origin;
            if (!(offset.squaredNorm() < range * range)) {  // NaN comes here, too
              ++(hit.allFinite() ? statistics.out_of_range : statistics.invalid);
            } else if (const Verdict verdict = own(offset); verdict != Verdict::Obstacle) {
              ++(verdict == Verdict::TooNear ? statistics.too_near : statistics.in_body);
            } else if (const std::optional<Cell> voxel = voxels_.frame().find(hit)) {
              mark(*voxel);
            } else {
              ++statistics.outside;
            }
          });
  statistics.invalid += count_invalid(misses);
  if (carver_) carve(origin, own, hits, misses, statistics);
  if (statistics.new_cells > 0 || statistics.erased_cells > 0) ++version_;
  totals_ += statistics;
  return statistics;
}

void ObstacleMap::carve(const Point& origin, const OwnReturns& own, const PointsView& hits,
                        const PointsView& misses, InsertStatistics& statistics) {
  Cell erased_low(occupied_.frame().nx(), occupied_.frame().ny(), occupied_.frame().nz());
  Cell erased_high = Cell::Zero();
  carver_->insert(origin, own, hits, misses, voxels_, [&](const Cell& voxel, bool occupied) {
    if (occupied) {
      statistics.new_cells += occupy_cell_of(voxel);
    } else if (const Cell cell = cell_of_voxel(voxel); !any_voxel_in(cell)) {
      occupied_.set(cell, false);
      ++statistics.erased_cells;
      erased_low = erased_low.cwiseMin(cell);
      erased_high = erased_high.cwiseMax(Cell(cell.array() + 1));
    }
  });
  if (statistics.erased_cells > 0) {
    inflation_.repair(occupied_, erased_low - inflation_.reach(), erased_high + inflation_.reach(),
                      blocked_);
  }
}

InsertStatistics ObstacleMap::sense(const Pose& sensor, const PointsView& hits,
                                    const PointsView& misses, const Leaving& leaving) {
  check_sensor(sensor);
  recentre(sensor.position, leaving);
  return insert(sensor, hits, misses);
}

Cell ObstacleMap::recentre(const Point& centre, const Leaving& leaving) {
  check::finite("centre", centre);
  voxels_.frame().shift_to_centre(centre);  // throws where voxel coordinates would overflow
  const Cell shift = occupied_.frame().shift_to_centre(centre);
  if (shift.isZero()) return shift;
  if (leaving) leaving(occupied_);
  const Cell voxel_shift = scaled(shift, ratio_);
  voxels_.roll(voxel_shift);  // first: it is the one that can throw
  occupied_.roll(shift);
  inflation_.roll(occupied_, shift, blocked_);
  if (carver_) carver_->roll(voxel_shift);
  return shift;
}

void ObstacleMap::clear() {
  if (occupied_.count() > 0) ++version_;
  occupied_.clear();
  blocked_.clear();
  voxels_.clear();
  if (carver_) carver_->clear();
}

double ObstacleMap::log_odds_at(const Point& point) const {
  const Cell voxel = voxels_.frame().cell_of(point);
  if (!voxels_.frame().contains(voxel)) return 0.0;
  if (carver_) return carver_->log_odds(voxel);
  return voxels_.blocked(voxel) ? one_hit() : 0.0;
}

double ObstacleMap::one_hit() const {
  return std::min(options_.hit_log_odds, options_.max_log_odds);
}

Cell ObstacleMap::cell_of_voxel(const Cell& voxel) const {
  return Cell(voxel.x() / ratio_[0], voxel.y() / ratio_[1], voxel.z() / ratio_[2]);
}

bool ObstacleMap::any_voxel_in(const Cell& cell) const {
  const Cell low = scaled(cell, ratio_);
  for (int x = low.x(); x < low.x() + ratio_[0]; ++x) {
    for (int y = low.y(); y < low.y() + ratio_[1]; ++y) {
      for (int z = low.z(); z < low.z() + ratio_[2]; ++z) {
        if (voxels_.blocked(Cell(x, y, z))) return true;
      }
    }
  }
  return false;
}

bool ObstacleMap::occupy_cell_of(const Cell& voxel) {
  const Cell cell = cell_of_voxel(voxel);
  if (occupied_.blocked(cell)) return false;
  occupied_.set(cell);
  inflation_.add(cell, blocked_);
  return true;
}

}  // namespace ltp
