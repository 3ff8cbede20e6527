// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The situations that every planner must master, and the check that the judge knows the answers.
#include "scenes.hpp"

#include <gtest/gtest.h>

namespace ltp::test {
namespace {

using Status = PlanStatus;

void draw_all(const Drawing& draw, const std::string& suffix, std::vector<Situation>& all) {
  const auto add = [&](const std::string& name, const std::vector<std::string>& lines,
                       std::optional<Status> expected) {
    all.push_back(draw(name + suffix, lines, expected));
  };
  add("open field", {"..........", ".S........", "..........", "........G.", ".........."},
      Status::Found);
  add("wall with a gap", {"....#.....", ".S..#...G.", "....#.....", "....#.....", ".........."},
      Status::Found);
  add("wall", {"....#.....", ".S..#...G.", "....#.....", "....#.....", "....#....."},
      Status::Unreachable);
  add("bug trap",
      {"..........", "..######..", ".......#..", "..S....#.G", ".......#..", "..######..",
       ".........."},
      Status::Found);
  add("bug trap from outside",
      {"..........", "..######..", ".......#..", "..G....#.S", ".......#..", "..######..",
       ".........."},
      Status::Found);
  add("corridor", {"S#...#...#", ".#.#.#.#.#", ".#.#.#.#.#", ".#.#.#.#.#", "...#...#.G"},
      Status::Found);
  add("corridor with a door shut",
      {"S#...#...#", ".#.#.#.#.#", ".#.#.#.###", ".#.#.#.#.#", "...#...#.G"}, Status::Unreachable);
  add("sealed goal", {"..........", ".S...###..", ".....#G#..", ".....###..", ".........."},
      Status::Unreachable);
  add("sealed start", {"..........", ".G...###..", ".....#S#..", ".....###..", ".........."},
      Status::Unreachable);
  add("goal sealed by four", {"..........", ".S....#...", ".....#G#..", "......#...", ".........."},
      Status::Unreachable);
  add("diagonal slit", {"...#......", ".S.#......", "...#......", "....#...G.", "....#....."},
      Status::Unreachable);
  add("diagonal slit, the other way",
      {"....#.....", ".S..#.....", "....#.....", "...#....G.", "...#......"}, Status::Unreachable);
  add("staircase",
      {"......S#", ".....###", "....##..", "...##...", "..##....", ".##.....", "##......",
       "#......G"},
      Status::Unreachable);
  add("staircase of corners",
      {"S......#", "......#.", ".....#..", "....#...", "...#....", "..#.....", ".#......",
       "#......G"},
      Status::Unreachable);
  add("gap of one diagonal", {"S..#....", "...#....", "........", "....#...", "....#..G"},
      Status::Found);
  add("occupied start", {"....", ".s.G", "...."}, Status::StartBlocked);
  add("occupied goal", {"....", ".S.g", "...."}, Status::GoalBlocked);
  add("both occupied", {"....", ".s.g", "...."}, Status::GoalBlocked);
  add("beside each other", {"...", "SG.", "..."}, Status::Found);
  add("beside each other over an edge", {"...", "S..", ".G."}, Status::Found);
  add("over an edge past a block", {"...", "S..", "#G."}, Status::Found);
  add("over an edge between two blocks", {"#..", "S#.", "#G."}, Status::Unreachable);
  add("one row", {"S..G"}, Status::Found);
  add("one column", {"S", ".", "G"}, Status::Found);
}

Situation with_points(const Situation& like, const std::string& name, const Point& start,
                      const Point& goal, std::optional<Status> expected) {
  Situation made = like;
  made.name = name;
  made.query.start = start;
  made.query.goal = goal;
  made.expected = expected;
  made.centred = false;
  return made;
}

Situation empty(const GridFrame& frame, const std::string& name, const Cell& start,
                const Cell& goal) {
  Situation made{name, OccupancyGrid(frame), random_priority(frame, 3), {}, std::nullopt};
  made.query.start = frame.centre(start);
  made.query.goal = frame.centre(goal);
  return made;
}

/// The shell of a box of cells.
void build_shell(OccupancyGrid& grid, const Cell& low, const Cell& high) {
  for (int x = low.x(); x <= high.x(); ++x) {
    for (int y = low.y(); y <= high.y(); ++y) {
      for (int z = low.z(); z <= high.z(); ++z) {
        const Cell cell(x, y, z);
        if ((cell.array() == low.array()).any() || (cell.array() == high.array()).any()) {
          grid.set(cell);
        }
      }
    }
  }
}

void add_boxes(const Point& cell, std::vector<Situation>& all) {
  const GridFrame frame(Point(5, -60, 0.5), cell, {11, 10, 9});
  Situation box = empty(frame, "hollow box", Cell(0, 0, 0), Cell(5, 5, 4));
  build_shell(box.grid, Cell(3, 3, 2), Cell(7, 8, 7));
  box.expected = Status::Unreachable;
  all.push_back(box);
  Situation out =
      with_points(box, "out of a hollow box", box.query.goal, box.query.start, Status::Unreachable);
  out.centred = true;
  all.push_back(out);
  Situation inside = empty(frame, "inside a hollow box", Cell(4, 4, 3), Cell(6, 7, 6));
  inside.grid = box.grid;
  inside.expected = Status::Found;
  all.push_back(inside);
  Situation hole = box;
  hole.name = "hollow box with a hole";
  hole.grid.set(Cell(5, 5, 7), false);
  hole.expected = Status::Found;
  all.push_back(hole);
  Situation edge = box;
  edge.name = "hollow box without an edge";  // a beam of it, so steps past it stay forbidden
  edge.grid.set(Cell(3, 3, 4), false);
  all.push_back(edge);
  Situation six = empty(frame, "goal sealed by six", Cell(0, 0, 0), Cell(5, 5, 4));
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {-1, 1}) {
      Cell wall(5, 5, 4);
      wall[axis] += side;
      six.grid.set(wall);
    }
  }
  six.expected = Status::Unreachable;
  all.push_back(six);
  // Only a step over a common corner or edge would lead from below to above.
  Situation layers = empty(frame, "corner slit", Cell(5, 5, 0), Cell(5, 5, 8));
  for (int x = 0; x < frame.nx(); ++x) {
    for (int y = 0; y < frame.ny(); ++y) layers.grid.set(Cell(x, y, (x + y) % 2 == 0 ? 4 : 5));
  }
  layers.expected = Status::Unreachable;
  all.push_back(layers);
}

void add_towers(int levels, std::vector<Situation>& all) {
  const GridFrame frame(Point(0, 0, -20), Point(2, 2, 4), {5, 5, levels});
  // Floors with a hole at alternating corners, round the border of two words.
  Situation tower =
      empty(frame, "tower of " + std::to_string(levels), Cell(2, 2, 1), Cell(2, 2, levels - 1));
  for (const int floor : {3, 31, 61, 63}) {
    for (int x = 0; x < 5; ++x) {
      for (int y = 0; y < 5; ++y) tower.grid.set(Cell(x, y, floor));
    }
    const int corner = floor == 31 || floor == 63 ? 0 : 4;
    tower.grid.set(Cell(corner, 4 - corner, floor), false);
  }
  tower.expected = Status::Found;
  all.push_back(tower);
  for (const int floor : {62, 63, 64}) {
    Situation shut = tower;
    shut.name += ", shut at " + std::to_string(floor);
    if (floor >= levels) continue;
    for (int x = 0; x < 5; ++x) {
      for (int y = 0; y < 5; ++y) shut.grid.set(Cell(x, y, floor));
    }
    shut.expected = floor == levels - 1 ? Status::GoalBlocked : Status::Unreachable;
    all.push_back(shut);
  }
  Situation band = tower;
  band.name += ", planar at the top";
  band.query.start = frame.centre(Cell(0, 4, levels - 1));
  band.query.goal = frame.centre(Cell(4, 0, levels - 1));
  band.query.band = kPlanar;
  band.expected = Status::Found;
  all.push_back(band);
}

void add_bands(std::vector<Situation>& all) {
  // A wall on the levels 1 to 3 of 6; only over it or under it.
  const Drawing draw{{2, 2, 4}, 6, 2, 1, 3, {}};
  const std::vector<std::string> wall = {"....#....", "S...#...G", "....#...."};
  struct Case {
    const char* name;
    AltitudeBand band;
    Status expected;
  };
  const Case cases[] = {
      {"wall, planar", {0, 0}, Status::Unreachable},
      {"wall, open band", {kInfinity, kInfinity}, Status::Found},
      {"wall, open above", {0, kInfinity}, Status::Found},
      {"wall, open below", {kInfinity, 0}, Status::Found},
      {"wall, band to the lowest level", {6.5, 0}, Status::Found},
      {"wall, band just above the lowest level", {5.9, 5.9}, Status::Unreachable},
      {"wall, band to the fifth level", {0, 6.5}, Status::Found},
      {"wall, huge band", {1e300, 1e300}, Status::Found},
  };
  for (const Case& test : cases) {
    Situation made = draw(test.name, wall, test.expected);
    made.query.band = test.band;
    all.push_back(made);
  }
  // Planar flight between two altitudes may use those between.
  Situation climb = draw("planar from the top to the bottom", wall, Status::Found);
  climb.query.start.z() += 12;
  climb.query.goal.z() -= 8;
  climb.query.band = kPlanar;
  all.push_back(climb);
  Situation part = draw("planar between two levels of the wall", wall, Status::Unreachable);
  part.query.start.z() += 4;
  part.query.band = kPlanar;
  all.push_back(part);
}

void add_points(std::vector<Situation>& all) {
  const Drawing draw{{2, 2, 4}, 3, 1, 1, 1, {}};
  const Situation field =
      draw("", {".......", ".#...#.", "...S...", ".#...#.", "...G..."}, std::nullopt);
  const GridFrame& frame = field.grid.frame();
  const Point s = field.query.start;
  const Point g = field.query.goal;
  all.push_back(with_points(field, "start equals goal", s, s, Status::Found));
  all.push_back(with_points(field, "start equals goal on a corner", frame.origin(), frame.origin(),
                            Status::Found));
  all.push_back(with_points(field, "same cell", s - Point(0.9, 0.9, 1.9), s + Point(0.9, 0.9, 1.9),
                            Status::Found));
  all.push_back(with_points(field, "hardly apart", s, s + Point(1e-300, 0, 5e-324), Status::Found));
  all.push_back(with_points(field, "straight up", s, s + Point(0, 0, 3.9), Status::Found));
  all.push_back(
      with_points(field, "goal beyond the east", s, s + Point(100, 0, 0), Status::OutsideMap));
  all.push_back(with_points(field, "goal on the upper edge", s,
                            Point(frame.upper().x(), s.y(), s.z()), Status::OutsideMap));
  all.push_back(
      with_points(field, "goal beyond the top", s, s + Point(0, 0, 6), Status::OutsideMap));
  all.push_back(
      with_points(field, "start below the floor", s - Point(0, 0, 6.5), g, Status::OutsideMap));
  all.push_back(with_points(field, "both beyond the world", Point(1e300, 0, 0), Point(0, -1e300, 0),
                            Status::OutsideMap));
  const Point block = frame.centre(Cell(1, 1, 1));
  all.push_back(with_points(field, "start occupied, goal outside", block, s + Point(1e4, 0, 0),
                            Status::OutsideMap));
  all.push_back(with_points(field, "goal occupied, start outside", Point(-1e4, 0, 0), block,
                            Status::OutsideMap));
  // On the faces, edges and corners round a blocked cell: the upper cells are free, it is not.
  for (int corner = 0; corner < 27; ++corner) {
    const Point at = block + Point(corner % 3 - 1, corner / 3 % 3 - 1, 2 * (corner / 9 - 1));
    const bool occupied = corner % 3 < 2 && corner / 3 % 3 < 2 && corner / 9 < 2;
    const std::string place = std::to_string(corner);
    all.push_back(with_points(field, "from the face, edge or corner " + place + " of a block", at,
                              g, occupied ? Status::StartBlocked : Status::Found));
    all.push_back(with_points(field, "to the face, edge or corner " + place + " of a block", s, at,
                              occupied ? Status::GoalBlocked : Status::Found));
  }
  const GridFrame dot(Point(0, 0, 0), Point(2, 2, 4), {1, 1, 1});
  Situation single = empty(dot, "a single cell", Cell(0, 0, 0), Cell(0, 0, 0));
  single.expected = Status::Found;
  all.push_back(single);
  single.grid.set(Cell(0, 0, 0));
  single.name = "a single blocked cell";
  single.expected = Status::GoalBlocked;
  all.push_back(single);
}

/// Clutter on frames whose numbers doubles do not hold exactly, with ends on faces and corners.
void add_clutter(std::vector<Situation>& all) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const Point edges[] = {{2, 2, 4}, {2, 2, 2}, {0.1, 0.3, 0.7}, {1.0 / 3, 0.2, 0.1}, {7, 1, 3}};
  for (int k = 0; k < 150; ++k) {
    const std::array<int, 3> dims = {2 + static_cast<int>(random() % 8),
                                     2 + static_cast<int>(random() % 8),
                                     1 + static_cast<int>(random() % 6)};
    const Point anchor(k % 3 == 0 ? 0.3 : 0.0, k % 5 == 0 ? -12.7 : 1.0, 0.1);
    GridFrame frame(anchor, edges[k % 5], dims);
    if (k % 2 == 0) {
      frame = frame.shifted({static_cast<int>(random() % 2001) - 1000,
                             static_cast<int>(random() % 51) - 25,
                             static_cast<int>(random() % 200001) - 100000});
    }
    const auto cell = [&] {
      return frame.cell_at(static_cast<std::int64_t>(random() % frame.size()));
    };
    const Cell from = cell();
    const Cell to = cell();
    Situation made = empty(frame, "clutter " + std::to_string(k), from, to);
    const double density = 0.1 + 0.1 * (k % 5);
    for (std::int64_t i = 0; i < frame.size(); ++i) {
      const Cell other = frame.cell_at(i);
      if (unit(random) < density && other != from && other != to) made.grid.set(other);
    }
    if (k % 3 != 0) {
      made.centred = false;
      for (Point* end : {&made.query.start, &made.query.goal}) {
        for (int axis = 0; axis < 3; ++axis) {
          const double offsets[] = {0.0, 0.25, -0.5, -0.4999999999999, 0.5};
          // A band that ends on a face would leave its levels to rounding.
          const int choice = axis == 2 && k % 4 < 2 ? 2 : 5;
          (*end)[axis] += offsets[random() % choice] * frame.cell()[axis];
        }
      }
    }
    if (k % 4 == 0) made.query.band = kPlanar;
    if (k % 4 == 1) made.query.band = {frame.cell().z(), 0.5 * frame.cell().z()};
    all.push_back(made);
  }
}

}  // namespace

std::vector<Situation> drawn_situations() {
  std::vector<Situation> all;
  draw_all(Drawing{{2, 2, 4}, 1, 0, 0, 0, {}}, "", all);
  draw_all(Drawing{{2, 2, 2}, 3, 1, 0, 2, {}}, " on cubes, three levels high", all);
  draw_all(Drawing{{2, 2, 4}, 3, 1, 1, 1, kPlanar}, ", planar between open levels", all);
  return all;
}

std::vector<Situation> built_situations() {
  std::vector<Situation> all;
  add_boxes({2, 2, 2}, all);
  add_boxes({2, 2, 4}, all);
  add_towers(65, all);
  add_towers(80, all);
  add_bands(all);
  add_points(all);
  add_clutter(all);
  return all;
}

std::vector<Situation> situations() {
  std::vector<Situation> all = drawn_situations();
  for (Situation& situation : built_situations()) all.push_back(std::move(situation));
  return all;
}

namespace {

TEST(Scenes, AreManyOfEachKind) {
  const std::vector<Situation> all = situations();
  std::array<int, 7> statuses{};
  for (const Situation& situation : all) {
    ++statuses[static_cast<int>(slow_status(situation))];
  }
  EXPECT_EQ(drawn_situations().size(), 3u * 24u);
  EXPECT_GT(all.size(), 300u);
  EXPECT_GT(statuses[static_cast<int>(Status::Found)], 100);
  EXPECT_GT(statuses[static_cast<int>(Status::Unreachable)], 60);
  EXPECT_GT(statuses[static_cast<int>(Status::OutsideMap)], 5);
  EXPECT_GT(statuses[static_cast<int>(Status::StartBlocked)], 5);
  EXPECT_GT(statuses[static_cast<int>(Status::GoalBlocked)], 5);
}

TEST(Scenes, AreJudgedAsByHand) {
  int known = 0;
  for (const Situation& situation : situations()) {
    if (!situation.expected) continue;
    EXPECT_EQ(slow_status(situation), *situation.expected) << situation.name;
    ++known;
  }
  EXPECT_GT(known, 150);
}

TEST(Scenes, AreJudgedByBoxesThatArePassedOrMet) {
  OccupancyGrid grid(GridFrame(Point(0, 0, 0), Point(2, 2, 4), {3, 3, 3}));
  grid.set(Cell(1, 1, 1));
  Path past(2, 3), through(2, 3), along(2, 3);
  past << 1.9, -5, 6, 1.9, 9, 6;
  through << 0, 0, 0, 6, 6, 12;
  along << 2, -5, 4, 2, 9, 4;
  EXPECT_FALSE(meets_blocked(grid, past, 0.0));
  EXPECT_TRUE(meets_blocked(grid, past, 0.11));
  EXPECT_TRUE(meets_blocked(grid, through, -0.9));
  EXPECT_TRUE(meets_blocked(grid, along, 1e-9));
  EXPECT_FALSE(meets_blocked(grid, along, -1e-9));
}

}  // namespace

}  // namespace ltp::test
