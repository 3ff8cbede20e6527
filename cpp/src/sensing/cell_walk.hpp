// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The end of a bundle's rays: from the slab where a panorama says that they may hit, side by side.
#pragma once

#include <array>

#include "ground_track.hpp"
#include "ltp/grid/raster.hpp"
#include "panorama.hpp"

namespace ltp::sensing {

/// What the rays of a bundle have in common.
struct BundleStart {
  BundleStart(const Raster& raster, const Point& from, double range)
      : heights(raster), origin(from), max_range(range), x(raster, from, 0), y(raster, from, 1) {}

  const Raster& heights;
  Point origin;
  double max_range;
  TrackStart x;
  TrackStart y;
};

/// Where rays end, in the order of `Panorama::Rays::near`.
struct RayEnds {
  static constexpr int kMost = Panorama::Rays::kMost + 8;  // the last ones fill up a register
  static constexpr double kUndecided = -1.0;  ///< a range: not hit within the first few cells

  alignas(64) std::array<double, kMost> range;  ///< as in `RayHit` [m]
  /// `RayHit::inside` of a hit [m]. If undecided: the cell where the ray is, and since when [m].
  alignas(64) std::array<double, kMost> x;
  alignas(64) std::array<double, kMost> y;
  alignas(64) std::array<double, kMost> z;
};

/// `Panorama::glance`, then a walk over a few cells for each ray that it found; how many.
int glance_and_walk(const BundleStart& start, const Panorama& panorama, Panorama::Rays& rays,
                    int count, RayEnds& ends);

}  // namespace ltp::sensing
