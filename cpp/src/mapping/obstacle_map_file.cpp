// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The obstacle map's way to disk and back, by OctoMap's files.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "ltp/geometry/check.hpp"
#include "ltp/grid/octree_file.hpp"
#include "ltp/mapping/obstacle_map.hpp"

namespace ltp {
namespace {

/// A file states its resolution with six digits.
constexpr double kResolutionTolerance = 1e-5;

/// The voxels of the window in a leaf: [low, high), empty where the leaf lies outside.
struct Box {
  Cell low;
  Cell high;
};

Box voxels_in(const OctreeLeaf& leaf, const GridFrame& frame, double resolution) {
  const Point corner = leaf.centre - Point::Constant(0.5 * leaf.size);
  Box box;
  for (int axis = 0; axis < 3; ++axis) {
    // In doubles until clipped: a file may reach far beyond the window.
    const double low = std::round((corner[axis] - frame.origin()[axis]) / frame.cell()[axis]);
    const double high = low + std::round(leaf.size / resolution);
    box.low[axis] = static_cast<int>(std::clamp<double>(low, 0, frame.dims()[axis]));
    box.high[axis] = static_cast<int>(std::clamp<double>(high, 0, frame.dims()[axis]));
  }
  return box;
}

}  // namespace

void ObstacleMap::save(const std::string& path) const {
  const GridFrame& frame = voxels_.frame();
  OctreeLeaves octree;
  octree.resolution = voxel_size();
  for (int x = 0; x < frame.nx(); ++x) {
    for (int y = 0; y < frame.ny(); ++y) {
      for (int z = 0; z < frame.nz(); ++z) {
        const Cell voxel(x, y, z);
        double log_odds = voxels_.blocked(voxel) ? one_hit() : 0.0;
        if (carver_) log_odds = carver_->log_odds(voxel);
        if (log_odds != 0.0)
          octree.leaves.push_back({frame.centre(voxel), octree.resolution, log_odds});
      }
    }
  }
  write_octree(path, octree);
}

void ObstacleMap::load(const std::string& path) {
  const OctreeLeaves octree = read_octree(path);
  if (!(std::abs(octree.resolution - voxel_size()) <= kResolutionTolerance * voxel_size())) {
    std::ostringstream expected;
    expected << "the map's voxel size, " << voxel_size() << " m";
    check::fail("octree file '" + path + "': resolution", octree.resolution,
                expected.str().c_str());
  }
  // From here on nothing throws.
  bool changed = false;
  for (const OctreeLeaf& leaf : octree.leaves) {
    const bool occupied = leaf.occupied();
    // OctoMap takes log-odds of 0 for occupied, carving for unknown.
    const double log_odds = occupied && leaf.log_odds <= 0.0 ? one_hit() : leaf.log_odds;
    if (!occupied && !carver_) continue;
    const Box box = voxels_in(leaf, voxels_.frame(), octree.resolution);
    for (int x = box.low.x(); x < box.high.x(); ++x) {
      for (int y = box.low.y(); y < box.high.y(); ++y) {
        for (int z = box.low.z(); z < box.high.z(); ++z) {
          const Cell voxel(x, y, z);
          if (carver_) {
            const double known = carver_->log_odds(voxel);
            if (occupied) carver_->set_log_odds(voxel, std::max(known, log_odds));
            if (!occupied && known == 0.0) carver_->set_log_odds(voxel, log_odds);
          }
          if (occupied && !voxels_.blocked(voxel)) {
            voxels_.set(voxel);
            changed |= occupy_cell_of(voxel);
          }
        }
      }
    }
  }
  if (changed) ++version_;
}

}  // namespace ltp
