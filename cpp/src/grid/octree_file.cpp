// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/grid/octree_file.hpp"

#include <octomap/OcTree.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>
#include <stdexcept>

#include "octree_bytes.hpp"

namespace ltp {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestFile = std::uintmax_t{1} << 30;
constexpr std::int64_t kMostLeaves = std::int64_t{1} << 25;  // 1.6 GB of them

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw std::invalid_argument("octree file '" + path + "': " + why);
}

std::string read_bytes(const std::string& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) refuse(path, "not a file");
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) refuse(path, error.message());
  if (size > kLargestFile) {
    refuse(path, "it has " + std::to_string(size) + " bytes: expected at most 2^30");
  }
  std::string bytes(size, '\0');
  std::ifstream stream(path, std::ios::binary);
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(size))) {
    refuse(path, "it cannot be read");
  }
  return bytes;
}

OctreeLeaf to_world(const octree::Leaf& leaf, double resolution) {
  const int voxels = 1 << (octree::kDepth - leaf.depth);
  OctreeLeaf world;
  for (int axis = 0; axis < 3; ++axis) {
    world.centre[axis] = (leaf.key[axis] - octree::kCentreKey + 0.5 * voxels) * resolution;
  }
  world.size = voxels * resolution;
  world.log_odds = leaf.log_odds;
  return world;
}

octomap::OcTreeKey key_of(const std::string& path, const OctreeLeaf& leaf, double resolution) {
  octomap::OcTreeKey key;
  for (int axis = 0; axis < 3; ++axis) {
    const double index = std::floor(leaf.centre[axis] / resolution) + octree::kCentreKey;
    if (!(index >= 0.0 && index < 2.0 * octree::kCentreKey)) {
      refuse(path, "a leaf at " + std::to_string(leaf.centre[axis]) +
                       " m: expected within 32768 voxels of the origin");
    }
    key[axis] = static_cast<octomap::key_type>(index);
  }
  return key;
}

octomap::OcTree to_tree(const std::string& path, const OctreeLeaves& octree, bool binary) {
  octomap::OcTree tree(octree.resolution);
  // Values are stored as they are; clamping is the map's business.
  tree.setClampingThresMin(0.0);
  tree.setClampingThresMax(1.0);
  for (const OctreeLeaf& leaf : octree.leaves) {
    const double ratio = leaf.size / octree.resolution;
    if (!(std::abs(ratio - 1.0) < 1e-6)) {
      refuse(path, "a leaf of size " + std::to_string(leaf.size) + " m: expected the resolution, " +
                       std::to_string(octree.resolution) + " m");
    }
    if (!std::isfinite(static_cast<float>(leaf.log_odds))) {
      refuse(path, "a leaf with log-odds " + std::to_string(leaf.log_odds) +
                       ": expected a finite number");
    }
    const float clamped = leaf.occupied() ? octree::kOccupied : octree::kFree;
    tree.setNodeValue(key_of(path, leaf, octree.resolution),
                      binary ? clamped : static_cast<float>(leaf.log_odds), true);
  }
  tree.updateInnerOccupancy();
  tree.prune();
  return tree;
}

/// As OctoMap writes it. Its own function reports to stderr, and prints six digits of the
/// resolution, which would move far voxels by metres.
void write_header(const octomap::OcTree& tree, bool binary, std::ostream& stream) {
  stream << (binary ? octree::kBinaryMagic : octree::kFullMagic) << "\n"
         << "# (feel free to add / change comments, but leave the first line as it is!)\n#\n"
         << "id OcTree\n"
         << "size " << tree.size() << "\n"
         << "res " << std::setprecision(std::numeric_limits<double>::max_digits10)
         << tree.getResolution() << "\n"
         << "data\n";
}

void write_bytes(const std::string& path, const std::string& bytes) {
  const std::string temporary = path + "." + std::to_string(::getpid()) + ".tmp";
  std::error_code ignored;
  errno = 0;
  std::ofstream stream(temporary, std::ios::binary | std::ios::trunc);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream) {
    const std::string why = errno != 0 ? std::strerror(errno) : "write error";
    fs::remove(temporary, ignored);
    throw std::runtime_error("octree file '" + path + "': it cannot be written: " + why);
  }
  std::error_code error;
  fs::rename(temporary, path, error);
  if (error) {
    fs::remove(temporary, ignored);
    throw std::runtime_error("octree file '" + path +
                             "': it cannot be written: " + error.message());
  }
}

}  // namespace

OctreeLeaves read_octree(const std::string& path) {
  const std::string bytes = read_bytes(path);
  OctreeLeaves octree;
  try {
    const octree::Header header = octree::read_header(bytes);
    std::int64_t count = 0;
    octree::walk(header, bytes, [&](const octree::Leaf&) {
      if (++count > kMostLeaves) throw std::invalid_argument("it has more than 2^25 leaves");
    });
    octree.resolution = header.resolution;
    octree.leaves.reserve(count);
    octree::walk(header, bytes, [&](const octree::Leaf& leaf) {
      octree.leaves.push_back(to_world(leaf, header.resolution));
    });
  } catch (const std::invalid_argument& error) {
    refuse(path, error.what());
  }
  return octree;
}

void write_octree(const std::string& path, const OctreeLeaves& octree) {
  const std::string extension = fs::path(path).extension().string();
  if (extension != ".bt" && extension != ".ot") {
    refuse(path, "extension '" + extension + "': expected .bt or .ot");
  }
  if (!(octree.resolution > 0.0 && octree.resolution <= 1e9)) {
    refuse(path, "resolution = " + std::to_string(octree.resolution) +
                     ": expected a positive number of metres");
  }
  const bool binary = extension == ".bt";
  const octomap::OcTree tree = to_tree(path, octree, binary);
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  write_header(tree, binary, stream);
  if (tree.getRoot() != nullptr) {
    if (binary) {
      tree.writeBinaryNode(stream, tree.getRoot());
    } else {
      tree.writeData(stream);
    }
  }
  write_bytes(path, stream.str());
}

}  // namespace ltp
