// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `OccupancyGrid`: bits against a plain set of cells, rolling against rebuilding, and the first
// touch of a path against clipping it at every blocked box.
#include "ltp/grid/occupancy_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <set>
#include <vector>

#include "allocations.hpp"

namespace ltp {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
using Key = std::array<int, 3>;

const int kLevels[] = {1, 2, 5, 63, 64, 65, 127, 128, 129, 200};

GridFrame frame_of(int nx, int ny, int nz) {
  return GridFrame(Point(-4, 7, 2), Point(2, 2, 4), {nx, ny, nz});
}

Cell random_cell(const GridFrame& frame, std::mt19937_64& random) {
  return frame.cell_at(static_cast<std::int64_t>(random() % frame.size()));
}

Path rows(const std::vector<Point>& points) {
  Path path(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    path.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  }
  return path;
}

TEST(OccupancyGrid, RemembersWhatIsSet) {
  std::mt19937_64 random(1);
  for (const int nz : kLevels) {
    const GridFrame frame = frame_of(3, 5, nz);
    OccupancyGrid grid(frame);
    std::set<Key> cells;
    EXPECT_EQ(grid.words_per_column(), (nz + 63) / 64);
    for (int i = 0; i < 400; ++i) {
      const Cell cell = random_cell(frame, random);
      const bool blocked = random() % 3 != 0;
      grid.set(cell, blocked);
      const Key key = {cell.x(), cell.y(), cell.z()};
      if (blocked) {
        cells.insert(key);
      } else {
        cells.erase(key);
      }
    }
    ASSERT_EQ(grid.count(), static_cast<std::int64_t>(cells.size()));
    for (std::int64_t i = 0; i < frame.size(); ++i) {
      const Cell cell = frame.cell_at(i);
      const bool expected = cells.count({cell.x(), cell.y(), cell.z()}) > 0;
      ASSERT_EQ(grid.blocked(cell), expected);
      ASSERT_EQ(grid.blocked_at(frame.centre(cell)), expected);
      ASSERT_EQ(grid.column(cell.x(), cell.y())[cell.z() / 64] >> (cell.z() % 64) & 1u, expected);
    }
    grid.clear();
    EXPECT_EQ(grid.count(), 0);
    EXPECT_TRUE(grid == OccupancyGrid(frame));
  }
}

TEST(OccupancyGrid, IsFreeOutside) {
  OccupancyGrid grid(frame_of(2, 2, 2));
  for (std::int64_t i = 0; i < grid.frame().size(); ++i) grid.set(grid.frame().cell_at(i));
  const Path points = rows({{-4.1, 8, 3},
                            {0, 8, 3},
                            {-3, 8, 10},
                            {kNan, 8, 3},
                            {-3, kInfinity, 3},
                            {-3, 8, -1e300},
                            {-4, 7, 2}});
  bool at_once[7];
  grid.blocked_at(points, at_once);
  for (Eigen::Index i = 0; i < 7; ++i) {
    EXPECT_EQ(grid.blocked_at(points.row(i).transpose()), i == 6) << points.row(i);
    EXPECT_EQ(at_once[i], i == 6) << points.row(i);
  }
}

/// What rolling means, cell by cell.
OccupancyGrid slow_roll(const OccupancyGrid& grid, const Cell& shift) {
  OccupancyGrid rolled(grid.frame().shifted(shift));
  for (std::int64_t i = 0; i < grid.frame().size(); ++i) {
    const Cell cell = grid.frame().cell_at(i);
    const Cell from = cell + shift;
    if (grid.frame().contains(from) && grid.blocked(from)) rolled.set(cell);
  }
  return rolled;
}

TEST(OccupancyGrid, RollsByAnyShift) {
  std::mt19937_64 random(2);
  int rolls = 0;
  for (const int nz : kLevels) {
    for (const auto& [nx, ny] : {std::pair{1, 1}, {4, 3}, {1, 6}, {5, 1}}) {
      const GridFrame frame = frame_of(nx, ny, nz);
      for (int k = 0; k < 60; ++k) {
        OccupancyGrid grid(frame);
        for (std::int64_t i = 0; i < frame.size(); ++i) {
          if (random() % 2 == 0) grid.set(frame.cell_at(i));
        }
        const auto by = [&](int n) {
          return random() % 3 == 0 ? 0 : static_cast<int>(random() % (2 * n + 5)) - n - 2;
        };
        Cell shift(by(nx), by(ny), by(nz));
        if (k == 0) shift = Cell(0, 0, 64);
        if (k == 1) shift = Cell(0, 0, -64);
        if (k == 2) shift = Cell(nx - 1, 1 - ny, 0);
        if (k == 3) shift = Cell(1 - nx, ny - 1, 1 - nz);
        const OccupancyGrid expected = slow_roll(grid, shift);
        const std::int64_t before = test::allocations();
        grid.roll(shift);
        ASSERT_EQ(test::allocations() - before, 0);
        ASSERT_TRUE(grid == expected)
            << "dims " << nx << " " << ny << " " << nz << ", shift " << shift.transpose();
        ++rolls;
      }
    }
  }
  EXPECT_EQ(rolls, 10 * 4 * 60);
}

TEST(OccupancyGrid, ForgetsWhatLeftAndKeepsWorldPositions) {
  OccupancyGrid grid(frame_of(10, 10, 10));
  const Point stays = grid.frame().centre(Cell(5, 5, 5));
  const Point leaves = grid.frame().centre(Cell(0, 5, 5));
  grid.set(Cell(5, 5, 5));
  grid.set(Cell(0, 5, 5));
  grid.roll({1, -2, 3});
  EXPECT_TRUE(grid.blocked_at(stays));
  grid.roll({-1, 2, -3});
  EXPECT_TRUE(grid.blocked_at(stays));
  EXPECT_FALSE(grid.blocked_at(leaves)) << "a cell that re-enters is unknown, never stale";
  EXPECT_TRUE(grid.frame() == frame_of(10, 10, 10));
  EXPECT_EQ(grid.count(), 1);
}

TEST(OccupancyGrid, RollsFarAwayButNotOffTheLattice) {
  constexpr int kMax = std::numeric_limits<int>::max();
  constexpr int kMin = std::numeric_limits<int>::min();
  OccupancyGrid grid(frame_of(3, 3, 3));
  grid.set(Cell(1, 1, 1));
  const OccupancyGrid before = grid;
  for (const Cell& shift : {Cell(kMax, 0, 0), Cell(0, kMin, 0), Cell(0, 0, kMin)}) {
    EXPECT_THROW(grid.roll(shift), std::invalid_argument);
    EXPECT_TRUE(grid == before) << "a refused shift changes nothing";
  }
  grid.roll({0, 0, 999999000});
  EXPECT_EQ(grid.count(), 0);
}

/// Where a segment first meets a box, as a fraction of it; by clipping. Without `ends`, a box does
/// not count that it meets in nothing but its first or its last point.
std::optional<double> meets(const Point& a, const Point& b, const Point& low, const Point& high,
                            bool ends) {
  double in = 0.0;
  double out = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double delta = b[axis] - a[axis];
    if (delta == 0.0) {
      // A point on a face belongs to the upper cell.
      if (a[axis] < low[axis] || a[axis] >= high[axis]) return std::nullopt;
      continue;
    }
    const double first = ((delta > 0.0 ? low : high)[axis] - a[axis]) / delta;
    const double second = ((delta > 0.0 ? high : low)[axis] - a[axis]) / delta;
    in = std::max(in, first);
    out = std::min(out, second);
  }
  if (in > out || (!ends && in == out && (in == 0.0 || in == 1.0))) return std::nullopt;
  return in;
}

/// The first touch of a path with boxes grown by `margin` on all sides.
std::optional<double> slow_first_blocked(const OccupancyGrid& grid, const Path& path, double from,
                                         double margin, bool ends = true) {
  const GridFrame& frame = grid.frame();
  const Point grow = Point::Constant(margin);
  double arc = 0.0;
  for (Eigen::Index i = 1; i < path.rows(); ++i) {
    Point a = path.row(i - 1).transpose();
    const Point b = path.row(i).transpose();
    const double size = (b - a).norm();
    const double skipped = std::clamp(from - arc, 0.0, size);
    if (from <= arc + size) {
      if (skipped > 0.0) a += skipped / size * (b - a);
      double nearest = kInfinity;
      for (std::int64_t c = 0; c < frame.size(); ++c) {
        if (!grid.blocked(frame.cell_at(c))) continue;
        const Point centre = frame.centre(frame.cell_at(c));
        const std::optional<double> t =
            meets(a, b, centre - frame.cell() / 2 - grow, centre + frame.cell() / 2 + grow, ends);
        if (t) nearest = std::min(nearest, arc + skipped + *t * (size - skipped));
      }
      if (nearest < kInfinity) return nearest;
    }
    arc += size;
  }
  return std::nullopt;
}

TEST(OccupancyGrid, PassesTheCellThatIsIgnored) {
  OccupancyGrid grid(GridFrame(Point::Zero(), Point::Ones(), {10, 3, 3}));
  grid.set({2, 1, 1});
  grid.set({6, 1, 1});
  Path path(2, 3);
  path << 0.5, 1.5, 1.5, 9.5, 1.5, 1.5;
  EXPECT_EQ(grid.first_blocked(path), 1.5);
  EXPECT_EQ(grid.first_blocked(path, 0.0, Cell(2, 1, 1)), 5.5);
  EXPECT_EQ(grid.first_blocked(path, 0.0, Cell(6, 1, 1)), 1.5);
  EXPECT_EQ(grid.first_blocked(path, 0.0, Cell(50, 1, 1)), 1.5);
  const Path inside = Point(2.5, 1.5, 1.5).transpose();
  EXPECT_EQ(grid.first_blocked(inside), 0.0);
  EXPECT_FALSE(grid.first_blocked(inside, 0.0, Cell(2, 1, 1)).has_value());
}

TEST(OccupancyGrid, FindsTheFirstTouchOfRandomPaths) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int touched = 0;
  int clear = 0;
  for (int k = 0; k < 1500; ++k) {
    OccupancyGrid grid(GridFrame(Point(0.3, -5, 1), Point(0.7, 2, 1.1), {6, 5, 7}));
    grid.roll({static_cast<int>(random() % 2001) - 1000, static_cast<int>(random() % 11) - 5, -3});
    const GridFrame& frame = grid.frame();
    for (int i = 0; i < 12; ++i) grid.set(random_cell(frame, random));
    Path path(2 + k % 4, 3);
    for (Eigen::Index i = 0; i < path.rows(); ++i) {
      const Point place(1.4 * unit(random) - 0.2, 1.4 * unit(random) - 0.2,
                        1.4 * unit(random) - 0.2);
      path.row(i) =
          (frame.origin() + place.cwiseProduct(frame.upper() - frame.origin())).transpose();
    }
    const double from = k % 3 == 0 ? 6.0 * unit(random) : 0.0;
    const std::optional<double> found = grid.first_blocked(path, from);
    // Boxes a little too small and a little too large bracket the answer.
    const std::optional<double> late = slow_first_blocked(grid, path, from, -1e-9);
    const std::optional<double> early = slow_first_blocked(grid, path, from, 1e-9);
    if (late) {
      ASSERT_TRUE(found);
      ASSERT_LE(*found, *late + 1e-7);
    }
    if (found) {
      ASSERT_TRUE(early);
      ASSERT_GE(*found, *early - 1e-7);
      ASSERT_GE(*found, from - 1e-12);
    }
    ++(found ? touched : clear);
  }
  EXPECT_GT(touched, 300);
  EXPECT_GT(clear, 300);
}

TEST(OccupancyGrid, MeetsFacesEdgesAndCornersLikeExactClipping) {
  // All numbers are halves, so that clipping is exact; corners that are only touched count.
  std::mt19937_64 random(4);
  int touched = 0;
  int clear = 0;
  int between = 0;
  for (int k = 0; k < 6000; ++k) {
    OccupancyGrid grid(GridFrame(Point(-2, -2, -2), Point(1, 1, 1), {4, 4, 4}));
    for (int i = 0; i < 4; ++i) grid.set(random_cell(grid.frame(), random));
    Path path(2, 3);
    for (Eigen::Index i = 0; i < 6; ++i) {
      path.data()[i] = (static_cast<int>(random() % 11) - 5) / 2.0;
    }
    const std::optional<double> found = grid.first_blocked(path);
    // An end on a face belongs to the upper cell, so it need not touch the lower one.
    const std::optional<double> early = slow_first_blocked(grid, path, 0.0, 0.0);
    const std::optional<double> late = slow_first_blocked(grid, path, 0.0, 0.0, false);
    if (late) {
      ASSERT_TRUE(found) << path;
      ASSERT_LE(*found, *late + 1e-12) << path;
    }
    if (found) {
      ASSERT_TRUE(early) << path;
      ASSERT_GE(*found, *early - 1e-12) << path;
    }
    between += early == late;
    ++(found ? touched : clear);
  }
  EXPECT_GT(touched, 1000);
  EXPECT_GT(clear, 1000);
  EXPECT_GT(between, 4000) << "mostly there is only one answer";
}

TEST(OccupancyGrid, LetsNothingThroughASlit) {
  // Two blocks that touch at an edge, and two that touch at a corner.
  OccupancyGrid edge(GridFrame(Point(0, 0, 0), Point(2, 2, 4), {2, 2, 1}));
  edge.set(Cell(0, 0, 0));
  edge.set(Cell(1, 1, 0));
  const std::optional<double> hit = edge.first_blocked(rows({{0.5, 3.5, 2}, {3.5, 0.5, 2}}));
  ASSERT_TRUE(hit);
  EXPECT_NEAR(*hit, 1.5 * std::sqrt(2.0), 1e-9);
  EXPECT_TRUE(edge.first_blocked(rows({{3.5, 0.5, 2}, {0.5, 3.5, 2}})));
  EXPECT_TRUE(edge.first_blocked(rows({{0.5, 3.5, 2}, {2, 2, 2}, {3.5, 0.5, 2}})));

  OccupancyGrid corner(GridFrame(Point(-1, -1, -1), Point(1, 1, 1), {2, 2, 2}));
  for (int i = 0; i < 8; ++i) {
    const Cell cell(i & 1, i >> 1 & 1, i >> 2);
    if (cell != Cell(0, 0, 0) && cell != Cell(1, 1, 1)) corner.set(cell);
  }
  EXPECT_TRUE(corner.first_blocked(rows({{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}})));
  EXPECT_TRUE(corner.first_blocked(rows({{0.5, 0.5, 0.5}, {-0.5, -0.5, -0.5}})));
  // Any one of the six is seen.
  for (int i = 1; i < 7; ++i) {
    OccupancyGrid one(corner.frame());
    one.set(Cell(i & 1, i >> 1 & 1, i >> 2));
    EXPECT_TRUE(one.first_blocked(rows({{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}})));
    EXPECT_TRUE(one.first_blocked(rows({{0.5, 0.5, 0.5}, {-0.5, -0.5, -0.5}})));
  }
}

TEST(OccupancyGrid, AgreesWithItsFrameAboutPointsOnFaces) {
  // Edges and origins that doubles do not hold exactly: a point's cell is a matter of rounding, and
  // a walk must round like the frame does.
  std::mt19937_64 random(5);
  const double edges[] = {0.1, 0.3, 1.0 / 3.0, 0.7};
  int blocked = 0;
  for (int k = 0; k < 4000; ++k) {
    const Point anchor(0.1 * static_cast<int>(random() % 100), -0.3, 12.1);
    const Point edge(edges[random() % 4], edges[random() % 4], edges[random() % 4]);
    OccupancyGrid grid(GridFrame(anchor, edge, {6, 6, 6}));
    grid.roll({static_cast<int>(random() % 2001) - 1000, static_cast<int>(random() % 21) - 10,
               static_cast<int>(random() % 200001) - 100000});
    const GridFrame& frame = grid.frame();
    for (int i = 0; i < 80; ++i) grid.set(random_cell(frame, random));
    Point point = frame.origin();
    for (int axis = 0; axis < 3; ++axis) {
      point[axis] += static_cast<double>(random() % 13) / 2 * edge[axis];
    }
    const bool expected = grid.blocked_at(point);
    ASSERT_EQ(grid.first_blocked(point.transpose()).has_value(), expected);
    ASSERT_EQ(grid.first_blocked(rows({point, point})).has_value(), expected);
    // As the end of a segment inside one cell, too.
    const Point centre = frame.centre(frame.cell_of(point));
    ASSERT_EQ(grid.first_blocked(rows({point, centre})).has_value(), expected);
    blocked += expected;
  }
  EXPECT_GT(blocked, 500);
}

TEST(OccupancyGrid, LooksOnlyBeyondAnArcLength) {
  OccupancyGrid grid(GridFrame(Point(0, 0, 0), Point(1, 1, 1), {10, 1, 1}));
  grid.set(Cell(3, 0, 0));
  const Path path = rows({{0.5, 0.5, 0.5}, {5.5, 0.5, 0.5}, {9.5, 0.5, 0.5}});
  EXPECT_EQ(grid.first_blocked(path), 2.5);
  EXPECT_EQ(grid.first_blocked(path, -5.0), 2.5);
  EXPECT_EQ(grid.first_blocked(path, -kInfinity), 2.5);
  EXPECT_EQ(grid.first_blocked(path, 2.5), 2.5);
  EXPECT_EQ(grid.first_blocked(path, 3.25), 3.25) << "it stands in the cell";
  EXPECT_EQ(grid.first_blocked(path, 3.6), std::nullopt);
  EXPECT_EQ(grid.first_blocked(path, 5.0), std::nullopt);
  EXPECT_EQ(grid.first_blocked(path, 100.0), std::nullopt);
  EXPECT_EQ(grid.first_blocked(path, kInfinity), std::nullopt);
  EXPECT_EQ(grid.first_blocked(rows({{3.5, 0.5, 0.5}})), 0.0);
  EXPECT_EQ(grid.first_blocked(rows({{2.5, 0.5, 0.5}})), std::nullopt);
  EXPECT_EQ(grid.first_blocked(Path(0, 3)), std::nullopt);
}

TEST(OccupancyGrid, WalksOnlyTheWindow) {
  // Beyond it there is nothing to meet, and these would take years or overflow a cell's number.
  OccupancyGrid grid(GridFrame(Point(0, 0, 0), Point(1, 1, 1), {10, 10, 10}));
  grid.set(Cell(4, 5, 5));
  const auto found = grid.first_blocked(rows({{-1e9, 5.5, 5.5}, {1e9, 5.5, 5.5}}));
  ASSERT_TRUE(found);
  EXPECT_NEAR(*found, 1e9 + 4, 1e-3);
  EXPECT_FALSE(grid.first_blocked(rows({{-1e12, 50, 5.5}, {1e12, 50, 5.5}})));
  EXPECT_FALSE(grid.first_blocked(rows({{1e300, 0, 0}, {2e300, 1e300, 0}, {0, 1e300, -1e300}})));
  const double largest = std::numeric_limits<double>::max();
  EXPECT_FALSE(grid.first_blocked(rows({{-largest, 50, 50}, {largest, 50, 50}})));
  const GridFrame tall(Point(0, 0, 0), Point(1, 1, 1), {1, 1, 2000000000});
  EXPECT_FALSE(tall.contains(Point(0, 0, 1.5e9))) << "beyond the lattice";
}

TEST(OccupancyGrid, RefusesAPathThatIsNotFinite) {
  const OccupancyGrid grid(frame_of(3, 3, 3));
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    EXPECT_THROW(grid.first_blocked(rows({{0, 8, 3}, {0, bad, 3}})), std::invalid_argument);
    EXPECT_THROW(grid.first_blocked(rows({{bad, 8, 3}})), std::invalid_argument);
  }
  EXPECT_THROW(grid.first_blocked(rows({{0, 8, 3}, {0, 9, 3}}), kNan), std::invalid_argument);
}

}  // namespace
}  // namespace ltp
