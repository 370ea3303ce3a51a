// SPDX-License-Identifier: Apache-2.0
// Airplanes beside movers (docs/movers.md, "Airplanes"): alone they are not touched; together they
// keep their certificate.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <span>
#include <vector>

#include "avo/assumptions.h"
#include "avo/error.h"
#include "avo/metrics.h"
#include "avo/simulation.h"
#include "support/generators.h"
#include "unit/sim/mover_scenes.h"

namespace avo {
namespace {

using test::mover;
using test::Random;

// An airplane that flies past movers, or circles where they pass.
Scenario lone_flight(Random& random, int count, bool circles, double time_step) {
  Scenario scene;
  scene.time_step = time_step, scene.sensing_radius = 80.0;
  RobotSetup airplane;
  airplane.position = circles ? Vec2{} : Vec2{-15, 0};
  airplane.goal = circles ? Vec2{} : Vec2{15, 0};
  airplane.heading = random.uniform(-1.0, 1.0);
  airplane.radius = random.uniform(0.3, 0.6);
  airplane.max_acceleration = random.log_uniform(0.3, 2.0);
  airplane.model = Airplane{random.uniform(0.6, 1.6), random.log_uniform(0.7, 3.0)};
  scene.robots = {airplane};
  while (static_cast<int>(scene.moving_obstacles.size()) < count) {
    const Vec2 velocity = random.uniform(0.6, 3.5) * random.direction();
    const double reach = circles ? 4.0 : 10.0, radius = random.uniform(0.3, 1.2);
    const Vec2 meets{random.uniform(-reach, reach), random.uniform(-4.0, 4.0)};
    const Vec2 from = meets - random.uniform(4.0, 16.0) * velocity;
    if (norm(from - airplane.position) < radius + airplane.radius + 3.0) continue;
    scene.moving_obstacles.push_back(mover(from, velocity, radius));
  }
  return scene;
}

// m, the least clearance of the first robot from movers in the last step: between the ends of a
// step its place is on a cubic, up to a micrometer.
double clearance_in_step(const Simulation& simulation, const FleetView& fleet, Vec2 p, Vec2 v,
                         std::span<const Vec2> before, std::span<const Vec2> velocities,
                         const Scenario& scene) {
  const double h = scene.time_step;
  const Vec2 q = fleet.position[0], w = fleet.velocity[0];
  double least = std::numeric_limits<double>::infinity();
  for (int part = 1; part <= 8; ++part) {
    const double s = part / 8.0, left = 1.0 - s;
    const Vec2 place = ((1.0 + 2.0 * s) * left * left) * p + (h * s * left * left) * v +
                       (s * s * (3.0 - 2.0 * s)) * q - (h * s * s * left) * w;
    for (std::size_t k = 0; k < before.size(); ++k) {
      const Vec2 velocity = velocities[k],
                 change = simulation.moving_obstacles().velocity[k] - velocity;
      const Vec2 c = before[k] + (h * s) * velocity + (0.5 * h * s * s) * change;
      least = std::min(least,
                       norm(place - c) - scene.moving_obstacles[k].radius - scene.robots[0].radius);
    }
  }
  return least;
}

struct Flown {
  double clearance = std::numeric_limits<double>::infinity();  // m
  int evading = 0;                                             // steps
  bool arrives = false;
};
Flown fly_for(const Scenario& scene, double duration) {
  Simulation simulation(scene, 1);
  Flown result;
  std::vector<Vec2> places, velocities;
  while (simulation.time() < duration) {
    const Vec2 p = simulation.fleet().position[0], v = simulation.fleet().velocity[0];
    const MovingObstacleView movers = simulation.moving_obstacles();
    places.assign(movers.position.begin(), movers.position.end());
    velocities.assign(movers.velocity.begin(), movers.velocity.end());
    simulation.step();
    const FleetView fleet = simulation.fleet();
    result.evading += fleet.plan[0].evading ? 1 : 0;
    result.clearance = std::min(
        result.clearance, clearance_in_step(simulation, fleet, p, v, places, velocities, scene));
    result.arrives = result.arrives || simulation.is_at_goal({0});
  }
  return result;
}

TEST(FlightEvasion, nobody_is_hit_alone_among_movers) {
  Random random(34);
  int evading = 0, late = 0;
  for (int trial = 0; trial < 240; ++trial) {
    const double time_step = std::vector{0.1, 0.05, 0.25}[static_cast<std::size_t>(trial % 3)];
    const int count = 1 + trial / 3 % 6;
    for (const bool circles : {false, true}) {
      const Flown flown = fly_for(lone_flight(random, count, circles, time_step), 40.0);
      EXPECT_GE(flown.clearance, 0.0) << trial << (circles ? " circles" : "");
      late += flown.arrives ? 0 : 1;
      evading += flown.evading > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(evading, 200);
  EXPECT_LE(late, 2);
}

// Once there is an evasive maneuver, there is one in each later state (docs/movers.md, "What is
// proved").
TEST(FlightEvasion, an_evasion_leaves_another_one) {
  Random random(35);
  int known = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Scenario scene = lone_flight(random, 1 + trial % 6, trial % 2 == 0, 0.1);
    Simulation simulation(scene, 1);
    PlanWorkspace workspace;
    bool had_one = false;
    for (int step = 0; step < 200; ++step, simulation.step()) {
      const Simulation::Perception seen = simulation.perceive({0});
      const Planner& planner = simulation.planner({0});
      const bool has_one =
          planner.has_evasive_maneuver(seen.robot, seen.neighbors, workspace, seen.walls);
      ASSERT_TRUE(has_one || !had_one) << trial << ", step " << step;
      had_one = has_one, known += has_one ? 1 : 0;
      const SafetyState state = planner.state(seen.robot, seen.neighbors, workspace).state;
      ASSERT_EQ(state, has_one ? SafetyState::safe : SafetyState::unknown);
      ASSERT_EQ(planner.plan(seen.robot, seen.neighbors, workspace).state, state);
    }
  }
  EXPECT_GT(known, 60 * 150);
}

TEST(FlightEvasion, nobody_is_hit_by_movers_that_accelerate_or_come_back) {
  Random random(36);
  for (int trial = 0; trial < 40; ++trial) {
    Scenario scene = lone_flight(random, 2, trial % 2 == 0, 0.1);
    for (MovingObstacle& m : scene.moving_obstacles) {
      if (trial % 4 < 2) {
        m.acceleration = random.uniform(-0.05, 0.05) * m.velocity;
        continue;
      }
      const double speed = std::min(norm(m.velocity), 1.5);
      m.path = {m.position + 12.0 / speed * m.velocity, m.position};
      m.velocity = (0.9 * speed / norm(m.velocity)) * m.velocity;
      m.max_speed = speed, m.max_deviation = 1.0;
    }
    EXPECT_GE(fly_for(scene, 40.0).clearance, 0.0) << trial;
  }
}

TEST(FlightEvasion, walls_are_kept_beside_movers) {
  Random random(37);
  for (int trial = 0; trial < 30; ++trial) {
    Scenario scene = lone_flight(random, 3, false, 0.1);
    scene.robots[0].heading = 0.0;
    for (const double y : {-14.0, 9.0})
      scene.obstacles.push_back({{{{Vec2{-40, y}, Vec2{40, y}}}}});
    Simulation simulation(scene, 1);
    Metrics metrics(scene);
    for (int step = 0; step < 300; ++step) metrics.observe(simulation), simulation.step();
    EXPECT_EQ(metrics.summary().static_collisions, 0) << trial;
    EXPECT_EQ(metrics.summary().mover_collisions_evadable.value_or(-1), 0) << trial;
  }
}

// Airplanes among robots of other kinds and movers, sent to one place after the other.
Scenario crowd_with_movers(std::uint64_t seed) {
  Random random(seed);
  Scenario scene;
  scene.sensing_radius = 40.0;
  for (int k = 0; k < 6; ++k) {
    const Vec2 from = 40.0 * random.direction(), to = test::in_disc(random, 8.0);
    scene.moving_obstacles.push_back(mover(from, random.uniform(0.02, 0.06) * (to - from), 0.6));
  }
  for (int tries = 0; scene.robots.size() < 30 && tries < 10'000; ++tries) {
    RobotSetup setup;
    setup.position = setup.goal = test::in_disc(random, 28.0);
    setup.radius = random.uniform(0.2, 0.6), setup.heading = random.uniform(-3.0, 3.0);
    const int kind = random.below(4);
    if (kind < 2) setup.model = Airplane{random.uniform(0.5, 1.2), random.uniform(1.0, 3.0)};
    if (kind == 2) setup.model = Car{.max_curvature = 0.8, .reverse = true};
    setup.velocity = kind < 2 ? Vec2{std::get<Airplane>(setup.model).min_speed, 0.0} : Vec2{};
    scene.robots.push_back(setup);
    if (broken_assumptions(scene).start_count > 0) scene.robots.pop_back();
  }
  return scene;
}

TEST(FlightEvasion, robots_do_not_touch_each_other_beside_movers) {
  for (const std::uint64_t seed : {1, 2}) {
    const Scenario scene = crowd_with_movers(seed);
    Simulation one(scene, 1), two(scene, 2);
    Metrics metrics(scene);
    Random random(5);
    int evading = 0;
    for (int step = 0; step < 500; ++step) {
      if (step % 100 == 0) {
        const Vec2 rally = test::in_disc(random, 8.0);
        for (Simulation* simulation : {&one, &two})
          for (const RobotId robot :
               std::vector(simulation->fleet().id.begin(), simulation->fleet().id.end()))
            simulation->set_goal(robot, rally);
      }
      metrics.observe(one);
      one.step(), two.step();
      const FleetView fleet = one.fleet();
      for (std::size_t k = 0; k < fleet.plan.size(); ++k)
        evading += fleet.plan[k].evading && !can_rest(fleet.setup[k].model) ? 1 : 0;
      ASSERT_EQ(one.state_hash(), two.state_hash()) << step;
    }
    const RunSummary summary = metrics.summary();
    EXPECT_EQ(summary.collision_pairs, 0);
    EXPECT_GE(summary.min_clearance.value_or(-1.0), -1e-7);
    EXPECT_EQ(summary.acceleration_excess, 0.0);
    EXPECT_EQ(summary.decisions.invalid_input, 0);
    EXPECT_GT(evading, 5);
  }
}

Robot airplane_in_flight() {
  Robot robot;
  robot.velocity = robot.preferred_velocity = {2, 0};
  robot.model = Airplane{1.0, 1.0};
  return robot;
}

Neighbor walker(Vec2 position, Vec2 velocity) {
  return {.position = position, .velocity = velocity, .behavior = Behavior::moves_on};
}

TEST(FlightEvasion, may_start_anywhere_but_in_contact) {
  Random random(39);
  Scenario scene = lone_flight(random, 1, true, 0.1);
  const Vec2 place{30.0, 0.0};
  scene.moving_obstacles[0] = mover(place, {-1, 0}, 0.5);
  RobotSetup another = scene.robots[0];
  another.radius = 0.5;
  const auto starts = [&](double away) {
    Simulation simulation(scene, 1);
    another.position = another.goal = place + Vec2{0.0, away};
    try {
      simulation.add_robot(another);
    } catch (const Error&) {
      return false;
    }
    return true;
  };
  EXPECT_TRUE(starts(1.1)) << "its circle is crossed";
  EXPECT_FALSE(starts(0.9));
}

TEST(FlightEvasion, is_told_with_the_beginning_of_the_circle) {
  Random random(38);
  PlanWorkspace workspace;
  int evading = 0, named = 0;
  for (int trial = 0; trial < 10; ++trial) {
    Simulation simulation(lone_flight(random, 3, true, 0.1), 1);
    const RobotSetup& setup = simulation.fleet().setup[0];
    const auto& airplane = std::get<Airplane>(setup.model);
    for (int step = 0; step < 200; ++step, simulation.step()) {
      const Simulation::Perception seen = simulation.perceive({0});
      const Planner& planner = simulation.planner({0});
      const Plan plan = planner.plan(seen.robot, seen.neighbors, workspace);
      const auto way = planner.evasion(seen.robot, seen.neighbors, workspace);
      ASSERT_EQ(way.has_value(), plan.evading) << step;
      if (!way) continue;
      ++evading;
      EXPECT_EQ(plan.status, PlanStatus::refused);
      named += way->neighbor >= 0 && way->neighbor < 3 ? 1 : 0;
      EXPECT_GE(norm(way->velocity), airplane.min_speed - 1e-9);
      EXPECT_LE(norm(way->velocity), setup.max_speed + 1e-9);
      EXPECT_GT(way->duration, 0.0);
      EXPECT_LE(way->duration, 40.0 + 0.2) << "400 steps, and one";
    }
  }
  EXPECT_GT(evading, 20);
  EXPECT_LT(evading, 10 * 100) << "not any longer when all have passed by";
  EXPECT_GT(named, evading / 2);
}

TEST(FlightEvasion, there_is_an_evasion_or_not) {
  const Planner planner(default_options(Method::avo));
  PlanWorkspace workspace;
  const Robot robot = airplane_in_flight();
  const auto has = [&](const std::vector<Neighbor>& others, const std::vector<Wall>& walls = {}) {
    return planner.has_evasive_maneuver(robot, others, workspace, walls);
  };
  EXPECT_TRUE(has({}));
  EXPECT_TRUE(has({walker({12, 0}, {-2, 0})}));
  EXPECT_FALSE(has({walker({2.5, 0}, {-4, 0})})) << "0.25 s before contact";
  std::vector<Neighbor> ring;
  for (int k = 0; k < 24; ++k)
    ring.push_back(walker({2.2 * std::cos(0.262 * k), 2.2 * std::sin(0.262 * k)}, {}));
  EXPECT_FALSE(has(ring)) << "all around";
  // between two walls no circle keeps clear of what comes
  const std::vector<Wall> walls{{{-60, 0.6}, {60, 0.6}, 0.0}, {{-60, -8.7}, {60, -8.7}, 0.0}};
  Neighbor wide = walker({-30.0, -4.0}, {3, 0});
  wide.radius = 3.0;
  EXPECT_TRUE(has({}, walls));
  EXPECT_TRUE(has({wide}));
  EXPECT_FALSE(has({wide}, walls));
  // A robot that cooperates promises nothing, and is no moving obstacle either.
  Neighbor polite = walker({9, 0}, {});
  polite.behavior = Behavior::cooperates;
  EXPECT_EQ(planner.plan(robot, std::vector{polite}, workspace).status, PlanStatus::invalid_input);
}

}  // namespace
}  // namespace avo
