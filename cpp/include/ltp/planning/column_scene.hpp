// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `ColumnScene`: a scene whose priority has one value over each column of its grid.
#pragma once

#include <cstdint>
#include <optional>

#include "ltp/planning/planner.hpp"

namespace ltp {

/// What planners see of a scene: they know one priority for each column, and only of such a raster
/// can they prove anything. A raster that lies off the grid's lattice, or is finer, is resampled by
/// `onto_columns`, whatever the weights: all planners tally the same raster. Where no squares fill
/// a column, it stays as it is.
///
/// What is found out holds for all columns far round the window, and is kept: as the window rolls
/// over them, no more than its part of them is copied.
class ColumnScene {
 public:
  /// The scene to plan in, until the next call.
  Scene of(const Scene& scene);
  /// Whether that has another raster than the scene given.
  bool resampled() const { return columns_.has_value(); }

 private:
  bool covers(const Raster& raster, const GridFrame& window) const;

  std::uint64_t raster_ = 0;        ///< of which the rest was found out
  std::optional<GridFrame> cover_;  ///< the columns for which it was
  std::optional<Raster> columns_;   ///< the raster on them; nothing: it stays as it is
  std::optional<GridFrame> window_;
  std::optional<Raster> seen_;  ///< of `columns_`, what lies in `window_`
};

}  // namespace ltp
