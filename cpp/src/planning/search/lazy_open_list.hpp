// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The open list of a search that labels its cells over and over: what is far off is not put in
// order.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "planning/search/open_list.hpp"

namespace ltp::planning {

/// Gives the entries of an `OpenList` in the same order. Only those of the nearest of many buckets
/// are in a heap; by the time that a bucket's turn comes most of its entries are stale, and these
/// are dropped unsorted. Values may fall, and lie anywhere.
class LazyOpenList {
 public:
  /// @param least, range  where values are likely to lie; only a matter of speed
  void begin(double least, double range) {
    near_.clear();
    for (std::vector<OpenEntry>& bucket : far_) bucket.clear();
    waiting_ = 0;
    now_ = 0;
    least_ = least;
    per_width_ = std::min(kBuckets / range, 1e300);  // finite, for the smallest of ranges too
  }

  void push(const OpenEntry& entry) {
    const std::size_t number = bucket(entry.f);
    if (number <= now_) {
      near_.push(entry);
    } else {
      far_[number].push_back(entry);
      ++waiting_;
    }
  }

  /// Takes out the next entry; false: none is left.
  /// @param is_stale  whether an entry may be left out
  template <typename IsStale>
  bool pop(OpenEntry& entry, const IsStale& is_stale) {
    while (near_.empty()) {
      if (waiting_ == 0) return false;
      do ++now_;
      while (far_[now_].empty());
      current_.swap(far_[now_]);
      waiting_ -= current_.size();
      current_.erase(std::remove_if(current_.begin(), current_.end(), is_stale), current_.end());
      if (now_ == kBuckets - 1) spread();
      for (const OpenEntry& one : current_) push(one);
      current_.clear();
    }
    entry = near_.pop();
    return true;
  }

 private:
  static constexpr std::size_t kBuckets = 1024;

  /// Rises with the value; the last holds all that lies beyond.
  std::size_t bucket(double value) const {
    const double number = (value - least_) * per_width_;
    if (!(number < kBuckets - 1)) return kBuckets - 1;
    return number > 0.0 ? static_cast<std::size_t>(number) : 0;
  }
  /// Makes room for what lies beyond; `current_` is all there is.
  void spread() {
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (const OpenEntry& entry : current_) {
      least = std::min(least, entry.f);
      most = std::max(most, entry.f);
    }
    if (!(most - least < std::numeric_limits<double>::max())) return;  // into the heap with them
    now_ = 0;
    least_ = least;
    per_width_ = std::min(per_width_, kBuckets / (most - least));
  }

  OpenList near_;
  std::array<std::vector<OpenEntry>, kBuckets> far_;
  std::vector<OpenEntry> current_;  ///< scratch
  std::size_t waiting_ = 0;         ///< in `far_`
  std::size_t now_ = 0;             ///< number of the bucket that is in the heap, with all before
  double least_ = 0.0;
  double per_width_ = 1.0;
};

}  // namespace ltp::planning
