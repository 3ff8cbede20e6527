// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Floor 0 in Python: poses and polylines.
#include "bindings.hpp"
#include "ltp/geometry/polyline.hpp"

namespace {

ltp::Pose make_pose(const ltp::Point& position, double yaw, double pitch, double roll) {
  ltp::check::finite("yaw", yaw);
  ltp::check::finite("pitch", pitch);
  ltp::check::finite("roll", roll);
  ltp::Pose pose;
  pose.position = position;
  pose.world_from_body = Eigen::AngleAxisd(yaw, ltp::Point::UnitZ()) *
                         Eigen::AngleAxisd(pitch, ltp::Point::UnitY()) *
                         Eigen::AngleAxisd(roll, ltp::Point::UnitX());
  ltp::check::finite("pose", pose);
  return pose;
}

}  // namespace

void bind_geometry(py::module_& m) {
  py::class_<ltp::Pose>(
      m, "Pose", "Where a body is and how it is turned (world ENU, body x forward, y left, z up).")
      .def(
          py::init(&make_pose), "position"_a, py::kw_only(), "yaw"_a = 0.0, "pitch"_a = 0.0,
          "roll"_a = 0.0,
          "position: (3,) [m]. yaw, pitch, roll: turns about z, y, x, applied in this order [rad].")
      .def_readonly("position", &ltp::Pose::position, "(3,), world [m]")
      .def_property_readonly(
          "rotation", [](const ltp::Pose& pose) { return pose.world_from_body.toRotationMatrix(); },
          "(3, 3), world from body");

  m.def(
      "path_length",
      [](const ltp::PathRef& path) {
        require_finite("path", path);
        return ltp::length(path);
      },
      "path"_a, "Length of a polyline, path: (N, 3) [m].");
  m.def(
      "resample",
      [](const ltp::PathRef& path, double spacing) {
        require_finite("path", path);
        return ltp::resample(path, spacing);
      },
      "path"_a, "spacing"_a,
      "Points every `spacing` [m] along a polyline, both ends kept: (M, 3). path: (N, 3), N >= 1 "
      "[m].");
  m.def(
      "closest_point",
      [](const ltp::PathRef& path, const ltp::Point& point, double from_arc_length,
         double to_arc_length) {
        require_finite("path", path);
        ltp::check::finite("point", point);
        const ltp::ClosestPoint found =
            ltp::closest_point(path, point, from_arc_length, to_arc_length);
        return py::make_tuple(found.point, found.arc_length, found.distance);
      },
      "path"_a, "point"_a, "from_arc_length"_a = 0.0,
      "to_arc_length"_a = std::numeric_limits<double>::infinity(),
      "(point (3,), arc length [m], distance [m]) of the closest point of a polyline between two "
      "arc lengths.");
  m.def(
      "point_at",
      [](const ltp::PathRef& path, double arc_length) {
        require_finite("path", path);
        return ltp::point_at(path, arc_length);
      },
      "path"_a, "arc_length"_a,
      "The point (3,) at an arc length [m] of a polyline; clamped to its ends.");
}
