// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/search/column_priority.hpp"

namespace ltp::planning {

void ColumnPriority::reset(const GridFrame& frame, const Raster& raster) {
  raster_ = &raster;
  rows_.resize(frame.nx());
  columns_.resize(frame.ny());
  for (int ix = 0; ix < frame.nx(); ++ix) {
    rows_[ix] = raster.index_of(0, frame.centre(Cell(ix, 0, 0)).x());
  }
  for (int iy = 0; iy < frame.ny(); ++iy) {
    columns_[iy] = raster.index_of(1, frame.centre(Cell(0, iy, 0)).y());
  }
}

}  // namespace ltp::planning
