// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `HeightSurface`: the fan of beams of one azimuth, by one sweep of the horizon.
#include <algorithm>
#include <cmath>
#include <limits>

#include "column_hit.hpp"
#include "ground_track.hpp"
#include "ltp/sensing/height_surface.hpp"

namespace ltp {

using sensing::GroundTrack;
using sensing::TrackAxis;

void HeightSurface::cast_fan(const Point& origin, const Eigen::Vector2d& heading,
                             const BeamFan& fan, double max_range, std::int64_t first_ray,
                             RayHits& hits) const {
  const GroundTrack track(heights_, origin, heading.x(), heading.y());
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
        hits.add(first_ray + lowest, range, sensing::inside_column(
            heights_, i, j, height, top_hit ? sensing::kTopFace : face,
            {origin.x() + t * heading.x(), origin.y() + t * heading.y(), base + t * slope}));
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
