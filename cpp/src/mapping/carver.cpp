// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/mapping/carver.hpp"

#include <algorithm>
#include <cmath>

#include "ltp/grid/cell_finder.hpp"
#include "ltp/grid/ray_walk.hpp"
#include "ltp/mapping/ray_marker.hpp"

namespace ltp {

Carver::Carver(const GridFrame& voxels, const ObstacleMapOptions& options)
    : frame_(voxels),
      options_(options),
      hit_log_odds_(static_cast<float>(options.hit_log_odds)),
      miss_log_odds_(static_cast<float>(options.miss_log_odds)),
      min_log_odds_(static_cast<float>(options.min_log_odds)),
      max_log_odds_(static_cast<float>(options.max_log_odds)),
      log_odds_(static_cast<std::size_t>(voxels.size())),
      hit_(voxels),
      passed_(voxels),
      followed_(voxels) {}

void Carver::follow(const Point& origin, const OwnReturns& own, const PointsView& ends) {
  const double range = options_.max_range;
  const Point from = frame_.lattice(origin);
  const bool from_inside = frame_.contains(origin);
  const auto follow_to = [&](Eigen::Index i) {
    Point end = ends[i];
    const double square = (end - origin).squaredNorm();
    if (!std::isfinite(square)) return;
    if (own(end - origin) != OwnReturns::Verdict::Obstacle) return;
    if (const double length = std::sqrt(square); length > range) {
      end = origin + (range / length) * (end - origin);
    }
    const std::optional<Cell> voxel = frame_.find(end);
    if (voxel) {
      if (followed_.blocked(*voxel)) return;
      followed_.set(*voxel);
    }
    const Point to = frame_.lattice(end);
    if (voxel && from_inside) {
      mark_passed(from, to, frame_.first(), passed_);
    } else {
      follow_outside(from, to);
    }
  };
  // Most rays end where another one did, most of them at the maximum range or a hair beyond: not
  // far enough to matter for their voxel.
  constexpr double kHair = 1e-6;
  CellFinder(frame_, {origin, own.reach(), range * (1.0 + kHair)}, 2.0 * kHair * range)
      .for_each(
          ends,
          [&](Eigen::Index i, const Cell& voxel) {
            if (!followed_.blocked(voxel)) follow_to(i);
          },
          follow_to);
}

void Carver::follow_outside(const Point& from, const Point& to) {
  const Cell first = frame_.first();
  const Point low = first.cast<double>();
  const Point high = low + Point(frame_.nx(), frame_.ny(), frame_.nz());
  const auto part = clip_segment<3>(from, to, low, high);
  if (part.empty) return;
  // Compared as numbers: one that is too far for an `int` is no voxel of the window.
  const Point last = to.array().floor();
  walk_segment<3>(part.a, part.b, [&](const Cell& lattice, double t_in, double t_out) {
    const Cell voxel = lattice - first;
    // A voxel that the ray only touches was not passed; one in which it ends was not passed all the
    // way.
    if (t_out > t_in && lattice.cast<double>() != last && frame_.contains(voxel)) {
      passed_.set(voxel);
    }
    return true;
  });
}

void Carver::set_log_odds(const Cell& voxel, double value) {
  log_odds_[frame_.index(voxel)] =
      static_cast<float>(std::clamp(value, options_.min_log_odds, options_.max_log_odds));
}

void Carver::roll(const Cell& shift) {
  frame_ = frame_.shifted(shift);
  const std::int64_t nx = frame_.nx();
  const std::int64_t ny = frame_.ny();
  const std::int64_t nz = frame_.nz();
  if (std::abs(std::int64_t{shift.x()}) >= nx || std::abs(std::int64_t{shift.y()}) >= ny ||
      std::abs(std::int64_t{shift.z()}) >= nz) {
    clear();
    return;
  }
  // One move of everything, then clear what entered (it holds what wrapped round).
  const std::int64_t offset = (shift.x() * ny + shift.y()) * nz + shift.z();
  if (offset > 0) std::copy(log_odds_.begin() + offset, log_odds_.end(), log_odds_.begin());
  if (offset < 0) std::copy_backward(log_odds_.begin(), log_odds_.end() + offset, log_odds_.end());
  const auto entered = [](std::int64_t i, int by, std::int64_t n) {
    return i + by < 0 || i + by >= n;
  };
  for (std::int64_t ix = 0; ix < nx; ++ix) {
    for (std::int64_t iy = 0; iy < ny; ++iy) {
      const auto column = log_odds_.begin() + (ix * ny + iy) * nz;
      if (entered(ix, shift.x(), nx) || entered(iy, shift.y(), ny)) {
        std::fill(column, column + nz, 0.0f);
      } else if (shift.z() > 0) {
        std::fill(column + nz - shift.z(), column + nz, 0.0f);
      } else {
        std::fill(column, column - shift.z(), 0.0f);
      }
    }
  }
}

void Carver::clear() { std::fill(log_odds_.begin(), log_odds_.end(), 0.0f); }

}  // namespace ltp
