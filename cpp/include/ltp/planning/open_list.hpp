// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The open list of a best-first search: a strict binary heap, entries never edited, stale ones
// skipped by the search.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace ltp {

struct OpenEntry {
  double f = 0.0;  ///< estimated total cost
  double h =
      0.0;  ///< the estimated part of it; among equals the cell nearer to the start goes first
  std::uint32_t cell = 0;  ///< index in the search space; the last tie-breaker, so that runs repeat
};

class OpenList {
 public:
  void clear() { entries_.clear(); }
  bool empty() const { return entries_.empty(); }
  const OpenEntry& top() const { return entries_.front(); }
  const std::vector<OpenEntry>& entries() const { return entries_; }  ///< stale ones too
  void push(const OpenEntry& entry) {
    entries_.push_back(entry);
    std::push_heap(entries_.begin(), entries_.end(), later);
  }
  OpenEntry pop() {
    std::pop_heap(entries_.begin(), entries_.end(), later);
    const OpenEntry best = entries_.back();
    entries_.pop_back();
    return best;
  }

 private:
  static bool later(const OpenEntry& a, const OpenEntry& b) {
    if (a.f != b.f) return a.f > b.f;
    if (a.h != b.h) return a.h > b.h;
    return a.cell > b.cell;
  }

  std::vector<OpenEntry> entries_;
};

}  // namespace ltp
