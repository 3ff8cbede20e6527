// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// OctoMap's files: occupied and free voxels in and out. The one place that knows OctoMap.
#pragma once

#include <string>
#include <vector>

#include "ltp/geometry/types.hpp"

namespace ltp {

/// One leaf of an octree: a cube.
struct OctreeLeaf {
  Point centre = Point::Zero();  ///< world [m]
  double size = 0.0;             ///< edge [m]; the resolution times a power of two
  double log_odds = 0.0;         ///< of being occupied; > 0: occupied
};

struct OctreeLeaves {
  double resolution = 0.0;  ///< edge of the smallest voxel [m]
  std::vector<OctreeLeaf> leaves;
};

/// Reads a `.bt` or `.ot` file. Everything is checked before OctoMap sees it (its own reader
/// recurses without limit on a hostile file). Throws `std::invalid_argument` that names the file
/// and what is wrong with it.
OctreeLeaves read_octree(const std::string& path);

/// Writes `.bt` or `.ot` by the path's extension: first to a temporary file beside it, then
/// renamed. Leaves must have the size of the resolution. Throws `std::invalid_argument` for another
/// extension, `std::runtime_error` that names the file if it cannot be written.
void write_octree(const std::string& path, const OctreeLeaves& octree);

}  // namespace ltp
