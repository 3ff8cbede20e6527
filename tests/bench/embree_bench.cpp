// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The LiDAR's peer: Embree's packets of 16 rays on two meshes of the same city. Only built where
// Embree 3 is found.
#include <benchmark/benchmark.h>

#include <cmath>

#include "embree_scene.hpp"
#include "lidar_city.hpp"
#include "ltp/sensing/height_surface.hpp"

namespace ltp::bench {
namespace {

enum class Mesh { kBoxes, kRaster };

/// Five faces a building and one square of ground: the least that a mesh of the city can be.
Triangles box_mesh(const City& city) {
  Triangles mesh;
  mesh.quad({0, 0, 0}, {City::kEdge, 0, 0}, {0, City::kEdge, 0});
  for (const Building& box : city.boxes) {
    const Point low(box.x, box.y, 0);
    const Point dx(box.dx, 0, 0);
    const Point dy(0, box.dy, 0);
    const Point up(0, 0, box.height);
    mesh.quad(low + up, dx, dy);
    for (const Point& side : {low, Point(low + dy)}) mesh.quad(side, dx, up);
    for (const Point& side : {low, Point(low + dx)}) mesh.quad(side, dy, up);
  }
  return mesh;
}

/// A square a cell and the walls between: what any height raster becomes.
Triangles raster_mesh(const City& city) {
  Triangles mesh;
  for (int i = 0; i < City::kEdge; ++i) {
    for (int j = 0; j < City::kEdge; ++j) {
      const double height = city.values(i, j);
      mesh.quad({double(i), double(j), height}, {1, 0, 0}, {0, 1, 0});
      const double rise_x = i > 0 ? height - city.values(i - 1, j) : 0.0;
      const double rise_y = j > 0 ? height - city.values(i, j - 1) : 0.0;
      const Point corner(i, j, height);
      if (rise_x != 0.0) mesh.quad(corner, {0, 1, 0}, {0, 0, -rise_x});
      if (rise_y != 0.0) mesh.quad(corner, {1, 0, 0}, {0, 0, -rise_y});
    }
  }
  return mesh;
}

/// How many of Embree's ranges are not ours.
std::int64_t differences(const HeightSurface& surface, const Lidar& lidar, const Pose& pose,
                         const std::vector<float>& ranges) {
  constexpr double kClose = 5e-3;  // Embree computes in float [m]
  const double max_range = lidar.options().max_range;
  std::int64_t count = 0;
  for (std::size_t n = 0; n < ranges.size(); ++n) {
    const Point direction = pose.world_from_body * Point(lidar.directions().row(n).transpose());
    const double ours =
        std::min(surface.cast(pose.position, direction, max_range).range, max_range);
    const double theirs = std::min(double(ranges[n]), max_range);
    count += !(std::abs(ours - theirs) < kClose);
  }
  return count;
}

void scan(benchmark::State& state, Mesh kind, bool tilted) {
  const City city;
  const EmbreeScene scene(kind == Mesh::kBoxes ? box_mesh(city) : raster_mesh(city));
  const HeightSurface surface(city.heights());
  const Lidar lidar(city_lidar());
  const std::vector<Pose> poses = city_flight(city, tilted);
  const auto max_range = static_cast<float>(lidar.options().max_range);
  std::vector<float> ranges(lidar.directions().rows());
  // The same attitude all along, so its rays are turned beforehand.
  const Eigen::Array<float, Eigen::Dynamic, 3> directions =
      (lidar.directions() * poses[0].world_from_body.toRotationMatrix().transpose()).cast<float>();

  std::int64_t differ = 0;
  for (const Pose& pose : poses) {
    scene.cast(pose.position, directions, max_range, ranges);
    differ += differences(surface, lidar, pose, ranges);
  }
  const double rays = static_cast<double>(poses.size() * ranges.size());
  if (differ > 1e-4 * rays) return state.SkipWithError("Embree's ranges are not ours");

  for (auto _ : state) {
    for (const Pose& pose : poses) {
      scene.cast(pose.position, directions, max_range, ranges);
      benchmark::DoNotOptimize(ranges.data());
    }
  }
  state.counters["rays_per_second"] = benchmark::Counter(
      rays * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
  state.counters["differ"] = static_cast<double>(differ);
}
BENCHMARK_CAPTURE(scan, level_box, Mesh::kBoxes, false)
    ->Name("lidar/level/embree_box")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(scan, level_raster, Mesh::kRaster, false)
    ->Name("lidar/level/embree_raster")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(scan, tilted_box, Mesh::kBoxes, true)
    ->Name("lidar/tilted/embree_box")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(scan, tilted_raster, Mesh::kRaster, true)
    ->Name("lidar/tilted/embree_raster")
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace ltp::bench
