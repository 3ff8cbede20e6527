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

/// Each cell of the raster is a solid column from below everything up to its height. Outside the
/// raster there is nothing. Any attitude: cells are skipped by hierarchical maxima; a level fan:
/// one sweep of the horizon.
class HeightSurface final : public Surface {
 public:
  explicit HeightSurface(Raster heights);  ///< heights above the datum [m]

  const Raster& heights() const { return heights_; }

  RayHit cast(const Point& origin, const Point& direction, double max_range) const override;
  void cast_fan(const Point& origin, const Eigen::Vector2d& heading,
                const std::vector<double>& elevations, double max_range,
                std::vector<RayHit>& hits) const override;

  /// Arc length [m] at which a path first touches the solid, exactly along its segments (a closed
  /// solid: grazing a top or a wall touches it); empty if it never does.
  std::optional<double> first_collision(const PathRef& path) const;

  /// Distance [m] from a point to the solid, 0 inside it, at most `max_distance`.
  double clearance(const Point& point, double max_distance) const;

  /// The cells of `frame` that hold any of the solid: what a perfect and complete sensor would map.
  OccupancyGrid occupancy(const GridFrame& frame) const;

 private:
  Raster heights_;
  std::vector<Raster::Values> maxima_;  ///< level k: maxima over blocks of 2^k x 2^k cells
};

}  // namespace ltp
