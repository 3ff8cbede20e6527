// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// A heap of four children each, in a vector, least entry first.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ltp::planning::quad_heap {

// Half as deep as a binary heap; four children that lie together cost little more to look at than
// two. Entries have `bool before(const Entry&) const`, a strict order without jumps: which child is
// the least cannot be foreseen.

inline constexpr std::size_t kChildren = 4;

/// Puts an entry where the hole is, or lower.
template <typename Entry>
void sink(std::vector<Entry>& heap, std::size_t hole, const Entry& entry) {
  const std::size_t size = heap.size();
  for (std::size_t child = hole * kChildren + 1; child < size; child = hole * kChildren + 1) {
    const std::size_t end = std::min(child + kChildren, size);
    std::size_t least = child;
    for (++child; child < end; ++child) least = heap[child].before(heap[least]) ? child : least;
    if (!heap[least].before(entry)) break;
    heap[hole] = heap[least];
    hole = least;
  }
  heap[hole] = entry;
}

/// Puts a vector's entries in order.
template <typename Entry>
void make(std::vector<Entry>& heap) {
  if (heap.size() < 2) return;
  for (std::size_t i = (heap.size() - 2) / kChildren + 1; i-- > 0;) {
    const Entry entry = heap[i];
    sink(heap, i, entry);
  }
}

template <typename Entry>
void push(std::vector<Entry>& heap, const Entry& entry) {
  std::size_t hole = heap.size();
  heap.push_back(entry);
  while (hole > 0) {
    const std::size_t parent = (hole - 1) / kChildren;
    if (!entry.before(heap[parent])) break;
    heap[hole] = heap[parent];
    hole = parent;
  }
  heap[hole] = entry;
}

/// Takes out the least entry.
template <typename Entry>
Entry pop(std::vector<Entry>& heap) {
  const Entry best = heap.front();
  const Entry last = heap.back();
  heap.pop_back();
  if (!heap.empty()) sink(heap, 0, last);
  return best;
}

}  // namespace ltp::planning::quad_heap
