// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `TripleBuffer`: the newest value from one thread to another; neither ever waits.
#pragma once

#include <array>
#include <atomic>

namespace ltp {

/// Of three slots one belongs to the writer, one to the reader, and the third holds what was
/// published last: both sides only exchange their slot for it. What the reader did not take in time
/// is overwritten. The slots keep their memory, so that large values cost a copy and no allocation.
/// One writing and one reading thread.
template <typename T>
class TripleBuffer {
 public:
  explicit TripleBuffer(const T& initial) : slots_{initial, initial, initial} {}

  /// The writer's slot: overwrite all of it, then publish. It holds some older value.
  T& back() { return slots_[back_]; }
  void publish() { back_ = middle_.exchange(back_ | kFresh, std::memory_order_acq_rel) & kSlot; }

  /// Takes what was published last. Whether there was anything new.
  bool take() {
    if ((middle_.load(std::memory_order_relaxed) & kFresh) == 0) return false;
    front_ = middle_.exchange(front_, std::memory_order_acq_rel) & kSlot;
    return true;
  }
  /// The reader's slot: its own until it takes the next one.
  T& front() { return slots_[front_]; }
  const T& front() const { return slots_[front_]; }

 private:
  static constexpr unsigned kSlot = 3;
  static constexpr unsigned kFresh = 4;  ///< the middle slot was published and not yet taken

  std::array<T, 3> slots_;
  std::atomic<unsigned> middle_{1};
  unsigned back_ = 0;   ///< the writer's alone
  unsigned front_ = 2;  ///< the reader's alone
};

}  // namespace ltp
