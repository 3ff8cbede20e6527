// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/mapping/mission_map.hpp"

#include <cmath>
#include <stdexcept>

namespace ltp {

MissionMap::Tile MissionMap::tile_of(const Cell& voxel) {
  Tile tile;
  for (int axis = 0; axis < 3; ++axis) {
    tile[axis] = static_cast<int>((std::int64_t{voxel[axis]} + Octree::kReach) >> Octree::kLevels);
  }
  return tile;
}

std::optional<float> MissionMap::find(const Cell& voxel) const {
  const Tile tile = tile_of(voxel);
  const auto found = tiles_.find(tile);
  if (found == tiles_.end()) return std::nullopt;
  return found->second.find(voxel - kTile * Cell(tile[0], tile[1], tile[2]));
}

void MissionMap::set(const Cell& voxel, float log_odds) {
  const Tile tile = tile_of(voxel);
  const auto octree = tiles_.try_emplace(tile, voxel_size_).first;
  octree->second.set(voxel - kTile * Cell(tile[0], tile[1], tile[2]), log_odds);
}

void MissionMap::merge(const OctreeLeaf& leaf) {
  const double edge = std::round(leaf.size / voxel_size_);
  Cell low;
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = static_cast<int>(std::round(leaf.centre[axis] / voxel_size_ - 0.5 * edge));
  }
  const auto octree = tiles_.try_emplace(Tile{0, 0, 0}, voxel_size_).first;
  octree->second.merge(low, std::ilogb(edge), static_cast<float>(leaf.log_odds));
}

std::int64_t MissionMap::nodes() const {
  std::int64_t sum = 0;
  for (const auto& [tile, octree] : tiles_) sum += octree.nodes();
  return sum;
}

std::int64_t MissionMap::bytes() const {
  std::int64_t sum = 0;
  for (const auto& [tile, octree] : tiles_) sum += octree.bytes();
  return sum;
}

void MissionMap::write(const std::string& path) const {
  for (const auto& [tile, octree] : tiles_) {
    if (tile == Tile{0, 0, 0} || octree.nodes() == 0) continue;
    throw std::invalid_argument("octree file '" + path +
                                "': the map reaches further than 32768 voxels from the origin, "
                                "which OctoMap cannot hold");
  }
  const auto middle = tiles_.find(Tile{0, 0, 0});
  write_octree(path, middle != tiles_.end() ? middle->second : Octree(voxel_size_));
}

}  // namespace ltp
