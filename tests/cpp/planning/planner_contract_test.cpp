// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// One contract for every planner, over all scenes: what it answers, what its paths are like, and
// that it answers the same again.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "ltp/planning/planners.hpp"
#include "scenes.hpp"

namespace ltp {
namespace {

using test::kInfinity;
using test::kNan;
using test::kPlanar;
using test::Situation;

const std::vector<Situation>& all_situations() {
  static const std::vector<Situation> all = test::situations();
  return all;
}

PlannerOptions quick_options() {
  PlannerOptions options;
  options.bezier.offsets = 9;
  options.bezier.reach = 12.0;
  options.bezier.z_offsets = 3;
  options.bezier.z_reach = 6.0;
  options.bezier.segments = 12;
  options.exact.memory = 2.0;
  options.hermite = {12, 3, 2.0, 2, 8};
  return options;
}

/// What a planner expands at most, in a window of so many cells.
using Most = std::int64_t (*)(const PlannerOptions&, std::int64_t cells);

Most most_of(std::string_view name) {
  if (name == "bezier") {
    return [](const PlannerOptions& o, std::int64_t) {
      return std::int64_t{o.bezier.offsets} * o.bezier.offsets * o.bezier.z_offsets;
    };
  }
  if (name == "hermite") {  // 8 moves either way
    return [](const PlannerOptions& o, std::int64_t) {
      return std::int64_t{o.hermite.starts} * o.hermite.starts +
             std::int64_t{16} * o.hermite.refined * o.hermite.iterations;
    };
  }
  if (name == "tangent-bug") {  // looks around, in two planes
    return [](const PlannerOptions&, std::int64_t cells) { return 8 * cells + 8; };
  }
  if (name == "exact") {  // many labels a cell
    return [](const PlannerOptions&, std::int64_t cells) { return cells << 32; };
  }
  if (name == "sweep" || name == "auto") {
    return [](const PlannerOptions& o, std::int64_t cells) {
      return o.linearised.searches * cells + o.linearised.closing;
    };
  }
  if (name == "ara-star") {  // one search a weight
    return [](const PlannerOptions& o, std::int64_t cells) {
      return cells *
             static_cast<std::int64_t>(std::ceil((o.ara.first_weight - 1.0) / o.ara.step) + 1.0);
    };
  }
  return [](const PlannerOptions&, std::int64_t cells) { return cells; };
}

/// All of an answer but the time that it took, byte by byte.
bool same(const Plan& a, const Plan& b) {
  const std::size_t bytes = a.path.size() * sizeof(double);
  return a.status == b.status && a.path.rows() == b.path.rows() &&
         (bytes == 0 || std::memcmp(a.path.data(), b.path.data(), bytes) == 0) &&
         a.tally.length == b.tally.length && a.tally.priority == b.tally.priority &&
         a.penalty == b.penalty && a.bound == b.bound && a.stats.expanded == b.stats.expanded &&
         a.stats.pushed == b.stats.pushed;
}

std::vector<std::string_view> names() {
  std::vector<std::string_view> all;
  for (const PlannerInfo& info : planners()) all.push_back(info.name);
  return all;
}

class PlannerContract : public ::testing::TestWithParam<std::string_view> {
 protected:
  static std::unique_ptr<Planner> make(const PlannerOptions& options = quick_options()) {
    return make_planner(GetParam(), options);
  }
  const PlannerInfo& info_ = planner_info(GetParam());
};

TEST(PlannerNames, BeginWithThePapersAndAreListedWhereOneIsUnknown) {
  const std::vector<std::string_view> paper = {"lp-dijkstra", "lp-a-star", "wlp-a-star", "ggwp",
                                               "bezier"};
  const std::vector<std::string_view> all = names();
  EXPECT_TRUE(std::equal(paper.begin(), paper.end(), all.begin()));
  for (const PlannerInfo& info : planners()) {
    const bool listed = std::find(paper.begin(), paper.end(), info.name) != paper.end();
    EXPECT_EQ(info.family == PlannerFamily::Paper, listed) << info.name;
  }
  EXPECT_EQ(make_planner()->name(), "auto");
  EXPECT_EQ(make_planner("pareto")->name(), "exact") << "the name of the release before";
  EXPECT_EQ(make_planner("bug")->name(), "tangent-bug");
  try {
    make_planner("dijkstra");
    ADD_FAILURE() << "an unknown planner was made";
  } catch (const std::invalid_argument& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("'dijkstra'"), std::string::npos) << text;
    for (const std::string_view name : all) EXPECT_NE(text.find(name), std::string::npos) << text;
  }
}

TEST_P(PlannerContract, HasItsName) {
  EXPECT_EQ(make()->name(), GetParam());
  EXPECT_EQ(make()->info().title, info_.title);
}

TEST_P(PlannerContract, GivesTheStatusThatAFloodGives) {
  const std::unique_ptr<Planner> planner = make();
  int judged = 0;
  int found = 0;
  for (const Situation& situation : all_situations()) {
    const Plan plan = planner->plan(situation.scene(), situation.query);
    const PlanStatus expected = test::slow_status(situation);
    const bool searched = expected == PlanStatus::Found || expected == PlanStatus::Unreachable;
    if (planner->complete() || !searched) {
      EXPECT_EQ(to_string(plan.status), to_string(expected)) << situation.name;
    } else if (plan.status != PlanStatus::Found || expected != PlanStatus::Found) {
      EXPECT_EQ(to_string(plan.status), "none_found") << situation.name;
    }
    ++judged;
    found += plan.status == PlanStatus::Found;
  }
  EXPECT_GT(judged, 300);
  EXPECT_GT(found, 80);
}

TEST_P(PlannerContract, GivesPathsThatLeadFromStartToGoalThroughFreeCellsOnly) {
  const std::unique_ptr<Planner> planner = make();
  int judged = 0;
  for (const Situation& situation : all_situations()) {
    SCOPED_TRACE(situation.name);
    const Plan plan = planner->plan(situation.scene(), situation.query);
    if (plan.status != PlanStatus::Found) {
      EXPECT_EQ(plan.path.rows(), 0);
      EXPECT_EQ(plan.penalty, kInfinity);
      EXPECT_EQ(plan.tally.length, 0.0);
      continue;
    }
    ++judged;
    const GridFrame& frame = situation.grid.frame();
    const LevelRange levels = test::slow_levels(frame, situation.query);
    const Query& query = situation.query;
    const double low = std::min(query.start.z(), query.goal.z()) - query.band.below;
    const double high = std::max(query.start.z(), query.goal.z()) + query.band.above;
    ASSERT_GE(plan.path.rows(), 2);
    EXPECT_EQ(plan.path.row(0).transpose(), situation.query.start);
    EXPECT_EQ(plan.path.row(plan.path.rows() - 1).transpose(), situation.query.goal);
    for (Eigen::Index i = 0; i < plan.path.rows(); ++i) {
      const Cell cell = frame.cell_of(plan.path.row(i).transpose());
      EXPECT_TRUE(frame.contains(cell));
      EXPECT_GE(cell.z(), levels.lowest);
      EXPECT_LE(cell.z(), levels.highest);
      EXPECT_GE(plan.path(i, 2), low - 1e-9);
      EXPECT_LE(plan.path(i, 2), high + 1e-9);
    }
    // From centre to centre, not even the faces of a blocked cell are touched. Ends
    // may lie on them, and a curve may have a point there.
    const bool clear = situation.centred && planner->complete();
    const double margin = (clear ? 1e-9 : -1e-9) * frame.cell().minCoeff();
    EXPECT_FALSE(test::meets_blocked(situation.grid, plan.path, margin)) << plan.path;
  }
  EXPECT_GT(judged, 80);
}

TEST_P(PlannerContract, TalliesThePathThatItGives) {
  int resampled = 0;
  for (const PenaltyWeights& weights : {PenaltyWeights{0.5, 1.0}, {1.0, 0.0}, {0.0, 2.0}}) {
    PlannerOptions options = quick_options();
    options.weights = weights;
    // Without a length term the longest way round is the best: `pareto` shall give up soon.
    if (weights.length == 0.0) options.exact.memory = 0.1;
    const std::unique_ptr<Planner> planner = make(options);
    for (const Situation& situation : all_situations()) {
      SCOPED_TRACE(situation.name);
      const Plan plan = planner->plan(situation.scene(), situation.query);
      if (plan.status != PlanStatus::Found) continue;
      const Raster priority = test::seen_priority(plan, situation);
      resampled += plan.priority_resampled;
      const PathTally again = tally(plan.path, priority);
      EXPECT_EQ(plan.tally.length, again.length);
      EXPECT_EQ(plan.tally.priority, again.priority);
      // Eq. (5), written out once more.
      const Query& query = situation.query;
      const double direct = (query.goal - query.start).norm();
      const double ratio = direct > 0.0 ? again.length / direct : 1.0;
      const double mean = again.length > 0.0 ? again.priority / again.length
                                             : priority.at(query.goal.x(), query.goal.y());
      EXPECT_DOUBLE_EQ(plan.penalty, weights.length * ratio - weights.priority * mean);
      EXPECT_GE(again.length, direct * (1 - 1e-12));
    }
  }
  EXPECT_GT(resampled, 0);
}

TEST_P(PlannerContract, StaysWhereItIsWhenItIsThere) {
  const std::unique_ptr<Planner> planner = make();
  int judged = 0;
  for (const Situation& situation : all_situations()) {
    if (situation.query.start != situation.query.goal) continue;
    const Plan plan = planner->plan(situation.scene(), situation.query);
    if (plan.status != PlanStatus::Found) continue;
    EXPECT_EQ(plan.tally.length, 0.0) << situation.name;
    ASSERT_EQ(plan.path.rows(), 2) << situation.name;
    EXPECT_EQ(plan.path.row(0).transpose(), situation.query.start);
    EXPECT_EQ(plan.path.row(1).transpose(), situation.query.start);
    ++judged;
  }
  EXPECT_GE(judged, 3);
}

TEST_P(PlannerContract, SaysHowGoodItsPathsAreIfItEverDoes) {
  const std::unique_ptr<Planner> planner = make();
  for (const Situation& situation : all_situations()) {
    const Plan plan = planner->plan(situation.scene(), situation.query);
    const bool found = plan.status == PlanStatus::Found;
    EXPECT_EQ(plan.bound.has_value(), found && info_.has(Trait::Bounds)) << situation.name;
    if (plan.bound) {
      EXPECT_LE(*plan.bound, plan.penalty) << situation.name;
    }
  }
}

TEST_P(PlannerContract, AnswersTheSameFreshAndUsedAndAgain) {
  const std::unique_ptr<Planner> used = make();
  const std::unique_ptr<Planner> twin = make();
  for (int round = 0; round < 2; ++round) {
    for (const Situation& situation : all_situations()) {
      SCOPED_TRACE(situation.name);
      const Plan old = used->plan(situation.scene(), situation.query);
      const Plan fresh = make()->plan(situation.scene(), situation.query);
      EXPECT_EQ(old.status, fresh.status);
      EXPECT_TRUE(same(old, twin->plan(situation.scene(), situation.query)));
      if (old.bound && fresh.bound) {  // what either proves holds for the other's path
        EXPECT_LE(*old.bound, fresh.penalty + 1e-12);
        EXPECT_LE(*fresh.bound, old.penalty + 1e-12);
      }
      if (info_.has(Trait::Remembers)) continue;
      EXPECT_TRUE(same(old, fresh));
      EXPECT_TRUE(same(old, used->plan(situation.scene(), situation.query)));
    }
  }
}

TEST_P(PlannerContract, ExpandsNoMoreThanItMay) {
  const PlannerOptions options = quick_options();
  const std::unique_ptr<Planner> planner = make(options);
  int searched = 0;
  for (const Situation& situation : all_situations()) {
    const Plan plan = planner->plan(situation.scene(), situation.query);
    const GridFrame& frame = situation.grid.frame();
    const LevelRange levels = test::slow_levels(frame, situation.query);
    const std::int64_t cells =
        std::int64_t{frame.nx()} * frame.ny() * (levels.highest - levels.lowest + 1);
    const std::int64_t most = most_of(GetParam())(options, cells);
    EXPECT_LE(plan.stats.expanded, most) << situation.name;
    EXPECT_GE(plan.stats.expanded, 0);
    // What a grid planner expands was pushed before; curves are not pushed.
    EXPECT_GE(plan.stats.pushed, info_.has(Trait::Complete) ? plan.stats.expanded : 0);
    EXPECT_LE(plan.stats.pushed, info_.has(Trait::Complete) ? 27 * most : 0);
    EXPECT_GE(plan.stats.seconds, 0.0);
    EXPECT_LT(plan.stats.seconds, 60.0);
    searched += plan.stats.expanded > 0;
  }
  EXPECT_GT(searched, 150);
}

TEST_P(PlannerContract, GivesUpAtItsBudgetAndNotBefore) {
  int exhausted = 0;
  for (const Situation& situation : all_situations()) {
    SCOPED_TRACE(situation.name);
    const Plan whole = make()->plan(situation.scene(), situation.query);
    const std::int64_t needed = whole.stats.expanded;
    if (needed < 2) continue;
    const Plan stopped = make()->plan(situation.scene(), situation.query, {needed - 1});
    EXPECT_EQ(stopped.stats.expanded, needed - 1);
    if (!info_.has(Trait::Anytime) || stopped.status != PlanStatus::Found) {
      EXPECT_EQ(to_string(stopped.status), "out_of_budget");
      EXPECT_EQ(stopped.path.rows(), 0);
      EXPECT_EQ(stopped.penalty, kInfinity);
    } else {  // it keeps what its searches found before
      EXPECT_GE(stopped.penalty, whole.penalty);
    }
    EXPECT_TRUE(same(whole, make()->plan(situation.scene(), situation.query, {needed + 1})));
    ++exhausted;
  }
  EXPECT_GT(exhausted, 100);
}

/// A large window with one end of the query walled in.
Situation sealed_off(bool start) {
  const GridFrame frame(Point(0, 0, 0), Point(2, 2, 4), {60, 60, 10});
  Situation sealed{"", OccupancyGrid(frame), test::random_priority(frame, 1), {}};
  for (int k = 0; k < 27; ++k) {
    if (k != 13) sealed.grid.set(Cell(3, 3, 3) + Cell(k / 9 - 1, k / 3 % 3 - 1, k % 3 - 1));
  }
  sealed.query.start = frame.centre(start ? Cell(3, 3, 3) : Cell(50, 50, 5));
  sealed.query.goal = frame.centre(start ? Cell(50, 50, 5) : Cell(3, 3, 3));
  return sealed;
}

/// The same window in two halves: whichever side a proof begins at, it is long.
Situation divided() {
  Situation halves = sealed_off(true);
  halves.grid.clear();
  for (int i = 0; i < 600; ++i) halves.grid.set(Cell(30, i / 10, i % 10));
  halves.query.start = halves.grid.frame().centre(Cell(3, 30, 3));
  halves.query.goal = halves.grid.frame().centre(Cell(50, 30, 5));
  return halves;
}

TEST_P(PlannerContract, StopsWhenItIsInterruptedOrItsTimeIsOver) {
  const std::unique_ptr<Planner> planner = make(PlannerOptions{});
  int longest = 0;
  for (const Situation& sealed : {sealed_off(true), sealed_off(false), divided()}) {
    int asked = 0;
    const auto ask = [&](const std::function<bool()>& interrupted, double time_limit = 0.0) {
      return planner->plan(sealed.scene(), sealed.query, {0, time_limit, interrupted});
    };
    const Plan whole = ask([&] { return ++asked, false; });
    EXPECT_NE(to_string(whole.status), "out_of_budget");
    EXPECT_LE(asked, 200);
    longest = std::max(longest, asked);
    const int stop = asked / 2;
    if (asked == 0) continue;
    asked = 0;
    const Plan stopped = ask([&] { return ++asked > stop; });
    EXPECT_EQ(to_string(stopped.status), "out_of_budget");
    EXPECT_EQ(asked, stop + 1) << "it is not asked again once it has said so";
    EXPECT_LT(stopped.stats.expanded, whole.stats.expanded);
    // The clock is read as often as the caller is asked; here it is over at once.
    const Plan late = ask(nullptr, 1e-9);
    EXPECT_EQ(to_string(late.status), "out_of_budget");
    EXPECT_LE(late.stats.expanded, stopped.stats.expanded);
    EXPECT_TRUE(same(ask(nullptr), whole));
  }
  EXPECT_GE(longest, 3);
}

TEST_P(PlannerContract, NamesWhatIsWrongWithAQuery) {
  const Situation& good = all_situations().front();
  struct Case {
    const char* name;
    void (*spoil)(Query&);
  };
  const Case cases[] = {
      {"start", [](Query& q) { q.start.x() = kNan; }},
      {"start", [](Query& q) { q.start.z() = -kInfinity; }},
      {"goal", [](Query& q) { q.goal.y() = kNan; }},
      {"goal", [](Query& q) { q.goal.z() = kInfinity; }},
      {"band.below", [](Query& q) { q.band.below = -1.0; }},
      {"band.below", [](Query& q) { q.band.below = kNan; }},
      {"band.below", [](Query& q) { q.band.below = -kInfinity; }},
      {"band.above", [](Query& q) { q.band.above = -1e-300; }},
      {"band.above", [](Query& q) { q.band.above = kNan; }},
  };
  const std::unique_ptr<Planner> planner = make();
  for (const Case& test : cases) {
    Query query = good.query;
    test.spoil(query);
    try {
      planner->plan(good.scene(), query);
      ADD_FAILURE() << "a wrong " << test.name << " was accepted";
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(std::string(error.what()).rfind(std::string(test.name) + " = ", 0), 0u)
          << error.what();
    }
  }
  EXPECT_EQ(to_string(planner->plan(good.scene(), good.query).status), "found");
}

TEST_P(PlannerContract, NamesTheLimitThatIsWrong) {
  const Situation& good = all_situations().front();
  const std::unique_ptr<Planner> planner = make();
  const std::pair<const char*, Budget> cases[] = {{"max_expansions", {-1}},
                                                  {"time_limit", {0, -1.0}},
                                                  {"time_limit", {0, kInfinity}},
                                                  {"time_limit", {0, kNan}}};
  for (const auto& [name, budget] : cases) {
    try {
      planner->plan(good.scene(), good.query, budget);
      ADD_FAILURE() << "a wrong " << name << " was accepted";
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(std::string(error.what()).rfind(std::string(name) + " = ", 0), 0u) << error.what();
    }
  }
}

TEST_P(PlannerContract, NamesTheOptionThatIsWrong) {
  struct Case {
    const char* name;
    void (*spoil)(PlannerOptions&);
  };
  const Case cases[] = {
      {"weights.length", [](PlannerOptions& o) { o.weights.length = -1; }},
      {"weights.priority", [](PlannerOptions& o) { o.weights.priority = kNan; }},
      {"weights.length + weights.priority",
       [](PlannerOptions& o) {
         o.weights = {0.0, 0.0};
       }},
      {"bezier.offsets", [](PlannerOptions& o) { o.bezier.offsets = 0; }},
      {"bezier.offsets", [](PlannerOptions& o) { o.bezier.offsets = 40; }},
      {"bezier.offsets", [](PlannerOptions& o) { o.bezier.offsets = -3; }},
      {"bezier.reach", [](PlannerOptions& o) { o.bezier.reach = 0.0; }},
      {"bezier.reach", [](PlannerOptions& o) { o.bezier.reach = kInfinity; }},
      {"bezier.z_offsets", [](PlannerOptions& o) { o.bezier.z_offsets = 2; }},
      {"bezier.z_reach", [](PlannerOptions& o) { o.bezier.z_reach = -0.1; }},
      {"bezier.segments", [](PlannerOptions& o) { o.bezier.segments = 1; }},
      {"bezier.segments", [](PlannerOptions& o) { o.bezier.segments = -5; }},
      {"bezier.segments", [](PlannerOptions& o) { o.bezier.segments = 2000000000; }},
      {"linearised.alpha", [](PlannerOptions& o) { o.linearised.alpha = -1.0; }},
      {"linearised.tolerance", [](PlannerOptions& o) { o.linearised.tolerance = kNan; }},
      {"linearised.searches", [](PlannerOptions& o) { o.linearised.searches = 0; }},
      {"exact.memory", [](PlannerOptions& o) { o.exact.memory = 0.0; }},
      {"exact.memory", [](PlannerOptions& o) { o.exact.memory = kInfinity; }},
      {"exact.eps", [](PlannerOptions& o) { o.exact.eps = -0.1; }},
      {"exact.eps", [](PlannerOptions& o) { o.exact.eps = kNan; }},
      {"linearised.effort", [](PlannerOptions& o) { o.linearised.effort = -1; }},
      {"linearised.closing", [](PlannerOptions& o) { o.linearised.closing = -1; }},
      {"ara.first_weight", [](PlannerOptions& o) { o.ara.first_weight = 0.9; }},
      {"ara.first_weight", [](PlannerOptions& o) { o.ara.first_weight = kNan; }},
      {"ara.step", [](PlannerOptions& o) { o.ara.step = 0.0; }},
      {"ara.step", [](PlannerOptions& o) { o.ara.step = kInfinity; }},
      {"risk.length_factor", [](PlannerOptions& o) { o.risk.length_factor = 0.0; }},
      {"risk.length_factor", [](PlannerOptions& o) { o.risk.length_factor = kNan; }},
      {"tangent_bug.range", [](PlannerOptions& o) { o.tangent_bug.range = -1.0; }},
      {"tangent_bug.range", [](PlannerOptions& o) { o.tangent_bug.range = kInfinity; }},
      {"hermite.segments", [](PlannerOptions& o) { o.hermite.segments = 1; }},
      {"hermite.starts", [](PlannerOptions& o) { o.hermite.starts = 4; }},
      {"hermite.reach", [](PlannerOptions& o) { o.hermite.reach = 0.0; }},
      {"hermite.reach", [](PlannerOptions& o) { o.hermite.reach = kNan; }},
      {"hermite.refined", [](PlannerOptions& o) { o.hermite.refined = 0; }},
      {"hermite.iterations", [](PlannerOptions& o) { o.hermite.iterations = -1; }},
  };
  for (const Case& test : cases) {
    PlannerOptions options;
    test.spoil(options);
    try {
      make(options);
      ADD_FAILURE() << "a wrong " << test.name << " was accepted";
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(std::string(error.what()).rfind(std::string(test.name) + " = ", 0), 0u)
          << error.what();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, PlannerContract, ::testing::ValuesIn(names()),
                         [](const ::testing::TestParamInfo<std::string_view>& planner) {
                           std::string name(planner.param);
                           for (char& letter : name) letter = letter == '-' ? '_' : letter;
                           return name;
                         });

}  // namespace
}  // namespace ltp
