// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Floor 2 in Python: the obstacle map and its inflation.
#include <pybind11/stl/filesystem.h>

#include "bindings.hpp"
#include "borrowed.hpp"
#include "ltp/mapping/obstacle_map.hpp"

namespace {

using Map = ltp::ObstacleMap;
using Options = ltp::ObstacleMapOptions;
using FilePath = std::filesystem::path;

ltp::InsertStatistics insert(Map& map, const bindings::Place& origin, const bindings::Points& hits,
                             const std::optional<bindings::Points>& misses) {
  own(map);
  const bindings::PointsInUse hit(hits, "hits");
  const bindings::PointsInUse missed(misses, "misses");
  const py::gil_scoped_release release;
  return map.insert(origin.pose, hit.view(), missed.view());
}

void load(Map& map, const FilePath& path) {
  own(map);
  const py::gil_scoped_release release;
  map.load(path.string());
}

ltp::Path remembered(const Map& map) {
  std::vector<ltp::Point> centres;
  const ltp::GridFrame& frame = map.voxels().frame();
  const auto add = [&](const ltp::Cell& voxel) { centres.push_back(frame.centre(voxel)); };
  for (std::int64_t i = 0; i < frame.size(); ++i) {
    const ltp::Cell voxel = frame.cell_at(i);
    if (map.voxels().blocked(voxel)) add(voxel);
  }
  if (map.mission()) {
    const ltp::Cell all = ltp::Cell::Constant(static_cast<int>(ltp::kFarthestCell));
    map.mission()->for_each(-all, all, true, [&](const auto& low, const auto& high, float) {
      for (int x = low.x(); x < high.x(); ++x) {
        for (int y = low.y(); y < high.y(); ++y) {
          for (int z = low.z(); z < high.z(); ++z) {
            const ltp::Cell voxel = ltp::Cell(x, y, z) - frame.first();
            if (!frame.contains(voxel)) add(voxel);
          }
        }
      }
    });
  }
  ltp::Path rows(centres.size(), 3);
  for (std::size_t i = 0; i < centres.size(); ++i) rows.row(i) = centres[i].transpose();
  return rows;
}

void bind_options(py::module_& m) {
  options_class<Options>(m, "ObstacleMapOptions", "Settings of the obstacle map.")
      .field("cell", &Options::cell,
             "(3,), edges of a planning cell [m], multiples of the smallest one")
      .field("dims", &Options::dims, "planning cells along x, y, z")
      .field("inflation_radius", &Options::inflation_radius,
             "the vehicle's radius [m]: a cell within it, and the margin, of an occupied voxel is "
             "blocked")
      .field("margin", &Options::margin,
             "added to inflation_radius [m], for errors of pose, range and path keeping")
      .field("inflate_whole_cells", &Options::inflate_whole_cells,
             "measure from whole occupied cells, not from the voxels in them: blocks more where "
             "cells are higher than wide")
      .field("max_range", &Options::max_range,
             "a hit at or beyond this distance from the scan's origin marks nothing [m]")
      .field("blind_distance", &Options::blind_distance,
             "a hit nearer than this to the scan's origin marks nothing [m]: the aircraft itself, "
             "or a sensor's own place written for no return; 0: any hit counts")
      .field("body_min", &Options::body_min,
             "(3,), lowest corner of a box about a scan's pose, in its frame, or the world's if "
             "only an origin is given [m]: hits in it mark nothing")
      .field("body_max", &Options::body_max,
             "(3,), its highest corner [m]; the same as body_min: no box")
      .field("remember", &Options::remember,
             "keep what leaves the window, without limit: it is there again when the window comes "
             "back")
      .field("carve_free_space", &Options::carve_free_space, "learn from what rays passed, too")
      .field("keep_hits", &Options::keep_hits,
             "only with carving: rays that pass an occupied voxel say nothing about it")
      .field("hit_log_odds", &Options::hit_log_odds, "added to a voxel by a hit, > 0")
      .field("miss_log_odds", &Options::miss_log_odds, "added by a ray that passes, < 0")
      .field("min_log_odds", &Options::min_log_odds, "clamping, < 0")
      .field("max_log_odds", &Options::max_log_odds, "clamping, > 0");
}

void bind_statistics(py::module_& m) {
  using Statistics = ltp::InsertStatistics;
  Fields<Statistics>(m, "InsertStatistics", "What became of a scan's points, and of the map.")
      .result("marked", &Statistics::marked, "hits that fell into the window")
      .result("too_near", &Statistics::too_near, "hits nearer than the blind distance: ignored")
      .result("in_body", &Statistics::in_body, "hits in the body box: ignored")
      .result("outside", &Statistics::outside,
              "hits beyond the window: kept for when it comes there, if the map remembers and does "
              "not carve")
      .result("out_of_range", &Statistics::out_of_range,
              "hits at or beyond the map's maximum range: treated as misses; many of them, and the "
              "sensor sees\n"
              "farther than the map was told")
      .result("invalid", &Statistics::invalid, "hits or misses that are not finite: ignored")
      .result("new_cells", &Statistics::new_cells, "planning cells that became occupied")
      .result("erased_cells", &Statistics::erased_cells,
              "planning cells that became free by carving")
      .bound()
      .def("warnings", &Statistics::warnings, "options"_a,
           "Sentences: in which ways a map of these ObstacleMapOptions loses more hits than it "
           "should - to max_range and\n"
           "the window's edges (0.1 % of the hits), to blind_distance (any), to the body box (a "
           "tenth). [] if all is well.");
}

}  // namespace

void bind_mapping(py::module_& m) {
  bind_options(m);
  bind_statistics(m);
  const auto view = py::return_value_policy::reference_internal;

  py::class_<Map>(m, "ObstacleMap",
                  "What the sensor has touched round the UAV. Voxels are the memory, planning "
                  "cells the view: a cell is\n"
                  "occupied if any voxel in it is, blocked if its box is within inflation_radius + "
                  "margin of an occupied voxel's\n"
                  "box. Use a map from one thread at a time. The map of a planner is read-only: "
                  "what would change it raises\n"
                  "ValueError.")
      .def(py::init<const Options&, const ltp::Point&>(), "options"_a = Options{},
           "centre"_a = ltp::Point(0, 0, 0),
           "centre: (3,), of the window, world [m]. ValueError names the option that is wrong.")
      .def_property_readonly("options", &Map::options, py::return_value_policy::copy)
      .def_property_readonly("occupied", &Map::occupied, view,
                             "planning cells with a hit in them; a view that follows the map")
      .def_property_readonly("blocked", &Map::blocked, view,
                             "the same, inflated: what planners get; a view that follows the map")
      .def_property_readonly("voxels", &Map::voxels, view,
                             "occupied voxels; a view that follows the map")
      .def_property_readonly("voxel_size", &Map::voxel_size, "edge of a voxel [m]")
      .def_property_readonly("totals", &Map::totals, py::return_value_policy::copy,
                             "InsertStatistics, the sum over all scans since the map was made")
      .def_property_readonly("version", &Map::version,
                             "grows, from 0, whenever planning cells become occupied, blocked or "
                             "free: by a scan, a file or `clear`")
      .def("insert", &insert, "origin"_a, "hits"_a, "misses"_a = py::none(),
           "Adds a scan: where its rays began, (3,) or a Pose whose attitude turns the body box; "
           "where they hit and, for\n"
           "carving, where those without a return ended; world [m]. Clouds are float32 or float64 "
           "of any layout: (N, 3) or\n"
           "wider (columns x, y, z first), organised (H, W, 3) or wider, or with fields x, y, z; "
           "C-ordered ones are not\n"
           "copied. Points that are not finite, too near, in the body, out of range or outside the "
           "window are counted, never\n"
           "an error. Returns InsertStatistics.")
      .def(
          "recentre", [](Map& map, const ltp::Point& centre) { return own(map).recentre(centre); },
          "centre"_a,
          "Centres the window on a point (3,) [m]. Cells that enter are as they were when they "
          "left; "
          "with `remember` off\n"
          "what leaves is forgotten. Returns the shift in cells, (3,) int.")
      .def(
          "clear", [](Map& map) { own(map).clear(); }, "Forgets everything.")
      .def(
          "log_odds_at", &Map::log_odds_at, "point"_a,
          "Log-odds of the voxel at a point (3,) [m], in the window or remembered; 0 where nothing "
          "is known.")
      .def("remembered", &remembered, py::call_guard<py::gil_scoped_release>(),
           "(N, 3), centres of all occupied voxels of the mission, in the window and beyond [m]; "
           "with `remember` off, of\n"
           "the window.")
      .def_property_readonly(
          "mission_bytes",
          [](const Map& map) { return map.mission() ? map.mission()->bytes() : 0; },
          "what the memory of the mission takes, roughly [bytes]")
      .def(
          "save", [](const Map& map, const FilePath& path) { map.save(path.string()); }, "path"_a,
          py::call_guard<py::gil_scoped_release>(),
          "Writes the whole mission (with `remember` off: the window) as OctoMap's `.bt` (occupied "
          "or free) or `.ot`\n"
          "(log-odds), atomically.")
      .def("load", &load, "path"_a,
           "Adds what a `.bt` or `.ot` file of the same voxel size knows (with `remember` off: "
           "about "
           "the window). ValueError\n"
           "names the file; the map then stays as it was.");

  using Inflate =
      ltp::OccupancyGrid (*)(const ltp::OccupancyGrid&, double, const std::array<int, 3>&);
  m.def("inflate", static_cast<Inflate>(&ltp::inflate), "grid"_a, "radius"_a,
        "parts"_a = std::array<int, 3>{1, 1, 1}, py::call_guard<py::gil_scoped_release>(),
        "The grid with every cell blocked whose box is within `radius` [m] of the box of a blocked "
        "one: any radius > 0\n"
        "adds at least the 26 neighbours, 0 none. With `parts`, so many of the given grid's cells "
        "along each edge make one\n"
        "of the result's. ValueError unless its dims, and where its window begins, are multiples.");
}
