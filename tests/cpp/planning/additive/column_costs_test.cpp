// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The cost over columns against a textbook's Dijkstra, below every cost in space, and the same
// however it came about.
#include "planning/additive/column_costs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <random>
#include <utility>
#include <vector>

namespace ltp::planning {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A query over ground of random priority, and what the field is asked for.
struct Instance {
  OccupancyGrid grid;
  Raster priority;
  Query query;
  AdditiveCost cost;
  double longest = kInfinity;
  int few = ColumnCosts::kFewLevels;

  Scene scene() const { return {grid, priority}; }
  Problem problem() const { return Problem(scene(), query, {}); }
};

/// @param percent  of the cells that are blocked
Instance random_instance(std::mt19937_64& random, const std::array<int, 3>& dims,
                         unsigned percent) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const Point edges[] = {{2, 2, 4}, {1, 3, 2}, {3, 2, 1}};
  const GridFrame frame(Point(-7, 3, 0), edges[random() % 3], dims);
  // Not aligned with the columns, and wider than the window.
  Raster::Values values(30, 30);
  for (Eigen::Index i = 0; i < values.size(); ++i) values.data()[i] = unit(random);
  // Where a metre over good ground costs next to nothing, columns of one bucket better each other.
  const bool nearly_free = random() % 2 == 0;
  if (nearly_free) values = 1.0 - 0.05 * values;
  Instance made{OccupancyGrid(frame), Raster(values, {-19, -12}, 1.7, 0.4), {}, {}};
  const auto anywhere = [&]() -> Point {
    const Point share(unit(random), unit(random), unit(random));
    return frame.origin() + share.cwiseProduct(frame.upper() - frame.origin());
  };
  made.query.start = anywhere();
  made.query.goal = anywhere();
  made.query.band = {8.0 * unit(random), 8.0 * unit(random)};
  made.cost = {nearly_free ? 1.001 : 1.01 + unit(random), 1.0};
  for (std::int64_t i = 0; i < frame.size(); ++i) {
    made.grid.set(frame.cell_at(i), random() % 100 < percent);
  }
  made.grid.set(frame.cell_of(made.query.start), false);
  made.grid.set(frame.cell_of(made.query.goal), false);
  return made;
}

bool few_levels(const Instance& made, const Problem& problem) {
  return problem.levels.highest - problem.levels.lowest < made.few;
}

/// Where no path leads: outside of all windows that hold the goal, off the ellipse, or blocked in
/// all of a few levels.
bool is_wall(const Instance& made, const Problem& problem, int ix, int iy) {
  const GridFrame& frame = made.grid.frame();
  if (std::abs(ix - problem.goal.x()) >= frame.nx()) return true;
  if (std::abs(iy - problem.goal.y()) >= frame.ny()) return true;
  const Eigen::Vector2d centre = frame.centre(Cell(ix, iy, 0)).head<2>();
  const double by_here =
      (centre - made.query.start.head<2>()).norm() + (centre - made.query.goal.head<2>()).norm();
  const bool at_start = ix == problem.start.x() && iy == problem.start.y();
  if (!at_start && by_here > made.longest) return true;
  if (!few_levels(made, problem)) return false;
  for (int iz = problem.levels.lowest; iz <= problem.levels.highest; ++iz) {
    if (frame.contains(Cell(ix, iy, iz)) && !made.grid.blocked(Cell(ix, iy, iz))) return false;
  }
  return true;
}

double straight(const Instance& made, const Point& from, const Point& to) {
  return made.cost((to - from).norm(), made.priority.integral(from, to));
}

/// Of a step between the centres of two columns `length` apart [m].
double step_cost(const Instance& made, const Cell& from, const Cell& to, double length) {
  const GridFrame& frame = made.grid.frame();
  const auto at = [&](const Cell& cell) {
    const Point centre = frame.centre(cell);
    return made.priority.at(centre.x(), centre.y());
  };
  return made.cost(length, length * 0.5 * (at(from) + at(to)));
}

/// Costs over the columns as textbooks have it; those of the window, y fastest.
std::vector<double> slow_field(const Instance& made) {
  const GridFrame& frame = made.grid.frame();
  const Problem problem = made.problem();
  const int width = 2 * frame.nx() + 1;
  const int height = 2 * frame.ny() + 1;
  const Cell corner = problem.goal - Cell(frame.nx(), frame.ny(), 0);
  const auto number = [&](const Cell& cell) {
    return (cell.x() - corner.x()) * height + cell.y() - corner.y();
  };
  std::vector<double> costs(static_cast<std::size_t>(width) * height, kInfinity);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto offer = [&](const Cell& cell, double cost) {
    double& mine = costs[static_cast<std::size_t>(number(cell))];
    if (cost >= mine || is_wall(made, problem, cell.x(), cell.y())) return;
    mine = cost;
    open.push({cost, number(cell)});
  };
  for (const Step& step : steps()) {
    const Cell from = problem.goal + step.offset();
    if (from.z() < problem.levels.lowest || from.z() > problem.levels.highest) continue;
    offer(from, straight(made, problem.vertex(from), made.query.goal));
  }
  while (!open.empty()) {
    const auto [cost, index] = open.top();
    open.pop();
    if (cost > costs[static_cast<std::size_t>(index)]) continue;
    const Cell cell = corner + Cell(index / height, index % height, 0);
    for (const Step& step : steps()) {
      if (step.dz != 0) continue;
      const bool squeezes = is_wall(made, problem, cell.x() + step.dx, cell.y()) ||
                            is_wall(made, problem, cell.x(), cell.y() + step.dy);
      if (squeezes && step.dx != 0 && step.dy != 0) continue;
      const Cell next = cell + Cell(step.dx, step.dy, 0);
      const double length = (frame.centre(next) - frame.centre(cell)).norm();
      offer(next, cost + step_cost(made, cell, next, length));
    }
  }
  std::vector<double> window;
  for (int ix = 0; ix < frame.nx(); ++ix) {
    for (int iy = 0; iy < frame.ny(); ++iy) {
      window.push_back(costs[static_cast<std::size_t>(number(Cell(ix, iy, corner.z())))]);
    }
  }
  return window;
}

void aim(ColumnCosts& field, const Instance& made) {
  field.aim(made.problem(), made.cost, made.longest, made.few);
}

/// Asks for every column of the window, in a random order.
void expect_field(ColumnCosts& field, const Instance& made, const std::vector<double>& expected,
                  std::mt19937_64& random) {
  const int ny = made.grid.frame().ny();
  std::vector<int> order(expected.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  std::shuffle(order.begin(), order.end(), random);
  for (const int i : order) {
    const double cost = field(i / ny, i % ny);
    if (expected[static_cast<std::size_t>(i)] == kInfinity) {
      ASSERT_EQ(cost, kInfinity);
    } else {
      ASSERT_NEAR(cost, expected[static_cast<std::size_t>(i)], 1e-9);
    }
  }
}

constexpr std::array<int, 3> kShapes[] = {{9, 7, 1}, {8, 11, 3}, {7, 8, 12}, {5, 6, 70}};

TEST(ColumnCosts, IsTheTextbooksInEveryColumn) {
  std::mt19937_64 random(1);
  int open = 0;
  int walled = 0;
  for (int k = 0; k < 160; ++k) {
    Instance made = random_instance(random, kShapes[k % 4], k % 3 == 0 ? 0 : 40);
    if (k % 8 > 3) made.query.band = {};
    if (k % 5 == 0) made.few = 100;
    ColumnCosts field;
    aim(field, made);
    const std::vector<double> expected = slow_field(made);
    expect_field(field, made, expected, random);
    (few_levels(made, made.problem()) ? walled : open) += 1;
  }
  EXPECT_GT(open, 30);
  EXPECT_GT(walled, 80);
}

TEST(ColumnCosts, WalledInTakesNothingFromGroundBeyondTheWindow) {
  // Where ground out there is worth more than a metre costs, there would be no end.
  std::mt19937_64 random(6);
  for (int k = 0; k < 40; ++k) {
    Instance made = random_instance(random, kShapes[k % 4], 20);
    const GridFrame& frame = made.grid.frame();
    Raster::Values values = Raster::Values::Constant(3 * frame.nx(), 3 * frame.ny(), 1.0);
    double best = 0.0;
    for (int ix = 0; ix < frame.nx(); ++ix) {
      for (int iy = 0; iy < frame.ny(); ++iy) {
        double& value = values(frame.nx() + ix, frame.ny() + iy);
        value = static_cast<double>(random() % 4) / 8.0;
        best = std::max(best, value);
      }
    }
    const Eigen::Vector2d extent(frame.nx() * frame.cell().x(), frame.ny() * frame.cell().y());
    if (frame.cell().x() != frame.cell().y()) continue;
    made.priority = Raster(values, frame.origin().head<2>() - extent, frame.cell().x());
    made.query.band = {};
    made.few = 100;
    made.cost = {best, 1.0};  // a metre over the best ground costs nothing
    ColumnCosts field;
    aim(field, made);
    expect_field(field, made, slow_field(made), random);
  }
}

TEST(ColumnCosts, LeavesOutWhatNoPathOfItsLengthCanVisit) {
  std::mt19937_64 random(2);
  int cut = 0;
  for (int k = 0; k < 80; ++k) {
    Instance made = random_instance(random, kShapes[k % 4], 10);
    made.longest = (made.query.goal - made.query.start).norm() * (1.0 + 0.05 * (k % 7)) + 1.0;
    ColumnCosts field;
    aim(field, made);
    const std::vector<double> expected = slow_field(made);
    expect_field(field, made, expected, random);
    cut += static_cast<int>(std::count(expected.begin(), expected.end(), kInfinity));
  }
  EXPECT_GT(cut, 500);
}

/// The least cost from each cell to the goal over the steps in space; by frame index.
std::vector<double> slow_costs_in_space(const Instance& made) {
  const GridFrame& frame = made.grid.frame();
  const Problem problem = made.problem();
  std::vector<double> costs(static_cast<std::size_t>(frame.size()), kInfinity);
  using Entry = std::pair<double, std::int64_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  costs[static_cast<std::size_t>(frame.index(problem.goal))] = 0.0;
  open.push({0.0, frame.index(problem.goal)});
  while (!open.empty()) {
    const auto [cost, index] = open.top();
    open.pop();
    if (cost > costs[static_cast<std::size_t>(index)]) continue;
    const Cell cell = frame.cell_at(index);
    const std::uint32_t blocked = blocked_surroundings(made.grid, cell, problem.levels);
    for (const Step& step : steps()) {
      if ((blocked & step.box) != 0) continue;
      const Cell next = cell + step.offset();
      const double length = (frame.centre(next) - frame.centre(cell)).norm();
      const double total =
          cost + (cell == problem.goal ? straight(made, frame.centre(next), made.query.goal)
                                       : step_cost(made, cell, next, length));
      double& other = costs[static_cast<std::size_t>(frame.index(next))];
      if (total >= other) continue;
      other = total;
      open.push({total, frame.index(next)});
    }
  }
  return costs;
}

TEST(ColumnCosts, IsBelowEveryCostInSpaceAndIsThatCostInPlanarFlight) {
  std::mt19937_64 random(3);
  int below = 0;
  int equal = 0;
  for (int k = 0; k < 120; ++k) {
    Instance made = random_instance(random, kShapes[k % 4], k % 4 == 0 ? 10 : 25);
    const GridFrame& frame = made.grid.frame();
    const Problem problem = made.problem();
    // A last step over an edge is one to the field whatever it squeezes past. And a way may lead
    // through the centre of the goal's column: no short cut only where the goal lies there, and
    // the last step sees the ground like all others.
    const bool is_alike = frame.nz() == 1 && frame.cell().x() == frame.cell().y();
    if (is_alike) {
      made.query.goal = frame.centre(problem.goal);
      made.priority =
          Raster(made.priority.values(), frame.origin().head<2>(), frame.cell().x(), 0.4);
    }
    const bool free_goal =
        (blocked_surroundings(made.grid, problem.goal, problem.levels) & kBottomBits << 1) == 0;
    ColumnCosts field;
    aim(field, made);
    const std::vector<double> in_space = slow_costs_in_space(made);
    for (std::int64_t i = 0; i < frame.size(); ++i) {
      const Cell cell = frame.cell_at(i);
      const double cost = in_space[static_cast<std::size_t>(i)];
      if (cell == problem.goal || cell.z() < problem.levels.lowest ||
          cell.z() > problem.levels.highest || cost == kInfinity) {
        continue;
      }
      ASSERT_LE(field(cell.x(), cell.y()), cost + 1e-9);
      ++below;
      if (!is_alike || !free_goal) continue;
      ASSERT_NEAR(field(cell.x(), cell.y()), cost, 1e-9);
      ++equal;
    }
  }
  EXPECT_GT(below, 5000);
  EXPECT_GT(equal, 100);
}

TEST(ColumnCosts, CostsAStepAsMuchAsItsHalvesPerMetre) {
  std::mt19937_64 random(4);
  const Instance made = random_instance(random, {7, 8, 12}, 0);
  ColumnCosts field;
  aim(field, made);
  for (int ix = 1; ix < 7; ++ix) {
    for (int iy = 1; iy < 8; ++iy) {
      const double metre = field.half_metre(ix, iy) + field.half_metre(ix - 1, iy - 1);
      EXPECT_NEAR(2.5 * metre, step_cost(made, Cell(ix, iy, 0), Cell(ix - 1, iy - 1, 0), 2.5),
                  1e-12);
    }
  }
}

TEST(ColumnCosts, IsAsFreshWhateverWasAskedBefore) {
  // One thing changes from query to query, and sometimes nothing: the goal inside its cell, the
  // levels, the cost, the bound on the length, the raster, the obstacles, the window.
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int asked = 0;
  for (const std::array<int, 3>& shape : kShapes) {
    ColumnCosts used;
    Instance made = random_instance(random, shape, 30);
    made.query.band = {};
    for (int k = 0; k < 500; ++k) {
      const GridFrame& frame = made.grid.frame();
      const auto within = [&](const Cell& cell) -> Point {
        const Point share(unit(random), unit(random), unit(random));
        return frame.centre(cell) +
               (0.98 * share.array() - 0.49).matrix().cwiseProduct(frame.cell());
      };
      const Problem problem = made.problem();
      switch (random() % 9) {
        case 0:
          made.query.goal = within(problem.goal);
          break;
        case 1:
          made.query.start = within(problem.start);
          break;
        case 2:
          made.query.band = random() % 3 != 0 ? AltitudeBand{} : AltitudeBand{1.0, 2.0};
          break;
        case 3:
          made.cost.length = 1.01 + unit(random);
          break;
        case 4:
          made.longest = random() % 2 ? kInfinity : 1.0 + 1.1 * problem.direct_length;
          break;
        case 5: {
          Raster::Values values = made.priority.values();
          const auto row = static_cast<Eigen::Index>(random() % 30);
          values.row(row) = 1.0 - values.row(row);
          made.priority = Raster(values, {-19, -12}, 1.7, 0.4);
          break;
        }
        case 6:
          made.grid.set(Cell(0, 0, static_cast<int>(random() % frame.nz())), random() % 2 != 0);
          break;
        case 7: {
          const Cell shift(static_cast<int>(random() % 3) - 1, static_cast<int>(random() % 3) - 1,
                           0);
          const GridFrame moved = frame.shifted(shift);
          if (moved.contains(made.query.start) && moved.contains(made.query.goal)) {
            made.grid.roll(shift);
          }
          break;
        }
        default:
          break;
      }
      // Sometimes only in part, so that the next query finds a field that is half advanced.
      aim(used, made);
      ColumnCosts fresh;
      aim(fresh, made);
      const GridFrame& now = made.grid.frame();
      const int columns = random() % 2 ? 3 : now.nx() * now.ny();
      for (int n = 0; n < columns; ++n) {
        const int ix = static_cast<int>(random() % now.nx());
        const int iy = static_cast<int>(random() % now.ny());
        ASSERT_EQ(used(ix, iy), fresh(ix, iy)) << "query " << k;
        ++asked;
      }
    }
  }
  EXPECT_GT(asked, 10000);
}

}  // namespace
}  // namespace ltp::planning
