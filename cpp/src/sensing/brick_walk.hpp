// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays through bricks of voxels, side by side: which voxel each of them hits.
#pragma once

#include <array>
#include <limits>

#include "ltp/geometry/types.hpp"
#include "ltp/sensing/surface.hpp"
#include "voxel_bricks.hpp"

namespace ltp::sensing {

/// A direction with a smaller component than this runs parallel to the axis: no range that a number
/// holds would leave the voxel.
inline constexpr double kStandsStill = 1e-100;

/// What the rays of a bundle have in common.
struct BrickStart {
  BrickStart(const VoxelBricks& of, double voxel, const Point& from, double range)
      : bricks(of),
        edge(voxel),
        per_edge(1.0 / voxel),
        max_range(range),
        origin(from),
        corner(of.low().cast<double>() * voxel),
        start((from - corner) / voxel) {}

  /// Whether rounding leaves room for a walk: the origin is less than 10^12 voxels away.
  bool near() const { return (start.array().abs() < 1e12).all(); }

  const VoxelBricks& bricks;
  double edge;       ///< of a voxel [m]
  double per_edge;   ///< its inverse [1/m]
  double max_range;  ///< [m]
  Point origin;      ///< of the rays [m]
  Point corner;      ///< lowest one of the voxels' bounding box [m]
  Point start;       ///< the origin, in voxels from that corner
};

/// Some rays of a bundle, component by component, and then what each of them hits.
struct BrickRays {
  static constexpr int kMost = 1024;
  template <typename Number>
  using Each = std::array<Number, kMost + 16>;  // the last ones fill up a register

  alignas(64) Each<double> x;  ///< unit vectors
  alignas(64) Each<double> y;
  alignas(64) Each<double> z;
  alignas(64) Each<double> range;     ///< as in `RayHit` [m]
  alignas(64) Each<double> inside_x;  ///< `RayHit::inside` of a hit [m]
  alignas(64) Each<double> inside_y;
  alignas(64) Each<double> inside_z;

  RayHit hit(int ray) const {
    if (!(range[ray] < std::numeric_limits<double>::infinity())) return RayHit();
    return {range[ray], {inside_x[ray], inside_y[ray], inside_z[ray]}};
  }
};

/// The first voxel that each ray enters, nearer than the range: one that it is in for more than
/// `kWalkTie` of a voxel along its main axis. Each time at which a ray crosses a plane comes from
/// one formula that never falls as the planes go on, so boxes of any size, on any processor, lead
/// to the same voxel.
void walk_bricks(const BrickStart& start, BrickRays& rays, int count);
/// The same for a single ray, the first.
void walk_bricks_of_one(const BrickStart& start, BrickRays& rays);

}  // namespace ltp::sensing
