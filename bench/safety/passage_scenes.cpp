// SPDX-License-Identifier: Apache-2.0
// Scenes of 50 robots that have to share passages between walls.
#include "passage_scenes.h"

#include <cmath>
#include <cstddef>
#include <utility>

#include "placement.h"

namespace avo::safety {
namespace {

constexpr int kRobots = 50;
constexpr double kRadius = 0.5;  // m
// Robots start with small gaps; their goals leave room for one robot between two that stand there.
constexpr Spacing kStarts{2.6 * kRadius, 1.5 * kRadius}, kGoals{3.0 * kRadius, 1.5 * kRadius},
    kSparseGoals{3.2 * kRadius, 1.6 * kRadius};

void add_wall(Scenario& scenario, Vec2 a, Vec2 b) {
  scenario.obstacles.push_back({{Chain{{a, b}}}});
}

void add_bounds(Scenario& scenario, std::vector<Vec2> corners) {
  scenario.obstacles.push_back({{Chain{std::move(corners), true}}, 0.0, Fill::bounds});
}

void add_robots(Scenario& scenario, const std::vector<Vec2>& starts,
                const std::vector<Vec2>& goals) {
  for (std::size_t i = 0; i < starts.size(); ++i) {
    scenario.robots.push_back(usual_robot(starts[i], goals[i], kSpeed));
  }
}

Scene within_ten_minutes(Scenario scenario) {
  Scene scene{std::move(scenario)};
  scene.unit = scene.scenario.duration = 600.0;
  scene.share = 0.98;
  return scene;
}

// Sends half of the robots from the room on the left to the room on the right, and half back.
// `starts` and `goals` are areas of the right room; starts lie nearer to the passage than goals.
void cross(Scenario& scenario, const Area& starts, const Area& goals, Random& random) {
  const std::vector<Wall> walls = walls_of(scenario.obstacles);
  const auto mirrored = [](const Area& area) {
    return Area{{-area.high.x, area.low.y}, {-area.low.x, area.high.y}};
  };
  constexpr int kHalf = kRobots / 2;
  for (const bool right : {false, true}) {
    const Area& from = right ? starts : mirrored(starts);
    const Area& to = right ? mirrored(goals) : goals;
    const std::vector<Vec2> places = places_among(walls, from, kHalf, kStarts, random);
    add_robots(scenario, places, places_among(walls, to, kHalf, kGoals, random));
  }
}

// The missing walls of a square of cells: the walls to the right of cells, and the walls above
// them.
struct Openings {
  std::vector<char> right, above;
};

struct Step {
  int cell;
  char* opening;
};

// Returns a spanning tree by depth-first search from the first cell.
Openings open_tree(int cells, Random& random) {
  const auto count = static_cast<std::size_t>(cells * cells);
  Openings open{std::vector<char>(count), std::vector<char>(count)};
  std::vector<char> is_reached(count);
  std::vector<int> path{0};
  is_reached[0] = 1;
  while (!path.empty()) {
    const int cell = path.back(), x = cell % cells, y = cell / cells;
    std::vector<Step> steps;
    const auto offer = [&](bool is_inside, int next, std::vector<char>& openings, int opening) {
      if (!is_inside || is_reached[static_cast<std::size_t>(next)] != 0) return;
      steps.push_back({next, &openings[static_cast<std::size_t>(opening)]});
    };
    offer(x > 0, cell - 1, open.right, cell - 1);
    offer(x + 1 < cells, cell + 1, open.right, cell);
    offer(y > 0, cell - cells, open.above, cell - cells);
    offer(y + 1 < cells, cell + cells, open.above, cell);
    if (steps.empty()) {
      path.pop_back();
      continue;
    }
    const Step step = steps[random.below(steps.size())];
    *step.opening = 1;
    is_reached[static_cast<std::size_t>(step.cell)] = 1;
    path.push_back(step.cell);
  }
  return open;
}

void open_more(Openings& open, double share, Random& random) {
  for (std::size_t cell = 0; cell < open.right.size(); ++cell) {
    if (random.between(0.0, 1.0) < share) open.right[cell] = 1;
    if (random.between(0.0, 1.0) < share) open.above[cell] = 1;
  }
}

void add_maze_walls(Scenario& scenario, int cells, double size, const Openings& open) {
  const double side = cells * size;
  add_bounds(scenario, {{0.0, 0.0}, {side, 0.0}, {side, side}, {0.0, side}});
  for (int cell = 0; cell < cells * cells; ++cell) {
    const int column = cell % cells, row = cell / cells;
    const double left = column * size, bottom = row * size;
    const double right = left + size, top = bottom + size;
    const auto k = static_cast<std::size_t>(cell);
    if (column + 1 < cells && open.right[k] == 0) {
      add_wall(scenario, {right, bottom}, {right, top});
    }
    if (row + 1 < cells && open.above[k] == 0) add_wall(scenario, {left, top}, {right, top});
  }
}

}  // namespace

Scene narrow_doorway(double width, std::uint64_t seed) {
  constexpr double kLength = 16.0, kHalf = 8.0;  // m, of a room: along x, and half of it along y
  Scenario scenario = usual_scenario();
  add_bounds(scenario,
             {{-kLength, -kHalf}, {kLength, -kHalf}, {kLength, kHalf}, {-kLength, kHalf}});
  for (const double side : {-1.0, 1.0}) {
    add_wall(scenario, {0.0, 0.5 * side * width}, {0.0, side * kHalf});
  }
  Random random(seed, 20);
  const double far = kLength - 1.0, high = kHalf - 1.0;
  cross(scenario, {{3.0, -high}, {far, high}}, {{5.0, -high}, {far, high}}, random);
  return within_ten_minutes(std::move(scenario));
}

Scene narrow_corridor(double width, std::uint64_t seed) {
  constexpr double kLength = 14.0, kHalf = 8.0;  // m, of a room: along x, and half of it along y
  constexpr double kEnd = 5.0;                   // m, x of the corridor's right end
  constexpr double kFar = kEnd + kLength;
  const double side = 0.5 * width;
  Scenario scenario = usual_scenario();
  add_bounds(scenario, {{-kFar, -kHalf},
                        {-kEnd, -kHalf},
                        {-kEnd, -side},
                        {kEnd, -side},
                        {kEnd, -kHalf},
                        {kFar, -kHalf},
                        {kFar, kHalf},
                        {kEnd, kHalf},
                        {kEnd, side},
                        {-kEnd, side},
                        {-kEnd, kHalf},
                        {-kFar, kHalf}});
  Random random(seed, 21);
  const double far = kFar - 1.0, high = kHalf - 1.0;
  cross(scenario, {{kEnd + 2.0, -high}, {far, high}}, {{kEnd + 3.0, -high}, {far, high}}, random);
  return within_ten_minutes(std::move(scenario));
}

Scene office(double door, std::uint64_t seed) {
  constexpr int kRooms = 5;                       // on each side
  constexpr double kRoom = 6.0, kCorridor = 3.0;  // m
  constexpr double kLength = kRooms * kRoom, kHalf = 0.5 * kCorridor + kRoom;
  Scenario scenario = usual_scenario();
  add_bounds(scenario, {{0.0, -kHalf}, {kLength, -kHalf}, {kLength, kHalf}, {0.0, kHalf}});
  for (const double side : {-1.0, 1.0}) {
    const double front = 0.5 * side * kCorridor, back = side * kHalf;
    for (int k = 0; k < kRooms; ++k) {
      const double left = k * kRoom, right = left + kRoom, middle = left + 0.5 * kRoom;
      add_wall(scenario, {left, front}, {middle - 0.5 * door, front});
      add_wall(scenario, {middle + 0.5 * door, front}, {right, front});
      if (k > 0) add_wall(scenario, {left, front}, {left, back});
    }
  }
  Random random(seed, 22);
  const std::vector<Wall> walls = walls_of(scenario.obstacles);
  const Area all{{0.0, -kHalf}, {kLength, kHalf}};
  const std::vector<Vec2> starts = places_among(walls, all, kRobots, kStarts, random);
  const auto is_in_room = [](Vec2 place) {  // and not in front of its door
    return std::abs(place.y) > 0.5 * kCorridor + 2.5 * kRadius + 0.5;
  };
  add_robots(scenario, starts, places_among(walls, all, kRobots, kSparseGoals, random, is_in_room));
  return within_ten_minutes(std::move(scenario));
}

Scene maze(std::uint64_t seed) {
  constexpr int kCells = 10;
  constexpr double kSize = 3.0;  // m, of a cell
  Scenario scenario = usual_scenario();
  Random random(seed, 23);
  Openings open = open_tree(kCells, random);
  open_more(open, 0.1, random);
  add_maze_walls(scenario, kCells, kSize, open);
  const std::vector<Wall> walls = walls_of(scenario.obstacles);
  const Area all{{0.0, 0.0}, {kCells * kSize, kCells * kSize}};
  const std::vector<Vec2> starts = places_among(walls, all, kRobots, kStarts, random);
  add_robots(scenario, starts, places_among(walls, all, kRobots, kSparseGoals, random));
  return within_ten_minutes(std::move(scenario));
}

}  // namespace avo::safety
