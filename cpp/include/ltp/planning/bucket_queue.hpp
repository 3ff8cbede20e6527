// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The open list of an additive search: buckets of equal width, emptied last in, first out.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ltp {

/// Entries come out in the order of their buckets only. So a search must be ready to improve a cell
/// that it has expanded already, and may stop when `lower_bound()` has reached what it has.
class BucketQueue {
 public:
  struct Entry {
    double cost = 0.0;  ///< of the cell when it was pushed; another one by now: stale
    std::uint32_t cell = 0;
  };

  /// @param first  the least value to come
  /// @param width  of a bucket, > 0; values are to come at most `kBuckets` - 2 widths above the
  ///     lower bound, else they come out too early
  void begin(double first, double width) {
    first_ = first;
    width_ = width;
    per_width_ = 1.0 / width;
    now_ = 0;
    size_ = 0;
    for (std::vector<Entry>& bucket : buckets_) bucket.clear();
  }

  bool empty() const { return size_ == 0; }
  /// No value that is still in the queue is below it.
  double lower_bound() const { return first_ + static_cast<double>(now_) * width_; }

  void push(double value, const Entry& entry) {
    const auto bucket = static_cast<std::int64_t>((value - first_) * per_width_);
    buckets_[std::clamp(bucket, now_, now_ + kBuckets - 1) % kBuckets].push_back(entry);
    ++size_;
  }

  /// Goes on to the next bucket that holds something. The queue must not be empty.
  void settle() {
    while (buckets_[now_ % kBuckets].empty()) ++now_;
  }
  /// The last entry of the bucket that `settle` found.
  Entry pop() {
    std::vector<Entry>& bucket = buckets_[now_ % kBuckets];
    const Entry last = bucket.back();
    bucket.pop_back();
    --size_;
    return last;
  }

  static constexpr std::int64_t kBuckets = 1024;

 private:
  double first_ = 0.0;
  double width_ = 1.0;
  double per_width_ = 1.0;
  std::int64_t now_ = 0;
  std::size_t size_ = 0;
  std::array<std::vector<Entry>, kBuckets> buckets_;
};

}  // namespace ltp
