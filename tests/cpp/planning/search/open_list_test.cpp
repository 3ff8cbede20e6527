// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Every open list gives its entries in the one order that there is, whatever it sorts and when.
#include "planning/search/open_list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <tuple>
#include <vector>

#include "planning/search/bucket_queue.hpp"
#include "planning/search/lazy_open_list.hpp"

namespace ltp::planning {
namespace {

using Key = std::tuple<double, double, std::uint32_t>;

Key key_of(const OpenEntry& entry) { return {entry.f, entry.h, entry.cell}; }

/// Few values, so that there are ties; now and then one far off.
OpenEntry random_entry(std::mt19937_64& random, bool wild) {
  const double far[] = {1e-300, -1e12, 1e12, 1e300, std::numeric_limits<double>::infinity()};
  OpenEntry entry{static_cast<double>(random() % 50) * 0.1, static_cast<double>(random() % 3),
                  static_cast<std::uint32_t>(random() % 20)};
  if (wild && random() % 10 == 0) entry.f = far[random() % 5];
  return entry;
}

TEST(OpenList, GivesTheLeastEntryFirst) {
  std::mt19937_64 random(1);
  for (int round = 0; round < 100; ++round) {
    OpenList list;
    std::multiset<Key> expected;
    for (int k = 0; k < 500; ++k) {
      if (random() % 3 != 0) {
        const OpenEntry entry = random_entry(random, true);
        list.push(entry);
        expected.insert(key_of(entry));
      } else if (!expected.empty()) {
        ASSERT_EQ(key_of(list.top()), *expected.begin());
        ASSERT_EQ(key_of(list.pop()), *expected.begin());
        expected.erase(expected.begin());
      }
      ASSERT_EQ(list.empty(), expected.empty());
    }
  }
}

TEST(LazyOpenList, GivesTheLeastEntryFirstWhereverValuesLie) {
  std::mt19937_64 random(2);
  LazyOpenList list;
  for (const double range : {5e-324, 1e-3, 1.0, 10.0, 1e300}) {
    for (int round = 0; round < 60; ++round) {
      list.begin(round % 3 == 0 ? 2.0 : 0.0, range);
      const auto is_stale = [](const OpenEntry& entry) { return entry.cell == 7; };
      std::multiset<Key> expected;
      OpenEntry entry;
      for (int k = 0; k < 500; ++k) {
        if (random() % 3 != 0) {
          entry = random_entry(random, round % 2 == 0);
          list.push(entry);
          if (!is_stale(entry)) expected.insert(key_of(entry));
          continue;
        }
        bool found = list.pop(entry, is_stale);
        while (found && is_stale(entry)) found = list.pop(entry, is_stale);
        ASSERT_EQ(found, !expected.empty());
        if (!found) continue;
        ASSERT_EQ(key_of(entry), *expected.begin());
        expected.erase(expected.begin());
      }
    }
  }
}

TEST(BucketQueue, GivesTheLeastEntryFirst) {
  std::mt19937_64 random(3);
  BucketQueue queue;
  for (int round = 0; round < 100; ++round) {
    queue.begin(0.0, 0.01 + 0.01 * round);
    std::multiset<Key> expected;  // among equals the largest cost first
    double least = 0.0;
    for (int k = 0; k < 500; ++k) {
      if (random() % 3 != 0) {
        const OpenEntry entry = random_entry(random, false);
        queue.push({least + entry.f, entry.h, entry.cell});
        expected.insert({least + entry.f, -entry.h, entry.cell});
      } else if (!expected.empty()) {
        const BucketQueue::Entry entry = queue.pop();
        ASSERT_EQ(Key(entry.value, -entry.cost, entry.cell), *expected.begin());
        expected.erase(expected.begin());
        least = entry.value;
      }
      ASSERT_EQ(queue.empty(), expected.empty());
    }
  }
}

TEST(QuadHeap, PutsAnyVectorInOrder) {
  std::mt19937_64 random(4);
  for (std::size_t size = 0; size < 100; ++size) {
    std::vector<OpenEntry> heap;
    std::multiset<Key> expected;
    for (std::size_t k = 0; k < size; ++k) {
      heap.push_back(random_entry(random, true));
      expected.insert(key_of(heap.back()));
    }
    quad_heap::make(heap);
    for (const Key& key : expected) ASSERT_EQ(key_of(quad_heap::pop(heap)), key);
    ASSERT_TRUE(heap.empty());
  }
}

TEST(LazyOpenList, DropsUnsortedWhatWentStaleWhileItWaited) {
  // As a search uses it: a cell is labelled again with a smaller value, and taken once.
  std::mt19937_64 random(5);
  LazyOpenList list;
  for (const double range : {1e-6, 1.0, 100.0}) {
    constexpr std::uint32_t kCells = 300;
    std::vector<double> labels(kCells, std::numeric_limits<double>::infinity());
    list.begin(0.0, range);
    std::size_t pushed = 0;
    for (int k = 0; k < 3000; ++k) {
      const auto cell = static_cast<std::uint32_t>(random() % kCells);
      const double value = static_cast<double>(random() % 1000) * 0.1;
      if (value >= labels[cell]) continue;
      labels[cell] = value;
      list.push({value, 0.0, cell});
      ++pushed;
    }
    std::set<Key> expected;
    for (std::uint32_t cell = 0; cell < kCells; ++cell) expected.insert({labels[cell], 0.0, cell});
    EXPECT_GT(pushed, 2 * expected.size());
    // In the first bucket lie only labels of 0, which cannot be bettered.
    const auto is_stale = [&](const OpenEntry& entry) { return entry.f != labels[entry.cell]; };
    OpenEntry entry;
    for (const Key& key : expected) {
      ASSERT_TRUE(list.pop(entry, is_stale));
      ASSERT_EQ(key_of(entry), key);
    }
    EXPECT_FALSE(list.pop(entry, is_stale));
  }
}

TEST(LazyOpenList, ForgetsWhatIsLeftWhenItBeginsAgain) {
  LazyOpenList list;
  const auto fresh = [](const OpenEntry&) { return false; };
  list.begin(0.0, 10.0);
  for (std::uint32_t cell = 0; cell < 100; ++cell) list.push({0.1 * cell, 0.0, cell});
  list.begin(-3.0, 1.0);
  OpenEntry entry;
  EXPECT_FALSE(list.pop(entry, fresh));
  list.push({5.0, 0.0, 7});
  ASSERT_TRUE(list.pop(entry, fresh));
  EXPECT_EQ(key_of(entry), Key(5.0, 0.0, 7));
  EXPECT_FALSE(list.pop(entry, fresh));
}

TEST(BucketQueue, GoesRoundItsRingAndTakesWhatComesLate) {
  // Values rise over many times what the ring holds; now and then one below what was taken last.
  std::mt19937_64 random(6);
  BucketQueue queue;
  queue.begin(3.0, 0.25);
  std::multiset<Key> expected;
  double least = 3.0;
  int late = 0;
  for (int k = 0; k < 30000; ++k) {
    if (random() % 2 == 0 || expected.empty()) {
      const double most = 0.25 * (BucketQueue::kBuckets - 2);
      const double up = std::ldexp(most, -static_cast<int>(random() % 12));
      const bool is_late = random() % 50 == 0;
      late += is_late;
      const BucketQueue::Entry entry{is_late ? least - 0.3 : least + up,
                                     static_cast<double>(random() % 3),
                                     static_cast<std::uint32_t>(random() % 20)};
      queue.push(entry);
      expected.insert({entry.value, -entry.cost, entry.cell});
    } else {
      const BucketQueue::Entry top = queue.top();
      const BucketQueue::Entry entry = queue.pop();
      ASSERT_EQ(Key(top.value, -top.cost, top.cell), *expected.begin());
      ASSERT_EQ(Key(entry.value, -entry.cost, entry.cell), *expected.begin());
      expected.erase(expected.begin());
      least = std::max(least, entry.value);
    }
  }
  EXPECT_GT(late, 100);
  EXPECT_GT(least, 3.0 + 10 * 0.25 * BucketQueue::kBuckets);
}

TEST(BucketQueue, ForgetsWhatIsLeftWhenItBeginsAgain) {
  BucketQueue queue;
  queue.begin(0.0, 0.5);
  for (std::uint32_t cell = 0; cell < 100; ++cell) queue.push({1.0 * cell, 0.0, cell});
  queue.pop();
  queue.begin(-7.0, 2.0);
  EXPECT_TRUE(queue.empty());
  queue.push({-1.0, 2.0, 3});
  EXPECT_EQ(queue.pop().cell, 3u);
  EXPECT_TRUE(queue.empty());
}

}  // namespace
}  // namespace ltp::planning
