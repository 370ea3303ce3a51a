// SPDX-License-Identifier: Apache-2.0
// What a certificate assumes of a scene: found where it is broken, to the bound, and nowhere else.
#include "avo/assumptions.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <span>
#include <vector>

#include "certificate/certificate.h"
#include "sim/scene/assumptions.h"
#include "support/generators.h"
#include "unit/sim/certified_scenes.h"

namespace avo {
namespace {

using test::head_on;
using test::Kind;
using test::kKinds;
using test::Random;

bool accepts(const Scenario& scenario) {
  return broken_assumptions(scenario).none();
}

// Half of what two robots head-on at 2 m/s need between their edges.
double stopping_vector(const Scenario& scenario) {
  const CertificateLaw law = certificate_law(scenario);
  return stopping_length(2.0, braking_decrement(1.0, law.step), law.step);
}

TEST(Assumptions, head_on_is_accepted_up_to_the_last_millimeter) {
  for (const Kind kind : kKinds) {
    Scenario scene = head_on(1.0, kind);
    const double needed = 1.0 + 2.0 * stopping_vector(scene);
    EXPECT_TRUE(accepts(head_on(needed, kind)));
    EXPECT_TRUE(accepts(head_on(needed + 1e-3, kind)));
    const BrokenAssumptions broken = broken_assumptions(head_on(needed - 1e-3, kind));
    ASSERT_EQ(broken.start_count, 1);
    ASSERT_EQ(broken.starts.size(), 1U);
    EXPECT_EQ(broken.starts[0].robot, RobotId{0});
    EXPECT_EQ(broken.starts[0].other, BodyId(RobotId{1}));
    EXPECT_DOUBLE_EQ(broken.starts[0].distance, needed - 1e-3);
    EXPECT_NEAR(broken.starts[0].depth, 1e-3, 1e-9);
    EXPECT_EQ(broken.fast_count, 0);
    EXPECT_FALSE(broken.unseen);
  }
  // 2 m each by a = 1 m/s² held over steps of 0.1 s
  EXPECT_DOUBLE_EQ(stopping_vector(head_on(1.0, kKinds[0])), 2.0);
}

TEST(Assumptions, crossing_one_after_the_other_breaks_none) {
  Scenario scene = head_on(20.0, {Certificate::braking_trajectories, Motion::held});
  scene.robots[0].position = {-1.0, 0.0};  // past the crossing when the other one comes
  scene.robots[0].velocity = {2.0, 0.0};
  scene.robots[1].position = {-0.2, -2.6};
  scene.robots[1].velocity = {0.0, 2.0};
  EXPECT_TRUE(accepts(scene));
}

TEST(Assumptions, overlap_at_rest_is_broken_touching_is_not) {
  for (const Kind kind : kKinds) {
    Scenario scene = head_on(1.0, kind);
    start_at_rest(scene);
    EXPECT_TRUE(accepts(scene));
    scene.robots[1].position.x -= 1e-10;  // what decimal fractions cost
    EXPECT_TRUE(accepts(scene));
    scene.robots[1].position.x -= 1e-8;
    EXPECT_FALSE(accepts(scene));
    scene.robots[1].position.x = scene.robots[0].position.x + 0.75;
    BrokenAssumptions broken = broken_assumptions(scene);
    ASSERT_EQ(broken.start_count, 1);
    EXPECT_DOUBLE_EQ(broken.starts[0].distance, 0.75);
    EXPECT_DOUBLE_EQ(broken.starts[0].depth, 0.25);
    scene.robots[1].position = scene.robots[0].position;
    broken = broken_assumptions(scene);
    ASSERT_EQ(broken.start_count, 1);
    EXPECT_DOUBLE_EQ(broken.starts[0].depth, 1.0);
  }
}

TEST(Assumptions, depth_is_never_more_than_contact) {
  for (const Kind kind : kKinds) {
    for (const double gap : {0.0, 0.1, 1.0, 2.0}) {
      const BrokenAssumptions broken = broken_assumptions(head_on(1.0 + gap, kind));
      ASSERT_EQ(broken.start_count, 1);
      EXPECT_LE(broken.starts[0].depth, 1.0);
      EXPECT_GT(broken.starts[0].depth, 0.9);
    }
  }
}

TEST(Assumptions, a_mover_counts_while_the_robot_brakes) {
  Scenario scene = head_on(20.0, {Certificate::braking_trajectories, Motion::held});
  scene.robots.pop_back();  // at 2 m/s towards +x, 20 steps of braking and 2 m
  const Vec2 own = scene.robots[0].position;
  scene.moving_obstacles = {{own + Vec2{1.0 + 2.0 + 2.0, 0.0}, {-1.0, 0.0}, {}, 0.5}};
  EXPECT_TRUE(accepts(scene));
  scene.moving_obstacles[0].position.x -= 1e-3;
  const BrokenAssumptions broken = broken_assumptions(scene);
  ASSERT_EQ(broken.start_count, 1);
  EXPECT_EQ(broken.starts[0].robot, RobotId{0});
  EXPECT_EQ(broken.starts[0].other, BodyId(MovingObstacleId{0}));
  EXPECT_NEAR(broken.starts[0].depth, 1e-3, 1e-9);
  // a robot at rest is touched without its doing, but must not overlap at the start
  scene.robots[0].velocity = {};
  EXPECT_TRUE(accepts(scene));
  scene.moving_obstacles[0].position = own + Vec2{0.9, 0.0};
  EXPECT_NEAR(broken_assumptions(scene).starts.at(0).depth, 0.1, 1e-12);
  // and two obstacles are no one's concern
  scene.moving_obstacles = {{{50.0, 0.0}, {}, {}, 0.5}, {{50.0, 0.0}, {}, {}, 0.5}};
  EXPECT_TRUE(accepts(scene));
}

TEST(Assumptions, a_mover_from_rest_counts_by_its_acceleration) {
  for (const Motion motion : {Motion::held, Motion::exponential}) {
    Scenario scene = head_on(20.0, {Certificate::braking_trajectories, motion});
    scene.robots.pop_back();
    const CertificateLaw law = certificate_law(scene);
    const double u = braking_decrement(1.0, law.step);
    const double seconds = 0.1 * braking_steps_at_least(2.0, u);
    const double meeting = 1.0 + stopping_length(2.0, u, law.step) + 0.5 * seconds * seconds * 0.8;
    // it moves on a parabola, the robot does not where its motion is exponential: a Δt²/8 at most
    const double margin = motion == Motion::held ? 0.0 : 0.001;
    scene.sensing_radius = 1000.0;  // within the duration it gets fast
    scene.moving_obstacles = {{{meeting + margin + 1e-4, 0.0}, {}, {-0.8, 0.0}, 0.5}};
    EXPECT_TRUE(accepts(scene));
    scene.moving_obstacles[0].position.x -= 2e-4;
    const BrokenAssumptions broken = broken_assumptions(scene);
    ASSERT_EQ(broken.start_count, 1);
    EXPECT_NEAR(broken.starts[0].depth, 1e-4, 1e-9);
  }
}

TEST(Assumptions, a_car_moves_along_its_heading) {
  Scenario scene = head_on(4.5, {Certificate::braking_trajectories, Motion::held});
  EXPECT_FALSE(accepts(scene));
  for (RobotSetup& robot : scene.robots) robot.model = Car{1.0}, robot.heading = 1.5;
  EXPECT_TRUE(accepts(scene));
}

TEST(Assumptions, speeds_beyond_the_limit_worst_first) {
  Scenario scene;
  scene.sensing_radius = 1000.0;
  for (int i = 0; i < 8; ++i) {
    RobotSetup robot;
    robot.position = {0.0, 100.0 * i};
    robot.velocity = {0.0, i % 2 == 0 ? 2.0 : 2.0 + 0.1 * i};
    scene.robots.push_back(robot);
  }
  const BrokenAssumptions broken = broken_assumptions(scene);
  EXPECT_EQ(broken.fast_count, 4);
  ASSERT_EQ(broken.fast.size(), 3U);
  EXPECT_EQ(broken.fast[0].robot, RobotId{7});
  EXPECT_EQ(broken.fast[1].robot, RobotId{5});
  EXPECT_EQ(broken.fast[2].robot, RobotId{3});
  EXPECT_DOUBLE_EQ(broken.fast[0].speed, 2.7);
  EXPECT_EQ(broken.start_count, 0);
  for (RobotSetup& robot : scene.robots) robot.velocity = {1.2, 1.6};  // 2 m/s up to rounding
  EXPECT_TRUE(accepts(scene));
}

TEST(Assumptions, nothing_is_assumed_without_a_certificate) {
  Scenario scene = head_on(0.5, {Certificate::none, Motion::held});
  scene.sensing_radius = 0.1;
  scene.robots[0].velocity = {9.0, 0.0};
  EXPECT_TRUE(accepts(scene));
  EXPECT_FALSE(sensing_need(scene));
  EXPECT_EQ(admissible_speed(scene), std::numeric_limits<double>::infinity());
  scene.certificate.reset();
  EXPECT_FALSE(accepts(scene));
  for (const Method method :
       {Method::avo_paper, Method::orca, Method::velocity_obstacle, Method::orca_clamped,
        Method::reciprocal_velocity_obstacle, Method::buffered_voronoi}) {
    scene.method = method;
    EXPECT_TRUE(accepts(scene));
  }
  EXPECT_TRUE(accepts(Scenario{}));
}

// Every pair put to the certificate, no search.
std::int64_t counted_one_by_one(const Scenario& scene) {
  const CertificateLaw law = certificate_law(scene);
  CertificateConstraints constraints;
  std::int64_t count = 0;
  const auto is_broken = [&](const RobotSetup& own, const Neighbor& other, double margin) {
    Robot robot;
    robot.position = own.position, robot.velocity = own.velocity;
    robot.radius = own.radius, robot.max_acceleration = own.max_acceleration;
    collect_constraints(robot, std::span(&other, 1), law, constraints);
    const double contact = own.radius + other.radius;
    return constraints.invariant.slack - margin < -1e-9 * contact ||
           norm(own.position - other.position) < (1.0 - 1e-9) * contact;
  };
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    for (std::size_t j = i + 1; j < scene.robots.size(); ++j) {
      const RobotSetup& b = scene.robots[j];
      const Neighbor other{b.position, b.velocity, b.radius, b.max_acceleration, {}};
      if (is_broken(scene.robots[i], other, 0.0)) ++count;
    }
    for (const MovingObstacle& b : scene.moving_obstacles) {
      const Neighbor other{.position = b.position,
                           .velocity = b.velocity,
                           .radius = b.radius,
                           .behavior = Behavior::moves_on,
                           .acceleration = b.acceleration};
      if (is_broken(scene.robots[i], other, parabola_error(b.acceleration, law.step))) ++count;
    }
  }
  return count;
}

TEST(Assumptions, the_search_finds_exactly_what_all_pairs_find) {
  Random random(5);
  std::int64_t found = 0;
  for (int round = 0; round < 60; ++round) {
    const Kind kind = kKinds[static_cast<std::size_t>(round) % kKinds.size()];
    Scenario scene;
    scene.certificate = kind.certificate;
    scene.motion = kind.motion;
    const double extent = random.log_uniform(5.0, 500.0);
    for (int i = 0; i < 120; ++i) {
      RobotSetup robot;
      robot.position = extent * Vec2{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
      robot.radius = random.log_uniform(0.01, 20.0);
      robot.max_acceleration = random.log_uniform(0.3, 3.0);
      robot.max_speed = random.log_uniform(0.1, 8.0);
      if (random.below(3) > 0) robot.velocity = test::in_disc(random, robot.max_speed);
      scene.robots.push_back(robot);
    }
    for (int k = 0; k < 15; ++k) {
      const Vec2 place = extent * Vec2{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
      const Vec2 v = test::in_disc(random, 4.0), a = test::in_disc(random, 0.5);
      scene.moving_obstacles.push_back({place, v, a, random.log_uniform(0.1, 5.0)});
    }
    const std::int64_t expected = counted_one_by_one(scene);
    EXPECT_EQ(broken_assumptions(scene).start_count, expected) << round;
    found += expected;
  }
  EXPECT_GT(found, 5000);
}

TEST(Assumptions, the_deepest_are_named_whatever_their_order) {
  Scenario scene;
  for (int i = 0; i < 40; ++i) {
    RobotSetup robot;
    robot.position = {0.99 * i - 0.001 * i * (i % 7), 0.0};
    scene.robots.push_back(robot);
  }
  const BrokenAssumptions broken = broken_assumptions(scene);
  ASSERT_EQ(broken.starts.size(), 3U);
  EXPECT_GT(broken.start_count, 3);
  std::vector<double> depths;
  for (std::size_t i = 0; i < 40; ++i) {
    for (std::size_t j = i + 1; j < 40; ++j) {
      depths.push_back(1.0 - norm(scene.robots[i].position - scene.robots[j].position));
    }
  }
  std::sort(depths.rbegin(), depths.rend());
  // along a normal that is a unit vector to rounding
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(broken.starts[k].depth, depths[k], 1e-15);
}

TEST(Assumptions, of_a_heap_nobody_counts_all_pairs) {
  Scenario scene;
  scene.robots.resize(100'000);
  const BrokenAssumptions broken = broken_assumptions(scene);
  EXPECT_EQ(broken.start_count, BrokenAssumptions::kCounted);
  EXPECT_EQ(broken.starts.size(), 3U);
}

}  // namespace
}  // namespace avo
