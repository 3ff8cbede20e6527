// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/sensing/height_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ltp/geometry/check.hpp"
#include "ltp/geometry/norm.hpp"

namespace ltp {
namespace {

constexpr double kOverlap = 1e-7;  // what is thinner is rounding, not solid [m]
constexpr double kTouch = 1e-9;    // a wall this near is touched [cells]

/// A closed interval of the parameter t of a segment; empty if low > high.
struct Interval {
  double low;
  double high;
};

/// Where a + t * delta lies in the closed interval [low, high], within `within`.
Interval inside(double a, double delta, double low, double high, const Interval& within) {
  if (delta == 0.0) return a >= low && a <= high ? within : Interval{1.0, 0.0};
  const double t_low = (low - a) / delta;
  const double t_high = (high - a) / delta;
  return {std::max(within.low, std::min(t_low, t_high)),
          std::min(within.high, std::max(t_low, t_high))};
}

/// Indices of the cells whose closed extents meet a + [t.low, t.high] * delta, in order of travel.
struct CellRange {
  CellRange(double a, double delta, const Interval& t, int cells) {
    const double from = a + t.low * delta;
    const double to = a + t.high * delta;
    const double low = std::max(std::floor(std::min(from, to) - kTouch), 0.0);
    const double high = std::min(std::floor(std::max(from, to) + kTouch), cells - 1.0);
    if (!(low <= high)) return;
    count = static_cast<int>(high - low) + 1;
    step = delta < 0.0 ? -1 : 1;
    first = static_cast<int>(step > 0 ? low : high);
  }
  int first = 0;
  int step = 1;
  int count = 0;
};

/// The parameter in [0, 1] at which the segment a-b first touches the columns; > 1 if it does not.
/// Plain intersection of closed intervals, so no boundary case can slip between two cells.
double first_touch(const Raster& heights, const Point& a, const Point& b) {
  const Eigen::Vector2d start = (a.head<2>() - heights.origin()) / heights.cell();
  const Eigen::Vector2d delta = (b - a).head<2>() / heights.cell();
  const double rise = b.z() - a.z();
  double first = 2.0;
  const CellRange rows(start.x(), delta.x(), {0.0, 1.0}, heights.nx());
  for (int n = 0, i = rows.first; n < rows.count; ++n, i += rows.step) {
    const Interval row = inside(start.x(), delta.x(), i - kTouch, i + 1.0 + kTouch, {0.0, 1.0});
    if (row.low > row.high) continue;
    if (row.low > first) break;
    const CellRange columns(start.y(), delta.y(), row, heights.ny());
    for (int m = 0, j = columns.first; m < columns.count; ++m, j += columns.step) {
      const Interval cell = inside(start.y(), delta.y(), j - kTouch, j + 1.0 + kTouch, row);
      if (cell.low > cell.high) continue;
      if (cell.low > first) break;
      const double height = heights.values()(i, j);
      if (a.z() + cell.low * rise <= height) {
        first = std::min(first, cell.low);
      } else if (a.z() + cell.high * rise <= height) {
        first = std::min(first, std::clamp((height - a.z()) / rise, cell.low, cell.high));
      }
    }
  }
  return first;
}

}  // namespace

HeightSurface::HeightSurface(Raster heights) : heights_(std::move(heights)) {
  levels_.push_back({0, heights_.nx(), heights_.ny()});
  while (levels_.back().nx > 1 || levels_.back().ny > 1) {
    const Level finer = levels_.back();
    const Level coarser{maxima_.size(), (finer.nx + 1) / 2, (finer.ny + 1) / 2};
    maxima_.resize(maxima_.size() + static_cast<std::size_t>(coarser.nx) * coarser.ny,
                   -std::numeric_limits<double>::infinity());
    const double* from = values(top());
    double* to = maxima_.data() + coarser.offset;
    for (int i = 0; i < finer.nx; ++i) {
      for (int j = 0; j < finer.ny; ++j) {
        double& maximum = to[static_cast<std::size_t>(i / 2) * coarser.ny + j / 2];
        maximum = std::max(maximum, from[static_cast<std::size_t>(i) * finer.ny + j]);
      }
    }
    levels_.push_back(coarser);
  }
}

std::optional<double> HeightSurface::first_collision(const PathRef& path) const {
  double arc = 0.0;
  for (Eigen::Index n = 0; n < path.rows(); ++n) {
    check::finite("path[" + std::to_string(n) + "]", Point(path.row(n).transpose()));
  }
  for (Eigen::Index n = 0; n < path.rows(); ++n) {
    const Point b = path.row(n).transpose();
    const Point a = n > 0 ? Point(path.row(n - 1).transpose()) : b;
    const double size = norm(b - a);
    const double t = first_touch(heights_, a, b);
    if (t <= 1.0) return arc + t * size;
    arc += size;
  }
  return std::nullopt;
}

double HeightSurface::squared_distance(const Point& point, int level, int bi, int bj) const {
  const double cell = heights_.cell();
  const auto gap = [&](int axis, int block, int cells) {
    const double low = heights_.origin()[axis] + (block << level) * cell;
    const double high = heights_.origin()[axis] + std::min((block + 1) << level, cells) * cell;
    return std::max({low - point[axis], point[axis] - high, 0.0});
  };
  const double dx = gap(0, bi, heights_.nx());
  const double dy = gap(1, bj, heights_.ny());
  const double height = values(level)[static_cast<std::size_t>(bi) * levels_[level].ny + bj];
  const double dz = std::max(point.z() - height, 0.0);
  return dx * dx + dy * dy + dz * dz;
}

double HeightSurface::squared_clearance(const Point& point, int level, int bi, int bj,
                                        double nearest) const {
  if (level == 0) return std::min(nearest, squared_distance(point, 0, bi, bj));
  // Nearest block first: it leaves the others little to beat.
  struct Block {
    double bound;
    int bi;
    int bj;
  };
  std::array<Block, 4> blocks;
  int count = 0;
  for (int i = 2 * bi; i < std::min(2 * bi + 2, levels_[level - 1].nx); ++i) {
    for (int j = 2 * bj; j < std::min(2 * bj + 2, levels_[level - 1].ny); ++j) {
      const double bound = squared_distance(point, level - 1, i, j);
      if (!(bound < nearest)) continue;
      int place = count++;
      for (; place > 0 && blocks[place - 1].bound > bound; --place) {
        blocks[place] = blocks[place - 1];
      }
      blocks[place] = {bound, i, j};
    }
  }
  for (int n = 0; n < count && blocks[n].bound < nearest; ++n) {
    nearest = squared_clearance(point, level - 1, blocks[n].bi, blocks[n].bj, nearest);
  }
  return nearest;
}

double HeightSurface::clearance(const Point& point, double max_distance) const {
  check::finite("point", point);
  check::not_negative("max_distance", max_distance);
  return std::min(max_distance,
                  std::sqrt(squared_clearance(point, top(), 0, 0, max_distance * max_distance)));
}

OccupancyGrid HeightSurface::occupancy(const GridFrame& frame) const {
  // The grid's columns that each of the raster's rows and columns overlaps, both ends included.
  struct Span {
    int low;
    int high;
  };
  const auto spans = [&](int axis, int cells) {
    std::vector<Span> all(cells);
    for (int n = 0; n < cells; ++n) {
      const double edge = heights_.origin()[axis] + n * heights_.cell();
      Point low = frame.origin();
      Point high = frame.origin();
      low[axis] = std::max(edge + kOverlap, frame.origin()[axis]);
      high[axis] = std::min(edge + heights_.cell() - kOverlap, frame.upper()[axis]);
      all[n] = {std::max(frame.cell_of(low)[axis], 0),
                std::min(frame.cell_of(high)[axis], frame.dims()[axis] - 1)};
    }
    return all;
  };
  const std::vector<Span> rows = spans(0, heights_.nx());
  const std::vector<Span> columns = spans(1, heights_.ny());

  constexpr double kNothing = -std::numeric_limits<double>::infinity();
  std::vector<double> highest(static_cast<std::size_t>(frame.nx()) * frame.ny(), kNothing);
  for (int i = 0; i < heights_.nx(); ++i) {
    for (int j = 0; j < heights_.ny(); ++j) {
      const double height = heights_.values()(i, j);
      for (int ix = rows[i].low; ix <= rows[i].high; ++ix) {
        for (int iy = columns[j].low; iy <= columns[j].high; ++iy) {
          double& top = highest[static_cast<std::size_t>(ix) * frame.ny() + iy];
          top = std::max(top, height);
        }
      }
    }
  }

  OccupancyGrid grid(frame);
  const Point origin = frame.origin();
  for (int ix = 0; ix < frame.nx(); ++ix) {
    for (int iy = 0; iy < frame.ny(); ++iy) {
      const double height = highest[static_cast<std::size_t>(ix) * frame.ny() + iy];
      if (height == kNothing) continue;
      const Point below_top(origin.x(), origin.y(), height - kOverlap);
      const int level = height >= frame.upper().z() ? frame.nz() - 1 : frame.cell_of(below_top).z();
      for (int iz = 0; iz <= std::min(level, frame.nz() - 1); ++iz) grid.set({ix, iy, iz});
    }
  }
  return grid;
}

}  // namespace ltp
