// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_walk.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <limits>

#include "column_hit.hpp"

// No vector leaves the function that it was made in, whatever the compiler fears.
#pragma GCC diagnostic ignored "-Wpsabi"
// Into functions for other processors than the baseline's only what is inlined gets.
#define LTP_INLINE __attribute__((always_inline))

namespace ltp::sensing {
namespace {

constexpr int kCells = 3;  // that a ray is followed here; nearly all that hit have hit by then

/// A register of doubles and what goes with it: the compiler's vectors, one source for all widths.
template <int kLanes>
struct Lanes {
  using Real __attribute__((vector_size(8 * kLanes))) = double;
  using Mask __attribute__((vector_size(8 * kLanes))) = std::int64_t;
  using Index __attribute__((vector_size(4 * kLanes))) = int;
};

/// Follows `kLanes` rays, the ones found from `at` on: what `HeightSurface::cast` does from there,
/// operation by operation, so that the results are the same to the last bit.
template <int kLanes>
LTP_INLINE inline void walk(const BundleStart& from, const Panorama::Rays& rays, int at, int last,
                            RayEnds& ends) {
  using Real = typename Lanes<kLanes>::Real;
  using Mask = typename Lanes<kLanes>::Mask;
  using Index = typename Lanes<kLanes>::Index;
  const auto all = [](double value) LTP_INLINE { return Real{} + value; };
  const auto least = [](const Real& a, const Real& b) LTP_INLINE { return b < a ? b : a; };
  const auto most = [](const Real& a, const Real& b) LTP_INLINE { return a < b ? b : a; };
  const Real none = all(std::numeric_limits<double>::infinity());

  Real dx, dy, dz, slab;
  for (int lane = 0; lane < kLanes; ++lane) {
    const int found = std::min(at + lane, last);
    dx[lane] = rays.x[rays.near[found]];
    dy[lane] = rays.y[rays.near[found]];
    dz[lane] = rays.z[rays.near[found]];
    slab[lane] = rays.slab[found];
  }

  // `TrackAxis`, lane by lane.
  struct Axis {
    Real start;
    Real direction;
    Real step;
    Real inverse;
    Real cells;
    Real first;     // the cell where the track begins
    Mask parallel;
    Mask up;
  };
  const auto axis = [&](const TrackStart& start, const Real& direction) LTP_INLINE {
    const Mask up = direction >= kParallel;
    const Mask down = direction <= -kParallel;
    return Axis{all(start.start),
                direction,
                up ? all(1.0) : (down ? all(-1.0) : all(0.0)),
                start.cell / direction,
                all(start.cells),
                down ? all(start.first_cell(-1)) : all(start.first_cell(1)),
                ~(up | down),
                up};
  };
  const Axis x = axis(from.x, dx);
  const Axis y = axis(from.y, dy);
  const auto time = [](const Axis& a, const Real& edge) LTP_INLINE {
    return (edge - a.start) * a.inverse;
  };
  const auto leave = [&](const Axis& a, const Real& cell) LTP_INLINE {
    return a.parallel ? none : time(a, a.up ? cell + 1.0 : cell);
  };
  const auto enter = [&](const Axis& a, const Real& cell) LTP_INLINE {
    return a.parallel ? -none : time(a, a.up ? cell : cell + 1.0);
  };

  // Into the slab, as if after all the cells before.
  const Mask along_x = (dx < 0.0 ? -dx : dx) >= (dy < 0.0 ? -dy : dy);
  const auto choose = [&](const Axis& a, const Axis& b) LTP_INLINE {
    return Axis{along_x ? a.start : b.start,         along_x ? a.direction : b.direction,
                along_x ? a.step : b.step,           along_x ? a.inverse : b.inverse,
                along_x ? a.cells : b.cells,         along_x ? a.first : b.first,
                along_x ? a.parallel : b.parallel, along_x ? a.up : b.up};
  };
  const Axis ahead = choose(x, y);
  const Axis aside = choose(y, x);
  const Mask moved = slab > 0.0;
  const Real cell_ahead = ahead.first + ahead.step * slab;
  Real t_in = moved ? enter(ahead, cell_ahead) : all(0.0);
  // `TrackAxis::cell_after`: the division guesses, the crossing times decide.
  const Real guess = aside.start + t_in * (aside.direction * from.x.per_cell);
  Real cell_aside = __builtin_convertvector(
      __builtin_convertvector(least(most(guess, all(0.0)), aside.cells - 1.0), Index), Real);
  cell_aside = leave(aside, cell_aside) <= t_in ? cell_aside + aside.step : cell_aside;
  cell_aside = enter(aside, cell_aside) > t_in ? cell_aside - aside.step : cell_aside;
  cell_aside = moved ? cell_aside : aside.first;
  Real i = along_x ? cell_ahead : cell_aside;
  Real j = along_x ? cell_aside : cell_ahead;
  Real face = moved ? (enter(y, j) == t_in ? all(1.0) : all(0.0)) : all(-1.0);

  const Real max_range = all(from.max_range);
  const auto over_raster = [&](const Real& a, const Real& b) LTP_INLINE {
    return (a >= 0.0) & (a < x.cells) & (b >= 0.0) & (b < y.cells);
  };
  Mask going = over_raster(i, j) & (t_in < max_range);
  Mask hit = Mask{};
  Real t_x = leave(x, i);
  Real t_y = leave(y, j);
  Real t_out = t_in;
  Real height = Real{};
  for (int n = 0; n < kCells; ++n) {
    const Real next = least(least(t_x, t_y), max_range);
    t_out = going ? next : t_out;
    const Index cell = __builtin_convertvector(going ? i * y.cells + j : Real{}, Index);
    Real top;
    for (int lane = 0; lane < kLanes; ++lane) top[lane] = from.heights.values().data()[cell[lane]];
    height = going ? top : height;
    const Real lowest = from.origin.z() + (dz < 0.0 ? t_out : t_in) * dz;
    const Mask blocked = going & (lowest < height);
    hit |= blocked;
    going &= ~blocked & (t_out < max_range);
    const Mask cross_x = going & (t_x <= t_out);
    const Mask cross_y = going & (t_y <= t_out);
    i = cross_x ? i + x.step : i;
    j = cross_y ? j + y.step : j;
    t_x = leave(x, i);
    t_y = leave(y, j);
    t_in = going ? t_out : t_in;
    face = going ? (cross_y ? all(1.0) : all(0.0)) : face;
    going &= over_raster(i, j);
  }

  // `HeightSurface::column_hit` and `inside_column`.
  const Mask top_hit = from.origin.z() + t_in * dz >= height;
  const Real to_top = (height - from.origin.z()) / dz;
  const Real range = top_hit ? (to_top < t_in ? t_in : (t_out < to_top ? t_out : to_top)) : t_in;
  const double cell = from.heights.cell();
  const double depth = std::min(kHitDepth, 0.5 * cell);
  const double margin = std::min(kHitMargin, 0.25 * cell);
  face = top_hit ? all(kTopFace) : face;
  const auto within = [&](double raster, const Real& index, const Real& inset,
                          const Real& point) LTP_INLINE {
    const Real low = raster + index * cell;
    return least(most(point, low + inset), low + cell - inset);
  };
  const Real inside_x = within(from.heights.origin().x(), i, face == 0.0 ? all(depth) : all(margin),
                               from.origin.x() + range * dx);
  const Real inside_y = within(from.heights.origin().y(), j, face == 1.0 ? all(depth) : all(margin),
                               from.origin.y() + range * dy);
  const Real inside_z = least(from.origin.z() + range * dz,
                              height - (top_hit ? all(kHitDepth) : all(kHitMargin)));
  const Real result =
      hit & (range < max_range) ? range : (going ? all(RayEnds::kUndecided) : none);
  for (int lane = 0; lane < kLanes; ++lane) {
    ends.range[at + lane] = result[lane];
    ends.x[at + lane] = inside_x[lane];
    ends.y[at + lane] = inside_y[lane];
    ends.z[at + lane] = inside_z[lane];
  }
}

template <int kLanes>
LTP_INLINE inline int glance_and_walk_by(const BundleStart& from, const Panorama& panorama,
                                         Panorama::Rays& rays, int count, RayEnds& ends) {
  const int found = panorama.glance(rays, count);
  for (int at = 0; at < found; at += kLanes) walk<kLanes>(from, rays, at, found - 1, ends);
  return found;
}

using GlanceAndWalk = int(const BundleStart&, const Panorama&, Panorama::Rays&, int, RayEnds&);

int baseline(const BundleStart& from, const Panorama& panorama, Panorama::Rays& rays, int count,
             RayEnds& ends) {
  return glance_and_walk_by<2>(from, panorama, rays, count, ends);
}

#ifdef __x86_64__
__attribute__((target("avx2"))) int avx2(const BundleStart& from, const Panorama& panorama,
                                         Panorama::Rays& rays, int count, RayEnds& ends) {
  return glance_and_walk_by<4>(from, panorama, rays, count, ends);
}

__attribute__((target("avx512f,avx512dq,avx512vl,prefer-vector-width=512"))) int avx512(
    const BundleStart& from, const Panorama& panorama, Panorama::Rays& rays, int count,
    RayEnds& ends) {
  return glance_and_walk_by<8>(from, panorama, rays, count, ends);
}
#else
GlanceAndWalk& avx2 = baseline;
GlanceAndWalk& avx512 = baseline;
#endif

GlanceAndWalk* compiled_for(Vectors vectors) {
  return vectors == Vectors::Avx512 ? avx512 : vectors == Vectors::Avx2 ? avx2 : baseline;
}

std::atomic<Vectors>& in_use() {
  static std::atomic<Vectors> vectors = supported(Vectors::Avx512) ? Vectors::Avx512
                                        : supported(Vectors::Avx2) ? Vectors::Avx2
                                                                   : Vectors::Baseline;
  return vectors;
}

}  // namespace

bool supported(Vectors vectors) {
#ifdef __x86_64__
  if (vectors == Vectors::Avx2) return __builtin_cpu_supports("avx2");
  if (vectors == Vectors::Avx512) {
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
  }
#endif
  return vectors == Vectors::Baseline;
}

Vectors vectors() { return in_use(); }
void use(Vectors vectors) { in_use() = vectors; }

int glance_and_walk(const BundleStart& from, const Panorama& panorama, Panorama::Rays& rays,
                    int count, RayEnds& ends) {
  return compiled_for(vectors())(from, panorama, rays, count, ends);
}

}  // namespace ltp::sensing
