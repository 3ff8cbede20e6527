// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The names of version 0.1 in Python: for one release they still work, and warn.
#include <string>

#include "bindings.hpp"
#include "flying.hpp"
#include "ltp/planning/planners.hpp"

namespace {

void warn(const std::string& old_name, const std::string& name) {
  warn_deprecated("`" + old_name + "` is now `" + name +
                  "`; the old name goes with the next release");
}

/// A class that was bound before.
template <typename Class>
py::class_<Class> bound() {
  return py::reinterpret_borrow<py::class_<Class>>(py::type::of<Class>());
}

template <typename Class>
void attribute(const std::string& old_name, const std::string& name) {
  bound<Class>().def_property_readonly(
      old_name.c_str(),
      [old_name, name](const py::object& self) -> py::object {
        warn(old_name, name);
        return self.attr(name.c_str());
      },
      ("The old name of `" + name + "`.").c_str());
}

/// A field that may be set. Its new name may lead through others, with dots between.
template <typename Class>
void field(const std::string& old_name, const std::string& holder, const std::string& name) {
  const std::string whole = holder.empty() ? name : holder + "." + name;
  const auto owner = [holder](const py::object& self) {
    return holder.empty() ? self : py::object(self.attr(holder.c_str()));
  };
  bound<Class>().def_property(
      old_name.c_str(),
      [=](const py::object& self) -> py::object {
        warn(old_name, whole);
        return owner(self).attr(name.c_str());
      },
      [=](const py::object& self, const py::object& value) {
        warn(old_name, whole);
        py::setattr(owner(self), name.c_str(), value);
      },
      ("The old name of `" + whole + "`.").c_str());
}

template <typename Class>
void set_way_points() {
  bound<Class>().def(
      "set_way_points",
      [](const py::object& self, const py::object& way_points) {
        warn("set_way_points", "set_waypoints");
        self.attr("set_waypoints")(way_points);
      },
      "way_points"_a, "The old name of `set_waypoints`.");
}

/// What is no longer limited.
void memory_widths() {
  const auto tell = [] {
    warn_deprecated(
        "`memory_widths` has no effect: what was seen is remembered without limit; the name goes "
        "with the next release");
  };
  bound<ltp::NavigationOptions>().def_property(
      "memory_widths",
      [tell](const ltp::NavigationOptions&) {
        tell();
        return 3;
      },
      [tell](ltp::NavigationOptions&, int) { tell(); }, "Without effect.");
}

}  // namespace

void bind_old_names(py::module_&) {
  set_way_points<bindings::Ltp>();
  attribute<bindings::Ltp>("way_points", "waypoints");
  attribute<bindings::Ltp>("way_point_index", "waypoint_index");
  set_way_points<bindings::Concurrent>();
  attribute<bindings::Concurrent>("way_points", "waypoints");
  attribute<ltp::Decision>("way_point_index", "waypoint_index");
  attribute<ltp::PlanRecord>("way_point", "waypoint");
  memory_widths();
  field<ltp::PlannerOptions>("length_weight", "weights", "length");
  field<ltp::PlannerOptions>("priority_weight", "weights", "priority");
  field<ltp::PlannerOptions>("pareto", "", "exact");
  field<ltp::PlannerOptions>("bug", "", "tangent_bug");
}
