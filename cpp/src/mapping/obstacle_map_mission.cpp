// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// What ties the obstacle map's window to the mission: what leaves it, what enters it again, and
// what reaches in from beyond.
#include <algorithm>
#include <limits>

#include "ltp/grid/lattice.hpp"
#include "ltp/mapping/obstacle_map.hpp"

namespace ltp {
namespace {

/// Log-odds that carving has brought back to 0, which OctoMap would take for occupied.
constexpr float kNothing = -std::numeric_limits<float>::min();

Cell scaled(const Cell& cells, const std::array<int, 3>& ratio) {
  return Cell(cells.x() * ratio[0], cells.y() * ratio[1], cells.z() * ratio[2]);
}

int rounded_down(int number, int by) {
  return number >= 0 ? number / by : -((-number - 1) / by) - 1;
}

Cell rounded_down(const Cell& voxel, const std::array<int, 3>& ratio) {
  return Cell(rounded_down(voxel.x(), ratio[0]), rounded_down(voxel.y(), ratio[1]),
              rounded_down(voxel.z(), ratio[2]));
}

template <typename Visitor>
void for_each_cell(const Cell& low, const Cell& high, Visitor&& visit) {
  for (int x = low.x(); x < high.x(); ++x) {
    for (int y = low.y(); y < high.y(); ++y) {
      for (int z = low.z(); z < high.z(); ++z) visit(Cell(x, y, z));
    }
  }
}

}  // namespace

CellBox ObstacleMap::voxels_of(const CellBox& cells) const {
  const Cell first = voxels_.frame().first();
  return {first + scaled(cells.low, ratio_), first + scaled(cells.high, ratio_)};
}

double ObstacleMap::remembered_at(const Point& point) const {
  const Cell voxel = voxels_.frame().cell_of(point);
  if ((voxel.array() == std::numeric_limits<int>::min()).any()) return 0.0;  // absurdly far
  const std::optional<float> log_odds = mission_->find(voxel + voxels_.frame().first());
  if (!log_odds || *log_odds == kNothing) return 0.0;
  return carver_ ? *log_odds : one_hit();
}

void ObstacleMap::remember_beyond(const Point& hit) {
  const Cell voxel = voxels_.frame().cell_of(hit);
  if ((voxel.array() == std::numeric_limits<int>::min()).any()) return;  // absurdly far
  const Cell number = voxel + voxels_.frame().first();
  if (mission_->find(number)) return;
  mission_->set(number, static_cast<float>(one_hit()));
  changed_ |= inflation_.add(source_of(voxel), blocked_);
}

Cell ObstacleMap::source_of(const Cell& voxel) const {
  return options_.inflate_whole_cells ? rounded_down(voxel, ratio_) : voxel;
}

void ObstacleMap::note(const CellBox& cells, MissionMap& mission) const {
  const Cell first = voxels_.frame().first();
  for_each_cell(scaled(cells.low, ratio_), scaled(cells.high, ratio_), [&](const Cell& voxel) {
    if (!carver_) {
      if (voxels_.blocked(voxel)) mission.set(voxel + first, static_cast<float>(one_hit()));
    } else if (const float log_odds = carver_->log_odds(voxel); log_odds != 0.0f) {
      mission.set(voxel + first, log_odds);
    } else if (mission.find(voxel + first)) {
      mission.set(voxel + first, kNothing);
    }
  });
}

void ObstacleMap::restore(const CellBox& cells, const MissionMap& mission) {
  const CellBox voxels = voxels_of(cells);
  const Cell first = voxels_.frame().first();
  const bool occupied_only = !carver_;
  mission.for_each(voxels.low, voxels.high, occupied_only,
                   [&](const Cell& low, const Cell& high, float log_odds) {
                     for_each_cell(low - first, high - first, [&](const Cell& voxel) {
                       if (carver_)
                         carver_->set_log_odds(voxel, log_odds == kNothing ? 0.0 : log_odds);
                       if (log_odds < 0.0f) return;
                       voxels_.set(voxel);
                       occupied_.set(cell_of_voxel(voxel));
                     });
                   });
}

std::optional<OccupancyGrid> ObstacleMap::blocked_everywhere(int most) const {
  if (!mission_) return std::nullopt;
  const Cell farthest = Cell::Constant(static_cast<int>(kFarthestCell));
  Cell low = farthest;
  Cell high = -farthest;
  mission_->for_each(-farthest, farthest, true, [&](const Cell& from, const Cell& to, float) {
    low = low.cwiseMin(from);
    high = high.cwiseMax(to);
  });
  if ((low.array() >= high.array()).any()) return std::nullopt;
  const Cell begin = rounded_down(low, ratio_) - inflation_.reach();
  const Cell end = rounded_down(high - Cell::Ones(), ratio_) + Cell::Ones() + inflation_.reach();
  if (((end - begin).array() > most).any()) return std::nullopt;
  const std::array<int, 3> parts = options_.inflated_parts();
  const GridFrame& lattice = inflated().frame();
  OccupancyGrid sources(
      on_lattice_of(lattice, scaled(begin, parts), scaled(Cell(end - begin), parts)));
  const Cell first = voxels_.frame().first();
  mission_->for_each(low, high, true, [&](const Cell& from, const Cell& to, float) {
    for_each_cell(from, to, [&](const Cell& voxel) {
      sources.set(source_of(voxel - first) + lattice.first() - sources.frame().first());
    });
  });
  return inflate(sources, inflation_.radius(), parts);
}

void ObstacleMap::repair(const CellBox& cells) {
  const CellBox window = all_of(occupied_.frame());
  const CellBox inside{cells.low.cwiseMax(window.low), cells.high.cwiseMin(window.high)};
  if (inside.empty()) return;
  inflation_.repair(inflated(), inside.low, inside.high, blocked_);
  if (!mission_) return;
  const Cell first = voxels_.frame().first();
  const auto reaches_in = [&](const Cell& low, const Cell& high, float) {
    for_each_cell(low - first, high - first, [&](const Cell& voxel) {
      inflation_.add(source_of(voxel), inside.low, inside.high, blocked_);
    });
  };
  // What is within reach but beyond the window, face by face.
  CellBox rest{inside.low - inflation_.reach(), inside.high + inflation_.reach()};
  for (int axis = 0; axis < 3; ++axis) {
    CellBox below = rest;
    CellBox above = rest;
    below.high[axis] = std::min(rest.high[axis], window.low[axis]);
    above.low[axis] = std::max(rest.low[axis], window.high[axis]);
    for (const CellBox& beyond : {below, above}) {
      if (beyond.empty()) continue;
      const CellBox voxels = voxels_of(beyond);
      mission_->for_each(voxels.low, voxels.high, true, reaches_in);
    }
    rest.low[axis] = std::max(rest.low[axis], window.low[axis]);
    rest.high[axis] = std::min(rest.high[axis], window.high[axis]);
  }
}

void ObstacleMap::roll(const Cell& shift) {
  if (mission_ && carver_) {
    for (int axis = 0; axis < 3; ++axis) note(entered(occupied_.frame(), -shift, axis), *mission_);
  }
  const Cell voxel_shift = scaled(shift, ratio_);
  voxels_.roll(voxel_shift);  // first: it is the one that can throw
  occupied_.roll(shift);
  if (carver_) carver_->roll(voxel_shift);
  if (!mission_) return inflation_.roll(inflated(), shift, blocked_);
  // What stays keeps what blocks it, wherever that is now.
  blocked_.roll(shift);
  for (int axis = 0; axis < 3; ++axis) restore(entered(occupied_.frame(), shift, axis), *mission_);
  for (int axis = 0; axis < 3; ++axis) repair(entered(occupied_.frame(), shift, axis));
}

}  // namespace ltp
