// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Floor 2 in Python: the penalty.
#include "bindings.hpp"
#include "ltp/cost/penalty.hpp"

void bind_cost(py::module_& m) {
  auto tally = py::class_<ltp::PathTally>(m, "PathTally",
                                          "The two integrals along a path that Eq. (5) is made of.")
                   .def(py::init<>())
                   .def_readonly("length", &ltp::PathTally::length, "L, Eq. (2) [m]")
                   .def_readonly("priority", &ltp::PathTally::priority,
                                 "integral of the priority along the path, Eq. (4) [m]")
                   .def_property_readonly("mean_priority", &ltp::PathTally::mean_priority,
                                          "-Eq. (4), in [0, 1]");
  list_fields(tally, {"length", "priority"});
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
      [](const ltp::PathTally& sums, double direct_length, double length_weight,
         double priority_weight) {
        return ltp::Penalty({length_weight, priority_weight}, direct_length)(sums);
      },
      "tally"_a, "direct_length"_a, "length_weight"_a = 0.5, "priority_weight"_a = 1.0,
      "Eq. (5): length_weight * L / direct_length - priority_weight * mean priority.");
}
