// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `Carver`: log-odds of being occupied, voxel by voxel, learnt from where rays ended and what they
// passed.
#pragma once

#include <cstdint>
#include <vector>

#include "ltp/geometry/types.hpp"
#include "ltp/grid/frame.hpp"
#include "ltp/grid/occupancy_grid.hpp"
#include "ltp/mapping/obstacle_map_options.hpp"

namespace ltp {

/// A voxel gets at most one vote per scan, and a hit wins over rays that pass. Rays that end in the
/// same voxel are followed once, exactly (no sampling), up to but without the voxel in which they
/// end. A voxel is occupied if its log-odds are positive. With `keep_hits` they never fall again,
/// and a first hit outweighs all that passed before. Allocates only when it is made.
class Carver {
 public:
  Carver(const GridFrame& voxels, const ObstacleMapOptions& options);

  /// A hit nearer than this is one [m]: a return at the maximum range, give or take rounding, is
  /// none.
  static double hit_range(const ObstacleMapOptions& options) {
    return options.max_range * (1.0 - 1e-9);
  }

  /// Takes in one scan: `hits` within the maximum range mark their voxels, all other finite points
  /// only tell what their rays passed. `changed(voxel, occupied)` is called, after the grid was
  /// updated, for each voxel of `occupied` that changed: first for those that a hit made occupied,
  /// then for those that rays freed.
  template <typename Changed>
  void insert(const Point& origin, const PathRef& hits, const PathRef& misses,
              OccupancyGrid& occupied, Changed&& changed) {
    cast_votes(origin, hits, misses);
    for_each_vote(hit_, [&](const Cell& voxel) {
      if (update(voxel, true) && !occupied.blocked(voxel)) {
        occupied.set(voxel);
        changed(voxel, true);
      }
    });
    for_each_vote(passed_, [&](const Cell& voxel) {
      if (!update(voxel, false) && occupied.blocked(voxel)) {
        occupied.set(voxel, false);
        changed(voxel, false);
      }
    });
    hit_.clear();
    passed_.clear();
    followed_.clear();
  }

  /// 0 where nothing is known.
  float log_odds(const Cell& voxel) const { return log_odds_[frame_.index(voxel)]; }
  /// Clamped to the options' limits.
  void set_log_odds(const Cell& voxel, double value);

  void roll(const Cell& shift);
  void clear();

 private:
  void cast_votes(const Point& origin, const PathRef& hits, const PathRef& misses);
  void follow(const Point& origin, const Point& end, const Cell& last);
  bool update(const Cell& voxel, bool hit);  ///< whether the voxel is occupied now

  template <typename Visitor>
  static void for_each_vote(const OccupancyGrid& votes, Visitor&& visit) {
    const GridFrame& frame = votes.frame();
    for (int ix = 0; ix < frame.nx(); ++ix) {
      for (int iy = 0; iy < frame.ny(); ++iy) {
        for (int w = 0; w < votes.words_per_column(); ++w) {
          for (std::uint64_t bits = votes.column(ix, iy)[w]; bits != 0; bits &= bits - 1) {
            visit(Cell(ix, iy, 64 * w + __builtin_ctzll(bits)));
          }
        }
      }
    }
  }

  GridFrame frame_;
  ObstacleMapOptions options_;
  std::vector<float> log_odds_;  ///< [index in frame_]
  // What one scan says; empty between scans, so they need not roll.
  OccupancyGrid hit_;
  OccupancyGrid passed_;
  OccupancyGrid
      followed_;  ///< voxels in which a ray without a hit ended, or the first ray that hit
};

}  // namespace ltp
