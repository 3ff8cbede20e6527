// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `BucketRing`: the open list of a search whose values lie near to one another.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ltp::planning {

/// Buckets of equal width, numbered upwards for ever; those in use fit into a ring, so that a
/// number modulo its size finds them (Dial 1969). What is done with a bucket whose turn has come
/// differs from search to search.
template <typename Entry>
class BucketRing {
 public:
  /// @param size  a power of two; entries go into fewer than `size` buckets in a row
  void begin(std::size_t size) {
    buckets_.resize(size);
    for (std::vector<Entry>& bucket : buckets_) bucket.clear();
    mask_ = size - 1;
  }
  std::vector<Entry>& operator[](std::uint64_t number) { return buckets_[number & mask_]; }
  std::size_t size() const { return buckets_.size(); }

 private:
  std::vector<std::vector<Entry>> buckets_;
  std::uint64_t mask_ = 0;
};

}  // namespace ltp::planning
