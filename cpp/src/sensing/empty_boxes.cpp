// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "empty_boxes.hpp"

#include <algorithm>

namespace ltp::sensing {

EmptyBoxes::Layers EmptyBoxes::layers(const std::array<std::uint8_t, 3>& used) {
  Layers free = kAllLayers;
  for (int axis = 0; axis < 3; ++axis) {
    if (used[axis] == 0) continue;
    free[2 * axis] = static_cast<std::uint8_t>(__builtin_ctz(used[axis]));
    free[2 * axis + 1] = static_cast<std::uint8_t>(__builtin_clz(used[axis]) - 24);
  }
  return free;
}

void EmptyBoxes::add_up(const std::uint64_t* words) {
  const std::int64_t row = dims_[2] + 1;
  const std::int64_t slab = row * (dims_[1] + 1);
  sums_.assign(slab * (dims_[0] + 1), 0);
  for (int x = 0; x < dims_[0]; ++x) {
    for (int y = 0; y < dims_[1]; ++y) {
      std::int32_t line = 0;
      for (int z = 0; z < dims_[2]; ++z) {
        line += words[at(x, y, z)] >> 62 != 0;
        std::int32_t* sum = sums_.data() + (x + 1) * slab + (y + 1) * row + z + 1;
        *sum = line + sum[-row] + sum[-slab] - sum[-slab - row];
      }
    }
  }
}

/// Whether the cells from `low` up to `high`, both included, are.
bool EmptyBoxes::empty(const Cell& low, const Cell& high) const {
  const std::int64_t row = dims_[2] + 1;
  const std::int64_t slab = row * (dims_[1] + 1);
  const auto line = [&](std::int64_t x, std::int64_t y) {
    const std::int32_t* sum = sums_.data() + x * slab + y * row;
    return sum[high.z() + 1] - sum[low.z()];
  };
  return line(high.x() + 1, high.y() + 1) - line(low.x(), high.y() + 1) -
             line(high.x() + 1, low.y()) + line(low.x(), low.y()) ==
         0;
}

/// Of one face of the cells from `low` up to `high`, both included; they are one cell thick along
/// the face's axis.
int EmptyBoxes::least_layers(const Cell& low, const Cell& high, int face) const {
  std::uint8_t least = 8;
  const std::uint8_t* layers = layers_[face].data();
  const int along = face / 2 == 2 ? 1 : 2;  // what lies side by side
  const int other = face / 2 == 0 ? 1 : 0;
  Cell cell = low;
  for (; cell[other] <= high[other]; ++cell[other]) {
    const std::uint8_t* row = layers + layer_at(face, cell.x(), cell.y(), cell.z());
    std::uint8_t in_row = 8;
    for (int n = 0; n <= high[along] - low[along]; ++n) in_row = std::min(in_row, row[n]);
    least = std::min(least, in_row);
    if (least == 0) return 0;
  }
  return least;
}

/// Grows first by whole cells, long strides first so that all sides have their turn; then by the
/// empty layers of the cells beyond. Floors and ceilings first: rays of a LiDAR meet them at small
/// angles.
std::uint64_t EmptyBoxes::grown(const Cell& cell) const {
  constexpr int kReach = 31;  // cells to each side at most: a byte holds the eighths of 31
  constexpr std::array<int, 6> kSides{4, 5, 0, 1, 2, 3};  // 2 * axis, one more for its upper side
  Cell low = cell;
  Cell high = cell;
  const auto step = [&](int side, int cells) {  // the slab beyond a side
    Cell from = low, to = high;
    const int axis = side / 2;
    if (side % 2 == 0) {
      to[axis] = low[axis] - 1;
      from[axis] = low[axis] - cells;
    } else {
      from[axis] = high[axis] + 1;
      to[axis] = high[axis] + cells;
    }
    return std::make_pair(from, to);
  };
  const auto room = [&](int side) {
    return side % 2 == 0 ? low[side / 2] : dims_[side / 2] - 1 - high[side / 2];
  };
  // Far from everything there is nothing to be found out.
  const Cell most = Cell(dims_[0], dims_[1], dims_[2]) - Cell::Ones();
  const Cell far_low = (cell.array() - kReach).max(0).matrix();
  const Cell far_high = (cell.array() + kReach).min(most.array()).matrix();
  const bool alone = empty(far_low, far_high);
  if (alone) {
    low = far_low;
    high = far_high;
  }
  for (int stride = (kReach + 1) / 2; stride > 0 && !alone; stride /= 2) {
    for (const int side : kSides) {
      const int cells = std::min(stride, room(side));
      if (cells == 0) continue;
      const auto [from, to] = step(side, cells);
      if (!empty(from, to)) continue;
      (side % 2 == 0 ? low : high)[side / 2] += side % 2 == 0 ? -cells : cells;
    }
  }
  std::uint64_t bytes = 0;
  std::array<bool, 6> reaches{};  // into the cells beyond
  for (const int side : kSides) {
    const int axis = side / 2;
    std::uint64_t eighths = 8 * static_cast<std::uint64_t>(side % 2 == 0 ? cell[axis] - low[axis]
                                                                         : high[axis] - cell[axis]);
    if (room(side) > 0 && !alone) {
      auto [from, to] = step(side, 1);
      for (int across = 0; across < 3; ++across) {
        if (across == axis) continue;
        from[across] -= reaches[2 * across];
        to[across] += reaches[2 * across + 1];
      }
      // Seen from the box, the layers of a cell below it begin at that cell's upper face.
      const int layers = empty(from, to) ? 0 : least_layers(from, to, side ^ 1);
      reaches[side] = layers > 0;
      eighths += layers;
    }
    bytes |= eighths << 8 * side;
  }
  return bytes;
}

void EmptyBoxes::grow_all(std::uint64_t* words) const {
  for (int x = 0; x < dims_[0]; ++x) {
    for (int y = 0; y < dims_[1]; ++y) {
      for (int z = 0; z < dims_[2]; ++z) {
        std::uint64_t& word = words[at(x, y, z)];
        if (word >> 62 == 0) word = grown(Cell(x, y, z));
      }
    }
  }
}

}  // namespace ltp::sensing
