// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Where a ray that hits a column of a height raster ends.
#pragma once

#include <algorithm>

#include "ltp/grid/raster.hpp"
#include "ltp/sensing/surface.hpp"

namespace ltp::sensing {

inline constexpr int kTopFace = 2;  ///< after 0 and 1, the walls across x and y; -1: started inside

/// A point on the surface of column (i, j), moved into it through the face that was hit. It keeps a
/// margin from the other faces, so that rounding cannot put it into the neighbour.
inline Point inside_column(const Raster& heights, int i, int j, double height, int face,
                    const Point& point) {
  const double cell = heights.cell();
  const double low_x = heights.origin().x() + i * cell;
  const double low_y = heights.origin().y() + j * cell;
  const double depth = std::min(kHitDepth, 0.5 * cell);
  const double margin = std::min(kHitMargin, 0.25 * cell);
  const double from_x = face == 0 ? depth : margin;
  const double from_y = face == 1 ? depth : margin;
  const double from_top = face == kTopFace ? kHitDepth : kHitMargin;
  return {std::min(std::max(point.x(), low_x + from_x), low_x + cell - from_x),
          std::min(std::max(point.y(), low_y + from_y), low_y + cell - from_y),
          std::min(point.z(), height - from_top)};
}

}  // namespace ltp::sensing
