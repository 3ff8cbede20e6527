// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// A scan's end points, and all its rays, into the map: beside OctoMap, and OpenVDB where it is
// installed, with the same points and the same voxels of 2 m. All have flown here before.
#include <benchmark/benchmark.h>
#include <octomap/octomap.h>

#ifdef LTP_BENCH_OPENVDB
#include <openvdb/openvdb.h>
#endif

#include <cmath>

#include "flight.hpp"
#include "ltp/mapping/obstacle_map.hpp"

namespace ltp::bench {
namespace {

constexpr double kVoxel = 2.0;  // [m]

ObstacleMapOptions options(bool carve) {
  ObstacleMapOptions options;
  options.carve_free_space = carve;
  options.keep_hits = false;  // as OctoMap does it
  return options;
}

void insert(ObstacleMap& map, const Scan& scan) { map.insert(scan.origin, rows(scan.hits)); }

void insert(octomap::OcTree& tree, const Scan& scan) {
  for (const Point& hit : scan.hits) tree.updateNode(hit.x(), hit.y(), hit.z(), true);
}

void carve(ObstacleMap& map, const Scan& scan) {
  map.insert(scan.origin, rows(scan.hits), rows(scan.misses));
}

octomap::point3d point3d(const Point& point) {
  return octomap::point3d(static_cast<float>(point.x()), static_cast<float>(point.y()),
                          static_cast<float>(point.z()));
}

/// Rays without a return end a little beyond the range, so that OctoMap takes them for what they
/// are.
octomap::Pointcloud cloud_of(const Scan& scan) {
  octomap::Pointcloud cloud;
  for (const Point& hit : scan.hits) cloud.push_back(point3d(hit));
  for (const Point& miss : scan.misses) {
    cloud.push_back(point3d(scan.origin + 1.02 * (miss - scan.origin)));
  }
  return cloud;
}

/// Whether a tree's occupied leaves are the map's voxels.
bool agree(const ObstacleMap& map, const octomap::OcTree& tree) {
  double volume = 0.0;  // pruned leaves are several voxels each
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    if (!tree.isNodeOccupied(*leaf)) continue;
    volume += std::pow(leaf.getSize() / kVoxel, 3);
    if (!map.voxels().blocked_at(Point(leaf.getX(), leaf.getY(), leaf.getZ()))) return false;
  }
  return volume == static_cast<double>(map.voxels().count());
}

template <typename Map, typename Insert>
void repeat(benchmark::State& state, Map& map, const Insert& insert_scan) {
  std::size_t next = 0;
  double hits = 0.0;
  for (auto _ : state) {
    insert_scan(map, flight()[next]);
    hits += static_cast<double>(flight()[next].hits.size());
    next = (next + 1) % flight().size();
  }
  state.counters["hits"] = hits / static_cast<double>(state.iterations());
  state.counters["a_hit"] =
      benchmark::Counter(hits, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void map_insert_ltp(benchmark::State& state) {
  ObstacleMap map(options(false), kMiddle);
  octomap::OcTree tree(kVoxel);
  for (const Scan& scan : flight()) {
    insert(map, scan);
    insert(tree, scan);
  }
  if (!agree(map, tree)) return state.SkipWithError("OctoMap has other voxels");
  repeat(state, map, [](ObstacleMap& into, const Scan& scan) { insert(into, scan); });
}
BENCHMARK(map_insert_ltp)->Name("map_insert/ltp")->Unit(benchmark::kMicrosecond);

void map_insert_octomap(benchmark::State& state) {
  octomap::OcTree tree(kVoxel);
  for (const Scan& scan : flight()) insert(tree, scan);
  repeat(state, tree, [](octomap::OcTree& into, const Scan& scan) { insert(into, scan); });
}
BENCHMARK(map_insert_octomap)->Name("map_insert/octomap")->Unit(benchmark::kMicrosecond);

#ifdef LTP_BENCH_OPENVDB
void map_insert_openvdb(benchmark::State& state) {
  openvdb::initialize();
  const openvdb::BoolGrid::Ptr grid = openvdb::BoolGrid::create(false);
  openvdb::BoolGrid::Accessor accessor = grid->getAccessor();
  const auto insert_scan = [](openvdb::BoolGrid::Accessor& into, const Scan& scan) {
    for (const Point& hit : scan.hits) {
      const openvdb::Vec3d at = openvdb::Vec3d(hit.x(), hit.y(), hit.z()) / kVoxel;
      into.setValueOn(openvdb::Coord::floor(at), true);
    }
  };
  ObstacleMap map(options(false), kMiddle);
  for (const Scan& scan : flight()) {
    insert(map, scan);
    insert_scan(accessor, scan);
  }
  if (static_cast<std::int64_t>(grid->activeVoxelCount()) != map.voxels().count()) {
    return state.SkipWithError("OpenVDB has other voxels");
  }
  repeat(state, accessor, insert_scan);
}
BENCHMARK(map_insert_openvdb)->Name("map_insert/openvdb")->Unit(benchmark::kMicrosecond);
#endif

/// The least that insertion must do: read every coordinate.
void map_insert_floor(benchmark::State& state) {
  Point sum = Point::Zero();
  repeat(state, sum, [](Point& into, const Scan& scan) {
    into = rows(scan.hits).colwise().sum().transpose();
    benchmark::DoNotOptimize(into.data());
  });
}
BENCHMARK(map_insert_floor)->Name("map_insert/floor_read")->Unit(benchmark::kMicrosecond);

void map_carve_ltp(benchmark::State& state) {
  ObstacleMap map(options(true), kMiddle);
  for (const Scan& scan : flight()) carve(map, scan);
  repeat(state, map, [](ObstacleMap& into, const Scan& scan) { carve(into, scan); });
}
BENCHMARK(map_carve_ltp)->Name("map_carve/ltp")->Unit(benchmark::kMicrosecond);

void map_carve_octomap(benchmark::State& state) {
  std::vector<octomap::Pointcloud> clouds;
  for (const Scan& scan : flight()) clouds.push_back(cloud_of(scan));
  octomap::OcTree tree(kVoxel);
  const auto insert_scan = [&](octomap::OcTree& into, const Scan& scan) {
    into.insertPointCloud(clouds[&scan - flight().data()], point3d(scan.origin), 50.0);
  };
  // One ray an end voxel on our side, all of them on OctoMap's: nearly the same cells.
  ObstacleMap map(options(true), kMiddle);
  carve(map, flight().front());
  insert_scan(tree, flight().front());
  std::int64_t ours = 0, both = 0, theirs = 0;
  const GridFrame& frame = map.voxels().frame();
  for (std::int64_t i = 0; i < frame.size(); ++i) {
    const Point centre = frame.centre(frame.cell_at(i));
    const octomap::OcTreeNode* node = tree.search(point3d(centre));
    const bool known = map.log_odds_at(centre) != 0.0;
    ours += known;
    theirs += node != nullptr;
    both +=
        known && node != nullptr && (map.log_odds_at(centre) > 0.0) == tree.isNodeOccupied(node);
  }
  state.counters["ours_too"] = static_cast<double>(both) / static_cast<double>(ours);
  state.counters["of_theirs"] = static_cast<double>(both) / static_cast<double>(theirs);
  if (both < 0.999 * ours || both < 0.9 * theirs) {
    return state.SkipWithError("OctoMap knows other voxels");
  }
  repeat(state, tree, insert_scan);
}
BENCHMARK(map_carve_octomap)->Name("map_carve/octomap")->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace ltp::bench
