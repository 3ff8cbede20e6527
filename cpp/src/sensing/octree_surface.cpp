// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/sensing/octree_surface.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <sstream>
#include <stdexcept>

#include "brick_walk.hpp"
#include "ltp/geometry/check.hpp"
#include "ltp/geometry/norm.hpp"
#include "ltp/grid/bits.hpp"
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

using sensing::BrickRays;
using sensing::BrickStart;
using sensing::VoxelBricks;
using sensing::VoxelCube;

std::vector<VoxelCube> occupied_cubes(const OctreeLeaves& octree) {
  check_resolution(octree.resolution);
  std::vector<VoxelCube> cubes;
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

std::vector<VoxelCube> voxels_of(const PathRef& points, double resolution) {
  check_resolution(resolution);
  std::vector<VoxelCube> cubes;
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

}  // namespace

struct OctreeSurface::Parts {
  Parts(const std::vector<VoxelCube>& cubes, double voxel)
      : bricks(cubes),
        edge(voxel),
        corner(bricks.low().cast<double>() * voxel),
        size(bricks.count()) {}

  /// A point in voxels from the lowest corner of the bounding box.
  Point lattice(const Point& point) const { return (point - corner) / edge; }

  VoxelBricks bricks;
  double edge;   ///< of a voxel [m]
  Point corner;  ///< lowest one of the bounding box [m]
  std::int64_t size;
  std::once_flag once;
  std::optional<OccupancyGrid> grid;
};

OctreeSurface::OctreeSurface(const OctreeLeaves& octree)
    : parts_(std::make_shared<Parts>(occupied_cubes(octree), octree.resolution)) {}

OctreeSurface::OctreeSurface(const std::string& path) {
  const OctreeLeaves octree = read_octree(path);
  try {
    parts_ = std::make_shared<Parts>(occupied_cubes(octree), octree.resolution);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("octree file '" + path + "': " + error.what());
  }
}

OctreeSurface::OctreeSurface(const PathRef& points, double resolution)
    : parts_(std::make_shared<Parts>(voxels_of(points, resolution), resolution)) {}

double OctreeSurface::resolution() const { return parts_->edge; }
std::int64_t OctreeSurface::size() const { return parts_->size; }
std::int64_t OctreeSurface::memory() const { return parts_->bricks.bytes(); }

const OccupancyGrid& OctreeSurface::voxels() const {
  std::call_once(parts_->once, [&] {
    const Cell& dims = parts_->bricks.dims();
    if (!(dims.cast<double>().prod() < 2147483648.0)) {
      std::ostringstream text;
      text << dims.x() << " x " << dims.y() << " x " << dims.z();
      check::fail("octree's bounding box [voxels]", text.str(), "fewer than 2^31 voxels in all");
    }
    OccupancyGrid grid(
        GridFrame(parts_->corner, Point::Constant(parts_->edge), {dims.x(), dims.y(), dims.z()}));
    parts_->bricks.for_each_cube([&](const Cell& low, int edge) {
      const int top = low.z() + edge - 1;
      for (int ix = low.x(); ix < low.x() + edge; ++ix) {
        for (int iy = low.y(); iy < low.y() + edge; ++iy) {
          std::uint64_t* column = grid.column(ix, iy);
          for (int word = low.z() / 64; word <= top / 64; ++word) {
            column[word] |= bits_between(word, low.z(), top);
          }
        }
      }
    });
    parts_->grid = std::move(grid);
  });
  return *parts_->grid;
}

RayHit OctreeSurface::cast(const Point& origin, const Point& direction, double max_range) const {
  const BrickStart start(parts_->bricks, parts_->edge, origin, max_range);
  if (!start.near()) return cast_from_afar(origin, direction, max_range);
  static thread_local BrickRays rays;
  rays.x[0] = direction.x();
  rays.y[0] = direction.y();
  rays.z[0] = direction.z();
  sensing::walk_bricks_of_one(start, rays);
  return rays.hit(0);
}

RayHit OctreeSurface::cast_from_afar(const Point& origin, const Point& direction,
                                     double max_range) const {
  // On to the sphere about the box, as near as rounding leads.
  const Point half = 0.5 * parts_->edge * parts_->bricks.dims().cast<double>();
  const double way = (parts_->corner + half - origin).norm() - half.norm();
  const Point nearer = origin + way * direction;
  const BrickStart start(parts_->bricks, parts_->edge, nearer, max_range);
  if (!(way < max_range) || !start.near()) return RayHit();
  RayHit hit = cast(nearer, direction, max_range - way);
  hit.range += way;
  return hit.range < max_range ? hit : RayHit();
}

template <typename DirectionOf>
void OctreeSurface::cast_all(const Point& origin, std::int64_t count, double max_range,
                             const DirectionOf& direction_of, RayHits& hits) const {
  const BrickStart start(parts_->bricks, parts_->edge, origin, max_range);
  if (!start.near()) {
    for (std::int64_t ray = 0; ray < count; ++ray) {
      const RayHit hit = cast(origin, direction_of(ray), max_range);
      if (hit.hit()) hits.add(ray, hit.range, hit.inside);
    }
    return;
  }
  static thread_local BrickRays rays;
  for (std::int64_t first = 0; first < count; first += BrickRays::kMost) {
    const int some = static_cast<int>(std::min<std::int64_t>(count - first, BrickRays::kMost));
    for (int n = 0; n < some; ++n) {
      const Point direction = direction_of(first + n);
      rays.x[n] = direction.x();
      rays.y[n] = direction.y();
      rays.z[n] = direction.z();
    }
    sensing::walk_bricks(start, rays, some);
    for (int n = 0; n < some; ++n) {
      const RayHit hit = rays.hit(n);
      if (hit.hit()) hits.add(first + n, hit.range, hit.inside);
    }
  }
}

void OctreeSurface::cast_fans(const Point& origin, const std::vector<Eigen::Vector2d>& headings,
                              const BeamFan& fan, double max_range, RayHits& hits) const {
  const std::int64_t rows = fan.size();
  cast_all(
      origin, rows * static_cast<std::int64_t>(headings.size()), max_range,
      [&](std::int64_t ray) {
        const Eigen::Vector2d& heading = headings[ray / rows];
        const BeamFan::Beam& beam = fan[static_cast<int>(ray % rows)];
        return Point(beam.cosine * heading.x(), beam.cosine * heading.y(), beam.sine);
      },
      hits);
}

void OctreeSurface::cast_bundle(const Point& origin, const Eigen::Matrix3d& turn,
                                const PathRef& directions, double max_range, RayHits& hits) const {
  cast_all(
      origin, directions.rows(), max_range,
      [&](std::int64_t ray) { return turned(turn, directions.row(ray)); }, hits);
}

std::optional<double> OctreeSurface::first_collision(const PathRef& path) const {
  if (!path.allFinite()) check::fail("path", "not finite", "finite numbers only");
  const VoxelBricks& bricks = parts_->bricks;
  const Point high = bricks.dims().cast<double>();
  if (path.rows() == 1) {
    const Point at = parts_->lattice(path.row(0).transpose()).array().floor();
    const bool within = (at.array() >= 0.0).all() && (at.array() < high.array()).all();
    return within && bricks.occupied(at.cast<int>()) ? std::optional<double>(0.0) : std::nullopt;
  }
  double arc = 0.0;
  for (Eigen::Index i = 1; i < path.rows(); ++i) {
    const Point a = path.row(i - 1).transpose();
    const Point b = path.row(i).transpose();
    const double size = norm(b - a);
    const Point from = parts_->lattice(a);
    const Point to = parts_->lattice(b);
    if (!from.allFinite() || !to.allFinite()) {
      check::fail("path", b.transpose(), "points at a finite number of voxels from the octree");
    }
    const ClippedSegment<3> part = clip_segment<3>(from, to, Point::Zero(), high);
    std::optional<double> touched;
    if (!part.empty) {
      walk_segment<3>(part.a, part.b, [&](const Cell& voxel, double t_in, double) {
        if (!bricks.occupied(voxel)) return true;
        touched = arc + size * part.whole(t_in);
        return false;
      });
    }
    if (touched) return touched;
    arc += size;
  }
  return std::nullopt;
}

double OctreeSurface::clearance(const Point& point, double max_distance) const {
  check::finite("point", point);
  check::not_negative("max_distance", max_distance);
  const double most = max_distance / parts_->edge;
  const double nearest = parts_->bricks.squared_distance(parts_->lattice(point), most * most);
  return std::min(max_distance, std::sqrt(nearest) * parts_->edge);
}

}  // namespace ltp
