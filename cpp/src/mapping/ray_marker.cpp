// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/mapping/ray_marker.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "ltp/grid/bits.hpp"
#include "ltp/grid/ray_walk.hpp"

namespace ltp {
namespace {

// Times on the way, in [0, 1], are counted in units of 2^-58, levels in units of 2^-32.
constexpr double kTime = 0x1p58;
constexpr double kLevel = 0x1p32;
constexpr std::int64_t kNever = std::int64_t{1} << 62;
/// Faces met within this much of the way [cells] are in doubt: a hundred times what `walk_segment`
/// takes for one and the same place, and more than rounding amounts to here.
constexpr double kDoubt = 100.0 * kWalkTie;
/// Crossing a face on a shorter way could take longer than we can count, and on a longer one
/// rounding adds up to more than a hundredth of the doubt [cells].
constexpr double kShort = 0.25;
constexpr double kLong = 1e4;

/// The way along one axis.
struct Along {
  int from;         ///< first cell, on the lattice
  int to;           ///< last cell
  double delta;     ///< [cells]
  double distance;  ///< to the first face [cells]
  bool on_face;     ///< the way begins on a face and leaves by it

  Along(double a, double b)
      : from(static_cast<int>(std::floor(a))), to(static_cast<int>(std::floor(b))), delta(b - a) {
    on_face = delta < 0.0 && a == from;  // a point on a face belongs to the upper cell
    if (on_face) --from;
    distance = delta > 0.0 ? from + 1 - a : a - from;
  }
  int crossings() const { return std::abs(to - from); }
  int step() const { return delta > 0.0 ? 1 : -1; }
};

/// When the way crosses the faces of one axis.
struct Clock {
  std::int64_t next = kNever;
  std::int64_t period = 0;

  explicit Clock(const Along& way) {
    if (way.crossings() == 0) return;
    const double cells_to_time = kTime / std::abs(way.delta);
    next = static_cast<std::int64_t>(way.distance * cells_to_time);
    period = static_cast<std::int64_t>(cells_to_time);
  }
};

__extension__ using Wide = __int128;

std::int64_t upper_half(std::int64_t a, std::int64_t b) {
  return static_cast<std::int64_t>(static_cast<Wide>(a) * b >> 64);
}

inline void set_between(std::uint64_t* column, int low, int high) {
  if (low >> 6 == high >> 6) {
    column[low >> 6] |= ~std::uint64_t{0} >> (63 - (high - low)) << (low & 63);
    return;
  }
  for (int w = low >> 6; w <= high >> 6; ++w) column[w] |= bits_between(w, low, high);
}

/// Does it fast, from column to column, on integers. False where faces are met so close to each
/// other that rounding could matter; all cells set by then are right.
bool mark_columns(const Point& a, const Point& b, const Cell& first, OccupancyGrid& passed) {
  const Along x(a.x(), b.x());
  const Along y(a.y(), b.y());
  const Along z(a.z(), b.z());
  bool on_face = false;
  bool close = false;
  for (const Along* way : {&x, &y, &z}) {
    on_face |= way->on_face;
    if (way->crossings() == 0) continue;
    if (!(std::abs(way->delta) > kShort && std::abs(way->delta) < kLong)) return false;
    close |= way->distance < kDoubt;
  }
  if (on_face && close) return false;

  const GridFrame& frame = passed.frame();
  if (!frame.contains(Cell(Cell(x.from, y.from, z.from) - first))) return false;
  std::uint64_t* column = passed.column(x.from - first.x(), y.from - first.y());
  const std::ptrdiff_t words_x = std::ptrdiff_t{x.step()} * frame.ny() * passed.words_per_column();
  const std::ptrdiff_t words_y = std::ptrdiff_t{y.step()} * passed.words_per_column();
  Clock at_x(x);
  Clock at_y(y);
  const double way = std::max(std::abs(x.delta), std::abs(y.delta));
  const std::int64_t tie = static_cast<std::int64_t>(kDoubt / std::max(way, kShort) * kTime);

  // On a way that stays on its level, height does not matter.
  const bool level = z.crossings() == 0;
  const std::int64_t start = (std::int64_t{z.from - first.z()} << 32) +
                             static_cast<std::int64_t>(kLevel * (level ? 0.5 : a.z() - z.from));
  const std::int64_t climb = level ? 0 : static_cast<std::int64_t>(z.delta * 0x1p38);
  constexpr std::int64_t kNear = static_cast<std::int64_t>(kDoubt * kLevel) + 4;

  int here = z.from - first.z();
  for (int left = x.crossings() + y.crossings(); left > 0; --left) {
    const std::int64_t apart = at_x.next - at_y.next;
    const std::int64_t x_first = apart >> 63;  // all bits or none
    const std::int64_t time = std::min(at_x.next, at_y.next);
    const std::int64_t height = start + upper_half(time, climb);
    const auto over_face = static_cast<std::uint32_t>(height + kNear);
    if (over_face < 2 * kNear || static_cast<std::uint64_t>(apart + tie) < 2ull * tie) return false;
    const int there = static_cast<int>(height >> 32);
    set_between(column, std::min(here, there), std::max(here, there));
    here = there;
    column += words_y + ((words_x - words_y) & x_first);
    at_x.next += at_x.period & x_first;
    at_y.next += at_y.period & ~x_first;
  }
  const int last = z.to - first.z();
  const int low = here < last ? here : last + 1;
  const int high = here < last ? last - 1 : here;
  if (low <= high) set_between(column, low, high);
  return true;
}

}  // namespace

void mark_passed(const Point& a, const Point& b, const Cell& first, OccupancyGrid& passed) {
  if (mark_columns(a, b, first, passed)) return;
  const GridFrame& frame = passed.frame();
  const Cell last = b.array().floor().cast<int>().matrix() - first;
  walk_segment<3>(a, b, [&](const Cell& lattice, double t_in, double t_out) {
    const Cell cell = lattice - first;
    if (t_out > t_in && cell != last && frame.contains(cell)) passed.set(cell);
    return true;
  });
}

}  // namespace ltp
