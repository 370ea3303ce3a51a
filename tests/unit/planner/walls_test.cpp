// SPDX-License-Identifier: Apache-2.0
// What walls make of the target of the first program.
#include "support/walls.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "planner/stages/demands.h"

namespace avo {
namespace {

using test::law_of;
using test::options_of;
using test::Random;

PlannerOptions options_with(Certificate certificate) {
  return options_of(certificate, Motion::held, 0.1, 2.0);
}

TEST(SpeedPlanes, the_speed_is_the_largest_that_stops_in_the_gap) {
  for (const Motion motion : {Motion::held, Motion::exponential}) {
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
      Random random(seed);
      const StepLaw law =
          law_of(test::random_options(random, Certificate::braking_trajectories, motion)).step;
      const double a = random.log_uniform(0.1, 10.0), gap = random.log_uniform(1e-6, 20.0);
      const double speed = speed_before(gap, a, law);
      const double way =
          law.time_step * speed + stopping_length(speed, braking_decrement(a, law), law);
      EXPECT_NEAR(way, gap, 1e-12 + 1e-9 * gap);
    }
  }
  EXPECT_EQ(speed_before(0.0, 1.0, {}), 0.0);
  EXPECT_EQ(speed_before(-1.0, 1.0, {}), 0.0);
}

// The robot is 1 m before the wall x = 1.5, and its preferred velocity leads through the wall.
Robot before_the_wall() {
  Robot robot;
  robot.preferred_velocity = {2.0, 0.0};
  return robot;
}
const Wall kWall{{1.5, -9.0}, {1.5, 9.0}};
const Wall kThickWall{{1.9, -9.0}, {1.9, 9.0}, 0.4};  // its surface is the same

// The robot drives straight at the wall: on a detour a target may turn a robot while it slows down.
void drive_straight_at(const Wall& wall) {
  PlanWorkspace workspace;
  for (const Certificate certificate : {Certificate::none, Certificate::braking_trajectories}) {
    PlannerOptions options = options_with(certificate);
    options.response_time = 0.0;  // targets are reached at once
    const Planner planner(options);
    const StepLaw law = law_of(planner.options()).step;
    Robot robot = before_the_wall();
    int too_fast = 0, braking = 0;
    for (int k = 0; k < 80; ++k) {
      const Plan plan = planner.plan(robot, {}, workspace, nullptr, {&wall, 1});
      const double speed = speed_before(1.0 - robot.position.x, robot.max_acceleration, law);
      too_fast += plan.next_velocity.x > speed + 1e-9 ? 1 : 0;
      braking += plan.status == PlanStatus::braking ? 1 : 0;
      robot.position = robot.position + 0.05 * (robot.velocity + plan.next_velocity);
      robot.velocity = plan.next_velocity;
    }
    EXPECT_EQ(too_fast, 0);
    EXPECT_EQ(braking, 0);
    EXPECT_GT(robot.position.x, 0.9);
    // the planes reckon with a step at V; one that slows down is longer by s u
    const double beyond = certificate == Certificate::none ? law.lag * 0.1 + 1e-9 : 0.0;
    EXPECT_LT(robot.position.x, 1.0 + beyond);
  }
}

TEST(SpeedPlanes, a_target_drives_at_no_wall_faster_than_braking_stops) {
  for (const Wall& wall : {kWall, kThickWall}) drive_straight_at(wall);
}

// Another one comes from behind so fast that its half-plane cannot be kept together with the
// wall's.
TEST(SpeedPlanes, the_half_planes_of_neighbors_yield_first) {
  const Planner planner(options_with(Certificate::none));
  const StepLaw law = law_of(planner.options()).step;
  Robot robot = before_the_wall();
  robot.position.x = 0.95;
  robot.preferred_velocity = {};
  const Neighbor other{{-0.1, 0.0}, {2.0, 0.0}};
  PlanWorkspace workspace;
  const Plan pushed = planner.plan(robot, {&other, 1}, workspace);
  const double speed = speed_before(0.05, robot.max_acceleration, law);
  EXPECT_GT(std::abs(pushed.new_velocity.x) + std::abs(pushed.new_velocity.y), 2.0 * speed);
  const Wall box[] = {kWall, {{1.5, 0.55}, {0.0, 0.55}}, {{1.5, -0.55}, {0.0, -0.55}}};
  const Plan plan = planner.plan(robot, {&other, 1}, workspace, nullptr, box);
  EXPECT_EQ(plan.status, PlanStatus::least_unsafe);
  EXPECT_GT(plan.violation, 0.0);
  EXPECT_LE(plan.new_velocity.x * planner.step_rate(), speed + 1e-9);
}

// A robot nearly in contact with one behind it is pushed on in the open, and where it has all but
// arrived. It is not pushed on beside a wall on its route.
TEST(PushAmongWalls, who_is_on_its_way_beside_a_wall_is_not_pushed) {
  PlannerOptions options = options_with(Certificate::braking_trajectories);
  options.response_time = 0.0;
  const Planner planner(options);
  Robot robot;
  robot.position = {0.0, 0.6};
  robot.preferred_velocity = {0.05, 0.0};
  robot.distance_to_goal = 50.0;
  const Neighbor behind{{-1.05, 0.6}, {-0.2, 0.0}};
  const auto speed = [&](const std::vector<Wall>& walls) {
    PlanWorkspace workspace;
    Detour detour;
    return norm(planner.plan(robot, {&behind, 1}, workspace, &detour, walls).next_velocity);
  };
  EXPECT_GT(speed({}), 0.09);
  EXPECT_GT(speed({{{-9.0, -4.0}, {9.0, -4.0}}}), 0.09) << "out of reach";
  EXPECT_NEAR(speed({{{-9.0, 0.0}, {9.0, 0.0}}}), 0.05, 1e-9);
  robot.distance_to_goal = 0.1;
  EXPECT_GT(speed({{{-9.0, 0.0}, {9.0, 0.0}}}), 0.09);
}

// A robot that is blocked in every direction turns off as far as may be. Beside a wall it then
// tries its own direction again.
TEST(DetourAmongWalls, begins_anew_where_all_is_blocked) {
  const Planner planner(options_with(Certificate::braking_trajectories));
  Robot robot;
  robot.position = {0.0, 0.51};
  robot.preferred_velocity = {1.5, 0.0};
  const std::vector<Neighbor> ring = [&] {
    std::vector<Neighbor> around;
    for (const Vec2 side :
         {Vec2{1.0, 0.0}, {0.5, 0.87}, {-0.5, 0.87}, {-1.0, 0.0}, {-0.5, -0.87}, {0.5, -0.87}})
      around.push_back({robot.position + 1.001 * side, {}});
    return around;
  }();
  const auto angles = [&](const std::vector<Wall>& walls) {
    PlanWorkspace workspace;
    Detour detour;
    std::vector<double> after;
    for (int step = 0; step < 60; ++step) {
      const Plan plan = planner.plan(robot, ring, workspace, &detour, walls);
      EXPECT_LT(norm(plan.next_velocity), 0.03);
      after.push_back(detour.angle);
    }
    return after;
  };
  const std::vector<double> in_the_open = angles({});
  EXPECT_TRUE(std::is_sorted(in_the_open.begin(), in_the_open.end()));
  EXPECT_FLOAT_EQ(static_cast<float>(in_the_open.back()), 2.4F);
  const std::vector<double> beside_a_wall = angles({{{-9.0, 0.0}, {9.0, 0.0}}});
  EXPECT_EQ(*std::max_element(beside_a_wall.begin(), beside_a_wall.end()), in_the_open.back());
  EXPECT_LT(beside_a_wall.back(), 1.0);
}

// A neighbor on the other side of a wall demands nothing of either, and is not listed.
TEST(HiddenNeighbors, are_not_listed_either) {
  const Planner planner(options_with(Certificate::braking_trajectories));
  Robot robot = before_the_wall();
  robot.velocity = {0.9, 0.0};
  const Neighbor others[] = {{{2.01, 0.0}, {-0.9, 0.0}}, {{0.0, 1.02}, {0.0, -0.1}}};
  PlanWorkspace workspace;
  HalfPlanes half_planes;
  std::vector<CertificateConstraint> constraints;
  const auto count = [&](std::span<const Wall> walls, int neighbor) {
    planner.collect_half_planes(robot, others, workspace, half_planes, walls);
    planner.collect_certificate(robot, others, workspace, constraints, walls);
    return std::pair(
        std::count_if(half_planes.planes.begin(), half_planes.planes.end(),
                      [&](const NeighborPlane& plane) { return plane.neighbor == neighbor; }),
        std::count_if(constraints.begin(), constraints.end(),
                      [&](const auto& constraint) { return constraint.neighbor == neighbor; }));
  };
  for (const int neighbor : {0, 1}) {
    EXPECT_GT(count({}, neighbor).first, 0);
    EXPECT_GT(count({}, neighbor).second, 0);
  }
  const Wall between[] = {{{1.0, -9.0}, {1.0, 9.0}}};
  const std::span<const Wall> walls = between;
  EXPECT_EQ(count(walls, 0).first, 0);
  EXPECT_EQ(count(walls, 0).second, 0);
  EXPECT_GT(count(walls, 1).first, 0);
  EXPECT_GT(count(walls, 1).second, 0);
}

}  // namespace
}  // namespace avo
