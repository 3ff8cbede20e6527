// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Floor 2 in Python: surfaces, the LiDAR and its scans.
#include <pybind11/numpy.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "bindings.hpp"
#include "ltp/sensing/height_surface.hpp"
#include "ltp/sensing/lidar.hpp"
#include "ltp/sensing/octree_surface.hpp"

namespace {

using ReleaseGil = py::call_guard<py::gil_scoped_release>;

template <typename Vector>
bool is_unit(const Vector& direction) {
  return std::abs(direction.squaredNorm() - 1.0) < 2e-6;  // false for NaN
}

ltp::RayHit cast(const ltp::Surface& surface, const ltp::Point& origin, const ltp::Point& direction,
                 double max_range) {
  ltp::check::finite("origin", origin);
  if (!is_unit(direction)) ltp::check::fail("direction", direction.transpose(), "a unit vector");
  ltp::check::positive("max_range", max_range);
  return surface.cast(origin, direction, max_range);
}

/// In pieces, so that Ctrl-C gets through.
py::array_t<double> clearance(const ltp::Surface& surface, const ltp::PathRef& points,
                              double max_distance) {
  constexpr Eigen::Index kPiece = 4096;
  require_finite("points", points);
  ltp::check::not_negative("max_distance", max_distance);
  py::array_t<double> distances(points.rows());
  double* out = distances.mutable_data();
  for (Eigen::Index begin = 0; begin < points.rows(); begin += kPiece) {
    {
      const py::gil_scoped_release release;
      const Eigen::Index end = std::min(begin + kPiece, points.rows());
      for (Eigen::Index n = begin; n < end; ++n) {
        out[n] = surface.clearance(points.row(n).transpose(), max_distance);
      }
    }
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
  return distances;
}

/// In pieces, so that Ctrl-C gets through; each large enough for the surface to gain by it.
py::array_t<double> cast_rays(const ltp::Surface& surface, const ltp::PathRef& origins,
                              const ltp::PathRef& directions, double max_range) {
  constexpr Eigen::Index kPiece = 1 << 18;
  require_finite("origins", origins);
  if (directions.rows() != origins.rows()) {
    ltp::check::fail("directions.shape[0]", directions.rows(), "as many as origins");
  }
  for (Eigen::Index n = 0; n < directions.rows(); ++n) {
    if (!is_unit(directions.row(n))) {
      ltp::check::fail("directions[" + std::to_string(n) + "]", directions.row(n), "a unit vector");
    }
  }
  ltp::check::positive("max_range", max_range);
  py::array_t<double> ranges(origins.rows());
  Eigen::Map<Eigen::VectorXd> out(ranges.mutable_data(), origins.rows());
  for (Eigen::Index begin = 0; begin < origins.rows(); begin += kPiece) {
    {
      const py::gil_scoped_release release;
      const Eigen::Index count = std::min(kPiece, origins.rows() - begin);
      surface.cast_rays(origins.middleRows(begin, count), directions.middleRows(begin, count),
                        max_range, out.segment(begin, count));
    }
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
  return ranges;
}

template <typename Number>
std::unique_ptr<ltp::Scan> scan_of(const ltp::Lidar& lidar, const py::array& ranges,
                                   const ltp::Pose& pose) {
  const auto numbers = py::array_t<Number, py::array::c_style | py::array::forcecast>(ranges);
  const Eigen::Map<const Eigen::Matrix<Number, Eigen::Dynamic, 1>> all(numbers.data(),
                                                                       numbers.size());
  const py::gil_scoped_release release;
  auto scan = std::make_unique<ltp::Scan>();
  lidar.from_ranges(all, pose, *scan);
  return scan;
}

std::unique_ptr<ltp::Scan> from_ranges(const ltp::Lidar& lidar, const py::object& ranges,
                                       const ltp::Pose& pose) {
  const ltp::LidarPattern& pattern = lidar.options().pattern;
  const py::array array = bindings::as_array(ranges);
  const bool is_list = !py::hasattr(ranges, "dtype");
  const bool floating = array && (array.dtype().kind() == 'f' ||
                                  (is_list && array.size() > 0 && array.dtype().kind() == 'i'));
  const bool shaped =
      array && (array.ndim() == 1 || (array.ndim() == 2 && array.shape(0) == pattern.azimuths &&
                                      array.shape(1) == pattern.rows));
  if (!floating || !shaped || array.itemsize() > 8 || array.itemsize() < 4) {
    throw py::type_error("ranges: expected shape (" + std::to_string(pattern.size()) + ",) or (" +
                         std::to_string(pattern.azimuths) + ", " + std::to_string(pattern.rows) +
                         "), azimuths by rows, of float32 or float64, got " +
                         bindings::described(ranges));
  }
  return array.itemsize() == sizeof(float) ? scan_of<float>(lidar, array, pose)
                                           : scan_of<double>(lidar, array, pose);
}

/// A read-only (N, 3) view of a scan's points that keeps the scan alive.
template <std::vector<ltp::Point> ltp::Scan::*kPoints>
py::array points_view(const py::object& self) {
  static_assert(sizeof(ltp::Point) == 3 * sizeof(double));
  const std::vector<ltp::Point>& points = self.cast<const ltp::Scan&>().*kPoints;
  const auto rows = static_cast<py::ssize_t>(points.size());
  py::array_t<double> view({rows, py::ssize_t{3}}, rows > 0 ? points.front().data() : nullptr,
                           self);
  view.attr("flags").attr("writeable") = false;
  return view;
}

void bind_surfaces(py::module_& m) {
  py::class_<ltp::RayHit>(m, "RayHit", "Where a ray first meets a surface.")
      .def_readonly("range", &ltp::RayHit::range, "from the ray's origin [m]; inf: no hit")
      .def_readonly("inside", &ltp::RayHit::inside,
                    "(3,), the point hit, moved 1 mm into the solid through the face hit; NaN: no "
                    "hit")
      .def_property_readonly("hit", &ltp::RayHit::hit, "whether there is one");

  py::class_<ltp::Surface>(m, "Surface", "Something that a ray can hit.")
      .def("cast", &cast, "origin"_a, "direction"_a, "max_range"_a,
           "The first hit nearer than max_range [m] of the ray from origin (3,) along the unit "
           "vector\ndirection (3,). A ray that starts inside the solid hits at range 0.")
      .def("cast_rays", &cast_rays, "origins"_a, "directions"_a, "max_range"_a,
           "(N,): ranges [m] of the rays from origins (N, 3) [m] along the unit vectors directions "
           "(N, 3);\ninf: no hit nearer than max_range [m]. Neighbours with the same "
           "origin are cast\ntogether, a thousand or more of them several times faster.")
      .def("first_collision", &ltp::Surface::first_collision, "path"_a, ReleaseGil(),
           "Arc length [m] at which a path (N, 3) first touches the solid, exactly along "
           "its\nsegments; None if it never does. Grazing a top or a wall touches it.")
      .def("clearance", &clearance, "points"_a, "max_distance"_a,
           "(N,): distance [m] from points (N, 3) to the solid, 0 inside it, at most\n"
           "max_distance.");

  py::class_<ltp::HeightSurface, ltp::Surface>(
      m, "HeightSurface",
      "The exact surface of a height raster: each cell is a solid column from below everything up\n"
      "to its height. Outside the raster there is nothing.")
      .def(py::init<ltp::Raster>(), "heights"_a, ReleaseGil(), "heights: above the datum [m].")
      .def_property_readonly("heights", &ltp::HeightSurface::heights,
                             py::return_value_policy::reference_internal)
      .def("occupancy", &ltp::HeightSurface::occupancy, "frame"_a, ReleaseGil(),
           "OccupancyGrid of the cells that hold any of the solid: what a perfect and complete "
           "sensor\nwould map.");

  py::class_<ltp::OctreeSurface, ltp::Surface>(
      m, "OctreeSurface",
      "The occupied voxels of an OctoMap octree, as bricks of bits; rays are walked exactly. The\n"
      "bounding box may have any size; ValueError if voxels lie so scattered that they would take\n"
      "more than 1 GiB.")
      .def(py::init([](const std::filesystem::path& path) {
             return std::make_unique<ltp::OctreeSurface>(path.string());
           }),
           "path"_a, ReleaseGil(),
           "Reads a .bt or .ot file. ValueError names the file and what is wrong with it.")
      .def(py::init<const ltp::PathRef&, double>(), "points"_a, "resolution"_a, ReleaseGil(),
           "Voxels of edge resolution [m], 1e-6 to 1e6, that hold points (N, 3) [m].")
      .def_property_readonly("resolution", &ltp::OctreeSurface::resolution, "edge of a voxel [m]")
      .def_property_readonly("size", &ltp::OctreeSurface::size, "occupied voxels")
      .def_property_readonly("memory", &ltp::OctreeSurface::memory,
                             "of the bricks and what is above them [bytes]")
      .def_property_readonly("voxels", &ltp::OctreeSurface::voxels,
                             py::return_value_policy::reference_internal,
                             "OccupancyGrid over their bounding box, made when it is first asked "
                             "for; ValueError if\nthe box has 2^31 voxels or more");
}

void bind_options(py::module_& m) {
  using Pattern = ltp::LidarPattern;
  options_class<Pattern>(
      m, "LidarPattern",
      "The rays of one revolution, in the sensor's frame (x forward, y left, z up).")
      .field("azimuths", &Pattern::azimuths, "rays a row, evenly over the range, >= 1")
      .field("azimuth_from_deg", &Pattern::azimuth_from_deg,
             "first azimuth, counter-clockwise from x [deg]")
      .field("azimuth_to_deg", &Pattern::azimuth_to_deg,
             "last azimuth; a full circle stops one step short [deg]")
      .field("rows", &Pattern::rows, "rows, evenly over the range, both ends, >= 1")
      .field("elevation_from_deg", &Pattern::elevation_from_deg,
             "lowest row, and the only one if rows = 1; > -90 [deg]")
      .field("elevation_to_deg", &Pattern::elevation_to_deg, "highest row; < 90 [deg]");

  using Options = ltp::LidarOptions;
  options_class<Options>(m, "LidarOptions", "Settings of the LiDAR.")
      .field("pattern", &Options::pattern, "which rays")
      .field("min_range", &Options::min_range,
             "a return nearer than it is no return, nor a miss [m]")
      .field("max_range", &Options::max_range, "a return at or beyond it is no return [m]")
      .field("range_noise_sd", &Options::range_noise_sd, "standard deviation of a range [m]")
      .field("drop_out", &Options::drop_out, "probability that a return is lost, in [0, 1]")
      .field("seed", &Options::seed, "of noise and drop-out");
}

void bind_scan(py::module_& m) {
  using Statistics = ltp::ScanStatistics;
  Fields<Statistics>(m, "ScanStatistics",
                     "What became of a scan's rays; the counts add up to all of them.")
      .result("hits", &Statistics::hits, "returns between the minimum and the maximum range")
      .result("misses", &Statistics::misses, "no return: +inf, or at or beyond the maximum range")
      .result("too_near", &Statistics::too_near, "returns nearer than the minimum range")
      .result("invalid", &Statistics::invalid, "NaN, 0, negative or -inf")
      .result("dropped", &Statistics::dropped, "returns lost to drop-out");

  py::class_<ltp::Scan>(m, "Scan", "One revolution of a LiDAR, in the world frame.")
      .def_readonly("origin", &ltp::Scan::origin, "(3,), of all its rays [m]")
      .def_property_readonly("hits", &points_view<&ltp::Scan::hits>,
                             "(N, 3), end points of the returns [m]; a read-only view")
      .def_property_readonly("misses", &points_view<&ltp::Scan::misses>,
                             "(M, 3), where rays without a return end, at the maximum range [m]; a "
                             "read-only view; empty if only counted")
      .def_readonly("statistics", &ltp::Scan::statistics);
}

}  // namespace

void bind_sensing(py::module_& m) {
  bind_surfaces(m);
  bind_options(m);
  bind_scan(m);

  py::class_<ltp::Lidar>(m, "Lidar", "A scanning LiDAR. May be used from several threads at once.")
      .def(py::init<const ltp::LidarOptions&>(), "options"_a = ltp::LidarOptions(),
           "ValueError names the option that is wrong.")
      .def_property_readonly("options", &ltp::Lidar::options, py::return_value_policy::copy)
      .def_property_readonly("directions", &ltp::Lidar::directions,
                             py::return_value_policy::reference_internal,
                             "(azimuths * rows, 3), unit vectors in the sensor frame: azimuth by "
                             "azimuth, rows ascending; a\nread-only view")
      .def(
          "scan",
          [](const ltp::Lidar& lidar, const ltp::Surface& surface, const ltp::Pose& pose,
             std::uint64_t sequence, bool misses) {
            auto scan = std::make_unique<ltp::Scan>();
            lidar.scan(surface, pose, sequence, *scan,
                       misses ? ltp::Misses::Listed : ltp::Misses::Counted);
            return scan;
          },
          "surface"_a, "pose"_a, "sequence"_a = 0, py::kw_only(), "misses"_a = true, ReleaseGil(),
          "Scans a surface. sequence numbers the scan: noise differs from scan to scan and repeats "
          "from\nrun to run. misses=False only counts the misses, which saves about half of the "
          "time.")
      .def(
          "from_ranges", &from_ranges, "ranges"_a, "pose"_a,
          "The scan that a real sensor's ranges (azimuths * rows,) or (azimuths, rows) [m] mean, "
          "in the\norder of directions; float32 or float64. NaN, 0, negative and -inf are invalid; "
          "what is nearer than\nthe minimum range is too near; +inf and anything at or beyond the "
          "maximum range is a miss.");
}
