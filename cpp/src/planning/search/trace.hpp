// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// From the marks that a search has left in its cells to the cells of its path.
#pragma once

#include <vector>

#include "ltp/grid/frame.hpp"

namespace ltp::planning {

/// Fills `chain` with the cells on the way from one to another; `offset_of(cell)` leads from each
/// to the next one.
template <typename Offset>
void trace(const Cell& from, const Cell& to, Offset&& offset_of, std::vector<Cell>& chain) {
  chain.assign(1, from);
  while (chain.back() != to) chain.push_back(chain.back() + offset_of(chain.back()));
}

}  // namespace ltp::planning
