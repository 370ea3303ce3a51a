// SPDX-License-Identifier: Apache-2.0
// The certificate against walls: no choice that it admits, and no braking after it, touches one.
#include "support/walls.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include "planner/stages/certified.h"
#include "robots/model.h"

namespace avo::test {
namespace {

constexpr Motion kMotions[] = {Motion::held, Motion::exponential};
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Robot any_body(Random& random) {
  Robot robot;
  robot.radius = random.uniform(0.2, 0.5);
  robot.max_acceleration = random.log_uniform(0.3, 3.0);
  robot.max_speed = random.log_uniform(0.3, 3.0);
  if (random.below(2) == 0) robot.max_braking = random_braking(random, robot.max_acceleration);
  return robot;
}

// What a robot does that means to touch: mostly the hardest push towards a wall, along what is
// admitted.
Vec2 wicked_wish(Random& random, const Robot& robot, const std::vector<Wall>& walls, double u) {
  Vec2 direction = random.direction();
  if (random.below(4) != 0) {
    const Wall* nearest = &walls.front();
    for (const Wall& wall : walls) {
      if (gap_to(robot.position, wall) < gap_to(robot.position, *nearest)) nearest = &wall;
    }
    if (random.below(4) == 0) {
      nearest = &walls[static_cast<std::size_t>(random.below(static_cast<int>(walls.size())))];
    }
    const double part = random.uniform(0.0, 1.0);
    const Vec2 towards = nearest->a + part * (nearest->b - nearest->a) - robot.position;
    if (norm(towards) > 0.0) direction = towards / norm(towards);
  }
  const Vec2 wish =
      robot.velocity + (random.below(3) == 0 ? random.uniform(0.0, u) : u) * direction;
  const double speed = norm(wish);
  return speed > robot.max_speed ? (robot.max_speed / speed) * wish : wish;
}

struct Outcome {
  double least = kInfinity;  // m
  int steps = 0, braked = 0;
};

// One robot that pushes at walls with whatever velocities admits() lets pass.
void push(Random& random, const PlannerOptions& options, int steps, Outcome& outcome) {
  const CertificateLaw law = law_of(options);
  Robot robot = any_body(random);
  const double u = braking_decrement(robot.max_acceleration, law.step);
  if (0.25 * u * options.time_step >= robot.radius) return;
  const std::vector<Wall> walls = random_walls(random, 8.0, robot.radius);
  robot.position = free_place(random, walls, 8.0, robot.radius + 1e-9);
  CertifiedWorkspace workspace;
  for (int k = 0; k < steps; ++k) {
    collect_constraints(robot, {}, law, workspace.constraints, walls);
    EXPECT_FALSE(workspace.constraints.walls.broken.any());
    const CertifiedChoice choice =
        choose_certified(robot, wicked_wish(random, robot, walls, u), law, workspace);
    const TrueStep step{robot.position, robot.velocity, choice.next_velocity};
    outcome.least = std::min(outcome.least, least_gap(step, walls, options) - robot.radius);
    outcome.braked += choice.chosen == Chosen::backup ? 1 : 0;
    ++outcome.steps;
    robot.position = step.at(options.time_step, options);
    robot.velocity = step.next_velocity;
  }
}

TEST(Walls, no_push_touches_one) {
  for (const Motion motion : kMotions) {
    Outcome outcome;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
      SCOPED_TRACE(seed);
      Random random(seed);
      push(random, random_options(random, Certificate::braking_trajectories, motion), 200, outcome);
    }
    EXPECT_GT(outcome.least, 0.0);
    EXPECT_LT(outcome.least, 1e-9) << "nobody came near";
    EXPECT_GT(outcome.steps, 10000);
    EXPECT_LT(outcome.braked, outcome.steps / 2);
  }
}

// A robot beside the wall y = 0, with a gap of so much.
Robot beside(double gap) {
  Robot robot;
  robot.position = {0.3, robot.radius + gap};
  return robot;
}
const Wall kWall{{-5.0, 0.0}, {5.0, 0.0}};

TEST(Walls, one_at_rest_almost_in_contact_leaves_along_the_wall_in_one_step) {
  for (const Motion motion : kMotions) {
    const CertificateLaw law =
        law_of(options_of(Certificate::braking_trajectories, motion, 0.1, 2.0));
    for (const double part : {0.6, 0.8, 1.0, 2.0}) {
      Robot robot = beside(0.0);
      const double margin = wall_margin(
          kWall, wall_rounding(robot.radius, robot.max_speed, robot.max_acceleration, law.step));
      robot = beside(part * margin);
      const double u = braking_decrement(robot.max_acceleration, law.step);
      CertifiedWorkspace workspace;
      for (const double side : {-1.0, 1.0}) {
        collect_constraints(robot, {}, law, workspace.constraints, {&kWall, 1});
        const CertifiedChoice choice = choose_certified(robot, {side * u, 0.0}, law, workspace);
        EXPECT_NE(choice.chosen, Chosen::backup);
        EXPECT_GE(side * choice.next_velocity.x, 0.999999 * u) << part;
      }
      // and not into it
      collect_constraints(robot, {}, law, workspace.constraints, {&kWall, 1});
      EXPECT_FALSE(admits(robot, {0.0, -0.5 * u}, law, workspace.constraints));
    }
  }
}

TEST(Walls, a_post_inside_of_the_steps_triangle_is_seen) {
  // All three sides pass the post by 12 radii, and the motion runs over it: p + v t + a t²/2 with
  // a = (0, 10) is (0.1, 0.0125) in the middle of the step.
  Robot robot;
  robot.radius = 0.001;
  robot.velocity = {2.0, 0.0};
  robot.max_acceleration = 10.0;
  robot.max_speed = 3.0;
  const PlannerOptions options =
      options_of(Certificate::braking_trajectories, Motion::held, 0.1, 2.0);
  const CertificateLaw law = law_of(options);
  const Vec2 next{2.0, 1.0};
  const auto is_admitted_beside = [&](Vec2 post) {
    const Wall wall{post, post};
    CertificateConstraints constraints;
    collect_constraints(robot, {}, law, constraints, {&wall, 1});
    EXPECT_FALSE(constraints.walls.broken.any());
    return admits(robot, next, law, constraints);
  };
  const Vec2 inside{0.1, 0.0125};
  EXPECT_LT(least_gap({robot.position, robot.velocity, next}, Wall{inside, inside}, options), 1e-9);
  EXPECT_FALSE(is_admitted_beside(inside));
  EXPECT_TRUE(is_admitted_beside({0.1, 1.0}));  // beyond all of the path
}

TEST(Walls, braking_is_always_admitted) {
  const CertificateLaw law =
      law_of(options_of(Certificate::braking_trajectories, Motion::held, 0.1, 2.0));
  for (const double speed : {0.0, 0.05, 0.1, 1.0, 2.0}) {
    Robot robot = beside(-0.1);  // in contact
    robot.velocity = {0.0, -speed};
    CertificateConstraints constraints;
    collect_constraints(robot, {}, law, constraints, {&kWall, 1});
    EXPECT_TRUE(constraints.walls.broken.any());
    EXPECT_TRUE(admits(robot, backup_velocity(robot, law), law, constraints));
  }
}

TEST(Walls, a_broken_start_is_held_to_what_braking_leaves) {
  const PlannerOptions options =
      options_of(Certificate::braking_trajectories, Motion::held, 0.1, 2.0);
  const CertificateLaw law = law_of(options);
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Robot robot = beside(random.uniform(-0.2, 0.05));
    robot.velocity = {random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.0)};
    const Vec2 v = robot.velocity;
    const double u = braking_decrement(robot.max_acceleration, law.step), speed = norm(v);
    const Vec2 stop = robot.position + (stopping_length(speed, u, law.step) / speed) * v;
    const double kept = std::min(gap_to(stop, kWall), robot.radius);
    CertifiedWorkspace workspace;
    for (int k = 0; k < 60; ++k) {
      collect_constraints(robot, {}, law, workspace.constraints, {&kWall, 1});
      const CertifiedChoice choice =
          choose_certified(robot, wicked_wish(random, robot, {kWall}, u), law, workspace);
      const TrueStep step{robot.position, robot.velocity, choice.next_velocity};
      EXPECT_GE(least_gap(step, kWall, options), kept - 1e-12);
      robot.position = step.at(options.time_step, options);
      robot.velocity = step.next_velocity;
    }
  }
}

TEST(Walls, one_that_braking_takes_across_a_wall_only_brakes) {
  const CertificateLaw law =
      law_of(options_of(Certificate::braking_trajectories, Motion::held, 0.1, 2.0));
  Robot robot = beside(0.2);
  robot.velocity = {0.0, -2.0};
  CertificateConstraints constraints;
  collect_constraints(robot, {}, law, constraints, {&kWall, 1});
  EXPECT_FALSE(admits(robot, {0.05, -1.9}, law, constraints));
  EXPECT_TRUE(admits(robot, {0.0, -1.9}, law, constraints));
}

TEST(Walls, those_out_of_reach_change_no_bit) {
  const Planner planner(options_of(Certificate::braking_trajectories, Motion::held, 0.1, 2.0));
  const CertificateLaw law = certificate_law(planner);
  PlanWorkspace workspace;
  int refused = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    Robot robot = any_body(random);
    const std::vector<Wall> walls = random_walls(random, 20.0, robot.radius);
    robot.position = free_place(random, walls, 20.0, robot.radius + 1e-3);
    robot.preferred_velocity = robot.max_speed * random.direction();
    robot.velocity = random.uniform(0.0, 1.0) * robot.preferred_velocity;
    const double speed = norm(robot.velocity);
    const double reach =
        robot.radius + wall_reach(speed, robot.max_speed, planned_ability_of(robot), law.step);
    std::vector<Wall> near;
    for (const Wall& wall : walls) {
      if (gap_to(robot.position, wall) <= reach * (1.0 + 1e-9)) near.push_back(wall);
    }
    const Plan all = planner.plan(robot, {}, workspace, nullptr, walls);
    const Plan few = planner.plan(robot, {}, workspace, nullptr, near);
    const Plan none = planner.plan(robot, {}, workspace);
    EXPECT_EQ(all.new_velocity, few.new_velocity);
    EXPECT_EQ(all.status, few.status);
    refused += all.new_velocity == none.new_velocity ? 0 : 1;
    if (near.empty()) {
      EXPECT_EQ(all.new_velocity, none.new_velocity);
    }
  }
  EXPECT_GT(refused, 10);
}

TEST(Walls, one_that_is_not_finite_is_invalid_input) {
  const Planner planner{PlannerOptions{}};
  PlanWorkspace workspace;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Wall& wall : {Wall{{nan, 0.0}, {1.0, 0.0}}, Wall{{}, {kInfinity, 0.0}},
                           Wall{{}, {1.0, 0.0}, -0.1}, Wall{{}, {1.0, 0.0}, nan}}) {
    EXPECT_EQ(planner.plan(Robot{}, {}, workspace, nullptr, {&wall, 1}).status,
              PlanStatus::invalid_input);
  }
}

// m: least gap of the center on the arc from the robot to the state, sampled by its length.
double gap_of_arc(const Robot& robot, const MotionState& state, const std::vector<Wall>& walls) {
  const Vec2 chord = state.position - robot.position;
  const double turn = state.heading - robot.heading;
  const double half = 0.5 * std::remainder(turn, 2.0 * std::numbers::pi);
  const double stretch = std::abs(half) < 1e-9 ? 1.0 : half / std::sin(half);
  double least = gap_to_all(state.position, walls);
  for (int k = 0; k < 16 && norm(chord) > 0.0; ++k) {
    const double part = k / 16.0, angle = half * part;
    const double length =
        norm(chord) * stretch * part * (std::abs(angle) < 1e-9 ? 1.0 : std::sin(angle) / angle);
    const double heading = robot.heading + angle;
    const Vec2 along = length * Vec2{std::cos(heading), std::sin(heading)};
    least = std::min(least, gap_to_all(robot.position + along, walls));
  }
  return least;
}

TEST(Walls, cars_touch_none) {
  PlannerOptions options = options_of(Certificate::braking_trajectories, Motion::held, 0.2, 2.0);
  const CertificateLaw law = law_of(options);
  double least = kInfinity, farthest = 0.0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Robot robot = any_body(random);
    const std::vector<Wall> walls = random_walls(random, 8.0, robot.radius);
    robot.position = free_place(random, walls, 8.0, robot.radius + 1e-9);
    robot.model = Car{random.uniform(0.3, 1.0)};
    robot.heading = random.uniform(-3.0, 3.0);
    const double u = braking_decrement(robot.max_acceleration, law.step);
    const MotionLimits limits{planned_braking(robot), robot.max_speed};
    const Vec2 start = robot.position;
    CertifiedWorkspace workspace;
    for (int k = 0; k < 200; ++k) {
      collect_constraints(robot, {}, law, workspace.constraints, walls);
      const CertifiedChoice choice =
          choose_certified(robot, wicked_wish(random, robot, walls, u), law, workspace);
      const MotionState state =
          advance(robot.model, limits, {robot.position, robot.velocity, robot.heading},
                  plan_to(robot, choice.next_velocity, law.step), options.time_step)
              .next;
      const double gap = gap_of_arc(robot, state, walls) - robot.radius;
      least = std::min(least, gap);
      robot.position = state.position, robot.velocity = state.velocity;
      robot.heading = state.heading;
      farthest = std::max(farthest, norm(robot.position - start));
    }
  }
  EXPECT_GT(least, 0.0);
  EXPECT_LT(least, 1e-3);
  EXPECT_GT(farthest, 2.0);
}

}  // namespace
}  // namespace avo::test
