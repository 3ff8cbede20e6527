// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `HeightSurface`: fans of beams, each by one sweep of the horizon.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "column_hit.hpp"
#include "ground_track.hpp"
#include "ltp/sensing/height_surface.hpp"
#include "panorama.hpp"

namespace ltp {
namespace {

using sensing::GroundTrack;
using sensing::Horizon;
using sensing::kTopFace;
using sensing::TrackAxis;
using sensing::TrackStart;

/// Columns of each side, for so many fans; measured.
int columns_for(std::size_t fans) { return fans < 512 ? 8 : 16; }

/// The beams of one fan that are not settled yet: that have hit nothing so far, but still may.
class FreeBeams {
 public:
  FreeBeams(const Point& origin, const BeamFan& fan, double max_range, double highest)
      : origin_(origin), fan_(fan), max_range_(max_range) {
    const double headroom = highest - origin.z();
    static thread_local std::vector<double> reach;  // reused from scan to scan
    reach.clear();
    for (int row = 0; row < fan.size(); ++row) {
      const BeamFan::Beam& beam = fan[row];
      double most = max_range * beam.cosine;
      if (beam.slope > 0.0) most = std::min(most, headroom * beam.run * (1.0 + 1e-12));
      reach.push_back(beam.slope >= 0.0 && headroom <= 0.0 ? 0.0 : most);
    }
    reach_ = reach.data();
  }

  /// The next fan, whose lowest beam has this number.
  void begin(const Eigen::Vector2d& heading, std::int64_t first_ray) {
    heading_ = heading;
    first_ray_ = first_ray;
    lowest_ = 0;
    lowest_slope_ = fan_[0].slope;
  }

  double lowest_slope() const { return lowest_slope_; }
  /// Whether the lowest is anywhere below a height while the track runs from `t_in` to `t_out` [m].
  bool below(double height, double t_in, double t_out) const {
    return origin_.z() + (lowest_slope_ < 0.0 ? t_out : t_in) * lowest_slope_ < height;
  }

  /// Settles those that end before `t` [m along the ground]; whether any are left.
  bool end_at(double t) {
    if (t < reach_[lowest_]) return true;
    while (++lowest_ < fan_.size() && t >= reach_[lowest_]) continue;
    return look_up();
  }

  /// Settles those that hit a column, by a wall on entering it or by its top; whether any are left.
  bool hit(const sensing::ColumnInside& column, double height, double t_in, double t_out, int face,
           RayHits& hits) {
    const double base = origin_.z();
    int end = lowest_;
    while (end < fan_.size() && base + t_in * fan_[end].slope < height) ++end;
    if (end > lowest_) {
      // These end at one place, one above the other.
      const double x = column.x(face, origin_.x() + t_in * heading_.x());
      const double y = column.y(face, origin_.y() + t_in * heading_.y());
      // The outer ones are the longest.
      if (t_in * std::max(fan_[lowest_].stretch, fan_[end - 1].stretch) < max_range_) {
        const RayHits::Slots slots = hits.extend(end - lowest_);
        for (int n = 0; n < end - lowest_; ++n) {
          const BeamFan::Beam& beam = fan_[lowest_ + n];
          slots.rays[n] = static_cast<std::int32_t>(first_ray_ + lowest_ + n);
          slots.ranges[n] = t_in * beam.stretch;
          slots.inside[n] = {x, y, column.z(face, base + t_in * beam.slope)};
        }
      } else {
        for (int row = lowest_; row < end; ++row) {
          const BeamFan::Beam& beam = fan_[row];
          add(row, t_in * beam.stretch, {x, y, column.z(face, base + t_in * beam.slope)}, hits);
        }
      }
      lowest_ = end;
    }
    for (; lowest_ < fan_.size(); ++lowest_) {
      const BeamFan::Beam& beam = fan_[lowest_];
      if (!(beam.slope < 0.0 && base + t_out * beam.slope < height)) break;
      const double t = std::min(std::max((height - base) * beam.run, t_in), t_out);
      add(lowest_, t * beam.stretch,
          column(kTopFace, {origin_.x() + t * heading_.x(), origin_.y() + t * heading_.y(),
                            base + t * beam.slope}),
          hits);
    }
    return look_up();
  }

 private:
  bool look_up() {
    if (lowest_ == fan_.size()) return false;
    lowest_slope_ = fan_[lowest_].slope;
    return true;
  }
  void add(int row, double range, const Point& inside, RayHits& hits) const {
    if (range < max_range_) hits.add(first_ray_ + row, range, inside);
  }

  const Point& origin_;
  const BeamFan& fan_;
  double max_range_;
  const double* reach_;  ///< how far each beam can hit anything [m along the ground]
  Eigen::Vector2d heading_;
  std::int64_t first_ray_ = 0;
  int lowest_ = 0;
  double lowest_slope_ = 0.0;
};

/// Walks a track slab by slab along the axis that it crosses faster; within a slab it passes one
/// cell or two (three where rounding splits a corner).
/// @param blocked  of each slab, below which slope (of the axis) it can block beams
void sweep(const Raster& heights, const GroundTrack& track, bool along_x, double stretch,
           const double* blocked, int slabs, FreeBeams& beams, RayHits& hits) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const TrackAxis along = along_x ? track.x : track.y;
  const TrackAxis across = along_x ? track.y : track.x;
  const std::ptrdiff_t along_stride = along_x ? heights.ny() : 1;
  const std::ptrdiff_t across_stride = along_x ? 1 : heights.ny();
  const int last = across.step > 0 ? across.cells - 1 : 0;
  const int first = along.cell_after(track.enter);

  for (int slab = 0; slab < slabs;) {
    const int a = first + slab * along.step;
    double t_in = slab > 0 ? along.enter(a) : track.enter;
    if (t_in >= track.leave || !beams.end_at(t_in)) return;
    // The beams above are steeper still.
    const double slope = beams.lowest_slope() * stretch;
    if (!(slope < blocked[slab])) {
      while (++slab < slabs && !(slope < blocked[slab])) continue;
      continue;
    }

    int face = slab > 0 ? (along_x ? 0 : 1) : track.axis;
    int b = across.cell_after(t_in);
    const double* cell = heights.values().data() + a * along_stride + b * across_stride;
    /// Whether any beams are left after the cell.
    const auto pass = [&](double t_out) {
      const double height = *cell;
      if (!(t_in < t_out) || !beams.below(height, t_in, t_out)) return true;
      const sensing::ColumnInside column(heights, along_x ? a : b, along_x ? b : a, height);
      return beams.hit(column, height, t_in, t_out, face, hits);
    };
    const double t_out = std::min(along.leave(a), track.leave);
    double t_across = b == last ? kInfinity : across.leave(b);
    while (t_across <= t_out) {
      if (!pass(t_across)) return;
      t_in = std::max(t_in, t_across);
      b += across.step;
      cell += across.step * across_stride;
      face = along_x ? 1 : 0;
      t_across = b == last ? kInfinity : across.leave(b);
    }
    if (!pass(t_out)) return;
    ++slab;
  }
}

}  // namespace

void HeightSurface::cast_fans(const Point& origin, const std::vector<Eigen::Vector2d>& headings,
                              const BeamFan& fan, double max_range, RayHits& hits) const {
  if (fan.size() == 0) return;
  Horizon& horizon = sensing::Panorama::of_this_thread().horizon();
  static thread_local std::vector<double> anything;  // reused from scan to scan
  // A horizon's cost goes with the square of the slabs, that of walking them all with the fans.
  const bool seen =
      Horizon::can_look(heights_, origin, max_range, static_cast<double>(headings.size()));
  if (seen) {
    horizon.look(heights_, origin, max_range, columns_for(headings.size()));
  } else {
    anything.assign(std::max(heights_.nx(), heights_.ny()),
                    std::numeric_limits<double>::infinity());
  }

  FreeBeams beams(origin, fan, max_range, values(top())[0]);
  const TrackStart start_x(heights_, origin, 0);
  const TrackStart start_y(heights_, origin, 1);
  std::int64_t ray = 0;
  for (const Eigen::Vector2d& heading : headings) {
    const GroundTrack track(TrackAxis(start_x, heading.x()), TrackAxis(start_y, heading.y()));
    beams.begin(heading, ray);
    ray += fan.size();
    if (!track.crosses()) continue;
    const bool along_x = std::abs(heading.x()) >= std::abs(heading.y());
    const double ahead = along_x ? heading.x() : heading.y();
    const double stretch = 1.0 / std::abs(ahead);
    if (seen) {
      const int side = Horizon::side(along_x, ahead < 0.0);
      const double aside = (along_x ? heading.y() : heading.x()) * stretch;
      const int column = std::min(static_cast<int>(0.5 * (aside + 1.0) * horizon.columns()),
                                  horizon.columns() - 1);
      const int slabs = static_cast<int>(horizon.slabs(side).size());
      sweep(heights_, track, along_x, stretch, horizon.blocked(side, column), slabs, beams, hits);
    } else {
      const int slabs = (along_x ? track.x : track.y).slabs_from(track.enter);
      sweep(heights_, track, along_x, stretch, anything.data(), slabs, beams, hits);
    }
  }
}

}  // namespace ltp
