// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The octree against a plain table of voxels.
#include "ltp/grid/octree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>

#include "allocations.hpp"

namespace ltp {
namespace {

using Random = std::mt19937_64;
using Table = std::map<std::array<int, 3>, float>;

std::array<int, 3> key(const Cell& voxel) { return {voxel.x(), voxel.y(), voxel.z()}; }

template <typename Visitor>
void for_each_voxel(const Cell& low, const Cell& high, Visitor&& visit) {
  for (int x = low.x(); x < high.x(); ++x) {
    for (int y = low.y(); y < high.y(); ++y) {
      for (int z = low.z(); z < high.z(); ++z) visit(Cell(x, y, z));
    }
  }
}

/// All that an octree knows of a box, each voxel once.
Table table_of(const Octree& octree, const Cell& low, const Cell& high, bool occupied_only) {
  Table table;
  octree.for_each(low, high, occupied_only, [&](const Cell& from, const Cell& to, float value) {
    for_each_voxel(from, to, [&](const Cell& voxel) {
      EXPECT_TRUE(table.emplace(key(voxel), value).second) << "twice: " << voxel.transpose();
      EXPECT_TRUE((voxel.array() >= low.array()).all() && (voxel.array() < high.array()).all());
    });
  });
  return table;
}

Table part_of(const Table& table, const Cell& low, const Cell& high, bool occupied_only) {
  Table part;
  for (const auto& [at, value] : table) {
    const Cell voxel(at[0], at[1], at[2]);
    const bool inside =
        (voxel.array() >= low.array()).all() && (voxel.array() < high.array()).all();
    if (inside && (!occupied_only || value >= 0.0f)) part[at] = value;
  }
  return part;
}

TEST(Octree, IsATableOfVoxels) {
  Random random(31);
  const float values[] = {0.85f, -2.0f, 0.0f, 3.5f, -0.4f};
  // Round the origin, where all eight children of the root meet, and at the very ends.
  for (const Cell& middle : {Cell(0, 0, 0), Cell(1000, -777, 13), Cell(32752, -32752, 32752)}) {
    Octree octree(0.5);
    Table table;
    const auto index = [&] { return static_cast<int>(random() % 32) - 16; };
    for (int step = 0; step < 1500; ++step) {
      const Cell voxel = middle + Cell(index(), index(), index());
      const float value = values[random() % 5];
      if (step % 10 != 9) {
        octree.set(voxel, value);
        table[key(voxel)] = value;
      } else {
        const int level = static_cast<int>(random() % 4);
        const Cell low = voxel.unaryExpr([&](int i) { return i >> level << level; });
        octree.merge(low, level, value);
        for_each_voxel(low, low.array() + (1 << level), [&](const Cell& at) {
          const auto [known, fresh] = table.emplace(key(at), value);
          if (!fresh && value >= 0.0f) known->second = std::max(known->second, value);
        });
      }
      ASSERT_EQ(octree.find(voxel), table.at(key(voxel)));
      if (step % 50 != 0) continue;
      const Cell low = middle + Cell(index(), index(), index());
      const Cell high = middle + Cell(index(), index(), index());
      for (const bool occupied_only : {false, true}) {
        ASSERT_EQ(table_of(octree, low, high, occupied_only),
                  part_of(table, low, high, occupied_only));
      }
    }
    const Cell all = Cell::Constant(Octree::kReach);
    EXPECT_EQ(table_of(octree, -all, all, false), table);
    const Octree copy(octree);
    octree.clear();
    EXPECT_EQ(octree.nodes(), 0);
    EXPECT_EQ(table_of(copy, -all, all, false), table);
    EXPECT_EQ(octree.find(middle), std::nullopt);
  }
}

TEST(Octree, KeepsCubesThatAreAlikeAsOneLeaf) {
  Octree octree(1.0);
  const Cell low(-32768, -32768, -32768);
  octree.merge(low, Octree::kLevels, -2.0f);  // all that it can hold
  EXPECT_EQ(octree.nodes(), 1);
  octree.merge(Cell(64, 0, -64), 6, 1.0f);
  EXPECT_EQ(octree.nodes(), 1 + 8 * 10);
  EXPECT_EQ(octree.find(Cell(64, 0, -1)), 1.0f);
  EXPECT_EQ(octree.find(Cell(63, 0, -1)), -2.0f);
  const std::int64_t before = test::allocations();
  octree.set(Cell(70, 3, -9), 1.0f);
  octree.merge(Cell(64, 0, -64), 5, -2.0f);
  EXPECT_EQ(test::allocations() - before, 0) << "nothing new";
  EXPECT_EQ(octree.nodes(), 81);
  EXPECT_GT(octree.bytes(), 81 * 16);
}

}  // namespace
}  // namespace ltp
