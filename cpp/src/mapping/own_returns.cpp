// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/mapping/own_returns.hpp"

#include <algorithm>

#include "ltp/geometry/norm.hpp"

namespace ltp {

OwnReturns::OwnReturns(const ObstacleMapOptions& options, const Pose& sensor)
    : blind_distance_(options.blind_distance),
      has_body_(options.has_body()),
      low_(options.body_min),
      high_(options.body_max),
      body_from_world_(sensor.world_from_body.conjugate()) {
  constexpr double kHair = 1e-9;  // far above rounding
  const double corner = norm(low_.cwiseAbs().cwiseMax(high_.cwiseAbs()));
  reach_ = (1.0 + kHair) * std::max(blind_distance_, has_body_ ? corner : 0.0);
}

OwnReturns::Verdict OwnReturns::operator()(const Point& offset) const {
  if (norm(offset) < blind_distance_) return Verdict::TooNear;
  const Point place = body_from_world_ * offset;
  const bool in_body =
      has_body_ && (place.array() >= low_.array()).all() && (place.array() <= high_.array()).all();
  return in_body ? Verdict::InBody : Verdict::Obstacle;
}

}  // namespace ltp
