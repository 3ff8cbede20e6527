// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Windows of other sizes on the lattice of a window.
#pragma once

#include "ltp/grid/frame.hpp"

namespace ltp {

inline Cell dims_of(const GridFrame& frame) { return Cell(frame.nx(), frame.ny(), frame.nz()); }

/// A window on the lattice of another one, which begins at a cell counted from the anchor.
inline GridFrame on_lattice_of(const GridFrame& frame, const Cell& first, const Cell& dims) {
  const Point anchor = frame.shifted(-frame.first()).origin();
  return GridFrame(anchor, frame.cell(), {dims.x(), dims.y(), dims.z()}).shifted(first);
}

}  // namespace ltp
