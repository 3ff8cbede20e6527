// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/search/flood.hpp"

#include <algorithm>

#include "ltp/geometry/check.hpp"
#include "ltp/grid/bits.hpp"

namespace ltp::planning {
namespace {

/// Spreads the set bits of a column up and down through its free bits.
void spread(std::uint64_t* reached, const std::uint64_t* blocked, const std::uint64_t* open,
            int words) {
  for (bool changed = true; changed;) {
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
  }
}

}  // namespace

/// Forgets the last fill, column by column if it was a small one.
void Flood::begin(const OccupancyGrid& grid) {
  const GridFrame& frame = grid.frame();
  if (nx_ == frame.nx() && ny_ == frame.ny() && words_ == grid.words_per_column()) {
    if (touched_.size() > states_.size() / 8) {
      std::fill(reached_.begin(), reached_.end(), 0);
      std::fill(states_.begin(), states_.end(), State::Untouched);
    } else {
      for (const std::uint32_t column : touched_) {
        for (int w = 0; w < words_; ++w) reached_[std::size_t{column} * words_ + w] = 0;
        states_[column] = State::Untouched;
      }
    }
  } else {
    reached_.reset(grid.words().size());
    states_.reset(static_cast<std::size_t>(frame.nx()) * frame.ny());
    nx_ = frame.nx();
    ny_ = frame.ny();
    words_ = grid.words_per_column();
  }
  touched_.clear();
  next_.clear();
  touched_edge_ = false;
}

void Flood::fill(const OccupancyGrid& grid, const Cell& from, const LevelRange& levels,
                 const std::optional<Cell>& until) {
  if (until) {
    spread_from(grid, from, levels, [&] { return touched_edge_ || reached(*until); });
  } else {
    spread_from(grid, from, levels, [] { return false; });
  }
}

bool Flood::parts(const OccupancyGrid& grid, const Cell& inside, const Cell& outside,
                  const LevelRange& levels, std::size_t most) {
  std::size_t visits = 0;
  return spread_from(grid, inside, levels, [&] { return reached(outside) || ++visits > most; });
}

template <typename Enough>
bool Flood::spread_from(const OccupancyGrid& grid, const Cell& from, const LevelRange& levels,
                        Enough&& enough) {
  const GridFrame& frame = grid.frame();
  if (!frame.contains(from) || !levels.contains(from)) {
    check::fail("from", from.transpose(), "a cell inside the window and its levels");
  }
  begin(grid);
  open_levels_.resize(words_);
  fill_between(open_levels_.data(), words_, levels.lowest,
               std::min(levels.highest, frame.nz() - 1));
  const auto first = static_cast<std::uint32_t>(from.x() * ny_ + from.y());
  reached_[std::size_t{first} * words_ + (from.z() >> 6)] = std::uint64_t{1} << (from.z() & 63);
  const auto wake = [&](std::uint32_t column) {
    State& state = states_[column];
    if (state == State::Waiting) return;
    if (state == State::Untouched) touched_.push_back(column);
    state = State::Waiting;
    next_.push_back(column);
  };
  wake(first);
  const int ceiling = (frame.nz() - 1) & 63;

  while (!next_.empty()) {
    front_.swap(next_);
    next_.clear();
    for (const std::uint32_t column : front_) {
      states_[column] = State::Touched;  // it may come back with more levels
      const int ix = static_cast<int>(column) / ny_;
      const int iy = static_cast<int>(column) % ny_;
      std::uint64_t* here = &reached_[std::size_t{column} * words_];
      spread(here, grid.column(ix, iy), open_levels_.data(), words_);
      // Levels at the window's floor or ceiling are an edge too.
      touched_edge_ |= ix == 0 || iy == 0 || ix == nx_ - 1 || iy == ny_ - 1 || (here[0] & 1u) ||
                       (here[words_ - 1] >> ceiling & 1u);
      if (enough()) return false;

      const int neighbours[4][2] = {{ix - 1, iy}, {ix + 1, iy}, {ix, iy - 1}, {ix, iy + 1}};
      for (const auto& [jx, jy] : neighbours) {
        if (jx < 0 || jy < 0 || jx >= nx_ || jy >= ny_) continue;
        const auto other = static_cast<std::uint32_t>(jx * ny_ + jy);
        std::uint64_t* there = &reached_[std::size_t{other} * words_];
        const std::uint64_t* blocked = grid.column(jx, jy);
        bool news = false;
        for (int w = 0; w < words_; ++w) {
          const std::uint64_t added = here[w] & ~blocked[w] & open_levels_[w] & ~there[w];
          there[w] |= added;
          news |= added != 0;
        }
        if (news) wake(other);
      }
    }
  }
  return true;
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
  for (const std::uint32_t column : touched_) {
    const std::uint64_t* words = &reached_[std::size_t{column} * words_];
    for (int w = 0; w < words_; ++w) sum += __builtin_popcountll(words[w]);
  }
  return sum;
}

}  // namespace ltp::planning
