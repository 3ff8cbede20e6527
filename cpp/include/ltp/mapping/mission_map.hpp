// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `MissionMap`: the voxels of a whole mission, wherever the window was.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "ltp/grid/octree.hpp"
#include "ltp/grid/octree_file.hpp"

namespace ltp {

/// Log-odds by voxel, without limit of extent: octrees, side by side where one does not reach.
/// Voxels are counted from the world's origin, and are occupied if their log-odds are >= 0. Only
/// what is new allocates; asking allocates nothing. A copy is deep.
class MissionMap {
 public:
  /// @param voxel_size  edge of a voxel [m], positive
  explicit MissionMap(double voxel_size) : voxel_size_(voxel_size) {}

  double voxel_size() const { return voxel_size_; }  ///< [m]
  std::optional<float> find(const Cell& voxel) const;
  void set(const Cell& voxel, float log_odds);
  /// Adds a leaf of a file that was read by `read_octree`, whose resolution is the voxel size:
  /// where nothing is known it is believed; where it is occupied, the higher log-odds count.
  void merge(const OctreeLeaf& leaf);
  void clear() { tiles_.clear(); }

  /// Calls `visit(low, high, log_odds)` for boxes of voxels that fill what is known of [low, high);
  /// with `occupied_only` what is occupied.
  template <typename Visitor>
  void for_each(const Cell& low, const Cell& high, bool occupied_only, Visitor&& visit) const {
    for (const auto& [tile, octree] : tiles_) {
      const Cell offset = kTile * Cell(tile[0], tile[1], tile[2]);
      const auto local = [&](const Cell& end) { return Cell(in_tile(end, offset)); };
      octree.for_each(local(low), local(high), occupied_only,
                      [&](const Cell& from, const Cell& to, float log_odds) {
                        visit(Cell(from + offset), Cell(to + offset), log_odds);
                      });
    }
  }

  std::int64_t nodes() const;  ///< of the octrees
  std::int64_t bytes() const;  ///< that they take, roughly

  /// Writes `.bt` or `.ot`, as `write_octree` does and throws; also where it reaches beyond what
  /// one octree can hold.
  void write(const std::string& path) const;

 private:
  static constexpr int kTile = 2 * Octree::kReach;
  using Tile = std::array<int, 3>;

  static Tile tile_of(const Cell& voxel);
  /// A voxel counted from a tile's middle, but not far beyond its end.
  static Cell in_tile(const Cell& voxel, const Cell& offset) {
    return (voxel.cast<std::int64_t>() - offset.cast<std::int64_t>())
        .cwiseMax(-Octree::kReach)
        .cwiseMin(Octree::kReach)
        .cast<int>();
  }

  double voxel_size_;
  std::map<Tile, Octree> tiles_;  ///< the one at (0, 0, 0) is what files hold
};

}  // namespace ltp
