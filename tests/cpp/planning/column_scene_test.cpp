// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `ColumnScene`: what planners see of a priority raster, wherever the window has rolled to.
#include "ltp/planning/column_scene.hpp"

#include <gtest/gtest.h>

#include <random>

#include "ltp/grid/columns.hpp"

namespace ltp {
namespace {

Raster random_raster(std::mt19937_64& random, int nx, int ny, const Eigen::Vector2d& origin,
                     double cell) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Raster::Values values(nx, ny);
  for (Eigen::Index i = 0; i < values.size(); ++i) values.data()[i] = unit(random);
  return Raster(values, origin, cell, 0.125);
}

TEST(ColumnScene, IsThatOfTheWindowWhereverItHasRolledTo) {
  std::mt19937_64 random(1);
  std::uniform_int_distribution<int> step(-60, 60);
  const double cells[] = {0.7, 1.0, 2.0, 3.0, 250.0, 1e300};
  const Point columns[] = {{2, 2, 4}, {1, 2, 3}, {0.5, 0.2, 1}, {1.0, 1.37, 2.0}};
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    const Raster given = random_raster(random, 40, 30, {-11.0 + 0.5 * (i % 3), 3.0}, cells[i % 6]);
    GridFrame frame({-1, 2, 0}, columns[i % 4], {9, 7, 2});
    ColumnScene seen;
    for (int roll = 0; roll < 20; ++roll) {
      const OccupancyGrid grid(frame);
      const Scene scene = seen.of({grid, given});
      const bool apart = !is_constant_on_columns(given, frame) && square_of_column(frame);
      if (!seen.resampled()) {
        EXPECT_FALSE(apart);
        EXPECT_EQ(&scene.priority, &given);
      } else {
        EXPECT_TRUE(is_constant_on_columns(scene.priority, frame));
        const Raster slow = onto_columns(given, frame);
        for (int ix = 0; ix < frame.nx(); ++ix) {
          for (int iy = 0; iy < frame.ny(); ++iy) {
            const Point centre = frame.centre(Cell(ix, iy, 0));
            ASSERT_NEAR(scene.priority.at(centre.x(), centre.y()), slow.at(centre.x(), centre.y()),
                        1e-9);
          }
        }
      }
      frame = frame.shifted(Cell(step(random), step(random), 0));
    }
  }
}

TEST(ColumnScene, IsKeptForOneRasterAndOneWindow) {
  std::mt19937_64 random(2);
  const Raster given = random_raster(random, 300, 200, {0.5, 0.5}, 1.0);
  const OccupancyGrid grid(GridFrame({0, 0, 0}, {2, 2, 4}, {40, 40, 2}));
  ColumnScene seen;
  const std::uint64_t id = seen.of({grid, given}).priority.id();
  EXPECT_NE(id, given.id());
  EXPECT_EQ(seen.of({grid, given}).priority.id(), id);
  const Raster another = random_raster(random, 300, 200, {0.5, 0.5}, 1.0);
  EXPECT_NE(seen.of({grid, another}).priority.id(), id);
}

TEST(ColumnScene, TakesARasterWithoutEnd) {
  const Raster endless(Raster::Values::Random(2, 2).abs(), {0.3, 0.3}, 1e300);
  const GridFrame frame({0, 0, 0}, {1, 1, 1}, {1000, 1000, 1});
  ColumnScene seen;
  const Scene scene = seen.of({OccupancyGrid(frame), endless});
  EXPECT_EQ(scene.priority.at(500, 500), endless.at(500, 500));
}

}  // namespace
}  // namespace ltp
