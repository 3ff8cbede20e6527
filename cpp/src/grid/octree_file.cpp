// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/grid/octree_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
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

Cell voxel_of(const std::string& path, const OctreeLeaf& leaf, double resolution) {
  Cell voxel;
  for (int axis = 0; axis < 3; ++axis) {
    const double index = std::floor(leaf.centre[axis] / resolution);
    if (!(index >= -Octree::kReach && index < Octree::kReach)) {
      refuse(path, "a leaf at " + std::to_string(leaf.centre[axis]) +
                       " m: expected within 32768 voxels of the origin");
    }
    voxel[axis] = static_cast<int>(index);
  }
  return voxel;
}

Octree to_tree(const std::string& path, const OctreeLeaves& octree) {
  Octree tree(octree.resolution);
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
    // A float may round what is below zero to -0, which is occupied.
    const float rounded = static_cast<float>(leaf.log_odds);
    const float log_odds =
        leaf.occupied() || rounded < 0.0f ? rounded : -std::numeric_limits<float>::min();
    tree.set(voxel_of(path, leaf, octree.resolution), log_odds);
  }
  return tree;
}

/// Whether a path asks for `.bt`, not `.ot`.
bool is_binary(const std::string& path) {
  const std::string extension = fs::path(path).extension().string();
  if (extension != ".bt" && extension != ".ot") {
    refuse(path, "extension '" + extension + "': expected .bt or .ot");
  }
  return extension == ".bt";
}

void check_resolution(const std::string& path, double resolution) {
  if (!(resolution > 0.0 && resolution <= 1e9)) {
    refuse(path,
           "resolution = " + std::to_string(resolution) + ": expected a positive number of metres");
  }
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
  is_binary(path);
  check_resolution(path, octree.resolution);
  write_octree(path, to_tree(path, octree));
}

void write_octree(const std::string& path, const Octree& octree) {
  const bool binary = is_binary(path);
  check_resolution(path, octree.resolution());
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  octree.write(stream, binary);
  write_bytes(path, stream.str());
}

}  // namespace ltp
