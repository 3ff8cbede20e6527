// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/navigation/obstacle_memory.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ltp/geometry/check.hpp"
#include "ltp/grid/bits.hpp"
#include "ltp/grid/lattice.hpp"
#include "ltp/planning/grid_planner.hpp"
#include "planning/search/flood.hpp"

namespace ltp {
namespace {

/// Free cells round all that is known: a flood that comes there has come out, and a way leads all
/// round.
constexpr int kRing = 2;
constexpr int kMostLevels = 128;
constexpr int kLevelStep = 8;  ///< by how many levels it grows at least

/// 64 levels of a column from one on; those beyond its ends are free.
std::uint64_t levels_from(const std::uint64_t* column, int words, int level) {
  const int w = level >> 6;
  const int shift = level & 63;
  const auto word = [&](int i) { return i >= 0 && i < words ? column[i] : std::uint64_t{0}; };
  return shift == 0 ? word(w) : word(w) >> shift | word(w + 1) << (64 - shift);
}

bool is_free(const std::uint64_t* column, int words) {
  return std::all_of(column, column + words, [](std::uint64_t word) { return word == 0; });
}

/// Blocks what another grid on the same lattice has blocked, as far as it is inside.
void copy(const OccupancyGrid& from, OccupancyGrid& to) {
  const Cell offset = to.frame().first() - from.frame().first();
  const Cell low = (-offset).cwiseMax(0);
  const Cell high = (dims_of(from.frame()) - offset).cwiseMin(dims_of(to.frame()));
  const int words = to.words_per_column();
  for (int ix = low.x(); ix < high.x(); ++ix) {
    for (int iy = low.y(); iy < high.y(); ++iy) {
      const std::uint64_t* source = from.column(ix + offset.x(), iy + offset.y());
      if (is_free(source, from.words_per_column())) continue;  // as most are
      std::uint64_t* target = to.column(ix, iy);
      for (int w = 0; w < words; ++w) {
        target[w] |= levels_from(source, from.words_per_column(), 64 * w + offset.z()) &
                     bits_between(w, 0, to.frame().nz() - 1);
      }
    }
  }
}

/// How long it may be along an axis: a grid has fewer than 2^31 cells.
int most_cells(int axis, int levels) {
  if (axis == 2) return kMostLevels;
  const double square = std::numeric_limits<std::int32_t>::max() / levels;
  return std::min(ObstacleMemory::kMostCells, static_cast<int>(std::sqrt(square)));
}

GridFrame ringed(const GridFrame& window) {
  const Cell ring = Cell::Constant(kRing);
  return on_lattice_of(window, window.first() - ring, dims_of(window) + 2 * ring);
}

Cell reach_of(const GridFrame& window, double inflation_radius) {
  check::not_negative("inflation_radius", inflation_radius);
  Cell reach;
  for (int axis = 0; axis < 3; ++axis) {
    const double cells = std::ceil(inflation_radius / window.cell()[axis]) + 1.0;
    reach[axis] = static_cast<int>(std::min<double>(cells, window.dims()[axis]));
  }
  return inflation_radius > 0.0 ? reach : Cell::Zero();
}

}  // namespace

ObstacleMemory::ObstacleMemory(const GridFrame& window, double inflation_radius)
    : blocked_(ringed(window)),
      seen_(window),
      reach_(reach_of(window, inflation_radius)),
      flood_(std::make_unique<planning::Flood>()) {}

ObstacleMemory::ObstacleMemory(ObstacleMemory&&) noexcept = default;
ObstacleMemory::~ObstacleMemory() = default;

void ObstacleMemory::remember(const OccupancyGrid& blocked) {
  const GridFrame& window = blocked.frame();
  hold(window.first(), window.first() + dims_of(window));
  seen_.roll(window.first() - seen_.frame().first());
  const Cell begin = window.first() - blocked_.frame().first();
  const int words = blocked.words_per_column();
  for (int ix = 0; ix < window.nx(); ++ix) {
    for (int iy = 0; iy < window.ny(); ++iy) {
      // Nearer to a face, a cell may be free because the window has left what blocks it.
      const bool inner = ix >= reach_.x() && ix < window.nx() - reach_.x() && iy >= reach_.y() &&
                         iy < window.ny() - reach_.y();
      const std::uint64_t* now = blocked.column(ix, iy);
      std::uint64_t* before = seen_.column(ix, iy);
      if (is_free(now, words) && is_free(before, words)) continue;
      const std::uint64_t* known = blocked_.column(begin.x() + ix, begin.y() + iy);
      for (int w = 0; w < words; ++w) {
        const std::uint64_t sure =
            inner ? bits_between(w, reach_.z(), window.nz() - 1 - reach_.z()) : 0;
        const std::uint64_t had =
            levels_from(known, blocked_.words_per_column(), 64 * w + begin.z());
        const std::uint64_t added = now[w] & ~had;
        const std::uint64_t freed = before[w] & ~now[w] & sure & had;
        before[w] = now[w] & sure;
        const Cell lowest = begin + Cell(ix, iy, 64 * w);
        for_each_bit(added, [&](int i) { blocked_.set(lowest + Cell(0, 0, i)); });
        for_each_bit(freed, [&](int i) { blocked_.set(lowest + Cell(0, 0, i), false); });
        version_ += (added | freed) != 0;
      }
    }
  }
}

void ObstacleMemory::add(const OccupancyGrid& blocked) {
  const GridFrame& frame = blocked.frame();
  if (!hold(frame.first(), frame.first() + dims_of(frame))) return;
  copy(blocked, blocked_);
  ++version_;
}

bool ObstacleMemory::make_room(const Point& low, const Point& high) {
  const GridFrame& frame = blocked_.frame();
  const auto on_lattice = [&](const Point& point) -> Cell {
    return frame.cell_of(point).cwiseMax(-kMostCells).cwiseMin(2 * kMostCells) + frame.first();
  };
  return hold(on_lattice(low), on_lattice(high) + Cell::Ones());
}

/// Grows to hold the cells [low, high) of the lattice, and the ring round them. Always does so for
/// a window.
bool ObstacleMemory::hold(const Cell& low, const Cell& high) {
  const GridFrame& frame = blocked_.frame();
  const Cell first = frame.first();
  const Cell last = first + dims_of(frame);
  Cell new_first = first;
  Cell new_last = last;
  bool forgets = false;
  for (const int axis : {2, 0, 1}) {
    const int window = seen_.frame().dims()[axis];
    const int most = std::max(most_cells(axis, new_last.z() - new_first.z()), window + 2 * kRing);
    const int from = low[axis] - kRing;
    const int to = high[axis] + kRing;
    if (to - from > most) return false;
    const int step = axis == 2 ? kLevelStep : std::max(window, frame.dims()[axis]) / 4;
    const bool down = from < first[axis];
    if (down) new_first[axis] = std::max(from - step, to - most);
    if (to > last[axis]) new_last[axis] = std::min(to + step, from + most);
    if (new_last[axis] - new_first[axis] <= most) continue;
    forgets = true;
    if (down) {
      new_last[axis] = new_first[axis] + most;
    } else {
      new_first[axis] = new_last[axis] - most;
    }
  }
  if (new_first == first && new_last == last) return true;
  has_forgotten_ |= forgets;
  OccupancyGrid grown(on_lattice_of(frame, new_first, new_last - new_first));
  copy(blocked_, grown);
  blocked_ = std::move(grown);
  return true;
}

void ObstacleMemory::add_to(OccupancyGrid& blocked) const { copy(blocked_, blocked); }

void ObstacleMemory::clear() {
  blocked_.clear();
  seen_.clear();
  ++version_;
}

bool ObstacleMemory::seals(const Query& query) { return is_closed(query, query.goal, query.start); }

bool ObstacleMemory::encloses(const Query& query) {
  return is_closed(query, query.start, query.goal);
}

bool ObstacleMemory::is_closed(const Query& query, const Point& from, const Point& to) {
  const GridFrame& frame = blocked_.frame();
  const Cell begin = frame.cell_of(from);
  if (!frame.contains(begin) || blocked_.blocked(begin)) return false;
  const Cell end = frame.cell_of(to);
  flood_->fill(blocked_, begin, levels_of(frame, query), end);
  return !flood_->touched_edge() && !flood_->reached(end);
}

}  // namespace ltp
