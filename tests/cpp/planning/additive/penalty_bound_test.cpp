// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// What additive searches prove about Eq. (5), against random paths that meet their constraints.
#include "planning/additive/penalty_bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace ltp::planning {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Constraint {
  double alpha;
  double min_cost;
};

/// Paths between two points, and what searches with some alphas have found out about them.
struct Instance {
  PenaltyWeights weights;
  double direct;
  double most;                   ///< the largest priority
  std::vector<PathTally> paths;  ///< none shorter than `direct`, none of a mean above `most`
  std::vector<Constraint> constraints;

  PenaltyBound bound() const {
    PenaltyBound made(weights, direct, most);
    for (const Constraint& each : constraints) made.add(each.alpha, each.min_cost);
    return made;
  }
  double least_penalty() const {
    double least = kInfinity;
    for (const PathTally& path : paths) least = std::min(least, Penalty(weights, direct)(path));
    return least;
  }
  /// Eq. (5) at most as low as a path of this length can have it.
  double lowest_at(double length) const {
    double mean = most;
    for (const Constraint& each : constraints) {
      mean = std::min(mean, each.alpha - each.min_cost / length);
    }
    return weights.length * length / direct - weights.priority * mean;
  }
};

Instance random_instance(std::mt19937_64& random, const PenaltyWeights& weights, int constraints) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Instance made{weights, 1.0 + 99.0 * unit(random), 0.1 + 0.9 * unit(random), {}, {}};
  for (int k = 0; k < 40; ++k) {
    const double length = made.direct * (1.0 + 2.0 * unit(random) * unit(random));
    made.paths.push_back({length, length * made.most * unit(random)});
  }
  const double min_alpha = PenaltyBound(weights, made.direct, made.most).min_alpha();
  for (int k = 0; k < constraints; ++k) {
    const double alpha = min_alpha + 2.0 * unit(random) * unit(random);
    double least = kInfinity;
    for (const PathTally& path : made.paths) {
      least = std::min(least, alpha * path.length - path.priority);
    }
    made.constraints.push_back({alpha, least * (k % 3 == 0 ? unit(random) : 1.0)});
  }
  return made;
}

const PenaltyWeights kWeights[] = {{0.5, 1}, {1, 1}, {1, 0.2}, {0.2, 1}, {0.02, 1}};

TEST(PenaltyBound, IsNeverAboveAPathThatMeetsItsConstraints) {
  std::mt19937_64 random(1);
  double nearest = kInfinity;
  for (int k = 0; k < 1000; ++k) {
    PenaltyWeights weights = kWeights[k % 5];
    if (k % 50 == 0) weights = {0, 1};
    if (k % 50 == 1) weights = {1, 0};
    const Instance made = random_instance(random, weights, k % 6);
    const double value = made.bound().lowest().value;
    ASSERT_LE(value, made.least_penalty()) << k;
    nearest = std::min(nearest, made.least_penalty() - value);
  }
  EXPECT_LT(nearest, 1e-3);
}

TEST(PenaltyBound, IsTakenOnAtItsLengthAndNowhereUndercut) {
  std::mt19937_64 random(2);
  int beyond = 0;  // bounds that lie at a longer length than the direct one
  for (int k = 0; k < 500; ++k) {
    const Instance made = random_instance(random, kWeights[k % 5], k % 6);
    const PenaltyBound::Point lowest = made.bound().lowest();
    const double scale = 1.0 + std::abs(lowest.value);
    ASSERT_NEAR(lowest.value, made.lowest_at(lowest.length), 1e-8 * scale);
    ASSERT_GE(lowest.length, made.direct);
    for (double length = made.direct; length < 100.0 * made.direct; length *= 1.01) {
      ASSERT_LE(lowest.value, made.lowest_at(length));
    }
    beyond += lowest.length > 1.001 * made.direct;
  }
  EXPECT_GT(beyond, 100);
}

TEST(PenaltyBound, RisesWithAllThatIsLearned) {
  std::mt19937_64 random(3);
  int risen = 0;
  for (int k = 0; k < 300; ++k) {
    const Instance made = random_instance(random, kWeights[k % 5], 5);
    PenaltyBound bound(made.weights, made.direct, made.most);
    double value = bound.lowest().value;
    const auto learned = [&] {
      const double next = bound.lowest().value;
      EXPECT_GE(next, value - 1e-8 * (1.0 + std::abs(value))) << k;
      risen += next > value + 1e-6;
      value = next;
    };
    for (const Constraint& each : made.constraints) {
      bound.add(each.alpha, each.min_cost);
      learned();
    }
    double shortest = kInfinity;
    for (const PathTally& path : made.paths) shortest = std::min(shortest, path.length);
    bound.add_min_length(shortest);
    bound.add_min_length(0.5 * shortest);  // the longest of them counts
    learned();
    double most = 0.0;
    for (const PathTally& path : made.paths) most = std::max(most, path.mean_priority());
    bound.set_max_priority(most);
    learned();
    ASSERT_LE(value, made.least_penalty());
    ASSERT_GE(bound.lowest().length, shortest * (1.0 - 1e-12));
  }
  EXPECT_GT(risen, 300);
}

TEST(PenaltyBound, KnowsHowLongAPathBelowAPenaltyCanBe) {
  std::mt19937_64 random(4);
  for (int k = 0; k < 200; ++k) {
    const Instance made = random_instance(random, kWeights[k % 5], 0);
    const PenaltyBound bound = made.bound();
    const Penalty penalty(made.weights, made.direct);
    for (const PathTally& path : made.paths) {
      ASSERT_LE(path.length, bound.longest_below(penalty(path)) * (1.0 + 1e-12));
    }
    // As long as that is a path over nothing but the best ground.
    const double longest = bound.longest_below(0.7);
    ASSERT_NEAR(penalty(longest, longest * made.most), 0.7, 1e-9);
  }
  EXPECT_EQ(PenaltyBound({0, 1}, 10.0, 1.0).longest_below(-0.5), kInfinity);
}

TEST(PenaltyBound, LinearisesEq5WhereAPathIs) {
  // Along alpha dL - dP = 0 Eq. (5) does not change, to the first order.
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int k = 0; k < 200; ++k) {
    const Instance made = random_instance(random, kWeights[k % 5], 0);
    const Penalty penalty(made.weights, made.direct);
    const PathTally& path = made.paths.front();
    const double alpha = made.bound().alpha_at(path.length, path.mean_priority());
    const double step = 1e-4 * path.length;
    const double up = penalty(path.length + step, path.priority + alpha * step);
    const double down = penalty(path.length - step, path.priority - alpha * step);
    ASSERT_NEAR((up - down) / (2.0 * step), 0.0, 1e-6);
  }
}

TEST(PenaltyBound, LetsEveryStepCostSomething) {
  PenaltyBound bound({0.5, 1}, 100.0, 0.8);
  EXPECT_GT(bound.min_alpha(), 0.8);
  bound.set_max_priority(0.3);
  EXPECT_EQ(bound.max_priority(), 0.3);
  EXPECT_GT(bound.min_alpha(), 0.3);
  EXPECT_LT(bound.min_alpha(), 0.31);
}

}  // namespace
}  // namespace ltp::planning
