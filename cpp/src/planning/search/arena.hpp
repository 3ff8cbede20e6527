// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `Arena`: a growing array that never moves what it holds and is emptied without giving up its
// memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace ltp::planning {

template <typename Item>
class Arena {
 public:
  std::uint32_t size() const { return size_; }
  void clear() { size_ = 0; }
  Item& operator[](std::uint32_t i) { return chunks_[i >> kShift][i & (kChunk - 1)]; }
  const Item& operator[](std::uint32_t i) const { return chunks_[i >> kShift][i & (kChunk - 1)]; }
  /// The number of the new item.
  std::uint32_t add(const Item& item) {
    if ((size_ >> kShift) == chunks_.size()) chunks_.push_back(std::make_unique<Item[]>(kChunk));
    (*this)[size_] = item;
    return size_++;
  }

 private:
  static constexpr std::uint32_t kShift = 12;
  static constexpr std::uint32_t kChunk = 1u << kShift;
  std::vector<std::unique_ptr<Item[]>> chunks_;
  std::uint32_t size_ = 0;
};

}  // namespace ltp::planning
