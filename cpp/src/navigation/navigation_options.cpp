// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/navigation/navigation_options.hpp"

#include <algorithm>

#include "ltp/geometry/check.hpp"

namespace ltp {

AltitudeBand NavigationOptions::band_from(double start, double highest) const {
  if (climb == 0.0) return band;
  return {band.below, std::max(0.0, highest + climb - std::max(start, highest))};
}

void NavigationOptions::check() const {
  if (!(band.below >= 0.0)) check::fail("band.below", band.below, "a number >= 0");
  if (!(band.above >= 0.0)) check::fail("band.above", band.above, "a number >= 0");
  if (!(climb >= 0.0)) check::fail("climb", climb, "a number >= 0");
  check::not_negative("reach_distance", reach_distance);
  check::not_negative("leave_distance", leave_distance);
  check::not_negative("gate_radius", gate_radius);
  check::not_negative("gate_height", gate_height);
  check::at_least("horizon", horizon, 1);
  check::positive("escape_distance", escape_distance);
  check::not_negative("max_detour", max_detour);
  Budget{max_expansions, time_limit}.check();
}

std::string_view to_string(NavigationStatus status) {
  switch (status) {
    case NavigationStatus::Finished:
      return "finished";
    case NavigationStatus::Following:
      return "following";
    case NavigationStatus::Escaping:
      return "escaping";
    case NavigationStatus::Holding:
      return "holding";
  }
  return "unknown";
}

}  // namespace ltp
