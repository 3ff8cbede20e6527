// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `own`: values that a Python object borrows from another one are there to be asked, not changed.
#pragma once

#include <string>

#include "bindings.hpp"

/// The value, if its Python object owns it. Throws `ValueError` if it is part of something else: a
/// map of its planner, a grid of its map. Needs the GIL.
template <typename T>
T& own(T& value) {
  const py::object self = py::cast(&value, py::return_value_policy::reference);
  if (!reinterpret_cast<const py::detail::instance*>(self.ptr())->owned) {
    const std::string name = py::str(py::type::of(self).attr("__name__"));
    throw py::value_error("this " + name + " belongs to another object and is read-only");
  }
  return value;
}
