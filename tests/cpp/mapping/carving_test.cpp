// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Carving against a plain table of world voxels, against OctoMap itself, and the story of the thin
// pole.
#include <gtest/gtest.h>
#include <octomap/octomap.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <vector>

#include "ltp/mapping/obstacle_map.hpp"
#include "mapping/promises.hpp"

namespace ltp {
namespace {

using Key = std::array<int, 3>;  // a voxel, counted from the world's origin

ObstacleMapOptions carving_map(bool keep_hits) {
  ObstacleMapOptions options;
  options.dims = {16, 14, 8};
  options.max_range = 25.0;
  options.blind_distance = 0.0;  // any hit counts
  options.carve_free_space = true;
  options.keep_hits = keep_hits;
  return options;
}

Path rows(const std::vector<Point>& points) {
  Path path(points.size(), 3);
  for (std::size_t i = 0; i < points.size(); ++i) path.row(i) = points[i].transpose();
  return path;
}

Key key_of(const Point& point, double edge) {
  return {static_cast<int>(std::floor(point.x() / edge)),
          static_cast<int>(std::floor(point.y() / edge)),
          static_cast<int>(std::floor(point.z() / edge))};
}

/// Whether a segment runs through the inside of a voxel, by its slabs.
bool passes(const Point& a, const Point& b, const Key& key, double edge) {
  double enter = 0.0;
  double leave = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = (key[axis] * edge - a[axis]) / (b[axis] - a[axis]);
    const double high = ((key[axis] + 1) * edge - a[axis]) / (b[axis] - a[axis]);
    enter = std::max(enter, std::min(low, high));
    leave = std::min(leave, std::max(low, high));
  }
  return leave - enter > 1e-11;
}

/// The rules of carving, word by word, on a table.
struct SlowCarver {
  ObstacleMapOptions options;
  double edge;
  std::map<Key, float> log_odds;

  void insert(const GridFrame& window, const Point& origin, const std::vector<Point>& hits,
              const std::vector<Point>& misses) {
    std::set<Key> hit;
    for (const Point& point : hits) {
      if ((point - origin).norm() < options.max_range && window.contains(point)) {
        hit.insert(key_of(point, edge));
      }
    }
    std::vector<Point> ends = hits;
    ends.insert(ends.end(), misses.begin(), misses.end());
    std::set<Key> followed, passed;
    for (Point end : ends) {
      const double length = (end - origin).norm();
      if (length > options.max_range) end = origin + (options.max_range / length) * (end - origin);
      const Key last = key_of(end, edge);
      if (window.contains(end) && !followed.insert(last).second) continue;
      const Key from = key_of(origin.cwiseMin(end), edge);
      const Key to = key_of(origin.cwiseMax(end), edge);
      for (Key key = from; key[0] <= to[0]; ++key[0]) {
        for (key[1] = from[1]; key[1] <= to[1]; ++key[1]) {
          for (key[2] = from[2]; key[2] <= to[2]; ++key[2]) {
            if (key != last && passes(origin, end, key, edge)) passed.insert(key);
          }
        }
      }
    }
    const float hit_vote = static_cast<float>(options.hit_log_odds);
    const float miss_vote = static_cast<float>(options.miss_log_odds);
    for (const Key& key : hit) {
      float& value = log_odds[key];
      if (options.keep_hits && value < 0) value = 0;
      value = std::min(value + hit_vote, static_cast<float>(options.max_log_odds));
    }
    for (const Key& key : passed) {
      if (hit.count(key) > 0) continue;
      float& value = log_odds[key];
      if (options.keep_hits && value > 0) continue;
      value = std::max(value + miss_vote, static_cast<float>(options.min_log_odds));
    }
    forget(window);
  }

  void forget(const GridFrame& window) {
    for (auto it = log_odds.begin(); it != log_odds.end();) {
      it = window.contains(centre(it->first)) ? std::next(it) : log_odds.erase(it);
    }
  }
  Point centre(const Key& key) const {
    return (Point(key[0], key[1], key[2]).array() + 0.5) * edge;
  }
};

void expect_equal(const ObstacleMap& map, const SlowCarver& slow) {
  const GridFrame& frame = map.voxels().frame();
  OccupancyGrid occupied(map.occupied().frame());
  std::int64_t known = 0;
  for (std::int64_t i = 0; i < frame.size(); ++i) {
    const Cell voxel = frame.cell_at(i);
    const Point centre = frame.centre(voxel);
    const auto it = slow.log_odds.find(key_of(centre, slow.edge));
    const double expected = it == slow.log_odds.end() ? 0.0 : it->second;
    ASSERT_EQ(map.log_odds_at(centre), expected) << centre.transpose();
    ASSERT_EQ(map.voxels().blocked(voxel), expected > 0.0);
    if (expected > 0.0) occupied.set(occupied.frame().cell_of(centre));
    known += expected != 0.0;
  }
  ASSERT_EQ(known, static_cast<std::int64_t>(slow.log_odds.size()));
  ASSERT_TRUE(map.occupied() == occupied);
  ASSERT_TRUE(map.blocked() == test::to_be_blocked(map));
}

TEST(Carving, EqualsATableOfWorldVoxelsWhereverTheWindowRolls) {
  for (const bool keep_hits : {true, false}) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    const auto vector = [&](double x, double y, double z) {
      return Point(x * normal(random), y * normal(random), z * normal(random));
    };
    ObstacleMapOptions options = carving_map(keep_hits);
    options.remember = false;
    Point centre(-311.0, 77.0, 40.0);
    ObstacleMap map(options, centre);
    SlowCarver slow{options, map.voxel_size(), {}};
    std::int64_t erased = 0;
    std::vector<Point> wall;
    for (int i = 0; i < 12; ++i) wall.push_back(centre + vector(8, 8, 6));
    for (int step = 0; step < 60; ++step) {
      // Sometimes far; sometimes the sensor itself is outside the window.
      centre += (step % 20 == 19 ? 8.0 : 0.5) * vector(2, 2, 4);
      map.recentre(centre);
      slow.forget(map.voxels().frame());
      const Point origin = centre + (step % 10 == 9 ? 20.0 : 1.0) * vector(1, 1, 1);
      std::vector<Point> hits, misses;
      for (const Point& point : wall) hits.push_back(point + vector(0.3, 0.3, 0.3));
      for (int i = 0; i < 12; ++i) hits.push_back(origin + vector(9, 9, 9));
      for (int i = 0; i < 12; ++i) {
        misses.push_back(origin + (i % 3 == 0 ? 3.0 : 1.0) * options.max_range *
                                      vector(1, 1, 1).normalized());
      }
      const std::int64_t before = map.occupied().count();
      const InsertStatistics statistics = map.insert(origin, rows(hits), rows(misses));
      slow.insert(map.voxels().frame(), origin, hits, misses);
      expect_equal(map, slow);
      EXPECT_EQ(statistics.new_cells - statistics.erased_cells, map.occupied().count() - before);
      erased += statistics.erased_cells;
    }
    if (keep_hits) {
      EXPECT_EQ(erased, 0);
    } else {
      EXPECT_GT(erased, 50);
    }
    EXPECT_GT(slow.log_odds.size(), 500u);
    map.clear();
    slow.log_odds.clear();
    expect_equal(map, slow);
  }
}

TEST(Carving, WithoutKeepingHitsItIsOctoMap) {
  octomap::OcTree tree(2.0);
  ObstacleMapOptions options;
  options.dims = {40, 40, 20};
  options.max_range = 60.0;
  options.blind_distance = 0.0;  // as OctoMap's
  options.carve_free_space = true;
  options.keep_hits = false;
  options.hit_log_odds = tree.getProbHitLog();
  options.miss_log_odds = tree.getProbMissLog();
  options.min_log_odds = tree.getClampingThresMinLog();
  options.max_log_odds = tree.getClampingThresMaxLog();
  ObstacleMap map(options);
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal;
  for (int scan = 0; scan < 30; ++scan) {
    const auto vector = [&](float size) {
      return octomap::point3d(size * static_cast<float>(normal(random)),
                              size * static_cast<float>(normal(random)),
                              size * static_cast<float>(normal(random)));
    };
    const octomap::point3d origin = vector(3.0f);
    octomap::Pointcloud cloud;
    std::vector<Point> hits;
    std::set<Key>
        ends;  // OctoMap follows every ray, so one ray an end voxel makes the two comparable
    while (hits.size() < 150) {
      const octomap::point3d point = origin + vector(7.0f);
      const Point hit(point.x(), point.y(), point.z());
      if (!map.occupied().frame().contains(hit) || !ends.insert(key_of(hit, 2.0)).second) continue;
      cloud.push_back(point);
      hits.push_back(hit);
    }
    map.insert(Point(origin.x(), origin.y(), origin.z()), rows(hits));
    octomap::KeySet free, occupied;
    tree.computeUpdate(cloud, origin, free, occupied, -1.0);
    for (const octomap::OcTreeKey& key : free) tree.updateNode(key, false);
    for (const octomap::OcTreeKey& key : occupied) tree.updateNode(key, true);
  }
  int known = 0;
  const GridFrame& frame = map.voxels().frame();
  for (std::int64_t i = 0; i < frame.size(); ++i) {
    const Point centre = frame.centre(frame.cell_at(i));
    const octomap::OcTreeNode* node = tree.search(centre.x(), centre.y(), centre.z());
    ASSERT_EQ(map.log_odds_at(centre), node == nullptr ? 0.0 : node->getLogOdds())
        << centre.transpose();
    known += node != nullptr;
  }
  EXPECT_GT(known, 1000);
}

/// A pole one voxel thick 10 m ahead, a wall 20 m ahead; the pole is hit once, then rays pass it to
/// the wall.
struct PoleScene {
  Point sensor{1, 1, 1};
  Point pole{11, 1, 1};
  Path wall = Path(40, 3);

  PoleScene() {
    for (int i = 0; i < wall.rows(); ++i) wall.row(i) = Point(21, 0.05 * i + 0.01, 1.0).transpose();
  }
  ObstacleMap map(bool carve, bool keep_hits) const {
    ObstacleMapOptions options = carving_map(keep_hits);
    options.carve_free_space = carve;
    options.dims = {40, 10, 5};
    return ObstacleMap(options, sensor);
  }
};

TEST(Carving, AThinPoleIsNotErasedByRaysThatPassIt) {
  const PoleScene scene;
  for (const bool carve : {false, true}) {
    ObstacleMap map = scene.map(carve, true);
    map.insert(scene.sensor, scene.pole.transpose());
    for (int scan = 0; scan < 100; ++scan) {
      EXPECT_EQ(map.insert(scene.sensor, scene.wall).erased_cells, 0);
    }
    EXPECT_TRUE(map.occupied().blocked_at(scene.pole));
    EXPECT_DOUBLE_EQ(map.log_odds_at(scene.pole), carve ? 0.85f : 0.85);
    EXPECT_EQ(map.log_odds_at(Point(6, 1, 1)), carve ? -2.0 : 0.0);
  }
}

TEST(Carving, OctoMapsRuleErasesThePoleWithThreeScans) {
  const PoleScene scene;
  ObstacleMap map = scene.map(true, false);
  map.insert(scene.sensor, scene.pole.transpose());
  EXPECT_EQ(map.insert(scene.sensor, scene.wall).erased_cells, 0);
  EXPECT_EQ(map.insert(scene.sensor, scene.wall).erased_cells, 0);
  EXPECT_EQ(map.version(), 2) << "pole, wall";
  EXPECT_EQ(map.insert(scene.sensor, scene.wall).erased_cells, 1);
  EXPECT_EQ(map.version(), 3);
  EXPECT_FALSE(map.occupied().blocked_at(scene.pole));
  EXPECT_FALSE(map.blocked().blocked_at(scene.pole));
  EXPECT_TRUE(map.blocked().blocked_at(Point(21, 1, 1)));
}

TEST(Carving, AHitWinsOverAllRaysThatPassInTheSameScan) {
  const PoleScene scene;
  for (const bool keep_hits : {true, false}) {
    ObstacleMap map = scene.map(true, keep_hits);
    Path hits(scene.wall.rows() + 1, 3);
    hits << scene.wall, scene.pole.transpose();
    for (int scan = 0; scan < 10; ++scan) map.insert(scene.sensor, hits);
    EXPECT_EQ(map.log_odds_at(scene.pole), 3.5) << keep_hits;  // clamped, and no vote against it
  }
}

TEST(Carving, AKeptHitOutweighsAllThatPassedBefore) {
  const PoleScene scene;
  ObstacleMap keeping = scene.map(true, true);
  ObstacleMap forgetting = scene.map(true, false);
  for (ObstacleMap* map : {&keeping, &forgetting}) {
    for (int scan = 0; scan < 100; ++scan) map->insert(scene.sensor, scene.wall);
    EXPECT_EQ(map->log_odds_at(scene.pole), -2.0);
    map->insert(scene.sensor, scene.pole.transpose());
  }
  EXPECT_TRUE(keeping.occupied().blocked_at(scene.pole));
  EXPECT_FALSE(forgetting.occupied().blocked_at(scene.pole));
}

TEST(Carving, StrangeRaysAreHarmless) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  ObstacleMapOptions options = carving_map(true);
  for (const double range : {25.0, 1e15, 1e300}) {
    options.max_range = range;
    ObstacleMap map(options);
    const Path strange = rows({{kNan, 0, 0},
                               {kInfinity, 0, 0},
                               {1e300, 1e300, -1e300},
                               {-1.7e308, 0, 0},
                               {0, 0, 0},
                               {1e12, 1e12, 1e12},
                               {2, 2, 2},
                               {0, -24, 0}});
    for (const Point& origin :
         {Point(0, 0, 0), Point(1.7e308, 0, 0), Point(1e13, 3, -1e11), Point(2, 2, 2)}) {
      const InsertStatistics statistics = map.insert(origin, strange, strange);
      EXPECT_EQ(statistics.invalid, 4);
      EXPECT_EQ(statistics.marked + statistics.outside + statistics.out_of_range, 6);
      EXPECT_TRUE(map.blocked() == test::to_be_blocked(map));
    }
    EXPECT_TRUE(map.occupied().blocked_at(Point(2, 2, 2)));
    EXPECT_LT(map.log_odds_at(Point(0.1, -9, 0.1)), 0.0);
  }
}

}  // namespace
}  // namespace ltp
