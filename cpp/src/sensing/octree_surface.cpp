// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/sensing/octree_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "ltp/geometry/check.hpp"
#include "ltp/grid/ray_walk.hpp"

namespace ltp {
namespace {

constexpr double kFarthest = 1e9;  // voxels from the world's origin
/// Edges of a voxel that leave room for the depth of a hit, and for rounding where cities lie [m].
constexpr double kFinest = 1e-6;
constexpr double kCoarsest = 1e6;

void check_resolution(double resolution) {
  if (resolution >= kFinest && resolution <= kCoarsest) return;
  check::fail("resolution", resolution, "from 1e-6 to 1e6 m");
}

/// A cube of occupied voxels, counted on the lattice through the world's origin.
struct Cube {
  Cell low;
  int edge;  ///< [voxels]
};

std::vector<Cube> occupied_cubes(const OctreeLeaves& octree) {
  check_resolution(octree.resolution);
  std::vector<Cube> cubes;
  for (const OctreeLeaf& leaf : octree.leaves) {
    if (!leaf.occupied()) continue;
    const Point low = (leaf.centre.array() - 0.5 * leaf.size) / octree.resolution;
    const double edge = std::round(leaf.size / octree.resolution);
    if (!(low.array().abs() < kFarthest).all() || !(edge >= 1.0 && edge < kFarthest)) {
      check::fail("leaf.centre", leaf.centre.transpose(), "a cube of voxels near the origin");
    }
    cubes.push_back({low.array().round().matrix().cast<int>(), static_cast<int>(edge)});
  }
  return cubes;
}

std::vector<Cube> voxels_of(const PathRef& points, double resolution) {
  check_resolution(resolution);
  std::vector<Cube> cubes;
  cubes.reserve(points.rows());
  for (Eigen::Index n = 0; n < points.rows(); ++n) {
    const Point lattice = points.row(n).transpose() / resolution;
    if (!(lattice.array().abs() < kFarthest).all()) {
      check::fail("points[" + std::to_string(n) + "]", points.row(n),
                  "three finite numbers within 1e9 voxels of the origin");
    }
    cubes.push_back({lattice.array().floor().matrix().cast<int>(), 1});
  }
  return cubes;
}

/// Sets the bits of levels `low` to `high` of a column, both included.
void set_levels(std::uint64_t* column, int low, int high) {
  for (int word = low / 64; word <= high / 64; ++word) {
    const int from = std::max(low - 64 * word, 0);
    const int to = std::min(high - 64 * word, 63);
    column[word] |= (~std::uint64_t{0} >> (63 - (to - from))) << from;
  }
}

OccupancyGrid fill(const std::vector<Cube>& cubes, double resolution) {
  const Point edges = Point::Constant(resolution);
  if (cubes.empty()) return OccupancyGrid(GridFrame(Point::Zero(), edges, {1, 1, 1}));
  Cell low = cubes.front().low;
  Cell high = low;
  for (const Cube& cube : cubes) {
    low = low.cwiseMin(cube.low);
    high = high.cwiseMax((cube.low.array() + cube.edge).matrix());
  }
  const Eigen::Matrix<std::int64_t, 3, 1> dims =
      high.cast<std::int64_t>() - low.cast<std::int64_t>();
  const double volume = dims.cast<double>().prod();
  if (!(volume < 2147483648.0)) {
    std::ostringstream text;
    text << dims.x() << " x " << dims.y() << " x " << dims.z();
    check::fail("octree's bounding box [voxels]", text.str(), "fewer than 2^31 voxels in all");
  }
  OccupancyGrid grid(GridFrame(
      low.cast<double>() * resolution, edges,
      {static_cast<int>(dims.x()), static_cast<int>(dims.y()), static_cast<int>(dims.z())}));
  for (const Cube& cube : cubes) {
    const Cell first = cube.low - low;
    for (int ix = first.x(); ix < first.x() + cube.edge; ++ix) {
      for (int iy = first.y(); iy < first.y() + cube.edge; ++iy) {
        set_levels(grid.column(ix, iy), first.z(), first.z() + cube.edge - 1);
      }
    }
  }
  return grid;
}

/// The point at `range` of a ray, moved into the voxel through the face by which the ray enters it.
Point inside_voxel(const GridFrame& frame, const Cell& voxel, const Point& origin,
                   const Point& direction, double range) {
  const double edge = frame.cell().x();
  const Point low = frame.origin() + voxel.cast<double>() * edge;
  int face = -1;
  double entered = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0.0) continue;
    const double side = direction[axis] > 0.0 ? low[axis] : low[axis] + edge;
    const double t = (side - origin[axis]) / direction[axis];
    if (t >= entered) {
      entered = t;
      face = axis;
    }
  }
  Point point = origin + range * direction;
  for (int axis = 0; axis < 3; ++axis) {
    const double depth =
        axis == face ? std::min(kHitDepth, 0.5 * edge) : std::min(kHitMargin, 0.25 * edge);
    point[axis] = std::min(std::max(point[axis], low[axis] + depth), low[axis] + edge - depth);
  }
  return point;
}

double squared(double value) { return value * value; }

/// From a coordinate to the interval [index, index + 1].
double gap(double at, int index) { return std::max({index - at, at - (index + 1.0), 0.0}); }

/// How far above or below a coordinate the nearest occupied level of a column is [levels]; inf:
/// there is none. `middle` is the level nearest to the coordinate.
double nearest_level(const std::uint64_t* column, int levels, int middle, double at) {
  double nearest = std::numeric_limits<double>::infinity();
  const int words = (levels + 63) / 64;
  std::uint64_t below = column[middle / 64] & (~std::uint64_t{0} >> (63 - middle % 64));
  std::uint64_t above = column[middle / 64] & (~std::uint64_t{0} << (middle % 64));
  for (int word = middle / 64; word >= 0; below = --word >= 0 ? column[word] : 0) {
    if (below == 0) continue;
    nearest = gap(at, 64 * word + 63 - __builtin_clzll(below));
    break;
  }
  for (int word = middle / 64; word < words; above = ++word < words ? column[word] : 0) {
    if (above == 0) continue;
    return std::min(nearest, gap(at, 64 * word + __builtin_ctzll(above)));
  }
  return nearest;
}

OccupancyGrid load(const std::string& path) {
  const OctreeLeaves octree = read_octree(path);
  try {
    return fill(occupied_cubes(octree), octree.resolution);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("octree file '" + path + "': " + error.what());
  }
}

}  // namespace

OctreeSurface::OctreeSurface(const OctreeLeaves& octree)
    : voxels_(fill(occupied_cubes(octree), octree.resolution)), size_(voxels_.count()) {}

OctreeSurface::OctreeSurface(const std::string& path)
    : voxels_(load(path)), size_(voxels_.count()) {}

OctreeSurface::OctreeSurface(const PathRef& points, double resolution)
    : voxels_(fill(voxels_of(points, resolution), resolution)), size_(voxels_.count()) {}

RayHit OctreeSurface::cast(const Point& origin, const Point& direction, double max_range) const {
  const GridFrame& frame = voxels_.frame();
  const double edge = resolution();
  const Point anchor = frame.origin();
  const Point start = (origin - anchor) / edge;
  const Point rate = direction / edge;

  // The part of the ray inside the box [m].
  double enter = 0.0;
  double leave = max_range;
  for (int axis = 0; axis < 3; ++axis) {
    if (rate[axis] == 0.0) {
      if (!(start[axis] >= 0.0 && start[axis] < frame.dims()[axis])) return RayHit();
      continue;
    }
    const double t_low = (0 - start[axis]) / rate[axis];
    const double t_high = (frame.dims()[axis] - start[axis]) / rate[axis];
    enter = std::max(enter, std::min(t_low, t_high));
    leave = std::min(leave, std::max(t_low, t_high));
  }
  if (!(enter < leave)) return RayHit();

  RayHit hit;
  walk_segment<3>(start + enter * rate, start + leave * rate,
                  [&](const Cell& voxel, double t_in, double t_out) {
                    // A voxel that is only touched, at an edge or a corner, is passed by.
                    if (t_in == t_out || !frame.contains(voxel) || !voxels_.blocked(voxel)) {
                      return true;
                    }
                    hit.range = enter + t_in * (leave - enter);
                    hit.inside = inside_voxel(frame, voxel, origin, direction, hit.range);
                    return false;
                  });
  return hit.range < max_range ? hit : RayHit();
}

std::optional<double> OctreeSurface::first_collision(const PathRef& path) const {
  return voxels_.first_blocked(path);
}

double OctreeSurface::clearance(const Point& point, double max_distance) const {
  check::finite("point", point);
  check::not_negative("max_distance", max_distance);
  const GridFrame& frame = voxels_.frame();
  const double edge = resolution();
  const Point at = (point - frame.origin()) / edge;  // in voxels
  const Point last(frame.nx() - 1.0, frame.ny() - 1.0, frame.nz() - 1.0);
  // Rings of columns round the nearest one of the box, until none can be nearer.
  const Cell middle = at.array().floor().max(0.0).min(last.array()).matrix().cast<int>();
  double nearest = max_distance / edge * (max_distance / edge);
  const int rings = std::max(frame.nx(), frame.ny());
  for (int ring = 0; ring < rings; ++ring) {
    const double least = std::max(ring - 1, 0);
    if (least * least >= nearest) break;
    for (int dx = -ring; dx <= ring; ++dx) {
      const int ix = middle.x() + dx;
      if (ix < 0 || ix >= frame.nx()) continue;
      const int stride = std::abs(dx) == ring ? 1 : 2 * ring;
      for (int dy = -ring; dy <= ring; dy += stride) {
        const int iy = middle.y() + dy;
        if (iy < 0 || iy >= frame.ny()) continue;
        const double across = squared(gap(at.x(), ix)) + squared(gap(at.y(), iy));
        if (across >= nearest) continue;
        const double up = nearest_level(voxels_.column(ix, iy), frame.nz(), middle.z(), at.z());
        nearest = std::min(nearest, across + squared(up));
      }
    }
  }
  return std::min(max_distance, std::sqrt(nearest) * edge);
}

}  // namespace ltp
