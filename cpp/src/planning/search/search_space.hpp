// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Scratch memory for a search over a window's cells: stamped, so that a new search clears nothing.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "ltp/grid/frame.hpp"
#include "ltp/grid/neighbourhood.hpp"
#include "planning/search/zeroed_array.hpp"

namespace ltp::planning {

/// One `Node` a cell of the levels that a query leaves open, or several layers of that. `Node`
/// needs a member `std::uint32_t stamp = 0`.
template <typename Node>
class SearchSpace {
 public:
  /// Begins a search: all cells are as if never visited. Returns the size of a layer: a cell's node
  /// in layer i is its `index`, and i of them. Throws `std::length_error` for 2^32 nodes and more.
  std::uint32_t begin(const GridFrame& frame, const LevelRange& levels, std::size_t layers = 1) {
    ny_ = static_cast<std::uint32_t>(frame.ny());
    lowest_ = levels.lowest;
    depth_ = static_cast<std::uint32_t>(levels.count());
    const std::size_t layer = std::size_t{static_cast<std::uint32_t>(frame.nx())} * ny_ * depth_;
    const std::size_t size = layer * layers;
    if (size > std::numeric_limits<std::uint32_t>::max()) throw std::length_error("ltp: layers");
    if (nodes_.size() < size) {
      nodes_.reset(size);
      stamp_ = 0;
    }
    if (stamp_ == std::numeric_limits<std::uint32_t>::max()) {
      for (Node& node : nodes_) node.stamp = 0;
      stamp_ = 0;
    }
    ++stamp_;
    return static_cast<std::uint32_t>(layer);
  }

  std::uint32_t index(const Cell& cell) const {
    return (static_cast<std::uint32_t>(cell.x()) * ny_ + static_cast<std::uint32_t>(cell.y())) *
               depth_ +
           static_cast<std::uint32_t>(cell.z() - lowest_);
  }
  Cell cell(std::uint32_t index) const {
    const std::uint32_t column = index / depth_;
    return Cell(static_cast<int>(column / ny_), static_cast<int>(column % ny_),
                static_cast<int>(index % depth_) + lowest_);
  }

  bool visited(std::uint32_t index) const { return nodes_[index].stamp == stamp_; }
  /// The cell's node; a fresh one if this search has not visited it.
  Node& visit(std::uint32_t index) {
    Node& node = nodes_[index];
    if (node.stamp != stamp_) {
      node = Node{};
      node.stamp = stamp_;
    }
    return node;
  }
  const Node& operator[](std::uint32_t index) const {
    assert(visited(index));
    return nodes_[index];
  }

 private:
  ZeroedArray<Node> nodes_;
  std::uint32_t stamp_ = 0;
  std::uint32_t ny_ = 0;
  std::uint32_t depth_ = 1;
  int lowest_ = 0;
};

}  // namespace ltp::planning
