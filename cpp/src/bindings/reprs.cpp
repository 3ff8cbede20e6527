// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// What the classes that are no structs of fields say of themselves in Python: one line, SI units.
#include <sstream>
#include <string>

#include "bindings.hpp"
#include "ltp/grid/occupancy_grid.hpp"
#include "ltp/grid/raster.hpp"
#include "ltp/mapping/obstacle_map.hpp"
#include "ltp/planning/planner.hpp"
#include "ltp/sensing/height_surface.hpp"
#include "ltp/sensing/lidar.hpp"
#include "ltp/sensing/octree_surface.hpp"

namespace {

template <typename Vector>
std::string list(const Vector& values) {
  const Eigen::IOFormat row(6, Eigen::DontAlignCols, ", ", ", ", "", "", "(", ")");
  std::ostringstream text;
  text << values.transpose().format(row);
  return text.str();
}

/// The parts of a repr, put together with `<<`.
class Text {
 public:
  template <typename Value>
  Text& operator<<(const Value& value) {
    text_ << value;
    return *this;
  }
  operator std::string() const { return text_.str(); }  // NOLINT: that is what it is for

 private:
  std::ostringstream text_;
};

/// The number of rows of an array, the length of a list.
std::size_t size(const py::object& self, const char* name) { return py::len(self.attr(name)); }

std::string of(const ltp::OccupancyGrid& grid) {
  const ltp::GridFrame& frame = grid.frame();
  return Text() << frame.nx() << " x " << frame.ny() << " x " << frame.nz() << " cells of "
                << list(frame.cell()) << " m from " << list(frame.origin()) << ", " << grid.count()
                << " set";
}

std::string of(const ltp::Raster& raster) {
  return Text() << raster.nx() << " x " << raster.ny() << " cells of " << raster.cell()
                << " m from " << list(raster.origin()) << ", values from "
                << raster.values().minCoeff() << " to " << raster.values().maxCoeff();
}

template <typename Class, typename Say>
void say(const py::module_& m, const char* name, Say say) {
  const py::object kind = m.attr(name);
  kind.attr("__repr__") = py::cpp_function(
      [say, name](const Class& self) {
        return std::string(Text() << name << "(" << say(self) << ")");
      },
      py::name("__repr__"), py::is_method(kind));
}

}  // namespace

void bind_reprs(py::module_& m) {
  say<ltp::Pose>(m, "Pose", [](const ltp::Pose& pose) -> std::string {
    const Eigen::Quaterniond& turn = pose.world_from_body;
    return Text() << "position=" << list(pose.position) << ", rotation=(" << turn.w() << ", "
                  << turn.x() << ", " << turn.y() << ", " << turn.z() << ") as w, x, y, z";
  });
  say<ltp::Raster>(m, "Raster", [](const ltp::Raster& raster) -> std::string {
    return Text() << of(raster) << ", outside=" << raster.outside();
  });
  say<ltp::OccupancyGrid>(m, "OccupancyGrid", [](const auto& grid) { return of(grid); });
  say<ltp::RayHit>(m, "RayHit", [](const ltp::RayHit& hit) -> std::string {
    if (!hit.hit()) return "nothing hit";
    return Text() << "range=" << hit.range << " m, inside=" << list(hit.inside);
  });
  say<ltp::HeightSurface>(m, "HeightSurface",
                          [](const auto& surface) { return of(surface.heights()); });
  say<ltp::OctreeSurface>(m, "OctreeSurface", [](const ltp::OctreeSurface& surface) -> std::string {
    return Text() << surface.size() << " voxels of " << surface.resolution() << " m";
  });
  say<ltp::Scan>(m, "Scan", [](const ltp::Scan& scan) -> std::string {
    return Text() << scan.hits.size() << " hits, " << scan.misses.size() << " misses from "
                  << list(scan.origin);
  });
  say<ltp::Lidar>(m, "Lidar", [](const ltp::Lidar& lidar) -> std::string {
    const ltp::LidarPattern& pattern = lidar.options().pattern;
    return Text() << pattern.azimuths << " x " << pattern.rows << " rays, elevation from "
                  << pattern.elevation_from_deg << " to " << pattern.elevation_to_deg
                  << " deg, max_range=" << lidar.options().max_range << " m";
  });
  say<ltp::ObstacleMap>(m, "ObstacleMap", [](const ltp::ObstacleMap& map) -> std::string {
    return Text() << of(map.occupied()) << ", " << map.blocked().count()
                  << " within inflation_radius=" << map.options().inflation_radius
                  << " m + margin=" << map.options().margin << " m";
  });
  say<ltp::Scene>(m, "Scene", [](const ltp::Scene& scene) -> std::string {
    return Text() << "occupancy: " << of(scene.occupancy) << "; priority: " << of(scene.priority);
  });
  say<ltp::Query>(m, "Query", [](const ltp::Query& query) -> std::string {
    return Text() << "start=" << list(query.start) << ", goal=" << list(query.goal) << ", band=("
                  << query.band.below << ", " << query.band.above << ")";
  });
  say<py::object>(m, "Planner", [](const py::object& self) -> std::string {
    const py::object info = self.attr("info");
    return Text() << std::string(py::repr(info.attr("name"))) << ", "
                  << std::string(py::str(info.attr("title")));
  });
  say<py::object>(m, "LocalTrajectoryPlanner", [](const py::object& self) -> std::string {
    return Text() << std::string(py::str(self.attr("status").attr("name"))) << ", waypoint "
                  << std::string(py::str(self.attr("waypoint_index"))) << " of "
                  << size(self, "waypoints") << ", a path of " << size(self, "path") << " points, "
                  << std::string(py::str(self.attr("plans_made"))) << " plans made";
  });
  say<py::object>(m, "ConcurrentTrajectoryPlanner", [](const py::object& self) -> std::string {
    return Text() << size(self, "waypoints") << " waypoints, "
                  << std::string(py::str(self.attr("scans"))) << " scans sensed";
  });
}
