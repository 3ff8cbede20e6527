// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/navigation/way_progress.hpp"

namespace ltp {
namespace {

/// Plans in a row, on one map, that may leave the way to a waypoint as long as it was: a UAV that
/// is blown about. After that it follows the shortest way itself.
constexpr int kStalls = 3;

}  // namespace

double WayProgress::detour(double left) {
  const double whole = flown_ + left;
  if (!first_length_) first_length_ = whole;
  return whole - *first_length_;
}

bool WayProgress::stalls(double left, std::int64_t version, double least) {
  if (measured_on_ != version || left < least_left_ - least) {
    measured_on_ = version;
    least_left_ = left;
    stalls_ = 0;
  } else {
    ++stalls_;
  }
  return stalls_ > kStalls;
}

}  // namespace ltp
