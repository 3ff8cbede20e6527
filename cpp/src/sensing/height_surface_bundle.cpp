// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `HeightSurface`: many rays from one point, by a picture of what can be seen from there.
#include <algorithm>
#include <cmath>

#include "cell_walk.hpp"
#include "ltp/sensing/height_surface.hpp"
#include "panorama.hpp"

namespace ltp {
namespace {

using sensing::GroundTrack;
using sensing::Horizon;
using sensing::Panorama;
using sensing::TrackAxis;
using sensing::TrackPosition;

constexpr Eigen::Index kFewest = 1000;  // rays for which a picture pays

constexpr int kAgain = 2;  // the level where the few go on that are not decided; measured

/// Columns of each side, for so many rays; measured.
int columns_for(Eigen::Index rays) { return rays < 16384 ? 32 : Horizon::kMostColumns; }

}  // namespace

void HeightSurface::cast_bundle(const Point& origin, const Eigen::Matrix3d& turn,
                                const PathRef& directions, double max_range, RayHits& hits) const {
  // A picture's cost goes with the cells in range, its gain with the rays.
  const double most_slabs = 4.0 * std::sqrt(static_cast<double>(directions.rows()));
  if (directions.rows() < kFewest ||
      !Horizon::can_look(heights_, origin, max_range, std::min(most_slabs, Panorama::kMostSlabs))) {
    return Surface::cast_bundle(origin, turn, directions, max_range, hits);
  }
  Panorama& panorama = Panorama::of_this_thread();
  static thread_local Panorama::Rays rays;  // both reused from bundle to bundle
  static thread_local sensing::RayEnds ends;
  const sensing::BundleStart start(heights_, origin, max_range);
  panorama.look(heights_, origin, max_range, columns_for(directions.rows()));

  for (Eigen::Index first = 0; first < directions.rows(); first += Panorama::Rays::kMost) {
    const int count =
        static_cast<int>(std::min<Eigen::Index>(directions.rows() - first, Panorama::Rays::kMost));
    for (int n = 0; n < count; ++n) {
      const Point direction = turned(turn, directions.row(first + n));
      rays.x[n] = direction.x();
      rays.y[n] = direction.y();
      rays.z[n] = direction.z();
    }
    const int found = sensing::glance_and_walk(start, panorama, rays, count, ends);
    for (int n = 0; n < found; ++n) {
      const int ray = rays.near[n];
      if (ends.range[n] == sensing::RayEnds::kUndecided) {
        const Point direction(rays.x[ray], rays.y[ray], rays.z[ray]);
        const GroundTrack track(TrackAxis(start.x, direction.x()),
                                TrackAxis(start.y, direction.y()));
        const int j = static_cast<int>(ends.y[n]);
        const TrackPosition at{static_cast<int>(ends.x[n]), j, ends.z[n],
                               track.y.enters(j, ends.z[n]) ? 1 : 0};
        const RayHit hit = walk(origin, direction, max_range, track, at, std::min(top(), kAgain));
        if (hit.hit()) hits.add(first + ray, hit.range, hit.inside);
      } else if (ends.range[n] < max_range) {
        hits.add(first + ray, ends.range[n], {ends.x[n], ends.y[n], ends.z[n]});
      }
    }
  }
}

}  // namespace ltp
