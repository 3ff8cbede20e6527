// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/navigation/obstacle_memory.hpp"

#include <algorithm>

#include "ltp/geometry/check.hpp"
#include "ltp/planning/grid_planner.hpp"
#include "planning/search/flood.hpp"

namespace ltp {
namespace {

GridFrame widened(const GridFrame& window, int widths) {
  if (widths < 1) check::fail("memory_widths", widths, "a number >= 1");
  const Cell margin(window.nx() * (widths - 1) / 2, window.ny() * (widths - 1) / 2, 0);
  const Point origin = window.origin() - margin.cast<double>().cwiseProduct(window.cell());
  return GridFrame(origin, window.cell(),
                   {window.nx() * widths, window.ny() * widths, window.nz()});
}

/// By how much a stretch of `outer` cells must move to hold one of `inner` cells that begins at
/// `begin`.
int shift_to_hold(int begin, int inner, int outer) {
  return std::min(begin, 0) + std::max(begin + inner - outer, 0);
}

}  // namespace

ObstacleMemory::ObstacleMemory(const GridFrame& window, int widths, double inflation_radius)
    : occupied_(widened(window, widths)),
      blocked_(occupied_),
      inflation_(occupied_.frame(), inflation_radius),
      flood_(std::make_unique<planning::Flood>()) {}

ObstacleMemory::ObstacleMemory(ObstacleMemory&&) noexcept = default;
ObstacleMemory::~ObstacleMemory() = default;

void ObstacleMemory::remember(const OccupancyGrid& occupied) {
  const GridFrame& window = occupied.frame();
  Cell begin = occupied_.frame().cell_of(window.centre(Cell::Zero()));
  const Cell shift(shift_to_hold(begin.x(), window.nx(), occupied_.frame().nx()),
                   shift_to_hold(begin.y(), window.ny(), occupied_.frame().ny()), begin.z());
  if (shift != Cell::Zero()) {
    occupied_.roll(shift);
    inflated_ = false;  // beyond the edge nothing was
    begin -= shift;
  }
  const int words = occupied.words_per_column();
  for (int ix = 0; ix < window.nx(); ++ix) {
    // The columns of one x lie contiguously in both.
    const std::uint64_t* from = occupied.column(ix, 0);
    std::uint64_t* to = occupied_.column(begin.x() + ix, begin.y());
    for (int i = 0; i < window.ny() * words; ++i) {
      const std::uint64_t added = from[i] & ~to[i];
      if (added == 0) continue;
      to[i] |= added;
      if (inflated_) inflate(begin.x() + ix, begin.y() + i / words, i % words, added);
    }
  }
}

void ObstacleMemory::clear() {
  occupied_.clear();
  inflated_ = false;
}

/// Blocks the surroundings of the cells that are bits of one word of a column.
void ObstacleMemory::inflate(int ix, int iy, int word, std::uint64_t bits) {
  for (; bits != 0; bits &= bits - 1) {
    inflation_.add(Cell(ix, iy, 64 * word + __builtin_ctzll(bits)), blocked_);
  }
}

bool ObstacleMemory::seals(const Query& query) {
  if (!inflated_) {
    blocked_.roll(blocked_.frame().cell_of(occupied_.frame().centre(Cell::Zero())));  // same frame
    inflation_.apply(occupied_, blocked_);
    inflated_ = true;
  }
  const GridFrame& frame = blocked_.frame();
  const Cell goal = frame.cell_of(query.goal);
  if (!frame.contains(goal) || blocked_.blocked(goal)) return false;
  const Cell start = frame.cell_of(query.start);
  flood_->fill(blocked_, goal, levels_of(frame, query), start);
  return !flood_->touched_edge() && !flood_->reached(start);
}

}  // namespace ltp
