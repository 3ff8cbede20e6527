// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// What the curve planners (Bezier, Hermite) share.
#pragma once

#include "ltp/geometry/types.hpp"
#include "ltp/grid/frame.hpp"
#include "ltp/grid/neighbourhood.hpp"

namespace ltp {

/// Whether all points of a curve lie in the window and its levels.
bool inside(const GridFrame& frame, const LevelRange& levels, const PathRef& curve);

/// Which way is sideways: in the plane, square to a direction, to its left. Straight up there is no
/// sideways; east is as good as any.
Point sideways(const Point& direction);

}  // namespace ltp
