// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/grid/neighbourhood.hpp"

#include <cmath>
#include <cstdlib>

namespace ltp {
namespace {

std::uint32_t box_of(int dx, int dy, int dz) {
  std::uint32_t box = 0;
  for (int x = 0; x <= std::abs(dx); ++x) {
    for (int y = 0; y <= std::abs(dy); ++y) {
      for (int z = 0; z <= std::abs(dz); ++z) {
        if (x == 0 && y == 0 && z == 0) continue;
        // The walker's own cell is not asked about: a UAV may stand in a coarse blocked cell.
        box |= std::uint32_t{1} << neighbour_bit(dx * x, dy * y, dz * z);
      }
    }
  }
  return box;
}

std::array<Step, kSteps> make_steps() {
  std::array<Step, kSteps> all{};
  int count = 0;
  for (int kind = 1; kind <= 3; ++kind) {
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dz = -1; dz <= 1; ++dz) {
          if (std::abs(dx) + std::abs(dy) + std::abs(dz) != kind) continue;
          Step& step = all[count++];
          step.dx = static_cast<std::int8_t>(dx);
          step.dy = static_cast<std::int8_t>(dy);
          step.dz = static_cast<std::int8_t>(dz);
          step.box = box_of(dx, dy, dz);
        }
      }
    }
  }
  for (Step& step : all) {
    for (int i = 0; i < kSteps; ++i) {
      if (all[i].dx == -step.dx && all[i].dy == -step.dy && all[i].dz == -step.dz) {
        step.opposite = static_cast<std::int8_t>(i);
      }
    }
  }
  return all;
}

}  // namespace

const std::array<Step, kSteps>& steps() {
  static const std::array<Step, kSteps> all = make_steps();
  return all;
}

std::array<double, kSteps> step_lengths(const Point& cell) {
  std::array<double, kSteps> lengths{};
  for (int i = 0; i < kSteps; ++i) {
    const Step& step = steps()[i];
    lengths[i] = Point(step.dx, step.dy, step.dz).cwiseProduct(cell).norm();
  }
  return lengths;
}

}  // namespace ltp
