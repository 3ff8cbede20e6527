// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Nothing is allocated while flying: the map takes its memory when it is made.
#include "allocations.hpp"

#include <gtest/gtest.h>
#include <malloc.h>

#include <cstdlib>
#include <new>
#include <random>
#include <vector>

#include "ltp/mapping/obstacle_map.hpp"

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

// Replaces those of the whole program; the forms for arrays and `nothrow` end up here.
void* operator new(std::size_t size) { return take(size); }
void* operator new[](std::size_t size) { return take(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace ltp {

std::int64_t test::allocations() { return count; }

std::int64_t test::bytes() { return most_taken = taken; }

std::int64_t test::most_bytes() { return most_taken; }

namespace {

TEST(Allocations, AreCounted) {
  const std::int64_t before = test::allocations();
  const std::int64_t taken_before = test::bytes();
  {
    const std::vector<int> vector(10);
    const Path path(2, 3);
    const void* volatile used = vector.data();  // else the compiler does without
    used = path.data();
    static_cast<void>(used);
  }
  const std::int64_t count = test::allocations() - before;
  const std::int64_t most = test::most_bytes() - taken_before;
  const std::int64_t left = test::bytes() - taken_before;
  EXPECT_EQ(count, 2);
  EXPECT_GE(most, static_cast<std::int64_t>(10 * sizeof(int) + 6 * sizeof(double)));
  EXPECT_EQ(left, 0);
}

TEST(Allocations, TheMapMakesNoneOnceItExists) {
  std::mt19937_64 random(9);
  std::normal_distribution<double> normal;
  for (const bool carve : {false, true}) {
    for (const bool keep_hits : {true, false}) {
      ObstacleMapOptions options;
      options.dims = {50, 50, 40};
      options.carve_free_space = carve;
      options.keep_hits = keep_hits;
      Point position = Point::Zero();
      ObstacleMap map(options, position);
      std::vector<Point> hits(500), misses(500);
      std::int64_t inserted = 0;
      for (int scan = 0; scan < 50; ++scan) {
        for (Point& hit : hits)
          hit = position + 15.0 * Point(normal(random), normal(random), normal(random));
        for (Point& miss : misses)
          miss = position + 90.0 * Point(normal(random), normal(random), normal(random));
        const std::int64_t before = test::allocations();
        const Eigen::Map<const Path> hit_rows(hits.front().data(), hits.size(), 3);
        const Eigen::Map<const Path> miss_rows(misses.front().data(), misses.size(), 3);
        inserted += map.insert(position, hit_rows, miss_rows).marked;
        inserted += map.insert(position, hit_rows).marked;
        map.recentre(position);
        EXPECT_EQ(test::allocations() - before, 0) << "scan " << scan << ", carving " << carve;
        position += Point(2.5 * normal(random), 2.5 * normal(random), 2.5 * normal(random));
      }
      EXPECT_GT(inserted, 10000);
    }
  }
}

}  // namespace
}  // namespace ltp
