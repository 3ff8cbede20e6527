// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Floor 3 in Python: planners, what goes into them and what comes out.
#include <mutex>

#include "bindings.hpp"
#include "interrupt.hpp"
#include "ltp/planning/distance_field.hpp"
#include "ltp/planning/flood.hpp"
#include "ltp/planning/grid_query.hpp"
#include "ltp/planning/pareto.hpp"
#include "ltp/planning/planner.hpp"

namespace {

/// A planner keeps scratch memory, and `plan` lets other threads run: they take turns.
class SharedPlanner {
 public:
  SharedPlanner(const std::string& name, const ltp::PlannerOptions& options)
      : planner_(ltp::make_planner(name, options)) {}

  const ltp::Planner& planner() const { return *planner_; }

  ltp::Plan plan(const ltp::Scene& scene, ltp::Query query) {
    query.interrupted = SignalWatch();
    ltp::Plan plan;
    {
      const py::gil_scoped_release release;
      const std::lock_guard<std::mutex> turn(turn_);
      plan = planner_->plan(scene, query);
    }
    raise_pending_signal();
    return plan;
  }

  ltp::Front front(const ltp::Scene& scene, ltp::Query query, double eps) {
    auto* const pareto = dynamic_cast<ltp::ParetoPlanner*>(planner_.get());
    if (pareto == nullptr) {
      throw std::invalid_argument("planner = '" + std::string(planner_->name()) +
                                  "': expected 'pareto', the only one that has a front");
    }
    query.interrupted = SignalWatch();
    ltp::Front front;
    {
      const py::gil_scoped_release release;
      const std::lock_guard<std::mutex> turn(turn_);
      front = pareto->front(scene, query, eps);
    }
    raise_pending_signal();
    return front;
  }

 private:
  std::unique_ptr<ltp::Planner> planner_;
  std::mutex turn_;
};

using Band = std::pair<double, double>;

ltp::AltitudeBand band_of(const Band& band) { return {band.first, band.second}; }

ltp::Query make_query(const ltp::Point& start, const ltp::Point& goal, const Band& band) {
  return {start, goal, band_of(band), nullptr};
}

void bind_values(py::module_& m) {
  py::class_<ltp::Scene>(m, "Scene",
                         "What a planner may look at: obstacles and priority. Keeps both alive.")
      .def(py::init([](const ltp::OccupancyGrid& occupancy, const ltp::Raster& priority) {
             return ltp::Scene{occupancy, priority};
           }),
           "occupancy"_a, "priority"_a, py::keep_alive<1, 2>(), py::keep_alive<1, 3>());

  py::class_<ltp::Query>(
      m, "Query", "From where to where, and how far the path may leave the altitudes between.")
      .def(py::init(&make_query), "start"_a, "goal"_a,
           "band"_a = Band(std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::infinity()),
           "start, goal: (3,), world [m]. band: (below, above), how far the path may go under the "
           "lower and over the\n"
           "higher of both ends [m], >= 0; (0, 0) is planar flight, the default is open to the "
           "whole window.")
      .def_readonly("start", &ltp::Query::start)
      .def_readonly("goal", &ltp::Query::goal)
      .def_property_readonly(
          "band", [](const ltp::Query& query) { return Band(query.band.below, query.band.above); });

  py::enum_<ltp::PlanStatus>(m, "PlanStatus", "How a plan ended.")
      .value("FOUND", ltp::PlanStatus::Found)
      .value("OUTSIDE_MAP", ltp::PlanStatus::OutsideMap, "start or goal lies beyond the window")
      .value("START_BLOCKED", ltp::PlanStatus::StartBlocked)
      .value("GOAL_BLOCKED", ltp::PlanStatus::GoalBlocked)
      .value("UNREACHABLE", ltp::PlanStatus::Unreachable,
             "proved: no free path exists on this grid")
      .value("NONE_FOUND", ltp::PlanStatus::NoneFound, "gave up without proof")
      .value("OUT_OF_BUDGET", ltp::PlanStatus::OutOfBudget, "the caller's limit was reached first")
      .def("__bool__", &no_truth_value<ltp::PlanStatus>);

  auto stats = py::class_<ltp::SearchStats>(m, "SearchStats", "What a search did.");
  stats.def_readonly("expanded", &ltp::SearchStats::expanded, "cells (or curves) examined")
      .def_readonly("pushed", &ltp::SearchStats::pushed, "entries that went into the open list")
      .def_readonly("seconds", &ltp::SearchStats::seconds, "wall time [s]");
  list_fields(stats, {"expanded", "pushed", "seconds"});

  auto plan = py::class_<ltp::Plan>(m, "Plan", "A planner's answer.");
  plan.def_readonly("status", &ltp::Plan::status)
      .def_readonly("path", &ltp::Plan::path,
                    "(N, 3), start ... goal, world [m]; empty unless FOUND")
      .def_readonly("tally", &ltp::Plan::tally, "length and priority integral of the path")
      .def_readonly("penalty", &ltp::Plan::penalty, "Eq. (5); inf unless FOUND")
      .def_readonly("bound", &ltp::Plan::bound,
                    "no path through cell centres has a smaller penalty (a refined one may); None "
                    "without a proof")
      .def_readonly("stats", &ltp::Plan::stats);
  list_fields(plan, {"status", "tally", "penalty", "bound", "stats"});

  auto front = py::class_<ltp::Front>(
      m, "Front", "The paths of which none is both shorter and over better ground.");
  front.def_readonly("status", &ltp::Front::status)
      .def_property_readonly(
          "tallies",
          [](const ltp::Front& self) {
            Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> rows(self.tallies.size(), 2);
            for (std::size_t i = 0; i < self.tallies.size(); ++i) {
              rows.row(static_cast<Eigen::Index>(i)) << self.tallies[i].length,
                  self.tallies[i].priority;
            }
            return rows;
          },
          "(k, 2): length and priority integral of each path [m], by rising length; empty unless "
          "FOUND")
      .def_readonly("paths", &ltp::Front::paths, "k arrays (N, 3), start ... goal, world [m]")
      .def_readonly("stats", &ltp::Front::stats);
  list_fields(front, {"status", "stats"});
}

void bind_options(py::module_& m) {
  auto bezier =
      py::class_<ltp::BezierOptions>(m, "BezierOptions", "The Bezier planner's exhaustive search.");
  bezier.def(py::init(&from_keywords<ltp::BezierOptions>))
      .def_readwrite("offsets", &ltp::BezierOptions::offsets,
                     "M, offsets tried for each control point; odd")
      .def_readwrite("reach", &ltp::BezierOptions::reach, "largest sideways offset [m]")
      .def_readwrite("z_offsets", &ltp::BezierOptions::z_offsets, "offsets tried in height; odd")
      .def_readwrite("z_reach", &ltp::BezierOptions::z_reach, "largest offset in height [m]")
      .def_readwrite("segments", &ltp::BezierOptions::segments, "straight pieces of the curve");
  list_fields(bezier, {"offsets", "reach", "z_offsets", "z_reach", "segments"});

  auto linearised = py::class_<ltp::LinearisedOptions>(
      m, "LinearisedOptions", "The additive searches of `additive` and `sweep`.");
  linearised.def(py::init(&from_keywords<ltp::LinearisedOptions>))
      .def_readwrite("alpha", &ltp::LinearisedOptions::alpha,
                     "of the first search; 0: from the weights")
      .def_readwrite("tolerance", &ltp::LinearisedOptions::tolerance,
                     "of Eq. (5): `sweep` stops when path and bound are this close")
      .def_readwrite("searches", &ltp::LinearisedOptions::searches, "that `sweep` makes at most")
      .def_readwrite("effort", &ltp::LinearisedOptions::effort,
                     "expansions that `sweep` may spend after its first path; 0: no limit")
      .def_readwrite("closing", &ltp::LinearisedOptions::closing,
                     "labels and cells that `sweep` may spend on closing the gap that is left");
  list_fields(linearised, {"alpha", "tolerance", "searches", "effort", "closing"});

  auto pareto = py::class_<ltp::ParetoOptions>(m, "ParetoOptions", "The exact search of `pareto`.");
  pareto.def(py::init(&from_keywords<ltp::ParetoOptions>))
      .def_readwrite("memory", &ltp::ParetoOptions::memory,
                     "for its labels; needing more is OUT_OF_BUDGET [MB]")
      .def_readwrite("eps", &ltp::ParetoOptions::eps,
                     "Eq. (5) + W_P p_max may be this part above its optimum");
  list_fields(pareto, {"memory", "eps"});

  auto ara = py::class_<ltp::AraOptions>(m, "AraOptions", "The weights of `ara-star`.");
  ara.def(py::init(&from_keywords<ltp::AraOptions>))
      .def_readwrite("first_weight", &ltp::AraOptions::first_weight,
                     "of the heuristic in the first round, 1 to 100")
      .def_readwrite("step", &ltp::AraOptions::step,
                     "by which it falls from round to round, to 1; >= 0.01");
  list_fields(ara, {"first_weight", "step"});

  auto risk = py::class_<ltp::RiskOptions>(m, "RiskOptions", "The cost of `risk-a-star`.");
  risk.def(py::init(&from_keywords<ltp::RiskOptions>))
      .def_readwrite("length_factor", &ltp::RiskOptions::length_factor,
                     "what a metre costs beside its risk (0 to 1 a metre); > 0");
  list_fields(risk, {"length_factor"});

  auto bug = py::class_<ltp::BugOptions>(m, "BugOptions", "The sensor of `bug`.");
  bug.def(py::init(&from_keywords<ltp::BugOptions>))
      .def_readwrite("range", &ltp::BugOptions::range,
                     "how far it sees [m], >= 0; 0: only what it touches");
  list_fields(bug, {"range"});

  auto hermite =
      py::class_<ltp::HermiteOptions>(m, "HermiteOptions", "The optimised curve of `hermite`.");
  hermite.def(py::init(&from_keywords<ltp::HermiteOptions>))
      .def_readwrite("segments", &ltp::HermiteOptions::segments, "straight pieces of the curve")
      .def_readwrite("starts", &ltp::HermiteOptions::starts,
                     "sideways tangents tried at each end to begin with; odd")
      .def_readwrite("reach", &ltp::HermiteOptions::reach, "the largest of them, in direct lengths")
      .def_readwrite("refined", &ltp::HermiteOptions::refined,
                     "the best so many of those curves are optimised")
      .def_readwrite("iterations", &ltp::HermiteOptions::iterations,
                     "rounds of the optimisation of each");
  list_fields(hermite, {"segments", "starts", "reach", "refined", "iterations"});

  auto options =
      py::class_<ltp::PlannerOptions>(m, "PlannerOptions", "What every planner can be told.");
  options.def(py::init(&from_keywords<ltp::PlannerOptions>))
      .def("check", &ltp::PlannerOptions::check, "Raises `ValueError` that names the field.")
      .def_property(
          "length_weight", [](const ltp::PlannerOptions& o) { return o.weights.length; },
          [](ltp::PlannerOptions& o, double value) { o.weights.length = value; }, "W_L of Eq. (5)")
      .def_property(
          "priority_weight", [](const ltp::PlannerOptions& o) { return o.weights.priority; },
          [](ltp::PlannerOptions& o, double value) { o.weights.priority = value; },
          "W_P of Eq. (5)")
      .def_readwrite("max_expansions", &ltp::PlannerOptions::max_expansions,
                     "give up (OUT_OF_BUDGET) after so many; 0: no limit")
      .def_readwrite("scaled_heuristic", &ltp::PlannerOptions::scaled_heuristic,
                     "multiply Eq. (9) by W_L, which it lacks as printed")
      .def_readwrite("refine", &ltp::PlannerOptions::refine,
                     "free the path from the grid's directions; never a larger penalty")
      .def_readwrite("bezier", &ltp::PlannerOptions::bezier)
      .def_readwrite("linearised", &ltp::PlannerOptions::linearised)
      .def_readwrite("pareto", &ltp::PlannerOptions::pareto)
      .def_readwrite("ara", &ltp::PlannerOptions::ara)
      .def_readwrite("risk", &ltp::PlannerOptions::risk)
      .def_readwrite("bug", &ltp::PlannerOptions::bug)
      .def_readwrite("hermite", &ltp::PlannerOptions::hermite);
  list_fields(options, {"length_weight", "priority_weight", "max_expansions", "scaled_heuristic",
                        "bezier", "linearised", "pareto", "ara", "risk", "bug", "hermite"});
}

/// The cells that a flood over faces reaches from a point, bool (nx, ny, nz).
py::array_t<bool> flood_fill(const ltp::OccupancyGrid& grid, const ltp::Query& query) {
  ltp::check_query(query);
  const ltp::GridFrame& frame = grid.frame();
  py::array_t<bool> out({frame.nx(), frame.ny(), frame.nz()});
  bool* reached = out.mutable_data();
  const py::gil_scoped_release release;
  ltp::Flood flood;
  flood.fill(grid, frame.cell_of(query.start), ltp::levels_of(frame, query));
  for (int ix = 0; ix < frame.nx(); ++ix) {
    for (int iy = 0; iy < frame.ny(); ++iy) {
      for (int iz = 0; iz < frame.nz(); ++iz) *reached++ = flood.reached({ix, iy, iz});
    }
  }
  return out;
}

using Levels = std::pair<int, int>;

/// Lengths of the shortest paths from the centre of a point's cell, double (nx, ny, nz).
py::array_t<double> distance_field(const ltp::OccupancyGrid& grid, const ltp::Point& source,
                                   const std::optional<Levels>& levels) {
  const ltp::GridFrame& frame = grid.frame();
  py::array_t<double> out({frame.nx(), frame.ny(), frame.nz()});
  double* const distances = out.mutable_data();
  const auto [lowest, highest] = levels.value_or(Levels(0, frame.nz() - 1));
  const std::function<bool()> interrupted = SignalWatch();
  {
    const py::gil_scoped_release release;
    ltp::DistanceField field;
    ltp::SearchStats stats;
    field.run(grid, frame.cell_of(source), {lowest, highest}, ltp::Budget(0, interrupted), stats);
    field.copy_to(distances);
  }
  raise_pending_signal();
  return out;
}

}  // namespace

void bind_planning(py::module_& m) {
  bind_values(m);
  bind_options(m);
  py::class_<SharedPlanner>(m, "Planner", "A local planner; made by `make_planner`.")
      .def(py::init<const std::string&, const ltp::PlannerOptions&>(), "name"_a,
           "options"_a = ltp::PlannerOptions{})
      .def_property_readonly("name",
                             [](const SharedPlanner& self) { return self.planner().name(); })
      .def_property_readonly(
          "complete", [](const SharedPlanner& self) { return self.planner().complete(); },
          "whether its failure proves that no path exists")
      .def("plan", &SharedPlanner::plan, "scene"_a, "query"_a,
           "Plans a path. Lets other threads run; Ctrl-C interrupts it. ValueError for a query "
           "that is not finite.")
      .def("front", &SharedPlanner::front, "scene"_a, "query"_a, "eps"_a = 0.0,
           "All paths of which none is both shorter (L) and over better ground (R = p_max L - P, "
           "p_max the largest\n"
           "priority in the window, P the priority integral). With eps, for each path one of them "
           "has at most\n"
           "(1 + eps) times its L and its R. Only `pareto` has a front: ValueError for another "
           "planner, for a query\n"
           "that is not finite and for a wrong eps. Lets other threads run; Ctrl-C interrupts it.");
  m.def(
      "distance_field", &distance_field, "grid"_a, "source"_a, "levels"_a = py::none(),
      "float64 (nx, ny, nz): the length of the shortest path [m] from the centre of the cell that "
      "holds a point to the\n"
      "centre of every cell, by the planners' 26 steps; inf where none leads. That cell counts as "
      "free itself. source:\n"
      "(3,), world [m]. levels: (lowest, highest), the only ones to use, both included; default: "
      "all. ValueError if the\n"
      "source is outside the grid or its levels, or these are not the grid's. Lets other threads "
      "run; Ctrl-C interrupts it.");
  m.def("planner_names", &ltp::planner_names,
        "The planners' names, in the order of the paper's tables.");
  m.def("flood_fill", &flood_fill, "grid"_a, "query"_a,
        "bool (nx, ny, nz): the cells that any planner could reach from the query's start within "
        "its band, by a flood\n"
        "that shares nothing with the planners. ValueError if the start is outside the grid.");
}
