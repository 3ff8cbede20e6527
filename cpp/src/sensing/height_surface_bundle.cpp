// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `HeightSurface`: many rays from one point, by a picture of what can be seen from there.
#include <algorithm>

#include "column_hit.hpp"
#include "ground_track.hpp"
#include "ltp/sensing/height_surface.hpp"
#include "panorama.hpp"

namespace ltp {
namespace {

using sensing::GroundTrack;
using sensing::Panorama;
using sensing::TrackAxis;
using sensing::TrackPosition;
using sensing::TrackStart;

constexpr Eigen::Index kFewest = 1000;  // rays for which a picture pays

/// Columns of each side, for so many rays; measured.
int columns_for(Eigen::Index rays) { return rays < 16384 ? 32 : 64; }

}  // namespace

void HeightSurface::cast_bundle(const Point& origin, const Eigen::Matrix3d& turn,
                                const PathRef& directions, double max_range, RayHits& hits) const {
  if (directions.rows() < kFewest || !Panorama::can_look_from(heights_, origin)) {
    return Surface::cast_bundle(origin, turn, directions, max_range, hits);
  }
  static thread_local Panorama panorama;  // reused from bundle to bundle
  static thread_local Panorama::Rays rays;
  panorama.look(heights_, origin, max_range, columns_for(directions.rows()));

  const TrackStart start_x(heights_, origin, 0);
  const TrackStart start_y(heights_, origin, 1);
  for (Eigen::Index first = 0; first < directions.rows(); first += Panorama::Rays::kMost) {
    const int count = static_cast<int>(
        std::min<Eigen::Index>(directions.rows() - first, Panorama::Rays::kMost));
    for (int n = 0; n < count; ++n) {
      const Point direction = turned(turn, directions.row(first + n));
      rays.x[n] = direction.x();
      rays.y[n] = direction.y();
      rays.z[n] = direction.z();
    }
    const int near = panorama.glance(rays, count);
    for (int found = 0; found < near; ++found) {
      const int n = rays.near[found];
      const Point direction(rays.x[n], rays.y[n], rays.z[n]);
      const TrackAxis x(start_x, direction.x());
      const TrackAxis y(start_y, direction.y());
      const RayHit hit = walk_cells(origin, direction, max_range, x, y, rays.slab[found]);
      if (hit.hit()) hits.add(first + n, hit.range, hit.inside);
    }
  }
}

RayHit HeightSurface::walk_cells(const Point& origin, const Point& direction, double max_range,
                                 const TrackAxis& x, const TrackAxis& y, int slab) const {
  // As the walk would enter the slab, after all that it passed before.
  const bool along_x = std::abs(direction.x()) >= std::abs(direction.y());
  TrackPosition at{x.cell_after(0.0), y.cell_after(0.0), 0.0, -1};
  if (slab > 0) {
    const TrackAxis& ahead = along_x ? x : y;
    const TrackAxis& aside = along_x ? y : x;
    int& cell_ahead = along_x ? at.i : at.j;
    int& cell_aside = along_x ? at.j : at.i;
    cell_ahead += ahead.step * slab;
    at.t = ahead.time(ahead.step > 0 ? cell_ahead : cell_ahead + 1);
    if (at.t >= aside.leave() || at.t >= max_range) return RayHit();
    cell_aside = aside.cell_after(at.t);
    at.face = y.enters(at.j, at.t) ? 1 : 0;
  }

  constexpr int kPatience = 16;  // cells; a ray that has passed so many may pass many more
  auto& [i, j, t_in, face] = at;
  const double rise = direction.z();
  double t_x = x.leave(i);
  double t_y = y.leave(j);
  for (int n = 0; n < kPatience; ++n) {
    const double t_out = std::min({t_x, t_y, max_range});
    const double height = heights_.values()(i, j);
    if (origin.z() + (rise < 0.0 ? t_out : t_in) * rise < height) {
      return column_hit(origin, direction, max_range, at, t_out);
    }
    if (t_out >= max_range) return RayHit();
    const bool cross_x = t_x <= t_out;
    const bool cross_y = t_y <= t_out;
    if (cross_x) {
      i += x.step;
      t_x = x.leave(i);
    }
    if (cross_y) {
      j += y.step;
      t_y = y.leave(j);
    }
    if (!heights_.contains(i, j)) return RayHit();
    t_in = t_out;
    face = cross_y ? 1 : 0;
  }
  return walk(origin, direction, max_range, GroundTrack(x, y), at, 1);
}

}  // namespace ltp
