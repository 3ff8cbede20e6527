// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/additive/additive_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace ltp::planning {
namespace {

constexpr std::int64_t kPatience = 4096;      // expansions before the flood
constexpr std::int8_t kInPlace = kSteps + 1;  // from the start itself to its cell's vertex
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The steps to one of the 3 x 3 columns round a cell: their numbers by dz + 1; -1: no step.
struct ColumnSteps {
  int dx, dy;
  std::array<std::int8_t, 3> number;
};

std::array<ColumnSteps, 9> make_column_steps() {
  std::array<ColumnSteps, 9> all{};
  for (int k = 0; k < 9; ++k) all[k] = {k / 3 - 1, k % 3 - 1, {-1, -1, -1}};
  for (int i = 0; i < kSteps; ++i) {
    const Step& step = steps()[i];
    all[(step.dx + 1) * 3 + step.dy + 1].number[step.dz + 1] = static_cast<std::int8_t>(i);
  }
  return all;
}

const std::array<ColumnSteps, 9>& column_steps() {
  static const std::array<ColumnSteps, 9> all = make_column_steps();
  return all;
}

/// By how much a step up from a level is longer than the same one that stays there, at least.
double min_climb(const LevelLengths::Lengths& lengths) {
  double least = kInfinity;
  for (const ColumnSteps& column : column_steps()) {
    const double level = column.number[1] < 0 ? 0.0 : lengths[column.number[1]];
    least = std::min(least, lengths[column.number[2]] - level);
  }
  return least;
}

}  // namespace

AdditiveSearch::AdditiveSearch() : proof_(UnreachableProof::From::Goal, kPatience) {}

AdditiveResult AdditiveSearch::run(const Problem& problem, const AdditiveCost& cost,
                                   BudgetWatch& budget, SearchStats& stats, double longest) {
  const Query& query = problem.query;
  if (problem.within_a_cell()) {
    const double straight = cost.along(problem.scene.priority, query.start, problem.last_point());
    return {PlanStatus::Found, straight, {problem.start}};
  }
  if (proof_.at_once(problem) || !begin(problem, cost, longest)) {
    return {PlanStatus::Unreachable, 0.0, {}};
  }
  ++stats.pushed;
  enter_in_place(problem, cost, stats);
  const PlanStatus status = search(problem, cost, budget, stats);
  AdditiveResult result{status, status == PlanStatus::Unreachable ? 0.0 : end_.cost, {}};
  if (status == PlanStatus::Found) trace_back(problem, result.chain);
  return result;
}

/// Lists the start; false if it is walled in over all levels.
bool AdditiveSearch::begin(const Problem& problem, const AdditiveCost& cost, double longest) {
  proof_.begin();
  const std::size_t layers = std::max<std::size_t>(1, problem.gates.size());
  layer_size_ = space_.begin(problem.frame(), problem.levels, layers);
  end_ = End{};
  aim(problem, cost, longest);
  const std::size_t first_layer = problem.passed_at_start;
  const std::uint32_t start = state(first_layer, problem.start);
  space_.visit(start).from_start = kSteps;
  const double estimate = fields_[first_layer](problem.start.x(), problem.start.y());
  if (estimate == kInfinity) return false;
  // The field begins at the centre of the start's column: from the start itself the first step may
  // be shorter, and over better ground. No step raises an estimate by more than twice its own cost.
  const double dearest = cost.length * problem.frame().cell().norm();
  const double first = std::max(0.0, estimate - 3.0 * dearest);
  open_.begin(first, 6.0 * dearest / (BucketQueue::kBuckets - 4));
  open_.push({first, 0.0, start});
  return true;
}

/// A step into the cell of the last waypoint's point: to the point itself, unless it is to pass
/// other gates on the way, for which it goes by the vertex.
/// @param by  the step; its cost is that before it
void AdditiveSearch::enter(const Problem& problem, const AdditiveCost& cost, const Node& by,
                           const Point& from, const Cell& cell, std::size_t layer) {
  const Raster& priority = problem.scene.priority;
  const Point& point = problem.last_point();
  const bool direct = !problem.has_gates() || layer + 1 == problem.gates.size() ||
                      problem.passed_at(point, layer) == problem.gates.size();
  const bool by_vertex = !direct && !problem.gates.back().holds_vertex(cell);
  const Point first = direct ? point : problem.vertex(cell);
  double total = by.cost + cost.along(priority, from, first);
  if (by_vertex) total += cost.along(priority, first, point);
  if (total < end_.cost) end_ = {total, cell, by, by_vertex};
}

/// A start beside a gate, in a cell whose vertex lies in it.
void AdditiveSearch::enter_in_place(const Problem& problem, const AdditiveCost& cost,
                                    SearchStats& stats) {
  const std::size_t first = problem.passed_at_start;
  std::size_t passed = first;
  while (passed < problem.gates.size() && problem.gates[passed].contains(problem.start)) ++passed;
  if (passed == first) return;
  const Point& start = problem.query.start;
  const Node by{0.0, 0, kInPlace, static_cast<std::uint8_t>(passed - first)};
  const double total = cost.along(problem.scene.priority, start, problem.vertex(problem.start));
  if (passed < problem.gates.size()) {
    const std::uint32_t index = state(passed, problem.start);
    Node& node = space_.visit(index);
    node.cost = total;
    node.from_start = by.from_start;
    node.passes = by.passes;
    open_.push({total + fields_[passed](problem.start.x(), problem.start.y()), total, index});
    ++stats.pushed;
  } else if (problem.start == problem.gates.back().own()) {
    enter(problem, cost, by, start, problem.start, first);
  } else {
    end_ = {total, problem.start, by};
  }
}

/// The fields, from the last gate's back: each begins with what the next one says in its region.
void AdditiveSearch::aim(const Problem& problem, const AdditiveCost& cost, double longest) {
  const std::size_t layers = std::max<std::size_t>(1, problem.gates.size());
  if (fields_.size() < layers) fields_.resize(layers);
  if (!problem.has_gates()) return fields_[0].aim(problem, cost, longest);
  for (std::size_t i = layers; i-- > problem.passed_at_start;) {
    ColumnCosts* const next = i + 1 < layers ? &fields_[i + 1] : nullptr;
    fields_[i].aim(problem, cost, i, next, longest);
  }
}

/// The last step into the goal may climb a level for next to nothing: the goal is no vertex.
void AdditiveSearch::set_climbs(const Problem& problem, double metre) {
  const LevelRange& levels = problem.levels;
  lengths_.reset(problem);
  levels_ = static_cast<std::size_t>(levels.count());
  climbs_.assign(levels_ * std::max<std::size_t>(1, problem.gates.size()), 0.0);
  if (problem.has_gates()) return set_gate_climbs(problem, metre);
  const int goal = problem.goal.z();
  const auto climb = [&](int level) -> double& { return climbs_[level - levels.lowest]; };
  if (problem.even()) {
    const double one = min_climb(lengths_.from(levels.lowest)) * metre;
    for (int level = levels.lowest; level <= levels.highest; ++level) {
      climb(level) = one * std::max(0, std::abs(level - goal) - 1);
    }
    return;
  }
  for (int level = goal + 2; level <= levels.highest; ++level) {
    climb(level) = climb(level - 1) + min_climb(lengths_.from(level - 1)) * metre;
  }
  for (int level = goal - 2; level >= levels.lowest; --level) {
    climb(level) = climb(level + 1) + min_climb(lengths_.from(level)) * metre;
  }
}

/// To the levels of a gate, and on from there to those of the next ones.
void AdditiveSearch::set_gate_climbs(const Problem& problem, double metre) {
  const LevelRange& levels = problem.levels;
  for (std::size_t layer = problem.gates.size(); layer-- > 0;) {
    const GateRegion& gate = problem.gates[layer];
    const bool last = layer + 1 == problem.gates.size();
    double* const mine = &climbs_[layer * levels_];
    const double* const next = mine + levels_;
    for (int level = levels.lowest; level <= levels.highest; ++level) {
      const int beside = std::abs(level - gate.own().z());
      const bool served = gate.levels().contains(Cell(0, 0, level)) || beside <= (last ? 1 : 0);
      const int i = level - levels.lowest;
      mine[i] = !served ? kInfinity : last ? 0.0 : next[i];
    }
    for (std::size_t i = 1; i < levels_; ++i) {
      const double up = min_climb(lengths_.from(levels.lowest + static_cast<int>(i) - 1)) * metre;
      mine[i] = std::min(mine[i], mine[i - 1] + up);
    }
    for (std::size_t i = levels_ - 1; i-- > 0;) {
      const double up = min_climb(lengths_.from(levels.lowest + static_cast<int>(i))) * metre;
      mine[i] = std::min(mine[i], mine[i + 1] + up);
    }
  }
}

/// The status; `end_` has the path found, and the least cost: of it, or of all paths if out of
/// budget.
PlanStatus AdditiveSearch::search(const Problem& problem, const AdditiveCost& cost,
                                  BudgetWatch& budget, SearchStats& stats) {
  const double most = std::max(problem.scene.priority.maximum(), 0.0);
  set_climbs(problem, std::max(0.0, cost.length - cost.priority * most));
  const int lowest = problem.levels.lowest;
  const std::vector<GateRegion>& gates = problem.gates;
  const bool has_gates = problem.has_gates();
  const std::size_t ends = std::max<std::size_t>(1, gates.size());
  const std::uint32_t start = state(problem.passed_at_start, problem.start);
  const Cell goal = has_gates ? gates.back().own() : problem.goal;
  while (!open_.empty()) {
    const BucketQueue::Entry entry = open_.pop();
    if (entry.value >= end_.cost) break;
    const std::uint32_t index = entry.cell;
    if (entry.cost != space_[index].cost) continue;  // stale
    ++stats.expanded;
    if (budget.spent(stats.expanded)) {
      end_.cost = entry.value;
      return PlanStatus::OutOfBudget;
    }
    if (proof_.after_expansion(problem)) break;
    const std::size_t layer = index / layer_size_;
    const Cell cell = space_.cell(index % layer_size_);
    ColumnCosts& field = fields_[layer];
    const double here = field.half_metre(cell.x(), cell.y());
    const LevelLengths::Lengths& lengths = lengths_.from(cell.z());
    const std::uint32_t blocked = blocked_surroundings(problem.grid(), cell, problem.levels);
    for (const ColumnSteps& column : column_steps()) {
      const int jx = cell.x() + column.dx;
      const int jy = cell.y() + column.dy;
      double metre = -1.0;  // cost of a metre on the way to this column, once it is needed
      double ground = 0.0;  // the field's value there
      const std::uint32_t level = state(layer, Cell(jx, jy, cell.z()));
      for (const std::int8_t number : column.number) {
        if (number < 0 || (blocked & steps()[number].box)) continue;
        if (metre < 0.0) {
          metre = here + field.half_metre(jx, jy);
          ground = field(jx, jy);
        }
        const Cell next(jx, jy, cell.z() + steps()[number].dz);
        std::size_t passed = layer;
        if (has_gates) {
          while (passed < ends && gates[passed].contains(next)) ++passed;
        } else if (next == goal) {
          passed = ends;
        }
        const bool done = passed == ends;
        const auto passes = static_cast<std::uint8_t>(passed - layer);
        double step;
        if ((done && next == goal) || index == start) {  // such a step is tallied exactly
          const Point from = index == start ? problem.query.start : problem.vertex(cell);
          if (done && next == goal) {
            enter(problem, cost, {entry.cost, 0, number, passes}, from, next, layer);
            continue;
          }
          step = cost.along(problem.scene.priority, from, problem.vertex(next));
        } else {
          step = lengths[number] * metre;
        }
        const double total = entry.cost + step;
        if (done) {
          if (total < end_.cost) end_ = {total, next, {total, 0, number, passes}};
          continue;
        }
        const std::uint32_t next_index =
            level + static_cast<std::uint32_t>(next.z() - cell.z()) + passes * layer_size_;
        Node& other = space_.visit(next_index);
        if (other.from_start >= 0 && total >= other.cost) continue;
        const double left = passed == layer ? ground : fields_[passed](jx, jy);
        const double value = total + left + climb(passed, next.z() - lowest);
        if (value >= end_.cost) continue;
        other.cost = total;
        other.from_start = number;
        other.passes = passes;
        open_.push({value, total, next_index});
        ++stats.pushed;
      }
    }
  }
  return end_.by.from_start < 0 ? PlanStatus::Unreachable : PlanStatus::Found;
}

void AdditiveSearch::trace_back(const Problem& problem, std::vector<Cell>& chain) const {
  const std::uint32_t start = state(problem.passed_at_start, problem.start);
  std::size_t layer = std::max<std::size_t>(1, problem.gates.size());
  Cell cell = end_.cell;
  Node by = end_.by;
  chain = {cell};
  if (end_.by_vertex) chain.push_back(cell);
  for (bool first = true;; first = false) {
    if (!first) {
      const std::uint32_t index = state(layer, cell);
      if (index == start) break;
      by = space_[index];
    }
    if (problem.has_gates()) {
      layer -= by.passes;
    } else {
      layer = 0;
    }
    if (by.from_start < kSteps) cell -= steps()[by.from_start].offset();
    chain.push_back(cell);
  }
  std::reverse(chain.begin(), chain.end());
}

}  // namespace ltp::planning
