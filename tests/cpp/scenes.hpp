// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes for the planners' tests, and slow, obvious judges of what a planner answers.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "ltp/grid/columns.hpp"
#include "ltp/grid/neighbourhood.hpp"
#include "ltp/planning/planner.hpp"

namespace ltp::test {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr AltitudeBand kPlanar{0.0, 0.0};

/// One question to a planner.
struct Situation {
  std::string name;
  OccupancyGrid grid;
  Raster priority;
  Query query;
  /// What a complete planner must answer, where it is known by hand.
  std::optional<PlanStatus> expected = std::nullopt;
  /// Whether start and goal are centres of cells: then no path even touches a blocked box.
  bool centred = true;

  Scene scene() const { return {grid, priority}; }
};

/// A priority between 0 and 1 that differs from column to column, somewhat smaller than the grid.
inline Raster random_priority(const GridFrame& frame, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Raster::Values values(std::max(1, frame.nx() - 1), std::max(1, frame.ny() - 1));
  for (Eigen::Index i = 0; i < values.size(); ++i) values.data()[i] = unit(random);
  return Raster(values, frame.origin().head<2>(), frame.cell().x(), 0.5);
}

/// A situation from a map: `#` blocked, `S` start, `G` goal (on free cells), `s`, `g` on blocked
/// ones. The first line is the north. The map fills the levels `low` to `high`; start and goal are
/// on `level`.
struct Drawing {
  Point cell{2, 2, 4};
  int levels = 1;
  int level = 0;
  int low = 0;
  int high = 0;
  AltitudeBand band{};

  Situation operator()(const std::string& name, const std::vector<std::string>& lines,
                       std::optional<PlanStatus> expected = std::nullopt) const {
    const int nx = static_cast<int>(lines.front().size());
    const int ny = static_cast<int>(lines.size());
    const GridFrame frame(Point(-7, 3, 10), cell, {nx, ny, levels});
    Situation made{name, OccupancyGrid(frame), random_priority(frame, 7), {}, expected};
    made.query.band = band;
    for (int ix = 0; ix < nx; ++ix) {
      for (int iy = 0; iy < ny; ++iy) {
        const char mark = lines[ny - 1 - iy].at(ix);
        if (mark == '#' || mark == 's' || mark == 'g') {
          for (int iz = low; iz <= high; ++iz) made.grid.set(Cell(ix, iy, iz));
        }
        if (mark == 'S' || mark == 's') made.query.start = frame.centre(Cell(ix, iy, level));
        if (mark == 'G' || mark == 'g') made.query.goal = frame.centre(Cell(ix, iy, level));
      }
    }
    return made;
  }
};

/// Cells of the levels that steps to 26 neighbours reach, none of which has a blocked cell in its
/// bounding box; by frame index.
inline std::vector<char> reachable(const OccupancyGrid& grid, const Cell& from,
                                   const LevelRange& levels) {
  const GridFrame& frame = grid.frame();
  std::vector<char> seen(frame.size(), 0);
  std::vector<Cell> open = {from};
  seen[frame.index(from)] = 1;
  while (!open.empty()) {
    const Cell cell = open.back();
    open.pop_back();
    for (int kind = 0; kind < 27; ++kind) {
      const Cell next = cell + Cell(kind / 9 - 1, kind / 3 % 3 - 1, kind % 3 - 1);
      if (!frame.contains(next) || next.z() < levels.lowest || next.z() > levels.highest) continue;
      bool legal = !seen[frame.index(next)];
      const Cell low = cell.cwiseMin(next);
      const Cell high = cell.cwiseMax(next);
      for (int x = low.x(); x <= high.x(); ++x) {
        for (int y = low.y(); y <= high.y(); ++y) {
          for (int z = low.z(); z <= high.z(); ++z) {
            legal = legal && (!grid.blocked(Cell(x, y, z)) || Cell(x, y, z) == cell);
          }
        }
      }
      if (!legal) continue;
      seen[frame.index(next)] = 1;
      open.push_back(next);
    }
  }
  return seen;
}

/// The levels that hold more of a band than a face, by looking at each; and those of both ends.
inline LevelRange slow_levels(const GridFrame& frame, const Query& query) {
  const double low = std::min(query.start.z(), query.goal.z()) - query.band.below;
  const double high = std::max(query.start.z(), query.goal.z()) + query.band.above;
  const int start = frame.cell_of(query.start).z();
  const int goal = frame.cell_of(query.goal).z();
  LevelRange levels{std::min(start, goal), std::max(start, goal)};
  for (int iz = 0; iz < frame.nz(); ++iz) {
    const double floor = frame.centre(Cell(0, 0, iz)).z() - 0.5 * frame.cell().z();
    const double touch = 1e-9 * std::min(1.0, frame.cell().z());
    if (floor + frame.cell().z() > low + touch && iz < levels.lowest) levels.lowest = iz;
    if (floor < high - touch && iz > levels.highest) levels.highest = iz;
  }
  return levels;
}

/// Where a path passes a cell that holds none of its ends: as near to its centre as the band lets
/// it.
inline Point slow_vertex(const GridFrame& frame, const Query& query, const Cell& cell) {
  Point point = frame.centre(cell);
  const double low = std::min(query.start.z(), query.goal.z()) - query.band.below;
  const double high = std::max(query.start.z(), query.goal.z()) + query.band.above;
  if (point.z() < low) point.z() = low;
  if (point.z() > high) point.z() = high;
  return point;
}

/// The priority that a plan was tallied over.
inline Raster seen_priority(const Plan& plan, const Situation& situation) {
  if (!plan.priority_resampled) return situation.priority;
  return onto_columns(situation.priority, situation.grid.frame());
}

/// What a complete planner must answer.
inline PlanStatus slow_status(const Situation& situation) {
  const GridFrame& frame = situation.grid.frame();
  const Query& query = situation.query;
  if (!frame.contains(query.start) || !frame.contains(query.goal)) return PlanStatus::OutsideMap;
  if (situation.grid.blocked_at(query.goal)) return PlanStatus::GoalBlocked;
  if (situation.grid.blocked_at(query.start)) return PlanStatus::StartBlocked;
  const std::vector<char> seen =
      reachable(situation.grid, frame.cell_of(query.start), slow_levels(frame, query));
  return seen[frame.index(frame.cell_of(query.goal))] ? PlanStatus::Found : PlanStatus::Unreachable;
}

/// Whether a path meets the box of a blocked cell, grown by `margin` [m] on all sides (shrunk if
/// negative): every segment is clipped at every box.
inline bool meets_blocked(const OccupancyGrid& grid, const Path& path, double margin) {
  const GridFrame& frame = grid.frame();
  for (std::int64_t index = 0; index < frame.size(); ++index) {
    const Cell cell = frame.cell_at(index);
    if (!grid.blocked(cell)) continue;
    const Point half = frame.cell() / 2 + Point::Constant(margin);
    for (Eigen::Index i = 0; i + 1 < path.rows(); ++i) {
      const Point a = path.row(i).transpose() - frame.centre(cell);
      const Point b = path.row(i + 1).transpose() - frame.centre(cell);
      double in = 0.0;
      double out = 1.0;
      for (int axis = 0; axis < 3; ++axis) {
        const double delta = b[axis] - a[axis];
        if (delta == 0.0) {
          if (std::abs(a[axis]) > half[axis]) out = -1.0;
          continue;
        }
        const double first = (-half[axis] - a[axis]) / delta;
        const double second = (half[axis] - a[axis]) / delta;
        in = std::max(in, std::min(first, second));
        out = std::min(out, std::max(first, second));
      }
      if (in <= out) return true;
    }
  }
  return false;
}

/// Walls, traps and slits, drawn by hand: on one level, and on the middle one of three.
std::vector<Situation> drawn_situations();
/// What only happens in space or at the numbers' edges: boxes, towers, faces, odd frames, clutter.
std::vector<Situation> built_situations();
/// Both.
std::vector<Situation> situations();

}  // namespace ltp::test
