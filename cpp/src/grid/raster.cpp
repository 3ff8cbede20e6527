// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/grid/raster.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "ltp/geometry/check.hpp"
#include "ltp/geometry/norm.hpp"
#include "ltp/grid/ray_walk.hpp"

namespace ltp {
namespace {

std::uint64_t next_id() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

}  // namespace

Raster::Raster(Values values, const Eigen::Vector2d& origin, double cell, double outside)
    : values_(std::move(values)), origin_(origin), cell_(cell), outside_(outside), id_(next_id()) {
  check::finite("origin.x", origin.x());
  check::finite("origin.y", origin.y());
  check::positive("cell", cell);
  check::finite("outside", outside);
  check::resolvable("cell", cell, origin.x(), values_.rows());
  check::resolvable("cell", cell, origin.y(), values_.cols());
  if (values_.size() == 0) {
    check::fail("values.shape", "(" + std::to_string(nx()) + ", " + std::to_string(ny()) + ")",
                "at least one cell");
  }
  if (!values_.isFinite().all()) {
    for (Eigen::Index i = 0; i < values_.size(); ++i) {
      if (std::isfinite(values_.data()[i])) continue;
      check::fail("values[" + std::to_string(i / ny()) + ", " + std::to_string(i % ny()) + "]",
                  values_.data()[i], "finite numbers only");
    }
  }
  minimum_ = std::min(values_.minCoeff(), outside);
  maximum_ = std::max(values_.maxCoeff(), outside);
}

int Raster::index_of(int axis, double coordinate) const {
  const double index = std::floor((coordinate - origin_[axis]) / cell_);
  constexpr double kFar = 1e9;
  // Negated, so that NaN saturates too.
  if (!(index > -kFar && index < kFar)) return std::numeric_limits<int>::min();
  return static_cast<int>(index);
}

double Raster::bilinear(double x, double y) const {
  if (!contains(index_of(0, x), index_of(1, y))) return outside_;
  const double u = std::clamp((x - origin_.x()) / cell_ - 0.5, 0.0, nx() - 1.0);
  const double v = std::clamp((y - origin_.y()) / cell_ - 0.5, 0.0, ny() - 1.0);
  const int i = std::min(static_cast<int>(u), std::max(nx() - 2, 0));
  const int j = std::min(static_cast<int>(v), std::max(ny() - 2, 0));
  const int i1 = std::min(i + 1, nx() - 1);
  const int j1 = std::min(j + 1, ny() - 1);
  const double s = u - i;
  const double t = v - j;
  return (1 - s) * ((1 - t) * values_(i, j) + t * values_(i, j1)) +
         s * ((1 - t) * values_(i1, j) + t * values_(i1, j1));
}

double Raster::integral(const Point& a, const Point& b) const {
  const double length = norm(b - a);
  if (length == 0.0) return 0.0;
  const Eigen::Vector2d from = (a.head<2>() - origin_) / cell_;
  const Eigen::Vector2d to = (b.head<2>() - origin_) / cell_;
  if (!from.allFinite() || !to.allFinite()) {
    check::fail("segment", b.transpose(), "points at a finite number of cells from the raster");
  }
  const ClippedSegment<2> part =
      clip_segment<2>(from, to, Eigen::Vector2d::Zero(), Eigen::Vector2d(nx(), ny()));
  if (part.empty) return outside_ * length;
  double sum = 0.0;
  walk_segment<2>(part.a, part.b, [&](const Eigen::Vector2i& cell, double t_in, double t_out) {
    sum += (t_out - t_in) * (*this)(cell.x(), cell.y());
    return true;
  });
  const double walked = part.t_out - part.t_in;
  return (sum * walked + outside_ * (1.0 - walked)) * length;
}

}  // namespace ltp
