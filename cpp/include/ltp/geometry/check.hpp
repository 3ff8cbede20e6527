// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Argument checks that name the culprit: argument, value, what was expected.
#pragma once

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

#include "ltp/geometry/types.hpp"

namespace ltp::check {

/// Throws `std::invalid_argument` "<name> = <value>: expected <expectation>".
template <typename Value>
[[noreturn]] void fail(const std::string& name, const Value& value, const char* expectation) {
  std::ostringstream text;
  text << name << " = " << value << ": expected " << expectation;
  throw std::invalid_argument(text.str());
}

inline void positive(const std::string& name, double value) {
  if (!(value > 0.0) || !std::isfinite(value)) fail(name, value, "a positive finite number");
}

inline void not_negative(const std::string& name, double value) {
  if (!(value >= 0.0) || !std::isfinite(value)) fail(name, value, "a finite number >= 0");
}

inline void finite(const std::string& name, double value) {
  if (!std::isfinite(value)) fail(name, value, "a finite number");
}

inline void finite(const std::string& name, const Point& value) {
  if (!value.allFinite()) fail(name, value.transpose(), "three finite numbers");
}

inline void finite(const std::string& name, const Pose& value) {
  finite(name + ".position", value.position);
  const double norm = value.world_from_body.norm();
  if (!(std::abs(norm - 1.0) < 1e-6)) {
    fail(name + ".orientation", value.world_from_body.coeffs().transpose(), "a unit quaternion");
  }
}

}  // namespace ltp::check
