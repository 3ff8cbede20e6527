// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The walk itself, for registers of `kLanes` doubles. Included once for each kind of processor,
// into a namespace that says how many those are.

/// A register of doubles and one of flags, 0 or 1: the compiler's vectors, one source for all
/// widths. A comparison goes straight into a choice, `a < b ? c : d`; on its own GCC 12 takes it to
/// pieces.
using Real __attribute__((vector_size(8 * kLanes))) = double;
using Flag __attribute__((vector_size(8 * kLanes))) = std::int64_t;

/// `TrackAxis`, lane by lane.
struct Axis {
  LTP_INLINE Axis() = default;
  LTP_INLINE Axis(const TrackStart& from, const Real& direction)
      : start(Real{} + from.start),
        cells(Real{} + from.cells),
        rate(direction * from.per_cell),
        inverse(from.cell / direction) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const Real zero = {};
    const Real forward = direction >= kParallel ? zero + 1.0 : zero;
    step = direction <= -kParallel ? zero - 1.0 : forward;
    first = step < 0.0 ? zero + from.first_cell(-1) : zero + from.first_cell(1);
    // A parallel track never enters or leaves: 0 * (an edge) + an infinity.
    never = step == 0.0 ? zero + kInfinity : zero;
    inverse = step == 0.0 ? zero : inverse;
  }
  LTP_INLINE Real enter(const Real& cell) const {
    const Real edge = step < 0.0 ? cell + 1.0 : cell;
    return (edge - start) * inverse - never;
  }
  LTP_INLINE Real leave(const Real& cell) const {
    const Real edge = step < 0.0 ? cell : cell + 1.0;
    return (edge - start) * inverse + never;
  }

  Real start;
  Real cells;
  Real rate;
  Real inverse;
  Real step;
  Real first;
  Real never;
};

/// Follows `kLanes` rays, the ones found from `at` on: what `HeightSurface::cast` does from there,
/// operation by operation, so that the results are the same to the last bit.
LTP_INLINE inline void walk(const BundleStart& from, const Panorama::Rays& rays, int at, int last,
                            RayEnds& ends) {
  const Real zero = {};
  const Real one = zero + 1.0;
  const Flag no = {};
  const Flag yes = no + 1;
  const double* heights = from.heights.values().data();

  Real dx, dy, dz, slab;
  for (int lane = 0; lane < kLanes; ++lane) {
    const int found = std::min(at + lane, last);
    dx[lane] = rays.x[rays.near[found]];
    dy[lane] = rays.y[rays.near[found]];
    dz[lane] = rays.z[rays.near[found]];
    slab[lane] = rays.slab[found];
  }
  const Axis x(from.x, dx);
  const Axis y(from.y, dy);

  // Into the slab, as if after all the cells before.
  const Real ahead_x = dx < 0.0 ? -dx : dx;
  const Real ahead_y = dy < 0.0 ? -dy : dy;
  Axis ahead, aside;
  ahead.start = ahead_x >= ahead_y ? x.start : y.start;
  ahead.inverse = ahead_x >= ahead_y ? x.inverse : y.inverse;
  ahead.step = ahead_x >= ahead_y ? x.step : y.step;
  ahead.first = ahead_x >= ahead_y ? x.first : y.first;
  ahead.never = zero;
  aside.start = ahead_x >= ahead_y ? y.start : x.start;
  aside.inverse = ahead_x >= ahead_y ? y.inverse : x.inverse;
  aside.rate = ahead_x >= ahead_y ? y.rate : x.rate;
  aside.step = ahead_x >= ahead_y ? y.step : x.step;
  aside.first = ahead_x >= ahead_y ? y.first : x.first;
  aside.never = ahead_x >= ahead_y ? y.never : x.never;
  const Real cell_ahead = ahead.first + ahead.step * slab;
  Real t_in = slab > 0.0 ? ahead.enter(cell_ahead) : zero;
  // `TrackAxis::cell_after`: a guess, rounded by adding and taking away what leaves no fraction;
  // the crossing times decide.
  constexpr double kNoFraction = 0x1.8p52;
  Real cell_aside = (aside.start + t_in * aside.rate - 0.5 + kNoFraction) - kNoFraction;
  cell_aside = aside.leave(cell_aside) <= t_in ? cell_aside + aside.step : cell_aside;
  cell_aside = aside.enter(cell_aside) > t_in ? cell_aside - aside.step : cell_aside;
  cell_aside = aside.step == 0.0 ? aside.first : cell_aside;
  cell_aside = slab > 0.0 ? cell_aside : aside.first;
  Real i = ahead_x >= ahead_y ? cell_ahead : cell_aside;
  Real j = ahead_x >= ahead_y ? cell_aside : cell_ahead;
  Real face = y.enter(j) == t_in ? one : zero;
  face = slab > 0.0 ? face : -one;

  const auto over_raster = [&](Flag flag) LTP_INLINE {
    flag = i >= 0.0 ? flag : no;
    flag = i < x.cells ? flag : no;
    flag = j >= 0.0 ? flag : no;
    return j < y.cells ? flag : no;
  };
  const Real max_range = zero + from.max_range;
  Flag going = over_raster(t_in < max_range ? yes : no);
  Flag hit = no;
  Real t_out = t_in;
  Real height = zero;
  for (int n = 0; n < kCells; ++n) {
    const Real t_x = x.leave(i);
    const Real t_y = y.leave(j);
    Real next = t_y < t_x ? t_y : t_x;
    next = max_range < next ? max_range : next;
    t_out = going == 1 ? next : t_out;
    // The bits of an integer, below those of 2^52.
    const Real cell = (going == 1 ? i * y.cells + j : zero) + 0x1p52;
    const Flag bits = Flag(cell) & 0xfffffffffffff;
    Real top;
    for (int lane = 0; lane < kLanes; ++lane) top[lane] = heights[bits[lane]];
    height = going == 1 ? top : height;
    const Real lowest = from.origin.z() + (dz < 0.0 ? t_out : t_in) * dz;
    const Flag blocked = lowest < height ? going : no;
    hit |= blocked;
    going ^= blocked;
    going = t_out < max_range ? going : no;
    const Flag cross_x = t_x <= t_out ? going : no;
    const Flag cross_y = t_y <= t_out ? going : no;
    i = cross_x == 1 ? i + x.step : i;
    j = cross_y == 1 ? j + y.step : j;
    t_in = going == 1 ? t_out : t_in;
    face = going == 1 ? (cross_y == 1 ? one : zero) : face;
    going = over_raster(going);
    if (kLanes == 1 && going[0] == 0) break;  // of more lanes, one would mostly go on
  }

  // `HeightSurface::column_hit` and `inside_column`.
  const Flag top_hit = from.origin.z() + t_in * dz >= height ? yes : no;
  Real to_top = (height - from.origin.z()) / dz;
  to_top = t_out < to_top ? t_out : to_top;
  to_top = to_top < t_in ? t_in : to_top;
  Real range = top_hit == 1 ? to_top : t_in;
  const double cell = from.heights.cell();
  const double depth = std::min(kHitDepth, 0.5 * cell);
  const double margin = std::min(kHitMargin, 0.25 * cell);
  face = top_hit == 1 ? zero + kTopFace : face;
  const auto within = [&](double raster, const Real& index, const Real& inset, Real point)
                          LTP_INLINE {
                            const Real low = raster + index * cell + inset;
                            const Real high = raster + index * cell + cell - inset;
                            point = point < low ? low : point;
                            return high < point ? high : point;
                          };
  const Real inset_x = face == 0.0 ? zero + depth : zero + margin;
  const Real inset_y = face == 1.0 ? zero + depth : zero + margin;
  const Real x_in = within(from.heights.origin().x(), i, inset_x, from.origin.x() + range * dx);
  const Real y_in = within(from.heights.origin().y(), j, inset_y, from.origin.y() + range * dy);
  const Real lid = height - (top_hit == 1 ? zero + kHitDepth : zero + kHitMargin);
  Real z_in = from.origin.z() + range * dz;
  z_in = lid < z_in ? lid : z_in;
  const Real otherwise =
      going == 1 ? zero + RayEnds::kUndecided : zero + std::numeric_limits<double>::infinity();
  const Real x_end = going == 1 ? i : x_in;
  const Real y_end = going == 1 ? j : y_in;
  const Real z_end = going == 1 ? t_in : z_in;
  hit = range < max_range ? hit : no;
  range = hit == 1 ? range : otherwise;
  for (int lane = 0; lane < kLanes; ++lane) {
    ends.range[at + lane] = range[lane];
    ends.x[at + lane] = x_end[lane];
    ends.y[at + lane] = y_end[lane];
    ends.z[at + lane] = z_end[lane];
  }
}

int glance_and_walk(const BundleStart& from, const Panorama& panorama, Panorama::Rays& rays,
                    int count, RayEnds& ends) {
  const int found = panorama.glance(rays, count);
  for (int at = 0; at < found; at += kLanes) walk(from, rays, at, found - 1, ends);
  return found;
}
