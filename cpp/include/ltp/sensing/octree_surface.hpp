// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `OctreeSurface`: the occupied voxels of an octree as something that a ray can hit.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ltp/grid/occupancy_grid.hpp"
#include "ltp/grid/octree_file.hpp"
#include "ltp/sensing/surface.hpp"

namespace ltp {

/// The occupied leaves of an octree, kept as bricks of 8 x 8 x 8 bits below a hierarchy of empty
/// boxes, which rays pass in one step. Leaves of any size are one word each, and empty space costs
/// next to nothing: the bounding box may have any size. Rays are walked exactly (OctoMap's
/// `castRay` also reports voxels that the ray only touches). Queries allocate nothing and may run
/// in several threads; copies share the voxels. Every constructor throws `std::invalid_argument` if
/// the box has 2^62 voxels or more, or if the voxels lie so scattered that they would take more
/// than 1 GiB.
class OctreeSurface final : public Surface {
 public:
  explicit OctreeSurface(const OctreeLeaves& octree);
  /// Reads a `.bt` or `.ot` file; errors name the file.
  explicit OctreeSurface(const std::string& path);
  /// Voxels of edge `resolution` [m] that hold the given points, shape (N, 3).
  OctreeSurface(const PathRef& points, double resolution);

  double resolution() const;    ///< edge of a voxel [m]
  std::int64_t size() const;    ///< occupied voxels
  std::int64_t memory() const;  ///< of bricks and hierarchy [bytes]
  /// A dense grid over the voxels' bounding box, made when it is first asked for. Throws
  /// `std::invalid_argument` if the box has 2^31 voxels or more.
  const OccupancyGrid& voxels() const;

  RayHit cast(const Point& origin, const Point& direction, double max_range) const override;
  void cast_fans(const Point& origin, const std::vector<Eigen::Vector2d>& headings,
                 const BeamFan& fan, double max_range, RayHits& hits) const override;
  /// Rays go side by side, as many as the processor has room for.
  void cast_bundle(const Point& origin, const Eigen::Matrix3d& turn, const PathRef& directions,
                   double max_range, RayHits& hits) const override;
  /// Voxels are half open: the cell of a point is `voxels().frame().cell_of`.
  std::optional<double> first_collision(const PathRef& path) const override;
  double clearance(const Point& point, double max_distance) const override;

 private:
  struct Parts;

  RayHit cast_from_afar(const Point& origin, const Point& direction, double max_range) const;
  template <typename DirectionOf>
  void cast_all(const Point& origin, std::int64_t count, double max_range,
                const DirectionOf& direction_of, RayHits& hits) const;

  std::shared_ptr<Parts> parts_;
};

}  // namespace ltp
