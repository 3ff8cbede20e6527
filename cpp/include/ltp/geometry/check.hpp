// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Argument checks that name the culprit: argument, value, what was expected. They allocate only to
// complain.
#pragma once

#include <cmath>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "ltp/geometry/types.hpp"

namespace ltp::check {

/// Throws `std::invalid_argument` "<name> = <value>: expected <expectation>".
template <typename Value>
[[noreturn]] void fail(std::string_view name, const Value& value, const char* expectation) {
  std::ostringstream text;
  text << name << " = " << value << ": expected " << expectation;
  throw std::invalid_argument(text.str());
}

inline void positive(std::string_view name, double value) {
  if (!(value > 0.0) || !std::isfinite(value)) fail(name, value, "a positive finite number");
}

inline void not_negative(std::string_view name, double value) {
  if (!(value >= 0.0) || !std::isfinite(value)) fail(name, value, "a finite number >= 0");
}

inline void at_least(std::string_view name, std::int64_t value, std::int64_t least) {
  if (value < least) fail(name, value, ("a number >= " + std::to_string(least)).c_str());
}

template <typename Number>
void between(std::string_view name, Number value, int least, int most) {
  if (value >= least && value <= most) return;
  fail(name, value,
       ("a number from " + std::to_string(least) + " to " + std::to_string(most)).c_str());
}

inline void odd(std::string_view name, int value) {
  if (value < 1 || value % 2 == 0) fail(name, value, "an odd number >= 1");
}

inline void finite(std::string_view name, double value) {
  if (!std::isfinite(value)) fail(name, value, "a finite number");
}

/// That neighbours among `count` cells from an origin on can be told apart, up to the last one.
inline void resolvable(std::string_view name, double cell, double origin, std::int64_t count) {
  const double end = origin + static_cast<double>(count) * cell;
  if (std::isfinite(end) && origin + cell > origin && end - cell < end) return;
  fail(name, cell, "an edge by which cells differ so far from zero, all at finite coordinates");
}

inline void finite(std::string_view name, const Point& value) {
  if (!value.allFinite()) fail(name, value.transpose(), "three finite numbers");
}

inline void finite(std::string_view name, const Pose& value) {
  finite(std::string(name) + ".position", value.position);
  const double norm = value.world_from_body.norm();
  if (!(std::abs(norm - 1.0) < 1e-6)) {
    fail(std::string(name) + ".orientation", value.world_from_body.coeffs().transpose(),
         "a unit quaternion");
  }
}

}  // namespace ltp::check
