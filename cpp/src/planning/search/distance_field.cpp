// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/search/distance_field.hpp"

#include <algorithm>
#include <limits>

#include "ltp/geometry/check.hpp"
#include "ltp/grid/bits.hpp"

namespace ltp::planning {
namespace {

constexpr std::uint32_t kNoTarget = std::numeric_limits<std::uint32_t>::max();
constexpr int kMostRingBits = 12;

}  // namespace

PlanStatus DistanceField::run(const OccupancyGrid& grid, const Cell& source,
                              const LevelRange& levels, BudgetWatch& budget, SearchStats& stats,
                              const std::optional<Cell>& stop_at) {
  frame_ = grid.frame();
  if (levels.lowest < 0 || levels.highest >= frame_.nz() || levels.lowest > levels.highest) {
    check::fail("levels", Eigen::RowVector2i(levels.lowest, levels.highest), "levels of the grid");
  }
  columns_.reset(grid, levels);
  const auto number = [&](const char* name, const Cell& cell) {
    if (!frame_.contains(cell) || !columns_.contains(cell)) {
      check::fail(name, cell.transpose(), "a cell inside the window and its levels");
    }
    return columns_.index(cell);
  };
  const std::uint32_t from = number("source", source);
  const std::uint32_t target = stop_at ? number("stop_at", *stop_at) : kNoTarget;
  PlanStatus status = PlanStatus::NoneFound;
  for (const double longest : LengthUnits::longest(frame_)) {
    prepare(longest);
    status = search(from, target, budget, stats);
    if (status != PlanStatus::NoneFound) break;
  }
  return status;
}

void DistanceField::prepare(double longest) {
  units_ = LengthUnits(longest);
  const std::array<std::uint64_t, kSteps> lengths = units_.of_steps(frame_.cell());
  if (!natural_ || natural_->lengths() != lengths) natural_.emplace(lengths);
  for (int i = 0; i < kSteps; ++i) moves_[i] = {label(lengths[i], i), columns_.offset(steps()[i])};

  const auto ends = std::minmax_element(lengths.begin(), lengths.end());
  const std::uint64_t dearest = *ends.second;
  int width = floor_log2(*ends.first);
  int ring = 0;  // the dearest step must fit
  const auto fits = [&] { return (std::uint64_t{1} << ring) >= (dearest >> width) + 2; };
  while (!fits() && ring < kMostRingBits) ++ring;
  while (!fits()) ++width;  // cells that are needles: labels of one bucket may improve one another
  shift_ = width + kTagBits;
  ring_.begin(std::size_t{1} << ring);

  labels_.resize(columns_.size());
  columns_.each_word([&](std::uint32_t cell, std::uint64_t blocked, std::uint32_t count) {
    Label* labels = labels_.data() + cell;
    std::fill_n(labels, count, kNew);
    blocked &= (std::uint64_t{1} << count) - 1;
    for_each_bit(blocked, [&](int level) { labels[level] = kBlocked; });
  });
}

/// `NoneFound`: lengths grew too long for their units.
PlanStatus DistanceField::search(std::uint32_t source, std::uint32_t target, BudgetWatch& budget,
                                 SearchStats& stats) {
  // The natural steps where nothing is near, without a look at single bits.
  std::array<std::array<Move, kSteps>, kSteps + 1> in_the_open;
  std::array<int, kSteps + 1> count{};
  for (int i = 0; i <= kSteps; ++i) {
    for_each_bit(natural_->in_the_open(i),
                 [&](int step) { in_the_open[i][count[i]++] = moves_[step]; });
  }
  const std::uint64_t last = (LengthUnits::kMost << kTagBits >> shift_) - ring_.size();
  const std::uint64_t width = std::uint64_t{1} << (shift_ - kTagBits);
  const std::uint64_t shortest =
      *std::min_element(natural_->lengths().begin(), natural_->lengths().end());

  labels_[source] = label(0, NaturalSteps::kRoot);
  if (target != kNoTarget && labels_[target] == kBlocked) return PlanStatus::Unreachable;
  ring_[0].push_back(source);
  ++stats.pushed;
  std::uint64_t idle = 0;  // empty buckets in a row
  for (std::uint64_t now = 0; idle < ring_.size(); ++now, ++idle) {
    std::vector<std::uint32_t>& here = ring_[now];
    if (here.empty()) continue;
    idle = 0;
    // Nothing that is still to come is shorter than this.
    const std::uint64_t settled = now * width + (shortest >= width ? shortest : 0);
    if (target != kNoTarget && labels_[target] >> kTagBits <= settled) return PlanStatus::Found;
    if (now > last) return PlanStatus::NoneFound;
    for (std::size_t i = 0; i < here.size(); ++i) {
      const std::uint32_t cell = here[i];
      const Label mine = labels_[cell];
      if ((mine & 1) == 0) continue;  // stale
      labels_[cell] = mine - 1;
      ++stats.expanded;
      if (budget.spent(stats.expanded)) return PlanStatus::OutOfBudget;
      const Label length = mine & ~kTag;
      const auto relax = [&](const Move& move) {
        const Label offer = length + move.add;
        const std::uint32_t next = cell + static_cast<std::uint32_t>(move.offset);
        if (offer >= labels_[next]) return;
        labels_[next] = offer;
        ring_[offer >> shift_].push_back(next);
        ++stats.pushed;
      };
      const int arrived = step_of(mine);
      if (columns_.in_the_open(cell)) {
        const Move* const moves = in_the_open[arrived].data();
        for (int k = 0; k < count[arrived]; ++k) relax(moves[k]);
      } else {
        for_each_bit(natural_->after(arrived, columns_.surroundings(cell)),
                     [&](int step) { relax(moves_[step]); });
      }
    }
    here.clear();
  }
  return target == kNoTarget || labels_[target] != kNew ? PlanStatus::Found
                                                        : PlanStatus::Unreachable;
}

double DistanceField::metres(Label label) const {
  if (label == kNew || label == kBlocked) return std::numeric_limits<double>::infinity();
  return units_.metres(label >> kTagBits);
}

double DistanceField::operator()(const Cell& cell) const {
  if (!columns_.contains(cell)) return std::numeric_limits<double>::infinity();
  return metres(labels_[columns_.index(cell)]);
}

void DistanceField::copy_to(double* distances) const {
  for (int ix = 0; ix < frame_.nx(); ++ix) {
    for (int iy = 0; iy < frame_.ny(); ++iy) {
      for (int iz = 0; iz < frame_.nz(); ++iz) *distances++ = (*this)(Cell(ix, iy, iz));
    }
  }
}

std::vector<Cell> DistanceField::chain_from(const Cell& cell) const {
  std::vector<Cell> chain{cell};
  while (true) {
    const int arrived = step_of(labels_[columns_.index(chain.back())]);
    if (arrived == NaturalSteps::kRoot) return chain;
    const Step& step = steps()[arrived];
    chain.push_back(chain.back() - step.offset());
  }
}

}  // namespace ltp::planning
