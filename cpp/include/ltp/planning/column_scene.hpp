// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `ColumnScene`: a scene whose priority has one value over each column of its grid.
#pragma once

#include <cstdint>
#include <optional>

#include "ltp/grid/columns.hpp"
#include "ltp/planning/planner.hpp"

namespace ltp {

/// What planners see of a scene: they know one priority for each column, and only of such a raster
/// can they prove anything. A raster that lies off the grid's lattice, or is finer, is resampled by
/// `onto_columns` (kept until raster or window change), whatever the weights: all planners tally
/// the same raster. Where no squares fill a column, it stays as it is.
class ColumnScene {
 public:
  /// The scene to plan in, until the next call.
  Scene of(const Scene& scene) {
    const GridFrame& frame = scene.occupancy.frame();
    resampled_ = !is_constant_on_columns(scene.priority, frame) && square_of_column(frame);
    if (!resampled_) return scene;
    if (!made_ || made_of_ != scene.priority.id() || frame_ != frame) {
      made_.emplace(onto_columns(scene.priority, frame));
      made_of_ = scene.priority.id();
      frame_ = frame;
    }
    return {scene.occupancy, *made_};
  }
  /// Whether that has another raster than the scene given.
  bool resampled() const { return resampled_; }

 private:
  bool resampled_ = false;
  std::optional<Raster> made_;
  std::uint64_t made_of_ = 0;
  std::optional<GridFrame> frame_;
};

}  // namespace ltp
