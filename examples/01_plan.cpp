// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Plans one path round a wall on an installed ltp. README.md shows the same lines.
#include <iostream>
#include <ltp/planning/planners.hpp>

int main() {
  const ltp::GridFrame frame({0, 0, 0}, {2, 2, 4}, {100, 100, 10});  // origin, cell [m]; cells
  ltp::OccupancyGrid grid(frame);
  for (int iy = 0; iy < 80; ++iy) {
    for (int iz = 0; iz < 10; ++iz) grid.set({50, iy, iz});  // a wall with a way round its end
  }
  const ltp::Raster priority(ltp::Raster::Values::Zero(100, 100), {0, 0}, 2.0);
  const auto planner = ltp::make_planner("auto");
  const ltp::Plan plan = planner->plan({grid, priority}, {{20, 20, 20}, {180, 20, 20}});
  std::cout << ltp::to_string(plan.status) << ", " << plan.tally.length << " m\n";
}
