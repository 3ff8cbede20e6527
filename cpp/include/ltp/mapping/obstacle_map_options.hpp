// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `ObstacleMapOptions`: every setting of the obstacle map.
#pragma once

#include <array>

#include "ltp/geometry/types.hpp"

namespace ltp {

struct ObstacleMapOptions {
  Point cell = Point(2, 2, 4);  ///< edges of a planning cell [m], multiples of the smallest one
  std::array<int, 3> dims = {200, 200, 40};  ///< planning cells along x, y, z
  /// The vehicle's radius [m]: a cell within it, and the margin, of an occupied voxel is blocked.
  double inflation_radius = 1.0;
  double margin = 0.0;  ///< added to it, for errors of pose, range and path keeping [m]
  /// Measure from whole occupied cells, not from the voxels in them: what flights before version
  /// 0.3 did. Of cells that are higher than a voxel it blocks more.
  bool inflate_whole_cells = false;
  /// A hit at or beyond this distance from the scan's origin marks nothing [m].
  double max_range = 50.0;
  /// A hit nearer than this to the scan's origin marks nothing: the aircraft sees itself, or the
  /// sensor writes its own place where there was no return [m]; 0: any hit counts. As far as the
  /// arms of a quadrotor of 10 kg reach, *assumed*.
  double blind_distance = 1.0;
  /// Corners of a box, in the frame of the pose given with a scan (the world's axes if only its
  /// origin is given), about that pose [m]: hits in it mark nothing. Twice the same point: no box.
  Point body_min = Point::Zero();
  Point body_max = Point::Zero();

  /// Remember what leaves the window, without limit: it is there again when the window comes back.
  /// False: the paper's map, which forgets it.
  bool remember = true;

  /// Learn from what rays passed, too. The paper's map does not: what was hit stays.
  bool carve_free_space = false;
  /// Only with carving: rays that pass an occupied voxel say nothing about it, so that a thin pole
  /// between two beams never vanishes, and an occupied voxel stays so.
  /// False: OctoMap's rule, where three passing rays erase a hit; for obstacles that move.
  bool keep_hits = true;
  // OctoMap's defaults, rounded.
  double hit_log_odds = 0.85;   ///< added to a voxel's log-odds by a hit, > 0
  double miss_log_odds = -0.4;  ///< added by a ray that passes, < 0
  double min_log_odds = -2.0;   ///< clamping, < 0
  double max_log_odds = 3.5;    ///< clamping, > 0

  /// How near to something occupied a cell is blocked [m]; 0: only cells with a hit in them.
  double clearance() const { return inflation_radius + margin; }
  /// The sources of inflation along each edge of a planning cell: its voxels, or the cell itself.
  std::array<int, 3> inflated_parts() const {
    return inflate_whole_cells ? std::array<int, 3>{1, 1, 1} : voxels_per_cell();
  }
  /// Whether hits beyond the window are remembered for when it comes there. Carving, which would
  /// not see what passes there, leaves them out.
  bool keeps_hits_beyond() const { return remember && !carve_free_space; }
  bool has_body() const { return body_min != body_max; }

  /// Voxels along each edge of a planning cell; a voxel is a cube of the smallest edge.
  std::array<int, 3> voxels_per_cell() const;

  /// Throws `std::invalid_argument` that names the field.
  void check() const;
};

}  // namespace ltp
