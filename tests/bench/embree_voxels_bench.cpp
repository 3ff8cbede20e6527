// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The voxels' peer: Embree's packets of 16 rays on the faces of their boxes that can be seen. Only
// built where Embree 3 is found.
#include <benchmark/benchmark.h>

#include <cmath>

#include "embree_scene.hpp"
#include "hall.hpp"
#include "ltp/sensing/octree_surface.hpp"

namespace ltp::bench {
namespace {

/// The faces between occupied voxels and free ones.
Triangles voxel_mesh(const OctreeSurface& surface) {
  Triangles mesh;
  const OccupancyGrid& voxels = surface.voxels();
  const GridFrame& frame = voxels.frame();
  const double edge = surface.resolution();
  for (std::int64_t index = 0; index < frame.size(); ++index) {
    const Cell cell = frame.cell_at(index);
    if (!voxels.blocked(cell)) continue;
    for (int axis = 0; axis < 3; ++axis) {
      for (const int side : {-1, 1}) {
        const Cell next = cell + side * Cell::Unit(axis);
        if (frame.contains(next) && voxels.blocked(next)) continue;
        Point corner = frame.origin() + edge * cell.cast<double>();
        if (side > 0) corner[axis] += edge;
        mesh.quad(corner, edge * Point::Unit((axis + 1) % 3), edge * Point::Unit((axis + 2) % 3));
      }
    }
  }
  return mesh;
}

void scan(benchmark::State& state, bool tilted) {
  constexpr double kClose = 2e-3;  // Embree computes in float [m]
  const Hall hall;
  const OctreeSurface surface(hall.points(), Hall::kVoxel);
  const EmbreeScene scene(voxel_mesh(surface));
  const Lidar lidar(hall_lidar());
  const std::vector<Pose> poses = hall.flight(tilted);
  const auto max_range = static_cast<float>(lidar.options().max_range);
  std::vector<float> ranges(lidar.directions().rows());
  const Path turned = lidar.directions() * poses[0].world_from_body.toRotationMatrix().transpose();
  const Eigen::Array<float, Eigen::Dynamic, 3> directions = turned.cast<float>();

  std::int64_t differ = 0;
  for (const Pose& pose : poses) {
    scene.cast(pose.position, directions, max_range, ranges);
    for (Eigen::Index ray = 0; ray < turned.rows(); ++ray) {
      const double ours = surface.cast(pose.position, turned.row(ray).transpose(), max_range).range;
      const double theirs = ranges[ray];
      const bool both_miss = std::isinf(ours) && std::isinf(theirs);
      differ += !both_miss && !(std::abs(ours - theirs) < kClose);
    }
  }
  const double rays = static_cast<double>(poses.size() * ranges.size());
  if (differ > 1e-3 * rays) return state.SkipWithError("Embree's ranges are not ours");

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
BENCHMARK_CAPTURE(scan, level, false)->Name("voxels/level/embree")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(scan, tilted, true)->Name("voxels/tilted/embree")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace ltp::bench
