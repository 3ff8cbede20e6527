// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The open list of a best-first search: a strict heap, entries never edited, stale ones skipped by
// the search.
#pragma once

#include <cstdint>
#include <vector>

#include "planning/search/quad_heap.hpp"

namespace ltp::planning {

struct OpenEntry {
  double f = 0.0;  ///< estimated total cost
  double h =
      0.0;  ///< the estimated part of it; among equals the cell nearer to the start goes first
  std::uint32_t cell = 0;  ///< index in the search space; the last tie-breaker, so that runs repeat

  bool before(const OpenEntry& other) const {
    const bool at_once = (h < other.h) | ((h == other.h) & (cell < other.cell));
    return (f < other.f) | ((f == other.f) & at_once);
  }
};

class OpenList {
 public:
  void clear() { entries_.clear(); }
  bool empty() const { return entries_.empty(); }
  const OpenEntry& top() const { return entries_.front(); }
  const std::vector<OpenEntry>& entries() const { return entries_; }  ///< stale ones too
  void push(const OpenEntry& entry) { quad_heap::push(entries_, entry); }
  OpenEntry pop() { return quad_heap::pop(entries_); }

 private:
  std::vector<OpenEntry> entries_;
};

}  // namespace ltp::planning
