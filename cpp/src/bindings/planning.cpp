// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Floor 3 in Python: planners, what goes into them and what comes out.
#include <mutex>

#include "bindings.hpp"
#include "interrupt.hpp"
#include "ltp/planning/grid_planner.hpp"
#include "ltp/planning/planners.hpp"
#include "planning/search/distance_field.hpp"
#include "planning/search/flood.hpp"

namespace {

/// The planner of a name; an old name warns.
const ltp::PlannerInfo& planner_info(const std::string& name) {
  const ltp::PlannerInfo& info = ltp::planner_info(name);
  if (info.name != name) {
    warn_deprecated("the planner '" + name + "' is now '" + std::string(info.name) +
                    "'; the old name goes with the next release");
  }
  return info;
}

/// Calls with a budget that Ctrl-C ends too, while other threads run.
template <typename Call>
auto watched(ltp::Budget budget, Call&& call) {
  budget.interrupted = SignalWatch();
  auto answer = [&] {
    const py::gil_scoped_release release;
    return call(budget);
  }();
  raise_pending_signal();
  return answer;
}

/// A planner keeps scratch memory, and `plan` lets other threads run: they take turns.
class SharedPlanner {
 public:
  SharedPlanner(const std::string& name, const ltp::PlannerOptions& options)
      : planner_(ltp::make_planner(planner_info(name).name, options)), exact_(options.exact) {}

  const ltp::PlannerInfo& info() const { return planner_->info(); }

  ltp::Plan plan(const ltp::Scene& scene, const ltp::Query& query, const ltp::Budget& budget) {
    return watched(budget, [&](const ltp::Budget& limits) {
      const std::lock_guard<std::mutex> turn(turn_);
      return planner_->plan(scene, query, limits);
    });
  }

  ltp::Front front(const ltp::Scene& scene, const ltp::Query& query, double eps) const {
    warn_deprecated("`planner.front` is now `ltp.pareto_front`");
    return watched({}, [&](const ltp::Budget& limits) {
      return ltp::pareto_front(scene, query, {exact_.memory, eps}, limits);
    });
  }

 private:
  std::unique_ptr<ltp::Planner> planner_;
  ltp::ExactOptions exact_;
  std::mutex turn_;
};

using Band = std::pair<double, double>;

ltp::AltitudeBand band_of(const Band& band) { return {band.first, band.second}; }

ltp::Query make_query(const ltp::Point& start, const ltp::Point& goal, const Band& band,
                      double gate_radius, double gate_height, const std::vector<ltp::Gate>& then) {
  return {start, goal, band_of(band), gate_radius, gate_height, then};
}

void bind_values(py::module_& m) {
  py::class_<ltp::Scene>(m, "Scene",
                         "What a planner may look at: obstacles and priority. Keeps both alive.")
      .def(py::init([](const ltp::OccupancyGrid& occupancy, const ltp::Raster& priority) {
             return ltp::Scene{occupancy, priority};
           }),
           "occupancy"_a, "priority"_a, py::keep_alive<1, 2>(), py::keep_alive<1, 3>());

  Fields<ltp::Gate>(m, "Gate",
                    "A waypoint with the region in which it is served: an upright cylinder.")
      .result("point", &ltp::Gate::point, "(3,), world [m]")
      .result("radius", &ltp::Gate::radius, "horizontally [m]; 0: the cell of the point")
      .result("height", &ltp::Gate::height, "above and below the point [m]")
      .bound()
      .def(py::init([](const ltp::Point& point, double radius, double height) {
             return ltp::Gate{point, radius, height};
           }),
           "point"_a, "radius"_a = 0.0, "height"_a = 0.0);

  py::class_<ltp::Query>(
      m, "Query", "From where to where, and how far the path may leave the altitudes between.")
      .def(py::init(&make_query), "start"_a, "goal"_a,
           "band"_a = Band(std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::infinity()),
           "gate_radius"_a = 0.0, "gate_height"_a = 0.0, "then"_a = std::vector<ltp::Gate>{},
           "start, goal: (3,), world [m]. band: (below, above), how far the path may go under the "
           "lower and over the\n"
           "higher of both ends [m], >= 0; (0, 0) is planar flight, the default is open to the "
           "whole window. gate_radius, gate_height: of the region about the goal in which it is "
           "served [m], >= 0; the path ends\n"
           "where it enters; radius 0: at the point itself. then: the Gates after it, planned "
           "jointly; the path passes them in\n"
           "order, and L_direct is the way through all their points.")
      .def_readonly("start", &ltp::Query::start)
      .def_readonly("goal", &ltp::Query::goal)
      .def_property_readonly(
          "band", [](const ltp::Query& query) { return Band(query.band.below, query.band.above); })
      .def_readonly("gate_radius", &ltp::Query::gate_radius)
      .def_readonly("gate_height", &ltp::Query::gate_height)
      .def_readonly("then", &ltp::Query::then)
      .def_property_readonly("direct_length", &ltp::direct_length, "L_direct of Eq. (3) [m]");

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

  Fields<ltp::SearchStats>(m, "SearchStats", "What a search did.")
      .result("expanded", &ltp::SearchStats::expanded, "cells (or curves) examined")
      .result("pushed", &ltp::SearchStats::pushed, "entries that went into the open list")
      .result("seconds", &ltp::SearchStats::seconds, "wall time [s]");

  // Without the paths, which a repr has no room for.
  Fields<ltp::Plan>(m, "Plan", "A planner's answer.")
      .result("status", &ltp::Plan::status, "how it ended")
      .result("tally", &ltp::Plan::tally, "length and priority integral of the path")
      .result("penalty", &ltp::Plan::penalty, "Eq. (5); inf unless FOUND")
      .result("bound", &ltp::Plan::bound,
              "no path through vertices of cells has a smaller penalty (a refined one may); None "
              "without a proof")
      .result("priority_resampled", &ltp::Plan::priority_resampled,
              "the priority was off the grid's columns: planned and tallied over "
              "`ltp.onto_columns` of it")
      .result("stats", &ltp::Plan::stats, "what the search did")
      .bound()
      .def_readonly("passed", &ltp::Plan::passed,
                    "where along the path each waypoint is passed, arc lengths [m]; fewer than "
                    "asked for where a later one is\n"
                    "blocked, unreachable or beyond the window; empty unless FOUND")
      .def_readonly("path", &ltp::Plan::path,
                    "(N, 3), start ... goal, world [m]; empty unless FOUND");

  Fields<ltp::Front>(m, "Front", "The paths of which none is both shorter and over better ground.")
      .result("status", &ltp::Front::status, "how it ended")
      .result("priority_resampled", &ltp::Front::priority_resampled, "as in `Plan`")
      .result("stats", &ltp::Front::stats, "what the search did")
      .bound()
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
      .def_readonly("paths", &ltp::Front::paths, "k arrays (N, 3), start ... goal, world [m]");
}

void bind_options(py::module_& m) {
  options_class<ltp::BezierOptions>(m, "BezierOptions", "The Bezier planner's exhaustive search.")
      .field("offsets", &ltp::BezierOptions::offsets,
             "M, offsets tried for each control point; odd")
      .field("reach", &ltp::BezierOptions::reach, "largest sideways offset [m]")
      .field("z_offsets", &ltp::BezierOptions::z_offsets, "offsets tried in height; odd")
      .field("z_reach", &ltp::BezierOptions::z_reach, "largest offset in height [m]")
      .field("segments", &ltp::BezierOptions::segments, "straight pieces of the curve");

  options_class<ltp::LinearisedOptions>(m, "LinearisedOptions",
                                        "The searches of `additive`, `sweep` and `auto`.")
      .field("alpha", &ltp::LinearisedOptions::alpha, "of the first search; 0: from the weights")
      .field("tolerance", &ltp::LinearisedOptions::tolerance,
             "of Eq. (5): ends when path and bound are this close")
      .field("searches", &ltp::LinearisedOptions::searches, "at most (`additive`: one)")
      .field("effort", &ltp::LinearisedOptions::effort,
             "expansions that may be spent, see `whole_first`; 0: no limit (`auto`: 20,000)")
      .field("whole_first", &ltp::LinearisedOptions::whole_first,
             "`effort` counts from the first path on: that search is never cut")
      .field("remember", &ltp::LinearisedOptions::remember,
             "begins with the slope at the last path to the same goal")
      .field("closing", &ltp::LinearisedOptions::closing,
             "labels and cells that may be spent on closing the gap that is left (`auto`: none)");

  options_class<ltp::ExactOptions>(m, "ExactOptions",
                                   "The exact search of `exact`, and the Pareto front's.")
      .field("memory", &ltp::ExactOptions::memory,
             "for its labels; needing more is OUT_OF_BUDGET [MB]")
      .field("eps", &ltp::ExactOptions::eps,
             "Eq. (5) + W_P p_max may be this part above its optimum");

  options_class<ltp::AraOptions>(m, "AraOptions", "The weights of `ara-star`.")
      .field("first_weight", &ltp::AraOptions::first_weight,
             "of the heuristic in the first round, 1 to 100")
      .field("step", &ltp::AraOptions::step,
             "by which it falls from round to round, to 1; >= 0.01");

  options_class<ltp::RiskOptions>(m, "RiskOptions", "The cost of `risk-a-star`.")
      .field("length_factor", &ltp::RiskOptions::length_factor,
             "what a metre costs beside its risk (0 to 1 a metre); > 0");

  options_class<ltp::TangentBugOptions>(m, "TangentBugOptions", "The sensor of `tangent-bug`.")
      .field("range", &ltp::TangentBugOptions::range,
             "how far it sees [m], >= 0; 0: only what it touches");

  options_class<ltp::HermiteOptions>(m, "HermiteOptions", "The optimised curve of `hermite`.")
      .field("segments", &ltp::HermiteOptions::segments, "straight pieces of the curve")
      .field("starts", &ltp::HermiteOptions::starts,
             "sideways tangents tried at each end to begin with; odd")
      .field("reach", &ltp::HermiteOptions::reach, "the largest of them, in direct lengths")
      .field("refined", &ltp::HermiteOptions::refined,
             "the best so many of those curves are optimised")
      .field("iterations", &ltp::HermiteOptions::iterations, "rounds of the optimisation of each");

  options_class<ltp::PlannerOptions>(m, "PlannerOptions", "What every planner can be told.")
      .field("weights", &ltp::PlannerOptions::weights, "W_L and W_P of Eq. (5)")
      .field("scaled_heuristic", &ltp::PlannerOptions::scaled_heuristic,
             "multiply Eq. (9) by W_L, which it lacks as printed")
      .field("refine", &ltp::PlannerOptions::refine,
             "free the path from the grid's directions; never a larger penalty")
      .field("bezier", &ltp::PlannerOptions::bezier, "of `bezier`")
      .field("linearised", &ltp::PlannerOptions::linearised, "of `additive`, `sweep` and `auto`")
      .field("exact", &ltp::PlannerOptions::exact, "of `exact`")
      .field("ara", &ltp::PlannerOptions::ara, "of `ara-star`")
      .field("risk", &ltp::PlannerOptions::risk, "of `risk-a-star`")
      .field("tangent_bug", &ltp::PlannerOptions::tangent_bug, "of `tangent-bug`")
      .field("hermite", &ltp::PlannerOptions::hermite, "of `hermite`");

  options_class<ltp::Budget>(m, "Budget",
                             "What one plan may spend. A search that reaches a limit ends with "
                             "OUT_OF_BUDGET, or with the best\n"
                             "path that it has.")
      .field("max_expansions", &ltp::Budget::max_expansions,
             "cells, curves or labels examined, >= 0; 0: no limit")
      .field("time_limit", &ltp::Budget::time_limit, "wall time [s], >= 0; 0: no limit");
}

void bind_registry(py::module_& m) {
  using Info = ltp::PlannerInfo;
  const auto trait = [](unsigned bits) {
    return [bits](const Info& info) { return info.has(bits); };
  };
  Fields<Info>(m, "PlannerInfo", "What a planner is: a row of the registry.")
      .result("name", &Info::name, "by which it is made")
      .result("title", &Info::title, "as tables print it")
      .result(
          "family", [](const Info& info) { return ltp::to_string(info.family); },
          "'paper': of the paper's tables; 'ours'; 'baseline': of other authors, to compare with")
      .result("complete", trait(ltp::Trait::Complete), "its UNREACHABLE proves that no path exists")
      .result("on_grid", trait(ltp::Trait::OnGrid), "its paths run through vertices of cells")
      .result("anytime", trait(ltp::Trait::Anytime),
              "out of budget, it answers with the best path so far")
      .result("remembers", trait(ltp::Trait::Remembers),
              "an answer may depend on what was asked before")
      .result("uses_priority", trait(ltp::Trait::UsesPriority), "the priority map shapes its paths")
      .result("bounds", trait(ltp::Trait::Bounds), "proves a lower bound of Eq. (5)")
      .result("regions", trait(ltp::Trait::Regions),
              "its goal is a whole region; others are given one cell of it")
      .result("horizon", trait(ltp::Trait::Horizon),
              "plans several waypoints jointly; others go leg by leg");
  m.def("planners", &ltp::planners, "All planners, in the order of the paper's tables.");
  m.def("planner_info", &planner_info, "name"_a,
        "The planner of a name; an old name warns. ValueError for an unknown one, listing those "
        "known.");
}

/// The cells that a flood over faces reaches from a point, bool (nx, ny, nz).
py::array_t<bool> flood_fill(const ltp::OccupancyGrid& grid, const ltp::Query& query) {
  ltp::check_query(query);
  const ltp::GridFrame& frame = grid.frame();
  py::array_t<bool> out({frame.nx(), frame.ny(), frame.nz()});
  bool* reached = out.mutable_data();
  const py::gil_scoped_release release;
  ltp::planning::Flood flood;
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
  watched({}, [&, low = lowest, high = highest](const ltp::Budget& limits) {
    ltp::planning::DistanceField field;
    ltp::SearchStats stats;
    ltp::BudgetWatch watch(limits);
    const ltp::PlanStatus status =
        field.run(grid, frame.cell_of(source), {low, high}, watch, stats);
    field.copy_to(distances);
    return status;
  });
  return out;
}

}  // namespace

void bind_planning(py::module_& m) {
  bind_values(m);
  bind_options(m);
  bind_registry(m);
  py::class_<SharedPlanner>(m, "Planner", "A local planner; made by `make_planner`.")
      .def(py::init<const std::string&, const ltp::PlannerOptions&>(), "name"_a,
           "options"_a = ltp::PlannerOptions{})
      .def_property_readonly("info", &SharedPlanner::info, "its row of the registry")
      .def_property_readonly("name", [](const SharedPlanner& self) { return self.info().name; })
      .def_property_readonly(
          "complete",
          [](const SharedPlanner& self) { return self.info().has(ltp::Trait::Complete); },
          "whether its failure proves that no path exists")
      .def("plan", &SharedPlanner::plan, "scene"_a, "query"_a, "budget"_a = ltp::Budget{},
           "Plans a path. Lets other threads run; Ctrl-C interrupts it. ValueError for a query "
           "that is not finite and for\n"
           "a negative limit.")
      .def("front", &SharedPlanner::front, "scene"_a, "query"_a, "eps"_a = 0.0,
           "Deprecated: `ltp.pareto_front`.");
  m.def(
      "pareto_front",
      [](const ltp::Scene& scene, const ltp::Query& query, const ltp::ExactOptions& options,
         const ltp::Budget& budget) {
        return watched(budget, [&](const ltp::Budget& limits) {
          return ltp::pareto_front(scene, query, options, limits);
        });
      },
      "scene"_a, "query"_a, "options"_a = ltp::ExactOptions{}, "budget"_a = ltp::Budget{},
      "All paths of which none is both shorter (L) and over better ground (R = p_max L - P, p_max "
      "the largest priority in\n"
      "the window, P the priority integral). With options.eps, for each path one of them has at "
      "most (1 + eps) times its\n"
      "L and its R. OUT_OF_BUDGET where memory or budget end. ValueError for a query that is not "
      "finite and for a wrong\n"
      "option. Lets other threads run; Ctrl-C interrupts it.");
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
  m.def("flood_fill", &flood_fill, "grid"_a, "query"_a,
        "bool (nx, ny, nz): the cells that any planner could reach from the query's start within "
        "its band, by a flood\n"
        "that shares nothing with the planners. ValueError if the start is outside the grid.");
}
