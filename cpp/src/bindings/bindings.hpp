// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// What the binding files share: one function a floor, and the arguments that come from Python.
#pragma once

#include <pybind11/eigen.h>
#include <pybind11/functional.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>

#include "ltp/geometry/check.hpp"
#include "ltp/geometry/types.hpp"

namespace py = pybind11;
using namespace pybind11::literals;  // NOLINT: "name"_a

void bind_geometry(py::module_& m);
void bind_grid(py::module_& m);
void bind_cost(py::module_& m);
void bind_sensing(py::module_& m);
void bind_mapping(py::module_& m);
void bind_planning(py::module_& m);
void bind_navigation(py::module_& m);

/// Throws `ValueError` unless every coordinate of a point set is finite.
inline void require_finite(const char* name, const ltp::PathRef& points) {
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (!points.row(i).allFinite()) {
      ltp::check::fail(std::string(name) + "[" + std::to_string(i) + "]", points.row(i),
                       "three finite numbers");
    }
  }
}

/// Keyword arguments of a struct's constructor: each is set as an attribute, so a name that does
/// not exist fails.
template <typename Options>
Options from_keywords(const py::kwargs& keywords) {
  Options options;
  const py::object view = py::cast(&options, py::return_value_policy::reference);
  for (const auto& item : keywords) {
    const std::string name = py::str(item.first);
    if (!py::hasattr(view, name.c_str())) {
      const std::string owner = py::str(py::type::of(view).attr("__name__"));
      throw py::type_error(owner + " has no field '" + name + "'");
    }
    py::setattr(view, item.first, item.second);
  }
  return options;
}

/// What `bool(status)` does: every status is true, the failures too, so asking is a mistake.
template <typename Enum>
bool no_truth_value(const Enum& status) {
  const std::string name = py::repr(py::cast(status));
  throw py::type_error(name + " has no truth value: compare it with a status");
}

/// A repr that lists the fields of an options or result struct.
template <typename Class>
void list_fields(Class& cls, std::initializer_list<const char*> names) {
  py::tuple fields(names.size());
  std::size_t count = 0;
  for (const char* name : names) fields[count++] = py::str(name);
  cls.attr("__fields__") = fields;  // what `ltp.config` reads and writes
  cls.def("__repr__", [fields](const py::object& self) {
    std::string text = py::str(py::type::of(self).attr("__name__"));
    text += "(";
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const std::string name = py::str(fields[i]);
      text += (i > 0 ? ", " : "") + name + "=" + std::string(py::repr(self.attr(name.c_str())));
    }
    return text + ")";
  });
}
