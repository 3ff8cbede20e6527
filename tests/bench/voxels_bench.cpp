// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays over the voxels of a hall: scans, level and tilted, and rays one by one; OctoMap's `castRay`
// beside them, voxel by voxel; and what it takes to build the bricks.
#include <benchmark/benchmark.h>
#include <octomap/OcTree.h>

#include "hall.hpp"
#include "ltp/sensing/octree_surface.hpp"

namespace ltp::bench {
namespace {

using Counter = benchmark::Counter;

void count_rays(benchmark::State& state, double rays) {
  state.counters["rays_per_second"] = Counter(rays, Counter::kIsIterationInvariantRate);
}

void scan(benchmark::State& state, bool tilted) {
  const Hall hall;
  const OctreeSurface surface(hall.points(), Hall::kVoxel);
  const Lidar lidar(hall_lidar());
  const std::vector<Pose> poses = hall.flight(tilted);
  Scan scan;
  std::int64_t hits = 0;
  for (auto _ : state) {
    for (const Pose& pose : poses) {
      lidar.scan(surface, pose, 0, scan, Misses::Counted);
      hits += scan.statistics.hits;
    }
  }
  count_rays(state, static_cast<double>(poses.size()) * lidar.options().pattern.size());
  state.counters["voxels"] = static_cast<double>(surface.size());
  state.counters["hits"] = Counter(static_cast<double>(hits) / static_cast<double>(poses.size()),
                                   Counter::kAvgIterations);
}
BENCHMARK_CAPTURE(scan, level, false)->Name("voxels/level/ltp")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(scan, tilted, true)->Name("voxels/tilted/ltp")->Unit(benchmark::kMillisecond);

void build(benchmark::State& state) {
  const Hall hall;
  const Path points = hall.points();
  for (auto _ : state) {
    const OctreeSurface surface(points, Hall::kVoxel);
    benchmark::DoNotOptimize(surface.size());
    state.counters["bytes_a_voxel"] =
        static_cast<double>(surface.memory()) / static_cast<double>(surface.size());
  }
}
BENCHMARK(build)->Name("voxels/build/ltp")->Unit(benchmark::kMillisecond);

/// A number as OctoMap holds it. Where GCC 12 vectorises, it takes a float's way back to double for
/// none at all, but for a volatile one.
double to_single(double value) {
  const volatile float single = static_cast<float>(value);
  return single;
}

/// The rays of a scan, as both of them take them: OctoMap's points are floats.
struct Rays {
  Rays(const Lidar& lidar, const Pose& pose)
      : from(static_cast<float>(pose.position.x()), static_cast<float>(pose.position.y()),
             static_cast<float>(pose.position.z())),
        origin(to_single(pose.position.x()), to_single(pose.position.y()),
               to_single(pose.position.z())) {
    for (Eigen::Index ray = 0; ray < lidar.directions().rows(); ++ray) {
      const Point d = pose.world_from_body * Point(lidar.directions().row(ray).transpose());
      octomap::point3d direction(static_cast<float>(d.x()), static_cast<float>(d.y()),
                                 static_cast<float>(d.z()));
      theirs.push_back(direction);
      direction.normalize();  // as it does
      ours.push_back(
          Point(to_single(direction.x()), to_single(direction.y()), to_single(direction.z()))
              .normalized());
    }
  }
  octomap::point3d from;
  Point origin;
  std::vector<octomap::point3d> theirs;
  std::vector<Point> ours;
};

void single(benchmark::State& state) {
  const Hall hall;
  const OctreeSurface surface(hall.points(), Hall::kVoxel);
  const Lidar lidar(hall_lidar());
  const Rays rays(lidar, hall.flight(true).front());
  for (auto _ : state) {
    for (const Point& direction : rays.ours) {
      benchmark::DoNotOptimize(surface.cast(rays.origin, direction, 50.0).range);
    }
  }
  count_rays(state, static_cast<double>(rays.ours.size()));
}
BENCHMARK(single)->Name("voxels/one_by_one/ltp")->Unit(benchmark::kMillisecond);

void octomap_rays(benchmark::State& state, bool tilted) {
  constexpr double kRange = 50.0;
  const Hall hall;
  const OctreeSurface surface(hall.points(), Hall::kVoxel);
  octomap::OcTree tree(Hall::kVoxel);
  for (const Eigen::Vector3i& voxel : hall.voxels) {
    const auto key = [&](int axis) { return static_cast<octomap::key_type>(32768 + voxel[axis]); };
    tree.setNodeValue(octomap::OcTreeKey(key(0), key(1), key(2)), 2.0F, true);
  }
  tree.updateInnerOccupancy();
  tree.prune();
  const Lidar lidar(hall_lidar());
  const std::vector<Pose> poses = hall.flight(tilted);
  const Rays rays(lidar, poses.front());
  octomap::point3d end;
  for (auto _ : state) {
    for (const octomap::point3d& direction : rays.theirs) {
      benchmark::DoNotOptimize(tree.castRay(rays.from, direction, end, true, kRange));
    }
  }
  count_rays(state, static_cast<double>(rays.theirs.size()));

  std::int64_t differ = 0;
  for (const Pose& pose : poses) {
    const Rays all(lidar, pose);
    for (std::size_t ray = 0; ray < all.ours.size(); ++ray) {
      const bool hit = tree.castRay(all.from, all.theirs[ray], end, true, kRange);
      const RayHit ours = surface.cast(all.origin, all.ours[ray], kRange);
      const Point inside = ours.inside.array() / Hall::kVoxel;
      const Point theirs = Point(end.x(), end.y(), end.z()).array() / Hall::kVoxel;
      differ += hit != ours.hit() ||
                (hit && inside.array().floor().matrix() != theirs.array().floor().matrix());
    }
  }
  state.counters["rays"] = static_cast<double>(poses.size() * rays.ours.size());
  state.counters["differ"] = static_cast<double>(differ);
}
BENCHMARK_CAPTURE(octomap_rays, level, false)
    ->Name("voxels/level/octomap")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(octomap_rays, tilted, true)
    ->Name("voxels/tilted/octomap")
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace ltp::bench
