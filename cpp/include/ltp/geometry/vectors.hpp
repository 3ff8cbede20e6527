// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `Vectors`: how wide the registers are that the inner loops use; chosen at run time.
#pragma once

namespace ltp {

/// The processors that inner loops are compiled for. All give the same bytes.
enum class Vectors {
  Baseline,
  Avx2,    ///< with POPCNT
  Avx512,  ///< F, DQ and VL
};

/// Whether this processor has them.
bool supported(Vectors vectors);

/// What the loops run with: at first the widest that is supported.
Vectors vectors();
/// Chooses; only what is supported. For tests; not while others compute.
void use(Vectors vectors);

}  // namespace ltp
