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
#include "ltp/grid/cell_box.hpp"

namespace ltp {
namespace {

/// How many sources further a box can lie without a gap of more than `within` [m], at most `most`.
int sources_within(double within, double edge, int most) {
  const double sources = std::floor(within / edge) + 2.0;  // one too many: the gap decides
  int count = sources < most ? static_cast<int>(sources) : most;
  while (count > 0 && (count - 1) * edge > within) --count;
  return count;
}

/// Boxes of the sources' lattice between a source, `part` of its cell, and a cell `offset` further.
int boxes_between(int offset, int part, int parts) {
  return std::max({0, offset * parts - part - 1, part - (offset + 1) * parts});
}

int rounded_down(int source, int parts) {
  return source >= 0 ? source / parts : -((-source - 1) / parts) - 1;
}

}  // namespace

Inflation::Inflation(const GridFrame& frame, double radius, const std::array<int, 3>& parts)
    : radius_(radius),
      parts_(parts),
      words_((frame.nz() + 63) / 64),
      planes_(static_cast<std::size_t>(words_) * parts[2]),
      inside_(words_) {
  check::not_negative("radius", radius);
  const double within = radius * (1.0 + 1e-9);  // a gap of exactly the radius is within it
  for (int axis = 0; axis < 3 && radius > 0.0; ++axis) {
    source_reach_[axis] = sources_within(within, frame.cell()[axis] / parts[axis],
                                         2 * frame.dims()[axis] * parts[axis]);
    reach_[axis] = (source_reach_[axis] + parts[axis] - 1) / parts[axis];
  }
  for (int x = 0; x < parts[0]; ++x) {
    for (int y = 0; y < parts[1]; ++y) rings_.push_back(rings(x, y, frame, within));
  }
}

std::vector<Inflation::Ring> Inflation::rings(int part_x, int part_y, const GridFrame& frame,
                                              double within) const {
  if (within == 0.0) return {{0, {{0, 0, 0}}}};
  const Point edge(frame.cell().x() / parts_[0], frame.cell().y() / parts_[1],
                   frame.cell().z() / parts_[2]);
  std::map<int, std::vector<Ring::Column>> by_reach;
  for (int dx = -reach_.x(); dx <= reach_.x(); ++dx) {
    for (int dy = -reach_.y(); dy <= reach_.y(); ++dy) {
      const double across = std::hypot(boxes_between(dx, part_x, parts_[0]) * edge.x(),
                                       boxes_between(dy, part_y, parts_[1]) * edge.y());
      if (across > within) continue;
      const double up = within * std::sqrt(1.0 - std::pow(across / within, 2));
      by_reach[sources_within(up, edge.z(), source_reach_.z())].push_back(
          {dx, dy, (dx * frame.ny() + dy) * words_});
    }
  }
  std::vector<Ring> rings;
  for (auto& [reach, columns] : by_reach) rings.push_back({reach, std::move(columns)});
  return rings;
}

bool Inflation::add(const Cell& source, OccupancyGrid& blocked) {
  return add(source, Cell::Zero(), dims_of(blocked.frame()), blocked);
}

bool Inflation::add(const Cell& source, const Cell& low, const Cell& high, OccupancyGrid& blocked) {
  const int ix = rounded_down(source.x(), parts_[0]);
  const int iy = rounded_down(source.y(), parts_[1]);
  const bool whole = ix - reach_.x() >= low.x() && ix + reach_.x() < high.x() &&
                     iy - reach_.y() >= low.y() && iy + reach_.y() < high.y();
  std::uint64_t* const centre = whole ? blocked.column(ix, iy) : nullptr;
  std::uint64_t added = 0;
  for (const Ring& ring : rings_of(source.x() - ix * parts_[0], source.y() - iy * parts_[1])) {
    const int bottom = std::max(rounded_down(source.z() - ring.reach, parts_[2]), low.z());
    const int top = std::min(rounded_down(source.z() + ring.reach, parts_[2]), high.z() - 1);
    if (bottom > top) continue;
    if (whole && words_ == 1) {  // nearly always
      const std::uint64_t bits = bits_between(0, bottom, top);
      for (const Ring::Column& column : ring.columns) {
        added |= bits & ~centre[column.words];
        centre[column.words] |= bits;
      }
      continue;
    }
    for (const Ring::Column& column : ring.columns) {
      const int jx = ix + column.dx;
      const int jy = iy + column.dy;
      if (jx < low.x() || jx >= high.x() || jy < low.y() || jy >= high.y()) continue;
      std::uint64_t* target = blocked.column(jx, jy);
      for (int w = bottom >> 6; w <= top >> 6; ++w) {
        const std::uint64_t bits = bits_between(w, bottom, top);
        added |= bits & ~target[w];
        target[w] |= bits;
      }
    }
  }
  return added != 0;
}

void Inflation::apply(const OccupancyGrid& sources, OccupancyGrid& blocked) {
  repair(sources, Cell::Zero(), dims_of(blocked.frame()), blocked);
}

void Inflation::repair(const OccupancyGrid& sources, const Cell& low, const Cell& high,
                       OccupancyGrid& blocked) {
  const GridFrame& frame = blocked.frame();
  const Cell parts(parts_[0], parts_[1], parts_[2]);
  assert(dims_of(sources.frame()) == dims_of(frame).cwiseProduct(parts) && &sources != &blocked);
  const Cell from = low.cwiseMax(0);
  const Cell to = high.cwiseMin(dims_of(frame));
  if ((from.array() >= to.array()).any()) return;
  const Cell source_from = (from.cwiseProduct(parts) - source_reach_).cwiseMax(0);
  const Cell source_to =
      (to.cwiseProduct(parts) + source_reach_).cwiseMin(dims_of(sources.frame()));
  for (int w = 0; w < words_; ++w) inside_[w] = bits_between(w, from.z(), to.z() - 1);

  for (int ix = from.x(); ix < to.x(); ++ix) {
    std::uint64_t* target = blocked.column(ix, from.y());
    std::uint64_t* const end = target + std::int64_t{to.y() - from.y()} * words_;
    if (words_ == 1) {  // which the compiler makes a loop over vectors
      for (const std::uint64_t mask = inside_[0]; target < end; ++target) *target &= ~mask;
    }
    for (; target < end; target += words_) {
      for (int w = 0; w < words_; ++w) target[w] &= ~inside_[w];
    }
  }
  const int words = sources.words_per_column();
  for (int x = source_from.x(); x < source_to.x(); ++x) {
    const std::uint64_t* row = sources.column(x, 0);
    const std::int64_t end = std::int64_t{source_to.y()} * words;
    std::int64_t next = next_in_use(row, std::int64_t{source_from.y()} * words, end);
    while (next < end) {
      const std::int64_t y = next / words;
      if (take(row + y * words, source_from.z(), source_to.z())) {
        spread(x, static_cast<int>(y), from, to, blocked);
      }
      next = next_in_use(row, (y + 1) * words, end);
    }
  }
}

bool Inflation::take(const std::uint64_t* column, int low, int high) {
  std::uint64_t any = 0;
  if (parts_[2] == 1) {
    for (int w = 0; w < words_; ++w) {
      planes_[w] = column[w] & bits_between(w, low, high - 1);
      any |= planes_[w];
    }
    return any != 0;
  }
  std::fill(planes_.begin(), planes_.end(), 0);
  for (int w = low >> 6; w <= (high - 1) >> 6; ++w) {
    const std::uint64_t here = column[w] & bits_between(w, low, high - 1);
    any |= here;
    for_each_bit(here, [&](int bit) {
      const int source = 64 * w + bit;
      const int level = source / parts_[2];
      planes_[(level >> 6) * parts_[2] + source % parts_[2]] |= std::uint64_t{1} << (level & 63);
    });
  }
  return any != 0;
}

/// Every source's two neighbours along z join it.
void Inflation::dilate() {
  const int parts = parts_[2];
  std::uint64_t carried = 0;  // from the highest part of the word below
  for (int w = 0; w < words_; ++w) {
    std::uint64_t* here = planes_.data() + w * parts;
    const std::uint64_t highest = here[parts - 1];
    const std::uint64_t above = w + 1 < words_ ? here[parts] << 63 : 0;
    const std::uint64_t last = here[0] >> 1 | above;
    std::uint64_t below = highest << 1 | carried;
    for (int part = 0; part < parts; ++part) {
      const std::uint64_t own = here[part];
      here[part] |= below | (part + 1 < parts ? here[part + 1] : last);
      below = own;
    }
    carried = highest >> 63;
  }
}

void Inflation::spread(int source_x, int source_y, const Cell& low, const Cell& high,
                       OccupancyGrid& blocked) {
  const int parts = parts_[2];
  const int ix = source_x / parts_[0];
  const int iy = source_y / parts_[1];
  const std::vector<Ring>& rings = rings_of(source_x - ix * parts_[0], source_y - iy * parts_[1]);
  const bool whole = ix - reach_.x() >= low.x() && ix + reach_.x() < high.x() &&
                     iy - reach_.y() >= low.y() && iy + reach_.y() < high.y();
  int reach = 0;
  if (whole && words_ == 1 && parts == 1) {  // the most frequent cases apart
    std::uint64_t* centre = blocked.column(ix, iy);
    std::uint64_t levels = planes_[0];
    for (const Ring& ring : rings) {
      for (; reach < ring.reach; ++reach) levels |= levels << 1 | levels >> 1;
      const std::uint64_t bits = levels & inside_[0];
      for (const Ring::Column& column : ring.columns) centre[column.words] |= bits;
    }
    return;
  }
  if (whole && words_ == 1 && parts == 2) {
    std::uint64_t* centre = blocked.column(ix, iy);
    std::uint64_t lower = planes_[0];
    std::uint64_t upper = planes_[1];
    for (const Ring& ring : rings) {
      for (; reach < ring.reach; ++reach) {
        const std::uint64_t both = lower | upper;
        const std::uint64_t above = lower >> 1;
        lower = both | upper << 1;
        upper = both | above;
      }
      const std::uint64_t bits = (lower | upper) & inside_[0];
      for (const Ring::Column& column : ring.columns) centre[column.words] |= bits;
    }
    return;
  }
  for (const Ring& ring : rings) {
    for (; reach < ring.reach; ++reach) dilate();
    for (int w = 0; w < words_; ++w) {
      std::uint64_t bits = 0;
      for (int part = 0; part < parts; ++part) bits |= planes_[w * parts + part];
      bits &= inside_[w];
      if (bits == 0) continue;
      for (const Ring::Column& column : ring.columns) {
        const int jx = ix + column.dx;
        const int jy = iy + column.dy;
        if (jx < low.x() || jx >= high.x() || jy < low.y() || jy >= high.y()) continue;
        blocked.column(jx, jy)[w] |= bits;
      }
    }
  }
}

void Inflation::roll(const OccupancyGrid& sources, const Cell& shift, OccupancyGrid& blocked) {
  blocked.roll(shift);
  for (int axis = 0; axis < 3; ++axis) {
    if (shift[axis] == 0) continue;
    // Cells that entered on one side take in what is occupied within reach; cells near the other
    // side may owe their being blocked to sources that left.
    const CellBox fresh = entered(blocked.frame(), shift, axis);
    CellBox bereft = all_of(blocked.frame());
    if (shift[axis] > 0) {
      bereft.high[axis] = reach_[axis];
    } else {
      bereft.low[axis] = bereft.high[axis] - reach_[axis];
    }
    repair(sources, fresh.low, fresh.high, blocked);
    repair(sources, bereft.low, bereft.high, blocked);
  }
}

OccupancyGrid inflate(const OccupancyGrid& occupied, double radius) {
  return inflate(occupied, radius, {1, 1, 1});
}

OccupancyGrid inflate(const OccupancyGrid& sources, double radius,
                      const std::array<int, 3>& parts) {
  constexpr const char* kAxis[] = {"x", "y", "z"};
  const GridFrame& fine = sources.frame();
  Point cell;
  std::array<int, 3> dims;
  Cell first;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string name = std::string("parts.") + kAxis[axis];
    check::at_least(name, parts[axis], 1);
    if (fine.dims()[axis] % parts[axis] != 0 || fine.first()[axis] % parts[axis] != 0) {
      check::fail(name, parts[axis], "a divisor of the grid's dims, and of where it begins");
    }
    cell[axis] = fine.cell()[axis] * parts[axis];
    dims[axis] = fine.dims()[axis] / parts[axis];
    first[axis] = fine.first()[axis] / parts[axis];
  }
  const bool same = parts == std::array<int, 3>{1, 1, 1};
  const Point anchor = fine.origin() - fine.first().cast<double>().cwiseProduct(fine.cell());
  OccupancyGrid blocked(same ? fine : GridFrame(anchor, cell, dims).shifted(first));
  Inflation(blocked.frame(), radius, parts).apply(sources, blocked);
  return blocked;
}

}  // namespace ltp
