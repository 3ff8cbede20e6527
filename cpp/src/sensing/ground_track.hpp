// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The track of a ray over the squares of a raster: which boundaries it crosses, and when.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "ltp/grid/raster.hpp"

namespace ltp::sensing {

/// A direction with a smaller component than this runs parallel to the axis.
inline constexpr double kParallel = 1e-12;

/// Where a point lies over a raster along one axis (0: x, 1: y) [cells].
inline double start_over(const Raster& raster, const Point& point, int axis) {
  return (point[axis] - raster.origin()[axis]) / raster.cell();
}

/// What all tracks from one point have in common along one axis (0: x, 1: y) of a raster.
struct TrackStart {
  TrackStart(const Raster& raster, const Point& origin, int axis)
      : start(start_over(raster, origin, axis)),
        cell(raster.cell()),
        per_cell(1.0 / raster.cell()),
        cells(axis == 0 ? raster.nx() : raster.ny()) {}

  /// The cell in which a track begins that goes up, down or neither, if it begins inside.
  int first_cell(int step) const {
    return static_cast<int>(step < 0 ? std::ceil(start) - 1.0 : std::floor(start));
  }

  double start;     ///< [cells]
  double cell;      ///< [m]
  double per_cell;  ///< [1/m]
  int cells;        ///< of the raster along this axis
};

/// One axis of a track. Every crossing time comes from `time` alone, so whoever asks for the same
/// boundary gets the same number, however he came there.
struct TrackAxis {
  TrackAxis(const TrackStart& from, double direction) : start(from.start), cells(from.cells) {
    if (std::abs(direction) < kParallel) return;
    step = direction > 0.0 ? 1 : -1;
    rate = direction * from.per_cell;
    inverse = from.cell / direction;
  }

  /// When the track crosses the boundary below cell `boundary` [m along it].
  double time(double boundary) const { return (boundary - start) * inverse; }

  /// When it enters and leaves the raster's slab.
  double enter() const {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (step == 0) return start >= 0.0 && start < cells ? -kInfinity : kInfinity;
    return time(step > 0 ? 0 : cells);
  }
  double leave() const {
    return step == 0 ? std::numeric_limits<double>::infinity() : time(step > 0 ? cells : 0);
  }

  /// The cell it runs in just after time `t`, which must lie within the slab. The division guesses,
  /// the crossing times decide.
  int cell_after(double t) const {
    int cell = static_cast<int>(std::clamp(start + t * rate, 0.0, cells - 1.0));
    if (step > 0) {
      while (cell + 1 < cells && time(cell + 1) <= t) ++cell;
      while (cell > 0 && time(cell) > t) --cell;
    } else if (step < 0) {
      while (cell > 0 && time(cell) <= t) --cell;
      while (cell + 1 < cells && time(cell + 1) > t) ++cell;
    }
    return cell;
  }

  /// When it leaves a cell by a boundary of this axis.
  double leave(int cell) const {
    return step == 0 ? std::numeric_limits<double>::infinity() : time(step > 0 ? cell + 1 : cell);
  }
  /// When it enters a cell by a boundary of this axis; only if it is not parallel.
  double enter(int cell) const { return time(step > 0 ? cell : cell + 1); }
  /// How many cells there are from the one where it is just after time `t`.
  int slabs_from(double t) const { return step > 0 ? cells - cell_after(t) : cell_after(t) + 1; }
  /// Whether it enters a cell at time `t`, by a boundary of this axis.
  bool enters(int cell, double t) const { return step != 0 && enter(cell) == t; }

  double start;          ///< [cells]
  double rate = 0.0;     ///< cells per metre of the track
  double inverse = 0.0;  ///< metres of the track per cell
  int step = 0;          ///< -1, 0 (parallel) or 1
  int cells;             ///< of the raster along this axis
};

/// Both axes, and the part of the track that lies over the raster, from the origin on.
struct GroundTrack {
  GroundTrack(const TrackAxis& along_x, const TrackAxis& along_y)
      : x(along_x), y(along_y), leave(std::min(x.leave(), y.leave())) {
    const double enter_x = x.enter();
    const double enter_y = y.enter();
    if (enter_x >= 0.0 || enter_y >= 0.0) axis = enter_x >= enter_y ? 0 : 1;
    enter = std::max({0.0, enter_x, enter_y});
  }

  GroundTrack(const Raster& raster, const Point& origin, double direction_x, double direction_y)
      : GroundTrack(TrackAxis(TrackStart(raster, origin, 0), direction_x),
                    TrackAxis(TrackStart(raster, origin, 1), direction_y)) {}

  bool crosses() const { return enter < leave; }

  TrackAxis x;
  TrackAxis y;
  double enter;   ///< [m]
  double leave;   ///< [m]
  int axis = -1;  ///< the face through which it enters the raster: 0: x, 1: y, -1: starts inside
};

/// How far a ray has come: it has just entered cell (i, j), and has hit nothing before.
struct TrackPosition {
  int i;
  int j;
  double t;  ///< [m]
  int face;  ///< by which it entered: 0: x, 1: y, -1: starts inside
};

}  // namespace ltp::sensing
