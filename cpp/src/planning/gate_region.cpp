// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/gate_region.hpp"

#include <cmath>

namespace ltp {
namespace {

constexpr double kWithin = 1e-9;  // what a point may be off [m]

}  // namespace

GateRegion::GateRegion(const GridFrame& frame, const AltitudeRange& altitudes,
                       const LevelRange& open, const Gate& gate)
    : gate_(gate),
      edge_(frame.cell()),
      centre_((gate.point - frame.centre(Cell::Zero())).head<2>()),
      own_(frame.cell_of(gate.point)),
      own_inside_(frame.contains(own_)),
      levels_{1, 0},
      reach_(gate.radius) {
  double rise = 0.0;
  for (int level = open.lowest; level <= open.highest; ++level) {
    const double dz = vertex_of(frame, altitudes, Cell(0, 0, level)).z() - gate.point.z();
    if (std::abs(dz) > gate.height + kWithin) continue;
    if (levels_.count() == 0) levels_.lowest = level;
    levels_.highest = level;
    rise = std::max(rise, std::abs(dz));
  }
  reach_ = std::hypot(gate.radius, rise);
  const Point corner(gate.radius, gate.radius, 0.0);
  const Cell low = frame.cell_of(gate.point - corner);
  const Cell high = frame.cell_of(gate.point + corner);
  first_ = low.cwiseMax(0);
  last_ = high.cwiseMin(Cell(frame.nx() - 1, frame.ny() - 1, frame.nz() - 1));
  whole_ = own_inside_ && low.head<2>() == first_.head<2>() && high.head<2>() == last_.head<2>();
}

bool GateRegion::contains(const Point& point) const {
  const Point offset = point - gate_.point;
  return offset.head<2>().norm() <= gate_.radius + kWithin &&
         std::abs(offset.z()) <= gate_.height + kWithin;
}

bool GateRegion::any_free(const OccupancyGrid& grid) const {
  bool free = false;
  for_each([&](const Cell& cell) { free = free || !grid.blocked(cell); });
  return free;
}

bool GateRegion::outside() const {
  bool none = true;
  for_each([&](const Cell&) { none = false; });
  return none;
}

}  // namespace ltp
