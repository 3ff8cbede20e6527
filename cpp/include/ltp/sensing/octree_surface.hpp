// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `OctreeSurface`: the occupied voxels of an octree as something that a ray can hit.
#pragma once

#include <string>

#include "ltp/grid/occupancy_grid.hpp"
#include "ltp/grid/octree_file.hpp"
#include "ltp/sensing/surface.hpp"

namespace ltp {

/// The occupied leaves of an octree, cut into its smallest voxels and kept as bits over their
/// bounding box. Rays are walked exactly (OctoMap's `castRay` reports hits on voxels that the ray
/// misses). Every constructor throws `std::invalid_argument` if the box has 2^31 voxels or more.
class OctreeSurface final : public Surface {
 public:
  explicit OctreeSurface(const OctreeLeaves& octree);
  /// Reads a `.bt` or `.ot` file; errors name the file.
  explicit OctreeSurface(const std::string& path);
  /// Voxels of edge `resolution` [m] that hold the given points, shape (N, 3).
  OctreeSurface(const PathRef& points, double resolution);

  double resolution() const { return voxels_.frame().cell().x(); }  ///< edge of a voxel [m]
  std::int64_t size() const { return size_; }                       ///< occupied voxels
  const OccupancyGrid& voxels() const { return voxels_; }

  RayHit cast(const Point& origin, const Point& direction, double max_range) const override;
  /// Voxels are half open: the cell of a point is `voxels().frame().cell_of`.
  std::optional<double> first_collision(const PathRef& path) const override;
  double clearance(const Point& point, double max_distance) const override;

 private:
  OccupancyGrid voxels_;
  std::int64_t size_;
};

}  // namespace ltp
