// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/exact/front_search.hpp"

#include <algorithm>
#include <limits>

namespace ltp::planning {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

StepCost least_of(const StepCost& a, const StepCost& b) {
  return {std::min(a.length, b.length), std::min(a.loss, b.loss)};
}

/// A representative may have come round to where it was, or be dominated by another.
void tidy(const CellGraph& graph, std::vector<FrontSearch::Solution>& front) {
  for (FrontSearch::Solution& solution : front) {
    solution.chain = CellGraph::without_rings(solution.chain);
    solution.sum = graph.along(solution.chain);
  }
  std::sort(front.begin(), front.end(), [](const auto& a, const auto& b) {
    return a.sum.length != b.sum.length ? a.sum.length < b.sum.length : a.sum.loss < b.sum.loss;
  });
  double least = kInfinity;
  const auto is_dominated = [&](const FrontSearch::Solution& solution) {
    if (solution.sum.loss >= least) return true;
    least = solution.sum.loss;
    return false;
  };
  front.erase(std::remove_if(front.begin(), front.end(), is_dominated), front.end());
}

}  // namespace

PlanStatus FrontSearch::run(const Task& task, BudgetWatch& budget, SearchStats& stats,
                            std::vector<Solution>& front) {
  const CellGraph& graph = task.graph;
  const double most_entries =
      std::min(task.memory / (sizeof(Entry) + sizeof(OpenEntry)), double{kNone - 1});
  front.clear();
  entries_.clear();
  open_.clear();
  least_loss_.assign(graph.size(), kInfinity);
  heads_.assign(graph.size(), kNone);
  double& least_at_goal = least_loss_[graph.goal()];

  const auto whole = [&](const Entry& entry) {
    return entry.apex + StepCost{task.length_to_goal[entry.node], task.loss_to_goal[entry.node]};
  };
  // Every solution so far is, by its apex, not longer than what is still to come.
  const auto is_dominated = [&](const Entry& entry) {
    return entry.apex.loss >= least_loss_[entry.node] ||
           least_at_goal <= task.factor * whole(entry).loss;
  };
  const auto push = [&](Entry entry) {
    if (task.factor > 1.0) merge(task, entry);
    entry.next = heads_[entry.node];
    const std::uint32_t number = entries_.add(entry);
    heads_[entry.node] = number;
    open_.push({whole(entry).length, whole(entry).loss, number});
    ++stats.pushed;
  };

  push({{}, {}, graph.start(), kNone, kNone, true});
  while (!open_.empty()) {
    const std::uint32_t number = open_.pop().cell;
    if (!entries_[number].open) continue;
    entries_[number].open = false;
    const Entry entry = entries_[number];
    if (is_dominated(entry)) continue;
    ++stats.expanded;
    if (budget.spent(stats.expanded)) return PlanStatus::OutOfBudget;
    if (entry.node == graph.goal()) {
      least_at_goal = std::min(least_at_goal, entry.representative.loss);
      std::vector<std::uint32_t> chain;
      for (std::uint32_t i = number; i != kNone; i = entries_[i].parent) {
        chain.push_back(entries_[i].node);
      }
      std::reverse(chain.begin(), chain.end());
      front.push_back({entry.representative, std::move(chain)});
      continue;
    }
    least_loss_[entry.node] = entry.apex.loss;
    const CellGraph::Edge* const end = graph.end(entry.node);
    for (const CellGraph::Edge* edge = graph.begin(entry.node); edge != end; ++edge) {
      if (edge->to == graph.start()) continue;
      const StepCost cost = graph.cost(entry.node, *edge);
      const Entry next{
          entry.apex + cost, entry.representative + cost, edge->to, number, kNone, true};
      if (is_dominated(next)) continue;
      if (entries_.size() >= most_entries) return PlanStatus::OutOfBudget;
      push(next);
    }
  }
  if (task.factor > 1.0) tidy(graph, front);
  return front.empty() ? PlanStatus::Unreachable : PlanStatus::Found;
}

/// Takes an open entry of the same node in, if one of both representatives can stand for both.
bool FrontSearch::merge(const Task& task, Entry& entry) {
  std::uint32_t* link = &heads_[entry.node];
  const StepCost rest{task.length_to_goal[entry.node], task.loss_to_goal[entry.node]};
  while (*link != kNone) {
    Entry& other = entries_[*link];
    if (!other.open) {  // taken from the queue since
      *link = other.next;
      continue;
    }
    const StepCost apex = least_of(entry.apex, other.apex);
    const auto stands = [&](const StepCost& representative) {
      return representative.length + rest.length <= task.factor * (apex.length + rest.length) &&
             representative.loss + rest.loss <= task.factor * (apex.loss + rest.loss);
    };
    const bool by_other = stands(other.representative);
    if (by_other || stands(entry.representative)) {
      if (by_other) {
        entry.representative = other.representative;
        entry.parent = other.parent;
      }
      entry.apex = apex;
      other.open = false;
      *link = other.next;
      return true;
    }
    link = &other.next;
  }
  return false;
}

}  // namespace ltp::planning
