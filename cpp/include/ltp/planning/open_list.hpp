// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The open list of a best-first search: a strict heap, entries never edited, stale ones skipped by
// the search.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ltp {

struct OpenEntry {
  double f = 0.0;  ///< estimated total cost
  double h =
      0.0;  ///< the estimated part of it; among equals the cell nearer to the start goes first
  std::uint32_t cell = 0;  ///< index in the search space; the last tie-breaker, so that runs repeat
};

/// Of four children each: half as deep as a binary heap, and a look at four children that lie
/// together costs little more than at two.
class OpenList {
 public:
  void clear() { entries_.clear(); }
  bool empty() const { return entries_.empty(); }
  const OpenEntry& top() const { return entries_.front(); }
  const std::vector<OpenEntry>& entries() const { return entries_; }  ///< stale ones too
  void push(const OpenEntry& entry) {
    std::size_t hole = entries_.size();
    entries_.push_back(entry);
    while (hole > 0) {
      const std::size_t parent = (hole - 1) / kChildren;
      if (!before(entry, entries_[parent])) break;
      entries_[hole] = entries_[parent];
      hole = parent;
    }
    entries_[hole] = entry;
  }
  OpenEntry pop() {
    const OpenEntry best = entries_.front();
    const OpenEntry last = entries_.back();
    entries_.pop_back();
    const std::size_t size = entries_.size();
    std::size_t hole = 0;
    for (std::size_t child = 1; child < size; child = hole * kChildren + 1) {
      const std::size_t end = std::min(child + kChildren, size);
      std::size_t least = child;
      for (++child; child < end; ++child) {
        least = before(entries_[child], entries_[least]) ? child : least;
      }
      if (!before(entries_[least], last)) break;
      entries_[hole] = entries_[least];
      hole = least;
    }
    if (size > 0) entries_[hole] = last;
    return best;
  }

 private:
  static constexpr std::size_t kChildren = 4;

  /// Without jumps: which child is the least cannot be foreseen.
  static bool before(const OpenEntry& a, const OpenEntry& b) {
    const bool at_once = (a.h < b.h) | ((a.h == b.h) & (a.cell < b.cell));
    return (a.f < b.f) | ((a.f == b.f) & at_once);
  }

  std::vector<OpenEntry> entries_;
};

}  // namespace ltp
