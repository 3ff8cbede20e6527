// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `ObstacleMap`: what the sensor has touched round the UAV, and which cells a path must therefore
// avoid.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "ltp/geometry/points_view.hpp"
#include "ltp/geometry/types.hpp"
#include "ltp/grid/cell_box.hpp"
#include "ltp/grid/occupancy_grid.hpp"
#include "ltp/mapping/carver.hpp"
#include "ltp/mapping/inflation.hpp"
#include "ltp/mapping/insert_statistics.hpp"
#include "ltp/mapping/mission_map.hpp"
#include "ltp/mapping/obstacle_map_options.hpp"
#include "ltp/mapping/own_returns.hpp"

namespace ltp {

/// Voxels (cubes of the planning cell's smallest edge) are the memory, planning cells the view: a
/// cell is occupied if any voxel in it is, and blocked if its closed box is within the clearance
/// (`inflation_radius + margin`) of the closed box of an occupied voxel: a vehicle of that radius,
/// anywhere in a free cell, touches none.
///
/// The window round the UAV is bits. What leaves it is kept in a `MissionMap`, OctoMap's octree,
/// and comes back as it was when the window does. At any time `blocked()` is the part in the window
/// of the inflation of all that is remembered, what lies beyond the window too; so a cell does not
/// change by the window's moving to and fro. A map that forgets (`remember = false`) inflates what
/// is in the window: `blocked() == inflate(voxels(), clearance, voxels_per_cell)`, or with
/// `inflate_whole_cells` `inflate(occupied(), clearance)`.
///
/// Only what is new allocates: a voxel hit for the first time, or, with carving, known voxels that
/// leave the window for the first time. A copy is a snapshot, the mission with it: a deep copy, as
/// costly as that is large. Who plans on another thread copies the grids only.
class ObstacleMap {
 public:
  /// A map whose window is centred on `centre` [m]; its lattice passes through the world's origin.
  /// Throws `std::invalid_argument` that names the option.
  explicit ObstacleMap(const ObstacleMapOptions& options = {}, const Point& centre = Point::Zero());

  const ObstacleMapOptions& options() const { return options_; }
  const OccupancyGrid& occupied() const {
    return occupied_;
  }  ///< planning cells with a hit in them
  const OccupancyGrid& blocked() const {
    return blocked_;
  }  ///< the same, inflated: what planners get
  const OccupancyGrid& voxels() const { return voxels_; }           ///< occupied voxels
  double voxel_size() const { return voxels_.frame().cell().x(); }  ///< [m]
  /// Grows, from 0, whenever planning cells become occupied, blocked or free: by a scan, a file, or
  /// `clear`.
  /// Recentring leaves it: what stays in the window keeps its meaning, what enters is as it was.
  std::int64_t version() const { return version_; }
  /// The voxels of the mission, in the window and beyond; nothing for a map that forgets. With
  /// carving it learns about those in the window when they leave it.
  const std::optional<MissionMap>& mission() const { return mission_; }
  /// The inflation of all that the mission holds in one grid on the window's lattice, as small as
  /// can be; nothing if it holds nothing or that is longer than `most` cells along an axis.
  std::optional<OccupancyGrid> blocked_everywhere(int most) const;
  /// The sum over all scans since the map was made.
  const InsertStatistics& totals() const { return totals_; }

  /// Adds a scan: where its rays began, where they hit something, and where those without a return
  /// stopped being seen; world frame [m]. The sensor's attitude only turns the body box. Strange
  /// points never throw: they are counted. `misses` only matter with carving. Throws only for an
  /// origin or a pose that is not finite.
  InsertStatistics insert(const Pose& sensor, const PointsView& hits,
                          const PointsView& misses = {});
  InsertStatistics insert(const Point& origin, const PointsView& hits,
                          const PointsView& misses = {}) {
    return insert(Pose{origin}, hits, misses);
  }

  /// Moves the window so that it is centred on a point; cells that enter are as they were when they
  /// left, or unknown, and those of a map that forgets always unknown. Returns the shift in
  /// planning cells. Throws for a point that is not finite or absurdly far.
  Cell recentre(const Point& centre);
  /// Recentres on the origin of a scan, then inserts it.
  InsertStatistics sense(const Pose& sensor, const PointsView& hits, const PointsView& misses);
  InsertStatistics sense(const Point& origin, const PointsView& hits, const PointsView& misses) {
    return sense(Pose{origin}, hits, misses);
  }
  /// Forgets everything, the mission too.
  void clear();

  /// Log-odds of the voxel at a point, in the window or remembered; 0 where nothing is known.
  /// Without carving a voxel that was hit has those of one hit.
  double log_odds_at(const Point& point) const;

  /// Writes the whole mission, or what a map that forgets has in its window: OctoMap's `.bt`
  /// (occupied or free) or `.ot` (log-odds), by the file's extension; atomically. Without carving
  /// there are only occupied voxels in it. Throws `std::invalid_argument` for another extension or
  /// a map further than 32768 voxels from the origin, which OctoMap cannot hold;
  /// `std::runtime_error` if the file cannot be written.
  void save(const std::string& path) const;
  /// Adds what a `.bt` or `.ot` file knows, to a map that forgets what it knows about the window:
  /// its occupied voxels and, with carving, the free ones that the map knows nothing about. The
  /// file's resolution must be the voxel size.
  /// Throws `std::invalid_argument` that names the file for anything malformed; the map then stays
  /// as it was.
  void load(const std::string& path);

 private:
  Cell cell_of_voxel(const Cell& voxel) const;
  bool any_voxel_in(const Cell& cell) const;
  /// What follows from a voxel that has become occupied. Whether its planning cell was free before.
  bool occupy_cell_of(const Cell& voxel);
  // What ties the window to the mission; boxes are of planning cells of the window.
  /// Tells a mission what the map knows of a box.
  void note(const CellBox& cells, MissionMap& mission) const;
  /// The box becomes what a mission knows of it, but for what is blocked.
  void restore(const CellBox& cells, const MissionMap& mission);
  /// Inflates anew what lies in a box, as far as it is in the window.
  void repair(const CellBox& cells);
  void roll(const Cell& shift);
  double remembered_at(const Point& point) const;
  void remember_beyond(const Point& hit);  ///< which lies outside the window
  /// What inflates a voxel, inside the window or not: itself, or its cell.
  Cell source_of(const Cell& voxel) const;
  CellBox voxels_of(const CellBox& cells) const;  ///< counted from the world's origin

  const OccupancyGrid& inflated() const {
    return options_.inflate_whole_cells ? occupied_ : voxels_;
  }
  /// The second half of `insert`, with carving: hits are marked, rays are followed.
  void carve(const Point& origin, const OwnReturns& own, const PointsView& hits,
             const PointsView& misses, InsertStatistics& statistics);

  double one_hit() const;  ///< the log-odds of a voxel hit once

  ObstacleMapOptions options_;
  std::array<int, 3> ratio_;  ///< voxels along a planning cell's edges
  OccupancyGrid occupied_;
  OccupancyGrid blocked_;
  OccupancyGrid voxels_;
  Inflation inflation_;
  std::optional<Carver> carver_;       ///< only with `carve_free_space`
  std::optional<MissionMap> mission_;  ///< only with `remember`
  std::int64_t version_ = 0;
  bool changed_ = false;  ///< whether cells have changed that `version_` does not count yet
  InsertStatistics totals_;
};

}  // namespace ltp
