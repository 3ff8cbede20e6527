// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Rasters over the columns of a grid: whether one value holds for each, and how it is made so.
#pragma once

#include <optional>

#include "ltp/grid/frame.hpp"
#include "ltp/grid/raster.hpp"

namespace ltp {

/// Whether a raster has one value over each column of a grid: its cells are the columns, or blocks
/// of them, or parts of them that are alike. Edges and origins are compared to 1e-9 of a column.
bool is_constant_on_columns(const Raster& raster, const GridFrame& frame);

/// The edge of the largest squares that fill a column of a grid [m]: its own, or for columns that
/// are no squares a common part of both edges, down to a sixteenth of the longer one. Empty where
/// there is none.
std::optional<double> square_of_column(const GridFrame& frame);

/// A raster that has one value over each column of a grid, the mean of the given one over the
/// column's area. It covers the grid and has the given one's value outside. Columns that are no
/// squares are several cells of it. Throws `std::invalid_argument` where no squares fill them.
Raster onto_columns(const Raster& raster, const GridFrame& frame);

}  // namespace ltp
