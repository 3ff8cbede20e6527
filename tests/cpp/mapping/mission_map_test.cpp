// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The mission: the window is a part of a map without limit, wherever it was in the meantime.
#include "ltp/mapping/mission_map.hpp"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "allocations.hpp"
#include "mapping/promises.hpp"

namespace ltp {
namespace {

using Random = std::mt19937_64;

/// Scans reach no further than the window, wherever in its middle they begin.
ObstacleMapOptions small_map(const Point& cell) {
  ObstacleMapOptions options;
  options.cell = cell;
  options.dims = {20, 16, 10};
  options.max_range = std::min({8.0 * cell.x(), 7.0 * cell.y(), 4.0 * cell.z()}) - cell.maxCoeff();
  options.blind_distance = 0.0;
  return options;
}

Path random_ends(const Point& origin, double range, int count, Random& random) {
  std::normal_distribution<double> normal;
  Path ends(count, 3);
  for (int i = 0; i < count; ++i) {
    const Point offset(normal(random), normal(random), normal(random));
    ends.row(i) = (origin + 0.6 * range * offset).transpose();
  }
  return ends;
}

/// A window's part of a map that holds all of it.
void expect_part(const ObstacleMap& map, const ObstacleMap& all) {
  const auto expect_grid = [](const OccupancyGrid& part, const OccupancyGrid& whole) {
    const Cell offset = part.frame().first() - whole.frame().first();
    for (std::int64_t i = 0; i < part.frame().size(); ++i) {
      const Cell cell = part.frame().cell_at(i);
      ASSERT_TRUE(whole.frame().contains(Cell(cell + offset)));
      ASSERT_EQ(part.blocked(cell), whole.blocked(cell + offset)) << cell.transpose();
    }
  };
  expect_grid(map.voxels(), all.voxels());
  expect_grid(map.occupied(), all.occupied());
  expect_grid(map.blocked(), all.blocked());
  for (std::int64_t i = 0; i < map.voxels().frame().size(); i += 7) {
    const Point centre = map.voxels().frame().centre(map.voxels().frame().cell_at(i));
    ASSERT_EQ(map.log_odds_at(centre), all.log_odds_at(centre)) << centre.transpose();
  }
}

/// What is blocked in a window is blocked in the grid of all, and what is not, is not.
void expect_part_of(const OccupancyGrid& part, const OccupancyGrid& all) {
  const Cell offset = part.frame().first() - all.frame().first();
  for (std::int64_t i = 0; i < part.frame().size(); ++i) {
    const Cell cell = part.frame().cell_at(i);
    const Cell there = cell + offset;
    const bool blocked = all.frame().contains(there) && all.blocked(there);
    ASSERT_EQ(part.blocked(cell), blocked) << cell.transpose();
  }
}

struct Case {
  Point cell;
  double radius;
  bool whole_cells;
  bool carve;
  bool keep_hits;
  Point home;  ///< round which the window walks [m]
};

TEST(MissionMap, TheWindowIsAPartOfAMapWithoutLimit) {
  const Case cases[] = {
      {{2, 2, 4}, 1.0, false, false, true, {0, 0, 0}},
      {{2, 2, 4}, 1.0, true, false, true, {0, 0, 0}},
      {{2, 2, 4}, 6.5, false, false, true, {-300, 77, 40}},
      {{2, 2, 4}, 0.0, false, false, true, {0, 0, 0}},
      {{2, 2, 4}, 1.0, false, true, true, {5, 5, 5}},
      {{2, 2, 4}, 1.0, false, true, false, {5, 5, 5}},
      {{2, 2, 4}, 3.0, true, true, false, {5, 5, 5}},
      {{1.5, 0.5, 1}, 0.7, false, false, true, {0, 0, 0}},
      {{1.5, 0.5, 1}, 0.7, false, true, false, {0, 0, 0}},
      // Where one octree of 32768 voxels each way ends and the next begins.
      {{2, 2, 4}, 3.0, false, false, true, {65536, -65536, 0}},
      {{2, 2, 4}, 3.0, false, true, false, {65536, -65536, 0}},
  };
  Random random(21);
  std::normal_distribution<double> normal;
  int came_back = 0;
  std::int64_t beyond = 0;
  for (const Case& test : cases) {
    ObstacleMapOptions options = small_map(test.cell);
    options.inflation_radius = test.radius;
    options.inflate_whole_cells = test.whole_cells;
    options.carve_free_space = test.carve;
    options.keep_hits = test.keep_hits;
    if (options.keeps_hits_beyond()) options.max_range *= 2.5;  // what lies beyond the window, too
    ObstacleMap map(options, test.home);
    options.dims = {130, 130, 90};
    options.remember = false;
    ObstacleMap all(options, test.home);
    for (int step = 0; step < 50; ++step) {
      // A step, a stride or a leap, never far from home.
      const double stride = step % 10 == 9 ? 12.0 : step % 3 == 2 ? 4.0 : 1.0;
      Point offset(normal(random), normal(random), normal(random));
      offset = (stride * offset).cwiseMax(-25.0).cwiseMin(25.0);
      offset.z() = std::clamp(offset.z(), -15.0, 15.0);
      const Point position = test.home + offset.cwiseProduct(test.cell);
      map.recentre(position);
      came_back += map.voxels().count() > 0 ? 1 : 0;
      ASSERT_NO_FATAL_FAILURE(expect_part(map, all)) << "rolled, step " << step;
      const Path hits = random_ends(position, options.max_range, 12, random);
      const Path misses = random_ends(position, options.max_range, 12, random);
      const InsertStatistics found = map.insert(position, hits, misses);
      ASSERT_EQ(all.insert(position, hits, misses).marked, found.marked + found.outside);
      beyond += found.outside;
      ASSERT_NO_FATAL_FAILURE(expect_part(map, all)) << "scanned, step " << step;
    }
    ASSERT_TRUE(all.blocked() == test::to_be_blocked(all));
    map.clear();
    map.recentre(test.home + test.cell);
    map.recentre(test.home);
    EXPECT_EQ(map.voxels().count() + map.blocked().count(), 0) << "forgotten";
    EXPECT_EQ(map.mission()->nodes(), 0);
  }
  EXPECT_GT(came_back, 400);
  EXPECT_GT(beyond, 200);
}

TEST(MissionMap, RollingToAndFroChangesNothing) {
  Random random(22);
  const ObstacleMapOptions options = small_map(Point(2, 2, 4));
  ObstacleMap map(options);
  for (int i = 0; i < 20; ++i)
    map.insert(Point::Zero(), random_ends(Point::Zero(), 14, 50, random));
  const OccupancyGrid voxels = map.voxels();
  const OccupancyGrid blocked = map.blocked();
  const std::int64_t version = map.version();
  for (const Point& there : {Point(2, 0, 0), Point(-6, 4, 8), Point(0, 0, -4), Point(500, 0, 0)}) {
    const std::int64_t before = test::allocations();
    map.recentre(there);
    map.recentre(Point::Zero());
    EXPECT_EQ(test::allocations() - before, 0);
    EXPECT_TRUE(map.voxels() == voxels && map.blocked() == blocked) << there.transpose();
  }
  EXPECT_EQ(map.version(), version);
  ObstacleMapOptions forgetful = options;
  forgetful.remember = false;
  ObstacleMap paper(forgetful);
  paper.insert(Point::Zero(), Eigen::RowVector3d(5, 5, 5));
  paper.recentre(Point(500, 0, 0));
  paper.recentre(Point::Zero());
  EXPECT_EQ(paper.voxels().count(), 0);
  EXPECT_FALSE(paper.mission().has_value());
}

TEST(MissionMap, AScanThatAddsNothingAllocatesNothing) {
  Random random(23);
  for (const bool carve : {false, true}) {
    ObstacleMapOptions options = small_map(Point(2, 2, 4));
    options.carve_free_space = carve;
    ObstacleMap map(options);
    std::vector<Point> places;
    std::vector<Path> scans;
    for (int i = 0; i < 30; ++i) {
      places.push_back(Point(20 * std::sin(0.2 * i), 20 * std::cos(0.3 * i), 0.3 * i));
      scans.push_back(random_ends(places.back(), options.max_range, 100, random));
    }
    const auto fly = [&] {
      for (std::size_t i = 0; i < scans.size(); ++i) {
        map.recentre(places[i]);
        map.insert(places[i], scans[i]);
      }
    };
    for (int lap = 0; lap < 12; ++lap) fly();  // with carving, until log-odds are at their limits
    const std::int64_t nodes = map.mission()->nodes();
    const std::int64_t before = test::allocations();
    fly();
    EXPECT_EQ(test::allocations() - before, 0) << "carving " << carve;
    EXPECT_EQ(map.mission()->nodes(), nodes);
    EXPECT_GT(map.mission()->bytes(), nodes * 16);
  }
}

TEST(MissionMap, ACopyGoesItsOwnWay) {
  ObstacleMap map(small_map(Point(2, 2, 4)));
  map.insert(Point::Zero(), Eigen::RowVector3d(5, 5, 5));
  ObstacleMap copy = map;
  map.clear();
  copy.recentre(Point(300, 0, 0));
  copy.recentre(Point::Zero());
  EXPECT_EQ(copy.voxels().count(), 1);
  copy.insert(Point::Zero(), Eigen::RowVector3d(-5, 5, 5));
  map = copy;
  copy.clear();
  map.recentre(Point(300, 0, 0));
  EXPECT_EQ(map.log_odds_at(Point(5, 5, 5)), 0.85) << "remembered, beyond the window";
  EXPECT_EQ(map.log_odds_at(Point(7, 5, 5)), 0.0);
  EXPECT_EQ(map.log_odds_at(Point(1e300, 5, 5)), 0.0);
  map.recentre(Point::Zero());
  EXPECT_EQ(map.voxels().count(), 2);
}

TEST(MissionMap, ASecondMissionBeginsWithWhatTheFirstOneSaw) {
  Random random(24);
  const std::string folder = testing::TempDir();
  for (const bool carve : {false, true}) {
    for (const char* name : {"ltp_mission.bt", "ltp_mission.ot"}) {
      ObstacleMapOptions options = small_map(Point(2, 2, 4));
      options.carve_free_space = carve;
      ObstacleMap first(options);
      std::vector<Point> places;
      for (int i = 0; i < 12; ++i) {
        places.push_back(Point(25.0 * i - 120, 10.0 * (i % 3), 4.0 * (i % 5)));
        first.recentre(places.back());
        const Path ends = random_ends(places.back(), options.max_range, 60, random);
        first.insert(places.back(), ends, ends);
      }
      first.save(folder + name);
      ObstacleMap second(options);
      second.load(folder + name);
      const OccupancyGrid everywhere = second.blocked_everywhere(1000).value();
      EXPECT_FALSE(second.blocked_everywhere(100).has_value()) << "it is longer";
      std::int64_t seen = 0;
      for (const Point& place : places) {
        first.recentre(place);
        second.recentre(place);
        ASSERT_TRUE(second.voxels() == first.voxels());
        ASSERT_TRUE(second.occupied() == first.occupied());
        ASSERT_TRUE(second.blocked() == first.blocked()) << "carving " << carve;
        expect_part_of(second.blocked(), everywhere);
        seen += second.voxels().count();
        if (std::string(name) != "ltp_mission.ot") continue;
        for (std::int64_t i = 0; i < first.voxels().frame().size(); i += 11) {
          const Point centre = first.voxels().frame().centre(first.voxels().frame().cell_at(i));
          ASSERT_EQ(second.log_odds_at(centre), first.log_odds_at(centre));
        }
      }
      EXPECT_GT(seen, 300);
      std::filesystem::remove(folder + name);
    }
  }
}

TEST(MissionMap, NothingIsBlockedAnywhereWhereNothingIsKept) {
  ObstacleMapOptions options = small_map(Point(2, 2, 4));
  EXPECT_FALSE(ObstacleMap(options).blocked_everywhere(1000).has_value());
  options.remember = false;
  ObstacleMap forgets(options);
  forgets.insert(Point::Zero(), Eigen::RowVector3d(5, 5, 5));
  EXPECT_FALSE(forgets.blocked_everywhere(1000).has_value());
}

TEST(MissionMap, WhatAFileHoldsNextToTheWindowReachesIn) {
  const std::string path = testing::TempDir() + "ltp_beside.ot";
  const ObstacleMapOptions options = small_map(Point(2, 2, 4));
  ObstacleMap writer(options, Point(20, 0, 0));
  writer.insert(Point(20, 0, 0), Eigen::RowVector3d(21, 1, 1));  // the first column beyond
  writer.save(path);
  for (const bool remember : {true, false}) {
    ObstacleMapOptions reading = options;
    reading.remember = remember;
    ObstacleMap map(reading);
    map.load(path);
    EXPECT_EQ(map.voxels().count(), 0);
    EXPECT_EQ(map.blocked().blocked_at(Point(19, 1, 1)), remember);
    EXPECT_EQ(map.version(), remember ? 1 : 0);
    map.recentre(Point(20, 0, 0));
    EXPECT_EQ(map.voxels().count(), remember ? 1 : 0);
  }
  std::filesystem::remove(path);
}

TEST(MissionMap, RefusesToWriteWhatOctoMapCannotHold) {
  ObstacleMap map(small_map(Point(2, 2, 4)), Point(70000, 0, 0));
  map.insert(Point(70000, 0, 0), Eigen::RowVector3d(70005, 5, 5));
  const std::string path = testing::TempDir() + "ltp_far.bt";
  EXPECT_THROW(map.save(path), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace ltp
