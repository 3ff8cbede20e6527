// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/column_scene.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "ltp/grid/columns.hpp"

namespace ltp {
namespace {

/// How many of its widths the raster is looked at round a window, on each side, at most; and how
/// many columns then. *Assumed.*
constexpr std::int64_t kWidths = 4;
constexpr std::int64_t kMostColumns = 4'000'000;

/// The columns of a frame's lattice that meet a raster, as numbers on the lattice.
struct Columns {
  Cell low;   ///< the first
  Cell high;  ///< behind the last
};

Columns columns_of(const Raster& raster, const GridFrame& lattice) {
  const auto number = [&](const Eigen::Vector2d& point) {
    const Point on_lattice = lattice.lattice(Point(point.x(), point.y(), 0.0));
    return Cell(on_lattice.array().floor().max(-kFarthestCell).min(kFarthestCell).cast<int>());
  };
  const Eigen::Vector2d size(raster.nx(), raster.ny());
  // A column more: the end may be a face, and rounding may have moved it.
  return {number(raster.origin()) - Cell(1, 1, 0),
          number(raster.origin() + raster.cell() * size) + Cell(2, 2, 0)};
}

/// The lattice itself: its first cell is at the anchor.
GridFrame lattice_of(const GridFrame& frame) { return frame.shifted(-frame.first()); }

/// The columns that meet both the raster and a window's surroundings; at least one.
Columns surroundings(const Raster& raster, const GridFrame& window, std::int64_t widths) {
  Columns met = columns_of(raster, lattice_of(window));
  for (int axis = 0; axis < 2; ++axis) {
    const std::int64_t first = window.first()[axis];
    const std::int64_t margin = widths * window.dims()[axis];
    const std::int64_t low = first - margin;
    const std::int64_t high = first + window.dims()[axis] + margin;
    const std::int64_t begin = std::clamp<std::int64_t>(met.low[axis], low, high - 1);
    met.low[axis] = static_cast<int>(begin);
    met.high[axis] = static_cast<int>(std::clamp<std::int64_t>(met.high[axis], begin + 1, high));
  }
  return met;
}

/// The columns to look at for a window, not too many.
GridFrame cover_of(const Raster& raster, const GridFrame& window) {
  std::int64_t widths = kWidths;
  Columns met = surroundings(raster, window, widths);
  const auto count = [&] {
    return std::int64_t{met.high.x() - met.low.x()} * (met.high.y() - met.low.y());
  };
  while (widths > 0 && count() > kMostColumns) met = surroundings(raster, window, --widths);
  return GridFrame(lattice_of(window).origin(), window.cell(),
                   {met.high.x() - met.low.x(), met.high.y() - met.low.y(), 1})
      .shifted(Cell(met.low.x(), met.low.y(), 0));
}

/// The part of a raster made by `onto_columns` for `cover` that `window` would have got.
Raster part_of(const Raster& columns, const GridFrame& cover, const GridFrame& window) {
  const int per_x = columns.nx() / cover.nx();
  const int per_y = columns.ny() / cover.ny();
  const int nx = window.nx() * per_x;
  const int ny = window.ny() * per_y;
  const int i = (window.first().x() - cover.first().x()) * per_x;
  const int j = (window.first().y() - cover.first().y()) * per_y;
  Raster::Values values = Raster::Values::Constant(nx, ny, columns.outside());
  const int begin_x = std::max(0, -i);
  const int begin_y = std::max(0, -j);
  const int count_x = std::min(nx, columns.nx() - i) - begin_x;
  const int count_y = std::min(ny, columns.ny() - j) - begin_y;
  if (count_x > 0 && count_y > 0) {
    values.block(begin_x, begin_y, count_x, count_y) =
        columns.values().block(i + begin_x, j + begin_y, count_x, count_y);
  }
  return Raster(std::move(values), window.origin().head<2>(), columns.cell(), columns.outside());
}

}  // namespace

Scene ColumnScene::of(const Scene& scene) {
  const GridFrame& window = scene.occupancy.frame();
  if (!covers(scene.priority, window)) {
    cover_ = cover_of(scene.priority, window);
    raster_ = scene.priority.id();
    columns_.reset();
    window_.reset();
    if (!is_constant_on_columns(scene.priority, *cover_) && square_of_column(*cover_)) {
      columns_.emplace(onto_columns(scene.priority, *cover_));
    }
  }
  if (!columns_) return scene;
  if (window_ != window) {
    seen_.emplace(part_of(*columns_, *cover_, window));
    window_ = window;
  }
  return {scene.occupancy, *seen_};
}

/// Whether what was found out holds for all columns of a window that meet a raster.
bool ColumnScene::covers(const Raster& raster, const GridFrame& window) const {
  if (!cover_ || raster_ != raster.id()) return false;
  const GridFrame lattice = lattice_of(window);
  const GridFrame of_cover = lattice_of(*cover_);
  if (lattice.origin() != of_cover.origin() || lattice.cell() != of_cover.cell()) return false;
  const Columns met = surroundings(raster, window, 0);
  const Cell low = cover_->first();
  const Cell high = low + Cell(cover_->nx(), cover_->ny(), 0);
  return met.low.x() >= low.x() && met.low.y() >= low.y() && met.high.x() <= high.x() &&
         met.high.y() <= high.y();
}

}  // namespace ltp
