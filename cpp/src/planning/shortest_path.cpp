// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/shortest_path.hpp"

#include <algorithm>
#include <array>

#include "ltp/planning/step_costs.hpp"

namespace ltp {
namespace {

/// After so many expansions the start's side is asked whether there is a way at all: a flood costs
/// about as much as they did.
constexpr std::int64_t kExpandedBeforeFlood = 16384;

/// Buckets are narrower than the shortest step by so many powers of two.
constexpr int kNarrower = 4;
constexpr int kMostRingBits = 12;

int floor_log2(std::uint64_t value) { return 63 - __builtin_clzll(value); }

}  // namespace

PlanStatus ShortestPath::run(const Scene& scene, const Query& query, const GridQuery& cells,
                             const Budget& budget, SearchStats& stats) {
  PlanStatus status = PlanStatus::NoneFound;
  for (const double longest : LengthUnits::longest(scene.occupancy.frame())) {
    prepare(scene, query, cells, longest);
    status = search(scene, cells, budget, stats);
    if (status != PlanStatus::NoneFound) break;
  }
  if (status == PlanStatus::Found) trace(cells);
  return status;
}

void ShortestPath::prepare(const Scene& scene, const Query& query, const GridQuery& cells,
                           double longest) {
  const GridFrame& frame = scene.occupancy.frame();
  units_ = LengthUnits(longest);
  const std::array<std::uint64_t, kSteps> lengths = units_.of_steps(frame.cell());
  if (!natural_ || natural_->lengths() != lengths) natural_.emplace(lengths);
  // Start and goal are points, not centres.
  for (int i = 0; i < kSteps; ++i) {
    const Step& step = steps()[i];
    const Cell by(step.dx, step.dy, step.dz);
    const Cell next = cells.goal + by;
    from_goal_[i] =
        units_(((next == cells.start ? query.start : frame.centre(next)) - query.goal).norm());
    const Cell last = cells.start + by;
    const bool open = last.z() >= cells.levels.lowest && last.z() <= cells.levels.highest;
    into_start_[neighbour_bit(by.x(), by.y(), by.z())] =
        open ? units_((query.start - frame.centre(last)).norm()) : OpenDistance::kNoStep;
  }
  to_start_.aim(cells.start, lengths, into_start_);
  space_.begin(frame, cells.levels);

  const auto [shortest, dearest] = std::minmax_element(lengths.begin(), lengths.end());
  shift_ = std::max(0, floor_log2(*shortest) - kNarrower);
  // A step raises an estimate by less than twice its length; those at the ends are longer by half.
  int bits = 0;
  const auto fits = [&] { return (std::uint64_t{1} << bits) >= (3 * *dearest >> shift_) + 2; };
  while (!fits() && bits < kMostRingBits) ++bits;
  while (!fits()) ++shift_;
  ring_.resize(std::size_t{1} << bits);
  // From the goal's centre; the first step begins elsewhere in its cell.
  const std::uint64_t estimate = to_start_(cells.goal);
  first_ = (estimate > *dearest ? estimate - *dearest : 0) >> shift_;
  for (std::vector<Entry>& bucket : ring_) bucket.clear();
  waiting_ = 0;
}

void ShortestPath::push(const Entry& entry) {
  const std::uint64_t number = std::max(entry.estimate >> shift_, now_);
  ring_[number & (ring_.size() - 1)].push_back(entry);
  ++waiting_;
}

/// `NoneFound`: lengths grew too long for their units.
PlanStatus ShortestPath::search(const Scene& scene, const GridQuery& cells, const Budget& budget,
                                SearchStats& stats) {
  const std::array<std::uint64_t, kSteps>& lengths = natural_->lengths();
  const std::uint32_t start = space_.index(cells.start);
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
  space_.visit(space_.index(cells.goal)).label = 0;
  push({0, 0, cells.goal});
  ++stats.pushed;
  std::int64_t expanded = 0;
  while (waiting_ > 0 && now_ << shift_ < best) {
    std::vector<Entry>& here = ring_[now_ & (ring_.size() - 1)];
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
    if (++expanded == kExpandedBeforeFlood) {
      flood_.fill(scene.occupancy, cells.start, cells.levels);
      if (!flood_.reached(cells.goal)) return PlanStatus::Unreachable;
    }
    const std::uint32_t blocked = blocked_surroundings(scene.occupancy, cell, cells.levels);
    const auto next = [&](int i) -> Cell {
      return cell + Cell(steps()[i].dx, steps()[i].dy, steps()[i].dz);
    };
    if (cell == cells.goal) {
      const std::uint32_t left = natural_->after(NaturalSteps::kRoot, blocked);
      now_ = first_;
      for (int i = 0; i < kSteps; ++i) {
        if (left >> i & 1u) offer(next(i), from_goal_[i], kSteps + i);
      }
      continue;
    }
    const int tag = static_cast<int>(entry.label & ((1u << kTagBits) - 1));
    const std::uint64_t length = entry.label >> kTagBits;
    // What a step at either end costs is no matter of the lattice: it spares no other.
    std::uint32_t left = natural_->after(tag < kSteps ? tag : NaturalSteps::kRoot, blocked);
    const Cell by = cells.start - cell;
    if (by.cwiseAbs().maxCoeff() == 1) {
      const int last = step_between(cell, cells.start);
      left &= ~(1u << last);
      if ((blocked & steps()[last].box) == 0) {
        offer(cells.start, length + into_start_[neighbour_bit(-by.x(), -by.y(), -by.z())], last);
      }
    }
    for (; left != 0; left &= left - 1) {
      const int i = __builtin_ctz(left);
      offer(next(i), length + lengths[i], i);
    }
  }
  if (best < LengthUnits::kMost) return PlanStatus::Found;
  return too_long ? PlanStatus::NoneFound : PlanStatus::Unreachable;
}

void ShortestPath::trace(const GridQuery& cells) {
  chain_.assign(1, cells.start);
  while (chain_.back() != cells.goal) {
    const Label label = space_[space_.index(chain_.back())].label;
    const Step& step = steps()[static_cast<int>(label & ((1u << kTagBits) - 1)) % kSteps];
    chain_.push_back(chain_.back() - Cell(step.dx, step.dy, step.dz));
  }
}

}  // namespace ltp
