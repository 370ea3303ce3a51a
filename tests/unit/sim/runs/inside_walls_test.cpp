// SPDX-License-Identifier: Apache-2.0
// Robots that were put into a wall, or pushed: out of it first, to their own side, and then on.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <string>
#include <vector>

#include "avo/simulation.h"
#include "unit/sim/scenes.h"
#include "walls/segment.h"

namespace avo {
namespace {

constexpr double kRadius = 0.5;  // m, of all discs

StaticObstacle polyline(std::vector<Vec2> points, double radius = 0.0) {
  return {.chains = {{std::move(points)}}, .radius = radius};
}
StaticObstacle solid(std::vector<Vec2> points) {
  return {.chains = {{std::move(points), true}}, .fill = Fill::solid};
}

// A row of cells of a map, each with walls of its own.
StaticObstacle cells() {
  StaticObstacle map{.fill = Fill::solid};
  for (double x = -5.0; x < 5.0; x += 0.5)
    map.chains.push_back({{{x, 0.0}, {x + 0.5, 0.0}, {x + 0.5, -0.5}, {x, -0.5}}, true});
  return map;
}

// A place that many meters deep in what is above it, and a goal that its walls part from it.
struct Start {
  std::string name;
  std::vector<StaticObstacle> obstacles;
  Vec2 position, goal;
};

std::vector<Start> starts(double depth) {
  const double h = kRadius - depth, diagonal = h * std::numbers::sqrt2 / 2.0;
  const StaticObstacle floor = polyline({{-5.0, 0.0}, {5.0, 0.0}});
  return {
      {"wall", {floor}, {0.0, h}, {0.3, -5.0}},
      {"wall, goal along it", {floor}, {0.0, h}, {4.0, 0.6}},
      {"wall, goal before it", {floor}, {0.0, h}, {3.0, 4.0}},
      {"wall in pieces",
       {polyline({{-5, 0}, {-1, 0}, {-0.1, 0}, {0.2, 0}, {5, 0}})},
       {0, h},
       {0, -5}},
      {"thick wall", {polyline({{-5.0, -0.2}, {5.0, -0.2}}, 0.2)}, {0.0, h}, {0.3, -5.0}},
      {"disc", {polyline({{0.0, -0.5}}, 0.5)}, {0.0, h}, {0.1, -5.0}},
      {"inner corner", {polyline({{0, 6}, {0, 0}, {6, 0}})}, {h, h}, {-3.0, -3.0}},
      {"outer corner", {polyline({{0, -6}, {0, 0}, {6, 0}})}, {-diagonal, diagonal}, {3.0, -3.0}},
      {"corridor", {floor, polyline({{-5.0, 1.1}, {5.0, 1.1}})}, {0.0, h}, {8.0, -3.0}},
      {"solid", {solid({{-3, -2}, {3, -2}, {3, 0}, {-3, 0}})}, {0.0, h}, {0.3, -6.0}},
      {"thin solid", {solid({{-3, -0.2}, {3, -0.2}, {3, 0}, {-3, 0}})}, {0.0, h}, {0.3, -6.0}},
      {"map", {cells()}, {0.13, h}, {0.3, -6.0}},
  };
}

Scenario scene_of(const Start& start, const MotionModel& model, double heading) {
  Scenario scene{.allow_broken_assumptions = true};
  scene.obstacles = start.obstacles;
  RobotSetup setup = test::robot_at(start.position, start.goal);
  setup.model = model;
  setup.heading = heading;
  if (const auto* drive = std::get_if<DifferentialDrive>(&model)) {
    setup.radius = kRadius - drive->offset;
    setup.position = start.position - disc_center(model, {}, heading);
  }
  scene.robots = {setup};
  return scene;
}

double clearance(const Scenario& scene, Vec2 center) {
  double least = 1e9;
  for (const Wall& wall : walls_of(scene.obstacles))
    least = std::min(least, distance(center, {wall.a, wall.b}) - wall.radius - kRadius);
  return least;
}

struct Leaving {
  double clear = -1.0, arrived = -1.0;  // s; -1: never
  double deeper = 0.0;                  // m, than it was, or in a wall again
  double moved = 0.0;                   // m, until it is clear
};

Leaving leave(Simulation& simulation, const Scenario& scene, double last) {
  const auto center = [&] {
    const FleetView fleet = simulation.fleet();
    return disc_center(fleet.setup[0].model, fleet.position[0], fleet.heading[0]);
  };
  const Vec2 start = center();
  Leaving result;
  double least = clearance(scene, start);
  const double begin = simulation.time();
  while (simulation.time() - begin < last && result.arrived < 0.0) {
    simulation.step();
    const double now = clearance(scene, center());
    if (result.clear < 0.0 && now >= 0.0) {
      result.clear = simulation.time() - begin;
      result.moved = norm(center() - start);
      least = 0.0;
    }
    result.deeper = std::max(result.deeper, least - now);
    const FleetView fleet = simulation.fleet();
    if (norm(fleet.position[0] - fleet.goal[0]) < 0.5) result.arrived = simulation.time() - begin;
  }
  return result;
}

constexpr double kDepths[] = {0.001, 0.02, 0.1, 0.3, 0.499};

// 2 √(d/a) is the time that the distance d takes from rest to rest.
TEST(InsideWalls, a_robot_leaves_as_fast_as_it_can_to_its_own_side_and_goes_on) {
  for (const double depth : kDepths) {
    for (const Start& start : starts(depth)) {
      SCOPED_TRACE(start.name + ", " + std::to_string(depth) + " m");
      const Scenario scene = scene_of(start, Holonomic{}, 0.0);
      Simulation simulation(scene, 1);
      const Leaving leaving = leave(simulation, scene, 40.0);
      // Out of both walls of a corner the distance is √2 times as long.
      const double way = start.name == "inner corner" ? std::numbers::sqrt2 * depth : depth;
      EXPECT_GT(leaving.clear, 0.0);
      EXPECT_LE(leaving.clear, 2.0 * std::sqrt(way + 0.01) + 0.2);
      EXPECT_LE(leaving.moved, way + 0.03);
      EXPECT_LE(leaving.deeper, 1e-12);
      EXPECT_GT(leaving.arrived, 0.0);
    }
  }
}

TEST(InsideWalls, robots_with_wheels_leave_as_well) {
  struct Kind {
    MotionModel model;
    double most;  // s, for 2 cm
  };
  for (const Kind& kind : {Kind{DifferentialDrive{}, 1.0}, Kind{Car{}, 1.5},
                           Kind{Car{.max_curvature = 0.8, .reverse = true}, 2.0}}) {
    for (const double heading : {0.0, 0.7, std::numbers::pi / 2.0}) {
      for (const double depth : kDepths) {
        for (const Start& start : starts(depth)) {
          if (start.name == "inner corner" || start.name == "corridor") continue;
          // a car deep in a wall comes nearer to the end of the next piece as it turns out of it
          const bool in_pieces = start.name == "map" || start.name == "wall in pieces";
          if (in_pieces && std::holds_alternative<Car>(kind.model)) continue;
          SCOPED_TRACE(start.name + ", " + std::to_string(depth) + " m, heading " +
                       std::to_string(heading));
          const Scenario scene = scene_of(start, kind.model, heading);
          Simulation simulation(scene, 1);
          const Leaving leaving = leave(simulation, scene, 60.0);
          EXPECT_GT(leaving.clear, 0.0);
          EXPECT_LE(leaving.clear, kind.most + 4.0 * std::max(depth - 0.02, 0.0) / kRadius);
          EXPECT_LE(leaving.deeper, 1e-12);
          EXPECT_GT(leaving.arrived, 0.0);
        }
      }
    }
  }
}

// The center is on the wall: to the side of the goal.
TEST(InsideWalls, half_through_a_wall_it_leaves_to_where_it_wants_to_go) {
  for (const Start& start : starts(kRadius)) {
    if (!start.name.starts_with("wall")) continue;
    SCOPED_TRACE(start.name);
    const Scenario scene = scene_of(start, Holonomic{}, 0.0);
    Simulation simulation(scene, 1);
    const Leaving leaving = leave(simulation, scene, 40.0);
    EXPECT_LE(leaving.clear, 2.0);
    EXPECT_GT(leaving.clear, 0.0);
    EXPECT_LE(leaving.arrived, 8.0);
    EXPECT_GT(leaving.arrived, 0.0);
  }
}

// Between walls that leave it no room it goes to where there is some.
TEST(InsideWalls, out_of_a_gap_that_is_too_narrow_it_goes_along_it) {
  for (const double depth : {0.001, 0.02, 0.1}) {
    Scenario scene{.allow_broken_assumptions = true};
    const double y = 2.0 * (kRadius - depth);
    scene.obstacles = {polyline({{-5.0, 0.0}, {5.0, 0.0}}), polyline({{-5.0, y}, {5.0, y}})};
    scene.robots = {test::robot_at({4.0, y / 2.0}, {8.0, -3.0})};
    Simulation simulation(scene, 1);
    const Leaving leaving = leave(simulation, scene, 40.0);
    EXPECT_GT(leaving.clear, 0.0);
    EXPECT_LE(leaving.clear, 12.0) << depth;
    EXPECT_LE(leaving.deeper, 1e-12);
    EXPECT_GT(leaving.arrived, 0.0);
  }
}

TEST(InsideWalls, moved_robots_and_moved_maps) {
  const Start start = starts(0.02).front();
  Scenario scene = scene_of(start, Holonomic{}, 0.0);
  const Vec2 inside = scene.robots[0].position;
  scene.robots[0].position = {0.0, 3.0};
  scene.certificate = Certificate::none;  // else nothing comes onto a robot
  const std::vector<StaticObstacle> walls = std::exchange(scene.obstacles, {});
  scene.robots[0].position = inside;
  Simulation simulation(scene, 1);
  simulation.add_obstacle(walls[0]);
  scene.obstacles = walls;
  const Leaving leaving = leave(simulation, scene, 40.0);
  EXPECT_GT(leaving.clear, 0.0);
  EXPECT_LE(leaving.clear, 0.6);
  EXPECT_GT(leaving.arrived, 0.0);
}

// Others in the same wall, and one beside it, do not keep it there.
TEST(InsideWalls, a_row_of_robots_leaves) {
  Scenario scene{.allow_broken_assumptions = true};
  scene.obstacles = {polyline({{-10.0, 0.0}, {10.0, 0.0}})};
  for (int k = 0; k < 8; ++k)
    scene.robots.push_back(test::robot_at({1.1 * k - 4.0, 0.48}, {4.0 - 1.1 * k, 6.0}));
  Simulation simulation(scene, 1);
  while (simulation.time() < 2.0) simulation.step();
  for (const Vec2 position : simulation.fleet().position)
    EXPECT_GE(clearance(scene, position), 0.0);
}

}  // namespace
}  // namespace avo
