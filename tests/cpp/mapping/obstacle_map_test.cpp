// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The obstacle map against a plain set of world voxels: whatever is inserted, wherever the window
// rolls.
#include "ltp/mapping/obstacle_map.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "mapping/promises.hpp"

namespace ltp {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
using Key = std::array<int, 3>;  // a voxel, counted from the world's origin

ObstacleMapOptions small_map() {
  ObstacleMapOptions options;
  options.dims = {20, 16, 10};
  options.max_range = 30.0;
  options.blind_distance = 0.0;  // any hit counts
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

/// The map's promises, checked slowly against the set of voxels that were ever hit and never left
/// the window.
void expect_equal(const ObstacleMap& map, std::set<Key>& hit, const std::array<int, 3>& ratio) {
  const double edge = map.voxel_size();
  const GridFrame& frame = map.voxels().frame();
  for (auto it = hit.begin(); it != hit.end();) {
    const Point centre = (Point((*it)[0], (*it)[1], (*it)[2]).array() + 0.5) * edge;
    it = frame.contains(centre) ? std::next(it) : hit.erase(it);
  }
  ASSERT_EQ(map.voxels().count(), static_cast<std::int64_t>(hit.size()));
  OccupancyGrid occupied(map.occupied().frame());
  for (const Key& key : hit) {
    const Point centre = (Point(key[0], key[1], key[2]).array() + 0.5) * edge;
    ASSERT_TRUE(map.voxels().blocked_at(centre));
    const Cell voxel = frame.cell_of(centre);
    occupied.set(Cell(voxel.x() / ratio[0], voxel.y() / ratio[1], voxel.z() / ratio[2]));
    ASSERT_TRUE(map.occupied().blocked_at(centre));
  }
  ASSERT_TRUE(map.occupied() == occupied);
  ASSERT_TRUE(map.blocked() == test::to_be_blocked(map));
  const Point low = map.occupied().frame().origin() - frame.origin();
  ASSERT_LT(low.norm(), 1e-9);
}

TEST(ObstacleMap, IsTheSetOfVoxelsThatWereHitAndNeverLeftTheWindow) {
  struct Case {
    Point cell;
    std::array<int, 3> ratio;
    double radius;
    double margin;
    bool whole_cells;
  };
  const Case cases[] = {
      {{2, 2, 4}, {1, 1, 2}, 0.75, 0.25, true},     {{2, 2, 4}, {1, 1, 2}, 1.0, 0.5, false},
      {{2, 2, 2}, {1, 1, 1}, 0.0, 0.0, false},      {{0.9, 0.3, 0.6}, {3, 1, 2}, 1.0, 0.0, false},
      {{0.9, 0.3, 0.6}, {3, 1, 2}, 1.0, 0.0, true}, {{2, 2, 4}, {1, 1, 2}, 3.0, 2.0, false}};
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  int scans = 0;
  for (const Case& test : cases) {
    ObstacleMapOptions options = small_map();
    options.cell = test.cell;
    options.inflation_radius = test.radius;
    options.margin = test.margin;
    options.inflate_whole_cells = test.whole_cells;
    options.remember = false;
    options.max_range = 10.0 * test.cell.x();
    const double edge = test.cell.minCoeff();
    Point centre(1e3 * normal(random), 1e3 * normal(random), 50.0);
    ObstacleMap map(options, centre);
    std::set<Key> hit;
    for (int step = 0; step < 60; ++step) {
      // Mostly by a cell or so, now and then far beyond the window, or back and forth.
      const double stride = step % 20 == 19 ? 30.0 : step % 7 == 6 ? 6.0 : 0.7;
      const Point old = map.occupied().frame().origin();
      centre +=
          stride * Point(normal(random), normal(random), normal(random)).cwiseProduct(test.cell);
      const Cell shift = map.recentre(centre);
      const GridFrame& frame = map.occupied().frame();
      ASSERT_LT((frame.origin() - old - shift.cast<double>().cwiseProduct(test.cell)).norm(), 1e-9);
      ASSERT_LE(((frame.origin() + frame.upper()) / 2 - centre)
                    .cwiseQuotient(test.cell)
                    .cwiseAbs()
                    .maxCoeff(),
                0.5 + 1e-9);
      expect_equal(map, hit, test.ratio);

      std::vector<Point> hits;
      InsertStatistics expected;
      const Point origin = centre + Point(normal(random), normal(random), normal(random));
      std::set<Key> cells_before;
      for (int i = 0; i < 40; ++i) {
        const Point point =
            origin +
            6.0 * Point(normal(random), normal(random), normal(random)).cwiseProduct(test.cell);
        hits.push_back(point);
        if ((point - origin).norm() >= options.max_range) {
          ++expected.out_of_range;
        } else if (!frame.contains(point)) {
          ++expected.outside;
        } else {
          ++expected.marked;
          hit.insert(key_of(point, edge));
        }
      }
      const std::int64_t before = map.occupied().count();
      const InsertStatistics statistics = map.insert(origin, rows(hits));
      EXPECT_EQ(statistics.marked, expected.marked);
      EXPECT_EQ(statistics.outside, expected.outside);
      EXPECT_EQ(statistics.out_of_range, expected.out_of_range);
      EXPECT_EQ(statistics.invalid, 0);
      EXPECT_EQ(statistics.new_cells, map.occupied().count() - before);
      EXPECT_EQ(statistics.erased_cells, 0);
      expect_equal(map, hit, test.ratio);
      ++scans;
    }
    map.clear();
    hit.clear();
    expect_equal(map, hit, test.ratio);
  }
  EXPECT_EQ(scans, 360);
}

TEST(ObstacleMap, AReturnAtTheMaximumRangeMarksNothing) {
  std::mt19937_64 random(6);
  std::normal_distribution<double> normal;
  const ObstacleMapOptions options = small_map();
  for (int i = 0; i < 1000; ++i) {
    const Point origin = 3.0 * Point(normal(random), normal(random), normal(random));
    ObstacleMap map(options, origin);
    const Point direction =
        Point(normal(random), normal(random), 0.3 * normal(random)).normalized();
    // Rounding may put it a little nearer than the maximum range: that is still the maximum range.
    const InsertStatistics statistics =
        map.insert(origin, Path((origin + options.max_range * direction).transpose()));
    ASSERT_EQ(statistics.out_of_range, 1);
    ASSERT_EQ(statistics.marked, 0);
    ASSERT_EQ(map.voxels().count(), 0);
  }
  ObstacleMap map(options);
  EXPECT_EQ(
      map.insert(Point::Zero(), Eigen::RowVector3d(0, 0, options.max_range - 1e-6)).out_of_range,
      0);
  EXPECT_EQ(map.insert(Point::Zero(), Eigen::RowVector3d(5, 0, 0)).marked, 1);
}

TEST(ObstacleMap, CountsStrangePointsAndGoesOn) {
  ObstacleMap map(small_map());
  const Path hits = rows({{kNan, 0, 0},
                          {1, kInfinity, 0},
                          {0, 0, -kInfinity},
                          {-5, -5, -5},
                          {1e300, 0, 0},
                          {1e200, -1e200, 1e200},
                          {-0.0, 3, 1},
                          {0, 0, 25}});
  const Path misses = rows({{kNan, kNan, kNan}, {1, 2, 3}, {0, kInfinity, 0}});
  const InsertStatistics statistics = map.insert(Point::Zero(), hits, misses);
  EXPECT_EQ(statistics.invalid, 3 + 2);
  EXPECT_EQ(statistics.out_of_range, 2);
  EXPECT_EQ(statistics.outside, 1);  // the window ends 20 m above
  EXPECT_EQ(statistics.marked, 2);
  EXPECT_EQ(statistics.new_cells, 2);
  EXPECT_TRUE(map.occupied().blocked_at(Point(-5, -5, -5)));
  EXPECT_TRUE(map.occupied().blocked_at(Point(0, 3, 1)));
  EXPECT_EQ(map.voxels().count(), 2);
  EXPECT_EQ(map.insert(Point::Zero(), Path(0, 3), Path(0, 3)).marked, 0);
  EXPECT_THROW(map.insert(Point(kNan, 0, 0), Path(0, 3)), std::invalid_argument);
}

TEST(ObstacleMap, TwoMapsOfOneWorldShareTheirCells) {
  ObstacleMapOptions options = small_map();
  ObstacleMap a(options, Point(0.3, 0.9, -1.1));
  const ObstacleMap b(options, Point(11.7, -4.2, 7.9));
  a.recentre(Point(11.7, -4.2, 7.9));
  EXPECT_TRUE(a.occupied().frame() == b.occupied().frame());
  EXPECT_TRUE(a.voxels().frame() == b.voxels().frame());
}

TEST(ObstacleMap, ACopyIsASnapshot) {
  ObstacleMap map(small_map());
  map.insert(Point::Zero(), Eigen::RowVector3d(5, 5, 5));
  const ObstacleMap snapshot = map;
  map.insert(Point::Zero(), Eigen::RowVector3d(-5, 5, 5));
  map.recentre(Point(100, 0, 0));
  EXPECT_EQ(snapshot.voxels().count(), 1);
  EXPECT_TRUE(snapshot.blocked().blocked_at(Point(5, 5, 5)));
  EXPECT_EQ(map.voxels().count(), 0);
}

TEST(ObstacleMap, CountsWhatChangesTheMeaningOfItsCells) {
  const std::string path = testing::TempDir() + "ltp_version.bt";
  ObstacleMap map(small_map());
  const Eigen::RowVector3d hit(5, 5, 5);
  EXPECT_EQ(map.version(), 0);
  map.clear();
  map.insert(Point::Zero(), Path(0, 3));
  EXPECT_EQ(map.version(), 0) << "it was empty before";
  map.insert(Point::Zero(), hit);
  EXPECT_EQ(map.version(), 1);
  map.insert(Point::Zero(), hit);
  EXPECT_EQ(map.version(), 1) << "nothing new";
  map.save(path);
  map.recentre(Point(4, 0, 0));
  map.load(path);
  EXPECT_EQ(map.version(), 1) << "the cell is known";
  map.clear();
  EXPECT_EQ(map.version(), 2);
  map.load(path);
  EXPECT_EQ(map.version(), 3);
  EXPECT_EQ(ObstacleMap(map).version(), 3);
}

TEST(ObstacleMap, AVehicleInAFreeCellTouchesNoVoxel) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::normal_distribution<double> normal;
  const auto vector = [&] { return Point(normal(random), normal(random), normal(random)); };
  for (const Point& cell : {Point(2, 2, 4), Point(1.5, 0.5, 1.0)}) {
    ObstacleMapOptions options = small_map();
    options.cell = cell;
    for (const double radius : {0.3, 1.0, 2.5}) {
      options.inflation_radius = 0.8 * radius;
      options.margin = 0.2 * radius;
      ObstacleMap map(options);
      std::vector<Point> hits;
      for (int i = 0; i < 30; ++i) hits.push_back(8.0 * vector());
      map.insert(Point::Zero(), rows(hits));
      int inside = 0;
      for (int i = 0; i < 20000; ++i) {
        const Cell voxel = map.voxels().frame().cell_of(hits[i % hits.size()]);
        if (!map.voxels().frame().contains(voxel)) continue;
        const Point within(unit(random) - 0.5, unit(random) - 0.5, unit(random) - 0.5);
        const Point place = map.voxels().frame().centre(voxel) + map.voxel_size() * within;
        const Point vehicle = place + radius * unit(random) * vector().normalized();
        if (!map.blocked().frame().contains(vehicle)) continue;
        ++inside;
        ASSERT_TRUE(map.blocked().blocked_at(vehicle));
      }
      EXPECT_GT(inside, 2000);
    }
  }
}

TEST(ObstacleMap, MeasuresFromTheVoxelNotFromItsCell) {
  ObstacleMapOptions options = small_map();
  const Eigen::RowVector3d hit(1, 1, 1);  // the lower voxel of a cell 4 m high
  const ObstacleMap whole = [&] {
    options.inflate_whole_cells = true;
    ObstacleMap map(options);
    map.insert(Point::Zero(), hit);
    return map;
  }();
  options.inflate_whole_cells = false;
  ObstacleMap map(options);
  map.insert(Point::Zero(), hit);
  EXPECT_EQ(whole.blocked().count(), 27);
  EXPECT_EQ(map.blocked().count(), 18);
  EXPECT_TRUE(whole.blocked().blocked_at(Point(1, 1, 5)));
  EXPECT_FALSE(map.blocked().blocked_at(Point(1, 1, 5)));  // two metres above the voxel
  EXPECT_TRUE(map.blocked().blocked_at(Point(1, 1, -1)));  // touches it
  const std::int64_t before = map.version();
  const InsertStatistics statistics = map.insert(Point::Zero(), Eigen::RowVector3d(1, 1, 3));
  EXPECT_EQ(statistics.new_cells, 0) << "the upper voxel of the same cell";
  EXPECT_EQ(map.blocked().count(), 27);
  EXPECT_EQ(map.version(), before + 1) << "what is blocked has changed";
}

TEST(ObstacleMap, SensesByRecentringAndInserting) {
  ObstacleMap map(small_map()), expected(small_map());
  for (const double x : {0.0, 0.1, 30.0}) {
    const Point origin(x, 0, 0);
    const Eigen::RowVector3d hit(x + 5, 5, 5);
    const InsertStatistics statistics = map.sense(origin, hit, Path(0, 3));
    expected.recentre(origin);
    EXPECT_EQ(statistics.new_cells, expected.insert(origin, hit).new_cells);
    EXPECT_TRUE(map.voxels() == expected.voxels());
    EXPECT_TRUE(map.blocked() == expected.blocked());
  }
  EXPECT_THROW(map.sense(Point(kNan, 0, 0), Path(0, 3), Path(0, 3)), std::invalid_argument);
}

TEST(ObstacleMap, RefusesToGoWhereCoordinatesEnd) {
  ObstacleMap map(small_map());
  map.insert(Point::Zero(), Eigen::RowVector3d(5, 5, 5));
  for (const Point& centre : {Point(kNan, 0, 0), Point(0, kInfinity, 0), Point(1e12, 0, 0),
                              Point(0, 0, 3e9) /* cells still fit, voxels do not */}) {
    EXPECT_THROW(map.recentre(centre), std::invalid_argument) << centre.transpose();
    EXPECT_THROW(ObstacleMap(small_map(), centre), std::invalid_argument) << centre.transpose();
  }
  EXPECT_EQ(map.voxels().count(), 1);
  EXPECT_TRUE(map.blocked().blocked_at(Point(5, 5, 5)));

  ObstacleMapOptions high = small_map();
  high.cell.z() = 20.0;  // ten voxels: 9e8 cells fit, 9e9 voxels wrap round in an int
  ObstacleMap tall(high);
  EXPECT_THROW(tall.recentre(Point(0, 0, 1.8e10)), std::invalid_argument);
  EXPECT_THROW(ObstacleMap(high, Point(0, 0, 1.8e10)), std::invalid_argument);
}

TEST(ObstacleMapOptions, NamesTheFieldThatIsWrong) {
  struct Case {
    const char* field;
    void (*spoil)(ObstacleMapOptions&);
  };
  const Case cases[] = {
      {"cell.x", [](ObstacleMapOptions& o) { o.cell.x() = 0; }},
      {"cell.y", [](ObstacleMapOptions& o) { o.cell.y() = -2; }},
      {"cell.z", [](ObstacleMapOptions& o) { o.cell.z() = kNan; }},
      {"cell.z", [](ObstacleMapOptions& o) { o.cell.z() = 3; }},  // no multiple of 2 m
      {"cell.x", [](ObstacleMapOptions& o) { o.cell = Point(0.30001, 0.1, 0.1); }},
      {"dims.x", [](ObstacleMapOptions& o) { o.dims[0] = 0; }},
      {"dims.z", [](ObstacleMapOptions& o) { o.dims[2] = -4; }},
      {"dims",
       [](ObstacleMapOptions& o) {
         o.dims = {100000, 100000, 1};
       }},
      {"dims", [](ObstacleMapOptions& o) { o.cell.z() = 2e9; }},  // 10^9 voxels high, each
      {"dims", [](ObstacleMapOptions& o) { o.cell = Point(1e-300, 1, 1); }},
      {"inflation_radius", [](ObstacleMapOptions& o) { o.inflation_radius = -1; }},
      {"inflation_radius", [](ObstacleMapOptions& o) { o.inflation_radius = kInfinity; }},
      {"margin", [](ObstacleMapOptions& o) { o.margin = -0.1; }},
      {"max_range", [](ObstacleMapOptions& o) { o.max_range = 0; }},
      {"max_range", [](ObstacleMapOptions& o) { o.max_range = kNan; }},
      {"hit_log_odds", [](ObstacleMapOptions& o) { o.hit_log_odds = -0.1; }},
      {"miss_log_odds", [](ObstacleMapOptions& o) { o.miss_log_odds = 0.4; }},
      {"min_log_odds", [](ObstacleMapOptions& o) { o.min_log_odds = kNan; }},
      {"max_log_odds", [](ObstacleMapOptions& o) { o.max_log_odds = 0; }},
  };
  for (const Case& test : cases) {
    ObstacleMapOptions options;
    test.spoil(options);
    try {
      ObstacleMap map(options);
      ADD_FAILURE() << test.field << " was accepted";
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(std::string(error.what()).rfind(std::string(test.field) + " = ", 0), 0u)
          << error.what();
    }
  }
  EXPECT_NO_THROW(ObstacleMapOptions().check());
}

TEST(ObstacleMap, TakesNoOwnReturnForAnObstacle) {
  ObstacleMapOptions options = small_map();
  options.blind_distance = 1.0;
  options.body_min = Point(-1.0, -3.0, -1.0);
  options.body_max = Point(2.5, 3.0, 1.0);
  Pose sensor;
  sensor.position = Point(100.3, -40.2, 20.1);
  sensor.world_from_body = Eigen::AngleAxisd(0.5, Point(1, 2, 3).normalized());
  const std::vector<std::pair<Point, char>> returns = {
      {{0, 0, 0}, 'n'},      {{0.42, 0.42, 0}, 'n'}, {{0, 0, -0.999}, 'n'}, {{0, 2.9, 0.9}, 'b'},
      {{2.4, 0, -0.9}, 'b'}, {{-1.1, 0, 0}, 'm'},    {{2.6, 0, 0}, 'm'},    {{0, 3.1, 0}, 'm'},
      {{0, 0, 1.1}, 'm'},    {{8, 0, 0}, 'm'},       {{29, 29, 0}, 'r'}};
  Path hits(returns.size(), 3);
  Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor> floats(returns.size(), 3);
  for (std::size_t i = 0; i < returns.size(); ++i) {
    hits.row(i) = (sensor.position + sensor.world_from_body * returns[i].first).transpose();
    floats.row(i) = hits.row(i).cast<float>();
  }
  for (const bool carve : {false, true}) {
    options.carve_free_space = carve;
    ObstacleMap map(options, sensor.position);
    const InsertStatistics found = map.sense(sensor, hits, PointsView());
    EXPECT_EQ(found.too_near, 3);
    EXPECT_EQ(found.in_body, 2);
    EXPECT_EQ(found.marked, 5);
    EXPECT_EQ(found.out_of_range, 1);
    for (std::size_t i = 0; i < returns.size(); ++i) {
      if (returns[i].second == 'm') {
        EXPECT_TRUE(map.voxels().blocked_at(Point(hits.row(i).transpose())));
      }
    }
    ObstacleMap of_floats(options, sensor.position);
    EXPECT_EQ(of_floats.sense(sensor, floats, PointsView()).marked, 5);
    EXPECT_EQ(of_floats.voxels(), map.voxels());
    EXPECT_EQ(map.totals().too_near, 3);
    map.sense(sensor, hits, PointsView());
    EXPECT_EQ(map.totals().too_near, 6);
  }
}

TEST(ObstacleMap, SaysWhatItLoses) {
  ObstacleMapOptions options = small_map();
  options.blind_distance = 1.0;
  ObstacleMap map(options);
  map.insert(Point(0, 0, 0), rows({{5, 5, 5}, {6, 0, 0}}));
  EXPECT_TRUE(map.totals().warnings(options).empty());
  options.remember = false;
  map.insert(Point(0, 0, 0), rows({{40, 0, 0}, {0, 0, 25}, {0, 0, 0}}));
  const std::vector<std::string> sentences = map.totals().warnings(options);
  ASSERT_EQ(sentences.size(), 3u);
  EXPECT_EQ(sentences[0].find("1 of 5 hits lie at or beyond the map's max_range of 30 m"), 0u);
  EXPECT_NE(sentences[1].find("window of 40 m x 32 m x 40 m"), std::string::npos);
  EXPECT_NE(sentences[2].find("blind_distance of 1 m"), std::string::npos);
  options.remember = true;
  EXPECT_EQ(map.totals().warnings(options).size(), 2u) << "what lies beyond the window is kept";
}

TEST(ObstacleMap, RefusesToBeBlind) {
  for (const double distance : {-1.0, kNan, kInfinity, 30.0, 31.0}) {
    ObstacleMapOptions options = small_map();
    options.blind_distance = distance;
    EXPECT_THROW(ObstacleMap{options}, std::invalid_argument) << distance;
  }
  ObstacleMapOptions options = small_map();
  options.body_max = Point(1, 1, 0);  // flat
  EXPECT_THROW(ObstacleMap{options}, std::invalid_argument);
  options.body_max = Point(1, kNan, 1);
  EXPECT_THROW(ObstacleMap{options}, std::invalid_argument);
}

}  // namespace
}  // namespace ltp
