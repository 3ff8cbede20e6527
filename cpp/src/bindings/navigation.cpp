// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Floor 4 in Python: the local trajectory planner that flies, on one thread or on two.
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <cctype>
#include <limits>

#include "bindings.hpp"
#include "flying.hpp"
#include "interrupt.hpp"

namespace {

using bindings::Concurrent;
using bindings::Ltp;
using Band = std::pair<double, double>;
using FilePath = std::filesystem::path;

template <typename Kind>
std::unique_ptr<Kind> make(const ltp::Raster& priority, const ltp::Point& position,
                           const std::string& planner, const ltp::PlannerOptions& planner_options,
                           const ltp::ObstacleMapOptions& map_options,
                           const ltp::NavigationOptions& options) {
  ltp::check::finite("position", position);
  return std::make_unique<Kind>(priority, position, planner, planner_options, map_options, options);
}

/// How a loop that flies is told to change its mind: alike for both, but for when it counts.
template <typename Kind>
void bind_changes(py::class_<Kind>& loop, const std::string& when) {
  const std::string keeping =
      "keep_if_within: 0: the path is given up. Else it is kept, unless a new one is better by "
      "more than that by Eq. 5, from\nwhere the UAV is, by the new priority and weights.";
  loop.def("set_priority", &Kind::set_priority, "priority"_a, "keep_if_within"_a = 0.0,
           ("Another Raster in [0, 1], " + when + ".\n" + keeping).c_str())
      .def("set_weights", &Kind::set_weights, "weights"_a, "keep_if_within"_a = 0.0,
           ("Other weights of Eq. 5, by the same planner made anew, " + when +
            ". Map and "
            "waypoints stay.\n" +
            keeping)
               .c_str())
      .def("set_planner", &Kind::remake_planner, "planner"_a = "auto", py::kw_only(),
           "planner_options"_a = ltp::PlannerOptions{}, "keep_if_within"_a = 0.0,
           ("Another planner, " + when + ". Map and waypoints stay.\n" + keeping).c_str())
      .def("take_events", &Kind::take_events,
           "What became of waypoints, each told once: also of waypoints that were replaced since, "
           "see WaypointEvent.route.");
}

template <typename Kind>
ltp::InsertStatistics sense(Kind& self, const bindings::Place& origin, const bindings::Points& hits,
                            const std::optional<bindings::Points>& misses) {
  const bindings::PointsInUse hit(hits, "hits");
  const bindings::PointsInUse missed(misses, "misses");
  const py::gil_scoped_release release;
  return self.sense(origin.pose, hit.view(), missed.view());
}

ltp::NavigationStatus update(Ltp& self, const ltp::Point& position) {
  ltp::NavigationStatus status;
  {
    const py::gil_scoped_release release;
    status = self.update(position, SignalWatch());
  }
  raise_pending_signal();
  return status;
}

/// In pieces, so that Ctrl-C gets through.
bool wait(Concurrent& self, double seconds) {
  constexpr double kPiece = 0.05;  // [s]
  while (true) {
    bool decided;
    {
      const py::gil_scoped_release release;
      decided = self.wait(std::min(seconds, kPiece));
    }
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    seconds -= kPiece;
    if (decided || !(seconds > 0.0)) return decided;
  }
}

void bind_concurrent(py::module_& m) {
  const py::call_guard<py::gil_scoped_release> released;
  Fields<ltp::Decision>(m, "Decision", "What the planning thread decided on one scan's map.")
      .result("scan", &ltp::Decision::scan,
              "number of the last scan that it knows, from 1; 0: none yet")
      .result("status", &ltp::Decision::status, "what to do")
      .result("reason", &ltp::Decision::reason, "why it holds or escapes")
      .result(
          "path", [](const ltp::Decision& d) { return d.path; }, "(N, 3), the path to follow [m]")
      .result("path_id", &ltp::Decision::path_id, "as long as it stands, so does `path`")
      .result("waypoint_index", &ltp::Decision::waypoint_index, "the waypoint flown to")
      .result("events", &ltp::Decision::events, "reached and dropped waypoints, in order")
      .result("plans", &ltp::Decision::plans, "the planner's answers when it was last asked")
      .result("plans_made", &ltp::Decision::plans_made, "since the beginning");

  py::class_<Concurrent> loop(
      m, "ConcurrentTrajectoryPlanner",
      "A LocalTrajectoryPlanner whose scans never wait for a plan: it plans on "
      "a thread of its own, on snapshots of the\n"
      "map. Call it from one thread. If each scan is waited for, it decides as "
      "the LocalTrajectoryPlanner does.");
  bind_changes(loop, "from the next scan on");
  loop.def(py::init(&make<Concurrent>), "priority"_a, "position"_a, py::kw_only(),
           "planner"_a = "auto", "planner_options"_a = ltp::PlannerOptions{},
           "map_options"_a = ltp::ObstacleMapOptions{}, "options"_a = ltp::NavigationOptions{},
           "As a LocalTrajectoryPlanner's.")
      .def("set_waypoints", &Concurrent::set_waypoints, "waypoints"_a,
           "gates"_a = ltp::GateSizes(0, 2),
           "Replaces what is left of the global path from the next scan on; (N, 3), world [m].\n"
           "gates: as LocalTrajectoryPlanner's.")
      .def("sense", &sense<Concurrent>, "origin"_a, "hits"_a, "misses"_a = py::none(),
           "Adds a scan, as LocalTrajectoryPlanner does, and hands the map over to be planned on; "
           "the UAV is at its origin.")
      .def(
          "load_map", [](Concurrent& self, const FilePath& path) { self.load_map(path.string()); },
          "path"_a, released,
          "As LocalTrajectoryPlanner's; the map is handed over to be planned on at once.")
      .def("clear_map", &Concurrent::clear_map, released,
           "As LocalTrajectoryPlanner's; the map is handed over to be planned on at once.")
      .def("start", &Concurrent::start, "Begins the planning thread.")
      .def("stop", &Concurrent::stop, released,
           "Ends the planning thread; interrupts a long search.")
      .def(
          "plan", &Concurrent::plan, released,
          "Decides on the newest map, in the calling thread: instead of `start`. Whether there was "
          "a new one.")
      .def("wait", &wait, "seconds"_a = std::numeric_limits<double>::infinity(),
           "Returns when the planning thread has decided on the newest map, or after so long [s]; "
           "whether it has. Raises\n"
           "what it has raised.")
      .def_property_readonly("decision", &Concurrent::decision, py::return_value_policy::copy,
                             "the newest one")
      .def_property_readonly("blocked_at", &Concurrent::blocked_at,
                             "arc length of the last decision's path at which the newest map "
                             "blocks it, an escape: at which something was hit [m]; None if it is "
                             "free")
      .def_property_readonly("scans", &Concurrent::scans, "sensed so far")
      .def_property_readonly("waypoints", &Concurrent::waypoints, py::return_value_policy::copy)
      .def_property_readonly("map", &Concurrent::map, py::return_value_policy::reference_internal,
                             "a read-only view: see `load_map` and `clear_map`");
}

void bind_options(py::module_& m) {
  options_class<ltp::NavigationOptions>(
      m, "NavigationOptions", "When a waypoint is reached, a path left, a height allowed.")
      .field(
          "band", [](const ltp::NavigationOptions& o) { return Band(o.band.below, o.band.above); },
          [](ltp::NavigationOptions& o, const Band& band) {
            o.band = {band.first, band.second};
          },
          "(below, above): how far to leave the altitudes of UAV and waypoint [m]; (0, 0) is "
          "planar flight")
      .field("climb", &ltp::NavigationOptions::climb,
             "how far above the highest waypoint of a leg the UAV may rise, however high it is by "
             "now [m]; 0: `band`'s second number")
      .field("reach_distance", &ltp::NavigationOptions::reach_distance,
             "a waypoint is reached within it, horizontally [m]; 0: one horizontal cell diagonal")
      .field("leave_distance", &ltp::NavigationOptions::leave_distance,
             "farther from its path the UAV has left it [m]; 0: one horizontal cell diagonal")
      .field("escape_distance", &ltp::NavigationOptions::escape_distance,
             "how far to look for a free cell when standing in a blocked one [m]")
      .field("gate_radius", &ltp::NavigationOptions::gate_radius,
             "a waypoint but the last is served within it, horizontally [m]; 0: it is a point, see "
             "`reach_distance`")
      .field("gate_height", &ltp::NavigationOptions::gate_height,
             "the same, up and down [m]; 0: one cell")
      .field("horizon", &ltp::NavigationOptions::horizon,
             "waypoints that are planned jointly, >= 1")
      .field("max_expansions", &ltp::NavigationOptions::max_expansions,
             "of a plan, see `Budget`; 0: no limit")
      .field("time_limit", &ltp::NavigationOptions::time_limit,
             "of a plan, see `Budget` [s]; 0: no limit")
      .field("max_detour", &ltp::NavigationOptions::max_detour,
             "a waypoint that would cost more metres than the shortest way to it that was known at "
             "first, by so many, is skipped as too far [m]; 0: none is")
      .field("fly_route", &ltp::NavigationOptions::fly_route,
             "where the planner finds no path and a way is known, fly the shortest one instead of "
             "holding")
      .bound()
      .def(
          "band_from",
          [](const ltp::NavigationOptions& self, double start, double highest) {
            const ltp::AltitudeBand band = self.band_from(start, highest);
            return Band(band.below, band.above);
          },
          "start"_a, "highest"_a,
          "The band (below, above) of a leg that begins at an altitude and whose highest waypoint "
          "lies at another [m].");
}

void bind_results(py::module_& m) {
  py::enum_<ltp::NavigationStatus>(m, "NavigationStatus",
                                   "What the local trajectory planner is doing.")
      .value("FINISHED", ltp::NavigationStatus::Finished, "no waypoint is left")
      .value("FOLLOWING", ltp::NavigationStatus::Following, "there is a path to follow")
      .value("ESCAPING", ltp::NavigationStatus::Escaping,
             "leaving a blocked cell by the nearest free one")
      .value("HOLDING", ltp::NavigationStatus::Holding, "no path and no proof: stay")
      .def("__bool__", &no_truth_value<ltp::NavigationStatus>)
      .def_property_readonly("label",
                             [](ltp::NavigationStatus status) { return ltp::to_string(status); });

  py::enum_<ltp::NavigationReason> reasons(
      m, "NavigationReason", "Why a UAV holds or escapes, or why a waypoint was dropped.");
  for (int i = 0; i <= static_cast<int>(ltp::NavigationReason::AllDropped); ++i) {
    const auto reason = static_cast<ltp::NavigationReason>(i);
    std::string name(ltp::to_string(reason));
    for (char& letter : name) letter = static_cast<char>(std::toupper(letter));
    reasons.value(name.c_str(), reason, std::string(ltp::sentence(reason)).c_str());
  }
  reasons.def("__bool__", &no_truth_value<ltp::NavigationReason>)
      .def_property_readonly("label",
                             [](ltp::NavigationReason reason) { return ltp::to_string(reason); })
      .def_property_readonly(
          "text", [](ltp::NavigationReason reason) { return ltp::sentence(reason); },
          "a plain sentence without its full stop; empty for NONE");

  Fields<ltp::WaypointEvent>(m, "WaypointEvent", "What became of a waypoint.")
      .result("index", &ltp::WaypointEvent::index, "of the waypoint, from 0")
      .result("reached", &ltp::WaypointEvent::reached, "True: reached; False: dropped")
      .result(
          "reason", &ltp::WaypointEvent::reason,
          "why it was dropped: GOAL_BLOCKED or UNREACHABLE, on proof; NONE_FOUND: it was too far")
      .result("why", &ltp::WaypointEvent::why, "the same as a reason with a text; NONE: reached")
      .result("position", &ltp::WaypointEvent::position, "(3,), of the UAV [m]")
      .result("goal", &ltp::WaypointEvent::goal, "(3,), the waypoint [m]")
      .result("distance", &ltp::WaypointEvent::distance, "from the UAV to the waypoint [m]")
      .result("window_origin", &ltp::WaypointEvent::window_origin, "(3,), of the map's window [m]")
      .result("route", &ltp::WaypointEvent::route,
              "counts the calls of `set_waypoints`: by which it was given, from 1");

  Fields<ltp::PlanRecord>(m, "PlanRecord", "One answer of the planner.")
      .result("waypoint", &ltp::PlanRecord::waypoint, "for which it was asked")
      .result("direct_length", &ltp::PlanRecord::direct_length,
              "L_direct of the query [m]; with a horizon of all its legs")
      .result("plan", &ltp::PlanRecord::plan, "the answer");
}

void bind_local(py::module_& m) {
  py::class_<Ltp> loop(m, "LocalTrajectoryPlanner",
                       "The loop that flies: waypoints, scans and poses in; plan and status out. "
                       "Replans when the path is\n"
                       "blocked, left, or its waypoint retired; drops a waypoint only on proof.");
  bind_changes(loop, "from the next update on");
  loop.def(py::init(&make<Ltp>), "priority"_a, "position"_a, py::kw_only(), "planner"_a = "auto",
           "planner_options"_a = ltp::PlannerOptions{}, "map_options"_a = ltp::ObstacleMapOptions{},
           "options"_a = ltp::NavigationOptions{},
           "priority: Raster in [0, 1]. position: (3,) [m]. planner: one of `ltp.PLANNERS`.")
      .def("set_waypoints", &Ltp::set_waypoints, "waypoints"_a, "gates"_a = ltp::GateSizes(0, 2),
           "Replaces what is left of the global path; (N, 3), world [m]. gates: (N, 2), radius and "
           "height "
           "in which each is served\n"
           "[m], 0: within `reach_distance`, one cell; default: those of the options.")
      .def("sense", &sense<Ltp>, "origin"_a, "hits"_a, "misses"_a = py::none(),
           "Adds a scan: where its rays began, (3,) or a Pose whose attitude turns the map's body "
           "box; where they hit and,\n"
           "for carving, where those without a return ended; world [m]. Clouds as "
           "ObstacleMap.insert takes them.")
      .def(
          "load_map", [](Ltp& self, const FilePath& path) { self.load_map(path.string()); },
          "path"_a, py::call_guard<py::gil_scoped_release>(),
          "Adds what a `.bt` or `.ot` file knows, as ObstacleMap.load does: of an earlier mission, "
          "say. The next update plans\n"
          "on it, beyond the window too (unless the map's `remember` is off).")
      .def("clear_map", &Ltp::clear_map,
           "Forgets all obstacles, those beyond the window too; the next update plans on it.")
      .def("update", &update, "position"_a, "Decides what to do at a position (3,) [m].")
      .def_property_readonly("status", &Ltp::status)
      .def_property_readonly("reason", &Ltp::reason, "why it holds or escapes; NONE: it does not")
      .def_property_readonly("path", &Ltp::path, py::return_value_policy::copy,
                             "(N, 3), the path to follow [m]")
      .def_property_readonly("path_id", &Ltp::path_id, "as long as it stands, so does `path`")
      .def_property_readonly("plans", &Ltp::plans, py::return_value_policy::copy,
                             "the planner's answers when it was last asked")
      .def_property_readonly("plans_made", &Ltp::plans_made, "since the beginning")
      .def_property_readonly("events", &Ltp::events, py::return_value_policy::copy,
                             "reached and dropped waypoints, in order")
      .def_property_readonly("events_count", [](const Ltp& self) { return self.events().size(); })
      .def_property_readonly("waypoint_index", &Ltp::waypoint_index, "the waypoint flown to")
      .def_property_readonly("waypoints", &Ltp::waypoints, py::return_value_policy::copy)
      .def_property_readonly("map", &Ltp::map, py::return_value_policy::reference_internal,
                             "a read-only view: see `load_map` and `clear_map`");
}

}  // namespace

void bind_navigation(py::module_& m) {
  bind_options(m);
  bind_results(m);
  bind_local(m);
  bind_concurrent(m);
}
