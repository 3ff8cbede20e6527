// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Random voxels, rays of all kinds about them, and what trying every voxel says of a ray.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "height_scenes.hpp"
#include "ltp/sensing/octree_surface.hpp"

namespace ltp::test {

inline int draw(Random& random, int low, int high) {
  return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
}
inline Point uniform_point(Random& random, double reach) {
  return {uniform(random, -reach, reach), uniform(random, -reach, reach),
          uniform(random, -reach, reach)};
}
/// Occupied cubes on the lattice through the world's origin, and all their voxels.
struct Voxels {
  explicit Voxels(double voxel) : edge(voxel) {}
  void add(const Cell& at, int size) {
    leaves.push_back({(at.cast<double>().array() + 0.5 * size) * edge, size * edge, 1.0});
    for (int x = 0; x < size; ++x) {
      for (int y = 0; y < size; ++y) {
        for (int z = 0; z < size; ++z) all.push_back(at + Cell(x, y, z));
      }
    }
    low = all.size() == static_cast<std::size_t>(size * size * size) ? at : low.cwiseMin(at).eval();
  }
  OctreeSurface surface() const { return OctreeSurface(OctreeLeaves{edge, leaves}); }

  double edge;
  std::vector<OctreeLeaf> leaves;
  std::vector<Cell> all;
  Cell low;
};

/// From when to when a ray is in a voxel [m]; not at all if the first is not less.
inline std::pair<double, double> times_in(const Voxels& voxels, const Cell& voxel,
                                          const Point& origin, const Point& direction) {
  const Point start = (origin - voxels.low.cast<double>() * voxels.edge) / voxels.edge;
  double t_in = -kInfinity;
  double t_out = kInfinity;
  for (int axis = 0; axis < 3; ++axis) {
    const int at = voxel[axis] - voxels.low[axis];
    if (direction[axis] == 0.0) {
      if (std::floor(start[axis]) != at) return {0.0, 0.0};
      continue;
    }
    const double inverse = voxels.edge / direction[axis];
    const double low = (at - start[axis]) * inverse;
    const double high = (at + 1 - start[axis]) * inverse;
    t_in = std::max(t_in, std::min(low, high));
    t_out = std::min(t_out, std::max(low, high));
  }
  return {std::max(t_in, 0.0), t_out};
}

inline double slow_range(const Voxels& voxels, const Point& origin, const Point& direction,
                         double max_range) {
  const double tie = 1e-9 * voxels.edge / direction.cwiseAbs().maxCoeff();
  double nearest = kInfinity;
  for (const Cell& voxel : voxels.all) {
    const auto [t_in, t_out] = times_in(voxels, voxel, origin, direction);
    if (t_out - t_in > tie && t_in < max_range) nearest = std::min(nearest, t_in);
  }
  return nearest;
}

/// Some voxels, some larger cubes, as octrees have them; nowhere, near the origin or far from it.
inline Voxels random_voxels(Random& random, int scene) {
  Voxels voxels(scene % 2 == 0 ? 0.25 : uniform(random, 0.01, 3.0));
  const Cell centre = scene % 3 == 0 ? Cell(-1000000, 4096, 777777) : Cell(0, 0, 0);
  const int spread = scene % 5 == 4 ? 1500 : scene % 5 == 3 ? 120 : 12;
  const auto place = [&] {
    return Cell(draw(random, -spread, spread), draw(random, -spread, spread),
                draw(random, -spread, spread));
  };
  for (int n = draw(random, 1, 60); n > 0; --n) voxels.add(centre + place(), 1);
  for (int n = draw(random, 0, 5); n > 0; --n) {
    const int size = 1 << draw(random, 1, 3);
    voxels.add(centre + Cell(place() / size * size), size);
  }
  return voxels;
}

/// Rays of any kind about some voxels: through them, beside them, from within, along axes, and
/// exactly through edges and corners of the lattice.
inline void random_rays(Random& random, const Voxels& voxels, int count, Path& origins,
                        Path& directions) {
  origins.resize(count, 3);
  directions.resize(count, 3);
  for (int ray = 0; ray < count; ++ray) {
    const Cell target = voxels.all[random() % voxels.all.size()];
    const Point inside = target.cast<double>() + Point::Constant(0.5) + uniform_point(random, 0.49);
    Point from = target.cast<double>() + uniform_point(random, ray % 2 == 0 ? 3.0 : 40.0);
    Point along = ray % 3 == 0 ? random_direction(random) : (inside - from).normalized();
    if (ray % 7 == 0) from = inside;
    if (ray % 5 == 0) {
      const int axis = draw(random, 0, 2);
      along = Point::Unit(axis) * (ray % 2 == 0 ? 1.0 : -1.0);
      from = inside - draw(random, 0, 30) * along;
      if (ray % 4 == 0) from[(axis + 1) % 3] = std::floor(from[(axis + 1) % 3]);  // in a face
    }
    if (ray % 11 == 0) {
      const Cell slope(draw(random, -3, 3), draw(random, -3, 3), draw(random, -3, 3));
      if (slope == Cell::Zero()) continue;
      along = slope.cast<double>().normalized();
      from = (target - draw(random, 1, 6) * slope).cast<double>();
    }
    origins.row(ray) = voxels.edge * from.transpose();
    directions.row(ray) = along.transpose();
  }
  for (int ray = 0; ray < count; ++ray) {
    if (directions.row(ray).norm() < 0.5) directions.row(ray) << 1, 0, 0;
  }
}

}  // namespace ltp::test
