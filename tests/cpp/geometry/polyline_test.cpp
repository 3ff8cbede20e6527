// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Polylines: lengths, points along them, closest points, against dense sampling and by hand.
#include "ltp/geometry/polyline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <random>

namespace ltp {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Path rows(std::initializer_list<Point> points) {
  Path path(static_cast<Eigen::Index>(points.size()), 3);
  Eigen::Index i = 0;
  for (const Point& point : points) path.row(i++) = point.transpose();
  return path;
}

Path random_path(int count, std::mt19937_64& random) {
  std::normal_distribution<double> normal(0.0, 5.0);
  Path path(count, 3);
  for (Eigen::Index i = 0; i < path.size(); ++i) path.data()[i] = normal(random);
  // Repeated points are legal.
  if (count > 3) path.row(2) = path.row(1);
  return path;
}

TEST(Polyline, HasALength) {
  EXPECT_EQ(length(Path(0, 3)), 0.0);
  EXPECT_EQ(length(rows({{1, 2, 3}})), 0.0);
  EXPECT_DOUBLE_EQ(length(rows({{0, 0, 0}, {3, 4, 0}, {3, 4, 0}, {3, 4, -12}})), 17.0);
}

TEST(Polyline, HasAPointAtEveryArcLength) {
  const Path path = rows({{0, 0, 0}, {0, 0, 0}, {3, 4, 0}, {3, 4, 0}, {3, 4, -12}, {3, 4, -12}});
  EXPECT_EQ(point_at(path, 0.0), Point(0, 0, 0));
  EXPECT_TRUE(point_at(path, 2.5).isApprox(Point(1.5, 2, 0)));
  EXPECT_TRUE(point_at(path, 5.0).isApprox(Point(3, 4, 0)));
  EXPECT_TRUE(point_at(path, 6.0).isApprox(Point(3, 4, -1)));
  EXPECT_EQ(point_at(path, 17.0), Point(3, 4, -12));
  // Clamped to the ends.
  EXPECT_EQ(point_at(path, -1.0), Point(0, 0, 0));
  EXPECT_EQ(point_at(path, 1e9), Point(3, 4, -12));
  EXPECT_EQ(point_at(path, kInfinity), Point(3, 4, -12));
  EXPECT_EQ(point_at(path, -kInfinity), Point(0, 0, 0));
  EXPECT_EQ(point_at(rows({{1, 2, 3}}), 5.0), Point(1, 2, 3));
  EXPECT_THROW(point_at(path, kNan), std::invalid_argument);
  EXPECT_THROW(point_at(Path(0, 3), 0.0), std::invalid_argument);
}

TEST(Polyline, IsResampledWithBothEndsAndNoStepTooLong) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int k = 0; k < 300; ++k) {
    const Path path = random_path(2 + k % 9, random);
    const double total = length(path);
    const double spacing = k % 7 == 0 ? total / (1 + k % 5) : 0.05 + 8.0 * unit(random);
    const Path points = resample(path, spacing);
    ASSERT_EQ(points.row(0), path.row(0));
    ASSERT_EQ(points.row(points.rows() - 1), path.row(path.rows() - 1));
    ASSERT_NEAR(static_cast<double>(points.rows() - 1), std::ceil(total / spacing - 1e-6), 0.0);
    for (Eigen::Index i = 0; i + 1 < points.rows(); ++i) {
      const Point here = points.row(i).transpose();
      ASSERT_LT((here - point_at(path, static_cast<double>(i) * spacing)).norm(), 1e-9);
      ASSERT_LE((points.row(i + 1) - points.row(i)).norm(), spacing * (1 + 1e-8));
    }
  }
  EXPECT_EQ(resample(rows({{1, 2, 3}}), 1.0), rows({{1, 2, 3}}));
  EXPECT_EQ(resample(rows({{1, 2, 3}, {1, 2, 3}}), 1.0), rows({{1, 2, 3}}));
  // Three tenths are three steps of a tenth, whatever rounding says.
  EXPECT_EQ(resample(rows({{0, 0, 0}, {0.1 + 0.2, 0, 0}}), 0.1).rows(), 4);
  // However short the path, its last point is kept.
  EXPECT_EQ(resample(rows({{0, 0, 0}, {1e-12, 0, 0}}), 1.0), rows({{0, 0, 0}, {1e-12, 0, 0}}));
  EXPECT_EQ(resample(rows({{0, 0, 0}, {3, 0, 0}}), 1e300).rows(), 2);
}

TEST(Polyline, RefusesASpacingThatIsNone) {
  const Path path = rows({{0, 0, 0}, {1, 0, 0}});
  for (const double spacing : {0.0, -1.0, kNan, kInfinity, 1e-300, 5e-324, 1e-12}) {
    EXPECT_THROW(resample(path, spacing), std::invalid_argument) << spacing;
  }
  EXPECT_THROW(resample(Path(0, 3), 1.0), std::invalid_argument);
}

TEST(Polyline, KnowsItsClosestPoint) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal(0.0, 6.0);
  std::uniform_real_distribution<double> unit(-0.2, 1.2);
  for (int k = 0; k < 300; ++k) {
    const Path path = random_path(1 + k % 7, random);
    const double total = length(path);
    const double from = k % 3 == 0 ? 0.0 : unit(random) * total;
    const Point point(normal(random), normal(random), normal(random));
    const ClosestPoint found = closest_point(path, point, from);
    ASSERT_NEAR(found.distance, (found.point - point).norm(), 1e-12);
    ASSERT_LT((point_at(path, found.arc_length) - found.point).norm(), 1e-9);
    ASSERT_GE(found.arc_length, std::min(from, total) - 1e-9);
    const int steps = 2000;
    for (int i = 0; i <= steps; ++i) {
      const double arc =
          std::clamp(from, 0.0, total) + (total - std::clamp(from, 0.0, total)) * i / steps;
      ASSERT_LE(found.distance, (point_at(path, arc) - point).norm() + 1e-9);
    }
  }
  EXPECT_THROW(closest_point(Path(0, 3), Point::Zero()), std::invalid_argument);
  EXPECT_THROW(closest_point(rows({{0, 0, 0}, {1, 0, 0}}), Point::Zero(), kNan),
               std::invalid_argument);
}

TEST(Polyline, PrefersTheFirstOfEquallyClosePoints) {
  // A loop: a UAV at its common end has all of it still to fly.
  const Path loop = rows({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0}});
  EXPECT_EQ(closest_point(loop, Point(0, 0, 0)).arc_length, 0.0);
  EXPECT_EQ(closest_point(loop, Point(2, 2, 0)).arc_length, 2.0);
  EXPECT_EQ(closest_point(loop, Point(0, 0, 0), 1.0).arc_length, 16.0);
}

TEST(Polyline, LooksNoFartherThanItIsTold) {
  // There and back, 1 m apart: from the first leg's middle the way back is as near as can be.
  const Path path = rows({{0, 0, 0}, {10, 0, 0}, {10, 1, 0}, {0, 1, 0}});
  EXPECT_EQ(closest_point(path, Point(5, 0.9, 0)).arc_length, 16.0);
  EXPECT_EQ(closest_point(path, Point(5, 0.9, 0), 0.0, 10.0).arc_length, 5.0);
  EXPECT_EQ(closest_point(path, Point(5, 0.9, 0), 2.0, 4.0).arc_length, 4.0);
  EXPECT_EQ(closest_point(path, Point(5, 0.9, 0), 12.0, 13.5).arc_length, 13.5);
  EXPECT_EQ(closest_point(path, Point(5, 0.9, 0), 6.0, 2.0).arc_length, 6.0) << "where it begins";
  EXPECT_EQ(closest_point(path, Point(0, 1, 0), 0.0, 1e9).arc_length, 21.0);
  EXPECT_EQ(closest_point(path, Point(0, 1, 0), 50.0, 60.0).arc_length, 21.0);
  EXPECT_EQ(closest_point(path, Point(5, 0, 0), -3.0, -1.0).arc_length, 0.0);
  EXPECT_THROW(closest_point(path, Point::Zero(), 0.0, kNan), std::invalid_argument);
}

/// Whole powers of ten that the square of a length cannot hold, and those that it can.
constexpr double kScales[] = {1e-300, 2e-292, 9.9e-272, 1e-200, 1e-160, 1e-100, 1.0,
                              1e100,  1e150,  1e154,    1e200,  1e250,  1e300};

TEST(Polyline, ScalesWithItsUnits) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> share(-0.2, 1.2);
  for (int round = 0; round < 20; ++round) {
    const Path path = random_path(6, random) / 16.0;
    const Point point = random_path(1, random).row(0).transpose() / 16.0;
    const double whole = length(path);
    const double arc = share(random) * whole;
    const Point at = point_at(path, arc);
    const ClosestPoint closest = closest_point(path, point, 0.3 * whole);
    const Path points = resample(path, whole / 7.5);
    for (const double scale : kScales) {
      const Path scaled = scale * path;
      EXPECT_NEAR(length(scaled) / scale, whole, 1e-12);
      EXPECT_LT((point_at(scaled, scale * arc) / scale - at).norm(), 1e-12);
      const ClosestPoint found = closest_point(scaled, scale * point, scale * (0.3 * whole));
      EXPECT_LT((found.point / scale - closest.point).norm(), 1e-12);
      EXPECT_NEAR(found.arc_length / scale, closest.arc_length, 1e-12);
      EXPECT_NEAR(found.distance / scale, closest.distance, 1e-12);
      const Path resampled = resample(scaled, scale * (whole / 7.5));
      ASSERT_EQ(resampled.rows(), points.rows());
      EXPECT_LT((resampled / scale - points).cwiseAbs().maxCoeff(), 1e-12);
    }
  }
}

TEST(Polyline, KeepsBothEndsHoweverShortOrLong) {
  for (const double scale : kScales) {
    const Path path = rows({{0, 0, 0}, {scale, 0, 0}, {scale, -0.5 * scale, 0.25 * scale}});
    for (const double spacing : {0.1 * scale, scale, 1.0, 1e300}) {
      if (scale / spacing > 1e6) continue;
      const Path points = resample(path, spacing);
      EXPECT_EQ(points.row(0), path.row(0)) << scale << " " << spacing;
      EXPECT_EQ(points.row(points.rows() - 1), path.row(2)) << scale << " " << spacing;
    }
  }
}

TEST(Polyline, RefusesDistancesThatOverflow) {
  const Path path = rows({{-1.5e308, 0, 0}, {1.5e308, 0, 0}});
  EXPECT_THROW(length(path), std::invalid_argument);
  EXPECT_THROW(point_at(path, 1.0), std::invalid_argument);
  EXPECT_THROW(resample(path, 1e307), std::invalid_argument);
  EXPECT_THROW(closest_point(path, Point::Zero()), std::invalid_argument);
  EXPECT_THROW(closest_point(rows({{1.5e308, 0, 0}}), Point(-1.5e308, 0, 0)),
               std::invalid_argument);
}

}  // namespace
}  // namespace ltp
