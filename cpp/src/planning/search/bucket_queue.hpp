// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The open list of an additive search: a ring of buckets, of which only the first is kept in order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "planning/search/bucket_ring.hpp"
#include "planning/search/quad_heap.hpp"

namespace ltp::planning {

/// A strict priority queue for values that come near to one another: a push into a later bucket
/// costs nothing, the bucket being emptied is a small heap. Entries are never edited; a search
/// skips stale ones.
class BucketQueue {
 public:
  struct Entry {
    double value = 0.0;  ///< estimated total cost
    double cost = 0.0;   ///< the part of it that is known; among equals the largest goes first
    std::uint32_t cell =
        0;  ///< index in the search space; the last tie-breaker, so that runs repeat

    bool before(const Entry& other) const {
      const bool at_once = (cost > other.cost) | ((cost == other.cost) & (cell < other.cell));
      return (value < other.value) | ((value == other.value) & at_once);
    }
  };

  /// @param first  the least value to come
  /// @param width  of a bucket, > 0; values come at most `kBuckets` - 2 widths above the lower
  /// bound
  void begin(double first, double width) {
    first_ = first;
    per_width_ = 1.0 / width;
    now_ = 0;
    size_ = 0;
    buckets_.begin(kBuckets);
  }

  bool empty() const { return size_ == 0; }

  void push(const Entry& entry) {
    const auto bucket = static_cast<std::int64_t>((entry.value - first_) * per_width_);
    const std::int64_t number = std::clamp(bucket, now_, now_ + kBuckets - 1);
    std::vector<Entry>& entries = buckets_[number];
    if (number == now_) {
      quad_heap::push(entries, entry);
    } else {
      entries.push_back(entry);
    }
    ++size_;
  }

  /// The entry of the least value. The queue must not be empty.
  const Entry& top() {
    if (buckets_[now_].empty()) {
      while (buckets_[now_].empty()) ++now_;
      quad_heap::make(buckets_[now_]);
    }
    return buckets_[now_].front();
  }
  Entry pop() {
    top();
    --size_;
    return quad_heap::pop(buckets_[now_]);
  }

  static constexpr std::int64_t kBuckets = 1024;

 private:
  double first_ = 0.0;
  double per_width_ = 1.0;
  std::int64_t now_ = 0;  ///< number of the first bucket that may hold something
  std::size_t size_ = 0;
  BucketRing<Entry> buckets_;
};

}  // namespace ltp::planning
