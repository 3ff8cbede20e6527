// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The walk along a segment against every box near it, met in exact rational arithmetic.
#include "ltp/grid/ray_walk.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <vector>

namespace ltp {
namespace {

template <int kDim>
using Real = Eigen::Matrix<double, kDim, 1>;
template <int kDim>
using Whole = std::array<int, kDim>;

template <int kDim>
struct Visit {
  Whole<kDim> cell;
  double t_in, t_out;
};

template <int kDim>
std::vector<Visit<kDim>> walk(const Real<kDim>& a, const Real<kDim>& b) {
  std::vector<Visit<kDim>> visits;
  const bool whole =
      walk_segment<kDim>(a, b, [&](const Eigen::Matrix<int, kDim, 1>& cell, double in, double out) {
        Visit<kDim> visit;
        for (int axis = 0; axis < kDim; ++axis) visit.cell[axis] = cell[axis];
        visit.t_in = in;
        visit.t_out = out;
        visits.push_back(visit);
        return visits.size() < 100000;
      });
  EXPECT_TRUE(whole);
  return visits;
}

struct Fraction {
  std::int64_t top = 0;
  std::int64_t bottom = 1;  ///< > 0
  double value() const { return static_cast<double>(top) / static_cast<double>(bottom); }
  bool operator<(const Fraction& other) const { return top * other.bottom < other.top * bottom; }
  bool operator==(const Fraction& other) const { return top * other.bottom == other.top * bottom; }
};

/// Coordinates in the exact tests are whole numbers of eighths: doubles hold them without error.
constexpr int kUnit = 8;

/// The part [in, out] of a segment in a closed box, exactly; empty if they do not meet. Along an
/// axis on which the segment does not move, the box is half open: a point on a face belongs to the
/// upper cell.
template <int kDim>
struct Meeting {
  bool any = false;
  Fraction in, out;
};

template <int kDim>
Meeting<kDim> meet(const Whole<kDim>& a, const Whole<kDim>& b, const Whole<kDim>& cell) {
  Meeting<kDim> meeting{true, {0, 1}, {1, 1}};
  for (int axis = 0; axis < kDim; ++axis) {
    const std::int64_t low = std::int64_t{cell[axis]} * kUnit - a[axis];
    const std::int64_t high = low + kUnit;
    const std::int64_t delta = b[axis] - a[axis];
    if (delta == 0) {
      if (low > 0 || high <= 0) return {};
      continue;
    }
    const Fraction in = delta > 0 ? Fraction{low, delta} : Fraction{-high, -delta};
    const Fraction out = delta > 0 ? Fraction{high, delta} : Fraction{-low, -delta};
    if (meeting.in < in) meeting.in = in;
    if (out < meeting.out) meeting.out = out;
  }
  if (meeting.out < meeting.in) return {};
  return meeting;
}

/// Checks a walk between points of the 1/8 lattice against every box near the segment.
template <int kDim>
void check_exactly(const Whole<kDim>& a, const Whole<kDim>& b) {
  Real<kDim> from, to;
  Whole<kDim> low{}, high{};
  for (int axis = 0; axis < kDim; ++axis) {
    from[axis] = static_cast<double>(a[axis]) / kUnit;
    to[axis] = static_cast<double>(b[axis]) / kUnit;
    low[axis] = static_cast<int>(std::floor(std::min(from[axis], to[axis]))) - 1;
    high[axis] = static_cast<int>(std::floor(std::max(from[axis], to[axis]))) + 1;
  }
  SCOPED_TRACE(::testing::Message() << from.transpose() << " -> " << to.transpose());
  const std::vector<Visit<kDim>> visits = walk<kDim>(from, to);

  // The intervals follow one another from 0 to 1; touched cells have none.
  ASSERT_FALSE(visits.empty());
  double reached = 0.0;
  std::map<Whole<kDim>, std::pair<double, double>> parts;
  for (const Visit<kDim>& visit : visits) {
    ASSERT_EQ(visit.t_in, reached);
    ASSERT_LE(visit.t_in, visit.t_out);
    reached = visit.t_out;
    ASSERT_TRUE(parts.emplace(visit.cell, std::make_pair(visit.t_in, visit.t_out)).second)
        << "a cell is visited twice";
  }
  ASSERT_EQ(reached, 1.0);
  // The ends lie in the first and the last cell; a point on a face belongs to the upper cell.
  for (int axis = 0; axis < kDim; ++axis) {
    ASSERT_EQ(visits.front().cell[axis], std::floor(from[axis]));
    ASSERT_EQ(visits.back().cell[axis], std::floor(to[axis]));
  }

  Whole<kDim> cell = low;
  while (true) {
    const Meeting<kDim> meeting = meet<kDim>(a, b, cell);
    const auto found = parts.find(cell);
    if (found != parts.end()) {
      ASSERT_TRUE(meeting.any) << "a cell that the segment does not meet";
      ASSERT_NEAR(found->second.first, meeting.in.value(), 1e-12);
      ASSERT_NEAR(found->second.second, meeting.out.value(), 1e-12);
      parts.erase(found);
    } else if (meeting.any) {
      // Only a box that is touched by nothing but an end of the segment may be left out.
      ASSERT_TRUE(meeting.in == meeting.out &&
                  (meeting.out == (Fraction{0, 1}) || meeting.in == (Fraction{1, 1})))
          << "left out: " << ::testing::PrintToString(cell);
    }
    int axis = 0;
    while (axis < kDim && ++cell[axis] > high[axis]) {
      cell[axis] = low[axis];
      ++axis;
    }
    if (axis == kDim) break;
  }
  ASSERT_TRUE(parts.empty()) << "a cell far from the segment";
}

TEST(RayWalk, MeetsTheBoxesOfEveryHalfLatticeSegmentInThePlane) {
  int walked = 0;
  for (int ax = 0; ax <= 16; ax += 4) {
    for (int ay = 0; ay <= 16; ay += 4) {
      for (int bx = -20; bx <= 28; bx += 4) {
        for (int by = -20; by <= 28; by += 4) {
          check_exactly<2>({ax, ay}, {bx, by});
          if (HasFatalFailure()) return;
          ++walked;
        }
      }
    }
  }
  EXPECT_EQ(walked, 25 * 169);
}

TEST(RayWalk, MeetsTheBoxesOfEveryHalfLatticeSegmentInSpace) {
  int walked = 0;
  for (int a = 0; a < 27; ++a) {
    for (int b = 0; b < 729; ++b) {
      check_exactly<3>({4 * (a % 3), 4 * (a / 3 % 3), 4 * (a / 9)},
                       {4 * (b % 9) - 16, 4 * (b / 9 % 9) - 16, 4 * (b / 81) - 16});
      if (HasFatalFailure()) return;
      ++walked;
    }
  }
  EXPECT_EQ(walked, 27 * 729);
}

TEST(RayWalk, MeetsTheBoxesOfRandomSegmentsOfEighths) {
  std::mt19937_64 random(1);
  const auto number = [&](int span) {
    // Faces and halves come often.
    const int grain = std::array<int, 4>{1, 2, 4, 8}[random() % 4];
    return (static_cast<int>(random() % (2 * span + 1)) - span) / grain * grain;
  };
  for (int i = 0; i < 4000; ++i) {
    const int span = i % 10 == 0 ? 100 : 40;
    check_exactly<2>({number(span), number(span)}, {number(span), number(span)});
    check_exactly<3>({number(30), number(30), number(30)}, {number(30), number(30), number(30)});
    if (HasFatalFailure()) return;
  }
}

/// What holds for any segment, whatever its numbers: facts with the tie distance as tolerance.
template <int kDim>
void check_roughly(const Real<kDim>& a, const Real<kDim>& b) {
  SCOPED_TRACE(::testing::Message() << a.transpose() << " -> " << b.transpose());
  const std::vector<Visit<kDim>> visits = walk<kDim>(a, b);
  const double slack = 2.0 * kWalkTie + 1e-15 * (a.norm() + b.norm());
  double reached = 0.0;
  std::set<Whole<kDim>> seen;
  for (const Visit<kDim>& visit : visits) {
    ASSERT_EQ(visit.t_in, reached);
    ASSERT_LE(visit.t_in, visit.t_out);
    reached = visit.t_out;
    for (const double t : {visit.t_in, visit.t_out}) {
      const Real<kDim> point = a + t * (b - a);
      for (int axis = 0; axis < kDim; ++axis) {
        ASSERT_GE(point[axis], visit.cell[axis] - slack);
        ASSERT_LE(point[axis], visit.cell[axis] + 1 + slack);
      }
    }
    seen.insert(visit.cell);
  }
  ASSERT_EQ(reached, 1.0);
  for (int axis = 0; axis < kDim; ++axis) {
    ASSERT_EQ(visits.front().cell[axis], std::floor(a[axis]));
    ASSERT_EQ(visits.back().cell[axis], std::floor(b[axis]));
  }
  // Visited cells hang together by faces: nothing slips through an edge or a corner unseen.
  std::set<Whole<kDim>> chained = {visits.front().cell};
  std::vector<Whole<kDim>> open = {visits.front().cell};
  while (!open.empty()) {
    const Whole<kDim> cell = open.back();
    open.pop_back();
    for (int axis = 0; axis < kDim; ++axis) {
      for (const int step : {-1, 1}) {
        Whole<kDim> next = cell;
        next[axis] += step;
        if (seen.count(next) && chained.insert(next).second) open.push_back(next);
      }
    }
  }
  ASSERT_EQ(chained.size(), seen.size());
  // Whatever lies deeper in a cell than rounding is found in a visited one.
  for (int i = 0; i <= 200; ++i) {
    const Real<kDim> point = a + (i / 200.0) * (b - a);
    Whole<kDim> cell{};
    bool deep = true;
    for (int axis = 0; axis < kDim; ++axis) {
      cell[axis] = static_cast<int>(std::floor(point[axis]));
      deep &= point[axis] - cell[axis] > slack && cell[axis] + 1 - point[axis] > slack;
    }
    ASSERT_TRUE(!deep || seen.count(cell)) << point.transpose();
  }
}

TEST(RayWalk, HoldsTogetherOnRandomSegments) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 3000; ++i) {
    const double spread = std::pow(10.0, static_cast<double>(random() % 5) - 2.0);
    Real<2> a2, b2;
    Real<3> a3, b3;
    for (double* x : {&a2[0], &a2[1], &b2[0], &b2[1]}) *x = spread * normal(random);
    for (double* x : {&a3[0], &a3[1], &a3[2], &b3[0], &b3[1], &b3[2]}) *x = spread * normal(random);
    check_roughly<2>(a2, b2);
    check_roughly<3>(a3, b3);
    if (HasFatalFailure()) return;
  }
}

TEST(RayWalk, HoldsTogetherNextToFacesEdgesAndCorners) {
  // On the lattice, off it by less and by more than the tie distance, and by the smallest numbers.
  const double off[] = {0.0,    1e-16,  1e-13, 9e-10,  1.1e-9,  1e-7,   0.5,    -1e-16,
                        -1e-13, -9e-10, -1e-7, 5e-324, -5e-324, 1e-310, -1e-310};
  const int count = static_cast<int>(std::size(off));
  std::mt19937_64 random(3);
  const auto number = [&] {
    return static_cast<double>(static_cast<int>(random() % 7) - 3) + off[random() % count];
  };
  for (int i = 0; i < 8000; ++i) {
    const Real<3> a(number(), number(), number());
    Real<3> b(number(), number(), number());
    if (i % 3 == 0) b = -a;               // through the corner at the origin
    if (i % 5 == 0) b[i % 3] = a[i % 3];  // along a face, or nearly
    check_roughly<3>(a, b);
    check_roughly<2>(a.head<2>(), b.head<2>());
    if (HasFatalFailure()) return;
  }
}

TEST(RayWalk, SeesACornerThroughRounding) {
  // Segments through a corner whose numbers meet it only to within rounding: all cells round the
  // corner that the walk turns past are seen.
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> unit(0.1, 1.0);
  for (int i = 0; i < 2000; ++i) {
    const int before = 1 + static_cast<int>(random() % 5);
    Real<3> way, corner;
    Whole<3> side{};
    for (int axis = 0; axis < 3; ++axis) {
      way[axis] = (random() % 2 == 0 ? 1.0 : -1.0) * unit(random);
      corner[axis] = static_cast<double>(static_cast<int>(random() % 9) - 4);
      side[axis] = way[axis] > 0.0 ? -1 : 0;  // from here it comes
    }
    const Real<3> a = corner - unit(random) * before * way;
    const Real<3> b = corner + unit(random) * way;
    std::set<Whole<3>> seen;
    for (const Visit<3>& visit : walk<3>(a, b)) seen.insert(visit.cell);
    for (int subset = 0; subset < 8; ++subset) {
      Whole<3> cell{};
      for (int axis = 0; axis < 3; ++axis) {
        cell[axis] = static_cast<int>(corner[axis]) + side[axis];
        if (subset >> axis & 1) cell[axis] += way[axis] > 0.0 ? 1 : -1;
      }
      ASSERT_EQ(seen.count(cell), 1u) << a.transpose() << " -> " << b.transpose();
    }
  }
}

TEST(RayWalk, SharesASegmentBetweenTwoRowsThatItHardlyLeaves) {
  // It slides through a face over many cells: each row gets its own half.
  for (const double depth : {1e-12, 1e-10, 4e-10, 1e-8}) {
    double below = 0.0;
    walk_segment<2>(Real<2>(0.5, 1.0 - depth), Real<2>(10.5, 1.0 + depth),
                    [&](const Eigen::Vector2i& cell, double in, double out) {
                      if (cell.y() == 0) below += out - in;
                      return true;
                    });
    EXPECT_NEAR(below, 0.5, 1e-3) << depth;
  }
}

TEST(RayWalk, ClippedMeetsTheSameCellsOfTheBox) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> around(-40.0, 40.0);
  const Real<3> low(-3, 0, 2);
  const Real<3> high(4, 5, 6);
  const auto cells_in_box = [&](const ClippedSegment<3>& part) {
    std::map<Whole<3>, std::pair<double, double>> cells;
    if (part.empty) return cells;
    walk_segment<3>(part.a, part.b, [&](const Eigen::Vector3i& cell, double in, double out) {
      const Eigen::Array3d lower = cell.cast<double>();
      if ((lower >= low.array()).all() && (lower < high.array()).all()) {
        const double length = part.whole(out) - part.whole(in);
        // Rounding decides about a corner that is just touched.
        if (length > 1e-12)
          cells[{cell.x(), cell.y(), cell.z()}] = {part.whole(in), part.whole(out)};
      }
      return true;
    });
    return cells;
  };
  int met = 0;
  int longest = 0;
  for (int i = 0; i < 20000; ++i) {
    Real<3> a(around(random), around(random), around(random));
    // Half of them through the box, some along its faces.
    const Real<3> aim = low + Real<3>(random() % 8, random() % 6, random() % 5);
    Real<3> b = i % 2 == 0 ? Real<3>(a + 3.0 * (aim - a))
                           : Real<3>(around(random), around(random), around(random));
    if (i % 7 == 0) a[i % 3] = b[i % 3] = aim[i % 3];
    const ClippedSegment<3> part = clip_segment<3>(a, b, low, high);
    const auto whole = cells_in_box({a, b});
    const auto clipped = cells_in_box(part);
    ASSERT_EQ(whole.size(), clipped.size()) << a.transpose() << " -> " << b.transpose();
    for (const auto& [cell, times] : whole) {
      ASSERT_EQ(clipped.count(cell), 1u) << a.transpose() << " -> " << b.transpose();
      ASSERT_NEAR(clipped.at(cell).first, times.first, 1e-12);
      ASSERT_NEAR(clipped.at(cell).second, times.second, 1e-12);
    }
    met += !whole.empty();
    if (!part.empty) longest = std::max(longest, static_cast<int>((part.b - part.a).norm()));
  }
  EXPECT_GT(met, 8000);
  EXPECT_LE(longest, 15) << "what is left to walk is about as long as the box";
}

TEST(RayWalk, StopsWhenItIsTold) {
  const Real<3> a(0.5, 0.5, 0.5);
  const Real<3> b(4.5, 4.5, 4.5);  // through four corners
  const std::size_t all = walk<3>(a, b).size();
  EXPECT_EQ(all, 5u + 4u * 6u);
  for (std::size_t limit = 1; limit <= all; ++limit) {
    std::size_t visited = 0;
    const bool whole = walk_segment<3>(
        a, b, [&](const Eigen::Vector3i&, double, double) { return ++visited < limit; });
    EXPECT_FALSE(whole);
    EXPECT_EQ(visited, limit);
  }
}

TEST(RayWalk, ReportsTheTwoCellsBesideACornerThatItPasses) {
  std::vector<Whole<2>> cells;
  for (const Visit<2>& visit : walk<2>(Real<2>(0.25, 1.75), Real<2>(1.75, 0.25))) {
    cells.push_back(visit.cell);
  }
  const std::vector<Whole<2>> expected = {{0, 1}, {1, 1}, {0, 0}, {1, 0}};
  EXPECT_EQ(cells, expected);
}

TEST(RayWalk, ClipsSegmentsHoweverLong) {
  const Eigen::Vector3d low(0, 0, 0);
  const Eigen::Vector3d high(8, 8, 8);
  for (const double far : {1e3, 1e9, 1e12, 1e17, 1e100, 1e200, 1e300}) {
    for (const double sign : {-1.0, 1.0}) {
      // Through a row, along the diagonal, into a cell, out of it.
      const std::vector<std::array<Eigen::Vector3d, 2>> segments = {
          {Eigen::Vector3d(-sign * far, 5.5, 2.5), Eigen::Vector3d(sign * far, 5.5, 2.5)},
          {Eigen::Vector3d::Constant(-sign * far), Eigen::Vector3d::Constant(sign * far)},
          {Eigen::Vector3d(sign * far, 5.5, 2.5), Eigen::Vector3d(3.5, 5.5, 2.5)},
          {Eigen::Vector3d(3.5, 5.5, 2.5), Eigen::Vector3d(3.5, sign * far, 2.5)}};
      const std::vector<int> least = {8, 8, 4, 3};
      for (std::size_t n = 0; n < segments.size(); ++n) {
        const auto part = clip_segment<3>(segments[n][0], segments[n][1], low, high);
        ASSERT_FALSE(part.empty) << far << " " << n;
        int inside = 0;
        walk_segment<3>(part.a, part.b, [&](const Eigen::Vector3i& cell, double, double) {
          inside += (cell.array() >= 0).all() && (cell.array() < 8).all();
          return true;
        });
        EXPECT_GE(inside, least[n]) << far << " " << n;
      }
      EXPECT_TRUE(clip_segment<3>(Eigen::Vector3d(-sign * far, 15.5, 2.5),
                                  Eigen::Vector3d(sign * far, 15.5, 2.5), low, high)
                      .empty);
    }
  }
}

}  // namespace
}  // namespace ltp
