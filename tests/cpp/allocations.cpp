// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// A file of its own: where the compiler sees the counters, it knows that `malloc` leaves them
// alone.
#include "allocations.hpp"

#include <malloc.h>

#include <cstdlib>
#include <new>

namespace {
thread_local std::int64_t count = 0;
thread_local std::int64_t taken = 0;  // bytes
thread_local std::int64_t most_taken = 0;

void* counted(void* memory) {
  if (memory == nullptr) return memory;
  ++count;
  taken += static_cast<std::int64_t>(malloc_usable_size(memory));
  if (taken > most_taken) most_taken = taken;
  return memory;
}

void* take(std::size_t size) {
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
}  // namespace

// The linker sends the whole program's calls here (`--wrap`): Eigen allocates without `new`.
extern "C" {
void* __real_malloc(std::size_t size);
void* __real_calloc(std::size_t number, std::size_t size);
void* __real_realloc(void* memory, std::size_t size);
void __real_free(void* memory);

void* __wrap_malloc(std::size_t size) { return counted(__real_malloc(size)); }
void* __wrap_calloc(std::size_t number, std::size_t size) {
  return counted(__real_calloc(number, size));
}
void* __wrap_realloc(void* memory, std::size_t size) {
  taken -= static_cast<std::int64_t>(malloc_usable_size(memory));
  return counted(__real_realloc(memory, size));
}
void __wrap_free(void* memory) {
  taken -= static_cast<std::int64_t>(malloc_usable_size(memory));
  __real_free(memory);
}
}

// Replaces those of the whole program, all of them: sanitizers compare who took with who frees.
void* operator new(std::size_t size) { return take(size); }
void* operator new[](std::size_t size) { return take(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return std::malloc(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return std::malloc(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace ltp {

std::int64_t test::allocations() { return count; }

std::int64_t test::bytes() { return most_taken = taken; }

std::int64_t test::most_bytes() { return most_taken; }

}  // namespace ltp
