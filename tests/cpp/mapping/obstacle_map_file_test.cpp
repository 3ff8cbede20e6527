// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The obstacle map's files are OctoMap's: each reads what the other wrote.
#include <gtest/gtest.h>
#include <octomap/octomap.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <random>
#include <string>

#include "ltp/mapping/obstacle_map.hpp"
#include "mapping/promises.hpp"

namespace ltp {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test, removed with it.
class ObstacleMapFile : public ::testing::Test {
 protected:
  ObstacleMapFile() {
    folder_ = fs::temp_directory_path() /
              ("ltp_" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) + "_" +
               std::to_string(std::random_device{}()));
    fs::create_directories(folder_);
  }
  ~ObstacleMapFile() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

 private:
  fs::path folder_;
};

ObstacleMapOptions small_map(bool carve) {
  ObstacleMapOptions options;
  options.dims = {20, 16, 10};
  options.carve_free_space = carve;
  return options;
}

void insert_random(ObstacleMap& map, const Point& centre, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  for (int scan = 0; scan < 5; ++scan) {
    Path hits(50, 3);
    for (int i = 0; i < hits.size(); ++i) hits.data()[i] = 9.0 * normal(random);
    hits.rowwise() += centre.transpose();
    map.insert(centre, hits);
  }
}

std::unique_ptr<octomap::OcTree> read_by_octomap(const std::string& path) {
  auto tree = std::make_unique<octomap::OcTree>(1.0);
  if (fs::path(path).extension() == ".bt") {
    return tree->readBinary(path) ? std::move(tree) : nullptr;
  }
  return std::unique_ptr<octomap::OcTree>(
      dynamic_cast<octomap::OcTree*>(octomap::AbstractOcTree::read(path)));
}

void expect_same(const ObstacleMap& map, const octomap::OcTree& tree, bool log_odds) {
  const GridFrame& frame = map.voxels().frame();
  int known = 0;
  for (std::int64_t i = 0; i < frame.size(); ++i) {
    const Cell voxel = frame.cell_at(i);
    const Point centre = frame.centre(voxel);
    const octomap::OcTreeNode* node = tree.search(centre.x(), centre.y(), centre.z());
    const bool occupied = node != nullptr && tree.isNodeOccupied(node);
    ASSERT_EQ(map.voxels().blocked(voxel), occupied) << centre.transpose();
    known += node != nullptr;
    if (!map.options().carve_free_space && !occupied) continue;
    ASSERT_EQ(map.log_odds_at(centre) != 0.0, node != nullptr) << centre.transpose();
    if (log_odds && node != nullptr) {
      const float clamped = std::clamp(node->getLogOdds(), -2.0f, 3.5f);
      ASSERT_FLOAT_EQ(static_cast<float>(map.log_odds_at(centre)), clamped);
    }
  }
  ASSERT_GT(known, 100);
  // What lies beyond the window reaches into that of a map that remembers.
  if (!map.mission()) {
    ASSERT_TRUE(map.blocked() == test::to_be_blocked(map));
  }
}

TEST_F(ObstacleMapFile, OctoMapReadsWhatTheMapWrote) {
  std::mt19937_64 random(12);
  for (const bool carve : {false, true}) {
    const Point centre(-333.3, 44.4, 55.5);
    ObstacleMap map(small_map(carve), centre);
    insert_random(map, centre, random);
    for (const char* name : {"map.bt", "map.ot"}) {
      map.save(path(name));
      const auto tree = read_by_octomap(path(name));
      ASSERT_NE(tree, nullptr) << name;
      EXPECT_DOUBLE_EQ(tree->getResolution(), 2.0);
      expect_same(map, *tree, std::string(name) == "map.ot");

      ObstacleMap again(small_map(carve), centre);
      again.load(path(name));
      expect_same(again, *tree, std::string(name) == "map.ot");
      EXPECT_TRUE(again.voxels() == map.voxels());
      EXPECT_TRUE(again.blocked() == map.blocked());
    }
  }
}

TEST_F(ObstacleMapFile, TheMapReadsWhatOctoMapWrote) {
  std::mt19937_64 random(13);
  std::normal_distribution<double> normal;
  octomap::OcTree tree(2.0);
  // A solid block that OctoMap prunes into larger cubes, half of it beyond the window; free space;
  // a point here and there.
  for (float x = 1; x < 64; x += 2) {
    for (float y = 1; y < 32; y += 2) {
      for (float z = -15; z < 16; z += 2) {
        for (int i = 0; i < 6; ++i) tree.updateNode(octomap::point3d(x, y, z), z < 0);
      }
    }
  }
  for (int i = 0; i < 300; ++i) {
    tree.updateNode(
        octomap::point3d(9.0f * normal(random), 9.0f * normal(random), 9.0f * normal(random)),
        i % 3 > 0);
  }
  tree.prune();
  int larger = 0;
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    larger += leaf.getDepth() < 16 && leaf->getOccupancy() > 0.5;
  }
  ASSERT_GT(larger, 10);
  ASSERT_TRUE(tree.write(path("tree.ot")));
  ASSERT_TRUE(tree.writeBinary(path("tree.bt")));  // pruned to the maximum likelihood
  for (const bool carve : {false, true}) {
    for (const char* name : {"tree.bt", "tree.ot"}) {
      ObstacleMapOptions options = small_map(carve);
      options.remember = false;  // what lies beyond the window does not reach in
      ObstacleMap map(options);
      map.load(path(name));
      const auto read = read_by_octomap(path(name));
      ASSERT_NE(read, nullptr);
      expect_same(map, *read, carve);
    }
  }
}

TEST_F(ObstacleMapFile, LoadingKeepsWhatTheMapKnows) {
  ObstacleMap file(small_map(true));
  file.insert(Point(1, 9, 1), Eigen::RowVector3d(1, 15, 1));
  file.insert(Point(1, 1, 1), Eigen::RowVector3d(11, 1, 1));  // passes (3 ... 9, 1, 1)
  file.save(path("map.ot"));
  ObstacleMap map(small_map(true));
  map.insert(Point(1, 1, 1), Eigen::RowVector3d(5, 1, 1));
  map.insert(Point(13, 1, 1), Eigen::RowVector3d(9, 1, 1));
  map.insert(Point(13, 1, 1), Eigen::RowVector3d(5, 1, 1));
  for (int i = 0; i < 3; ++i) map.insert(Point(1, 9, 1), Eigen::RowVector3d(1, 15, 1));
  map.load(path("map.ot"));
  EXPECT_FLOAT_EQ(map.log_odds_at(Point(5, 1, 1)), 1.7f);    // hit twice here, free there
  EXPECT_FLOAT_EQ(map.log_odds_at(Point(7, 1, 1)), -0.4f);   // one vote here, one there
  EXPECT_FLOAT_EQ(map.log_odds_at(Point(11, 1, 1)), 0.85f);  // free here, hit there
  EXPECT_TRUE(map.occupied().blocked_at(Point(11, 1, 1)));
  EXPECT_FLOAT_EQ(map.log_odds_at(Point(1, 15, 1)), 2.55f);  // hit thrice here, once there
}

TEST_F(ObstacleMapFile, LogOddsOfZeroAreOccupiedAsInOctoMap) {
  octomap::OcTree tree(2.0);
  tree.setNodeValue(octomap::point3d(5, 1, 1), 0.0f);
  ASSERT_TRUE(tree.isNodeOccupied(tree.search(5.0, 1.0, 1.0)));
  ASSERT_TRUE(tree.write(path("zero.ot")));
  for (const bool carve : {false, true}) {
    ObstacleMap map(small_map(carve));
    map.load(path("zero.ot"));
    EXPECT_EQ(map.voxels().count(), 1);
    EXPECT_FLOAT_EQ(map.log_odds_at(Point(5, 1, 1)), 0.85f);
    map.insert(Point(1, 1, 1), Eigen::RowVector3d(9, 1, 1));  // passes it
    EXPECT_TRUE(map.occupied().blocked_at(Point(5, 1, 1)));
  }
}

}  // namespace
}  // namespace ltp
