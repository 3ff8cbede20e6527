// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// A fuzzer of the walker behind `read_octree`: whatever the bytes, an answer or one clear error.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

#include "octree_bytes.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace octree = ltp::octree;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  std::uint64_t leaves = 0;
  octree::Header header;
  try {
    header = octree::read_header(bytes);
    octree::walk(header, bytes, [&](const octree::Leaf& leaf) {
      ++leaves;
      const int edge = 1 << (octree::kDepth - leaf.depth);
      for (const int key : leaf.key) {
        if (key < 0 || key % edge != 0 || key + edge > 2 * octree::kCentreKey) std::abort();
      }
      if (leaf.depth < 0 || leaf.depth > octree::kDepth) std::abort();
      if (!std::isfinite(leaf.log_odds)) std::abort();
    });
  } catch (const std::invalid_argument&) {
    return 0;
  }
  // Accepted: then the header told the truth, and every node took bytes of the file.
  if (!(header.resolution > 0.0) || leaves > header.nodes || header.nodes > 4 * size + 1) {
    std::abort();
  }
  return 0;
}
