// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Any-angle refinement of a path, and the planner that refines what another one finds.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "ltp/planning/grid_planner.hpp"
#include "ltp/planning/planner.hpp"
#include "planning/search/sight.hpp"

namespace ltp::planning {

/// Frees a path from the grid's 26 directions. What it returns has no larger Eq. (5), is no longer,
/// has no more vertices, stays in the query's levels and meets no blocked cell:
///   1. vertices are dropped, moved and their corners cut, as long as Eq. (5) falls; the moves
///      begin with one cell and are halved;
///   2. of all subsequences of the vertices that see each other, the best one for Eq. (5)
///      linearised at the path is taken (a shortest path through an acyclic graph); then 1. again.
/// What falls is Eq. (5) with the priority beside the path, a part of a cell (`kBeside`) to the
/// left and to the right: nobody flies a line exactly, and the path that is best on paper runs
/// along the very edge of good ground. Eq. (5) itself ends no larger than it was. New pieces keep a
/// part of a cell away from blocked cells (`kClearance`); where an end of them is nearer, the
/// distance tapers off towards it. The outcome is a local optimum near the given path.
class Refiner {
 public:
  /// What new vertices and pieces keep from blocked cells, along each axis [cells].
  static constexpr double kClearance = 0.1;

  /// How far beside the path the priority is looked at [cells].
  static constexpr double kBeside = 0.25;

  explicit Refiner(const PenaltyWeights& weights);

  /// @param path   valid for the problem: from its start to its goal, in its levels, touching no
  ///               blocked cell
  /// Deterministic; ends after a number of tries that grows with the number of vertices. Keeps its
  /// scratch: allocates what it returns, and no more when it has seen longer paths.
  Path refine(const Problem& problem, const Path& path);

 private:
  struct Vertex {
    Point at;
    double clearance;  ///< [cells]
  };
  /// The straight piece from a vertex to the next one; or the sum over several.
  struct Piece {
    double length = 0.0;
    double priority = 0.0;  ///< its integral
    double beside = 0.0;    ///< the mean of its integrals on both sides

    Piece operator+(const Piece& o) const {
      return {length + o.length, priority + o.priority, beside + o.beside};
    }
    Piece operator-(const Piece& o) const {
      return {length - o.length, priority - o.priority, beside - o.beside};
    }
  };

  bool load(const Sight& sight, const Path& path);
  void relax(const Sight& sight);
  bool relax(const Sight& sight, std::size_t vertex, double step);
  bool shortcut(const Sight& sight, double max_priority);
  bool drop(const Sight& sight, std::size_t vertex);
  bool move(const Sight& sight, std::size_t vertex, const Point& to);
  bool cut(const Sight& sight, std::size_t vertex, double share);
  bool exact(const Problem& problem, const Path& refined, const Path& path) const;

  Piece measure(const Sight& sight, const Point& a, const Point& b) const;
  double priority(const Sight& sight, const Point& a, const Point& b) const;
  /// Whether a path is better than the present one by so much of Eq. (5), judged beside it ...
  bool better(const Piece& path, double gain) const {
    return path.length <= longest_ && (*eq5_)(path.length, path.beside) < penalty_ - gain;
  }
  /// ... and no worse than the given one. Asked only where all else is well: three integrals tell
  /// this one, two the other.
  bool allowed(const Piece& path) const {
    return (*eq5_)(path.length, path.priority) <= most_penalty_;
  }
  void take(const Piece& path);

  PenaltyWeights weights_;
  std::optional<Penalty> eq5_;  ///< of the query
  Point cell_ = Point::Ones();
  bool flat_ = false;  ///< all vertices share one altitude
  // The given path's, which the refined one must not exceed.
  double longest_ = 0.0;
  double most_penalty_ = 0.0;
  std::size_t most_vertices_ = 0;
  std::int64_t tries_ = 0;  ///< left

  // The present path.
  std::vector<Vertex> vertices_;
  std::vector<Piece> pieces_;
  Piece sum_;
  double penalty_ = 0.0;  ///< Eq. (5) with the priority beside it

  // Of `shortcut`, by vertex.
  std::vector<double> costs_;
  std::vector<std::size_t> previous_;
  std::vector<char> kept_;
};

/// Refines the paths that another planner finds: `PlannerOptions::refine`. What it is, its statuses
/// and its bound stay that planner's.
std::unique_ptr<Planner> make_refined(std::unique_ptr<Planner> planner,
                                      const PenaltyWeights& weights);

}  // namespace ltp::planning
