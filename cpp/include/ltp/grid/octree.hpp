// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `Octree`: log-odds, voxel by voxel, wherever something is known. The one door to OctoMap.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <optional>

#include "ltp/grid/frame.hpp"

namespace ltp {

/// Voxels are counted from the world's origin: voxel (0, 0, 0) covers [0, resolution) along each
/// axis. A voxel is occupied if its log-odds are >= 0, OctoMap's rule. Cubes of voxels that are
/// alike are kept as one leaf. Only what is new allocates.
class Octree {
 public:
  /// Voxels lie in [-kReach, kReach) along each axis.
  static constexpr int kReach = 1 << 15;
  static constexpr int kLevels = 16;  ///< the whole is a cube of 2^kLevels voxels

  /// @param resolution  edge of a voxel [m], positive
  explicit Octree(double resolution);
  Octree(const Octree& other);  ///< all of it: as costly as it is large
  Octree(Octree&&) noexcept;
  Octree& operator=(Octree other) noexcept;
  ~Octree();

  static bool holds(const Cell& voxel) {
    return (voxel.array() >= -kReach).all() && (voxel.array() < kReach).all();
  }

  double resolution() const;  ///< [m]
  std::optional<float> find(const Cell& voxel) const;
  /// The voxel must be held, the log-odds finite.
  void set(const Cell& voxel, float log_odds);
  /// Adds a cube of 2^level voxels whose lowest corner is at a multiple of its edge: what is
  /// unknown there takes its log-odds, and if it is occupied, what has lower ones does, too.
  void merge(const Cell& low, int level, float log_odds);
  void clear();

  /// Calls `visit(low, high, log_odds)` for the part in [low, high), not empty, of each leaf;
  /// with `occupied_only` of occupied ones. Allocates nothing.
  template <typename Visitor>
  void for_each(const Cell& low, const Cell& high, bool occupied_only, Visitor&& visit) const {
    const auto call = [](void* visitor, const Cell& from, const Cell& to, float log_odds) {
      (*static_cast<std::remove_reference_t<Visitor>*>(visitor))(from, to, log_odds);
    };
    walk(low, high, occupied_only, call, &visit);
  }

  std::int64_t nodes() const;  ///< inner ones and leaves
  std::int64_t bytes() const;  ///< that they take, roughly

  /// OctoMap's file, header and all: `.bt` if `binary` (occupied or free), else `.ot`.
  void write(std::ostream& stream, bool binary) const;

 private:
  class Tree;
  using Call = void (*)(void* visitor, const Cell& low, const Cell& high, float log_odds);

  void walk(const Cell& low, const Cell& high, bool occupied_only, Call call, void* visitor) const;

  std::unique_ptr<Tree> tree_;
};

}  // namespace ltp
