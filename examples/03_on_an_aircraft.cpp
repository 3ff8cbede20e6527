// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The loop as it runs on an aircraft: scans and positions in, a path to follow out. The sensor and
// the motion are made up here, and are all that a real aircraft brings along instead.
#include <cmath>
#include <iostream>
#include <ltp/geometry/polyline.hpp>
#include <ltp/navigation/local_trajectory_planner.hpp>

namespace {
constexpr double kHeight = 50.0;  // of the flight [m]
constexpr double kSpeed = 3.0;    // [m/s]
constexpr double kStep = 0.1;     // between two scans [s]

/// Where the rays of a level LiDAR with 50 m of range hit a building of 40 x 80 m, shape (N, 3).
ltp::Path scan(const ltp::Point& from) {
  const Eigen::Array2d low(80, -40), high(120, 40);
  ltp::Path hits(360, 3);
  int count = 0;
  for (int degree = 0; degree < 360; ++degree) {
    const double angle = degree * EIGEN_PI / 180.0 + 1e-6;  // never quite along a wall
    const Eigen::Array2d ray(std::cos(angle), std::sin(angle));
    const Eigen::Array2d at_low = (low - from.head<2>().array()) / ray;
    const Eigen::Array2d at_high = (high - from.head<2>().array()) / ray;
    const double enters = at_low.min(at_high).maxCoeff();
    const double leaves = at_low.max(at_high).minCoeff();
    if (enters < 0.0 || enters > leaves || enters >= 50.0) continue;
    hits.row(count++) = from + (enters + 1e-3) * ltp::Point(ray.x(), ray.y(), 0.0);
  }
  return hits.topRows(count);
}
}  // namespace

int main() {
  ltp::Point position(0, 0, kHeight);
  const ltp::Raster priority(ltp::Raster::Values::Zero(150, 150), {-50, -150}, 2.0);
  ltp::LocalTrajectoryPlanner planner({}, {}, priority, position);
  ltp::Path waypoints(3, 3);  // the second one lies in the building
  waypoints << 50, 0, kHeight, 100, 0, kHeight, 200, 0, kHeight;
  planner.set_waypoints(waypoints);

  double flown = 0.0;
  for (int tick = 0; tick < 3000; ++tick) {
    planner.sense(position, scan(position), ltp::Path(0, 3));
    const ltp::NavigationStatus status = planner.update(position);
    if (status == ltp::NavigationStatus::Finished) break;
    if (planner.path().rows() == 0) continue;  // holding: stay, and look again
    const double along = ltp::closest_point(planner.path(), position).arc_length;
    const ltp::Point next = ltp::point_at(planner.path(), along + kSpeed * kStep);
    flown += (next - position).norm();
    position = next;
  }
  for (const ltp::WaypointEvent& event : planner.events()) {
    std::cout << "waypoint " << event.index + 1 << (event.reached ? " reached" : " dropped: ")
              << (event.reached ? "" : ltp::to_string(event.reason)) << '\n';
  }
  std::cout << "flew " << flown << " m with " << planner.plans_made() << " plans\n";
}
