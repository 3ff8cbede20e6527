// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The walk itself, for registers of `kLanes` doubles. Included once for each kind of processor,
// into a namespace of its own, with `LTP_LANES` for how many those are.

constexpr int kLanes = LTP_LANES;
/// A register of doubles and one of integers: the compiler's vectors, one source for all widths. A
/// comparison goes straight into a choice, `a < b ? c : d`; on its own GCC 12 takes it to pieces.
using Real __attribute__((vector_size(8 * kLanes))) = double;
using Whole __attribute__((vector_size(8 * kLanes))) = std::int64_t;

#if LTP_LANES == 8
LTP_INLINE inline bool any(const Whole& flags) {
  return _mm512_test_epi64_mask((__m512i)flags, (__m512i)flags) != 0;
}
LTP_INLINE inline Whole gather(const std::uint64_t* words, const Whole& index) {
  return (Whole)_mm512_mask_i64gather_epi64(_mm512_setzero_si512(), 0xff, (__m512i)index, words, 8);
}
#elif LTP_LANES == 4
LTP_INLINE inline bool any(const Whole& flags) {
  return _mm256_testz_si256((__m256i)flags, (__m256i)flags) == 0;
}
LTP_INLINE inline Whole gather(const std::uint64_t* words, const Whole& index) {
  return (Whole)_mm256_i64gather_epi64((const long long*)words, (__m256i)index, 8);
}
#else
LTP_INLINE inline bool any(const Whole& flags) { return flags[0] != 0; }
LTP_INLINE inline Whole gather(const std::uint64_t* words, const Whole& index) {
  return Whole{static_cast<std::int64_t>(words[index[0]])};
}
#endif

// As in `VoxelBricks`.
LTP_INLINE inline Whole child_of(const Whole& x, const Whole& y, const Whole& z, int shift) {
  return (x >> shift & 7) << 6 | (y >> shift & 7) << 3 | (z >> shift & 7);
}
LTP_INLINE inline Whole word_of(const Whole& x, const Whole& y, const Whole& z) {
  return (x >> 2 & 1) << 2 | (y >> 2 & 1) << 1 | (z >> 2 & 1);
}
LTP_INLINE inline Whole bit_of(const Whole& x, const Whole& y, const Whole& z) {
  return (x & 3) << 4 | (y & 3) << 2 | (z & 3);
}

constexpr double kWholeDouble = 0x1p52;  // from here on a double's lowest bits are an integer's
constexpr std::int64_t kWholeBits = 0x4330000000000000;  // of that double

/// One axis of the rays. Where they are is told by the plane where they leave their voxel, counted
/// from the box's lowest corner. A parallel ray stays between two planes that it reaches at
/// infinity.
struct Axis {
  LTP_INLINE Axis() = default;
  /// @param from   where the rays start, and the box ends [voxels]
  /// @param below  the box's lowest voxel, counted from the root's corner
  /// @param edge   of a voxel [m], and its inverse
  LTP_INLINE Axis(double from, double end, double below, double edge, double per_edge,
                  const Real& direction, int axis) {
    const Real zero = {};
    const Real one = zero + 1.0;
    const Whole none = {};
    const Real ahead = direction <= -kStandsStill ? zero : one;
    step = direction <= -kStandsStill ? -one : one;
    back = direction <= -kStandsStill ? none - 1 : none;
    margin = 16 * axis + 8 + (back & -8);
    const Real size = direction < 0.0 ? -direction : direction;
    rate = size >= kStandsStill ? direction * per_edge : zero;
    inverse =
        size >= kStandsStill ? edge / direction : zero + std::numeric_limits<double>::infinity();
    start = size >= kStandsStill ? zero + from : zero + (std::floor(from) + 0.5);
    bias = kWholeDouble + below - ahead;
    guess = start - 0.5 + ahead - kLag * step;
    guess = size >= kStandsStill ? guess : start + 0.5;
    first = step < 0.0 ? zero + (end - 1.0) : one;
    last = step < 0.0 ? zero : zero + end;
  }

  /// When the rays cross a plane [m].
  LTP_INLINE Real time(const Real& plane) const { return (plane - start) * inverse; }
  /// The planes where the rays leave the voxels where they are right after a time. A guess that
  /// lags behind a little, rounded by adding and taking away what leaves no fraction; the crossing
  /// time decides whether it lags by a voxel.
  LTP_INLINE Real after(const Real& t) const {
    constexpr double kNoFraction = 0x1.8p52;
    const Real plane = (guess + t * rate + kNoFraction) - kNoFraction;
    return time(plane) <= t ? plane + step : plane;
  }
  /// The voxel left at a plane, counted from the root's corner.
  LTP_INLINE Whole voxel(const Real& plane) const {
    const Real biased = plane + bias;
    return (Whole)biased ^ kWholeBits;
  }
  /// The plane where the rays leave the cube of edge `inner` + 1 about a voxel, `reach` farther on.
  LTP_INLINE Real plane(const Whole& voxel, const Whole& inner, const Whole& reach) const {
    const Whole end = ((voxel ^ back) | inner) + reach;
    const Real biased = (Real)(end ^ (back ^ kWholeBits));
    return biased - bias;
  }

  static constexpr double kLag = 0x1p-10;  // far above rounding; `BrickStart::near`
  Real start;                              ///< [voxels]
  Real rate;                               ///< [voxels/m]
  Real inverse;                            ///< [m/voxel]
  Real step;                               ///< from plane to plane
  Real guess;
  Real bias;
  Whole back;    ///< all bits set where planes go down
  Whole margin;  ///< where in a word it says how far the empty box reaches
  Real first;    ///< plane at the end of the first and the last voxel in the box
  Real last;
};

LTP_INLINE inline Real least(const Real& a, const Real& b, const Real& c) {
  const Real ab = b < a ? b : a;
  return c < ab ? c : ab;
}
LTP_INLINE inline Real most(const Real& a, const Real& b, const Real& c) {
  const Real ab = a < b ? b : a;
  return ab < c ? c : ab;
}

/// `kLanes` rays on their way.
struct Walk {
  LTP_INLINE void begin(const BrickStart& from, const BrickRays& rays, int first_ray) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const VoxelBricks& bricks = from.bricks;
    const Real zero = {};
    const Whole none = {};
    at = first_ray;
    const auto axis_of = [&](const double* component, int axis) LTP_INLINE {
      Real direction;
      std::memcpy(&direction, component, sizeof(direction));
      return Axis(from.start[axis], bricks.dims()[axis], bricks.offset()[axis], from.edge,
                  from.per_edge, direction, axis);
    };
    x = axis_of(&rays.x[at], 0);
    y = axis_of(&rays.y[at], 1);
    z = axis_of(&rays.z[at], 2);
    const Real across = least(x.step * x.inverse, y.step * y.inverse, z.step * z.inverse);
    tie = kWalkTie * across;
    leave = least(x.time(x.last), y.time(y.last), z.time(z.last));
    leave = from.max_range < leave ? zero + from.max_range : leave;
    Real t = most(x.time(x.first - x.step), y.time(y.first - y.step), z.time(z.first - z.step));
    t = t > 0.0 ? t : zero;
    going = t < leave ? none - 1 : none;
    t = t < leave ? t : zero;
    const auto within = [&](const Axis& axis) LTP_INLINE {  // whatever the numbers
      const Real plane = axis.after(t);
      const Real end = (plane - axis.first) * axis.step >= 0.0 ? plane : axis.first;
      return (axis.last - end) * axis.step >= 0.0 ? end : axis.last;
    };
    i = within(x);
    j = within(y);
    k = within(z);
    range = zero + kInfinity;
  }

  /// On through one cube, or to a hit.
  LTP_INLINE void go_on(const VoxelBricks& bricks) {
    const Whole none = {};
    const Whole a = x.voxel(i);
    const Whole b = y.voxel(j);
    const Whole c = z.voxel(k);
    int shift = bricks.shift();
    Whole word = gather(bricks.root(), a >> shift << bricks.x_shift() |
                                           b >> shift << bricks.y_shift() | c >> shift);
    Whole inner = none + ((std::int64_t{1} << shift) - 1);
    Whole scale = none + (shift - VoxelBricks::kBrickShift);
    const bool deep = shift > VoxelBricks::kBrickShift;
    while (shift > VoxelBricks::kBrickShift) {
      shift -= VoxelBricks::kBrickShift;
      const Whole down = word >> 63;
      const Whole child = (word & kNumber) * VoxelBricks::kCells + child_of(a, b, c, shift);
      const Whole found = gather(bricks.nodes(), child & down);
      word = down != 0 ? found : word;
      inner = down != 0 ? none + ((std::int64_t{1} << shift) - 1) : inner;
      scale = down != 0 ? none + (shift - VoxelBricks::kBrickShift) : scale;
    }
    // In a brick: 64 voxels a word. Where they are all free, and where 8 are, all are passed.
    const Whole in_brick = word >> 63;
    const Whole part = (word & kNumber) * VoxelBricks::kWords + word_of(a, b, c);
    const Whole bits = gather(bricks.bricks(), part & in_brick);
    const Whole bit = bit_of(a, b, c);
    const Whole eight = bits >> (bit & 0b101010) & 0x330033;
    Whole free = eight == 0 ? none + 1 : none;
    free = bits == 0 ? none + 3 : free;
    inner = in_brick != 0 ? free : inner;
    const Whole full = ~in_brick & word << 1 >> 63;
    inner &= ~full;
    const Whole blocked = ((bits >> bit & 1 & in_brick) | full) & going;
    if (any(blocked)) {
      const Real t_in = most(x.time(i - x.step), y.time(j - y.step), z.time(k - z.step));
      const Real t_out = least(x.time(i), y.time(j), z.time(k));
      const Real entered = t_in > 0.0 ? t_in : Real{};
      const Whole inside = t_out - entered > tie ? none - 1 : none;
      const Whole hit = blocked != 0 ? inside : none;
      range = hit != 0 ? entered : range;
      going &= ~hit;
    }
    const auto reach = [&](const Axis& axis) LTP_INLINE {
      const Whole eighths = word >> axis.margin & 255 & ~in_brick;
      return deep ? eighths << scale : eighths;
    };
    const Real t = least(x.time(x.plane(a, inner, reach(x))), y.time(y.plane(b, inner, reach(y))),
                         z.time(z.plane(c, inner, reach(z))));
    going = t < leave ? going : none;
    i = going != 0 ? x.after(t) : i;
    j = going != 0 ? y.after(t) : j;
    k = going != 0 ? z.after(t) : k;
  }

  /// Writes what became of the rays.
  LTP_INLINE void end(const BrickStart& from, BrickRays& rays) const {
    const Real none = Real{} - 1.0;
    // The face by which a ray came in; none where it started inside.
    const Real at_x = x.time(i - x.step);
    const Real at_y = y.time(j - y.step);
    const Real at_z = z.time(k - z.step);
    Real face = at_x >= 0.0 ? none + 1.0 : none;
    const Real at_xy = at_x < 0.0 ? Real{} : at_x;
    face = at_y >= at_xy ? none + 2.0 : face;
    face = at_z >= (at_y < at_xy ? at_xy : at_y) ? none + 3.0 : face;
    const auto inside = [&](const Axis& axis, int number, const Real& plane,
                            const double* component) LTP_INLINE {
      Real direction;
      std::memcpy(&direction, component, sizeof(direction));
      const Real voxel = plane + axis.bias - (kWholeDouble + from.bricks.offset()[number]);
      const Real low = from.corner[number] + voxel * from.edge;
      const Real depth = face == number ? Real{} + std::min(kHitDepth, 0.5 * from.edge)
                                        : Real{} + std::min(kHitMargin, 0.25 * from.edge);
      Real point = from.origin[number] + range * direction;
      point = point < low + depth ? low + depth : point;
      return low + from.edge - depth < point ? low + from.edge - depth : point;
    };
    const Real px = inside(x, 0, i, &rays.x[at]);
    const Real py = inside(y, 1, j, &rays.y[at]);
    const Real pz = inside(z, 2, k, &rays.z[at]);
    std::memcpy(&rays.range[at], &range, sizeof(range));
    std::memcpy(&rays.inside_x[at], &px, sizeof(px));
    std::memcpy(&rays.inside_y[at], &py, sizeof(py));
    std::memcpy(&rays.inside_z[at], &pz, sizeof(pz));
  }

  static constexpr auto kNumber = static_cast<std::int64_t>(VoxelBricks::kNumber);
  int at;  ///< the first one's number
  Axis x, y, z;
  Real i, j, k;  ///< planes where they leave their voxels
  Real leave;    ///< when they leave the box, or have come far enough [m]
  Real tie;      ///< what counts as no way at all [m]
  Real range;    ///< as in `BrickRays`
  Whole going;   ///< all bits set where a ray is still on its way
};

void walk_all(const BrickStart& start, BrickRays& rays, int count) {
  // Two at a time, in turn: one computes while the other waits for memory.
  constexpr int kTurns = kLanes > 1 ? 2 : 1;
  std::array<Walk, kTurns> walks;
  int next = 0;
  int on_the_way = 0;
  for (Walk& walk : walks) {
    walk.at = -1;
    walk.going = Whole{};
    if (next >= count) continue;
    walk.begin(start, rays, next);
    next += kLanes;
    ++on_the_way;
  }
  while (on_the_way > 0) {
    for (Walk& walk : walks) {
      if (walk.at >= 0) walk.go_on(start.bricks);
    }
    for (Walk& walk : walks) {
      if (any(walk.going) || walk.at < 0) continue;
      walk.end(start, rays);
      walk.at = -1;
      --on_the_way;
      if (next >= count) continue;
      walk.begin(start, rays, next);
      next += kLanes;
      ++on_the_way;
    }
  }
}
