// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/exact/cell_graph.hpp"

#include <algorithm>
#include <limits>
#include <unordered_map>

namespace ltp::planning {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

}  // namespace

void CellGraph::build(const Problem& problem, const StepCosts& costs,
                      const std::vector<Cell>& cells) {
  const GridFrame& frame = problem.frame();
  const auto index = [&](const Cell& cell) { return static_cast<std::size_t>(frame_index(cell)); };
  for (const Cell& cell : cells_) number_[index(cell)] = kNone;  // those of the last graph
  ny_ = frame.ny();
  nz_ = frame.nz();
  costs_ = &costs;
  cells_ = cells;
  number_.resize(static_cast<std::size_t>(frame.size()), kNone);
  priority_.resize(cells.size());
  for (std::uint32_t i = 0; i < size(); ++i) {
    number_[index(cells[i])] = i;
    priority_[i] = costs.priority(cells[i].x(), cells[i].y());
    if (cells[i] == problem.start) start_ = i;
    if (cells[i] == problem.goal) goal_ = i;
  }
  first_.assign(1, 0);
  edges_.clear();
  ends_.clear();
  longest_ = 0.0;
  for (std::uint32_t i = 0; i < size(); ++i) {
    const std::uint32_t blocked = blocked_surroundings(problem.grid(), cells[i], problem.levels);
    double longest = 0.0;
    for (int k = 0; k < kSteps; ++k) {
      const Step& step = steps()[k];
      if (blocked & step.box) continue;
      const std::uint32_t to = number_[index(cells[i] + step.offset())];
      if (to == kNone) continue;
      Edge edge{to, static_cast<std::uint32_t>(k)};
      if (i == start_ || i == goal_ || to == start_ || to == goal_ ||
          !costs.on_lattice(cells[i], k)) {
        edge.step = static_cast<std::uint32_t>(kSteps + ends_.size());
        ends_.push_back(costs(cells[i], k));
      }
      edges_.push_back(edge);
      longest = std::max(longest, cost(i, edge).length);
    }
    longest_ += longest;
    first_.push_back(static_cast<std::uint32_t>(edges_.size()));
  }
}

std::size_t CellGraph::bytes() const {
  return cells_.size() * (sizeof(Cell) + sizeof(double) + sizeof(std::uint32_t)) +
         edges_.size() * sizeof(Edge) + ends_.size() * sizeof(StepCost);
}

StepCost CellGraph::along(const std::vector<std::uint32_t>& chain) const {
  StepCost sum;
  for (std::size_t i = 1; i < chain.size(); ++i) {
    const Edge* edge = begin(chain[i - 1]);
    while (edge->to != chain[i]) ++edge;
    sum = sum + cost(chain[i - 1], *edge);
  }
  return sum;
}

std::vector<std::uint32_t> CellGraph::without_rings(const std::vector<std::uint32_t>& chain) {
  std::unordered_map<std::uint32_t, std::size_t> last;
  for (std::size_t i = 0; i < chain.size(); ++i) last[chain[i]] = i;
  std::vector<std::uint32_t> simple;
  for (std::size_t i = 0; i < chain.size(); i = last[chain[i]] + 1) simple.push_back(chain[i]);
  return simple;
}

bool least_costs(const CellGraph& graph, std::uint32_t from, const CostFactors& factors,
                 BudgetWatch& budget, SearchStats& stats, OpenList& open,
                 std::vector<double>& costs) {
  const std::uint32_t other_end = from == graph.start() ? graph.goal() : graph.start();
  costs.assign(graph.size(), std::numeric_limits<double>::infinity());
  costs[from] = 0.0;
  open.clear();
  open.push({0.0, 0.0, from});
  ++stats.pushed;
  while (!open.empty()) {
    const OpenEntry entry = open.pop();
    if (entry.f > costs[entry.cell]) continue;
    ++stats.expanded;
    if (budget.spent(stats.expanded)) return false;
    if (entry.cell == other_end) continue;
    const CellGraph::Edge* const end = graph.end(entry.cell);
    for (const CellGraph::Edge* edge = graph.begin(entry.cell); edge != end; ++edge) {
      const double total = entry.f + factors(graph.cost(entry.cell, *edge));
      if (total >= costs[edge->to]) continue;
      costs[edge->to] = total;
      open.push({total, 0.0, edge->to});
      ++stats.pushed;
    }
  }
  return true;
}

}  // namespace ltp::planning
