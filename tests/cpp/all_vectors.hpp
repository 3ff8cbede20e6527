// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Runs a check with every kind of registers that this processor has.
#pragma once

#include <vector>

#include "ltp/geometry/vectors.hpp"

namespace ltp::test {

/// The widest last.
inline std::vector<Vectors> all_vectors() {
  std::vector<Vectors> all;
  for (const Vectors vectors : {Vectors::Baseline, Vectors::Avx2, Vectors::Avx512}) {
    if (supported(vectors)) all.push_back(vectors);
  }
  return all;
}

/// Calls `check()` once for each; then all is as it was before.
template <typename Check>
void with_all_vectors(Check&& check) {
  const Vectors at_first = vectors();
  for (const Vectors vectors : all_vectors()) {
    use(vectors);
    check();
  }
  use(at_first);
}

}  // namespace ltp::test
