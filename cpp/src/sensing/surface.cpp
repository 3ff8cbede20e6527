// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/sensing/surface.hpp"

#include <cmath>

#include "ltp/geometry/check.hpp"

namespace ltp {

BeamFan::BeamFan(const std::vector<double>& elevations) {
  constexpr double kZenith = 1.5707963267948966;
  beams_.reserve(elevations.size());
  for (std::size_t row = 0; row < elevations.size(); ++row) {
    const double elevation = elevations[row];
    const std::string name = "elevations[" + std::to_string(row) + "]";
    if (!(std::abs(elevation) < kZenith)) check::fail(name, elevation, "within (-pi/2, pi/2)");
    if (row > 0 && elevation < elevations[row - 1]) {
      check::fail(name, elevation, "ascending elevations");
    }
    const double cosine = std::cos(elevation);
    const double sine = std::sin(elevation);
    beams_.push_back({sine / cosine, cosine / sine, cosine, sine, 1.0 / cosine});
  }
}

void Surface::cast_fan(const Point& origin, const Eigen::Vector2d& heading, const BeamFan& fan,
                       double max_range, std::vector<RayHit>& hits) const {
  hits.resize(fan.size());
  for (int row = 0; row < fan.size(); ++row) {
    const BeamFan::Beam& beam = fan[row];
    const Point direction(beam.cosine * heading.x(), beam.cosine * heading.y(), beam.sine);
    hits[row] = cast(origin, direction, max_range);
  }
}

}  // namespace ltp
