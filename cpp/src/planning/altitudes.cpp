// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/altitudes.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "ltp/geometry/check.hpp"

namespace ltp {
namespace {

constexpr double kWithin =
    1e-9;  // what an altitude may be off, and a band may touch of a level [m]

}  // namespace

void check_query(const Query& query) {
  check::finite("start", query.start);
  check::finite("goal", query.goal);
  check::not_negative("gate_radius", query.gate_radius);
  check::not_negative("gate_height", query.gate_height);
  for (std::size_t i = 0; i < query.then.size(); ++i) {
    const std::string name = "then[" + std::to_string(i) + "].";
    check::finite(name + "point", query.then[i].point);
    check::not_negative((name + "radius").c_str(), query.then[i].radius);
    check::not_negative((name + "height").c_str(), query.then[i].height);
  }
  // An infinite band is open to the whole window.
  if (!(query.band.below >= 0.0)) check::fail("band.below", query.band.below, "a number >= 0");
  if (!(query.band.above >= 0.0)) check::fail("band.above", query.band.above, "a number >= 0");
}

bool AltitudeRange::contains(double z) const {
  const double rounding = kWithin + 1e-15 * std::abs(z);
  return z >= lowest - rounding && z <= highest + rounding;
}

AltitudeRange altitudes_of(const Query& query) {
  double lowest = std::min(query.start.z(), query.goal.z());
  double highest = std::max(query.start.z(), query.goal.z());
  for (const Gate& gate : query.then) {
    lowest = std::min(lowest, gate.point.z());
    highest = std::max(highest, gate.point.z());
  }
  return {lowest - query.band.below, highest + query.band.above};
}

LevelRange levels_of(const GridFrame& frame, const Query& query) {
  const auto level = [&](double z) {
    if (z <= frame.origin().z()) return 0;  // an open band has no cell of its own
    if (z >= frame.upper().z()) return frame.nz() - 1;
    return std::clamp(frame.cell_of(Point(query.start.x(), query.start.y(), z)).z(), 0,
                      frame.nz() - 1);
  };
  const AltitudeRange open = altitudes_of(query);
  const double face = kWithin * std::min(1.0, frame.cell().z());
  std::pair<int, int> ends = std::minmax({level(query.start.z()), level(query.goal.z())});
  for (const Gate& gate : query.then) {
    ends.first = std::min(ends.first, level(gate.point.z()));
    ends.second = std::max(ends.second, level(gate.point.z()));
  }
  return {std::min(ends.first, level(open.lowest + face)),
          std::max(ends.second, level(open.highest - face))};
}

Point vertex_of(const GridFrame& frame, const AltitudeRange& altitudes, const Cell& cell) {
  Point point = frame.centre(cell);
  point.z() = std::clamp(point.z(), altitudes.lowest, altitudes.highest);
  return point;
}

}  // namespace ltp
