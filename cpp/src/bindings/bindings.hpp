// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// What the binding files share: one function a floor, and the arguments that come from Python.
#pragma once

#include <pybind11/eigen.h>
#include <pybind11/functional.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>
#include <type_traits>
#include <utility>

#include "ltp/geometry/check.hpp"
#include "ltp/geometry/types.hpp"
#include "points.hpp"

namespace py = pybind11;
using namespace pybind11::literals;  // NOLINT: "name"_a

void bind_geometry(py::module_& m);
void bind_grid(py::module_& m);
void bind_cost(py::module_& m);
void bind_sensing(py::module_& m);
void bind_mapping(py::module_& m);
void bind_planning(py::module_& m);
void bind_navigation(py::module_& m);
void bind_reprs(py::module_& m);
void bind_old_names(py::module_& m);

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
  const py::type type = py::type::of(view);
  for (const auto& item : keywords) {
    const std::string name = py::str(item.first);
    if (!py::hasattr(type, name.c_str())) {
      const std::string owner = py::str(type.attr("__name__"));
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

/// Issues a `DeprecationWarning` at the Python line that is running.
inline void warn_deprecated(const std::string& text) {
  if (PyErr_WarnEx(PyExc_DeprecationWarning, text.c_str(), 1) != 0) throw py::error_already_set();
}

/// The Python class of an options or result struct. Each field that it is given becomes an
/// attribute, a name in `__fields__`, which is what `ltp.config` reads and writes, and a part of
/// the repr.
template <typename Struct>
class Fields {
 public:
  Fields(py::module_& m, const char* name, const char* doc) : class_(m, name, doc) {
    class_.attr("__fields__") = py::tuple();
    class_.def("__repr__", &repr);
  }

  /// A field that may be read and set.
  template <typename Value>
  Fields& field(const char* name, Value Struct::*member, const char* doc) {
    class_.def_readwrite(name, member, doc);
    return listed(name);
  }
  template <typename Getter, typename Setter>
  Fields& field(const char* name, const Getter& get, const Setter& set, const char* doc) {
    class_.def_property(name, get, set, doc);
    return listed(name);
  }

  /// A field that may only be read.
  template <typename Value>
  Fields& result(const char* name, Value Struct::*member, const char* doc) {
    class_.def_readonly(name, member, doc);
    return listed(name);
  }
  template <typename Getter>
  Fields& result(const char* name, const Getter& get, const char* doc) {
    class_.def_property_readonly(name, get, doc);
    return listed(name);
  }

  /// For what is no field: constructors, methods, attributes that a repr has no room for.
  py::class_<Struct>& bound() { return class_; }

 private:
  Fields& listed(const char* name) {
    const py::object before = class_.attr("__fields__");
    class_.attr("__fields__") = before + py::make_tuple(name);
    return *this;
  }

  static std::string repr(const py::object& self) {
    std::string fields;
    for (const py::handle name : py::type::of(self).attr("__fields__")) {
      if (!fields.empty()) fields += ", ";
      fields += std::string(py::str(name)) + "=" + std::string(py::repr(self.attr(name)));
    }
    return std::string(py::str(py::type::of(self).attr("__name__"))) + "(" + fields + ")";
  }

  py::class_<Struct> class_;
};

template <typename Struct, typename = void>
struct HasCheck : std::false_type {};
template <typename Struct>
struct HasCheck<Struct, std::void_t<decltype(std::declval<const Struct&>().check())>>
    : std::true_type {};

/// The Python class of an options struct: made by keywords, copied as a value, and checked where
/// it can be.
template <typename Options>
Fields<Options> options_class(py::module_& m, const char* name, const char* doc) {
  Fields<Options> fields(m, name, doc);
  fields.bound()
      .def(py::init(&from_keywords<Options>))
      .def("__copy__", [](const Options& self) { return self; })
      .def(
          "__deepcopy__", [](const Options& self, const py::dict&) { return self; }, "memo"_a);
  if constexpr (HasCheck<Options>::value) {
    fields.bound().def("check", &Options::check, "Raises `ValueError` that names the field.");
  }
  return fields;
}
