// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `HeightSurface`: the exact surface of a height raster, flat tops and vertical walls.
#pragma once

#include <optional>
#include <vector>

#include "ltp/grid/occupancy_grid.hpp"
#include "ltp/grid/raster.hpp"
#include "ltp/sensing/surface.hpp"

namespace ltp {

namespace sensing {
struct GroundTrack;
struct TrackPosition;
}  // namespace sensing

/// Each cell of the raster is a solid column from below everything up to its height. Outside the
/// raster there is nothing. Any attitude: cells are skipped by hierarchical maxima; a level fan:
/// one sweep of the horizon. Queries are exact, allocate nothing and may run in several threads.
class HeightSurface final : public Surface {
 public:
  explicit HeightSurface(Raster heights);  ///< heights above the datum [m]

  const Raster& heights() const { return heights_; }

  RayHit cast(const Point& origin, const Point& direction, double max_range) const override;
  /// All beams of a fan share a ground track, so one that is blocked blocks every lower one: a
  /// single walk over the cells moves the lowest free beam up. Cells plus beams, not cells times
  /// beams.
  void cast_fans(const Point& origin, const std::vector<Eigen::Vector2d>& headings,
                 const BeamFan& fan, double max_range, RayHits& hits) const override;
  /// Rays that look the same way meet the same columns: where a ray can hit first is looked up in
  /// a picture of the surroundings, and only there it is walked, cell by cell.
  void cast_bundle(const Point& origin, const Eigen::Matrix3d& turn, const PathRef& directions,
                   double max_range, RayHits& hits) const override;

  /// Arc length [m] at which a path first touches the solid, exactly along its segments (a closed
  /// solid: grazing a top or a wall touches it); empty if it never does. A path of one point is
  /// tested as that point. Throws for coordinates that are not finite.
  std::optional<double> first_collision(const PathRef& path) const override;

  /// Distance [m] from a point to the solid, 0 inside it, at most `max_distance`. Throws for values
  /// that are not finite or a negative distance.
  double clearance(const Point& point, double max_distance) const override;

  /// The cells of `frame` that hold any of the solid: what a perfect and complete sensor would map.
  /// A cell whose lower face lies in a top holds none of it. Overlaps below 0.1 um do not count.
  OccupancyGrid occupancy(const GridFrame& frame) const;

 private:
  /// One level of the pyramid of maxima; level k has blocks of 2^k x 2^k cells.
  struct Level {
    std::size_t offset = 0;  ///< of its first value in `maxima_`
    int nx = 0;
    int ny = 0;
  };

  int top() const { return static_cast<int>(levels_.size()) - 1; }
  /// The values of a level, row by row; level 0 is the raster itself.
  const double* values(int level) const {
    return level == 0 ? heights_.values().data() : maxima_.data() + levels_[level].offset;
  }
  /// The rest of a ray's walk, which begins among the blocks of a level.
  RayHit walk(const Point& origin, const Point& direction, double max_range,
              const sensing::GroundTrack& track, const sensing::TrackPosition& from,
              int level) const;
  /// Where a ray hits the column of the cell where it is, and which it would leave at `t_out`.
  RayHit column_hit(const Point& origin, const Point& direction, double max_range,
                    const sensing::TrackPosition& at, double t_out) const;
  /// Squared distance [m^2] from a point to the solid below a block, or `nearest` if that is less.
  double squared_clearance(const Point& point, int level, int bi, int bj, double nearest) const;
  /// Squared distance [m^2] from a point to the box that bounds the solid of a block.
  double squared_distance(const Point& point, int level, int bi, int bj) const;

  Raster heights_;
  std::vector<Level> levels_;   ///< the last one is a single block
  std::vector<double> maxima_;  ///< levels 1 and up
};

}  // namespace ltp
