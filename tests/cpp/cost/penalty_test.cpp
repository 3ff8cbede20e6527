// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The paper's equations 2 to 5 worked out by hand.
#include "ltp/cost/penalty.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

namespace ltp {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Priority 1 where x < 10, 0.25 beyond; 0 outside of 20 m x 20 m.
Raster two_halves() {
  Raster::Values values(2, 2);
  values << 1, 1, 0.25, 0.25;
  return Raster(values, {0, 0}, 10.0);
}

TEST(Penalty, TalliesAPathByHand) {
  // 5 m at 1, a detour of 12 m up and down at 1, 5 m at 0.25, 3 m at 0.25 to the side.
  Path path(6, 3);
  path << 5, 5, 0,  //
      10, 5, 0,     //
      10, 5, 0,     // a repeated point
      15, 5, 0,     //
      15, 5, 12,    //
      15, 9, 15;
  const PathTally sum = tally(path, two_halves());
  EXPECT_DOUBLE_EQ(sum.length, 5 + 5 + 12 + 5);                 // Eq. (2)
  EXPECT_DOUBLE_EQ(sum.priority, 5 * 1 + (5 + 12 + 5) * 0.25);  // Eq. (4), numerator
  EXPECT_DOUBLE_EQ(sum.mean_priority(), 10.5 / 27);
  // Eq. (5): W_L L / L_direct - W_P mean, with L_direct = |(10, 4, 15)|.
  const double direct = std::sqrt(100.0 + 16.0 + 225.0);
  const Penalty penalty({0.5, 2.0}, direct);
  EXPECT_DOUBLE_EQ(penalty(sum), 0.5 * 27 / direct - 2.0 * 10.5 / 27);
  EXPECT_DOUBLE_EQ(penalty(27, 10.5), penalty(sum));
  EXPECT_DOUBLE_EQ(penalty.per_metre(), 0.5 / direct);
}

TEST(Penalty, IsTheWeightsForTheStraightWayOverPriorityOne) {
  Path path(2, 3);
  path << 1, 1, 3, 9, 1, 3;
  const PathTally sum = tally(path, two_halves());
  EXPECT_DOUBLE_EQ(Penalty({0.5, 1.0}, 8.0)(sum), 0.5 - 1.0);
  EXPECT_DOUBLE_EQ(Penalty({1.0, 0.0}, 8.0)(sum), 1.0);
  EXPECT_DOUBLE_EQ(Penalty({0.0, 3.0}, 8.0)(sum), -3.0);
  // Half of it beyond the raster.
  path << -4, 1, 0, 4, 1, 0;
  EXPECT_DOUBLE_EQ(Penalty({0.5, 1.0}, 8.0)(tally(path, two_halves())), 0.5 - 0.5);
}

TEST(Penalty, HasAValueForAPathWithoutLength) {
  EXPECT_EQ(tally(Path(0, 3), two_halves()).length, 0.0);
  EXPECT_EQ(tally(Path::Zero(1, 3), two_halves()).priority, 0.0);
  EXPECT_EQ(tally(Path::Zero(3, 3), two_halves()).mean_priority(), 0.0);
  // start == goal: the ratio of lengths is 1, the mean is the priority of the point.
  const Penalty here({0.5, 1.0}, 0.0);
  EXPECT_DOUBLE_EQ(here(0.0, 0.0, 0.7), 0.5 - 0.7);
  EXPECT_DOUBLE_EQ(here(0.0, 0.0), 0.5);
  EXPECT_EQ(here.per_metre(), 0.0);
  // The empty path of a search that stands at the goal: no length yet, the goal's priority.
  EXPECT_DOUBLE_EQ(Penalty({0.5, 1.0}, 10.0)(0.0, 0.0, 0.7), -0.7);
}

TEST(Penalty, DoesNotDependOnHowAPathIsCut) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> around(-5.0, 25.0);
  for (int k = 0; k < 200; ++k) {
    Path path(5, 3);
    for (Eigen::Index i = 0; i < path.size(); ++i) path.data()[i] = around(random);
    Path cut(9, 3);
    for (int i = 0; i < 5; ++i) cut.row(2 * i) = path.row(i);
    for (int i = 0; i < 4; ++i) cut.row(2 * i + 1) = 0.3 * path.row(i) + 0.7 * path.row(i + 1);
    const PathTally whole = tally(path, two_halves());
    const PathTally parts = tally(cut, two_halves());
    ASSERT_NEAR(whole.length, parts.length, 1e-9);
    ASSERT_NEAR(whole.priority, parts.priority, 1e-9);
    const PathTally back = tally(path.colwise().reverse(), two_halves());
    ASSERT_NEAR(whole.priority, back.priority, 1e-9);
    ASSERT_GE(whole.mean_priority(), 0.0);
    ASSERT_LE(whole.mean_priority(), 1.0);
  }
}

TEST(Penalty, NamesTheWeightThatIsWrong) {
  struct Case {
    PenaltyWeights weights;
    const char* name;
  };
  const Case cases[] = {
      {{-0.1, 1.0}, "weights.length = -0.1"},
      {{kNan, 1.0}, "weights.length = nan"},
      {{kInfinity, 1.0}, "weights.length = inf"},
      {{0.5, -2.0}, "weights.priority = -2"},
      {{0.5, kNan}, "weights.priority = "},
      {{0.5, kInfinity}, "weights.priority = "},
      {{0.0, 0.0}, "weights.length + weights.priority = 0"},
  };
  for (const Case& test : cases) {
    try {
      const Penalty penalty(test.weights, 1.0);
      ADD_FAILURE() << test.name << " was accepted";
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(std::string(error.what()).rfind(test.name, 0), 0u) << error.what();
    }
  }
  for (const double direct : {-1.0, kNan, kInfinity}) {
    EXPECT_THROW(Penalty({}, direct), std::invalid_argument) << direct;
  }
  EXPECT_NO_THROW(Penalty({0.0, 1e-9}, 0.0));
}

}  // namespace
}  // namespace ltp
