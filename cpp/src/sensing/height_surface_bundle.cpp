// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `HeightSurface`: many rays from one point, by a picture of what can be seen from there.
#include <algorithm>

#include "ground_track.hpp"
#include "ltp/sensing/height_surface.hpp"
#include "panorama.hpp"

namespace ltp {
namespace {

using sensing::GroundTrack;
using sensing::Panorama;
using sensing::TrackAxis;
using sensing::TrackPosition;

constexpr Eigen::Index kFewest = 1000;  // rays for which a picture pays

/// Columns of each side, for so many rays; measured.
int columns_for(Eigen::Index rays) {
  int columns = 16;
  while (columns < 128 && columns * 512 < rays) columns *= 2;
  return columns;
}

}  // namespace

void HeightSurface::cast_bundle(const Point& origin, const Eigen::Matrix3d& turn,
                                const PathRef& directions, double max_range, RayHits& hits) const {
  if (directions.rows() < kFewest || !Panorama::can_look_from(heights_, origin)) {
    return Surface::cast_bundle(origin, turn, directions, max_range, hits);
  }
  static thread_local Panorama panorama;  // reused from bundle to bundle
  panorama.look(heights_, origin, max_range, columns_for(directions.rows()));

  const double cell = heights_.cell();
  const double start_x = sensing::start_over(heights_, origin, 0);
  const double start_y = sensing::start_over(heights_, origin, 1);
  Panorama::Glance glance;
  for (Eigen::Index ray = 0; ray < directions.rows(); ++ray) {
    const Point direction = turn * directions.row(ray).transpose();
    if (!panorama.glance(direction, glance)) continue;
    const GroundTrack track(TrackAxis(start_x, direction.x(), cell, heights_.nx()),
                            TrackAxis(start_y, direction.y(), cell, heights_.ny()));
    TrackPosition from{track.x.cell_after(0.0), track.y.cell_after(0.0), 0.0, -1};
    if (glance.slab > 0) {
      // As the walk would enter the slab: after all that it passed before.
      const TrackAxis& ahead = glance.along_x ? track.x : track.y;
      const TrackAxis& aside = glance.along_x ? track.y : track.x;
      int& at_ahead = glance.along_x ? from.i : from.j;
      int& at_aside = glance.along_x ? from.j : from.i;
      at_ahead += ahead.step * glance.slab;
      from.t = ahead.time(ahead.step > 0 ? at_ahead : at_ahead + 1);
      if (from.t >= track.leave || from.t >= max_range) continue;
      at_aside = aside.cell_after(from.t);
      from.face = track.y.enters(from.j, from.t) ? 1 : 0;
    }
    const RayHit hit = walk(origin, direction, max_range, track, from, 0);
    if (hit.hit()) hits.add(ray, hit.range, hit.inside);
  }
}

}  // namespace ltp
