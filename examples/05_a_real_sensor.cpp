// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// A driver's cloud as it comes - floats x, y, z, intensity in the sensor's frame - and a planning
// thread of its own. The cloud is made up here: a wall 12 m ahead, and a leg of the aircraft.
#include <cmath>
#include <iostream>
#include <ltp/navigation/concurrent_trajectory_planner.hpp>
#include <ltp/planning/planners.hpp>
#include <vector>

namespace {
constexpr int kColumns = 4;  // of the driver's buffer: x, y, z, intensity

std::vector<float> driver_cloud() {
  std::vector<float> cloud;
  for (int i = -400; i <= 400; ++i) {
    for (int k = -20; k <= 20; ++k) cloud.insert(cloud.end(), {12.0F, i * 0.02F, k * 0.1F, 1.0F});
  }
  cloud.insert(cloud.end(), {0.3F, 0.3F, -0.2F, 1.0F});  // the leg
  cloud.insert(cloud.end(), {0.0F, 0.0F, 0.0F, 0.0F});   // "no return", as some drivers write it
  return cloud;
}
}  // namespace

int main() {
  ltp::ObstacleMapOptions map;
  map.max_range = 60.0;      // of the sensor [m]
  map.blind_distance = 0.8;  // a return nearer than this is the aircraft itself [m]
  const ltp::Raster priority(ltp::Raster::Values::Zero(200, 200), {-200, -200}, 2.0);
  const ltp::Point body(0, 0, 30);  // where the autopilot says it is, ENU [m]
  ltp::ConcurrentTrajectoryPlanner planner(ltp::make_planner("auto"), map, {}, priority, body);
  planner.start();
  ltp::Path waypoints(1, 3);
  waypoints << 40, 0, 30;
  planner.set_waypoints(waypoints);

  // World from sensor: the attitude of the aircraft times that of the mount, tilted down 20
  // degrees.
  const Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();
  const Eigen::Quaterniond mount(Eigen::AngleAxisd(EIGEN_PI / 9.0, Eigen::Vector3d::UnitY()));
  const ltp::Pose sensor{body + attitude * ltp::Point(0.10, 0.0, -0.05), attitude * mount};
  const Eigen::Matrix3d rotation(sensor.world_from_body);

  const std::vector<float> cloud = driver_cloud();
  const ltp::PointsView seen(cloud.data(), static_cast<Eigen::Index>(cloud.size() / kColumns),
                             kColumns);
  ltp::Path hits(seen.rows(), 3);  // world frame; keep it from scan to scan
  for (Eigen::Index i = 0; i < seen.rows(); ++i) {
    hits.row(i) = (sensor.position + rotation * seen[i]).transpose();
  }
  const ltp::InsertStatistics statistics = planner.sense(sensor, hits, ltp::Path(0, 3));
  std::cout << statistics.marked << " marked, " << statistics.too_near << " too near\n";

  planner.wait(1.0);  // here only: in flight nobody waits, the next scan comes
  const ltp::Decision& decision = planner.decision();
  const bool blocked = planner.blocked_at().has_value();  // by the newest scan
  std::cout << ltp::to_string(decision.status) << (blocked ? ", stop\n" : ", fly\n");
}
