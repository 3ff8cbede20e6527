// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Is there an obstacle at a point? At random points, and metre by metre along segments; beside
// OctoMap, and OpenVDB where it is installed, with the same voxels of 2 m.
#include <benchmark/benchmark.h>
#include <octomap/octomap.h>

#ifdef LTP_BENCH_OPENVDB
#include <openvdb/openvdb.h>
#endif

#include <random>

#include "flight.hpp"
#include "ltp/mapping/obstacle_map.hpp"

namespace ltp::bench {
namespace {

constexpr double kVoxel = 2.0;  // [m]
constexpr int kPoints = 10000;

const ObstacleMap& map() {
  static const ObstacleMap made = [] {
    ObstacleMap fresh({}, kMiddle);
    for (const Scan& scan : flight()) fresh.insert(scan.origin, rows(scan.hits));
    return fresh;
  }();
  return made;
}

Path random_points() {
  std::mt19937 random(3);
  const GridFrame& frame = map().voxels().frame();
  Path points(kPoints, 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      std::uniform_real_distribution<float> within(
          static_cast<float>(frame.origin()[axis]),
          std::nextafter(static_cast<float>(frame.upper()[axis]), 0.0f));
      points(i, axis) = within(random);
    }
  }
  return points;
}

/// A hundred segments of a hundred metres.
Path segment_points() {
  const Path ends = random_points();
  Path points(kPoints, 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::RowVector3d from = ends.row(i / 100);
    const Eigen::RowVector3d towards = ends.row(9999 - i / 100) - from;
    const Eigen::RowVector3d at =
        from +
        std::min<double>(static_cast<double>(i % 100), towards.norm()) * towards.normalized();
    points.row(i) = at.cast<float>().cast<double>();
  }
  return points;
}

template <typename Blocked>
void ask(benchmark::State& state, bool random, const Blocked& blocked) {
  const Path points = random ? random_points() : segment_points();
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Point point = points.row(i).transpose();
    if (blocked(point) != map().voxels().blocked_at(point)) {
      return state.SkipWithError("it has other voxels");
    }
  }
  std::int64_t yes = 0;
  for (auto _ : state) {
    for (Eigen::Index i = 0; i < points.rows(); ++i) yes += blocked(points.row(i).transpose());
  }
  benchmark::DoNotOptimize(yes);
  state.counters["blocked"] =
      static_cast<double>(yes) / static_cast<double>(state.iterations() * kPoints);
  state.counters["a_point"] = benchmark::Counter(
      kPoints, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void ltp_one_by_one(benchmark::State& state, bool random) {
  const OccupancyGrid& voxels = map().voxels();
  ask(state, random, [&](const Point& point) { return voxels.blocked_at(point); });
}
BENCHMARK_CAPTURE(ltp_one_by_one, random, true)
    ->Name("point_query/random/ltp")
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ltp_one_by_one, segment, false)
    ->Name("point_query/segment/ltp")
    ->Unit(benchmark::kMicrosecond);

/// As from Python: all at once.
void ltp_at_once(benchmark::State& state, bool random) {
  const Path points = random ? random_points() : segment_points();
  bool out[kPoints];
  for (auto _ : state) {
    map().voxels().blocked_at(points, out);
    benchmark::DoNotOptimize(&out[0]);
  }
  state.counters["a_point"] = benchmark::Counter(
      kPoints, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK_CAPTURE(ltp_at_once, random, true)
    ->Name("point_query/random/ltp_at_once")
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ltp_at_once, segment, false)
    ->Name("point_query/segment/ltp_at_once")
    ->Unit(benchmark::kMicrosecond);

void octomap_search(benchmark::State& state, bool random) {
  octomap::OcTree tree(kVoxel);
  for (const Scan& scan : flight()) {
    for (const Point& hit : scan.hits) tree.updateNode(hit.x(), hit.y(), hit.z(), true);
  }
  ask(state, random, [&](const Point& point) {
    const octomap::OcTreeNode* node = tree.search(point.x(), point.y(), point.z());
    return node != nullptr && tree.isNodeOccupied(node);
  });
}
BENCHMARK_CAPTURE(octomap_search, random, true)
    ->Name("point_query/random/octomap")
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(octomap_search, segment, false)
    ->Name("point_query/segment/octomap")
    ->Unit(benchmark::kMicrosecond);

#ifdef LTP_BENCH_OPENVDB
void openvdb_accessor(benchmark::State& state, bool random) {
  openvdb::initialize();
  const openvdb::BoolGrid::Ptr grid = openvdb::BoolGrid::create(false);
  openvdb::BoolGrid::Accessor accessor = grid->getAccessor();
  const auto coord = [](const Point& point) {
    return openvdb::Coord::floor(openvdb::Vec3d(point.x(), point.y(), point.z()) / kVoxel);
  };
  for (const Scan& scan : flight()) {
    for (const Point& hit : scan.hits) accessor.setValueOn(coord(hit), true);
  }
  ask(state, random, [&](const Point& point) { return accessor.isValueOn(coord(point)); });
}
BENCHMARK_CAPTURE(openvdb_accessor, random, true)
    ->Name("point_query/random/openvdb")
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(openvdb_accessor, segment, false)
    ->Name("point_query/segment/openvdb")
    ->Unit(benchmark::kMicrosecond);
#endif

}  // namespace
}  // namespace ltp::bench
