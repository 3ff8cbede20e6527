// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/grid/columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "ltp/geometry/check.hpp"

namespace ltp {
namespace {

constexpr double kSame = 1e-9;  // of a column
constexpr int kMostSquares = 16;

constexpr double kFarthest = 1e9;  // [columns, cells]; beyond, whole numbers cannot be told

bool is_whole(double number) { return std::abs(number - std::round(number)) < kSame; }

/// Whether a number is whole and so near that this can be told; with a count, it is at least 1, and
/// what rounding left of it adds up to nothing over so many.
bool is_multiple(double number, int count = 0) {
  if (!(std::abs(number) < kFarthest)) return false;
  if (count > 0 && number < 0.5) return false;
  return std::abs(number - std::round(number)) * std::max(1, count) < kSame;
}

/// The cells of a raster that a column meets along one axis, and which shares of it.
struct Shares {
  int first = 0;
  std::vector<double> of;
  double inside = 0.0;  ///< their sum; what is missing from 1 is beyond the raster
};

Shares shares(double low, double high, int count) {
  Shares met;
  if (!std::isfinite(low) || !std::isfinite(high)) return met;
  if (high - low < kSame) {  // next to nothing of one cell
    if (low < 0.0 || low >= count) return met;
    return {static_cast<int>(low), {1.0}, 1.0};
  }
  const double begin = std::clamp(low, 0.0, static_cast<double>(count));
  const double end = std::clamp(high, 0.0, static_cast<double>(count));
  met.first = static_cast<int>(begin);
  for (int i = met.first; i < end; ++i) {
    const double share = (std::min(end, i + 1.0) - std::max(begin, static_cast<double>(i)));
    met.of.push_back(std::max(0.0, share) / (high - low));
    met.inside += met.of.back();
  }
  return met;
}

/// For each column along an axis, of a raster's cells: the same to the last bit in every window on
/// the frame's lattice.
std::vector<Shares> all_shares(const Raster& raster, const GridFrame& frame, int axis) {
  const double anchor = frame.shifted(-frame.first()).origin()[axis];
  const int cells = axis == 0 ? raster.nx() : raster.ny();
  const auto face = [&](int i) {  // in cells of the raster, from its origin
    const double number = static_cast<double>(frame.first()[axis]) + i;
    return (anchor + number * frame.cell()[axis] - raster.origin()[axis]) / raster.cell();
  };
  std::vector<Shares> all;
  all.reserve(frame.dims()[axis]);
  for (int i = 0; i < frame.dims()[axis]; ++i) all.push_back(shares(face(i), face(i + 1), cells));
  return all;
}

}  // namespace

bool is_constant_on_columns(const Raster& raster, const GridFrame& frame) {
  if (raster.minimum() == raster.maximum()) return true;
  std::array<int, 2> parts{1, 1};  // cells of the raster along a column
  std::array<int, 2> first{};      // of them, under the first column
  for (int axis = 0; axis < 2; ++axis) {
    const double edge = frame.cell()[axis];
    const int cells = axis == 0 ? raster.nx() : raster.ny();
    const double ratio = raster.cell() / edge;
    const double offset = raster.origin()[axis] - frame.origin()[axis];
    if (is_multiple(ratio, cells) && is_multiple(offset / edge)) continue;
    if (!is_multiple(1.0 / ratio, frame.dims()[axis]) || !is_multiple(offset / raster.cell())) {
      return false;
    }
    parts[axis] = static_cast<int>(std::round(1.0 / ratio));
    first[axis] = -static_cast<int>(std::round(offset / raster.cell()));
  }
  if (parts[0] == 1 && parts[1] == 1) return true;
  for (int axis = 0; axis < 2; ++axis) {
    // Blocks along one axis, parts along the other: no squares, and not looked at any closer.
    if (parts[axis] > 1) continue;
    if (std::abs(raster.cell() / frame.cell()[axis] - 1.0) > kSame) return false;
    first[axis] = static_cast<int>(
        std::round((frame.origin()[axis] - raster.origin()[axis]) / raster.cell()));
  }
  std::array<int, 2> begin{};  // the columns that meet the raster
  std::array<int, 2> end{};
  for (int axis = 0; axis < 2; ++axis) {
    const int columns = frame.dims()[axis];
    const int cells = axis == 0 ? raster.nx() : raster.ny();
    begin[axis] = std::clamp(-first[axis] / parts[axis], 0, columns);
    end[axis] = std::clamp((cells - first[axis]) / parts[axis] + 1, begin[axis], columns);
  }
  for (int ix = begin[0]; ix < end[0]; ++ix) {
    for (int iy = begin[1]; iy < end[1]; ++iy) {
      const int i = first[0] + ix * parts[0];
      const int j = first[1] + iy * parts[1];
      const double value = raster(i, j);
      for (int k = 1; k < parts[0] * parts[1]; ++k) {
        if (raster(i + k / parts[1], j + k % parts[1]) != value) return false;
      }
    }
  }
  return true;
}

std::optional<double> square_of_column(const GridFrame& frame) {
  const double x = frame.cell().x();
  const double y = frame.cell().y();
  const double longer = std::max(x, y);
  for (int parts = 1; parts <= kMostSquares; ++parts) {
    const double edge = longer / parts;
    const double other = std::min(x, y) / edge;
    if (std::round(other) >= 1.0 && is_whole(other)) return edge;
  }
  return std::nullopt;
}

Raster onto_columns(const Raster& raster, const GridFrame& frame) {
  const std::optional<double> square = square_of_column(frame);
  if (!square) {
    check::fail("frame.cell", frame.cell().transpose(),
                "x and y edges that are at most 16 times one common edge");
  }
  const std::vector<Shares> along_x = all_shares(raster, frame, 0);
  const std::vector<Shares> along_y = all_shares(raster, frame, 1);
  const int per_x = static_cast<int>(std::round(frame.cell().x() / *square));
  const int per_y = static_cast<int>(std::round(frame.cell().y() / *square));
  Raster::Values values(frame.nx() * per_x, frame.ny() * per_y);
  int begin = raster.ny();  // what the grid sees of the raster along y
  int end = 0;
  for (const Shares& y : along_y) {
    if (y.of.empty()) continue;
    begin = std::min(begin, y.first);
    end = std::max(end, y.first + static_cast<int>(y.of.size()));
  }
  const int seen = std::max(0, end - begin);
  Eigen::ArrayXd strip(seen);  // the raster's means over the column's width
  for (int ix = 0; ix < frame.nx(); ++ix) {
    const Shares& x = along_x[ix];
    strip.setZero();
    for (std::size_t i = 0; i < x.of.size() && seen > 0; ++i) {
      const int row = x.first + static_cast<int>(i);
      strip += x.of[i] * raster.values().row(row).segment(begin, seen).transpose();
    }
    for (int iy = 0; iy < frame.ny(); ++iy) {
      const Shares& y = along_y[iy];
      double mean = raster.outside() * std::max(0.0, 1.0 - x.inside * y.inside);
      for (std::size_t j = 0; j < y.of.size(); ++j) {
        mean += y.of[j] * strip[y.first - begin + static_cast<int>(j)];
      }
      // Rounding must not lead beyond what was averaged.
      mean = std::clamp(mean, raster.minimum(), raster.maximum());
      values.block(ix * per_x, iy * per_y, per_x, per_y).setConstant(mean);
    }
  }
  return Raster(std::move(values), frame.origin().head<2>(), *square, raster.outside());
}

}  // namespace ltp
