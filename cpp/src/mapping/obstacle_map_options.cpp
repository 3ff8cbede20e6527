// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/mapping/obstacle_map_options.hpp"

#include <cmath>
#include <limits>

#include "ltp/geometry/check.hpp"

namespace ltp {
namespace {

constexpr const char* kAxis[] = {"x", "y", "z"};

/// Log-odds are kept as floats: nothing so small that it would be lost, nothing so large that it
/// could overflow.
void check_log_odds(const char* name, double value, double sign) {
  if (!(sign * value >= 1e-3 && sign * value <= 1e3)) {
    check::fail(name, value, sign > 0 ? "0.001 ... 1000" : "-1000 ... -0.001");
  }
}

}  // namespace

std::array<int, 3> ObstacleMapOptions::voxels_per_cell() const {
  const double voxel = cell.minCoeff();
  return {static_cast<int>(std::lround(cell.x() / voxel)),
          static_cast<int>(std::lround(cell.y() / voxel)),
          static_cast<int>(std::lround(cell.z() / voxel))};
}

void ObstacleMapOptions::check() const {
  for (int axis = 0; axis < 3; ++axis) {
    check::positive(std::string("cell.") + kAxis[axis], cell[axis]);
    if (dims[axis] <= 0) {
      check::fail(std::string("dims.") + kAxis[axis], dims[axis], "a positive number of cells");
    }
  }
  const double voxel = cell.minCoeff();
  double voxels = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double ratio = cell[axis] / voxel;
    if (!(std::abs(ratio - std::round(ratio)) <= 1e-9 * ratio)) {
      check::fail(std::string("cell.") + kAxis[axis], cell[axis],
                  "a multiple of the smallest edge");
    }
    voxels *= std::round(ratio) * dims[axis];
  }
  if (!(voxels <= std::numeric_limits<std::int32_t>::max())) {
    check::fail("dims", voxels, "at most 2^31 - 1 voxels in all");
  }
  check::not_negative("inflation_radius", inflation_radius);
  check::not_negative("margin", margin);
  check::positive("max_range", max_range);
  check::not_negative("blind_distance", blind_distance);
  if (!(blind_distance < max_range)) {
    check::fail("blind_distance", blind_distance, "less than max_range, or nothing is mapped");
  }
  check::finite("body_min", body_min);
  check::finite("body_max", body_max);
  if (has_body() && !(body_min.array() < body_max.array()).all()) {
    check::fail("body_max", body_max.transpose(),
                "a corner above body_min along each axis, or twice the same point for no box");
  }
  check_log_odds("hit_log_odds", hit_log_odds, 1.0);
  check_log_odds("miss_log_odds", miss_log_odds, -1.0);
  check_log_odds("min_log_odds", min_log_odds, -1.0);
  check_log_odds("max_log_odds", max_log_odds, 1.0);
}

}  // namespace ltp
