// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Every open list gives its entries in the one order that there is, whatever it sorts and when.
#include "ltp/planning/open_list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <set>
#include <tuple>

#include "ltp/planning/bucket_queue.hpp"
#include "ltp/planning/lazy_open_list.hpp"

namespace ltp {
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

}  // namespace
}  // namespace ltp
