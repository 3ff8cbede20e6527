// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Floor 2 in Python: the penalty.
#include "bindings.hpp"
#include "ltp/cost/penalty.hpp"

void bind_cost(py::module_& m) {
  options_class<ltp::PenaltyWeights>(m, "PenaltyWeights", "W_L and W_P of Eq. (5).")
      .field("length", &ltp::PenaltyWeights::length,
             "W_L, of the length over the direct length; >= 0")
      .field("priority", &ltp::PenaltyWeights::priority,
             "W_P, of the mean priority along the path; >= 0");

  Fields<ltp::PathTally>(m, "PathTally", "The two integrals along a path that Eq. (5) is made of.")
      .result("length", &ltp::PathTally::length, "L, Eq. (2) [m]")
      .result("priority", &ltp::PathTally::priority,
              "integral of the priority along the path, Eq. (4) [m]")
      .bound()
      .def(py::init([](double length, double priority) {
             return ltp::PathTally{length, priority};
           }),
           py::kw_only(), "length"_a = 0.0, "priority"_a = 0.0)
      .def_property_readonly("mean_priority", &ltp::PathTally::mean_priority,
                             "-Eq. (4), in [0, 1]");
  m.def(
      "tally",
      [](const ltp::PathRef& path, const ltp::Raster& priority) {
        require_finite("path", path);
        return ltp::tally(path, priority);
      },
      "path"_a, "priority"_a,
      "Length and priority integral of a path (N, 3) [m]; exact for a priority constant on each "
      "cell of its raster.");
  m.def(
      "penalty",
      [](const ltp::PathTally& sums, double direct_length, const ltp::PenaltyWeights& weights) {
        return ltp::Penalty(weights, direct_length)(sums);
      },
      "tally"_a, "direct_length"_a, "weights"_a = ltp::PenaltyWeights{},
      "Eq. (5): weights.length * L / direct_length - weights.priority * mean priority.");
  m.def(
      "penalty",
      [](const ltp::PathTally& sums, double direct_length, double length_weight,
         double priority_weight) {
        warn_deprecated("penalty(length_weight=, priority_weight=): use weights=PenaltyWeights()");
        return ltp::Penalty({length_weight, priority_weight}, direct_length)(sums);
      },
      "tally"_a, "direct_length"_a, "length_weight"_a = 0.5, "priority_weight"_a = 1.0,
      "Deprecated: give `weights`.");
}
