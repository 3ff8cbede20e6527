// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `CellBox`: a box of cells, and which cells enter a window when it rolls.
#pragma once

#include <algorithm>

#include "ltp/grid/lattice.hpp"

namespace ltp {

/// The cells in [low, high).
struct CellBox {
  Cell low;
  Cell high;

  bool empty() const { return (low.array() >= high.array()).any(); }
};

/// All cells of a window.
inline CellBox all_of(const GridFrame& frame) { return {Cell::Zero(), dims_of(frame)}; }

/// The cells that enter a window along one axis when it rolls by `shift`, in its new coordinates;
/// those that leave it are, in its old ones, those that enter it when it rolls back.
inline CellBox entered(const GridFrame& frame, const Cell& shift, int axis) {
  CellBox box = all_of(frame);
  const int dim = frame.dims()[axis];
  if (shift[axis] >= 0) {
    box.low[axis] = std::max(dim - shift[axis], 0);
  } else {
    box.high[axis] = std::min(-std::max(shift[axis], -dim), dim);
  }
  return box;
}

}  // namespace ltp
