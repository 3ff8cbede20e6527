// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `Raster`: its samples by the definition, its integrals against dense sampling and by hand.
#include "ltp/grid/raster.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace ltp {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Raster::Values random_values(int nx, int ny, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Raster::Values values(nx, ny);
  for (Eigen::Index i = 0; i < values.size(); ++i) values.data()[i] = unit(random);
  return values;
}

TEST(Raster, SharesItsIdentityWithCopiesOnly) {
  const Raster raster(Raster::Values::Zero(2, 2), {0, 0}, 1.0);
  const Raster twin(Raster::Values::Zero(2, 2), {0, 0}, 1.0);
  Raster copy = raster;
  EXPECT_EQ(copy.id(), raster.id());
  EXPECT_NE(twin.id(), raster.id());
  copy = twin;
  EXPECT_EQ(copy.id(), twin.id());
}

TEST(Raster, SamplesTheCellThatHoldsThePoint) {
  Raster::Values values(2, 3);
  values << 1, 2, 3,  // x in [10, 14): y in [20, 24), [24, 28), [28, 32)
      4, 5, 6;
  const Raster raster(values, {10, 20}, 4.0, -1.0);
  EXPECT_EQ(raster.at(10, 20), 1);
  EXPECT_EQ(raster.at(13.999, 31.999), 3);
  EXPECT_EQ(raster.at(14, 24), 5) << "a face belongs to the upper cell";
  EXPECT_EQ(raster.at(17.9, 27.9), 5);
  for (const double out : {kNan, kInfinity, -kInfinity, 1e300, -1e300, 4294967306.0, 9.999, 18.0}) {
    EXPECT_EQ(raster.at(out, 22), -1) << out;
    EXPECT_EQ(raster.bilinear(out, 22), -1) << out;
  }
  for (const double out : {kNan, -kInfinity, 19.999, 32.0, 1e10}) {
    EXPECT_EQ(raster.at(12, out), -1) << out;
    EXPECT_EQ(raster.bilinear(12, out), -1) << out;
  }
  EXPECT_EQ(raster.minimum(), -1);
  EXPECT_EQ(raster.maximum(), 6);
}

TEST(Raster, InterpolatesBetweenCentres) {
  std::mt19937_64 random(1);
  const int nx = 6;
  const int ny = 4;
  const Raster raster(random_values(nx, ny, random), {-3, 5}, 0.5);
  const auto clipped = [&](int i, int j) {
    return raster.values()(std::clamp(i, 0, nx - 1), std::clamp(j, 0, ny - 1));
  };
  std::uniform_real_distribution<double> x(-3.0, 0.0);
  std::uniform_real_distribution<double> y(5.0, 7.0);
  for (int k = 0; k < 2000; ++k) {
    const double px = x(random);
    const double py = y(random);
    const double u = (px + 3) / 0.5 - 0.5;
    const double v = (py - 5) / 0.5 - 0.5;
    const int i = static_cast<int>(std::floor(u));
    const int j = static_cast<int>(std::floor(v));
    const double low = (1 - (u - i)) * clipped(i, j) + (u - i) * clipped(i + 1, j);
    const double high = (1 - (u - i)) * clipped(i, j + 1) + (u - i) * clipped(i + 1, j + 1);
    ASSERT_NEAR(raster.bilinear(px, py), (1 - (v - j)) * low + (v - j) * high, 1e-12);
  }
  for (int i = 0; i < nx; ++i) {
    for (int j = 0; j < ny; ++j) {
      ASSERT_EQ(raster.bilinear(-3 + (i + 0.5) * 0.5, 5 + (j + 0.5) * 0.5), raster.values()(i, j));
    }
  }
  const Raster single(Raster::Values::Constant(1, 1, 7.0), {0, 0}, 1.0);
  EXPECT_EQ(single.bilinear(0.1, 0.9), 7.0);
}

TEST(Raster, IntegratesLikeDenseSampling) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> around(-8.0, 20.0);
  for (int k = 0; k < 60; ++k) {
    const Raster raster(random_values(5, 7, random), {1.3, -2.1}, 1.7, 0.25);
    const Point a(around(random), around(random), around(random));
    const Point b(around(random), around(random), around(random));
    const int steps = 200000;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
      const Point point = a + (i + 0.5) / steps * (b - a);
      sum += raster.at(point.x(), point.y());
    }
    const double expected = sum / steps * (b - a).norm();
    // A boundary is crossed at most 14 times; each costs the sampling at most one step.
    ASSERT_NEAR(raster.integral(a, b), expected, 14.0 * (b - a).norm() / steps);
    ASSERT_NEAR(raster.integral(a, b), raster.integral(b, a), 1e-12 * (b - a).norm());
  }
}

TEST(Raster, IntegratesByHand) {
  Raster::Values values(3, 2);
  values << 1, 2, 4, 8, 16, 32;
  const Raster raster(values, {0, 0}, 2.0, 64.0);
  const auto integral = [&](Point a, Point b) { return raster.integral(a, b); };
  EXPECT_DOUBLE_EQ(integral({1, 1, 0}, {5, 1, 0}), 1 * 1 + 4 * 2 + 16 * 1);
  EXPECT_DOUBLE_EQ(integral({-3, 1, 0}, {9, 1, 0}), 64 * 3 + 2 * (1 + 4 + 16) + 64 * 3);
  EXPECT_DOUBLE_EQ(integral({1, 1, 5}, {1, 1, -2}), 7 * 1)
      << "straight down, per metre of 3-D length";
  EXPECT_DOUBLE_EQ(integral({1, 1, 0}, {3, 1, 0}) * std::sqrt(2.0), integral({1, 1, 0}, {3, 1, 2}));
  EXPECT_DOUBLE_EQ(integral({1, 1, 0}, {3, 3, 0}), std::sqrt(2.0) * (1 + 8)) << "through a corner";
  EXPECT_DOUBLE_EQ(integral({0, 2, 0}, {6, 2, 0}), 2 * (2 + 8 + 32)) << "a face: the upper cells";
  EXPECT_DOUBLE_EQ(integral({0, 4, 0}, {6, 4, 0}), 6 * 64) << "the upper edge is outside";
  EXPECT_DOUBLE_EQ(integral({0, 0, 0}, {6, 0, 0}), 2 * (1 + 4 + 16)) << "the lower edge is inside";
  EXPECT_DOUBLE_EQ(integral({50, 50, 0}, {53, 54, 0}), 5 * 64);
  EXPECT_EQ(integral({1, 1, 1}, {1, 1, 1}), 0.0);
}

TEST(Raster, AddsUpAlongASplitSegment) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> around(-10.0, 20.0);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const Raster raster(random_values(11, 9, random), {0, 0}, 1.0, 0.5);
  for (int k = 0; k < 1000; ++k) {
    const Point a(around(random), around(random), around(random));
    const Point b(around(random), around(random), around(random));
    const Point middle = a + unit(random) * (b - a);
    ASSERT_NEAR(raster.integral(a, b), raster.integral(a, middle) + raster.integral(middle, b),
                1e-9);
  }
}

TEST(Raster, IntegratesOverAnyDistanceAtOnce) {
  // The part beyond the edges is not walked: these would take hours, or overflow a cell's number.
  const Raster raster(Raster::Values::Constant(10, 10, 1.0), {0, 0}, 1.0, 0.25);
  EXPECT_NEAR(raster.integral({-1e9, 5, 0}, {1e9, 5, 0}), 10 + 0.25 * (2e9 - 10), 1.0);
  EXPECT_NEAR(raster.integral({5, 5, 0}, {5, 1e12, 0}), 5 + 0.25 * (1e12 - 10), 1e-3);
  EXPECT_NEAR(raster.integral({5, -1e100, 0}, {5, -2e100, 0}) / 0.25e100, 1.0, 1e-12);
  EXPECT_NEAR(raster.integral({-1e12, 20, 0}, {1e12, 20, 0}), 0.25 * 2e12, 1e-3);
}

/// Checks that a raster is refused with a message that begins with the argument's name.
template <typename Make>
void expect_refused(const std::string& name, Make&& make) {
  try {
    make();
    ADD_FAILURE() << name << " was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()).rfind(name, 0), 0u) << error.what();
  }
}

TEST(Raster, NamesTheArgumentThatIsWrong) {
  const Raster::Values good = Raster::Values::Zero(2, 3);
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    Raster::Values values = good;
    values(1, 2) = bad;
    expect_refused("values[1, 2] = ", [&] { Raster(values, {0, 0}, 1.0); });
    expect_refused("origin.x = ", [&] { Raster(good, {bad, 0}, 1.0); });
    expect_refused("origin.y = ", [&] { Raster(good, {0, bad}, 1.0); });
    expect_refused("cell = ", [&] { Raster(good, {0, 0}, bad); });
    expect_refused("outside = ", [&] { Raster(good, {0, 0}, 1.0, bad); });
  }
  expect_refused("cell = 0", [&] { Raster(good, {0, 0}, 0.0); });
  expect_refused("cell = -1", [&] { Raster(good, {0, 0}, -1.0); });
  expect_refused("values.shape = (0, 3)", [] { Raster(Raster::Values(0, 3), {0, 0}, 1.0); });
  expect_refused("values.shape = (3, 0)", [] { Raster(Raster::Values(3, 0), {0, 0}, 1.0); });
}

}  // namespace
}  // namespace ltp
