// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/mapping/inflation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "ltp/geometry/check.hpp"

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

/// The bits of word `w` that are levels in [low, high] of a column.
std::uint64_t bits_between(int w, int low, int high) {
  const int from = std::max(low - 64 * w, 0);
  const int to = std::min(high - 64 * w, 63);
  if (from > to) return 0;
  return (~std::uint64_t{0} >> (63 - (to - from))) << from;
}

/// Every level's two neighbours join it; `nz` levels.
void dilate_by_one(std::vector<std::uint64_t>& column, int nz) {
  const int words = static_cast<int>(column.size());
  std::uint64_t below = 0;
  for (int w = 0; w < words; ++w) {
    const std::uint64_t here = column[w];
    const std::uint64_t above = w + 1 < words ? column[w + 1] : 0;
    column[w] |= here << 1 | below >> 63 | here >> 1 | above << 63;
    below = here;
  }
  column[words - 1] &= bits_between(words - 1, 0, nz - 1);
}

}  // namespace

Inflation::Inflation(const GridFrame& frame, double radius)
    : radius_(radius), dilated_((frame.nz() + 63) / 64) {
  check::not_negative("radius", radius);
  if (radius == 0.0) {
    columns_ = {{0, 0, 0}};
    return;
  }
  const double within = radius * (1.0 + 1e-9);  // a gap of exactly the radius is within it
  const Point& edge = frame.cell();
  const int nx = cells_within(within, edge.x(), frame.nx() - 1);
  const int ny = cells_within(within, edge.y(), frame.ny() - 1);
  for (int dx = -nx; dx <= nx; ++dx) {
    for (int dy = -ny; dy <= ny; ++dy) {
      const double across = std::hypot(gap(dx, edge.x()), gap(dy, edge.y()));
      if (across > within) continue;
      const double reach = within * std::sqrt(1.0 - std::pow(across / within, 2));
      columns_.push_back({dx, dy, cells_within(reach, edge.z(), frame.nz() - 1)});
    }
  }
  std::sort(columns_.begin(), columns_.end(),
            [](const Column& a, const Column& b) { return a.reach < b.reach; });
}

void Inflation::add(const Cell& occupied, OccupancyGrid& blocked) const {
  const GridFrame& frame = blocked.frame();
  const int words = blocked.words_per_column();
  for (const Column& column : columns_) {
    const int ix = occupied.x() + column.dx;
    const int iy = occupied.y() + column.dy;
    if (static_cast<unsigned>(ix) >= static_cast<unsigned>(frame.nx()) ||
        static_cast<unsigned>(iy) >= static_cast<unsigned>(frame.ny())) {
      continue;
    }
    const int low = std::max(occupied.z() - column.reach, 0);
    const int high = std::min(occupied.z() + column.reach, frame.nz() - 1);
    std::uint64_t* bits = blocked.column(ix, iy);
    for (int w = words == 1 ? 0 : low / 64; w < words && 64 * w <= high; ++w) {
      bits[w] |= bits_between(w, low, high);
    }
  }
}

void Inflation::apply(const OccupancyGrid& occupied, OccupancyGrid& blocked) {
  assert(occupied.frame() == blocked.frame() && &occupied != &blocked);
  const GridFrame& frame = occupied.frame();
  const int words = occupied.words_per_column();
  blocked.clear();
  for (int ix = 0; ix < frame.nx(); ++ix) {
    for (int iy = 0; iy < frame.ny(); ++iy) {
      const std::uint64_t* source = occupied.column(ix, iy);
      if (std::all_of(source, source + words, [](std::uint64_t word) { return word == 0; })) {
        continue;
      }
      std::copy(source, source + words, dilated_.begin());
      int reach = 0;
      for (const Column& column : columns_) {
        for (; reach < column.reach; ++reach) dilate_by_one(dilated_, frame.nz());
        const int jx = ix + column.dx;
        const int jy = iy + column.dy;
        if (static_cast<unsigned>(jx) >= static_cast<unsigned>(frame.nx()) ||
            static_cast<unsigned>(jy) >= static_cast<unsigned>(frame.ny())) {
          continue;
        }
        std::uint64_t* target = blocked.column(jx, jy);
        for (int w = 0; w < words; ++w) target[w] |= dilated_[w];
      }
    }
  }
}

OccupancyGrid inflate(const OccupancyGrid& occupied, double radius) {
  OccupancyGrid blocked(occupied.frame());
  Inflation(occupied.frame(), radius).apply(occupied, blocked);
  return blocked;
}

}  // namespace ltp
