// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `VoxelBricks`: occupied voxels as bricks of bits, and above them a hierarchy of empty boxes.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ltp/geometry/types.hpp"
#include "ltp/grid/frame.hpp"

namespace ltp::sensing {

/// A cube of occupied voxels, counted on the lattice through the world's origin.
struct VoxelCube {
  Cell low;
  int edge;  ///< [voxels]
};

/// One 64-bit word says what is in a cube of voxels. A brick's cube has an edge of 8 voxels, that
/// of a node 8 times that of its children. Above all is a dense root, of cells so large that they
/// are few: bricks for a hall or a district, nodes for what is larger. Only bricks and nodes that
/// hold voxels exist; cubes that are all occupied are one word, whatever their size.
class VoxelBricks {
 public:
  /// Bits of a word: of a brick or node (its number in the lowest 32 bits), of a full cube.
  /// Neither: an empty cube, which is part of a larger empty box. Six bytes say how far that one
  /// reaches beyond the cube, in eighths of its edge: downwards and upwards along x, then y, then
  /// z.
  static constexpr std::uint64_t kChild = std::uint64_t{1} << 63;
  static constexpr std::uint64_t kFull = std::uint64_t{1} << 62;
  static constexpr std::uint64_t kNumber = 0xffffffff;
  static constexpr int kBrickShift = 3;  ///< of the edge of a brick
  static constexpr int kCells = 512;     ///< children of a node; voxels of a brick
  static constexpr int kWords = 8;       ///< of a brick, a cube of 4 x 4 x 4 voxels each

  /// Throws `std::invalid_argument` for a bounding box of 2^62 voxels and more, or if voxels lie so
  /// scattered that the structure would take more than `most_bytes` of memory.
  explicit VoxelBricks(const std::vector<VoxelCube>& cubes,
                       std::int64_t most_bytes = std::int64_t{1} << 30);

  const Cell& low() const { return low_; }    ///< lowest voxel of the bounding box, on the lattice
  const Cell& dims() const { return dims_; }  ///< voxels of the box; (1, 1, 1) if there are none
  std::int64_t count() const;                 ///< occupied voxels
  std::int64_t bytes() const;                 ///< of memory

  /// Whether a voxel is occupied, counted from the box's lowest one; false outside the box.
  bool occupied(const Cell& voxel) const;
  /// Squared distance to the nearest occupied voxel from a point, both in voxels from the box's
  /// lowest corner; `most` if none is nearer.
  double squared_distance(const Point& point, double most) const;
  /// Calls `visit(low, edge)` for disjoint cubes of voxels that are all that is occupied, counted
  /// from the box's lowest one.
  template <typename Visitor>
  void for_each_cube(Visitor&& visit) const {
    const auto cells = static_cast<std::uint32_t>(root_.size());
    for (std::uint32_t index = 0; index < cells; ++index) {
      visit_word(root_[index], root_low(index), shift_, visit);
    }
  }

  // What a walk reads. Voxels are counted from the root's lowest corner, `offset` below the box.
  const Cell& offset() const { return offset_; }
  int shift() const { return shift_; }      ///< a root cell's edge is so many doublings [voxels]
  int x_shift() const { return x_shift_; }  ///< a step in x or y is so many doublings in the root
  int y_shift() const { return y_shift_; }
  const std::uint64_t* root() const { return root_.data(); }
  const std::uint64_t* nodes() const { return nodes_.data(); }
  const std::uint64_t* bricks() const { return bricks_.data(); }

  /// Among the children of a node, whose edges are `shift` doublings.
  static std::int64_t child_of(std::int64_t x, std::int64_t y, std::int64_t z, int shift) {
    return (x >> shift & 7) << 6 | (y >> shift & 7) << 3 | (z >> shift & 7);
  }
  /// Among the words of a brick, and the voxel's bit among those of the word.
  static std::int64_t word_of(std::int64_t x, std::int64_t y, std::int64_t z) {
    return (x >> 2 & 1) << 2 | (y >> 2 & 1) << 1 | (z >> 2 & 1);
  }
  static std::int64_t bit_of(std::int64_t x, std::int64_t y, std::int64_t z) {
    return (x & 3) << 4 | (y & 3) << 2 | (z & 3);
  }

 private:
  using Box =
      std::array<std::int64_t, 6>;  ///< lowest voxel along each axis, then end; from the root

  void choose_root(const std::vector<VoxelCube>& cubes);
  void fill(std::vector<std::uint64_t>& words, std::size_t index, const Cell& low, int shift,
            const Box& box);
  void find_empty_boxes();
  std::uint64_t new_child(int shift);
  Cell root_low(std::uint32_t index) const {
    return Cell(index >> x_shift_, index >> y_shift_ & ((1u << (x_shift_ - y_shift_)) - 1),
                index & ((1u << y_shift_) - 1)) *
               (1 << shift_) -
           offset_;
  }
  double squared_distance(std::uint64_t word, const Cell& low, int shift, const Point& point,
                          double nearest) const;

  template <typename Visitor>
  void visit_word(std::uint64_t word, const Cell& low, int shift, Visitor&& visit) const {
    if (word & kFull) {
      visit(low, 1 << shift);
    } else if (word & kChild && shift > kBrickShift) {
      const std::uint64_t* children = nodes_.data() + (word & kNumber) * kCells;
      const int edge = shift - kBrickShift;
      for (int n = 0; n < kCells; ++n) {
        visit_word(children[n], low + Cell(n >> 6, n >> 3 & 7, n & 7) * (1 << edge), edge, visit);
      }
    } else if (word & kChild) {
      const std::uint64_t* brick = bricks_.data() + (word & kNumber) * kWords;
      for (int n = 0; n < kWords; ++n) {
        const Cell corner = low + Cell(n >> 2, n >> 1 & 1, n & 1) * 4;
        for (std::uint64_t bits = brick[n]; bits != 0; bits &= bits - 1) {
          const int bit = __builtin_ctzll(bits);
          visit(Cell(corner + Cell(bit >> 4, bit >> 2 & 3, bit & 3)), 1);
        }
      }
    }
  }

  std::int64_t most_bytes_;
  Cell low_ = Cell::Zero();
  Cell dims_ = Cell::Ones();
  Cell offset_ = Cell::Zero();
  int shift_ = kBrickShift;
  int x_shift_ = 0;
  int y_shift_ = 0;
  Cell root_dims_ = Cell::Ones();  ///< cells that are in use; along y and z there may be more
  std::vector<std::uint64_t> root_;
  std::vector<std::uint64_t> nodes_;
  std::vector<std::uint64_t> bricks_;
};

}  // namespace ltp::sensing
