// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `mark_passed`: which cells a ray passes, column of bits by column of bits.
#pragma once

#include "ltp/geometry/types.hpp"
#include "ltp/grid/occupancy_grid.hpp"

namespace ltp {

/// Sets the cells that the segment a-b passes, but for that in which it ends. `a` and `b` are given
/// in lattice units, as for `walk_segment`; the grid's first cell has the number `first` on that
/// lattice, whatever its frame says, and both points must lie inside. A cell that the segment only
/// touches is not passed: these are exactly the cells that `walk_segment` visits with t_in < t_out.
void mark_passed(const Point& a, const Point& b, const Cell& first, OccupancyGrid& passed);

}  // namespace ltp
