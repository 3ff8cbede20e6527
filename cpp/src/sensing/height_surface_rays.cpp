// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `HeightSurface`: single rays by hierarchical maxima.
#include <algorithm>
#include <cmath>
#include <limits>

#include "column_hit.hpp"
#include "ground_track.hpp"
#include "ltp/sensing/height_surface.hpp"

namespace ltp {
namespace {

using sensing::GroundTrack;
using sensing::TrackAxis;
using sensing::TrackPosition;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kFirstLevel = 5;  // where a ray begins to look for blocks to skip; measured

}  // namespace

RayHit HeightSurface::cast(const Point& origin, const Point& direction, double max_range) const {
  const GroundTrack track(heights_, origin, direction.x(), direction.y());
  if (!track.crosses() || !(track.enter < max_range)) return RayHit();
  const TrackPosition from{track.x.cell_after(track.enter), track.y.cell_after(track.enter),
                           track.enter, track.axis};
  return walk(origin, direction, max_range, track, from, std::min(top(), kFirstLevel));
}

RayHit HeightSurface::column_hit(const Point& origin, const Point& direction, double max_range,
                                 const TrackPosition& at, double t_out) const {
  const double height = heights_.values()(at.i, at.j);
  const bool top_hit = origin.z() + at.t * direction.z() >= height;
  RayHit hit;
  hit.range = top_hit ? std::clamp((height - origin.z()) / direction.z(), at.t, t_out) : at.t;
  if (!(hit.range < max_range)) return RayHit();
  hit.inside = sensing::ColumnInside(heights_, at.i, at.j, height)(
      top_hit ? sensing::kTopFace : at.face, origin + hit.range * direction);
  return hit;
}

RayHit HeightSurface::walk(const Point& origin, const Point& direction, double max_range,
                           const GroundTrack& track, const TrackPosition& from, int level) const {
  const TrackAxis& x = track.x;
  const TrackAxis& y = track.y;
  const double rise = direction.z();
  const auto altitude = [&](double t) { return origin.z() + t * rise; };
  auto [i, j, t_in, face] = from;

  while (true) {
    // The block of this level round cell (i, j), and when the ray leaves it.
    const int bi = i >> level;
    const int bj = j >> level;
    const int edge_x = (x.step > 0 ? bi + 1 : bi) << level;
    const int edge_y = (y.step > 0 ? bj + 1 : bj) << level;
    const double t_x = x.step == 0 ? kInfinity : x.time(edge_x);
    const double t_y = y.step == 0 ? kInfinity : y.time(edge_y);
    const double t_out = std::min({t_x, t_y, max_range});
    const double lowest = altitude(rise < 0.0 ? t_out : t_in);
    const double height = values(level)[static_cast<std::size_t>(bi) * levels_[level].ny + bj];

    if (lowest < height) {
      if (level > 0) {
        --level;
        continue;
      }
      return column_hit(origin, direction, max_range, {i, j, t_in, face}, t_out);
    }

    t_in = t_out;
    if (t_in >= track.leave || t_in >= max_range) return RayHit();
    // Through a corner both at once.
    const bool cross_x = t_x <= t_out;
    const bool cross_y = t_y <= t_out;
    i = cross_x ? (x.step > 0 ? edge_x : edge_x - 1) : level > 0 ? x.cell_after(t_in) : i;
    j = cross_y ? (y.step > 0 ? edge_y : edge_y - 1) : level > 0 ? y.cell_after(t_in) : j;
    face = cross_y || (level > 0 && y.enters(j, t_in)) ? 1 : 0;
    // Up again only where the next larger block is left as well.
    const bool left_parent = i >> (level + 1) != bi >> 1 || j >> (level + 1) != bj >> 1;
    if (left_parent && level < top()) ++level;
  }
}

}  // namespace ltp
