// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `ObstacleMap`: what the sensor has touched round the UAV, and which cells a path must therefore
// avoid.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>

#include "ltp/geometry/types.hpp"
#include "ltp/grid/occupancy_grid.hpp"

namespace ltp {

struct ObstacleMapOptions {
  Point cell = Point(2, 2, 4);  ///< edges of a planning cell [m], multiples of the smallest one
  std::array<int, 3> dims = {200, 200, 40};  ///< planning cells along x, y, z
  double inflation_radius =
      1.0;  ///< a cell any point of which is this near to an occupied cell is blocked [m]; 0: none
  double max_range =
      50.0;  ///< a hit at or beyond this distance from the scan's origin marks nothing [m]

  bool carve_free_space = false;  ///< lower the log-odds of the voxels that rays pass through
  /// A voxel that was ever hit stays occupied until it leaves the window, however many rays pass
  /// it: a pole between two beams must not vanish. False lets log-odds erase it, for moving
  /// obstacles. Only matters with carving.
  bool keep_hits = true;
  double hit_log_odds = 0.85;   ///< added to a voxel's log-odds by a hit (OctoMap's default)
  double miss_log_odds = -0.4;  ///< added by a ray that passes (OctoMap's default), < 0
  double min_log_odds = -2.0;   ///< clamping (OctoMap's default)
  double max_log_odds = 3.5;    ///< clamping (OctoMap's default)

  void check() const;
};

/// What became of a scan's points, and of the map.
struct InsertStatistics {
  std::int64_t marked = 0;        ///< hits that fell into the window
  std::int64_t outside = 0;       ///< hits beyond the window
  std::int64_t out_of_range = 0;  ///< hits at or beyond the maximum range: treated as misses
  std::int64_t invalid = 0;       ///< hits or misses that are not finite: ignored
  std::int64_t new_cells = 0;     ///< planning cells that became occupied
  std::int64_t erased_cells = 0;  ///< planning cells that became free by carving
};

/// Voxels (cubes of the planning cell's smallest edge) are the memory, planning cells the view: a
/// cell is occupied if any voxel in it is, and blocked if it is within the inflation radius of an
/// occupied one. Only the window round the UAV is kept. Insertion allocates nothing. OctoMap is the
/// archive: files and interchange.
class ObstacleMap {
 public:
  /// A map whose window is centred on `centre` [m]; its lattice passes through the world's origin.
  explicit ObstacleMap(const ObstacleMapOptions& options = {}, const Point& centre = Point::Zero());
  ~ObstacleMap();
  ObstacleMap(ObstacleMap&&) noexcept;
  ObstacleMap& operator=(ObstacleMap&&) noexcept;

  const ObstacleMapOptions& options() const;
  const OccupancyGrid& occupied() const;  ///< planning cells with a hit in them
  const OccupancyGrid& blocked() const;   ///< the same, inflated: what planners get
  const OccupancyGrid& voxels() const;    ///< occupied voxels
  double voxel_size() const;              ///< [m]

  /// Adds a scan: where its rays began, where they hit something, and where those without a return
  /// stopped being seen; world frame, shape (N, 3) [m]. Strange points never throw: they are
  /// counted. `misses` only matter with carving. Throws only for an `origin` that is not finite.
  InsertStatistics insert(const Point& origin, const PathRef& hits, const PathRef& misses);

  /// Moves the window so that it is centred on a point; cells that enter are unknown. Returns the
  /// shift in cells.
  Cell recentre(const Point& centre);
  void clear();

  /// Log-odds of the voxel at a point; 0 where nothing is known.
  double log_odds_at(const Point& point) const;

  /// Writes OctoMap's `.bt` (occupied or not) or `.ot` (log-odds), by the file's extension;
  /// atomically.
  void save(const std::string& path) const;
  /// Adds the occupied voxels of a `.bt` or `.ot` file that lie in the window. The file's
  /// resolution must be the voxel size. Throws `std::invalid_argument` that names the file for
  /// anything malformed; the map stays as it was.
  void load(const std::string& path);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Marks in `out` every cell any point of which is within `radius` [m] of an occupied cell. Radius
/// 0 copies.
void inflate(const OccupancyGrid& occupied, double radius, OccupancyGrid& out);

}  // namespace ltp
