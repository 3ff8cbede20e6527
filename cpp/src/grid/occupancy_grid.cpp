// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/grid/occupancy_grid.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>

#include "ltp/geometry/check.hpp"
#include "ltp/geometry/norm.hpp"
#include "ltp/grid/bits.hpp"
#include "ltp/grid/cell_finder.hpp"
#include "ltp/grid/ray_walk.hpp"

namespace ltp {
namespace {

int popcount(std::uint64_t word) { return __builtin_popcountll(word); }

/// Moves the levels of one column down by `dz` (up if negative).
void shift_levels(std::uint64_t* column, int words, int nz, int dz) {
  const int by_words = std::abs(dz) / 64;
  const int by_bits = std::abs(dz) % 64;
  const auto word = [&](int w) { return w >= 0 && w < words ? column[w] : std::uint64_t{0}; };
  if (dz > 0) {
    for (int w = 0; w < words; ++w) {
      std::uint64_t value = word(w + by_words) >> by_bits;
      if (by_bits > 0) value |= word(w + by_words + 1) << (64 - by_bits);
      column[w] = value;
    }
  } else {
    for (int w = words - 1; w >= 0; --w) {
      std::uint64_t value = word(w - by_words) << by_bits;
      if (by_bits > 0) value |= word(w - by_words - 1) >> (64 - by_bits);
      column[w] = value & bits_between(w, 0, nz - 1);
    }
  }
}

}  // namespace

OccupancyGrid::OccupancyGrid(const GridFrame& frame)
    : frame_(frame),
      words_per_column_((frame.nz() - 1) / 64 + 1),
      words_(static_cast<std::size_t>(frame.nx()) * frame.ny() * words_per_column_) {}

void OccupancyGrid::blocked_at(const PointsView& points, bool* out) const {
  CellFinder(frame_).for_each(
      points, [&](Eigen::Index i, const Cell& cell) { out[i] = blocked(cell); },
      [&](Eigen::Index i) { out[i] = blocked_at(points[i]); });
}

void OccupancyGrid::set(const Cell& cell, bool blocked) {
  assert(frame_.contains(cell));
  std::uint64_t& word = column(cell.x(), cell.y())[cell.z() >> 6];
  const std::uint64_t bit = std::uint64_t{1} << (cell.z() & 63);
  word = blocked ? word | bit : word & ~bit;
}

void OccupancyGrid::clear() { std::fill(words_.begin(), words_.end(), 0); }

std::int64_t OccupancyGrid::count() const {
  std::int64_t sum = 0;
  for (const std::uint64_t word : words_) sum += popcount(word);
  return sum;
}

void OccupancyGrid::roll(const Cell& shift) {
  frame_ = frame_.shifted(shift);
  const std::int64_t nx = frame_.nx();
  const std::int64_t ny = frame_.ny();
  const int nz = frame_.nz();
  if (std::abs(std::int64_t{shift.x()}) >= nx || std::abs(std::int64_t{shift.y()}) >= ny ||
      std::abs(std::int64_t{shift.z()}) >= nz) {
    clear();
    return;
  }
  const std::int64_t row = ny * words_per_column_;  // words of one x
  if (shift.x() != 0 || shift.y() != 0) {
    // Column (ix, iy) takes what was at (ix + sx, iy + sy): one move of the whole board, then clear
    // what entered.
    const std::int64_t offset = shift.x() * row + std::int64_t{shift.y()} * words_per_column_;
    const std::int64_t size = static_cast<std::int64_t>(words_.size());
    std::uint64_t* data = words_.data();
    const std::int64_t kept = size - std::abs(offset);
    if (offset > 0) std::memmove(data, data + offset, kept * sizeof(*data));
    if (offset < 0) std::memmove(data - offset, data, kept * sizeof(*data));
    for (std::int64_t ix = 0; ix < nx; ++ix) {
      const bool entered = ix + shift.x() < 0 || ix + shift.x() >= nx;
      std::uint64_t* begin = data + ix * row;
      if (entered) {
        std::fill(begin, begin + row, 0);
      } else if (shift.y() > 0) {
        std::fill(begin + (ny - shift.y()) * words_per_column_, begin + row, 0);
      } else if (shift.y() < 0) {
        std::fill(begin, begin - std::int64_t{shift.y()} * words_per_column_, 0);
      }
    }
  }
  if (shift.z() != 0) {
    const std::int64_t end = static_cast<std::int64_t>(words_.size());
    std::int64_t next = next_in_use(words_.data(), 0, end);
    while (next < end) {
      const std::int64_t begin = next - next % words_per_column_;
      shift_levels(words_.data() + begin, words_per_column_, nz, shift.z());
      next = next_in_use(words_.data(), begin + words_per_column_, end);
    }
  }
}

std::optional<double> OccupancyGrid::first_blocked(const PathRef& path, double from,
                                                   const std::optional<Cell>& ignored) const {
  if (!path.allFinite()) check::fail("path", "not finite", "finite numbers only");
  if (std::isnan(from)) check::fail("from", from, "a number");
  // On the anchor's lattice, so that the walk's cells and `cell_of` never disagree.
  const Point low = frame_.first().cast<double>();
  const Point high =
      (low + Point(frame_.nx(), frame_.ny(), frame_.nz())).cwiseMin(Point::Constant(kFarthestCell));
  if (path.rows() == 1) {
    const Point only = path.row(0).transpose();
    if (from <= 0.0 && blocked_at(only) && frame_.cell_of(only) != ignored) return 0.0;
    return std::nullopt;
  }
  double arc = 0.0;
  for (Eigen::Index i = 1; i < path.rows(); ++i) {
    const Point a = path.row(i - 1).transpose();
    const Point b = path.row(i).transpose();
    const double size = norm(b - a);
    if (arc + size >= from) {
      const double t_min = size > 0.0 && from > arc ? (from - arc) / size : 0.0;
      const Point begin = t_min > 0.0 ? Point(a + t_min * (b - a)) : a;  // b - a may overflow
      std::optional<double> touched;
      const Point from_lattice = frame_.lattice(begin);
      const Point to_lattice = frame_.lattice(b);
      if (!from_lattice.allFinite() || !to_lattice.allFinite()) {
        check::fail("path", b.transpose(), "points at a finite number of cells from the grid");
      }
      const ClippedSegment<3> part = clip_segment<3>(from_lattice, to_lattice, low, high);
      if (!part.empty) {
        walk_segment<3>(part.a, part.b, [&](const Cell& number, double t_in, double) {
          const Cell cell = number - frame_.first();
          if (!frame_.contains(cell) || !blocked(cell) || cell == ignored) return true;
          touched = arc + size * (t_min + part.whole(t_in) * (1.0 - t_min));
          return false;
        });
        if (touched) return touched;
      }
    }
    arc += size;
  }
  return std::nullopt;
}

}  // namespace ltp
