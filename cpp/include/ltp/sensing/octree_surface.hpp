// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `OctreeSurface`: the occupied voxels of an OctoMap octree as something that a ray can hit.
#pragma once

#include <memory>
#include <string>

#include "ltp/sensing/surface.hpp"

namespace ltp {

/// A copy of an octree's occupied leaves; OctoMap itself stays out of this header.
class OctreeSurface final : public Surface {
 public:
  /// Reads a `.bt` or `.ot` file. Throws `std::invalid_argument` that names the file for anything
  /// malformed.
  explicit OctreeSurface(const std::string& path);
  /// Voxels of edge `resolution` [m] that hold the given points, shape (N, 3).
  OctreeSurface(const PathRef& points, double resolution);
  ~OctreeSurface() override;

  double resolution() const;  ///< edge of the smallest voxel [m]
  std::int64_t size() const;  ///< occupied leaves
  RayHit cast(const Point& origin, const Point& direction, double max_range) const override;

 private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

}  // namespace ltp
