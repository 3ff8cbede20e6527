// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `ZeroedArray`: much scratch memory, of which only what is used becomes resident.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace ltp::planning {

/// Items of zero bytes. The system hands out zeroed pages when they are first touched, so that a
/// search over a few cells of a large window neither waits for the others nor holds memory for
/// them.
template <typename Item>
class ZeroedArray {
  static_assert(std::is_trivially_copyable_v<Item> && std::is_trivially_destructible_v<Item>);

 public:
  std::size_t size() const { return size_; }
  /// All items are zero bytes again.
  void reset(std::size_t size) {
    items_.reset();
    size_ = 0;
    items_.reset(static_cast<Item*>(std::calloc(size, sizeof(Item))));
    if (!items_ && size > 0) throw std::bad_alloc();
    size_ = size;
  }
  Item& operator[](std::size_t i) { return items_.get()[i]; }
  const Item& operator[](std::size_t i) const { return items_.get()[i]; }
  Item* begin() { return items_.get(); }
  Item* end() { return items_.get() + size_; }

 private:
  struct Free {
    void operator()(Item* items) const { std::free(items); }
  };
  std::unique_ptr<Item[], Free> items_;
  std::size_t size_ = 0;
};

}  // namespace ltp::planning
