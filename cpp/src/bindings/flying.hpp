// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The loops that fly, with what their planner was made of: to make it anew with other weights.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "ltp/navigation/concurrent_trajectory_planner.hpp"
#include "ltp/navigation/local_trajectory_planner.hpp"
#include "ltp/planning/planners.hpp"

namespace bindings {

template <typename Kind>
class Flying : public Kind {
 public:
  Flying(const ltp::Raster& priority, const ltp::Point& position, std::string planner,
         const ltp::PlannerOptions& planner_options, const ltp::ObstacleMapOptions& map_options,
         const ltp::NavigationOptions& options)
      : Kind(ltp::make_planner(planner, planner_options), map_options, options, priority, position),
        name_(std::move(planner)),
        options_(planner_options) {}

  void remake_planner(const std::string& planner, const ltp::PlannerOptions& options,
                      double keep_if_within) {
    this->set_planner(ltp::make_planner(planner, options), keep_if_within);
    name_ = planner;
    options_ = options;
  }
  void set_weights(const ltp::PenaltyWeights& weights, double keep_if_within) {
    ltp::PlannerOptions options = options_;
    options.weights = weights;
    remake_planner(name_, options, keep_if_within);
  }

 private:
  std::string name_;
  ltp::PlannerOptions options_;
};

using Ltp = Flying<ltp::LocalTrajectoryPlanner>;
using Concurrent = Flying<ltp::ConcurrentTrajectoryPlanner>;

}  // namespace bindings
