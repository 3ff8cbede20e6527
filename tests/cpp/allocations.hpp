// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Counts what the test program takes from the heap by `operator new`.
#pragma once

#include <cstdint>

namespace ltp::test {

/// Calls of `operator new` on this thread since the program began.
std::int64_t allocations();

}  // namespace ltp::test
