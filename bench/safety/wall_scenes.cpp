// SPDX-License-Identifier: Apache-2.0
// Scenes in which moving robots are near walls for a long time.
#include "wall_scenes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "placement.h"

namespace avo::safety {
namespace {

constexpr int kRobots = 30;
constexpr double kRadii[] = {0.2, 0.35, 0.5};  // m; navigation has separate routes for every radius
constexpr double kWidest = 0.5;

Scenario walled_scenario(std::uint64_t seed) {
  Scenario scenario = usual_scenario();
  scenario.motion = seed % 2 == 0 ? Motion::held : Motion::exponential;
  return scenario;
}

void add_robots(Scenario& scenario, const std::vector<Vec2>& starts, Random& random) {
  for (std::size_t i = 0; i < starts.size(); ++i) {
    RobotSetup robot = usual_robot(starts[i], starts[i], 0.0);
    robot.radius = kRadii[i % 3];
    robot.max_acceleration = random.between(0.3, 3.0);
    robot.max_speed = random.between(0.5, 2.5);
    robot.preferred_speed = robot.max_speed;
    scenario.robots.push_back(robot);
  }
}

// Returns a scene in which no robot has to arrive for good.
Scene without_end(Scenario scenario, double robot_steps) {
  see_far_enough(scenario);
  const double steps = std::ceil(robot_steps / static_cast<double>(scenario.robots.size()));
  scenario.duration = std::max(1.0, steps) * scenario.time_step;
  return {std::move(scenario)};
}

void add_room(Scenario& scenario, Vec2 half) {
  const std::vector<Vec2> corners{-half, {half.x, -half.y}, half, {-half.x, half.y}};
  scenario.obstacles.push_back({{Chain{corners, true}}, 0.0, Fill::bounds});
}

// Adds separate walls at random places, one for every 4 m² of a square room. Half of them are
// lines, the rest thick lines and discs.
std::vector<Wall> add_random_walls(Scenario& scenario, double side, Random& random) {
  constexpr int kDirections = 3600;
  const double far = 0.5 * side;
  add_room(scenario, {far, far});
  for (double area = 0.0; area < side * side; area += 4.0) {
    const Vec2 middle = random.in_square(side);
    const Vec2 direction = circle_point(static_cast<int>(random.below(kDirections)), kDirections);
    const Vec2 end = random.between(0.05, 0.75) * direction;
    const std::size_t kind = random.below(4);
    if (kind == 0) {
      scenario.obstacles.push_back({{Chain{{middle}}}, random.between(0.05, 0.3)});
    } else {
      const double radius = kind == 1 ? random.between(0.05, 0.2) : 0.0;
      scenario.obstacles.push_back({{Chain{{middle - end, middle + end}}}, radius});
    }
  }
  return walls_of(scenario.obstacles);
}

constexpr double kSide = 20.0;  // m, of the room with random walls
constexpr Area kRoom{{-0.5 * kSide, -0.5 * kSide}, {0.5 * kSide, 0.5 * kSide}};
constexpr Spacing kSpacing{2.0 * kWidest + 0.3, kWidest + 0.05};

bool has_ways(std::uint64_t seed) {
  return seed / 2 % 2 == 0;
}

}  // namespace

Scene random_walls(double robot_steps, std::uint64_t seed) {
  constexpr int kPlaces = 40;
  Scenario scenario = walled_scenario(seed);
  scenario.navigation = has_ways(seed);
  Random random(seed, 24);
  const std::vector<Wall> walls = add_random_walls(scenario, kSide, random);
  add_robots(scenario, places_among(walls, kRoom, kRobots, kSpacing, random), random);
  Scene scene = without_end(std::move(scenario), robot_steps);
  scene.errands = {places_among(walls, kRoom, kPlaces, {0.0, kWidest}, random)};
  return scene;
}

Scene walls_and_cars(double robot_steps, std::uint64_t seed) {
  Scene scene = random_walls(robot_steps, seed);
  scene.scenario.motion = Motion::held;  // the motion that the certificate covers for cars
  Random random(seed, 28);
  for (std::size_t i = 0; i < kRobots; i += 2) {
    RobotSetup& robot = scene.scenario.robots[i];
    robot.model = Car{2.0 * robot.radius};
    robot.heading = random.between(-kPi, kPi);
  }
  return scene;
}

Scene walls_and_movers(std::uint64_t seed) {
  constexpr int kMovers = 8, kFew = 20;
  Scenario scenario = walled_scenario(seed);
  Random random(seed, 25);
  const std::vector<Wall> walls = add_random_walls(scenario, kSide, random);
  add_robots(scenario, places_among(walls, kRoom, kFew, kSpacing, random), random);
  for (int k = 0; k < kMovers; ++k) {
    MovingObstacle mover;
    mover.position = 1.2 * kSide * circle_point(k, kMovers);
    const Vec2 way = random.in_square(0.5 * kSide) - mover.position;
    mover.velocity = (random.between(0.3, 1.5) / norm(way)) * way;
    mover.radius = random.between(0.3, 0.8);
    scenario.moving_obstacles.push_back(mover);
  }
  const double minute = 60.0 / scenario.time_step;
  Scene scene = without_end(std::move(scenario), kFew * minute);
  scene.errands = {places_among(walls, kRoom, kFew, kSpacing, random)};
  return scene;
}

Scene wall_corners(double robot_steps, std::uint64_t seed) {
  constexpr double kRadius = 6.0;  // m, of the circle that the corners stand on
  // for 10°, 20°, 30°, 45°, 60°, 90°, 120°, 150°: their height per half of their width
  constexpr double kHeights[] = {11.43, 5.671, 3.732, 2.414, 1.732, 1.0, 0.5774, 0.2679};
  Scenario scenario = walled_scenario(seed);
  scenario.navigation = false;  // no route leads into a corner
  std::vector<Vec2> outline, tips;
  for (int k = 0; k < 8; ++k) {
    const Vec2 from = kRadius * circle_point(2 * k, 16), to = kRadius * circle_point(2 * k + 1, 16);
    const Vec2 out = kHeights[k] * perpendicular(0.5 * (from - to));
    tips.push_back(0.5 * (from + to) + out);
    outline.insert(outline.end(), {from, tips.back(), to});
  }
  scenario.obstacles.push_back({{Chain{outline, true}}, 0.0, Fill::bounds});
  const std::vector<Wall> walls = walls_of(scenario.obstacles);
  Random random(seed, 26);
  const Area middle{{-kRadius, -kRadius}, {kRadius, kRadius}};
  const auto is_inside = [&](Vec2 place) { return norm(place) < 0.9 * kRadius; };
  add_robots(scenario, places_among(walls, middle, kRobots, kSpacing, random, is_inside), random);
  Scene scene = without_end(std::move(scenario), robot_steps);
  scene.rallies = std::move(tips);
  scene.rally_period = 15.0;
  return scene;
}

Scene wall_gaps(double robot_steps, std::uint64_t seed) {
  constexpr int kGaps = 6;
  // m, distance of the gaps; half of the length of every second gap
  constexpr double kApart = 3.0, kWay = 1.5;
  constexpr double kWider = 1e-6;  // m
  constexpr double kHeight = 0.5 * kApart * kGaps;
  Scenario scenario = walled_scenario(seed);
  scenario.navigation = has_ways(seed);
  add_room(scenario, {9.0, kHeight});
  std::vector<double> middles;
  double below = -kHeight;  // where the piece of the dividing wall begins
  for (int k = 0; k < kGaps; ++k) {
    middles.push_back(-kHeight + kApart * (k + 0.5));
    const double half = kRadii[k % 3] + 0.5 * kWider, way = k % 2 == 0 ? 0.0 : kWay;
    const double low = middles.back() - half, high = middles.back() + half;
    scenario.obstacles.push_back({{Chain{{{0.0, below}, {0.0, low}}}}});
    if (way > 0.0) {
      for (const double y : {low, high})
        scenario.obstacles.push_back({{Chain{{{-way, y}, {way, y}}}}});
    }
    below = high;
  }
  scenario.obstacles.push_back({{Chain{{{0.0, below}, {0.0, kHeight}}}}});
  Random random(seed, 27);
  std::vector<Vec2> starts;
  std::vector<std::vector<Vec2>> errands;
  for (int i = 0; i < kRobots; ++i) {
    const double y = middles[static_cast<std::size_t>(i % kGaps)];
    const int place = i / kGaps;  // place in the line before the gap, on both sides
    const double x = 2.5 + 0.8 * place + random.between(-0.1, 0.1);
    starts.push_back({place % 2 == 0 ? -x : x, y});
    errands.push_back({{-5.0, y}, {5.0, y}});
  }
  add_robots(scenario, starts, random);
  Scene scene = without_end(std::move(scenario), robot_steps);
  scene.errands = std::move(errands);
  return scene;
}

}  // namespace avo::safety
