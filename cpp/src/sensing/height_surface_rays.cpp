// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `HeightSurface`: single rays by hierarchical maxima, fans by one sweep of the horizon.
#include <algorithm>
#include <cmath>
#include <limits>

#include "ground_track.hpp"
#include "ltp/sensing/height_surface.hpp"

namespace ltp {
namespace {

using sensing::GroundTrack;
using sensing::TrackAxis;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kFirstLevel = 5;  // where a ray begins to look for blocks to skip; measured
constexpr int kTopFace = 2;  // after 0 and 1, the walls across x and y; -1: no face, started inside

/// A point on the surface of column (i, j), moved into it through the face that was hit. It keeps a
/// margin from the other faces, so that rounding cannot put it into the neighbour.
Point inside_column(const Raster& heights, int i, int j, double height, int face,
                    const Point& point) {
  const double cell = heights.cell();
  const double low_x = heights.origin().x() + i * cell;
  const double low_y = heights.origin().y() + j * cell;
  const double depth = std::min(kHitDepth, 0.5 * cell);
  const double margin = std::min(kHitMargin, 0.25 * cell);
  const double from_x = face == 0 ? depth : margin;
  const double from_y = face == 1 ? depth : margin;
  const double from_top = face == kTopFace ? kHitDepth : kHitMargin;
  return {std::min(std::max(point.x(), low_x + from_x), low_x + cell - from_x),
          std::min(std::max(point.y(), low_y + from_y), low_y + cell - from_y),
          std::min(point.z(), height - from_top)};
}

}  // namespace

RayHit HeightSurface::cast(const Point& origin, const Point& direction, double max_range) const {
  const GroundTrack track(heights_, origin.x(), origin.y(), direction.x(), direction.y());
  RayHit hit;
  if (!track.crosses() || !(track.enter < max_range)) return hit;

  const TrackAxis& x = track.x;
  const TrackAxis& y = track.y;
  const double rise = direction.z();
  const auto altitude = [&](double t) { return origin.z() + t * rise; };
  int i = x.cell_after(track.enter);
  int j = y.cell_after(track.enter);
  int face = track.axis;
  double t_in = track.enter;
  int level = std::min(top(), kFirstLevel);

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
      const bool top_hit = altitude(t_in) >= height;
      hit.range = top_hit ? std::clamp((height - origin.z()) / rise, t_in, t_out) : t_in;
      if (!(hit.range < max_range)) return RayHit();
      hit.inside = inside_column(heights_, i, j, height, top_hit ? kTopFace : face,
                                 origin + hit.range * direction);
      return hit;
    }

    t_in = t_out;
    if (t_in >= track.leave || t_in >= max_range) return hit;
    // Through a corner both at once.
    const bool cross_x = t_x <= t_out;
    const bool cross_y = t_y <= t_out;
    i = cross_x ? (x.step > 0 ? edge_x : edge_x - 1) : level > 0 ? x.cell_after(t_in) : i;
    j = cross_y ? (y.step > 0 ? edge_y : edge_y - 1) : level > 0 ? y.cell_after(t_in) : j;
    face = cross_y ? 1 : 0;
    // Up again only where the next larger block is left as well.
    const bool left_parent = i >> (level + 1) != bi >> 1 || j >> (level + 1) != bj >> 1;
    if (left_parent && level < top()) ++level;
  }
}

void HeightSurface::cast_fan(const Point& origin, const Eigen::Vector2d& heading,
                             const BeamFan& fan, double max_range,
                             std::vector<RayHit>& hits) const {
  hits.assign(fan.size(), RayHit());
  const GroundTrack track(heights_, origin.x(), origin.y(), heading.x(), heading.y());
  if (fan.size() == 0 || !track.crosses()) return;

  // The walk goes slab by slab along the axis that the track crosses faster; within a slab it
  // passes one cell or two (three where rounding splits a corner).
  const bool along_x = std::abs(heading.x()) >= std::abs(heading.y());
  const TrackAxis along = along_x ? track.x : track.y;
  const TrackAxis across = along_x ? track.y : track.x;
  const std::ptrdiff_t ny = heights_.ny();
  const std::ptrdiff_t along_stride = along_x ? ny : 1;
  const std::ptrdiff_t across_stride = along_x ? 1 : ny;

  // Every beam below this one is settled: it has hit something, or can no longer.
  int lowest = -1;
  double slope = 0.0;
  double reach = 0.0;
  const double base = origin.z();
  const double headroom = values(top())[0] - base;  // to the highest top
  const auto next_beam = [&] {
    if (++lowest == fan.size()) return false;
    slope = fan[lowest].slope;
    reach = max_range * fan[lowest].cosine;
    if (slope > 0.0) reach = std::min(reach, headroom * fan[lowest].run * (1.0 + 1e-12));
    if (slope >= 0.0 && headroom <= 0.0) reach = 0.0;
    return true;
  };
  /// Settles the beams that a cell blocks; whether any are left.
  const auto sweep = [&](int a, int b, double t_in, double t_out, int face) {
    const int i = along_x ? a : b;
    const int j = along_x ? b : a;
    const double height = values(0)[i * ny + j];
    while (base + (slope < 0.0 ? t_out : t_in) * slope < height) {
      const BeamFan::Beam& beam = fan[lowest];
      const bool top_hit = base + t_in * slope >= height;
      const double t = top_hit ? std::min(std::max((height - base) * beam.run, t_in), t_out) : t_in;
      const double range = t * beam.stretch;
      if (range < max_range) {
        hits[lowest].range = range;
        hits[lowest].inside = inside_column(
            heights_, i, j, height, top_hit ? kTopFace : face,
            {origin.x() + t * heading.x(), origin.y() + t * heading.y(), base + t * slope});
      }
      if (!next_beam()) return false;
    }
    return true;
  };
  next_beam();

  int a = along.cell_after(track.enter);
  int b = across.cell_after(track.enter);
  int face = track.axis;
  double t_in = track.enter;
  for (;; a += along.step, face = along_x ? 0 : 1) {
    const double t_out = std::min(along.time(along.step > 0 ? a + 1 : a), track.leave);
    const int b_out = across.cell_after(t_out);
    const double* slab = values(0) + a * along_stride;
    const double higher = std::max(slab[b * across_stride], slab[b_out * across_stride]);
    if (base + (slope < 0.0 ? t_out : t_in) * slope < higher || std::abs(b_out - b) > 1) {
      double entered = t_in;
      for (; b != b_out; b += across.step, face = along_x ? 1 : 0) {
        const double left = std::min(across.time(across.step > 0 ? b + 1 : b), t_out);
        if (entered < left && !sweep(a, b, entered, left, face)) return;
        entered = std::max(entered, left);
      }
      if (entered < t_out && !sweep(a, b, entered, t_out, face)) return;
    }
    b = b_out;
    while (t_out >= reach) {
      if (!next_beam()) return;
    }
    if (t_out >= track.leave) return;
    t_in = t_out;
  }
}

}  // namespace ltp
