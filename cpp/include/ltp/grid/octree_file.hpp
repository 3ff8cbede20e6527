// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// OctoMap's files: occupied and free voxels in and out.
#pragma once

#include <string>
#include <vector>

#include "ltp/geometry/types.hpp"
#include "ltp/grid/octree.hpp"

namespace ltp {

/// One leaf of an octree: a cube.
struct OctreeLeaf {
  Point centre = Point::Zero();  ///< world [m]
  double size = 0.0;             ///< edge [m]; the resolution times a power of two
  double log_odds = 0.0;         ///< of being occupied

  bool occupied() const { return log_odds >= 0.0; }  ///< OctoMap's rule: 0 is occupied
};

struct OctreeLeaves {
  double resolution = 0.0;  ///< edge of the smallest voxel [m]
  std::vector<OctreeLeaf> leaves;
};

/// Reads a `.bt` or `.ot` file (which of them, its first line says; OctoMap's types OcTree,
/// ColorOcTree and OcTreeStamped). OctoMap's own reader recurses without limit on a hostile file,
/// so this one walks the bytes itself, bounded by the tree's 16 levels, and counts before it
/// allocates. Leaves of a `.bt` get OctoMap's clamped log-odds, 3.5 or -2. Throws
/// `std::invalid_argument` that names the file and what is wrong with it.
OctreeLeaves read_octree(const std::string& path);

/// Writes `.bt` or `.ot` by the path's extension, pruned: first to a temporary file beside it, then
/// renamed. Leaves must be voxels of the resolution; of two for one voxel the later one counts.
/// Throws `std::invalid_argument` that names the file for another extension or a leaf that OctoMap
/// cannot hold, `std::runtime_error` that names the file if it cannot be written.
void write_octree(const std::string& path, const OctreeLeaves& octree);
/// The same of a whole tree.
void write_octree(const std::string& path, const Octree& octree);

}  // namespace ltp
