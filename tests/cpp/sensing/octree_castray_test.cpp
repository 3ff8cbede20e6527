// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays beside OctoMap's `castRay`, voxel by voxel, over random pruned trees.
#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include <cmath>

#include "ltp/sensing/octree_surface.hpp"
#include "voxel_scenes.hpp"

namespace ltp {
namespace {

using test::draw;
using test::Random;
using test::random_rays;
using test::times_in;
using test::Voxels;

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

TEST(OctreeCastRay, OursHitsTheSameVoxelsButForThoseOnlyTouched) {
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

}  // namespace
}  // namespace ltp
