// SPDX-License-Identifier: Apache-2.0
// `overlapping` says that an assumption is broken, and with which neighbor. It does not say so
// where rounding or a declared error looks like a broken assumption.
#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <span>
#include <vector>

#include "avo/planner.h"
#include "avo/simulation.h"
#include "support/generators.h"

namespace avo {
namespace {

using test::Random;

Plan decide(const Robot& robot, const std::vector<Neighbor>& neighbors,
            const std::vector<Wall>& walls, const PlannerOptions& options = {}) {
  PlanWorkspace workspace;
  return Planner(options).plan(robot, neighbors, workspace, nullptr, walls);
}

SafetyReport state_of(const Robot& robot, const std::vector<Neighbor>& neighbors,
                      const std::vector<Wall>& walls, const PlannerOptions& options = {}) {
  PlanWorkspace workspace;
  return Planner(options).state(robot, neighbors, workspace, walls);
}

// The wall is parallel to the x axis. Its surface is `gap` m above the disc of a robot at rest at
// (5, y).
Wall above(double y, double gap) {
  return {{-20.0, y + 0.5 + gap}, {20.0, y + 0.5 + gap}};
}

float rounded(double value) {
  return static_cast<float>(value);
}

// A base that keeps its state in single precision, as a message of it does.
void move_in_floats(Robot& robot, Vec2 acceleration, double time_step) {
  const auto h = rounded(time_step);
  const auto move = [h](double& place, double& speed, double a) {
    place = rounded(place) + rounded(speed) * h + 0.5F * rounded(a) * h * h;
    speed = rounded(speed) + rounded(a) * h;
    place = rounded(place), speed = rounded(speed);
  };
  move(robot.position.x, robot.velocity.x, acceleration.x);
  move(robot.position.y, robot.velocity.y, acceleration.y);
}

// m, of the nearest wall
double gap_of(const Robot& robot, std::span<const Wall> walls) {
  double least = 1e9;
  for (const Wall& wall : walls) {
    const Vec2 along = wall.b - wall.a, to = robot.position - wall.a;
    const double squared = norm_squared(along);
    const double part = squared > 0.0 ? std::clamp(dot(to, along) / squared, 0.0, 1.0) : 0.0;
    least = std::min(least, norm(to - part * along) - wall.radius - robot.radius);
  }
  return least;
}

// A room of 8 m by 6 m askew, with a wall, a pillar and a thin wall in it.
std::vector<Wall> room() {
  const Vec2 e{std::cos(0.3), std::sin(0.3)};
  const auto place = [&](double x, double y) {
    return Vec2{5.0, 3.0} + x * e + y * perpendicular(e);
  };
  const auto wall = [&](double ax, double ay, double bx, double by, double radius) {
    return Wall{place(ax, ay), place(bx, by), radius};
  };
  return {wall(-4, -3, 4, -3, 0.05), wall(4, -3, 4, 3, 0.05),   wall(4, 3, -4, 3, 0.05),
          wall(-4, 3, -4, -3, 0.05), wall(0, -1, 0, 1.2, 0.05), wall(2, 0, 2, 0, 0.3),
          wall(-2, 1, -1, 1.8, 0.0)};
}

struct OnBoard {
  int decisions = 0, overlapping = 0, touching = 0;
  double least = 1e9;  // m, gap to a wall
};

// Robots on board that are sent to and fro beside walls, by exact sensing or with declared errors.
OnBoard drive_on_board(std::uint64_t seed, double error) {
  constexpr std::size_t kRobots = 4;
  Random random(seed);
  PlannerOptions options;
  options.sensing_error = {error, 2.0 * error};
  const Planner planner(options);
  const std::vector<Wall> walls = room();
  std::array<Robot, kRobots> robots;
  std::array<Detour, kRobots> detours;
  std::array<Vec2, kRobots> goals;
  PlanWorkspace workspace;
  for (std::size_t i = 0; i < kRobots; ++i) {
    robots[i].position = {rounded(2.0 + 1.2 * static_cast<double>(i)), 2.0};
    robots[i].radius = 0.25;
  }
  OnBoard counts;
  for (int step = 0; step < 600; ++step) {
    std::array<Plan, kRobots> plans;
    for (std::size_t i = 0; i < kRobots; ++i) {
      if (step % 40 == 0) goals[i] = {random.uniform(0.0, 10.0), random.uniform(0.0, 7.0)};
      const Vec2 to = goals[i] - robots[i].position;
      const double way = norm(to);
      robots[i].preferred_velocity = way > 1e-9 ? (1.5 * std::min(1.0, way) / way) * to : Vec2{};
      std::vector<Neighbor> seen;
      for (std::size_t k = 0; k < kRobots; ++k) {
        if (k == i) continue;
        const double angle = random.uniform(0.0, 6.28), other = random.uniform(0.0, 6.28);
        const Vec2 p{std::cos(angle), std::sin(angle)}, v{std::cos(other), std::sin(other)};
        seen.push_back({.position = robots[k].position + (0.99 * error) * p,
                        .velocity = robots[k].velocity + (1.98 * error) * v,
                        .radius = 0.25});
      }
      plans[i] = planner.plan(robots[i], seen, workspace, &detours[i], walls);
      const double gap = gap_of(robots[i], walls);
      ++counts.decisions;
      counts.overlapping += plans[i].status == PlanStatus::overlapping ? 1 : 0;
      counts.touching += gap < 0.0 ? 1 : 0;
      counts.least = std::min(counts.least, gap);
      EXPECT_TRUE(plans[i].status == PlanStatus::overlapping ||
                  (plans[i].neighbor == -1 && plans[i].wall == -1 && plans[i].depth == 0.0F));
    }
    for (std::size_t i = 0; i < kRobots; ++i)
      move_in_floats(robots[i], plans[i].acceleration, options.time_step);
  }
  return counts;
}

TEST(Contact, rounding_on_board_breaks_no_assumption) {
  for (const double error : {0.0, 0.02}) {
    int touching = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const OnBoard counts = drive_on_board(seed, error);
      EXPECT_EQ(counts.overlapping, 0) << seed << " of " << counts.decisions;
      EXPECT_GT(counts.least, -8e-6) << seed;
      touching += counts.touching;
    }
    EXPECT_GT(touching, 50) << "the rounding is not felt: nothing is tested";
  }
}

// Each step's rounding leads one that presses against a wall nearer to it; it leaves again.
TEST(Contact, rounding_does_not_add_up_along_a_wall) {
  const Vec2 along{std::cos(0.3), std::sin(0.3)}, away = perpendicular(along);
  const Wall wall{{-5.0, -2.0}, Vec2{-5.0, -2.0} + 400.0 * along};
  const Planner planner(PlannerOptions{});
  PlanWorkspace workspace;
  Detour detour;
  Robot robot;
  robot.position = wall.a + 6.0 * along + 0.6 * away;
  double least = 1e9;
  for (int step = 0; step < 3000; ++step) {
    const double side = step % 400 < 200 ? 1.0 : -1.0;
    robot.preferred_velocity = (1.0 * side) * along - 1.0 * away;
    const Plan plan = planner.plan(robot, {}, workspace, &detour, {&wall, 1});
    ASSERT_NE(plan.status, PlanStatus::overlapping) << step;
    move_in_floats(robot, plan.acceleration, 0.1);
    least = std::min(least, gap_of(robot, {&wall, 1}));
  }
  EXPECT_LT(least, 0.0) << "the rounding is not felt: nothing is tested";
  EXPECT_GT(least, -1.5e-5);
}

TEST(Contact, a_wall_is_named_with_the_depth) {
  const Robot robot{.position = {3.0, 1.0}};
  const std::vector<Wall> walls{above(1.0, 5.0), above(1.0, -1e-3), above(1.0, -1e-4)};
  const Plan plan = decide(robot, {}, walls);
  EXPECT_EQ(plan.status, PlanStatus::overlapping);
  EXPECT_EQ(plan.wall, 1);
  EXPECT_EQ(plan.neighbor, -1);
  EXPECT_NEAR(plan.depth, 1e-3, 1e-9);
  const SafetyReport report = state_of(robot, {}, walls);
  EXPECT_EQ(report.wall, 1);
  EXPECT_NEAR(report.depth, 1e-3, 1e-9);
  EXPECT_EQ(decide(robot, {}, {above(1.0, -1e-7)}).status, PlanStatus::optimal);
  EXPECT_NE(state_of(robot, {}, {above(1.0, -1e-7)}).state, SafetyState::doomed);
}

// It stops 0.1 m too late: 2 m/s, 1 m/s², a second more of braking than there is room.
TEST(Contact, one_that_braking_does_not_avoid_is_named_before_it_comes) {
  const Robot robot{.velocity = {2.0, 0.0}, .preferred_velocity = {2.0, 0.0}};
  const std::vector<Wall> walls{{{9.0, -9.0}, {9.0, 9.0}}, {{2.4, -0.2}, {2.4, 0.2}}};
  const Plan plan = decide(robot, {}, walls);
  EXPECT_EQ(plan.status, PlanStatus::overlapping);
  EXPECT_EQ(plan.wall, 1);
  EXPECT_NEAR(plan.depth, 0.1, 1e-6);
  const SafetyReport report = state_of(robot, {}, walls);
  EXPECT_EQ(report.wall, 1);
  EXPECT_NEAR(report.depth, 0.1, 1e-6);
}

TEST(Contact, a_neighbor_is_named_by_its_place_in_the_list_given) {
  const Robot robot{.position = {10.0, 4.0}};
  const auto at = [](double x, double y) { return Neighbor{.position = {10.0 + x, 4.0 + y}}; };
  const std::vector<Neighbor> seen{at(5.0, 0.0), at(0.0, 0.98), at(-3.0, 0.0), at(0.97, 0.0)};
  for (const Method method : {Method::avo, Method::avo_paper, Method::orca, Method::orca_clamped,
                              Method::velocity_obstacle, Method::buffered_voronoi}) {
    PlannerOptions options = default_options(method);
    const Plan plan = decide(robot, seen, {}, options);
    EXPECT_EQ(plan.status, PlanStatus::overlapping) << to_string(method);
    EXPECT_EQ(plan.neighbor, 3) << to_string(method);
    EXPECT_EQ(plan.wall, -1) << to_string(method);
    EXPECT_NEAR(plan.depth, 0.03, 1e-6) << to_string(method);
  }
  PlanWorkspace workspace;
  const Plan among = Planner(PlannerOptions{}).plan_among_movers(robot, seen, workspace);
  EXPECT_EQ(among.neighbor, 3);
  const SafetyReport report = state_of(robot, seen, {});
  EXPECT_EQ(report.neighbor, 1) << "doomed with both: the first of them";
  EXPECT_NEAR(report.depth, 0.02, 1e-9);
}

// A neighbor that may truly be 2 cm away is not known to be in contact.
TEST(Contact, what_a_declared_error_may_feign_breaks_no_assumption) {
  PlannerOptions options;
  options.sensing_error = {0.02, 0.1};
  const Robot robot{};
  for (const Behavior behavior : {Behavior::decides, Behavior::moves_on}) {
    const auto seen = [behavior](double depth) {
      return std::vector<Neighbor>{{.position = {1.0 - depth, 0.0}, .behavior = behavior}};
    };
    EXPECT_NE(decide(robot, seen(0.019), {}, options).status, PlanStatus::overlapping);
    EXPECT_EQ(state_of(robot, seen(0.019), {}, options).neighbor, -1);
    const Plan plan = decide(robot, seen(0.05), {}, options);
    EXPECT_EQ(plan.status, PlanStatus::overlapping);
    EXPECT_EQ(plan.neighbor, 0);
    EXPECT_NEAR(plan.depth, 0.03, 1e-6);
  }
  Neighbor aged{.position = {0.95, 0.0}};
  aged.position_error = 0.04;
  EXPECT_NE(decide(robot, {aged}, {}, options).status, PlanStatus::overlapping);
}

TEST(Contact, a_simulation_tells_the_depth_alone) {
  Scenario scene{.allow_broken_assumptions = true};
  scene.robots = {{.position = {0.0, 0.0}, .goal = {5.0, 0.0}},
                  {.position = {0.9, 0.0}, .goal = {-5.0, 0.0}}};
  Simulation simulation(scene, 1);
  simulation.step();
  for (const Plan& plan : simulation.fleet().plan) {
    EXPECT_EQ(plan.status, PlanStatus::overlapping);
    EXPECT_EQ(plan.neighbor, -1);
    EXPECT_NEAR(plan.depth, 0.1, 1e-6);
  }
  const auto seen = Simulation(scene, 1).perceive({1});
  PlanWorkspace workspace;
  const Plan plan = simulation.planner().plan(seen.robot, seen.neighbors, workspace);
  EXPECT_EQ(seen.source[static_cast<std::size_t>(plan.neighbor)], 0);
}

}  // namespace
}  // namespace avo
