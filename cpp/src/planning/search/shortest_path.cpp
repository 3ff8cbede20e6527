// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/search/shortest_path.hpp"

#include <algorithm>
#include <array>

#include "ltp/grid/bits.hpp"
#include "planning/search/trace.hpp"

namespace ltp::planning {
namespace {

/// Buckets are narrower than the shortest step by so many powers of two.
constexpr int kNarrower = 4;
constexpr int kMostRingBits = 12;

}  // namespace

ShortestPath::ShortestPath(std::int64_t patience)
    : proof_(UnreachableProof::From::Start, patience) {}

PlanStatus ShortestPath::run(const Problem& problem, BudgetWatch& budget, SearchStats& stats) {
  PlanStatus status = PlanStatus::NoneFound;
  for (const double longest : LengthUnits::longest(problem.frame())) {
    prepare(problem, longest);
    status = search(problem, budget, stats);
    if (status != PlanStatus::NoneFound) break;
  }
  if (status == PlanStatus::Found) {
    trace(
        problem.start, problem.goal,
        [&](const Cell& cell) -> Cell {
          const Label label = space_[space_.index(cell)].label;
          return -steps()[static_cast<int>(label & ((1u << kTagBits) - 1)) % kSteps].offset();
        },
        chain_);
  }
  return status;
}

void ShortestPath::prepare(const Problem& problem, double longest) {
  const GridFrame& frame = problem.frame();
  units_ = LengthUnits(longest);
  const std::array<std::uint64_t, kSteps> lengths = units_.of_steps(frame.cell());
  if (!natural_ || natural_->lengths() != lengths) natural_.emplace(lengths);
  prepare_levels(problem);
  for (int i = 0; i < kSteps; ++i) {
    const Cell by = steps()[i].offset();
    from_goal_[i] = units_((problem.point_of(problem.goal + by) - problem.query.goal).norm());
    const Cell last = problem.start + by;
    // To the heuristic, which knows no ends but the start, the goal's cell is one like any other.
    into_start_[neighbour_bit(by)] =
        problem.levels.contains(last) ? units_((problem.query.start - problem.vertex(last)).norm())
                                      : OctileDistance::kNoStep;
  }
  to_start_.aim(problem.start, least_, into_start_);
  space_.begin(frame, problem.levels);

  const auto ends = std::minmax_element(lengths.begin(), lengths.end());
  const std::uint64_t shortest = *ends.first;
  const std::uint64_t dearest = *ends.second;
  shift_ = std::max(0, floor_log2(shortest) - kNarrower);
  // A step raises an estimate by less than twice its length; those at the ends are longer by half.
  int bits = 0;
  const auto fits = [&] { return (std::uint64_t{1} << bits) >= (3 * dearest >> shift_) + 2; };
  while (!fits() && bits < kMostRingBits) ++bits;
  while (!fits()) ++shift_;
  ring_.begin(std::size_t{1} << bits);
  // From the goal's centre; the first step begins elsewhere in its cell.
  const std::uint64_t estimate = to_start_(problem.goal);
  first_ = (estimate > dearest ? estimate - dearest : 0) >> shift_;
  waiting_ = 0;
}

/// Where vertices keep to a band that ends within a level, steps up and down from there have
/// lengths of their own. The heuristic takes all levels to be as near as the two nearest.
void ShortestPath::prepare_levels(const Problem& problem) {
  least_ = natural_->lengths();
  by_level_.clear();
  if (problem.even()) return;
  const LevelRange& levels = problem.levels;
  level_lengths_.reset(problem);
  double rise = problem.frame().cell().z();
  for (int level = levels.lowest; level <= levels.highest; ++level) {
    ByLevel& row = by_level_.emplace_back(ByLevel{least_, true});
    row.even = LevelLengths::is_even_at(problem, level);
    if (level < levels.highest) {
      rise = std::min(rise, level_lengths_.from(level)[step_by(Cell::UnitZ())]);
    }
    if (row.even) continue;
    const LevelLengths::Lengths& metres = level_lengths_.from(level);
    std::transform(metres.begin(), metres.end(), row.lengths.begin(), units_);
  }
  const Point& cell = problem.frame().cell();
  least_ = units_.of_steps(Point(cell.x(), cell.y(), rise));
}

void ShortestPath::push(const Entry& entry) {
  const std::uint64_t number = std::max(entry.estimate >> shift_, now_);
  ring_[number].push_back(entry);
  ++waiting_;
}

/// `NoneFound`: lengths grew too long for their units.
PlanStatus ShortestPath::search(const Problem& problem, BudgetWatch& budget, SearchStats& stats) {
  const std::uint32_t start = space_.index(problem.start);
  std::uint64_t best = LengthUnits::kMost;
  bool too_long = false;
  const auto offer = [&](const Cell& cell, std::uint64_t length, int tag) {
    const std::uint32_t index = space_.index(cell);
    Node& node = space_.visit(index);
    const Label label = length << kTagBits | static_cast<Label>(tag);
    if (label >= node.label) return;
    const std::uint64_t estimate = index == start ? length : length + to_start_(cell);
    if (estimate >= best) {
      too_long |= best == LengthUnits::kMost;
      return;
    }
    node.label = label;
    if (index == start) {
      best = length;
    } else {
      push({estimate, label, cell});
      ++stats.pushed;
    }
  };

  now_ = 0;
  proof_.begin();
  space_.visit(space_.index(problem.goal)).label = 0;
  push({0, 0, problem.goal});
  ++stats.pushed;
  while (waiting_ > 0 && now_ << shift_ < best) {
    std::vector<Entry>& here = ring_[now_];
    if (here.empty()) {
      ++now_;
      continue;
    }
    const Entry entry = here.back();
    here.pop_back();
    --waiting_;
    const Cell& cell = entry.cell;
    if (entry.estimate >= best || space_[space_.index(cell)].label != entry.label) continue;
    ++stats.expanded;
    if (budget.spent(stats.expanded)) return PlanStatus::OutOfBudget;
    if (proof_.after_expansion(problem)) return PlanStatus::Unreachable;
    const std::uint32_t blocked = blocked_surroundings(problem.grid(), cell, problem.levels);
    const auto next = [&](int i) -> Cell { return cell + steps()[i].offset(); };
    if (cell == problem.goal) {
      now_ = first_;
      for_each_bit(natural_->after(NaturalSteps::kRoot, blocked),
                   [&](int i) { offer(next(i), from_goal_[i], kSteps + i); });
      continue;
    }
    const int tag = static_cast<int>(entry.label & ((1u << kTagBits) - 1));
    const std::uint64_t length = entry.label >> kTagBits;
    // What a step at either end costs is no matter of the lattice: it dominates no other.
    const ByLevel* const level =
        by_level_.empty() ? nullptr : &by_level_[cell.z() - problem.levels.lowest];
    const bool even = level == nullptr || level->even;
    const std::array<std::uint64_t, kSteps>& lengths = even ? natural_->lengths() : level->lengths;
    // Ways round a cell are compared by the lattice's lengths.
    std::uint32_t left = natural_->after(even && tag < kSteps ? tag : NaturalSteps::kRoot, blocked);
    const Cell by = problem.start - cell;
    if (by.cwiseAbs().maxCoeff() == 1) {
      const int last = step_by(by);
      left &= ~(1u << last);
      if ((blocked & steps()[last].box) == 0) {
        offer(problem.start, length + into_start_[neighbour_bit(-by)], last);
      }
    }
    for_each_bit(left, [&](int i) { offer(next(i), length + lengths[i], i); });
  }
  if (best < LengthUnits::kMost) return PlanStatus::Found;
  return too_long ? PlanStatus::NoneFound : PlanStatus::Unreachable;
}

}  // namespace ltp::planning
