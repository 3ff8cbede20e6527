// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays through bricks: as by trying every voxel, to the last bit, on every processor; and
// OctoMap's.
#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "all_vectors.hpp"
#include "ltp/sensing/lidar.hpp"
#include "ltp/sensing/octree_surface.hpp"
#include "sensing/voxel_bricks.hpp"

namespace ltp {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
using Random = std::mt19937_64;

double uniform(Random& random, double low, double high) {
  return low + (high - low) * (random() >> 11) * 0x1p-53;
}
int draw(Random& random, int low, int high) {
  return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
}
Point uniform_point(Random& random, double reach) {
  return {uniform(random, -reach, reach), uniform(random, -reach, reach),
          uniform(random, -reach, reach)};
}
Point random_direction(Random& random) {
  while (true) {
    const Point v = uniform_point(random, 1.0);
    if (v.norm() > 0.1 && v.norm() < 1.0) return v.normalized();
  }
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
std::pair<double, double> times_in(const Voxels& voxels, const Cell& voxel, const Point& origin,
                                   const Point& direction) {
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

double slow_range(const Voxels& voxels, const Point& origin, const Point& direction,
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
Voxels random_voxels(Random& random, int scene) {
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
void random_rays(Random& random, const Voxels& voxels, int count, Path& origins, Path& directions) {
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

TEST(OctreeRays, AreThoseOfTryingEveryVoxelToTheLastBit) {
  Random random(21);
  int hits = 0, misses = 0, inside = 0;
  for (int scene = 0; scene < 30; ++scene) {
    const Voxels voxels = random_voxels(random, scene);
    const OctreeSurface surface = voxels.surface();
    Path origins, directions;
    random_rays(random, voxels, 200, origins, directions);
    for (Eigen::Index ray = 0; ray < origins.rows(); ++ray) {
      const Point from = origins.row(ray).transpose();
      const Point along = directions.row(ray).transpose();
      const double max_range = voxels.edge * uniform(random, 1, ray % 4 == 0 ? 20 : 3000);
      const RayHit hit = surface.cast(from, along, max_range);
      const double expected = slow_range(voxels, from, along, max_range);
      ASSERT_EQ(hit.range, expected) << scene << " " << ray;
      (hit.hit() ? hits : misses) += 1;
      inside += hit.range == 0.0;
      if (!hit.hit()) continue;
      const Cell cell = (hit.inside / voxels.edge).array().floor().matrix().cast<int>();
      ASSERT_NE(std::find(voxels.all.begin(), voxels.all.end(), cell), voxels.all.end()) << ray;
      ASSERT_LE((hit.inside - (from + hit.range * along)).norm(), kHitDepth + 2 * kHitMargin);
    }
  }
  EXPECT_GT(hits, 3000);
  EXPECT_GT(misses, 1000);
  EXPECT_GT(inside, 300);
}

TEST(OctreeRays, BundlesAndFansSayWhatSingleRaysDo) {
  Random random(22);
  std::int64_t hits = 0;
  for (int scene = 0; scene < 10; ++scene) {
    const Voxels voxels = random_voxels(random, scene);
    const OctreeSurface surface = voxels.surface();
    Path origins, directions;
    random_rays(random, voxels, 1500, origins, directions);
    const Point origin = origins.row(scene).transpose();
    const double max_range = 200 * voxels.edge;
    std::vector<RayHit> expected;
    for (Eigen::Index ray = 0; ray < directions.rows(); ++ray) {
      expected.push_back(surface.cast(origin, directions.row(ray).transpose(), max_range));
    }
    std::vector<Eigen::Vector2d> headings;
    for (int n = 0; n < 90; ++n) headings.emplace_back(std::cos(0.07 * n), std::sin(0.07 * n));
    const BeamFan fan({-1.2, -0.6, -0.1, 0.0, 0.2, 0.9, 1.4});
    RayHits expected_fans;
    expected_fans.reset(7 * 90);
    surface.Surface::cast_fans(origin, headings, fan, max_range, expected_fans);
    test::with_all_vectors([&] {
      RayHits bundle;
      bundle.reset(directions.rows());
      surface.cast_bundle(origin, Eigen::Matrix3d::Identity(), directions, max_range, bundle);
      std::int64_t next = 0;
      for (Eigen::Index ray = 0; ray < directions.rows(); ++ray) {
        if (!expected[ray].hit()) continue;
        ASSERT_LT(next, bundle.size());
        ASSERT_EQ(bundle.ray(next), ray);
        ASSERT_EQ(bundle.range(next), expected[ray].range);
        ASSERT_EQ(bundle.inside(next++), expected[ray].inside);
      }
      ASSERT_EQ(next, bundle.size());
      hits += next;
      RayHits fans;
      fans.reset(7 * 90);
      surface.cast_fans(origin, headings, fan, max_range, fans);
      ASSERT_EQ(fans.size(), expected_fans.size());
      for (std::int64_t n = 0; n < fans.size(); ++n) {
        ASSERT_EQ(fans.ray(n), expected_fans.ray(n));
        ASSERT_EQ(fans.range(n), expected_fans.range(n));
        ASSERT_EQ(fans.inside(n), expected_fans.inside(n));
      }
    });
  }
  EXPECT_GT(hits, 1000);
}

TEST(OctreeRays, HoldAlongTheWholeOfOctoMapsWorld) {
  // Voxels at the ends of 65,536 keys along each axis, and one whole eighth of it: a word a cube.
  Voxels ends(0.05);
  for (const int x : {-32768, -3, 32767}) {
    for (const int y : {-32768, 5, 32767}) {
      for (const int z : {-32768, 0, 32767}) ends.add({x, y, z}, 1);
    }
  }
  const OctreeSurface surface = ends.surface();
  EXPECT_EQ(surface.size(), 27);
  EXPECT_LT(surface.memory(), 32 << 20);
  EXPECT_THROW(surface.voxels(), std::invalid_argument);
  Random random(23);
  int hits = 0;
  for (int ray = 0; ray < 400; ++ray) {
    const Point target =
        ends.edge *
        (ends.all[ray % 27].cast<double>().array() + uniform(random, 0.1, 0.9)).matrix();
    const Point from = uniform_point(random, ray % 2 == 0 ? 1600.0 : 30.0);
    const Point along = (target - from).normalized();
    const RayHit hit = surface.cast(from, along, 1e5);
    ASSERT_EQ(hit.range, slow_range(ends, from, along, 1e5)) << ray;
    hits += hit.hit();
  }
  EXPECT_EQ(hits, 400);
  const OctreeSurface eighth(OctreeLeaves{0.05, {{Point::Constant(819.2), 1638.4, 1.0}}});
  EXPECT_EQ(eighth.size(), std::int64_t{1} << 45);
  EXPECT_NEAR(eighth.cast({-10, 700, 700}, {1, 0, 0}, 50).range, 10.0, 1e-9);
  EXPECT_EQ(eighth.cast({800, 700, 700}, {1, 0, 0}, 50).range, 0.0);
  EXPECT_NEAR(eighth.clearance({-3, -4, 700}, 50), 5.0, 1e-9);
}

/// A float as a double. Where GCC 12 vectorises, it takes a conversion to float and back for none
/// at all, but for a volatile one.
double to_double(float value) {
  const volatile float single = value;
  return single;
}

/// What OctoMap's `castRay` answers, and the same ray in our terms.
struct TheirRay {
  TheirRay(const octomap::OcTree& tree, const Point& origin, const Point& direction, double range)
      : from(origin.x(), origin.y(), origin.z()),
        along(direction.x(), direction.y(), direction.z()) {
    octomap::point3d end;
    hit = tree.castRay(from, along, end, true, range);
    const octomap::OcTreeKey key = tree.coordToKey(end);
    voxel = Cell(key[0], key[1], key[2]).array() - 32768;
    along.normalize();
  }
  Point origin() const { return {to_double(from.x()), to_double(from.y()), to_double(from.z())}; }
  Point direction() const {
    return Point(to_double(along.x()), to_double(along.y()), to_double(along.z())).normalized();
  }

  octomap::point3d from;
  octomap::point3d along;
  bool hit;
  Cell voxel;
};

TEST(OctreeRays, HitTheVoxelsThatOctoMapsDoButForThoseOnlyTouched) {
  Random random(24);
  constexpr double kRange = 30.0;
  int same = 0, none = 0, touched = 0;
  for (int scene = 0; scene < 30; ++scene) {
    const double edge = scene % 2 == 0 ? 0.25 : 0.1;
    octomap::OcTree tree(edge);
    Voxels voxels(edge);
    const auto occupy = [&](const Cell& at, int size) {
      for (int x = 0; x < size; ++x) {
        for (int y = 0; y < size; ++y) {
          for (int z = 0; z < size; ++z) {
            tree.setNodeValue(
                octomap::OcTreeKey(32768 + at.x() + x, 32768 + at.y() + y, 32768 + at.z() + z),
                2.0F, true);
          }
        }
      }
    };
    for (int n = 0; n < 150; ++n) {
      occupy({draw(random, -30, 30), draw(random, -30, 30), draw(random, -30, 30)}, 1);
    }
    for (int n = 0; n < 4; ++n) {
      const int size = 1 << draw(random, 1, 4);
      occupy(Cell(draw(random, -2, 1), draw(random, -2, 1), draw(random, -2, 1)) * size, size);
    }
    tree.updateInnerOccupancy();
    tree.prune();
    std::size_t leaves = 0;
    for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf, ++leaves) {
      const int size = static_cast<int>(std::lround(leaf.getSize() / edge));
      const octomap::OcTreeKey key = leaf.getIndexKey();
      voxels.add(Cell(key[0], key[1], key[2]).array() - 32768, size);
    }
    ASSERT_LT(leaves, voxels.all.size());  // some are pruned
    const OctreeSurface surface = voxels.surface();
    ASSERT_EQ(static_cast<std::size_t>(surface.size()), voxels.all.size());
    Path origins, directions;
    random_rays(random, voxels, 400, origins, directions);
    for (Eigen::Index n = 0; n < origins.rows(); ++n) {
      const TheirRay theirs(tree, origins.row(n).transpose(), directions.row(n).transpose(),
                            kRange);
      const Point from = theirs.origin();
      const Point along = theirs.direction();
      const RayHit ours = surface.cast(from, along, kRange - 2 * edge);
      const Cell cell = (ours.inside / edge).array().floor().matrix().cast<int>();
      if (ours.hit() && theirs.hit && cell == theirs.voxel) {
        ++same;
      } else if (theirs.hit) {
        // Theirs is one that the ray does not go through, or it lies beyond the range.
        const auto [t_in, t_out] = times_in(voxels, theirs.voxel, from, along);
        if (t_in < kRange - 3 * edge) {
          ++touched;
          ASSERT_LT(t_out - t_in, 1e-6 * edge) << scene << " " << n;
        }
      } else {
        ASSERT_FALSE(ours.hit()) << scene << " " << n;
        ++none;
      }
    }
  }
  EXPECT_GT(same, 6000);
  EXPECT_GT(none, 1000);
  EXPECT_GT(touched, 10);  // of rays along faces, through edges and corners
  EXPECT_LT(touched, 1000);
  RecordProperty("same", same);
  RecordProperty("touched", touched);
}

TEST(OctreeRays, VoxelsScatteredTooWidelyAreRefused) {
  // A brick, and the nodes above it, for each voxel.
  Random random(25);
  std::vector<sensing::VoxelCube> cubes;
  for (int n = 0; n < 80; ++n) {
    cubes.push_back({uniform_point(random, 3e4).cast<int>(), 1});
  }
  const std::int64_t bytes = sensing::VoxelBricks(cubes).bytes();
  EXPECT_LT(bytes, 2 << 20);
  EXPECT_THROW(sensing::VoxelBricks(cubes, bytes / 2), std::invalid_argument);
  Path points(2, 3);
  points << 0, 0, 0, 9e8, 9e8, 9e8;
  EXPECT_EQ(OctreeSurface(points, 1e3).size(), 2);
  EXPECT_THROW(OctreeSurface(points, 1.0), std::invalid_argument);
}

}  // namespace
}  // namespace ltp
