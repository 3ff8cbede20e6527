// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_bricks.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "empty_boxes.hpp"
#include "ltp/geometry/check.hpp"

namespace ltp::sensing {
namespace {

constexpr std::int64_t kMostRoot = std::int64_t{1} << 20;  // cells; 8 MB

int bits_for(std::int64_t count) {
  int bits = 0;
  while ((std::int64_t{1} << bits) < count) ++bits;
  return bits;
}

double squared(double value) { return value * value; }

/// Squared distance from a point to a cube.
double squared_gap(const Point& point, const Cell& low, double edge) {
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    sum += squared(std::max({low[axis] - point[axis], point[axis] - (low[axis] + edge), 0.0}));
  }
  return sum;
}

}  // namespace

VoxelBricks::VoxelBricks(const std::vector<VoxelCube>& cubes, std::int64_t most_bytes)
    : most_bytes_(most_bytes) {
  choose_root(cubes);
  const Eigen::Matrix<std::int64_t, 3, 1> base =
      low_.cast<std::int64_t>() - offset_.cast<std::int64_t>();
  for (const VoxelCube& cube : cubes) {
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
      box[axis] = cube.low[axis] - base[axis];
      box[axis + 3] = box[axis] + cube.edge;
    }
    for (std::int64_t x = box[0] >> shift_; x <= (box[3] - 1) >> shift_; ++x) {
      for (std::int64_t y = box[1] >> shift_; y <= (box[4] - 1) >> shift_; ++y) {
        for (std::int64_t z = box[2] >> shift_; z <= (box[5] - 1) >> shift_; ++z) {
          const auto index = static_cast<std::uint32_t>(x << x_shift_ | y << y_shift_ | z);
          fill(root_, index, root_low(index) + offset_, shift_, box);
        }
      }
    }
  }
  bricks_.resize(std::max<std::size_t>(bricks_.size(), kWords));  // a walk may read the first
  nodes_.resize(std::max<std::size_t>(nodes_.size(), kCells));
  bricks_.shrink_to_fit();
  nodes_.shrink_to_fit();
  find_empty_boxes();
}

void VoxelBricks::choose_root(const std::vector<VoxelCube>& cubes) {
  using Wide = Eigen::Matrix<std::int64_t, 3, 1>;
  Wide low = Wide::Zero();
  Wide high = Wide::Ones();
  if (!cubes.empty()) {
    low = cubes.front().low.cast<std::int64_t>();
    high = low;
  }
  for (const VoxelCube& cube : cubes) {
    low = low.cwiseMin(cube.low.cast<std::int64_t>());
    high = high.cwiseMax((cube.low.cast<std::int64_t>().array() + cube.edge).matrix());
  }
  const Wide dims = high - low;
  if (!(dims.cast<double>().prod() < 0x1p62) || dims.maxCoeff() >= (std::int64_t{1} << 31)) {
    std::ostringstream text;
    text << dims.x() << " x " << dims.y() << " x " << dims.z();
    check::fail("octree's bounding box [voxels]", text.str(), "fewer than 2^62 voxels in all");
  }
  low_ = low.cast<int>();
  dims_ = dims.cast<int>();
  // The smallest cells of which there are few enough. On multiples of their edge, as the cubes of
  // an octree are.
  for (shift_ = kBrickShift;; shift_ += kBrickShift) {
    Wide first, cells;
    for (int axis = 0; axis < 3; ++axis) {
      first[axis] = low[axis] >> shift_;
      cells[axis] = ((high[axis] - 1) >> shift_) - first[axis] + 1;
    }
    y_shift_ = bits_for(cells.z());
    x_shift_ = y_shift_ + bits_for(cells.y());
    if (x_shift_ > 40 || cells.x() << x_shift_ > kMostRoot) continue;
    root_dims_ = cells.cast<int>();
    offset_ = (low - first * (std::int64_t{1} << shift_)).cast<int>();
    root_.assign(cells.x() << x_shift_, 0);
    return;
  }
}

std::uint64_t VoxelBricks::new_child(int shift) {
  std::vector<std::uint64_t>& words = shift > kBrickShift ? nodes_ : bricks_;
  const int size = shift > kBrickShift ? kCells : kWords;
  const std::uint64_t number = words.size() / size;
  if (bytes() + 8 * size > most_bytes_) {
    const std::string expected =
        "at most " + std::to_string(most_bytes_) + ", fewer or nearer voxels";
    check::fail("octree's memory [bytes]", bytes() + 8 * size, expected.c_str());
  }
  words.resize(words.size() + size, 0);
  return kChild | number;
}

void VoxelBricks::fill(std::vector<std::uint64_t>& words, std::size_t index, const Cell& low,
                       int shift, const Box& box) {
  if (words[index] & kFull) return;
  // The part of the box that lies in this cube, counted from its corner.
  std::array<int, 3> from, to;
  bool all = true;
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t edge = std::int64_t{1} << shift;
    from[axis] = static_cast<int>(std::max<std::int64_t>(box[axis] - low[axis], 0));
    to[axis] = static_cast<int>(std::min<std::int64_t>(box[axis + 3] - low[axis], edge));
    all &= from[axis] == 0 && to[axis] == edge;
  }
  if (all) {
    words[index] = kFull;
    return;
  }
  if (words[index] == 0) {
    const std::uint64_t child = new_child(shift);  // may move `words`
    words[index] = child;
  }
  const std::uint64_t number = words[index] & kNumber;
  if (shift == kBrickShift) {
    for (int x = from[0]; x < to[0]; ++x) {
      for (int y = from[1]; y < to[1]; ++y) {
        for (int z = from[2]; z < to[2]; ++z) {
          bricks_[number * kWords + word_of(x, y, z)] |= std::uint64_t{1} << bit_of(x, y, z);
        }
      }
    }
    return;
  }
  const int inner = shift - kBrickShift;
  for (int x = from[0] >> inner; x <= (to[0] - 1) >> inner; ++x) {
    for (int y = from[1] >> inner; y <= (to[1] - 1) >> inner; ++y) {
      for (int z = from[2] >> inner; z <= (to[2] - 1) >> inner; ++z) {
        fill(nodes_, number * kCells + (x << 6 | y << 3 | z), low + Cell(x, y, z) * (1 << inner),
             inner, box);
      }
    }
  }
}

void VoxelBricks::find_empty_boxes() {
  const auto layers_of = [&](std::uint64_t word, int shift) {
    if (word & kFull) return EmptyBoxes::kNoLayers;
    const std::uint64_t number = word & kNumber;
    std::array<std::uint8_t, 3> used{};
    const auto use = [&](int x, int y, int z) {
      used[0] |= 1 << x;
      used[1] |= 1 << y;
      used[2] |= 1 << z;
    };
    if (shift > kBrickShift) {
      for (int n = 0; n < kCells; ++n) {
        if (nodes_[number * kCells + n] & (kChild | kFull)) use(n >> 6, n >> 3 & 7, n & 7);
      }
    } else {
      visit_word(word, Cell::Zero(), shift,
                 [&](const Cell& voxel, int) { use(voxel.x(), voxel.y(), voxel.z()); });
    }
    return EmptyBoxes::layers(used);
  };
  // Of the nodes, wherever they are: their children's edges go with the depth.
  const auto inside_nodes = [&](const auto& self, std::uint64_t* words, std::size_t size,
                                int shift) -> void {
    for (std::size_t n = 0; n < size; ++n) {
      if (!(words[n] & kChild) || shift == kBrickShift) continue;
      std::uint64_t* children = nodes_.data() + (words[n] & kNumber) * kCells;
      const int inner = shift - kBrickShift;
      EmptyBoxes({8, 8, 8}, 6, 3).find(children, [&](std::uint64_t word) {
        return layers_of(word, inner);
      });
      self(self, children, kCells, inner);
    }
  };
  EmptyBoxes({root_dims_.x(), root_dims_.y(), root_dims_.z()}, x_shift_, y_shift_)
      .find(root_.data(), [&](std::uint64_t word) { return layers_of(word, shift_); });
  inside_nodes(inside_nodes, root_.data(), root_.size(), shift_);
}

std::int64_t VoxelBricks::count() const {
  std::int64_t sum = 0;
  for_each_cube([&](const Cell&, std::int64_t edge) { sum += edge * edge * edge; });
  return sum;
}

std::int64_t VoxelBricks::bytes() const {
  return static_cast<std::int64_t>(8 * (root_.size() + nodes_.size() + bricks_.size()));
}

bool VoxelBricks::occupied(const Cell& voxel) const {
  for (int axis = 0; axis < 3; ++axis) {
    if (voxel[axis] < 0 || voxel[axis] >= dims_[axis]) return false;
  }
  const std::int64_t x = std::int64_t{voxel.x()} + offset_.x();
  const std::int64_t y = std::int64_t{voxel.y()} + offset_.y();
  const std::int64_t z = std::int64_t{voxel.z()} + offset_.z();
  std::uint64_t word = root_[x >> shift_ << x_shift_ | y >> shift_ << y_shift_ | z >> shift_];
  for (int shift = shift_ - kBrickShift; shift >= kBrickShift && word & kChild;
       shift -= kBrickShift) {
    word = nodes_[(word & kNumber) * kCells + child_of(x, y, z, shift)];
  }
  if (!(word & kChild)) return word & kFull;
  return bricks_[(word & kNumber) * kWords + word_of(x, y, z)] >> bit_of(x, y, z) & 1;
}

double VoxelBricks::squared_distance(const Point& point, double most) const {
  // Rings of root cells round the one nearest to the point, until none can be nearer.
  const double edge = std::int64_t{1} << shift_;
  const Point at = (point + offset_.cast<double>()) / edge;
  const Cell last = root_dims_ - Cell::Ones();
  const Cell middle =
      at.array().floor().max(0.0).min(last.cast<double>().array()).matrix().cast<int>();
  double nearest = most;
  for (int ring = 0; ring < root_dims_.maxCoeff(); ++ring) {
    if (squared(std::max(ring - 1, 0) * edge) >= nearest) break;
    const Cell from = (middle.array() - ring).max(0).matrix();
    const Cell to = (middle.array() + ring).min(last.array()).matrix();
    for (int x = from.x(); x <= to.x(); ++x) {
      for (int y = from.y(); y <= to.y(); ++y) {
        const bool side = std::abs(x - middle.x()) == ring || std::abs(y - middle.y()) == ring;
        for (int z = side ? from.z() : middle.z() - ring; z <= to.z();
             z += side || ring == 0 ? 1 : 2 * ring) {
          if (z < 0) continue;
          const auto index = static_cast<std::uint32_t>(x << x_shift_ | y << y_shift_ | z);
          nearest = squared_distance(root_[index], root_low(index), shift_, point, nearest);
        }
      }
    }
  }
  return nearest;
}

double VoxelBricks::squared_distance(std::uint64_t word, const Cell& low, int shift,
                                     const Point& point, double nearest) const {
  if (!(word & (kChild | kFull))) return nearest;
  const double to_cube = squared_gap(point, low, std::int64_t{1} << shift);
  if (to_cube >= nearest || word & kFull) return std::min(to_cube, nearest);
  if (shift == kBrickShift) {
    visit_word(word, low, shift, [&](const Cell& voxel, int) {
      nearest = std::min(nearest, squared_gap(point, voxel, 1.0));
    });
    return nearest;
  }
  const std::uint64_t* children = nodes_.data() + (word & kNumber) * kCells;
  const int inner = shift - kBrickShift;
  for (int n = 0; n < kCells; ++n) {
    const Cell corner = low + Cell(n >> 6, n >> 3 & 7, n & 7) * (1 << inner);
    nearest = squared_distance(children[n], corner, inner, point, nearest);
  }
  return nearest;
}

}  // namespace ltp::sensing
