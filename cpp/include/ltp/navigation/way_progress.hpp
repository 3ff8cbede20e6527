// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `WayProgress`: whether the way to a waypoint grows shorter, measured.
#pragma once

#include <cstdint>
#include <optional>

namespace ltp {

/// Of the way to one waypoint: begins anew with the next one.
class WayProgress {
 public:
  void fly(double metres) { flown_ += metres; }

  /// What the waypoint costs, flown and left, more than the shortest way known at first [m].
  double detour(double left);

  /// Whether the way has grown no shorter, several times in a row, though nothing new was seen.
  /// @param left     of the shortest way [m]
  /// @param version  of the map that it was measured on
  /// @param least    by which it grows shorter [m]
  bool stalls(double left, std::int64_t version, double least);

  /// Whether the way was measured on a map last.
  bool measured_on(std::int64_t version) const { return measured_on_ == version; }

 private:
  double flown_ = 0.0;                  ///< since the waypoint became the next one [m]
  std::optional<double> first_length_;  ///< of the way to it that was known at first [m]
  double least_left_ = 0.0;             ///< shortest so far on the same map [m]
  std::int64_t measured_on_ = -1;       ///< version of the map for `least_left_`
  int stalls_ = 0;                      ///< times in a row that the way had grown no shorter
};

}  // namespace ltp
