// SPDX-License-Identifier: Apache-2.0
// What the methods without a certificate make of walls: half-planes of the walls' obstacles.
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "planner/stages/demands.h"
#include "support/walls.h"

namespace avo {
namespace {

using test::Random;

constexpr Method kMethods[] = {Method::avo_paper, Method::orca, Method::velocity_obstacle,
                               Method::orca_clamped, Method::reciprocal_velocity_obstacle};

PlannerOptions options_of(Method method) {
  PlannerOptions options = default_options(method);
  options.certificate = Certificate::none;
  return options;
}

// The robot's own half-plane, and that of a mover of the same size that stands where it is.
TEST(WallObstacles, a_disc_is_a_mover_that_stands) {
  Random random(1);
  PlanWorkspace workspace;
  int compared = 0;
  for (int k = 0; k < 2000; ++k) {
    for (const Method method : {Method::avo_paper, Method::orca}) {
      const Planner planner(options_of(method));
      Robot robot;
      robot.velocity = test::in_disc(random, 2.0);
      const Vec2 place = random.uniform(0.8, 12.0) * random.direction();
      const double radius = random.uniform(0.01, 2.0);
      Neighbor mover{place, {}, radius};
      mover.behavior = Behavior::moves_on;
      const Wall disc{place, place, radius};
      HalfPlanes of_mover;
      WallPlanes of_wall;
      planner.collect_half_planes(robot, {&mover, 1}, workspace, of_mover);
      planner.collect_half_planes(robot, {&disc, 1}, of_wall);
      EXPECT_TRUE(of_wall.speeds.empty());
      EXPECT_EQ(of_wall.overlapping, of_mover.overlapping);
      if (of_wall.obstacles.empty()) continue;  // beyond what its speed allows
      ASSERT_EQ(of_mover.planes.size(), 1U);
      ++compared;
      EXPECT_EQ(of_wall.obstacles[0].plane.normal, of_mover.planes[0].plane.normal);
      EXPECT_EQ(of_wall.obstacles[0].plane.offset, of_mover.planes[0].plane.offset);
      EXPECT_EQ(of_wall.obstacles[0].excess, of_mover.planes[0].excess);
    }
  }
  EXPECT_GT(compared, 1000);
}

// A robot alone in a square of walls, with another wish every 2 s, always towards some wall. The
// half-planes of walls of orca all allow to stop. Those of avo_paper promise nothing.
TEST(WallObstacles, a_robot_alone_stays_in_its_room) {
  const std::vector<Wall> room{{{-6, -4}, {6, -4}},      {{6, 4}, {6, -4}}, {{6, 4}, {-6, 4}},
                               {{-6, 4}, {-6, -4}, 0.2}, {{0, -1}, {0, 2}}, {{3, 1}, {3, 1}, 0.4}};
  PlanWorkspace workspace;
  for (const Method method : kMethods) {
    const Planner planner(options_of(method));
    Random random(9);
    Robot robot;
    robot.position = {-3.0, 0.0};
    double least = 1e300, way = 0.0;
    for (int k = 0; k < 4000; ++k) {
      if (k % 20 == 0) robot.preferred_velocity = 1.9 * random.direction();
      const Plan plan = planner.plan(robot, {}, workspace, nullptr, room);
      const test::TrueStep step{robot.position, robot.velocity, plan.next_velocity};
      least = std::min(least, test::least_gap(step, room, planner.options()) - robot.radius);
      robot.position = step.at(planner.options().time_step, planner.options());
      robot.velocity = plan.next_velocity;
      way += 0.1 * norm(robot.velocity);
    }
    EXPECT_GT(least, -1e-9) << to_string(method);
    EXPECT_LT(least, 0.05) << to_string(method) << ": it came near no wall";
    EXPECT_GT(way, 60.0) << to_string(method);
  }
}

TEST(WallObstacles, walls_out_of_reach_change_no_bit) {
  PlanWorkspace workspace;
  for (const Method method : kMethods) {
    const Planner planner(options_of(method));
    const double far = 0.5 + 1e-6 + 2.0 * planner.options().time_horizon;
    Robot robot;
    robot.velocity = {1.0, 0.2}, robot.preferred_velocity = {1.9, 0.0};
    const Wall beyond[] = {{{far, -9.0}, {far, 9.0}}, {{-far, 0.0}, {-far, 0.0}}};
    const Wall within[] = {{{4.0, -9.0}, {4.0, 9.0}}};
    const Plan alone = planner.plan(robot, {}, workspace);
    const Plan away = planner.plan(robot, {}, workspace, nullptr, beyond);
    const Plan near = planner.plan(robot, {}, workspace, nullptr, within);
    EXPECT_EQ(away.new_velocity, alone.new_velocity) << to_string(method);
    bool overlapping = false;
    for (const Wall& wall : beyond) {
      EXPECT_FALSE(
          obstacle_plane(planner.options(), planner.horizon(), robot, wall, 0, overlapping))
          << to_string(method) << ": whatever else its hull would cut";
    }
    EXPECT_NE(near.new_velocity, alone.new_velocity) << to_string(method);
  }
}

TEST(WallObstacles, whoever_touches_a_wall_is_told_and_parts) {
  PlanWorkspace workspace;
  for (const Method method : kMethods) {
    const Planner planner(options_of(method));
    for (const double x : {0.3, 0.0}) {  // the center beside the wall, and on it
      Robot robot;
      robot.position = {x, 0.0}, robot.velocity = {0.1, 0.0}, robot.preferred_velocity = {-1, 0};
      const Wall wall{{0.0, -3.0}, {0.0, 3.0}};
      const Plan plan = planner.plan(robot, {}, workspace, nullptr, {&wall, 1});
      EXPECT_EQ(plan.status, PlanStatus::overlapping) << to_string(method);
      EXPECT_GT(plan.new_velocity.x, 0.1) << to_string(method);
    }
  }
}

// The one in front and the one behind want more room than there is between two walls.
TEST(WallObstacles, the_half_planes_of_neighbors_yield_first) {
  PlanWorkspace workspace;
  for (const Method method : {Method::avo_paper, Method::orca}) {
    const Planner planner(options_of(method));
    Robot robot;
    robot.preferred_velocity = {1.0, 0.0};
    const Neighbor others[] = {{{0.0, 1.05}, {0.0, -2.0}}, {{-1.05, 0.0}, {2.0, 0.0}}};
    const Wall walls[] = {{{-9.0, -0.52}, {9.0, -0.52}}, {{0.52, -0.52}, {0.52, 9.0}}};
    const Plan pushed = planner.plan(robot, others, workspace);
    const Plan plan = planner.plan(robot, others, workspace, nullptr, walls);
    EXPECT_EQ(plan.status, PlanStatus::least_unsafe) << to_string(method);
    EXPECT_GT(plan.violation, 0.0);
    WallPlanes planes;
    planner.collect_half_planes(robot, walls, planes);
    ASSERT_EQ(planes.obstacles.size(), 2U);
    double missed = 0.0;
    for (const WallPlane& wall : planes.obstacles) {
      EXPECT_LE(violation(wall.plane, plan.new_velocity), 1e-9) << to_string(method);
      missed = std::max(missed, violation(wall.plane, pushed.new_velocity));
    }
    EXPECT_GT(missed, 0.1) << to_string(method);
  }
}

// Among movers as well, where the union of their obstacles is avoided.
TEST(WallObstacles, a_robot_among_movers_keeps_to_them) {
  const Planner planner(options_of(Method::avo_paper));
  PlanWorkspace workspace;
  Robot robot;
  robot.velocity = {1.0, 0.0}, robot.preferred_velocity = {1.9, 0.0};
  Neighbor mover{{6.0, 0.3}, {-1.0, 0.0}};
  mover.behavior = Behavior::moves_on;
  const Wall wall{{-9.0, -0.7}, {20.0, -0.7}};  // where it would pass the mover
  const Plan without = planner.plan(robot, {&mover, 1}, workspace);
  const Plan plan = planner.plan(robot, {&mover, 1}, workspace, nullptr, {&wall, 1});
  WallPlanes planes;
  planner.collect_half_planes(robot, {&wall, 1}, planes);
  ASSERT_EQ(planes.obstacles.size(), 1U);
  EXPECT_GT(violation(planes.obstacles[0].plane, without.new_velocity), 0.01);
  EXPECT_LE(violation(planes.obstacles[0].plane, plan.new_velocity), 1e-9);
  EXPECT_EQ(plan.status, PlanStatus::optimal);
}

}  // namespace
}  // namespace avo
