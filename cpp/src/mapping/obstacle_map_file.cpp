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

}  // namespace

void ObstacleMap::save(const std::string& path) const {
  if (mission_ && !carver_) return mission_->write(path);
  MissionMap all = mission_ ? *mission_ : MissionMap(voxel_size());
  note(all_of(occupied_.frame()), all);
  all.write(path);
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
  const CellBox window = all_of(occupied_.frame());
  MissionMap only_window(voxel_size());
  MissionMap& mission = mission_ ? *mission_ : only_window;
  note(window, mission);
  for (OctreeLeaf leaf : octree.leaves) {
    const bool occupied = leaf.occupied();
    if (!occupied && !carver_) continue;
    // OctoMap takes log-odds of 0 for occupied, carving for unknown; without carving all that is
    // occupied was hit once.
    if (occupied && (!carver_ || leaf.log_odds <= 0.0)) leaf.log_odds = one_hit();
    if (carver_) {
      leaf.log_odds = std::clamp(leaf.log_odds, options_.min_log_odds, options_.max_log_odds);
    }
    leaf.centre *= voxel_size() / octree.resolution;
    leaf.size *= voxel_size() / octree.resolution;
    mission.merge(leaf);
  }
  const std::int64_t before = occupied_.count() + blocked_.count();
  restore(window, mission);
  repair(window);
  if (occupied_.count() + blocked_.count() != before) ++version_;
}

}  // namespace ltp
