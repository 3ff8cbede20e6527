// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/mapping/inflation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <utility>

#include "ltp/geometry/check.hpp"
#include "ltp/grid/bits.hpp"

namespace ltp {
namespace {

/// Distance along one axis between two boxes of a lattice that lie `offset` cells apart [m].
double gap(int offset, double edge) { return std::max(0, std::abs(offset) - 1) * edge; }

/// How many cells further a box can lie without a gap of more than `reach` [m], at most `most`.
int cells_within(double reach, double edge, int most) {
  const double cells = std::floor(reach / edge) + 2.0;  // one too many: `gap` decides
  int count = cells < most ? static_cast<int>(cells) : most;
  while (count > 0 && gap(count, edge) > reach) --count;
  return count;
}

/// Every level's two neighbours join it.
void dilate_by_one(std::vector<std::uint64_t>& column) {
  std::uint64_t below = 0;
  for (std::size_t w = 0; w < column.size(); ++w) {
    const std::uint64_t here = column[w];
    const std::uint64_t above = w + 1 < column.size() ? column[w + 1] : 0;
    column[w] |= here << 1 | below >> 63 | here >> 1 | above << 63;
    below = here;
  }
}

}  // namespace

Inflation::Inflation(const GridFrame& frame, double radius)
    : radius_(radius), dilated_((frame.nz() + 63) / 64), inside_(dilated_.size()) {
  check::not_negative("radius", radius);
  const int words = static_cast<int>(dilated_.size());
  std::map<int, std::vector<Ring::Column>> by_reach;
  if (radius == 0.0) {
    by_reach[0] = {{0, 0, 0}};
  } else {
    const double within = radius * (1.0 + 1e-9);  // a gap of exactly the radius is within it
    const Point& edge = frame.cell();
    for (int axis = 0; axis < 3; ++axis) {
      reach_[axis] = cells_within(within, edge[axis], frame.dims()[axis] - 1);
    }
    for (int dx = -reach_.x(); dx <= reach_.x(); ++dx) {
      for (int dy = -reach_.y(); dy <= reach_.y(); ++dy) {
        const double across = std::hypot(gap(dx, edge.x()), gap(dy, edge.y()));
        if (across > within) continue;
        const double up = within * std::sqrt(1.0 - std::pow(across / within, 2));
        by_reach[cells_within(up, edge.z(), frame.nz() - 1)].push_back(
            {dx, dy, (dx * frame.ny() + dy) * words});
      }
    }
  }
  for (auto& [reach, columns] : by_reach) rings_.push_back({reach, std::move(columns)});
}

void Inflation::add(const Cell& occupied, OccupancyGrid& blocked) {
  const GridFrame& frame = blocked.frame();
  for (int w = 0; w < blocked.words_per_column(); ++w) {
    dilated_[w] = bits_between(w, occupied.z(), occupied.z());
    inside_[w] = bits_between(w, 0, frame.nz() - 1);
  }
  spread(occupied.x(), occupied.y(), Cell::Zero(), Cell(frame.nx(), frame.ny(), frame.nz()),
         blocked);
}

void Inflation::apply(const OccupancyGrid& occupied, OccupancyGrid& blocked) {
  const GridFrame& frame = occupied.frame();
  repair(occupied, Cell::Zero(), Cell(frame.nx(), frame.ny(), frame.nz()), blocked);
}

void Inflation::repair(const OccupancyGrid& occupied, const Cell& low, const Cell& high,
                       OccupancyGrid& blocked) {
  assert(occupied.frame() == blocked.frame() && &occupied != &blocked);
  const GridFrame& frame = occupied.frame();
  const Cell dims(frame.nx(), frame.ny(), frame.nz());
  const Cell from = low.cwiseMax(0);
  const Cell to = high.cwiseMin(dims);
  if ((from.array() >= to.array()).any()) return;
  const Cell source_from = (from - reach_).cwiseMax(0);
  const Cell source_to = (to + reach_).cwiseMin(dims);
  const int words = occupied.words_per_column();
  for (int w = 0; w < words; ++w) inside_[w] = bits_between(w, from.z(), to.z() - 1);

  for (int ix = from.x(); ix < to.x(); ++ix) {
    std::uint64_t* target = blocked.column(ix, from.y());
    std::uint64_t* const end = target + std::int64_t{to.y() - from.y()} * words;
    if (words == 1) {  // which the compiler makes a loop over vectors
      for (const std::uint64_t mask = inside_[0]; target < end; ++target) *target &= ~mask;
    }
    for (; target < end; target += words) {
      for (int w = 0; w < words; ++w) target[w] &= ~inside_[w];
    }
  }
  for (int ix = source_from.x(); ix < source_to.x(); ++ix) {
    const std::uint64_t* row = occupied.column(ix, 0);
    const std::int64_t end = std::int64_t{source_to.y()} * words;
    std::int64_t next = next_in_use(row, std::int64_t{source_from.y()} * words, end);
    while (next < end) {
      const std::int64_t iy = next / words;
      std::uint64_t any = 0;
      for (int w = 0; w < words; ++w) {
        dilated_[w] = row[iy * words + w] & bits_between(w, source_from.z(), source_to.z() - 1);
        any |= dilated_[w];
      }
      if (any != 0) spread(ix, static_cast<int>(iy), from, to, blocked);
      next = next_in_use(row, (iy + 1) * words, end);
    }
  }
}

void Inflation::spread(int ix, int iy, const Cell& low, const Cell& high, OccupancyGrid& blocked) {
  const bool whole = ix - reach_.x() >= low.x() && ix + reach_.x() < high.x() &&
                     iy - reach_.y() >= low.y() && iy + reach_.y() < high.y();
  const int words = blocked.words_per_column();
  int reach = 0;
  if (whole && words == 1) {  // nearly always
    std::uint64_t* centre = blocked.column(ix, iy);
    std::uint64_t levels = dilated_[0];
    for (const Ring& ring : rings_) {
      for (; reach < ring.reach; ++reach) levels |= levels << 1 | levels >> 1;
      const std::uint64_t bits = levels & inside_[0];
      for (const Ring::Column& column : ring.columns) centre[column.words] |= bits;
    }
    return;
  }
  for (const Ring& ring : rings_) {
    for (; reach < ring.reach; ++reach) dilate_by_one(dilated_);
    for (const Ring::Column& column : ring.columns) {
      const int jx = ix + column.dx;
      const int jy = iy + column.dy;
      if (jx < low.x() || jx >= high.x() || jy < low.y() || jy >= high.y()) continue;
      std::uint64_t* target = blocked.column(jx, jy);
      for (int w = 0; w < words; ++w) target[w] |= dilated_[w] & inside_[w];
    }
  }
}

void Inflation::roll(const OccupancyGrid& occupied, const Cell& shift, OccupancyGrid& blocked) {
  blocked.roll(shift);
  const GridFrame& frame = occupied.frame();
  const Cell dims(frame.nx(), frame.ny(), frame.nz());
  for (int axis = 0; axis < 3; ++axis) {
    if (shift[axis] == 0) continue;
    // Cells that entered on one side take in what is occupied within reach; cells near the other
    // side may owe their being blocked to cells that left.
    Cell entered_low = Cell::Zero(), entered_high = dims, left_low = Cell::Zero(), left_high = dims;
    if (shift[axis] > 0) {
      entered_low[axis] = std::max(dims[axis] - shift[axis], 0);
      left_high[axis] = reach_[axis];
    } else {
      entered_high[axis] = std::min(-std::max(shift[axis], -dims[axis]), dims[axis]);
      left_low[axis] = dims[axis] - reach_[axis];
    }
    repair(occupied, entered_low, entered_high, blocked);
    repair(occupied, left_low, left_high, blocked);
  }
}

OccupancyGrid inflate(const OccupancyGrid& occupied, double radius) {
  OccupancyGrid blocked(occupied.frame());
  Inflation(occupied.frame(), radius).apply(occupied, blocked);
  return blocked;
}

}  // namespace ltp
