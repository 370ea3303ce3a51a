// SPDX-License-Identifier: Apache-2.0
// Gentle execution of method avo's choices (docs/smoothness.md): gain, ease, use, and need.
#include "planner/stages/execution.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "avo/planner.h"
#include "avo/simulation.h"
#include "planner/decision_columns.h"
#include "planner/rules/wishes.h"
#include "planner/tile.h"
#include "support/generators.h"

namespace avo {
namespace {

constexpr double kNone = kUnlimited;

Execution usual(double time_step = 0.1) {
  return execution_of(Planner({.time_step = time_step}), true);
}

TEST(Execution, has_a_time_constant_of_v_max_over_a_max_that_decisions_can_follow) {
  const Robot robot;  // v_max 2 m/s, a_max 1 m/s²: 0.1 T is 0.2 s
  EXPECT_DOUBLE_EQ(haste_of(robot, usual(0.1)).gain, 0.5);
  EXPECT_DOUBLE_EQ(haste_of(robot, usual(0.01)).gain, 0.05);
  EXPECT_DOUBLE_EQ(haste_of(robot, usual(0.2)).gain, 0.5) << "2 Δt at least";
  const Robot slow{.max_acceleration = 0.25};
  EXPECT_DOUBLE_EQ(haste_of(slow, usual(0.1)).gain, 0.125);
  const Planner at_once({.response_time = 0.0});
  EXPECT_EQ(haste_of(robot, execution_of(at_once, true)).gain, 1.0);
  EXPECT_GT(haste_of(robot, execution_of(at_once, true)).jerk, 1e300);
}

TEST(Execution, uses_no_more_than_is_comfortable_or_of_use) {
  const Robot robot, strong{.max_acceleration = 50.0};  // r 0.5 m
  EXPECT_DOUBLE_EQ(haste_of(robot, usual()).most, 0.1);
  EXPECT_DOUBLE_EQ(haste_of(strong, usual()).most, 0.4) << "its speed within five steps";
  const Planner gentle({.comfort_acceleration = 0.4, .comfort_jerk = 0.5});
  EXPECT_DOUBLE_EQ(haste_of(robot, execution_of(gentle, true)).most, 0.04);
  EXPECT_DOUBLE_EQ(haste_of(robot, execution_of(gentle, true)).jerk, 0.5 * 0.1 * 0.1);
  EXPECT_EQ(haste_of(robot, execution_of(gentle, false)).jerk, kNone) << "last one unknown";
}

// From 0 to all in 0.8 T_e, from all forward to all backward in twice that.
TEST(Execution, changes_the_acceleration_by_and_by) {
  const Haste haste = haste_of(Robot{}, usual(0.01));  // T_e 0.2 s
  Vec2 last, v;
  int steps = 0;
  for (; norm(last) < (1.0 - 1e-9) * haste.most; ++steps) {
    const Vec2 next = executed(v, last, {2.0, 0.0}, haste);
    EXPECT_LE(norm(next - v - last), haste.jerk * (1.0 + 1e-12));
    last = next - v, v = next;
  }
  EXPECT_EQ(steps, 16);
  steps = 0;
  for (; last.x > -(1.0 - 1e-9) * haste.most; ++steps) {
    const Vec2 next = executed(v, last, {-2.0, 0.0}, haste);
    last = next - v, v = next;
  }
  EXPECT_EQ(steps, 32);
}

TEST(Execution, makes_up_for_a_part_of_what_is_missing) {
  const Haste haste{0.25, 0.1, kNone};
  const Vec2 near = executed({1.0, 0.0}, {}, {1.2, -0.1}, haste);
  EXPECT_DOUBLE_EQ(near.x, 1.05);
  EXPECT_DOUBLE_EQ(near.y, -0.025);
  EXPECT_EQ(executed({1.0, 0.0}, {}, {9.0, 0.0}, haste), (Vec2{1.1, 0.0}));
  EXPECT_EQ(executed({1.0, 0.0}, {0.1, 0.0}, {1.03, 0.02}, {1.0, 0.1, kNone}), (Vec2{1.03, 0.02}))
      << "at once: to the bit";
}

// T_w is 0.4 s: alone a robot makes up for a quarter of what is missing in a step of 0.1 s, and
// for the half of what a half-plane asks. comfort_jerk, which makes T_e longer, leaves T_w.
TEST(Execution, approaches_a_wish_more_slowly_than_what_half_planes_ask) {
  const Robot robot;
  EXPECT_DOUBLE_EQ(unhurried_part(robot, usual()), 0.5);
  EXPECT_DOUBLE_EQ(unhurried_part(robot, execution_of(Planner({.comfort_jerk = 5.0}), true)), 0.625)
      << "T_e 0.25 s";
  EXPECT_EQ(unhurried_part(robot, execution_of(Planner({.comfort_jerk = 0.5}), true)), 1.0);
  EXPECT_EQ(unhurried_part(robot, execution_of(Planner({.response_time = 0.0}), true)), 1.0);

  const Planner planner({});
  PlanWorkspace workspace;
  Robot self{.velocity = {1.0, 0.0}, .preferred_velocity = {1.1, 0.0}};
  EXPECT_NEAR(planner.plan(self, {}, workspace).acceleration.x, 0.25, 1e-9);
  // two that meet: the half-plane asks for a little to the side, and the wish for next to nothing
  self.preferred_velocity = self.velocity;
  const Neighbor oncoming{.position = {6.0, 0.95}, .velocity = {-1.0, 0.0}};
  const Vec2 at_once =
      Planner({.response_time = 0.0}).plan(self, {&oncoming, 1}, workspace).acceleration;
  const Vec2 gently = planner.plan(self, {&oncoming, 1}, workspace).acceleration;
  ASSERT_GT(norm(at_once), 0.1);
  ASSERT_LT(norm(at_once), 0.99);
  EXPECT_NEAR(norm(gently) / norm(at_once), 0.5, 0.1);
}

// What the certificate refuses is replaced at once: a robot that appears right ahead is braked for
// with all of a_max, whatever the last acceleration and comfort are.
TEST(Execution, gives_way_to_the_certificate) {
  const Planner planner({.comfort_acceleration = 0.2, .comfort_jerk = 0.2});
  PlanWorkspace workspace;
  const Robot self{.velocity = {1.0, 0.0}, .preferred_velocity = {1.5, 0.0}};
  const Neighbor ahead{.position = {1.5, 0.0}};  // the robot stops within 0.5 m
  Detour detour{.acceleration_x = 0.2F};
  const Plan plan = planner.plan(self, {&ahead, 1}, workspace, &detour);
  EXPECT_NEAR(plan.acceleration.x, -1.0, 1e-6);
  EXPECT_FLOAT_EQ(detour.acceleration_x, static_cast<float>(plan.acceleration.x));
  Detour calm{.acceleration_x = 0.2F};
  const Plan free = planner.plan(self, {}, workspace, &calm);
  EXPECT_GT(free.acceleration.x, 0.15);
  EXPECT_LE(free.acceleration.x, 0.2 + 1e-12);
}

// Without a Detour the last acceleration is unknown, and does not count.
TEST(Execution, remembers_in_the_detour_alone) {
  const Planner planner({.time_step = 0.01});
  PlanWorkspace workspace;
  const Robot self{.preferred_velocity = {2.0, 0.0}};
  EXPECT_NEAR(planner.plan(self, {}, workspace).acceleration.x, 1.0, 1e-9);
  Detour detour;
  double last = 0.0;
  for (int k = 0; k < 5; ++k) {
    const double a = planner.plan(self, {}, workspace, &detour).acceleration.x;
    EXPECT_NEAR(a - last, 0.01 / 0.16, 1e-6);
    last = a;
  }
}

// A robot that decides among moving obstacles alone has an acceleration as well. So has a robot
// that is given what no decision can be made from.
TEST(Execution, remembers_every_decision) {
  const Planner planner({});
  PlanWorkspace workspace;
  const Robot self{.velocity = {1.0, 0.0}, .preferred_velocity = {0.0, 1.0}};
  const Neighbor mover{.position = {0.0, 9.0}, .behavior = Behavior::moves_on};
  Detour detour;
  const Plan beside = planner.plan(self, {&mover, 1}, workspace, &detour);
  EXPECT_GT(norm(beside.acceleration), 0.5);
  EXPECT_FLOAT_EQ(detour.acceleration_y, static_cast<float>(beside.acceleration.y));
  Neighbor nowhere = mover;
  nowhere.position.x = std::nan("");
  const Plan blind = planner.plan(self, {&nowhere, 1}, workspace, &detour);
  EXPECT_EQ(blind.status, PlanStatus::invalid_input);
  EXPECT_FLOAT_EQ(detour.acceleration_x, static_cast<float>(blind.acceleration.x));
  EXPECT_FLOAT_EQ(detour.acceleration_y, static_cast<float>(blind.acceleration.y));
}

// Where robots decide about each other, and at once among movers alone.
TEST(Execution, of_decisions_among_obstacles) {
  const Planner planner({.time_step = 0.01});
  PlanWorkspace workspace;
  const Robot self{.velocity = {1.0, 0.0}, .preferred_velocity = {1.1, 0.0}};
  Neighbor other{.position = {0.0, 9.0}};
  EXPECT_NEAR(planner.plan_among_movers(self, {&other, 1}, workspace).acceleration.x, 0.5, 1e-9)
      << "0.1 m/s in 0.2 s";
  other.behavior = Behavior::moves_on;
  EXPECT_NEAR(planner.plan_among_movers(self, {&other, 1}, workspace).acceleration.x, 1.0, 1e-9);
}

// What a robot that moves at 1 m/s aims at, of a wish for 2 m/s across. Before it in the tile is
// one that senses a mover.
Vec2 aim_of(Robot robot, const std::vector<Neighbor>& neighbors, bool maneuvers = false,
            const PlannerOptions& options = {}) {
  robot.velocity = {1.0, 0.0}, robot.preferred_velocity = {0.0, 2.0};
  Tile tile;
  Detour detours[2];
  DecisionColumns decisions;
  tile.robots.reserve(2), tile.neighbors.reserve(neighbors.size() + 1), decisions.reserve(2);
  tile.neighbors.add({.position = {0.0, 30.0}, .behavior = Behavior::moves_on});
  for (const Neighbor& neighbor : neighbors) tile.neighbors.add(neighbor);
  tile.robots.add({.distance_to_goal = 50.0}, {&tile.neighbors, 0, 1});
  tile.robots.add(robot, {&tile.neighbors, 1, neighbors.size()});
  for (Detour& detour : detours) tile.detour.push_back(&detour);
  tile.maneuvers = {0, static_cast<std::uint8_t>(maneuvers)};
  decisions.wish_x[1] = robot.preferred_velocity.x;
  decisions.wish_y[1] = robot.preferred_velocity.y;
  const Planner planner(options);
  make_aims(planner, execution_of(planner, true), tile, decisions);
  return decisions.aim(1);
}

// Among movers, on wheels near the goal, and with priority there is a hurry.
TEST(Execution, aims_half_of_the_way_to_a_wish_that_can_wait) {
  const Vec2 half{0.5, 1.0}, all{0.0, 2.0};
  Robot robot{.distance_to_goal = 50.0};
  Neighbor other{.position = {0.0, 2.0}}, mover{.position = {0.0, 5.0}};
  mover.behavior = Behavior::moves_on;
  EXPECT_EQ(aim_of(robot, {}), half);
  EXPECT_EQ(aim_of(robot, {other}), half);
  EXPECT_EQ(aim_of(robot, {other, mover}), all);
  // A moving obstacle that the robot could not touch within 4 τ, 12 s, at its 2 m/s does not
  // matter.
  mover.position.y = 24.99, mover.radius = 0.5;
  EXPECT_EQ(aim_of(robot, {mover}), all);
  mover.position.y = 25.01;
  EXPECT_EQ(aim_of(robot, {mover}), half);
  mover.velocity = {0.0, -1.0};
  EXPECT_EQ(aim_of(robot, {mover}), all);
  EXPECT_EQ(aim_of(robot, {other, mover}, false, {.max_neighbors = 1}), half) << "no half-plane";
  mover.behavior = Behavior::cooperates;
  EXPECT_EQ(aim_of(robot, {mover, other}), all);
  const MotionModel car = Car{}, drive = DifferentialDrive{}, airplane = Airplane{};
  for (const MotionModel& model : {car, drive}) {
    robot.model = model;
    EXPECT_EQ(aim_of(robot, {}), half);
    EXPECT_EQ(aim_of(robot, {mover}), all);
    EXPECT_EQ(aim_of(robot, {}, true), all) << "maneuvers";
    robot.distance_to_goal = 9.9;  // radius 0.5: the robot is on the last of its route
    EXPECT_EQ(aim_of(robot, {}), all);
    robot.distance_to_goal = 50.0;
  }
  robot.model = airplane;
  EXPECT_EQ(aim_of(robot, {}), all);
  robot.model = Holonomic{}, robot.distance_to_goal = 9.9;
  EXPECT_EQ(aim_of(robot, {}), half);
}

// Among others of less: alone and among equals priorities change nothing.
TEST(Execution, aims_farther_with_more_priority_than_all_others) {
  Robot robot{.distance_to_goal = 50.0, .priority = 3.0};
  Neighbor low{.position = {0.0, 2.0}, .priority = 0.5}, high{.position = {0.0, 5.0}};
  EXPECT_EQ(aim_of(robot, {}).y, 1.0);
  for (const auto& [priority, part] : {std::pair{9.0, 0.5}, {3.0, 0.5}, {2.0, 0.75}, {1.0, 1.0}}) {
    high.priority = priority;
    EXPECT_NEAR(aim_of(robot, {low, high}).y, 2.0 * part, 1e-15) << priority;
    EXPECT_NEAR(aim_of(robot, {high, low}).y, 2.0 * part, 1e-15) << priority;
  }
  high.position.y = 50.0;
  EXPECT_EQ(aim_of(robot, {low, high}).y, 2.0) << "3 in place of 0.5";
  robot.priority = 1e9;
  EXPECT_EQ(aim_of(robot, {low}).y, 2.0);
}

// Where T_e is no longer than a step, v' is adopted at once, far from the goal as well.
TEST(Execution, aims_at_the_wish_where_a_step_leads_there) {
  const PlannerOptions options{.control_time = 0.1, .time_step = 0.1};
  for (const double distance : {9.9, 50.0, 5000.0})
    EXPECT_EQ(aim_of({.distance_to_goal = distance}, {}, false, options), Vec2(0.0, 2.0));
}

// The shortcut that most robots take leaves out no robot that comes to rest.
TEST(Landing, is_noticed_of_whomever_is_near_its_goal) {
  test::Random random(33);
  int landing = 0, on_the_way = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    PlannerOptions options{.response_time = random.log_uniform(0.01, 1.0),
                           .time_step = random.log_uniform(0.005, 0.5)};
    if (trial % 3 == 0) options.comfort_acceleration = random.log_uniform(0.01, 10.0);
    if (trial % 5 == 0) options.comfort_jerk = random.log_uniform(0.1, 10.0);
    Robot robot{.preferred_velocity = random.direction(),
                .radius = random.log_uniform(0.05, 2.0),
                .max_acceleration = random.log_uniform(0.05, 50.0),
                .max_speed = random.log_uniform(0.1, 30.0),
                .distance_to_goal = random.log_uniform(0.01, 500.0)};
    if (trial % 2 == 0) robot.max_braking = random.log_uniform(0.05, 50.0);
    const Planner planner(options);
    const Execution execution = execution_of(planner, true);
    Tile tile;
    Detour detour;
    DecisionColumns decisions;
    tile.robots.reserve(1), decisions.reserve(1);
    tile.robots.add(robot, {});
    tile.detour.push_back(&detour);
    decisions.wish_x[0] = robot.preferred_velocity.x;
    decisions.wish_y[0] = robot.preferred_velocity.y;
    make_aims(planner, execution, tile, decisions);
    const bool lands = is_landing(robot, haste_of(robot, execution), execution);
    ++(lands ? landing : on_the_way);
    // at rest: what leads to the wish in one step, or a part of the wish
    const double part =
        lands ? 1.0 / haste_of(robot, execution).gain : unhurried_part(robot, execution);
    ASSERT_NEAR(norm(decisions.aim(0) - part * decisions.wish(0)), 0.0, 1e-12 * part) << trial;
  }
  EXPECT_GT(landing, 3000);
  EXPECT_GT(on_the_way, 3000);
}

struct Landing {
  double overshoot = 0.0;  // m
  double jerk = 0.0;       // m/s³, largest change of the acceleration while it brakes
  double rests = -1.0;     // s
};

// One robot alone, 10 m along x.
Landing land(double time_step, double max_acceleration, std::optional<double> max_braking) {
  Scenario scenario;
  scenario.time_step = time_step;
  RobotSetup robot;
  robot.goal = {10.0, 0.0};
  robot.preferred_speed = robot.max_speed = 2.0;
  robot.max_acceleration = max_acceleration, robot.max_braking = max_braking;
  scenario.robots.push_back(robot);
  Simulation simulation(scenario);
  Landing landing;
  double v = 0.0, a = 0.0;
  for (int k = 0; k < 30.0 / time_step && landing.rests < 0.0; ++k) {
    simulation.step();
    const FleetView now = simulation.fleet();
    const double next = (now.velocity[0].x - v) / time_step;
    landing.overshoot = std::max(landing.overshoot, now.position[0].x - 10.0);
    if (now.position[0].x > 5.0)
      landing.jerk = std::max(landing.jerk, std::abs(next - a) / time_step);
    v = now.velocity[0].x, a = next;
    if (k > 5 && now.velocity[0] == Vec2{}) landing.rests = simulation.time();
  }
  return landing;
}

TEST(Landing, is_soft_and_exact_at_any_time_step) {
  for (const double time_step : {0.01, 0.02, 0.05, 0.1, 0.2}) {
    SCOPED_TRACE(time_step);
    const Landing landing = land(time_step, 1.0, std::nullopt);
    EXPECT_GT(landing.rests, 7.0);
    EXPECT_LT(landing.rests, 8.6) << "7 s, and what it takes to brake without a jolt";
    EXPECT_LE(landing.overshoot, 1e-12);
    // after short steps it still approaches its speed, and that ends at once
    const double most = time_step < 0.02 ? 1.35 : 1.25;
    EXPECT_LE(landing.jerk, most / (0.8 * std::max(0.2, 2.0 * time_step)));
  }
}

TEST(Landing, does_not_overshoot_with_other_brakes) {
  for (const double a : {0.3, 1.0, 3.0, 8.0}) {
    for (const double part : {0.3, 1.0, 2.5}) {
      SCOPED_TRACE(testing::Message() << a << " " << part);
      const Landing landing = land(0.05, a, part * a);
      EXPECT_GT(landing.rests, 0.0);
      EXPECT_LE(landing.overshoot, 1e-12);
    }
  }
}

}  // namespace
}  // namespace avo
