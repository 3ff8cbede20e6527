// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/mapping/obstacle_map.hpp"

#include <algorithm>
#include <utility>

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
      inflation_(occupied_.frame(), options.clearance(), options.inflated_parts()) {
  if (options.carve_free_space) carver_.emplace(voxels_.frame(), options);
  if (options.remember) mission_.emplace(voxel_size());
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
    if (mission_) mission_->set(voxel + voxels_.frame().first(), static_cast<float>(one_hit()));
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
              if (options_.keeps_hits_beyond()) remember_beyond(hit);
            }
          });
  statistics.invalid += count_invalid(misses);
  if (carver_) carve(origin, own, hits, misses, statistics);
  version_ += std::exchange(changed_, false);
  totals_ += statistics;
  return statistics;
}

void ObstacleMap::carve(const Point& origin, const OwnReturns& own, const PointsView& hits,
                        const PointsView& misses, InsertStatistics& statistics) {
  // Of the planning cells that lost a voxel.
  Cell erased_low(occupied_.frame().nx(), occupied_.frame().ny(), occupied_.frame().nz());
  Cell erased_high = Cell::Zero();
  carver_->insert(origin, own, hits, misses, voxels_, [&](const Cell& voxel, bool occupied) {
    if (occupied) {
      statistics.new_cells += occupy_cell_of(voxel);
      return;
    }
    const Cell cell = cell_of_voxel(voxel);
    const bool freed = !any_voxel_in(cell);
    if (freed) {
      occupied_.set(cell, false);
      ++statistics.erased_cells;
    }
    if (freed || !options_.inflate_whole_cells) {
      erased_low = erased_low.cwiseMin(cell);
      erased_high = erased_high.cwiseMax(Cell(cell.array() + 1));
    }
  });
  if ((erased_low.array() < erased_high.array()).all()) {
    repair({erased_low - inflation_.reach(), erased_high + inflation_.reach()});
    changed_ = true;
  }
}

InsertStatistics ObstacleMap::sense(const Pose& sensor, const PointsView& hits,
                                    const PointsView& misses) {
  check_sensor(sensor);
  recentre(sensor.position);
  return insert(sensor, hits, misses);
}

Cell ObstacleMap::recentre(const Point& centre) {
  check::finite("centre", centre);
  voxels_.frame().shift_to_centre(centre);  // throws where voxel coordinates would overflow
  const Cell shift = occupied_.frame().shift_to_centre(centre);
  if (shift.isZero()) return shift;
  roll(shift);
  return shift;
}

void ObstacleMap::clear() {
  if (occupied_.count() + blocked_.count() > 0) ++version_;
  occupied_.clear();
  blocked_.clear();
  voxels_.clear();
  if (carver_) carver_->clear();
  if (mission_) mission_->clear();
}

double ObstacleMap::log_odds_at(const Point& point) const {
  const Cell voxel = voxels_.frame().cell_of(point);
  if (!voxels_.frame().contains(voxel)) return mission_ ? remembered_at(point) : 0.0;
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
  const bool fresh = !occupied_.blocked(cell);
  if (fresh) occupied_.set(cell);
  if (options_.inflate_whole_cells) {
    if (fresh) inflation_.add(cell, blocked_);
    changed_ |= fresh;
  } else {
    changed_ |= inflation_.add(voxel, blocked_) || fresh;
  }
  return fresh;
}

}  // namespace ltp
