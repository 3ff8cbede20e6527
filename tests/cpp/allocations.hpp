// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Counts what the test program takes from the heap.
#pragma once

#include <cstdint>

namespace ltp::test {

/// Times that this thread has asked for memory since the program began.
std::int64_t allocations();

/// Bytes that this thread has taken and not given back.
std::int64_t bytes();
/// The most that `bytes` was since it was last asked.
std::int64_t most_bytes();

}  // namespace ltp::test
