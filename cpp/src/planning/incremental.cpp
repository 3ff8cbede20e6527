// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/incremental.hpp"

#include <algorithm>

#include "ltp/planning/linearisation.hpp"

namespace ltp {
namespace {

constexpr std::size_t kTidy = 1 << 16;

int wrapped(int number, int size) {
  const int rest = number % size;
  return rest < 0 ? rest + size : rest;
}

Cell offset_of(const Step& step) { return Cell(step.dx, step.dy, step.dz); }

template <typename Visitor>
void for_each_cell(const Cell& low, const Cell& high, Visitor&& visit) {
  for (int x = low.x(); x <= high.x(); ++x) {
    for (int y = low.y(); y <= high.y(); ++y) {
      for (int z = low.z(); z <= high.z(); ++z) visit(Cell(x, y, z));
    }
  }
}

struct Later {
  template <typename Entry>
  bool operator()(const Entry& a, const Entry& b) const {
    if (a.key != b.key) return a.key > b.key;
    if (a.least != b.least) return a.least > b.least;
    return a.node > b.node;  // so that runs repeat
  }
};

}  // namespace

struct IncrementalPlanner::Call {
  const Scene& scene;
  const Query& query;
  const GridQuery& cells;
  Budget budget;

  const GridFrame& frame() const { return scene.occupancy.frame(); }
  const Cell& first() const { return frame().first(); }
  std::uint32_t blocked_round(const Cell& cell) const {
    return blocked_surroundings(scene.occupancy, cell, cells.levels);
  }
  bool inside(const Cell& cell) const {
    return frame().contains(cell) && cell.z() >= cells.levels.lowest &&
           cell.z() <= cells.levels.highest;
  }
  bool usable(const Cell& cell) const { return inside(cell) && !scene.occupancy.blocked(cell); }
  Box box() const {
    const Cell low(0, 0, cells.levels.lowest);
    const Cell high(frame().nx() - 1, frame().ny() - 1, cells.levels.highest);
    return {low + first(), high + first()};
  }
};

IncrementalPlanner::IncrementalPlanner(const PlannerOptions& options) : options_(options) {
  options.check();
}

Plan IncrementalPlanner::plan(const Scene& scene, const Query& query) {
  return answer(scene, query, [&](const GridQuery& cells, Plan& plan) {
    plan.status = PlanStatus::Found;
    std::vector<Cell> chain{cells.start};
    if (cells.start != cells.goal) {
      const Call call{scene, query, cells, Budget(options_.max_expansions, query.interrupted)};
      plan.status = search(call, plan.stats, chain);
    }
    if (plan.status == PlanStatus::Found) {
      accept(scene, query, cells, options_.weights, chain, plan);
    }
  });
}

PlanStatus IncrementalPlanner::search(const Call& call, SearchStats& stats,
                                      std::vector<Cell>& chain) {
  const GridFrame& frame = call.frame();
  const Problem problem{call.query.goal, call.scene.priority.id(), frame.cell(),
                        frame.lattice(Point::Zero()), frame.dims()};
  const int depth = call.cells.levels.highest - call.cells.levels.lowest + 1;
  const bool same = known_ && problem == problem_ && depth <= size_[2] &&
                    !box_.cut(call.box()).empty() && moved_ < kNone / 4;
  if (!same) begin(call, problem);
  costs_.use(frame, call.scene.priority);
  lowest_ = call.cells.levels.lowest;
  turn_ = {wrapped(call.first().x(), size_[0]), wrapped(call.first().y(), size_[1]),
           wrapped(call.first().z() + lowest_, size_[2])};
  if (++call_ == 0) {  // the numbers are used up
    for (Node& node : nodes_) node.seen = 0;
    call_ = 1;
  }

  if (same) {
    move_start(call);
    take_changes(call, stats);
  } else {
    costs_.root(call.cells.start.x(), call.cells.start.y());
    const std::uint32_t goal = index(call.cells.goal);
    visit(call, call.cells.goal, goal).ahead = 0;
    queue(call.cells.goal, goal, stats);
  }
  start_ = {call.cells.start.x() + call.first().x(), call.cells.start.y() + call.first().y()};
  if (open_.size() > tidy_at_) tidy();

  const PlanStatus status = settle(call, stats);
  if (status != PlanStatus::Found || chain_from(call, *best_exit(), chain)) return status;
  AdditiveResult result =
      scratch_.run(call.scene, call.query, call.cells, cost_, call.budget, stats);
  chain = std::move(result.chain);
  return result.status;
}

void IncrementalPlanner::begin(const Call& call, const Problem& problem) {
  const GridFrame& frame = call.frame();
  problem_ = problem;
  known_ = call.scene.occupancy;
  box_ = call.box();
  touched_ = Box{};
  size_ = {frame.nx(), frame.ny(), call.cells.levels.highest - call.cells.levels.lowest + 1};
  const std::size_t size = static_cast<std::size_t>(size_[0]) * size_[1] * size_[2];
  if (nodes_.size() < size) nodes_.resize(size);
  if (++epoch_ == 0) {  // the numbers are used up
    std::fill(nodes_.begin(), nodes_.end(), Node{});
    epoch_ = 1;
  }
  cost_ = {1.0, 0.0};
  if (options_.weights.priority > 0.0) {
    const double most = std::max(call.scene.priority.maximum(), 0.0);
    const double direct = call.cells.direct_length;
    const PenaltyBound bound(options_.weights, direct, most);
    cost_ = {first_alpha(bound, direct, most, options_.linearised.alpha), 1.0};
  }
  costs_.begin(frame, call.scene.priority, cost_, call.query.goal, call.cells.goal,
               static_cast<std::int64_t>(size));
  moved_ = 0;
  open_.clear();
  tidy_at_ = kTidy;
}

void IncrementalPlanner::move_start(const Call& call) {
  const Cell& start = call.cells.start;
  if (start_[0] == start.x() + call.first().x() && start_[1] == start.y() + call.first().y())
    return;
  moved_ += costs_.least(start.x(), start.y());
  costs_.root(start.x(), start.y());
}

/// Brings what neighbours offer up to date with the scene.
void IncrementalPlanner::take_changes(const Call& call, SearchStats& stats) {
  const Box before = box_;
  box_ = call.box();
  const bool moved = before.low != box_.low || before.high != box_.high;
  OccupancyGrid& known = *known_;
  const OccupancyGrid& now = call.scene.occupancy;
  if (known.frame() != now.frame()) known.roll(call.first() - known.frame().first());
  if (moved) leave(call, before, stats);

  const int words = now.words_per_column();
  const int ny = call.frame().ny();
  for (std::size_t i = 0; i < now.words().size(); ++i) {
    const std::uint64_t change = known.words()[i] ^ now.words()[i];
    if (change == 0) continue;
    const int column = static_cast<int>(i) / words;
    const Cell foot(column / ny, column % ny, static_cast<int>(i) % words * 64);
    // Freed ones first: round them everything has to be looked at, and no cell is twice.
    const std::uint64_t freed = change & known.words()[i];
    for (const std::uint64_t part : {freed, change & ~freed}) {
      for (std::uint64_t bits = part; bits != 0; bits &= bits - 1) {
        const Cell cell = foot + Cell(0, 0, __builtin_ctzll(bits));
        look_round(call, cell, part == freed, stats);
      }
    }
  }
  if (moved) enter(call, before, stats);
  known = now;
}

/// Forgets the cells that are outside now: their places on the torus are used again.
void IncrementalPlanner::leave(const Call& call, const Box& before, SearchStats& stats) {
  const Box learned = touched_.cut(before);
  touched_ = learned.cut(box_);
  const auto forget = [&](const Box& gone) {
    for_each_cell(gone.low, gone.high,
                  [&](const Cell& cell) { nodes_[index_on_lattice(cell)].epoch = 0; });
  };
  for (int axis = 0; axis < 3; ++axis) {
    Box gone = learned;
    gone.high[axis] = std::min(gone.high[axis], box_.low[axis] - 1);
    forget(gone);
    gone = learned;
    gone.low[axis] = std::max(gone.low[axis], box_.high[axis] + 1);
    forget(gone);
  }
  const Box stayed = before.cut(box_);
  const auto lose = [&](Box layer) {  // its cells may have lost the way that they had
    layer = layer.cut(touched_);
    for_each_cell(layer.low, layer.high, [&](const Cell& on_lattice) {
      const Cell cell = on_lattice - call.first();
      if (nodes_[index(cell)].epoch == epoch_) offers(call, cell, stats);
    });
  };
  for (int axis = 0; axis < 3; ++axis) {
    Box layer = stayed;
    layer.high[axis] = layer.low[axis];
    if (before.low[axis] < box_.low[axis]) lose(layer);
    layer = stayed;
    layer.low[axis] = layer.high[axis];
    if (before.high[axis] > box_.high[axis]) lose(layer);
  }
}

/// Offers the cells that have entered the ways of those beside them.
void IncrementalPlanner::enter(const Call& call, const Box& before, SearchStats& stats) {
  const Box stayed = before.cut(box_);
  const auto offer = [&](Box layer) {
    layer = layer.cut(touched_.grown()).cut(box_);
    for_each_cell(layer.low, layer.high, [&](const Cell& on_lattice) {
      const Cell cell = on_lattice - call.first();
      if (!stayed.contains(on_lattice) && call.usable(cell)) offers(call, cell, stats);
    });
  };
  for (int axis = 0; axis < 3; ++axis) {
    Box layer = stayed.grown();
    layer.low[axis] = layer.high[axis] = before.low[axis] - 1;
    if (box_.low[axis] < before.low[axis]) offer(layer);
    layer = stayed.grown();
    layer.low[axis] = layer.high[axis] = before.high[axis] + 1;
    if (box_.high[axis] > before.high[axis]) offer(layer);
  }
}

/// A cell has become free or blocked: all steps within one cell of it may have.
void IncrementalPlanner::look_round(const Call& call, const Cell& changed, bool freed,
                                    SearchStats& stats) {
  const Cell one = Cell::Ones();
  for_each_cell(changed - one, changed + one, [&](const Cell& cell) {
    if (!call.inside(cell) || !touched_.grown().contains(cell + call.first())) return;
    Node& node = nodes_[index(cell)];
    if (node.seen == call_) return;
    if (!freed) {
      // What its neighbours offer can only have got dearer: by the loss of the best of them.
      if (node.epoch != epoch_) return;
      const bool stands = node.next >= 0 && call.usable(cell) &&
                          (call.blocked_round(cell) & steps()[node.next].box) == 0;
      if (stands) return;
    }
    node.seen = call_;
    if (node.epoch == epoch_ || call.usable(cell)) offers(call, cell, stats);
  });
}

/// Settles cells in order until no unsettled one can offer the start less.
PlanStatus IncrementalPlanner::settle(const Call& call, SearchStats& stats) {
  find_exits(call);
  for (;;) {
    while (!open_.empty() && stale(open_.front())) drop_first();
    if (best_exit()) return PlanStatus::Found;
    if (open_.empty()) return PlanStatus::Unreachable;
    const Entry entry = open_.front();
    const Cell cell = cell_of(entry.node);
    const Node& node = nodes_[entry.node];
    const Units key = node.least() + costs_.least(cell.x(), cell.y()) + moved_;
    if (entry.key < key) {  // from when the start was elsewhere
      drop_first();
      queue(cell, entry.node, stats);
      continue;
    }
    ++stats.expanded;
    if (call.budget.spent(stats.expanded)) return PlanStatus::OutOfBudget;
    drop_first();
    settle_one(call, cell, entry.node, stats);
  }
}

void IncrementalPlanner::settle_one(const Call& call, const Cell& cell, std::uint32_t place,
                                    SearchStats& stats) {
  if (nodes_[place].cost > nodes_[place].ahead) {
    const Units cost = nodes_[place].ahead;
    nodes_[place].cost = cost;
    const std::uint32_t blocked = call.blocked_round(cell);
    for (const Step& step : steps()) {
      if (blocked & step.box) continue;  // a step is legal both ways, or none
      const Cell from = cell + offset_of(step);
      if (from == call.cells.goal) continue;
      const std::uint32_t there = index(from);
      Node& other = visit(call, from, there);
      const Units through = cost + step_cost(call, from, step.opposite, cell);
      if (through >= other.ahead) continue;
      other.ahead = through;
      other.next = step.opposite;
      queue(from, there, stats);
    }
    return;
  }
  // It costs more than was thought: whoever leads through it must look again.
  nodes_[place].cost = kNone;
  queue(cell, place, stats);
  for (const Step& step : steps()) {
    const Cell from = cell + offset_of(step);
    if (!call.inside(from)) continue;
    const Node& other = nodes_[index(from)];
    if (other.epoch == epoch_ && other.next == step.opposite) offers(call, from, stats);
  }
}

/// What a cell's neighbours offer it.
void IncrementalPlanner::offers(const Call& call, const Cell& cell, SearchStats& stats) {
  if (cell == call.cells.goal) return;
  Units best = kNone;
  std::int8_t next = -1;
  if (call.usable(cell)) {
    const std::uint32_t blocked = call.blocked_round(cell);
    for (int i = 0; i < kSteps; ++i) {
      const Step& step = steps()[i];
      if (blocked & step.box) continue;
      const Cell to = cell + offset_of(step);
      const Node& other = nodes_[index(to)];
      if (other.epoch != epoch_ || other.cost == kNone) continue;
      const Units through = other.cost + step_cost(call, cell, i, to);
      if (through >= best) continue;
      best = through;
      next = static_cast<std::int8_t>(i);
    }
  }
  const std::uint32_t place = index(cell);
  if (best == kNone && nodes_[place].epoch != epoch_) return;
  Node& node = visit(call, cell, place);
  node.ahead = best;
  node.next = next;
  queue(cell, place, stats);
}

void IncrementalPlanner::find_exits(const Call& call) {
  exits_.clear();
  const Cell& start = call.cells.start;
  const std::uint32_t blocked = call.blocked_round(start);
  for (const Step& step : steps()) {
    if (blocked & step.box) continue;
    const Cell cell = start + offset_of(step);
    const Point to = cell == call.cells.goal ? call.query.goal : call.frame().centre(cell);
    exits_.push_back({index(cell), costs_.straight(call.query.start, to),
                      costs_.least(cell.x(), cell.y()), cell});
  }
}

/// The best step out of the start, once it is known to be the best.
const IncrementalPlanner::Exit* IncrementalPlanner::best_exit() const {
  const Units first = open_.empty() ? kNone : open_.front().key - moved_;
  const Units first_least = open_.empty() ? kNone : open_.front().least;
  const Exit* best = nullptr;
  Units least = kNone;
  Units bound = kNone;  // what the others cost at least
  for (const Exit& exit : exits_) {
    const Node& node = nodes_[exit.node];
    const bool settled = node.epoch == epoch_ && node.cost == node.ahead && node.cost < kNone;
    const Units key = settled ? node.cost + exit.from_start : 0;
    if (settled && (key < first || (key == first && node.cost < first_least))) {
      if (exit.cost + node.cost >= least) continue;
      least = exit.cost + node.cost;
      best = &exit;
    } else if (first < kNone) {
      bound = std::min(bound, exit.cost + std::max<Units>(0, first - exit.from_start));
    }
  }
  return least <= bound ? best : nullptr;
}

/// The cells from the start to the goal. False if the way leads back through the start's own cell.
bool IncrementalPlanner::chain_from(const Call& call, const Exit& exit,
                                    std::vector<Cell>& chain) const {
  chain = {call.cells.start, exit.cell};
  while (chain.back() != call.cells.goal) {
    if (chain.back() == call.cells.start && chain.size() > 1) return false;
    const Node& node = nodes_[index(chain.back())];
    if (node.epoch != epoch_ || node.next < 0 || chain.size() > nodes_.size()) return false;
    chain.push_back(chain.back() + offset_of(steps()[node.next]));
  }
  return true;
}

Units IncrementalPlanner::step_cost(const Call& call, const Cell& from, int step,
                                    const Cell& to) const {
  return to == call.cells.goal ? costs_.into_goal(from) : costs_.step(from, step);
}

IncrementalPlanner::Node& IncrementalPlanner::visit(const Call& call, const Cell& cell,
                                                    std::uint32_t place) {
  Node& node = nodes_[place];
  if (node.epoch == epoch_) return node;
  node = Node{};
  node.epoch = epoch_;
  const Cell on_lattice = cell + call.first();
  if (touched_.empty()) touched_ = {on_lattice, on_lattice};
  touched_.low = touched_.low.cwiseMin(on_lattice);
  touched_.high = touched_.high.cwiseMax(on_lattice);
  return node;
}

/// Puts a cell where it belongs: into the open list, or out of it if it has nothing new.
void IncrementalPlanner::queue(const Cell& cell, std::uint32_t place, SearchStats& stats) {
  const Node& node = nodes_[place];
  if (node.cost == node.ahead) return;  // an entry that it may have is stale now
  const Units key = node.least() + costs_.least(cell.x(), cell.y()) + moved_;
  open_.push_back({key, node.least(), place});
  std::push_heap(open_.begin(), open_.end(), Later());
  ++stats.pushed;
}

bool IncrementalPlanner::stale(const Entry& entry) const {
  const Node& node = nodes_[entry.node];
  return node.epoch != epoch_ || node.cost == node.ahead || node.least() != entry.least;
}

void IncrementalPlanner::drop_first() {
  std::pop_heap(open_.begin(), open_.end(), Later());
  open_.pop_back();
}

/// Throws stale entries away, now and then, so that they do not pile up.
void IncrementalPlanner::tidy() {
  open_.erase(
      std::remove_if(open_.begin(), open_.end(), [&](const Entry& entry) { return stale(entry); }),
      open_.end());
  std::make_heap(open_.begin(), open_.end(), Later());
  tidy_at_ = std::max(kTidy, 2 * open_.size());
}

std::uint32_t IncrementalPlanner::index(const Cell& cell) const {
  int x = cell.x() + turn_[0];
  int y = cell.y() + turn_[1];
  int z = cell.z() - lowest_ + turn_[2];
  if (x >= size_[0]) x -= size_[0];
  if (y >= size_[1]) y -= size_[1];
  if (z >= size_[2]) z -= size_[2];
  return (static_cast<std::uint32_t>(x) * size_[1] + y) * size_[2] + z;
}

std::uint32_t IncrementalPlanner::index_on_lattice(const Cell& cell) const {
  const auto x = static_cast<std::uint32_t>(wrapped(cell.x(), size_[0]));
  return (x * size_[1] + wrapped(cell.y(), size_[1])) * size_[2] + wrapped(cell.z(), size_[2]);
}

Cell IncrementalPlanner::cell_of(std::uint32_t index) const {
  const auto depth = static_cast<std::uint32_t>(size_[2]);
  const auto width = static_cast<std::uint32_t>(size_[1]);
  int z = static_cast<int>(index % depth) - turn_[2];
  int y = static_cast<int>(index / depth % width) - turn_[1];
  int x = static_cast<int>(index / depth / width) - turn_[0];
  if (x < 0) x += size_[0];
  if (y < 0) y += size_[1];
  if (z < 0) z += size_[2];
  return Cell(x, y, z + lowest_);
}

}  // namespace ltp
