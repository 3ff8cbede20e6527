// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Mapping beside planning: the same decisions where each scan is waited for, safe ones where none
// is.
#include "ltp/navigation/concurrent_trajectory_planner.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "allocations.hpp"
#include "ltp/geometry/polyline.hpp"
#include "ltp/navigation/local_trajectory_planner.hpp"
#include "ltp/planning/planners.hpp"
#include "ltp/sensing/height_surface.hpp"
#include "ltp/sensing/lidar.hpp"

namespace ltp {
namespace {

constexpr double kStep = 0.3;       // 3 m/s at 10 Hz
constexpr double kPatience = 60.0;  // [s]

/// A street between blocks, and a tower in which a waypoint lies.
HeightSurface town() {
  Raster::Values heights = Raster::Values::Zero(260, 160);
  heights.block(60, 30, 20, 60) = 60.0;
  heights.block(120, 70, 30, 60) = 60.0;
  heights.block(170, 20, 24, 70) = 60.0;
  return HeightSurface(Raster(heights, {0, 0}, 1.0));
}

Path route() {
  Path points(4, 3);
  points << 100, 60, 30, 135, 100, 30, 185, 60, 30, 240, 60, 30;
  return points;
}

const Point kStart(20, 60, 30);

ObstacleMapOptions small_map() {
  ObstacleMapOptions options;
  options.dims = {60, 60, 20};  // rolls often
  return options;
}

Raster priority() {
  Raster::Values values(130, 80);
  for (int i = 0; i < 130; ++i) {
    for (int j = 0; j < 80; ++j) values(i, j) = (i * 7 + j * 13) % 10 / 10.0;
  }
  return Raster(values, {0, 0}, 2.0);
}

/// Paths lead straight.
Raster no_priority() { return Raster(Raster::Values::Zero(1, 1), {0, 0}, 1.0); }

ConcurrentTrajectoryPlanner make_concurrent(std::string_view planner = "auto",
                                            const Raster& priorities = priority()) {
  return {make_planner(planner), small_map(), {}, priorities, kStart};
}

Lidar lidar() {
  LidarOptions options;
  options.pattern.azimuths = 180;
  options.pattern.rows = 16;
  return Lidar(options);
}

Eigen::Map<const Path> rows(const std::vector<Point>& points) {
  return {points.empty() ? nullptr : points.front().data(),
          static_cast<Eigen::Index>(points.size()), 3};
}

/// A world, its sensor, and a UAV that flies along whatever path there is, without inertia.
struct Flight {
  HeightSurface surface = town();
  Lidar sensor = lidar();
  Scan scan;
  Point position = kStart;
  std::uint64_t sequence = 0;
  bool collided = false;

  const Scan& look() {
    Pose pose;
    pose.position = position;
    sensor.scan(surface, pose, sequence++, scan);
    return scan;
  }
  void move(const Path& path) {
    if (path.rows() == 0) return;
    const Point next = point_at(path, closest_point(path, position).arc_length + kStep);
    Path step(2, 3);
    step << position.transpose(), next.transpose();
    collided |= surface.first_collision(step).has_value();
    position = next;
  }
};

void expect_same_events(const std::vector<WaypointEvent>& a, const std::vector<WaypointEvent>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].index, b[i].index);
    EXPECT_EQ(a[i].reached, b[i].reached);
    EXPECT_EQ(a[i].reason, b[i].reason);
    EXPECT_EQ(a[i].position, b[i].position);
    EXPECT_EQ(a[i].window_origin, b[i].window_origin);
  }
}

void expect_same_decision(ConcurrentTrajectoryPlanner& concurrent,
                          const LocalTrajectoryPlanner& single) {
  const Decision& decision = concurrent.decision();
  ASSERT_EQ(decision.scan, concurrent.scans());
  ASSERT_EQ(decision.status, single.status());
  ASSERT_EQ(decision.path, single.path()) << "scan " << decision.scan;
  ASSERT_EQ(decision.plans_made, single.plans_made());
  ASSERT_EQ(decision.plans.size(), single.plans().size());
  ASSERT_EQ(decision.waypoint_index, single.waypoint_index());
  ASSERT_FALSE(concurrent.blocked_at().has_value());
}

/// Calls `change` for either kind of planner.
template <typename Change>
void both(ConcurrentTrajectoryPlanner& a, LocalTrajectoryPlanner& b, const Change& change) {
  change(a);
  change(b);
}

/// What a user may do in between: another priority, a map cleared, a map loaded.
template <typename Decide>
void meddle(int step, ConcurrentTrajectoryPlanner& concurrent, LocalTrajectoryPlanner& single,
            const Point& position, const Decide& decide) {
  if (step % 50 == 49) {
    Raster::Values values = priority().values();
    if (step % 100 == 49) values = 1.0 - values;
    const Raster other(values, {0, 0}, 2.0);
    const double keep = step % 100 == 49 ? 0.0 : 0.05;
    both(concurrent, single, [&](auto& ltp) { ltp.set_priority(other, keep); });
  }
  if (step % 50 == 24) {
    PlannerOptions options;
    options.weights = {0.5, step % 100 == 24 ? 2.0 : 1.0};
    const double keep = step % 100 == 24 ? 0.02 : 0.0;
    both(concurrent, single,
         [&](auto& ltp) { ltp.set_planner(make_planner("auto", options), keep); });
  }
  if (step != 69) return;  // later, walls would be forgotten that proofs need
  const std::string path = testing::TempDir() + "ltp_meddle.bt";
  single.map().save(path);
  both(concurrent, single, [](auto& ltp) { ltp.clear_map(); });
  for (const bool loaded : {false, true}) {
    if (loaded) both(concurrent, single, [&](auto& ltp) { ltp.load_map(path); });
    decide();
    single.update(position);
    expect_same_decision(concurrent, single);
  }
}

/// Flies both side by side; `decide` has the concurrent one decide on its newest map.
template <typename Decide>
void expect_the_same_flight(ConcurrentTrajectoryPlanner& concurrent, const Decide& decide,
                            bool meddling = false) {
  Flight flight;
  Point sensed = kStart;
  LocalTrajectoryPlanner single(make_planner(), small_map(), {}, priority(), kStart);
  single.set_waypoints(route());
  concurrent.set_waypoints(route());
  NavigationStatus status = NavigationStatus::Holding;
  for (int step = 0; step < 4000 && status != NavigationStatus::Finished; ++step) {
    if (meddling) meddle(step, concurrent, single, sensed, decide);
    const Scan& scan = flight.look();
    single.sense(scan.origin, rows(scan.hits), rows(scan.misses));
    status = single.update(flight.position);
    concurrent.sense(scan.origin, rows(scan.hits), rows(scan.misses));
    decide();
    ASSERT_EQ(concurrent.scans(), step + 1);
    expect_same_decision(concurrent, single);
    if (testing::Test::HasFatalFailure()) return;
    sensed = flight.position;
    flight.move(single.path());
  }
  EXPECT_EQ(status, NavigationStatus::Finished);
  EXPECT_EQ(single.events().size(), 4u);
  EXPECT_GT(single.plans_made(), 4);
  expect_same_events(concurrent.decision().events, single.events());
}

TEST(ConcurrentTrajectoryPlanner, DecidesStepByStepAsTheSingleThreadedOneDoes) {
  ConcurrentTrajectoryPlanner concurrent = make_concurrent();
  expect_the_same_flight(concurrent, [&] {
    EXPECT_TRUE(concurrent.plan());
    EXPECT_FALSE(concurrent.plan()) << "nothing is new";
  });
}

TEST(ConcurrentTrajectoryPlanner, DecidesOnAnotherThreadAsTheSingleThreadedOneDoes) {
  ConcurrentTrajectoryPlanner concurrent = make_concurrent();
  concurrent.start();
  expect_the_same_flight(concurrent, [&] { ASSERT_TRUE(concurrent.wait(kPatience)); });
}

TEST(ConcurrentTrajectoryPlanner, TakesUpPrioritiesAndMapsAsTheSingleThreadedOneDoes) {
  ConcurrentTrajectoryPlanner concurrent = make_concurrent();
  concurrent.start();
  expect_the_same_flight(
      concurrent, [&] { ASSERT_TRUE(concurrent.wait(kPatience)); }, true);
}

TEST(ConcurrentTrajectoryPlanner, FliesSafelyWithoutWaitingForItsPlans) {
  Flight flight;
  ConcurrentTrajectoryPlanner ltp = make_concurrent("lp-dijkstra");  // a slow one
  ltp.set_waypoints(route());
  ltp.start();
  std::int64_t stale = 0;
  bool finished = false;
  for (int step = 0; step < 20000 && !finished; ++step) {
    const Scan& scan = flight.look();
    ltp.sense(scan.origin, rows(scan.hits), rows(scan.misses));
    const Decision& now = ltp.decision();
    stale += now.scan < ltp.scans();
    finished = now.status == NavigationStatus::Finished;
    if (ltp.blocked_at()) continue;  // stays until there is a better one
    flight.move(now.path);
  }
  EXPECT_TRUE(finished);
  EXPECT_FALSE(flight.collided);
  EXPECT_GT(stale, 0) << "else nothing ran side by side";
  const std::vector<WaypointEvent>& events = ltp.decision().events;
  ASSERT_EQ(events.size(), 4u);
  for (const WaypointEvent& event : events) {
    const bool inside = flight.surface.clearance(event.goal, 1.0) == 0.0;
    EXPECT_EQ(event.reached, !inside) << "waypoint " << event.index;
  }
}

TEST(ConcurrentTrajectoryPlanner, FlagsAPathThatTheNewestScanBlocks) {
  ConcurrentTrajectoryPlanner ltp = make_concurrent("auto", no_priority());
  Path goal(1, 3);
  goal << 50, 60, 30;
  ltp.set_waypoints(goal);
  ltp.sense(kStart, Path(0, 3), Path(0, 3));
  EXPECT_EQ(ltp.decision().path.rows(), 0) << "nothing is decided yet";
  EXPECT_TRUE(ltp.plan());
  EXPECT_EQ(ltp.decision().status, NavigationStatus::Following);
  EXPECT_FALSE(ltp.blocked_at().has_value());
  Path wall(60, 3);
  for (int i = 0; i < 60; ++i) wall.row(i) << 41, 45 + 0.5 * i, 30;
  ltp.sense(kStart, wall, Path(0, 3));
  ASSERT_TRUE(ltp.blocked_at().has_value());
  EXPECT_GT(*ltp.blocked_at(), 10.0);
  EXPECT_LT(*ltp.blocked_at(), 21.0);
  EXPECT_TRUE(ltp.plan());
  EXPECT_FALSE(ltp.map().blocked().first_blocked(ltp.decision().path).has_value());
  EXPECT_FALSE(ltp.blocked_at().has_value());
}

TEST(ConcurrentTrajectoryPlanner, ForgetsThePathToOldWaypointsAtOnce) {
  ConcurrentTrajectoryPlanner ltp = make_concurrent();
  ltp.set_waypoints(route());
  ltp.sense(kStart, Path(0, 3), Path(0, 3));
  ltp.plan();
  const std::int64_t old = ltp.decision().path_id;
  ltp.set_waypoints(route().bottomRows(1));
  EXPECT_EQ(ltp.decision().status, NavigationStatus::Holding);
  EXPECT_EQ(ltp.decision().path.rows(), 0);
  EXPECT_NE(ltp.decision().path_id, old);
  ltp.sense(kStart, Path(0, 3), Path(0, 3));
  ltp.plan();
  EXPECT_EQ(ltp.decision().status, NavigationStatus::Following);
}

TEST(ConcurrentTrajectoryPlanner, ForgetsThePathForTheOldPriorityAtOnce) {
  ConcurrentTrajectoryPlanner ltp = make_concurrent();
  Path points(2, 3);
  points << kStart.transpose(), 50, 60, 30;  // the first is reached at once
  ltp.set_waypoints(points);
  const auto sense = [&] { ltp.sense(kStart, Path(0, 3), Path(0, 3)); };
  sense();
  ltp.plan();
  const std::int64_t old = ltp.decision().path_id;
  ASSERT_GT(length(ltp.decision().path), 32.0);
  sense();
  ltp.set_priority(no_priority());
  ltp.plan();  // on a snapshot from before
  EXPECT_EQ(ltp.decision().status, NavigationStatus::Holding);
  EXPECT_EQ(ltp.decision().path.rows(), 0);
  EXPECT_NE(ltp.decision().path_id, old);
  EXPECT_EQ(ltp.decision().waypoint_index, 1) << "what became of the waypoints stays";
  EXPECT_EQ(ltp.decision().events.size(), 1u);
  sense();
  ltp.plan();
  EXPECT_EQ(ltp.decision().status, NavigationStatus::Following);
  EXPECT_LT(length(ltp.decision().path), 31.5) << "without priorities straight ahead";
  EXPECT_EQ(ltp.decision().events.size(), 1u);
}

TEST(ConcurrentTrajectoryPlanner, KeepsThePathWhileABetterOneIsSought) {
  ConcurrentTrajectoryPlanner ltp = make_concurrent("auto", no_priority());
  ltp.set_waypoints(route().topRows(1));
  const auto decide = [&] {
    ltp.sense(kStart, Path(0, 3), Path(0, 3));
    ltp.plan();
  };
  decide();
  const std::int64_t id = ltp.decision().path_id;
  ASSERT_EQ(ltp.decision().status, NavigationStatus::Following);
  ltp.set_priority(priority(), 100.0);
  EXPECT_EQ(ltp.decision().path_id, id);
  EXPECT_EQ(ltp.decision().status, NavigationStatus::Following);
  decide();
  EXPECT_EQ(ltp.decision().path_id, id) << "none is better by so much";
  EXPECT_EQ(ltp.decision().plans_made, 2);
  ltp.set_priority(priority(), 1e-6);
  decide();
  EXPECT_NE(ltp.decision().path_id, id);
  EXPECT_EQ(ltp.decision().plans_made, 3);
  // Who gives up the path in between has given it up, whatever was said after that.
  const std::int64_t last = ltp.decision().path_id;
  ltp.set_planner(make_planner("additive"));
  ltp.set_priority(priority(), 100.0);
  EXPECT_EQ(ltp.decision().path.rows(), 0);
  decide();
  EXPECT_NE(ltp.decision().path_id, last);
  EXPECT_EQ(ltp.decision().status, NavigationStatus::Following);
  EXPECT_THROW(ltp.set_planner(nullptr), std::invalid_argument);
  EXPECT_THROW(ltp.set_priority(priority(), -1.0), std::invalid_argument);
}

TEST(ConcurrentTrajectoryPlanner, LosesNoEventWhenOtherWaypointsAreSet) {
  ConcurrentTrajectoryPlanner ltp = make_concurrent("auto", no_priority());
  Path near(2, 3);
  near << 21, 60, 30, 60, 60, 30;  // the first is reached at once
  const auto sense = [&] { ltp.sense(kStart, Path(0, 3), Path(0, 3)); };
  ltp.set_waypoints(near);
  sense();
  ltp.plan();  // decided and published, but nobody reads it
  ltp.set_waypoints(near.bottomRows(1));
  EXPECT_TRUE(ltp.decision().events.empty());
  ltp.set_waypoints(near);
  sense();
  ltp.set_waypoints(near.bottomRows(1));
  ltp.plan();  // on a snapshot from before
  EXPECT_TRUE(ltp.decision().events.empty());
  const std::vector<WaypointEvent> events = ltp.take_events();
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].route, 1);
  EXPECT_EQ(events[1].route, 3) << "the second was replaced before it was ever flown";
  for (const WaypointEvent& event : events) {
    EXPECT_TRUE(event.reached);
    EXPECT_EQ(event.goal, Point(21, 60, 30));
  }
  sense();
  ltp.plan();
  EXPECT_EQ(ltp.decision().status, NavigationStatus::Following);
  EXPECT_TRUE(ltp.take_events().empty());
}

TEST(ConcurrentTrajectoryPlanner, TellsEachEventOnceWhileWaypointsChangeAtEveryScan) {
  ConcurrentTrajectoryPlanner ltp = make_concurrent("auto", no_priority());
  ltp.start();
  Path near(1, 3);
  near << 21, 60, 30;
  std::vector<WaypointEvent> events;
  const auto take = [&] {
    for (const WaypointEvent& event : ltp.take_events()) events.push_back(event);
  };
  for (int i = 0; i < 200; ++i) {
    ltp.set_waypoints(near);
    ltp.sense(kStart, Path(0, 3), Path(0, 3));
    if (i % 3 == 0) {
      ASSERT_TRUE(ltp.wait(kPatience));  // this one is decided on
    }
    if (i % 7 == 0) take();
  }
  ASSERT_TRUE(ltp.wait(kPatience));
  take();
  std::int64_t last = 0;
  int waited_for = 0;
  for (const WaypointEvent& event : events) {
    EXPECT_GT(event.route, last) << "in order, none twice";
    last = event.route;
    waited_for += (event.route - 1) % 3 == 0;
  }
  EXPECT_EQ(waited_for, 67);
  EXPECT_EQ(last, 200);
}

TEST(ConcurrentTrajectoryPlanner, AClearedOrLoadedMapWakesAHoldingUavBetweenItsScans) {
  const std::string path = testing::TempDir() + "ltp_court.bt";
  Path court(160, 3);  // walls of 20 m round the start
  for (int i = 0; i < 40; ++i) {
    const double along = 0.5 * i - 10.0;
    court.row(4 * i) = (kStart + Point(along, -10, 0)).transpose();
    court.row(4 * i + 1) = (kStart + Point(along, 10, 0)).transpose();
    court.row(4 * i + 2) = (kStart + Point(-10, along, 0)).transpose();
    court.row(4 * i + 3) = (kStart + Point(10, along, 0)).transpose();
  }
  ConcurrentTrajectoryPlanner ltp = make_concurrent("auto", no_priority());
  Path goal(1, 3);
  goal << 50, 60, 30;
  ltp.set_waypoints(goal);
  ltp.start();
  ltp.sense(kStart, court, Path(0, 3));
  ASSERT_TRUE(ltp.wait(kPatience));
  EXPECT_EQ(ltp.decision().status, NavigationStatus::Holding);
  ltp.map().save(path);
  ltp.clear_map();
  ASSERT_TRUE(ltp.wait(kPatience));
  EXPECT_EQ(ltp.decision().status, NavigationStatus::Following);
  ltp.load_map(path);
  EXPECT_TRUE(ltp.blocked_at().has_value()) << "told at once";
  ASSERT_TRUE(ltp.wait(kPatience));
  EXPECT_EQ(ltp.decision().status, NavigationStatus::Holding);
  EXPECT_EQ(ltp.decision().plans_made, 3);
  EXPECT_EQ(ltp.decision().scan, 1);
  EXPECT_THROW(ltp.load_map("nowhere.bt"), std::invalid_argument);
  EXPECT_TRUE(ltp.wait(0.0)) << "nothing was handed over";
}

TEST(ConcurrentTrajectoryPlanner, ReckonsWithAnEarlierMissionUntilThatIsCleared) {
  const std::string path = testing::TempDir() + "ltp_far_box.bt";
  Path box(4 * 21, 3);  // round a waypoint far beyond the window of 120 m
  for (int i = 0; i < 21; ++i) {
    const double along = i - 10.0;
    box.row(4 * i) = Eigen::RowVector3d(390, 60 + along, 30);
    box.row(4 * i + 1) = Eigen::RowVector3d(410, 60 + along, 30);
    box.row(4 * i + 2) = Eigen::RowVector3d(400 + along, 50, 30);
    box.row(4 * i + 3) = Eigen::RowVector3d(400 + along, 70, 30);
  }
  ObstacleMapOptions options = small_map();
  ObstacleMap earlier(options, {400, 60, 30});
  earlier.insert({400, 60, 30}, box);
  earlier.save(path);
  Path goal(1, 3);
  goal << 400, 60, 30;
  for (const bool cleared : {false, true}) {
    ConcurrentTrajectoryPlanner ltp = make_concurrent("auto", no_priority());
    ltp.set_waypoints(goal);
    ltp.load_map(path);
    if (cleared) ltp.clear_map();
    ASSERT_TRUE(ltp.plan());
    EXPECT_EQ(ltp.decision().status,
              cleared ? NavigationStatus::Following : NavigationStatus::Finished);
  }
}

TEST(ConcurrentTrajectoryPlanner, ProvesNothingFromWhatWasCleared) {
  Path walls(1600, 3);  // of a block of 100 m, for a window of 80 m
  for (int i = 0; i < 400; ++i) {
    const double along = 0.25 * i - 50.0;
    walls.row(4 * i) << along, -50, 30;
    walls.row(4 * i + 1) << along, 50, 30;
    walls.row(4 * i + 2) << -50, along, 30;
    walls.row(4 * i + 3) << 50, along, 30;
  }
  ObstacleMapOptions map = small_map();
  map.dims = {40, 40, 20};
  for (const bool cleared : {false, true}) {
    ConcurrentTrajectoryPlanner ltp(make_planner("ggwp"), map, {}, no_priority(), {60, 60, 30});
    const auto sense = [&](double x, double y) {
      ltp.sense({x, y, 30}, walls, Path(0, 3));
      ltp.plan();
    };
    for (double at = 60; at >= -60; at -= 10) sense(at, 60);
    for (double at = 60; at >= -60; at -= 10) sense(-60, at);
    for (double at = -60; at <= 60; at += 10) sense(at, -60);
    for (double at = -60; at <= 60; at += 10) sense(60, at);
    for (double at = 60; at >= 20; at -= 10) sense(at, 60);
    if (cleared) ltp.clear_map();
    ltp.set_waypoints(Eigen::RowVector3d(20, 40, 30));
    sense(20, 60);
    EXPECT_EQ(ltp.decision().status,
              cleared ? NavigationStatus::Following : NavigationStatus::Finished);
    EXPECT_EQ(ltp.decision().events.size(), cleared ? 0u : 1u);
  }
}

TEST(ConcurrentTrajectoryPlanner, AllocatesNothingWhileAPlanStands) {
  ConcurrentTrajectoryPlanner ltp = make_concurrent("auto", no_priority());
  Path goal(1, 3);
  goal << 70, 60, 30;
  ltp.set_waypoints(goal);
  Point position = kStart;
  for (int step = 0; step < 100; ++step, position.x() += kStep) {
    const std::int64_t before = test::allocations();
    ltp.sense(position, Path(0, 3), Path(0, 3));
    const bool planned = ltp.plan();
    const Decision& decision = ltp.decision();
    ltp.blocked_at();
    // Each of the three slots takes the path once.
    if (step >= 3) {
      EXPECT_EQ(test::allocations() - before, 0) << "step " << step;
    }
    EXPECT_TRUE(planned);
    EXPECT_EQ(decision.plans_made, 1);
  }
}

/// Throws when it is asked.
class Broken final : public Planner {
 public:
  const PlannerInfo& info() const override { return info_; }
  const PenaltyWeights& weights() const override { return weights_; }
  Plan plan(const Scene&, const Query&, const Budget&) override {
    throw std::logic_error("broken");
  }

 private:
  PlannerInfo info_{"broken", "Broken"};
  PenaltyWeights weights_;
};

TEST(ConcurrentTrajectoryPlanner, PassesOnWhatThePlanningThreadThrows) {
  ConcurrentTrajectoryPlanner ltp(std::make_unique<Broken>(), small_map(), {}, priority(), kStart);
  ltp.set_waypoints(route());
  ltp.start();
  ltp.sense(kStart, Path(0, 3), Path(0, 3));
  EXPECT_THROW(ltp.wait(kPatience), std::logic_error);
  EXPECT_THROW(ltp.sense(kStart, Path(0, 3), Path(0, 3)), std::logic_error);
}

TEST(ConcurrentTrajectoryPlanner, WaitsNoLongerThanItIsTold) {
  ConcurrentTrajectoryPlanner ltp = make_concurrent();
  ltp.set_waypoints(route());
  EXPECT_TRUE(ltp.wait(0.0)) << "there is nothing to wait for";
  ltp.sense(kStart, Path(0, 3), Path(0, 3));
  EXPECT_FALSE(ltp.wait(0.01)) << "nobody plans";
  ltp.start();
  EXPECT_TRUE(ltp.wait(kPatience));
  ltp.stop();
  ltp.sense(kStart, Path(0, 3), Path(0, 3));
  EXPECT_FALSE(ltp.wait(0.01));
}

}  // namespace
}  // namespace ltp
