// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Any-angle refinement of a path, and the planner that refines what another one finds.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "ltp/planning/grid_query.hpp"
#include "ltp/planning/planner.hpp"
#include "ltp/planning/sight.hpp"

namespace ltp {

/// Frees a path from the grid's 26 directions. What it returns has no larger Eq. (5), is no longer,
/// has no more vertices, stays in the query's levels and meets no blocked cell:
///   1. vertices are dropped, moved and their corners cut, as long as Eq. (5) falls; the moves
///      begin with one cell and are halved;
///   2. of all subsequences of the vertices that see each other, the best one for Eq. (5)
///      linearised at the path is taken (a shortest path through an acyclic graph); then 1. again.
/// New pieces keep a part of a cell away from blocked cells (`kClearance`); where an end of them is
/// nearer, the distance tapers off towards it. The outcome is a local optimum near the given path.
class Refiner {
 public:
  /// What new vertices and pieces keep from blocked cells, along each axis [cells].
  static constexpr double kClearance = 0.1;

  explicit Refiner(const PenaltyWeights& weights);

  /// @param query  of the path
  /// @param path   valid for the query: from its start to its goal, in its levels, touching no
  ///               blocked cell
  /// Deterministic; ends after a number of tries that grows with the number of vertices. Keeps its
  /// scratch: allocates what it returns, and no more when it has seen longer paths.
  Path refine(const Scene& scene, const GridQuery& query, const Path& path);

 private:
  struct Vertex {
    Point at;
    double clearance;  ///< [cells]
  };
  /// The straight piece from a vertex to the next one.
  struct Piece {
    double length;
    double priority;
  };

  bool load(const Sight& sight, const Path& path);
  void relax(const Sight& sight);
  bool relax(const Sight& sight, std::size_t vertex, double step);
  bool shortcut(const Sight& sight, const Raster& priority);
  bool drop(const Sight& sight, std::size_t vertex);
  bool move(const Sight& sight, std::size_t vertex, const Point& to);
  bool cut(const Sight& sight, std::size_t vertex, double share);
  bool exact(const Scene& scene, const GridQuery& query, const Path& refined,
             const Path& path) const;

  Piece measure(const Sight& sight, const Point& a, const Point& b) const;
  double penalty(const PathTally& tally) const {
    return per_metre_ * tally.length - weights_.priority * tally.mean_priority();
  }
  /// Whether a path is better than the present one by so much of Eq. (5).
  bool better(const PathTally& tally, double gain) const {
    return tally.length <= longest_ && penalty(tally) < penalty_ - gain;
  }
  void take(const PathTally& tally);

  PenaltyWeights weights_;
  double per_metre_ = 0.0;  ///< W_L / L_direct
  Point cell_ = Point::Ones();
  bool flat_ = false;  ///< all vertices share one altitude
  double longest_ = 0.0;
  std::size_t most_vertices_ = 0;
  std::int64_t tries_ = 0;  ///< left

  // The present path.
  std::vector<Vertex> vertices_;
  std::vector<Piece> pieces_;
  PathTally tally_;
  double penalty_ = 0.0;

  // Of `shortcut`, by vertex.
  std::vector<double> costs_;
  std::vector<std::size_t> previous_;
  std::vector<char> kept_;
};

/// Refines the paths that another planner finds: `PlannerOptions::refine`. Name, completeness,
/// statuses and bound stay that planner's.
class RefinedPlanner final : public Planner {
 public:
  RefinedPlanner(std::unique_ptr<Planner> planner, const PenaltyWeights& weights);

  std::string_view name() const override { return planner_->name(); }
  bool complete() const override { return planner_->complete(); }
  Plan plan(const Scene& scene, const Query& query) override;

 private:
  std::unique_ptr<Planner> planner_;
  PenaltyWeights weights_;
  Refiner refiner_;
};

}  // namespace ltp
