// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Rasters over columns: when one value holds for each, and the means that make it so.
#include "ltp/grid/columns.hpp"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

namespace ltp {
namespace {

Raster random_raster(std::mt19937_64& random, int nx, int ny, const Eigen::Vector2d& origin,
                     double cell, double outside) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Raster::Values values(nx, ny);
  for (Eigen::Index i = 0; i < values.size(); ++i) values.data()[i] = unit(random);
  return Raster(values, origin, cell, outside);
}

TEST(Columns, AreConstantWhereTheyAreCellsOfTheRasterOrPartsOfThem) {
  const Raster::Values flat = Raster::Values::Zero(4, 5);
  Raster::Values blocks = flat;  // parts that are alike, but for the last ones, under no column
  blocks(3, 4) = 1.0;
  const auto constant = [&](double origin, double cell, const Point& column) {
    const GridFrame frame({10, 20, 0}, column, {1, 1, 2});
    return is_constant_on_columns(Raster(blocks, {10 + origin, 20}, cell), frame);
  };
  EXPECT_TRUE(constant(0, 2, {2, 2, 4}));
  EXPECT_TRUE(constant(-4, 2, {2, 2, 4}));
  EXPECT_TRUE(constant(1, 2, {1, 1, 4}));
  EXPECT_TRUE(constant(2, 2, {1, 2, 4}));
  EXPECT_TRUE(constant(0, 0.6, {0.2, 0.3, 4}));
  EXPECT_FALSE(constant(1, 2, {2, 2, 4})) << "half a cell aside";
  EXPECT_TRUE(constant(0, 1, {2, 2, 4})) << "finer, but alike";
  EXPECT_TRUE(constant(1, 1, {2, 3, 4})) << "the same for columns that are no squares";
  EXPECT_FALSE(constant(0, 3, {2, 2, 4}));
  EXPECT_FALSE(constant(0, 2, {2, 3, 4}));
  EXPECT_FALSE(constant(0, 1e-12, {2, 2, 4}));
  EXPECT_FALSE(constant(0, 1e300, {2, 2, 4})) << "too large to tell";
}

TEST(Columns, AreConstantWhereAllPartsOfEachAreAlike) {
  std::mt19937_64 random(2);
  const GridFrame frame({10, 20, 0}, {2, 3, 4}, {4, 3, 2});
  const Raster alike = onto_columns(random_raster(random, 30, 30, {8, 16}, 0.7, 0.0), frame);
  EXPECT_EQ(alike.cell(), 1.0);
  EXPECT_TRUE(is_constant_on_columns(alike, frame));
  for (const int i : {0, 3, 7}) {
    Raster::Values values = alike.values();
    values(i, i) += 1e-3;
    EXPECT_FALSE(is_constant_on_columns(Raster(values, alike.origin(), 1.0), frame));
  }
  // Its edge runs through columns.
  const Raster half(Raster::Values::Ones(3, 3), {10, 20}, 1.0, 0.5);
  EXPECT_FALSE(is_constant_on_columns(half, frame));
}

TEST(Columns, AreFilledBySquares) {
  const auto square = [](double x, double y) {
    return square_of_column(GridFrame({0, 0, 0}, {x, y, 1}, {1, 1, 1}));
  };
  EXPECT_EQ(square(2, 2), 2.0);
  EXPECT_EQ(square(1, 2), 1.0);
  EXPECT_EQ(square(3, 2), 1.0);
  EXPECT_DOUBLE_EQ(*square(0.2, 0.3), 0.1);
  EXPECT_EQ(square(1, 16), 1.0);
  EXPECT_EQ(square(1, 17), std::nullopt);
  EXPECT_EQ(square(1, 1.37), std::nullopt);
}

TEST(Columns, TakeTheMeanOverTheirArea) {
  std::mt19937_64 random(3);
  const double cells[] = {0.37, 0.5, 1.0, 2.0, 3.0, 7.3, 40.0};
  const Point columns[] = {{2, 2, 4}, {1, 2, 3}, {0.1, 0.3, 1}, {0.5, 0.2, 1}};
  for (int i = 0; i < 60; ++i) {
    const double cell = cells[i % 7];
    const Eigen::Vector2d origin(-3.0 + 0.83 * (i % 5), 1.0 - 0.4 * (i % 3));
    const Raster given = random_raster(random, 9, 12, origin, cell, 0.25 * (i % 4));
    const GridFrame frame =
        GridFrame({-1, 2, 0}, columns[i % 4], {6, 5, 2}).shifted(Cell(i % 3, -(i % 2), 0));
    const Raster made = onto_columns(given, frame);
    EXPECT_TRUE(is_constant_on_columns(made, frame));
    EXPECT_EQ(made.outside(), given.outside());
    for (int ix = 0; ix < frame.nx(); ++ix) {
      for (int iy = 0; iy < frame.ny(); ++iy) {
        const Point centre = frame.centre(Cell(ix, iy, 0));
        const Point low = centre - 0.5 * frame.cell();
        // Over strips along y, each an exact integral; between them by many.
        constexpr int kStrips = 4000;
        double mean = 0.0;
        for (int k = 0; k < kStrips; ++k) {
          const double x = low.x() + (k + 0.5) / kStrips * frame.cell().x();
          const Point a(x, low.y(), 0);
          mean += given.integral(a, a + Point(0, frame.cell().y(), 0)) / frame.cell().y();
        }
        EXPECT_NEAR(made.at(centre.x(), centre.y()), mean / kStrips, 1e-3);
      }
    }
  }
}

TEST(Columns, KeepWhatIsConstantOnThem) {
  std::mt19937_64 random(4);
  const GridFrame frame({0, 0, 0}, {2, 2, 4}, {7, 6, 2});
  for (const double cell : {2.0, 4.0, 8.0}) {
    const Raster given = random_raster(random, 3, 2, {-2, 4}, cell, 0.5);
    const Raster made = onto_columns(given, frame);
    for (int ix = 0; ix < frame.nx(); ++ix) {
      for (int iy = 0; iy < frame.ny(); ++iy) {
        const Point centre = frame.centre(Cell(ix, iy, 0));
        EXPECT_DOUBLE_EQ(made(ix, iy), given.at(centre.x(), centre.y()));
      }
    }
  }
}

TEST(Columns, AreMadeOfTheLargestAndTheSmallestCells) {
  const GridFrame frame({0, 0, 0}, {2, 2, 4}, {3, 3, 1});
  const Raster::Values ones = Raster::Values::Ones(2, 2);
  EXPECT_TRUE((onto_columns(Raster(ones, {-1, -1}, 1e300), frame).values() == 1.0).all());
  EXPECT_TRUE((onto_columns(Raster(ones, {0, 0}, 1e-300, 0.5), frame).values() == 0.5).all());
  EXPECT_THROW(
      onto_columns(Raster(ones, {0, 0}, 1.0), GridFrame({0, 0, 0}, {1, 1.37, 2}, {2, 2, 2})),
      std::invalid_argument);
}

}  // namespace
}  // namespace ltp
