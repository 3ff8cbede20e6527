// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `Carver`: log-odds of being occupied, voxel by voxel, learnt from where rays ended and what they
// passed.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "ltp/geometry/points_view.hpp"
#include "ltp/geometry/types.hpp"
#include "ltp/grid/frame.hpp"
#include "ltp/grid/occupancy_grid.hpp"
#include "ltp/mapping/obstacle_map_options.hpp"
#include "ltp/mapping/own_returns.hpp"

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

  /// A hit of the next scan, nearer than `hit_range`.
  void mark(const Cell& voxel) { hit_.set(voxel); }

  /// Takes in one scan, whose hits are marked: all finite points but own returns tell what their
  /// rays passed.
  /// `changed(voxel, occupied)` is called, after the grid was updated, for each voxel of `occupied`
  /// that changed: first for those that a hit made occupied, then for those that rays freed.
  template <typename Changed>
  void insert(const Point& origin, const OwnReturns& own, const PointsView& hits,
              const PointsView& misses, OccupancyGrid& occupied, Changed&& changed) {
    follow(origin, own, hits);
    follow(origin, own, misses);
    for_each_word(origin, [&](int ix, int iy, int w) {
      followed_.column(ix, iy)[w] = 0;
      std::uint64_t& hit = hit_.column(ix, iy)[w];
      std::uint64_t& here = occupied.column(ix, iy)[w];
      passed_.column(ix, iy)[w] &= ~(options_.keep_hits ? hit | here : hit);
      for (; hit != 0; hit &= hit - 1) {
        const Cell voxel(ix, iy, 64 * w + __builtin_ctzll(hit));
        const std::uint64_t bit = hit & -hit;
        if (vote(voxel, true) && (here & bit) == 0) {
          here |= bit;
          changed(voxel, true);
        }
      }
    });
    for_each_word(origin, [&](int ix, int iy, int w) {
      std::uint64_t& passed = passed_.column(ix, iy)[w];
      std::uint64_t& here = occupied.column(ix, iy)[w];
      for (; passed != 0; passed &= passed - 1) {
        const Cell voxel(ix, iy, 64 * w + __builtin_ctzll(passed));
        const std::uint64_t bit = passed & -passed;
        if (!vote(voxel, false) && (here & bit) != 0) {
          here &= ~bit;
          changed(voxel, false);
        }
      }
    });
  }

  /// 0 where nothing is known.
  float log_odds(const Cell& voxel) const { return log_odds_[frame_.index(voxel)]; }
  /// Clamped to the options' limits.
  void set_log_odds(const Cell& voxel, double value);

  void roll(const Cell& shift);
  void clear();

 private:
  /// Follows the rays to all ends but own returns and those in whose voxel another one ended.
  void follow(const Point& origin, const OwnReturns& own, const PointsView& ends);
  /// Follows a ray, given in lattice units, that is not all inside.
  void follow_outside(const Point& from, const Point& to);
  /// A hit or a passing ray changes a voxel's log-odds; returns whether it is occupied now.
  bool vote(const Cell& voxel, bool hit) {
    float& log_odds = log_odds_[frame_.index(voxel)];
    if (hit) {
      const float before = options_.keep_hits ? std::max(log_odds, 0.0f) : log_odds;
      log_odds = std::min(before + hit_log_odds_, max_log_odds_);
    } else {
      log_odds = std::max(log_odds + miss_log_odds_, min_log_odds_);
    }
    return log_odds > 0.0f;
  }

  /// Calls `visit(ix, iy, w)` for all words of columns that the rays of a scan can reach.
  template <typename Visitor>
  void for_each_word(const Point& origin, Visitor&& visit) const {
    const auto column = [&](int axis, double sign) {
      const double from_low = origin[axis] + sign * options_.max_range - frame_.origin()[axis];
      const double reached = std::floor(from_low / frame_.cell()[axis]) + sign;
      return static_cast<int>(std::clamp<double>(reached, 0, frame_.dims()[axis] - 1));
    };
    for (int ix = column(0, -1.0); ix <= column(0, 1.0); ++ix) {
      for (int iy = column(1, -1.0); iy <= column(1, 1.0); ++iy) {
        for (int w = 0; w < hit_.words_per_column(); ++w) visit(ix, iy, w);
      }
    }
  }

  GridFrame frame_;
  ObstacleMapOptions options_;
  // As floats.
  float hit_log_odds_, miss_log_odds_, min_log_odds_, max_log_odds_;
  std::vector<float> log_odds_;  ///< [index in frame_]
  // What one scan says; empty between scans, so they need not roll.
  OccupancyGrid hit_;
  OccupancyGrid passed_;
  OccupancyGrid followed_;  ///< voxels in which a ray ended
};

}  // namespace ltp
