// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Where a ray that hits a column of a height raster ends.
#pragma once

#include <algorithm>

#include "ltp/grid/raster.hpp"
#include "ltp/sensing/surface.hpp"

namespace ltp::sensing {

inline constexpr int kTopFace = 2;  ///< after 0 and 1, the walls across x and y; -1: started inside

/// Moves points of a column's surface into it, through the face that was hit. They keep a margin
/// from the other faces, so that rounding cannot put them into the neighbour.
class ColumnInside {
 public:
  ColumnInside(const Raster& heights, int i, int j, double height)
      : cell_(heights.cell()),
        low_x_(heights.origin().x() + i * cell_),
        low_y_(heights.origin().y() + j * cell_),
        height_(height) {}

  double x(int face, double on_surface) const { return within(low_x_, face == 0, on_surface); }
  double y(int face, double on_surface) const { return within(low_y_, face == 1, on_surface); }
  double z(int face, double on_surface) const {
    return std::min(on_surface, height_ - (face == kTopFace ? kHitDepth : kHitMargin));
  }
  Point operator()(int face, const Point& p) const {
    return {x(face, p.x()), y(face, p.y()), z(face, p.z())};
  }

 private:
  double within(double low, bool hit, double on_surface) const {
    const double inset =
        hit ? std::min(kHitDepth, 0.5 * cell_) : std::min(kHitMargin, 0.25 * cell_);
    return std::min(std::max(on_surface, low + inset), low + cell_ - inset);
  }

  double cell_;
  double low_x_;
  double low_y_;
  double height_;
};

}  // namespace ltp::sensing
