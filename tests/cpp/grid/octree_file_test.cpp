// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// OctoMap's files: OctoMap reads what we write, we read what it writes, and nothing hostile passes.
#include "ltp/grid/octree_file.hpp"

#include <gtest/gtest.h>
#include <octomap/ColorOcTree.h>
#include <octomap/OcTree.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace ltp {
namespace {

namespace fs = std::filesystem;
using Random = std::mt19937_64;
using Key = std::array<int, 3>;

class OctreeFile : public testing::Test {
 protected:
  void SetUp() override {
    const testing::TestInfo* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() /
              ("ltp_octree_" + std::to_string(::getpid()) + "_" + info->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string at(const std::string& name) const { return (folder_ / name).string(); }

  std::string put(const std::string& name, const std::string& bytes) const {
    std::ofstream(at(name), std::ios::binary) << bytes;
    return at(name);
  }
  std::string get(const std::string& name) const {
    std::ifstream stream(at(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  /// What the reader says about these bytes; empty if it accepts them.
  std::string verdict(const std::string& bytes) const {
    const std::string path = put("hostile.bt", bytes);
    try {
      read_octree(path);
      return "";
    } catch (const std::invalid_argument& error) {
      const std::string text = error.what();
      EXPECT_NE(text.find(path), std::string::npos) << text;
      return text;
    }
  }
  void expect_refused(const std::string& bytes, const std::string& because) const {
    const std::string text = verdict(bytes);
    EXPECT_NE(text.find(because), std::string::npos)
        << "'" << text << "' lacks '" << because << "'";
  }

  fs::path folder_;
};

std::string header(const std::string& magic, const std::string& id, const std::string& size,
                   const std::string& resolution) {
  return magic + "\n# a comment\nid " + id + "\nsize " + size + "\nres " + resolution + "\ndata\n";
}
std::string bt(const std::string& size, const std::string& data, const std::string& res = "0.5") {
  return header("# Octomap OcTree binary file", "OcTree", size, res) + data;
}
std::string ot(const std::string& size, const std::string& data, const std::string& id = "OcTree") {
  return header("# Octomap OcTree file", id, size, "0.5") + data;
}
std::string node(float log_odds, unsigned char children) {
  std::string bytes(5, '\0');
  std::memcpy(bytes.data(), &log_odds, 4);
  bytes[4] = static_cast<char>(children);
  return bytes;
}

/// Blocks, so that something can be pruned, and single voxels round the origin.
std::map<Key, float> random_voxels(Random& random) {
  std::map<Key, float> voxels;
  const auto index = [&] { return static_cast<int>(random() % 60) - 30; };
  for (int n = 0; n < 300; ++n) {
    voxels[{index(), index(), index()}] = static_cast<float>(random() % 1000) / 200 - 2;
  }
  const Key corner = {-16, 8, 24};
  for (int n = 0; n < 512; ++n) {
    voxels[{corner[0] + n % 8, corner[1] + n / 8 % 8, corner[2] + n / 64}] = 1.25f;
  }
  return voxels;
}

OctreeLeaves leaves_of(const std::map<Key, float>& voxels, double resolution) {
  OctreeLeaves octree;
  octree.resolution = resolution;
  for (const auto& [key, value] : voxels) {
    const Point centre = resolution * Point(key[0] + 0.5, key[1] + 0.5, key[2] + 0.5);
    octree.leaves.push_back({centre, resolution, value});
  }
  return octree;
}

/// Leaves cut into voxels.
std::map<Key, float> voxels_of(const OctreeLeaves& octree) {
  std::map<Key, float> voxels;
  for (const OctreeLeaf& leaf : octree.leaves) {
    const int edge = static_cast<int>(std::lround(leaf.size / octree.resolution));
    Key low;
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] =
          static_cast<int>(std::lround((leaf.centre[axis] - 0.5 * leaf.size) / octree.resolution));
    }
    for (int n = 0; n < edge * edge * edge; ++n) {
      const Key key = {low[0] + n % edge, low[1] + n / edge % edge, low[2] + n / (edge * edge)};
      EXPECT_TRUE(voxels.emplace(key, static_cast<float>(leaf.log_odds)).second) << "twice";
    }
  }
  return voxels;
}

template <typename Tree>
void fill(Tree& tree, const std::map<Key, float>& voxels) {
  for (const auto& [key, value] : voxels) {
    const octomap::OcTreeKey at(key[0] + 32768, key[1] + 32768, key[2] + 32768);
    tree.setNodeValue(at, value, true);
  }
  tree.updateInnerOccupancy();
  tree.prune();
}

void expect_same(const std::map<Key, float>& found, const std::map<Key, float>& expected,
                 bool binary) {
  ASSERT_EQ(found.size(), expected.size());
  for (const auto& [key, value] : expected) {
    const auto here = found.find(key);
    ASSERT_NE(here, found.end()) << key[0] << " " << key[1] << " " << key[2];
    EXPECT_EQ(here->second, binary ? (value >= 0 ? 3.5f : -2.0f) : value);
  }
}

TEST_F(OctreeFile, OctoMapReadsWhatWeWrite) {
  Random random(1);
  const std::map<Key, float> voxels = random_voxels(random);
  for (const std::string name : {"map.bt", "map.ot"}) {
    write_octree(at(name), leaves_of(voxels, 0.3));
    std::unique_ptr<octomap::OcTree> tree;
    if (name == "map.bt") {
      tree = std::make_unique<octomap::OcTree>(1.0);
      ASSERT_TRUE(tree->readBinary(at(name)));
    } else {
      tree.reset(dynamic_cast<octomap::OcTree*>(octomap::AbstractOcTree::read(at(name))));
      ASSERT_NE(tree, nullptr);
    }
    EXPECT_EQ(tree->getResolution(), 0.3);
    EXPECT_LT(tree->getNumLeafNodes(), voxels.size());  // pruned
    std::size_t known = 0;
    for (int n = 0; n < 64 * 64 * 64; ++n) {
      const Key key = {n % 64 - 32, n / 64 % 64 - 32, n / 4096 - 32};
      const octomap::OcTreeNode* found =
          tree->search(octomap::OcTreeKey(key[0] + 32768, key[1] + 32768, key[2] + 32768));
      const auto expected = voxels.find(key);
      ASSERT_EQ(found != nullptr, expected != voxels.end());
      if (found == nullptr) continue;
      ++known;
      EXPECT_EQ(tree->isNodeOccupied(found), expected->second >= 0);
      if (name == "map.ot") {
        EXPECT_EQ(found->getLogOdds(), expected->second);
      }
    }
    EXPECT_EQ(known, voxels.size());
  }
}

TEST_F(OctreeFile, WeReadWhatOctoMapWrites) {
  Random random(2);
  const std::map<Key, float> voxels = random_voxels(random);
  octomap::OcTree tree(0.25);
  fill(tree, voxels);
  ASSERT_TRUE(tree.write(at("map.ot")));
  expect_same(voxels_of(read_octree(at("map.ot"))), voxels, false);
  ASSERT_TRUE(tree.writeBinary(at("map.bt")));
  const OctreeLeaves binary = read_octree(at("map.bt"));
  EXPECT_EQ(binary.resolution, 0.25);
  expect_same(voxels_of(binary), voxels, true);

  octomap::ColorOcTree coloured(0.25);
  fill(coloured, voxels);
  coloured.setNodeColor(octomap::OcTreeKey(32768, 32768, 32768), 1, 2, 3);
  ASSERT_TRUE(coloured.write(at("coloured.ot")));
  expect_same(voxels_of(read_octree(at("coloured.ot"))), voxels, false);
  ASSERT_TRUE(coloured.writeBinary(at("coloured.bt")));
  expect_same(voxels_of(read_octree(at("coloured.bt"))), voxels, true);
}

TEST_F(OctreeFile, ARoundTripKeepsEveryVoxel) {
  Random random(3);
  for (const double resolution : {0.1, 1.0 / 3.0, 2.0}) {
    const std::map<Key, float> voxels = random_voxels(random);
    for (const std::string name : {"map.bt", "map.ot"}) {
      write_octree(at(name), leaves_of(voxels, resolution));
      const OctreeLeaves read = read_octree(at(name));
      EXPECT_EQ(read.resolution, resolution);
      expect_same(voxels_of(read), voxels, name == "map.bt");
    }
  }
  const OctreeLeaf far_corner{Point::Constant(-32767.5 * 0.1), 0.1, 1.0};
  write_octree(at("corner.ot"), {0.1, {far_corner}});
  ASSERT_EQ(read_octree(at("corner.ot")).leaves.size(), 1u);
  EXPECT_TRUE(read_octree(at("corner.ot")).leaves[0].centre.isApprox(far_corner.centre, 1e-12));
}

TEST_F(OctreeFile, AnEmptyTreeIsAFileToo) {
  for (const std::string name : {"map.bt", "map.ot"}) {
    write_octree(at(name), {0.5, {}});
    EXPECT_EQ(read_octree(at(name)).resolution, 0.5);
    EXPECT_TRUE(read_octree(at(name)).leaves.empty());
  }
}

TEST_F(OctreeFile, TheLaterOfTwoLeavesCounts) {
  const Point centre = Point::Constant(0.25);
  write_octree(at("map.ot"), {0.5, {{centre, 0.5, 1.0}, {centre, 0.5, -1.0}}});
  ASSERT_EQ(read_octree(at("map.ot")).leaves.size(), 1u);
  EXPECT_FALSE(read_octree(at("map.ot")).leaves[0].occupied());
}

TEST_F(OctreeFile, AFileCutAnywhereIsRefused) {
  Random random(4);
  std::map<Key, float> few;
  for (const auto& [key, value] : random_voxels(random)) {
    if (few.size() < 6) few[key] = value;
  }
  for (const std::string name : {"map.bt", "map.ot"}) {
    write_octree(at(name), leaves_of(few, 0.5));
    const std::string whole = get(name);
    ASSERT_EQ(verdict(whole), "");
    for (std::size_t size = 0; size < whole.size(); ++size) {
      EXPECT_NE(verdict(whole.substr(0, size)), "") << name << " cut after " << size << " bytes";
    }
    expect_refused(whole + "x", "1 bytes after the tree");
  }
}

TEST_F(OctreeFile, ASpoiledFileIsReadOrRefused) {
  Random random(5);
  for (const std::string name : {"map.bt", "map.ot"}) {
    write_octree(at(name), leaves_of(random_voxels(random), 0.5));
    const std::string whole = get(name);
    int refused = 0;
    for (int n = 0; n < 250; ++n) {
      std::string spoiled = whole;
      for (std::uint64_t k = 0; k <= random() % 4; ++k) {
        spoiled[random() % whole.size()] = static_cast<char>(random());
      }
      refused += !verdict(spoiled).empty();
    }
    EXPECT_GT(refused, 25);
  }
}

TEST_F(OctreeFile, ATreeWithoutEndIsRefusedAtTheSixteenthLevel) {
  // One child with children, on and on: OctoMap's own reader would follow it as deep as it goes.
  std::string spine;
  for (int n = 0; n < 200000; ++n) spine += std::string("\x03\x00", 2);
  expect_refused(bt("200001", spine), "deeper than 16 levels");
  expect_refused(bt("4294967295", std::string(200000, '\xff')), "deeper than 16 levels");
  std::string full_spine;
  for (int n = 0; n < 200000; ++n) full_spine += node(1.0f, 1);
  expect_refused(ot("200000", full_spine), "deeper than 16 levels");
  // Sixteen levels are fine.
  std::string deepest;
  for (int n = 0; n < 15; ++n) deepest += std::string("\x03\x00", 2);
  const std::string path = put("deep.bt", bt("17", deepest + std::string("\x02\x00", 2)));
  const OctreeLeaves read = read_octree(path);
  ASSERT_EQ(read.leaves.size(), 1u);
  EXPECT_EQ(read.leaves[0].size, 0.5);
  EXPECT_TRUE(read.leaves[0].occupied());
  EXPECT_TRUE(read.leaves[0].centre.isApprox(Point::Constant(-16384 + 0.25), 1e-12));
}

TEST_F(OctreeFile, AHeaderMustBeTrue) {
  const std::string leaf("\x02\x00", 2);  // the root and one occupied octant
  EXPECT_EQ(verdict(bt("2", leaf)), "");
  expect_refused(bt("3", leaf), "size = 3");
  expect_refused(bt("0", leaf), "2 bytes after the tree");
  expect_refused(bt("18446744073709551615", leaf), "size = 18446744073709551615");
  expect_refused(bt("18446744073709551616", leaf), "size = ");
  expect_refused(bt("-2", leaf), "size = ");
  expect_refused(bt("two", leaf), "size = ");
  expect_refused(bt("", leaf), "size = ");
  for (const std::string res : {"0", "-1", "nan", "inf", "1e400", "1e10", "", "0.5m", "\x01"}) {
    expect_refused(bt("2", leaf, res), "res = ");
  }
  expect_refused(header("# Octomap OcTree file", "Ship", "2", "0.5") + leaf, "id = \"Ship\"");
  expect_refused(header("# Octomap", "OcTree", "2", "0.5") + leaf, "first line");
  expect_refused("", "first line");
  expect_refused("# Octomap OcTree binary file\nsize 2\nres 1\ndata\n" + leaf, "\"id\"");
  expect_refused("# Octomap OcTree binary file\nid OcTree\nres 1\ndata\n" + leaf, "\"size\"");
  expect_refused("# Octomap OcTree binary file\nid OcTree\nsize 2\ndata\n" + leaf, "\"res\"");
  expect_refused("# Octomap OcTree binary file\nid OcTree\nsize 2\nres 1\n" + leaf, "\"data\"");
  expect_refused("# Octomap OcTree binary file\n" + std::string(1 << 20, '#') + "\ndata\n",
                 "\"data\"");
}

TEST_F(OctreeFile, ValuesMustMakeSense) {
  EXPECT_EQ(verdict(ot("1", node(0.5f, 0))), "");
  expect_refused(ot("1", node(std::nanf(""), 0)), "log-odds nan");
  expect_refused(ot("2", node(0.5f, 1) + node(-INFINITY, 0)), "node 2 has log-odds -inf");
  expect_refused(bt("1", std::string(2, '\0')), "no children");
  expect_refused(bt("2", std::string("\x03\x00\x00\x00", 4)), "no children");
}

TEST_F(OctreeFile, WhatIsNoFileIsNamed) {
  for (const std::string& path : {at("absent.bt"), folder_.string(), std::string("/dev/zero")}) {
    try {
      read_octree(path);
      ADD_FAILURE() << path;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(path), std::string::npos) << error.what();
    }
  }
}

TEST_F(OctreeFile, ALeafThatOctoMapCannotHoldIsRefused) {
  const Point centre = Point::Constant(0.25);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::pair<std::string, OctreeLeaves>> cases = {
      {"leaf of size", {0.5, {{centre, 1.0, 1.0}}}},
      {"leaf of size", {0.5, {{centre, nan, 1.0}}}},
      {"log-odds", {0.5, {{centre, 0.5, nan}}}},
      {"log-odds", {0.5, {{centre, 0.5, 1e300}}}},
      {"leaf at", {0.5, {{Point(0, 0, 20000), 0.5, 1.0}}}},
      {"leaf at", {0.5, {{Point(0, nan, 0), 0.5, 1.0}}}},
      {"resolution", {0.0, {}}},
      {"resolution", {nan, {}}},
  };
  for (const auto& [because, octree] : cases) {
    try {
      write_octree(at("map.ot"), octree);
      ADD_FAILURE() << because;
    } catch (const std::invalid_argument& error) {
      const std::string text = error.what();
      EXPECT_NE(text.find(because), std::string::npos) << text;
      EXPECT_NE(text.find(at("map.ot")), std::string::npos) << text;
    }
    EXPECT_FALSE(fs::exists(at("map.ot")));
  }
  EXPECT_THROW(write_octree(at("map.vtk"), {0.5, {}}), std::invalid_argument);
}

TEST_F(OctreeFile, AFailedWriteLeavesNothingBehindAndNamesTheFile) {
  const std::string path = at("no_such_folder/map.bt");
  try {
    write_octree(path, {0.5, {}});
    ADD_FAILURE();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find(path), std::string::npos) << error.what();
  }
  // The target is a folder: the rename fails after the temporary file was written.
  fs::create_directories(at("map.bt/inner"));
  EXPECT_THROW(write_octree(at("map.bt"), {0.5, {}}), std::runtime_error);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(OctreeFile, NothingIsPrinted) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  Random random(6);
  write_octree(at("map.bt"), leaves_of(random_voxels(random), 0.5));
  write_octree(at("map.ot"), leaves_of(random_voxels(random), 0.5));
  read_octree(at("map.bt"));
  read_octree(at("map.ot"));
  verdict("# Octomap OcTree binary file\nunknown word\ndata\n");
  verdict(bt("3", std::string("\x02\x00", 2)));
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace ltp
