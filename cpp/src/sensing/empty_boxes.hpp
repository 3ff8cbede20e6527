// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `EmptyBoxes`: round each empty cube of a grid a box, as large as may be, in which there is
// nothing.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ltp/grid/frame.hpp"

namespace ltp::sensing {

/// A dense grid of `VoxelBricks`' words: its root, or the children of one node. Cell (x, y, z) is
/// at `x << x_shift | y << y_shift | z`.
class EmptyBoxes {
 public:
  /// How many eighths of a cell are empty from its lower and its upper face on, along each axis.
  using Layers = std::array<std::uint8_t, 6>;
  static constexpr Layers kNoLayers{};
  static constexpr Layers kAllLayers{8, 8, 8, 8, 8, 8};

  EmptyBoxes(const std::array<int, 3>& dims, int x_shift, int y_shift)
      : dims_(dims), x_shift_(x_shift), y_shift_(y_shift) {}

  /// Of a cell, by a bit for each of its eighths along each axis that is in use.
  static Layers layers(const std::array<std::uint8_t, 3>& used);

  /// Writes the six bytes into each empty word.
  /// @param layers_of  of a word that is not empty
  template <typename LayersOf>
  void find(std::uint64_t* words, LayersOf&& layers_of) {
    for (std::vector<std::uint8_t>& of_face : layers_) {
      of_face.resize(std::size_t(dims_[0]) * dims_[1] * dims_[2]);
    }
    for (int x = 0; x < dims_[0]; ++x) {
      for (int y = 0; y < dims_[1]; ++y) {
        for (int z = 0; z < dims_[2]; ++z) {
          const std::uint64_t word = words[at(x, y, z)];
          const Layers layers = word >> 62 == 0 ? kAllLayers : layers_of(word);
          for (int face = 0; face < 6; ++face)
            layers_[face][layer_at(face, x, y, z)] = layers[face];
        }
      }
    }
    add_up(words);
    grow_all(words);
  }

 private:
  std::int64_t at(std::int64_t x, std::int64_t y, std::int64_t z) const {
    return x << x_shift_ | y << y_shift_ | z;
  }
  /// In `layers_[face]`, where what is looked through together lies side by side: levels of cells
  /// for the faces that look up and down, else columns.
  std::size_t layer_at(int face, std::size_t x, std::size_t y, std::size_t z) const {
    return face / 2 == 2 ? (z * dims_[0] + x) * dims_[1] + y : (x * dims_[1] + y) * dims_[2] + z;
  }
  void add_up(const std::uint64_t* words);
  void grow_all(std::uint64_t* words) const;
  std::uint64_t grown(const Cell& cell) const;
  bool empty(const Cell& low, const Cell& high) const;
  int least_layers(const Cell& low, const Cell& high, int face) const;

  std::array<int, 3> dims_;
  int x_shift_;
  int y_shift_;
  std::array<std::vector<std::uint8_t>, 6> layers_;  ///< of each face
  std::vector<std::int32_t> sums_;  ///< cells in use below (x, y, z), one more along each axis
};

}  // namespace ltp::sensing
