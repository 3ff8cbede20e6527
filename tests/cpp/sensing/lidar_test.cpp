// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The LiDAR: which rays it casts, what its returns mean, and noise that repeats.
#include "ltp/sensing/lidar.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "allocations.hpp"
#include "ltp/sensing/height_surface.hpp"

namespace ltp {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPi = 3.141592653589793;

Pose pose(const Point& position, double yaw, double pitch = 0.0, double roll = 0.0) {
  Pose made;
  made.position = position;
  made.world_from_body = Eigen::AngleAxisd(yaw, Point::UnitZ()) *
                         Eigen::AngleAxisd(pitch, Point::UnitY()) *
                         Eigen::AngleAxisd(roll, Point::UnitX());
  return made;
}

/// 200 x 200 m at height 0, a block of 30 m in its middle.
HeightSurface town() {
  Raster::Values values = Raster::Values::Zero(200, 200);
  values.block(90, 90, 20, 20) = 30.0;
  return HeightSurface(Raster(values, {0, 0}, 1.0));
}

LidarOptions small_lidar() {
  LidarOptions options;
  options.pattern.azimuths = 72;
  options.pattern.rows = 16;
  return options;
}

std::int64_t total(const ScanStatistics& s) {
  return s.hits + s.misses + s.too_near + s.invalid + s.dropped;
}

bool same(const Scan& a, const Scan& b) { return a.hits == b.hits && a.misses == b.misses; }

TEST(Lidar, AFullCircleDoesNotRepeatItsFirstAzimuth) {
  LidarOptions options;
  options.pattern = {4, -180, 180, 3, -30, 30};
  const Path rays = Lidar(options).directions();
  ASSERT_EQ(rays.rows(), 12);
  const double c = std::cos(kPi / 6);
  EXPECT_TRUE(rays.row(0).isApprox(Eigen::RowVector3d(-c, 0, -0.5), 1e-12));
  EXPECT_TRUE(rays.row(1).isApprox(Eigen::RowVector3d(-1, 0, 0), 1e-12));
  EXPECT_TRUE(rays.row(2).isApprox(Eigen::RowVector3d(-c, 0, 0.5), 1e-12));
  EXPECT_TRUE(rays.row(4).isApprox(Eigen::RowVector3d(0, -1, 0), 1e-12));  // counter-clockwise
  EXPECT_TRUE(rays.row(7).isApprox(Eigen::RowVector3d(1, 0, 0), 1e-12));
  EXPECT_TRUE(rays.row(10).isApprox(Eigen::RowVector3d(0, 1, 0), 1e-12));
}

TEST(Lidar, ASectorIncludesBothEnds) {
  LidarOptions options;
  options.pattern = {3, -90, 90, 1, -20, 40};
  const Path rays = Lidar(options).directions();
  ASSERT_EQ(rays.rows(), 3);
  const double c = std::cos(kPi / 9);
  const double s = std::sin(kPi / 9);
  EXPECT_TRUE(rays.row(0).isApprox(Eigen::RowVector3d(0, -c, -s), 1e-12));
  EXPECT_TRUE(rays.row(1).isApprox(Eigen::RowVector3d(c, 0, -s), 1e-12));
  EXPECT_TRUE(rays.row(2).isApprox(Eigen::RowVector3d(0, c, -s), 1e-12));
}

TEST(Lidar, AWrongOptionIsNamed) {
  using Spoil = std::function<void(LidarOptions&)>;
  const std::vector<std::pair<std::string, Spoil>> cases = {
      {"azimuths", [](LidarOptions& o) { o.pattern.azimuths = 0; }},
      {"rows", [](LidarOptions& o) { o.pattern.rows = -3; }},
      {"azimuths * rows",
       [](LidarOptions& o) { o.pattern.azimuths = o.pattern.rows = 2000000000; }},
      {"azimuth_from_deg", [](LidarOptions& o) { o.pattern.azimuth_from_deg = std::nan(""); }},
      {"azimuth_to_deg", [](LidarOptions& o) { o.pattern.azimuth_to_deg = kInfinity; }},
      {"azimuth_to_deg", [](LidarOptions& o) { o.pattern.azimuth_to_deg = 180.1; }},
      {"azimuth_to_deg", [](LidarOptions& o) { o.pattern.azimuth_to_deg = -180; }},
      {"elevation_from_deg", [](LidarOptions& o) { o.pattern.elevation_from_deg = -90; }},
      {"elevation_to_deg", [](LidarOptions& o) { o.pattern.elevation_to_deg = 90; }},
      {"elevation_to_deg", [](LidarOptions& o) { o.pattern.elevation_to_deg = -45; }},
      {"elevation_to_deg", [](LidarOptions& o) { o.pattern.elevation_to_deg = std::nan(""); }},
      {"max_range", [](LidarOptions& o) { o.max_range = 0; }},
      {"max_range", [](LidarOptions& o) { o.max_range = kInfinity; }},
      {"range_noise_sd", [](LidarOptions& o) { o.range_noise_sd = -0.1; }},
      {"range_noise_sd", [](LidarOptions& o) { o.range_noise_sd = std::nan(""); }},
      {"drop_out", [](LidarOptions& o) { o.drop_out = 1.01; }},
      {"drop_out", [](LidarOptions& o) { o.drop_out = std::nan(""); }},
  };
  for (const auto& [name, spoil] : cases) {
    LidarOptions options;
    spoil(options);
    try {
      const Lidar lidar(options);
      ADD_FAILURE() << name << " was accepted";
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(std::string(error.what()).rfind(name + " = ", 0), 0) << error.what();
    }
  }
  EXPECT_NO_THROW(Lidar{});
}

TEST(Lidar, AScanIsItsRays) {
  const HeightSurface surface = town();
  const Lidar lidar(small_lidar());
  const std::vector<Pose> poses = {pose({60, 95, 20}, 0.0), pose({60, 95, 20}, 2.5),
                                   pose({60, 95, 20}, 0.3, 0.2, -0.4),
                                   pose({60, 95, 20}, -1.0, 0.0, kPi)};
  for (const Pose& at : poses) {
    Scan scan;
    lidar.scan(surface, at, 0, scan);
    EXPECT_EQ(scan.origin, at.position);
    std::size_t hits = 0, misses = 0;
    for (Eigen::Index ray = 0; ray < lidar.directions().rows(); ++ray) {
      const Point direction = at.world_from_body * Point(lidar.directions().row(ray).transpose());
      const RayHit hit = surface.cast(at.position, direction, 50);
      if (hit.hit()) {
        ASSERT_LT(hits, scan.hits.size());
        ASSERT_LT((scan.hits[hits++] - hit.inside).norm(), 1e-9);
      } else {
        ASSERT_LT(misses, scan.misses.size());
        ASSERT_LT((scan.misses[misses++] - (at.position + 50 * direction)).norm(), 1e-9);
      }
    }
    EXPECT_EQ(scan.hits.size(), hits);
    EXPECT_EQ(scan.misses.size(), misses);
    EXPECT_EQ(scan.statistics.hits, static_cast<std::int64_t>(hits));
    EXPECT_EQ(scan.statistics.misses, static_cast<std::int64_t>(misses));
    EXPECT_EQ(total(scan.statistics), lidar.directions().rows());
    EXPECT_GT(hits, 50u);
    EXPECT_GT(misses, 50u);
  }
}

TEST(Lidar, MissesCanBeCountedOnly) {
  LidarOptions noisy = small_lidar();
  noisy.range_noise_sd = 20;
  noisy.drop_out = 0.1;
  for (const LidarOptions& options : {small_lidar(), noisy}) {
    const Lidar lidar(options);
    for (const double pitch : {0.0, 0.2}) {
      Scan listed, counted;
      counted.misses.resize(3);
      lidar.scan(town(), pose({60, 95, 20}, 0.3, pitch), 0, listed);
      lidar.scan(town(), pose({60, 95, 20}, 0.3, pitch), 0, counted, Misses::Counted);
      EXPECT_EQ(counted.hits, listed.hits);
      EXPECT_TRUE(counted.misses.empty());
      EXPECT_EQ(counted.statistics.hits, listed.statistics.hits);
      EXPECT_EQ(counted.statistics.misses, static_cast<std::int64_t>(listed.misses.size()));
      EXPECT_EQ(counted.statistics.invalid, listed.statistics.invalid);
      EXPECT_EQ(counted.statistics.dropped, listed.statistics.dropped);
    }
  }
}

TEST(Lidar, SeesTheWallInFrontAndTheGroundBelow) {
  LidarOptions options;
  options.pattern = {1, 0, 0, 2, -80, 0};
  Scan scan;
  Lidar(options).scan(town(), pose({60.5, 95.5, 20}, 0), 0, scan);
  ASSERT_EQ(scan.hits.size(), 2u);
  EXPECT_TRUE(scan.hits[1].isApprox(Point(90 + kHitDepth, 95.5, 20), 1e-12));
  EXPECT_NEAR(scan.hits[0].x(), 60.5 + 20 * std::tan(kPi / 18), 1e-9);
  EXPECT_NEAR(scan.hits[0].z(), -kHitDepth, 1e-12);
  // Turned round, nothing is there.
  Lidar(options).scan(town(), pose({60.5, 95.5, 20}, kPi), 0, scan);
  EXPECT_EQ(scan.hits.size(), 1u);
  ASSERT_EQ(scan.misses.size(), 1u);
  EXPECT_TRUE(scan.misses[0].isApprox(Point(10.5, 95.5, 20), 1e-9));
}

TEST(Lidar, AReturnAtExactlyTheMaximumRangeIsNone) {
  for (const double pitch : {0.0, 1e-6}) {  // by the fan, by single rays
    LidarOptions options;
    options.pattern = {1, 0, 0, 1, 0, 0};
    Scan scan;
    options.max_range = 29.5 - 1e-9;
    Lidar(options).scan(town(), pose({60.5, 95.5, 20}, 0, pitch), 0, scan);
    EXPECT_EQ(scan.statistics.misses, 1);
    options.max_range = 29.5 + 1e-9;
    Lidar(options).scan(town(), pose({60.5, 95.5, 20}, 0, pitch), 0, scan);
    EXPECT_EQ(scan.statistics.hits, 1);
    EXPECT_EQ(scan.statistics.misses, 0);
  }
  LidarOptions options;
  options.pattern = {1, 0, 0, 1, 0, 0};
  options.max_range = 29.5;
  Scan scan;
  Lidar(options).scan(town(), pose({60.5, 95.5, 20}, 0), 0, scan);
  EXPECT_EQ(scan.statistics.misses, 1);
}

TEST(Lidar, NoiseHasTheSpreadThatIsAskedFor) {
  LidarOptions options = small_lidar();
  options.pattern.elevation_to_deg = -44;  // ground only
  options.max_range = 60;
  options.range_noise_sd = 0.2;
  const Lidar lidar(options);
  const HeightSurface surface(Raster(Raster::Values::Zero(200, 200), {0, 0}, 1.0));
  const Pose at = pose({100, 100, 20}, 0.1);
  double sum = 0, squares = 0;
  std::int64_t count = 0;
  Scan scan;
  for (int sequence = 0; sequence < 20; ++sequence) {
    lidar.scan(surface, at, sequence, scan);
    ASSERT_EQ(scan.hits.size(), 72u * 16u);
    for (const Point& hit : scan.hits) {
      const Point ray = hit - at.position;
      const double truth = 20 * ray.norm() / -ray.z();
      sum += ray.norm() - truth;
      squares += std::pow(ray.norm() - truth, 2);
      ++count;
    }
  }
  // Four standard errors.
  EXPECT_NEAR(sum / count, 0.0, 4 * 0.2 / std::sqrt(count));
  EXPECT_NEAR(std::sqrt(squares / count), 0.2, 4 * 0.2 / std::sqrt(2.0 * count));
}

TEST(Lidar, DropOutLosesTheShareThatIsAskedFor) {
  LidarOptions options = small_lidar();
  options.drop_out = 0.3;
  const Lidar lidar(options);
  const HeightSurface surface = town();
  std::int64_t hits = 0, dropped = 0;
  Scan scan;
  for (int sequence = 0; sequence < 20; ++sequence) {
    lidar.scan(surface, pose({60, 95, 20}, 0), sequence, scan);
    hits += scan.statistics.hits;
    dropped += scan.statistics.dropped;
    EXPECT_EQ(total(scan.statistics), 72 * 16);
  }
  const double returns = static_cast<double>(hits + dropped);
  EXPECT_NEAR(dropped / returns, 0.3, 4 * std::sqrt(0.3 * 0.7 / returns));
  options.drop_out = 1.0;
  Lidar(options).scan(surface, pose({60, 95, 20}, 0), 0, scan);
  EXPECT_EQ(scan.statistics.hits, 0);
  EXPECT_GT(scan.statistics.dropped, 0);
}

TEST(Lidar, NoiseCanMakeAReturnAMissOrInvalid) {
  LidarOptions options = small_lidar();
  options.range_noise_sd = 100;
  Scan scan;
  Lidar(options).scan(town(), pose({60, 95, 20}, 0), 0, scan);
  Scan clean;
  Lidar(small_lidar()).scan(town(), pose({60, 95, 20}, 0), 0, clean);
  EXPECT_EQ(total(scan.statistics), 72 * 16);
  EXPECT_GT(scan.statistics.invalid, 0);
  EXPECT_GT(scan.statistics.misses, clean.statistics.misses);
  EXPECT_GT(scan.statistics.hits, 0);
  for (const Point& hit : scan.hits) EXPECT_LT((hit - scan.origin).norm(), 50 + 1e-9);
}

TEST(Lidar, NoiseRepeatsFromRunToRunAndDiffersFromScanToScan) {
  LidarOptions options = small_lidar();
  options.range_noise_sd = 0.1;
  options.drop_out = 0.1;
  options.seed = 7;
  const HeightSurface surface = town();
  const Pose at = pose({60, 95, 20}, 0);
  const Lidar lidar(options);
  Scan first, again, other;
  lidar.scan(surface, at, 3, first);
  lidar.scan(surface, at, 4, other);
  EXPECT_FALSE(same(first, other));
  lidar.scan(surface, at, 3, again);
  EXPECT_TRUE(same(first, again));
  Scan in_thread;
  std::thread([&] { lidar.scan(surface, at, 3, in_thread); }).join();
  EXPECT_TRUE(same(first, in_thread));
  options.seed = 8;
  Lidar(options).scan(surface, at, 3, other);
  EXPECT_FALSE(same(first, other));
}

TEST(Lidar, NoiseIsTheSameOnEveryMachine) {
  // One hit at 30 m, straight ahead; computed independently from the documented hash.
  LidarOptions options;
  options.pattern = {1, 0, 0, 1, 0, 0};
  options.range_noise_sd = 1.0;
  options.seed = 1;
  Scan scan;
  Lidar(options).scan(town(), pose({60, 95.5, 20}, 0), 2, scan);
  ASSERT_EQ(scan.hits.size(), 1u);
  EXPECT_NEAR(scan.hits[0].x(), 91.853873813775, 1e-9);
}

TEST(Lidar, RangesOfARealSensorMeanWhatTheySay) {
  LidarOptions options;
  options.pattern = {9, 0, 0, 1, 0, 0};
  options.pattern.azimuth_to_deg = 80;
  const Lidar lidar(options);
  Eigen::VectorXd ranges(9);
  ranges << 10, std::nan(""), -1, -kInfinity, kInfinity, 50, 49.999, 0, 60;
  Scan scan;
  const Pose at = pose({1, 2, 3}, kPi / 2);
  lidar.from_ranges(ranges, at, scan);
  EXPECT_EQ(scan.statistics.hits, 2);
  EXPECT_EQ(scan.statistics.misses, 3);
  EXPECT_EQ(scan.statistics.invalid, 4);
  EXPECT_EQ(scan.statistics.dropped, 0);
  ASSERT_EQ(scan.hits.size(), 2u);
  ASSERT_EQ(scan.misses.size(), 3u);
  EXPECT_TRUE(scan.hits[0].isApprox(Point(1, 12, 3), 1e-12));
  EXPECT_NEAR((scan.hits[1] - at.position).norm(), 49.999, 1e-9);
  for (const Point& miss : scan.misses) EXPECT_NEAR((miss - at.position).norm(), 50, 1e-9);

  EXPECT_THROW(lidar.from_ranges(Eigen::VectorXd::Ones(8), at, scan), std::invalid_argument);
}

TEST(Lidar, ABadPoseIsRefused) {
  const Lidar lidar(small_lidar());
  Scan scan;
  Pose bad = pose({0, 0, std::nan("")}, 0);
  EXPECT_THROW(lidar.scan(town(), bad, 0, scan), std::invalid_argument);
  bad = pose({0, 0, 10}, 0);
  bad.world_from_body.coeffs() *= 2;
  EXPECT_THROW(lidar.scan(town(), bad, 0, scan), std::invalid_argument);
  EXPECT_THROW(lidar.from_ranges(Eigen::VectorXd::Ones(72 * 16), bad, scan), std::invalid_argument);
}

TEST(Lidar, AWarmScanAllocatesNothing) {
  LidarOptions noisy = small_lidar();
  noisy.range_noise_sd = 0.1;
  noisy.drop_out = 0.1;
  const HeightSurface surface = town();
  for (const LidarOptions& options : {small_lidar(), noisy}) {
    const Lidar lidar(options);
    Scan scan;
    lidar.scan(surface, pose({60, 95, 20}, 0), 0, scan);
    const std::int64_t before = test::allocations();
    for (int sequence = 1; sequence < 20; ++sequence) {
      lidar.scan(surface, pose({60.0 + sequence, 95, 20}, 0.1 * sequence), sequence, scan);
      lidar.scan(surface, pose({60, 95, 20}, 0, 0.01 * sequence), sequence, scan);
    }
    EXPECT_EQ(test::allocations() - before, 0);
  }
}

TEST(Lidar, SeesNothingNearerThanItsMinimumRange) {
  LidarOptions options;
  options.pattern.azimuths = 6;
  options.pattern.rows = 1;
  options.pattern.elevation_from_deg = options.pattern.elevation_to_deg = 0.0;
  options.min_range = 2.0;
  options.max_range = 10.0;
  const Lidar lidar(options);
  Eigen::VectorXd ranges(6);
  ranges << 1.999, 2.0, 9.0, 10.0, 0.0, 0.5;
  Scan scan;
  lidar.from_ranges(ranges, Pose(), scan);
  EXPECT_EQ(scan.statistics.too_near, 2);
  EXPECT_EQ(scan.statistics.hits, 2);
  EXPECT_EQ(scan.statistics.misses, 1);
  EXPECT_EQ(scan.statistics.invalid, 1);
  const Eigen::VectorXf floats = ranges.cast<float>();
  Scan same;
  lidar.from_ranges(floats, Pose(), same);
  EXPECT_EQ(same.statistics.too_near, 2);
  EXPECT_EQ(same.hits, scan.hits);
  options.min_range = 10.0;
  EXPECT_THROW(Lidar{options}, std::invalid_argument);
}

}  // namespace
}  // namespace ltp
