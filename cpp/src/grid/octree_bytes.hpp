// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The bytes of OctoMap's two file formats, walked without trusting any of them.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string_view>

namespace ltp::octree {

inline constexpr std::string_view kBinaryMagic = "# Octomap OcTree binary file";  ///< `.bt`
inline constexpr std::string_view kFullMagic = "# Octomap OcTree file";           ///< `.ot`
inline constexpr int kDepth = 16;           ///< levels below the root
inline constexpr int kCentreKey = 1 << 15;  ///< the key of the voxel above the world's origin
inline constexpr float kOccupied = 3.5f;    ///< log-odds; OctoMap's default clamping
inline constexpr float kFree = -2.0f;       ///< log-odds; OctoMap's default clamping

/// What a file says before its data.
struct Header {
  bool binary = false;      ///< `.bt`: two bits a child; otherwise `.ot`: log-odds
  int node_bytes = 0;       ///< `.ot`: bytes of a node's value; the log-odds are the first four
  std::uint64_t nodes = 0;  ///< stated number of nodes
  double resolution = 0.0;  ///< [m]
  std::size_t data = 0;     ///< where the data begin
};

/// A leaf at a depth; its key counts voxels of the finest level along each axis.
struct Leaf {
  std::array<int, 3> key;  ///< of its lowest corner, 0 ... 65535
  int depth;
  float log_odds;
};

/// Both throw `std::invalid_argument` that says what is wrong; the caller adds the file's name.
Header read_header(std::string_view bytes);

/// Visits the leaves depth first. Throws at the first byte that is not a valid tree's, and if the
/// tree is not exactly as long as the bytes or has another number of nodes than the header says.
void walk(const Header& header, std::string_view bytes,
          const std::function<void(const Leaf&)>& visit);

}  // namespace ltp::octree
