// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The extension module `ltp._core`: one function a floor, in floor order.
#include "bindings.hpp"

PYBIND11_MODULE(_core, m) {
  m.doc() = "The compiled core of ltp. World frame: ENU, metres, z up.";
  m.attr("__version__") = LTP_VERSION;
  bind_geometry(m);
  bind_grid(m);
  bind_cost(m);
  bind_sensing(m);
  bind_mapping(m);
  bind_planning(m);
  bind_navigation(m);
  bind_reprs(m);
  bind_old_names(m);
}
