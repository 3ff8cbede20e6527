// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/flood.hpp"

#include <algorithm>

#include "ltp/geometry/check.hpp"

namespace ltp {
namespace {

/// Spreads the set bits of a column up and down through its free bits. Returns whether anything was
/// added.
bool spread(std::uint64_t* reached, const std::uint64_t* blocked, const std::uint64_t* open,
            int words) {
  bool any = false;
  bool changed = true;
  while (changed) {
    changed = false;
    for (int w = 0; w < words; ++w) {
      const std::uint64_t free = ~blocked[w] & open[w];
      std::uint64_t bits = reached[w];
      if (w > 0) bits |= reached[w - 1] >> 63 & free;
      if (w + 1 < words) bits |= reached[w + 1] << 63 & free;
      for (std::uint64_t before = ~bits; before != bits;) {
        before = bits;
        bits |= (bits << 1 | bits >> 1) & free;
      }
      changed |= bits != reached[w];
      reached[w] = bits;
    }
    any |= changed;
  }
  return any;
}

}  // namespace

void Flood::fill(const OccupancyGrid& grid, const Cell& from, const LevelRange& levels,
                 const std::optional<Cell>& until) {
  const GridFrame& frame = grid.frame();
  if (!frame.contains(from) || from.z() < levels.lowest || from.z() > levels.highest) {
    check::fail("from", from.transpose(), "a cell inside the window and its levels");
  }
  nx_ = frame.nx();
  ny_ = frame.ny();
  words_ = grid.words_per_column();
  reached_.assign(grid.words().size(), 0);
  queued_.assign(static_cast<std::size_t>(nx_) * ny_, 0);
  queue_.clear();
  open_levels_.assign(words_, 0);
  const int highest = std::min(levels.highest, frame.nz() - 1);
  for (int level = std::max(levels.lowest, 0); level <= highest; ++level) {
    open_levels_[level >> 6] |= std::uint64_t{1} << (level & 63);
  }
  touched_edge_ = false;

  const auto wake = [&](std::uint32_t column) {
    if (queued_[column]) return;
    queued_[column] = 1;
    queue_.push_back(column);
  };
  const auto first = static_cast<std::uint32_t>(from.x() * ny_ + from.y());
  reached_[std::size_t{first} * words_ + (from.z() >> 6)] |= std::uint64_t{1} << (from.z() & 63);
  wake(first);

  // First in, first out; a column may come back with more levels. The queue grows at its end only.
  for (std::size_t head = 0; head < queue_.size(); ++head) {
    const std::uint32_t column = queue_[head];
    queued_[column] = 0;
    const int ix = static_cast<int>(column) / ny_;
    const int iy = static_cast<int>(column) % ny_;
    std::uint64_t* here = reached_.data() + std::size_t{column} * words_;
    spread(here, grid.column(ix, iy), open_levels_.data(), words_);
    if (ix == 0 || iy == 0 || ix == nx_ - 1 || iy == ny_ - 1) touched_edge_ = true;
    if (until && (touched_edge_ || reached(*until))) return;

    const int neighbours[4][2] = {{ix - 1, iy}, {ix + 1, iy}, {ix, iy - 1}, {ix, iy + 1}};
    for (const auto& [jx, jy] : neighbours) {
      if (jx < 0 || jy < 0 || jx >= nx_ || jy >= ny_) continue;
      const auto other = static_cast<std::uint32_t>(jx * ny_ + jy);
      std::uint64_t* there = reached_.data() + std::size_t{other} * words_;
      const std::uint64_t* blocked = grid.column(jx, jy);
      bool news = false;
      for (int w = 0; w < words_; ++w) {
        const std::uint64_t added = here[w] & ~blocked[w] & open_levels_[w] & ~there[w];
        there[w] |= added;
        news |= added != 0;
      }
      if (news) wake(other);
    }
    if (head > (std::size_t{1} << 20)) {  // keep the memory bounded
      queue_.erase(queue_.begin(), queue_.begin() + static_cast<std::ptrdiff_t>(head) + 1);
      head = static_cast<std::size_t>(-1);
    }
  }
  // Levels at the window's floor or ceiling are an edge too.
  for (std::size_t i = 0; i < reached_.size() && !touched_edge_; i += words_) {
    touched_edge_ =
        (reached_[i] & 1u) != 0 || (reached_[i + words_ - 1] >> ((frame.nz() - 1) & 63) & 1u) != 0;
  }
}

bool Flood::reached(const Cell& cell) const {
  if (cell.x() < 0 || cell.y() < 0 || cell.z() < 0 || cell.x() >= nx_ || cell.y() >= ny_ ||
      cell.z() >= words_ * 64) {
    return false;
  }
  const std::size_t column = static_cast<std::size_t>(cell.x()) * ny_ + cell.y();
  return reached_[column * words_ + (cell.z() >> 6)] >> (cell.z() & 63) & 1u;
}

std::int64_t Flood::count() const {
  std::int64_t sum = 0;
  for (const std::uint64_t word : reached_) sum += __builtin_popcountll(word);
  return sum;
}

}  // namespace ltp
