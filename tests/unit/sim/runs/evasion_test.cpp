// SPDX-License-Identifier: Apache-2.0
// A robot alone among movers that keep their motion is not touched, neither in motion nor at rest
// (docs/movers.md), judged by where everybody is.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "avo/simulation.h"
#include "support/generators.h"
#include "unit/sim/mover_scenes.h"

namespace avo {
namespace {

using test::mover;
using test::one_robot;
using test::robot_at;

// Moving obstacles cross the course of the robot, or pass over where it rests.
Scenario crossing(test::Random& random, int count, double slowest, double fastest, bool rests,
                  double time_step) {
  Scenario scene =
      rests ? one_robot({0, 0}, {0, 0}, time_step) : one_robot({-10, 0}, {10, 0}, time_step);
  while (static_cast<int>(scene.moving_obstacles.size()) < count) {
    const Vec2 along = random.direction();
    const Vec2 velocity = random.uniform(slowest, fastest) * along;
    const double radius = random.uniform(0.3, 1.2), time = random.uniform(4.0, 16.0);
    const double aside = random.uniform(-1.0, 1.0) * (radius + 0.4);
    const Vec2 meets = rests ? aside * Vec2{-along.y, along.x}
                             : Vec2{random.uniform(-7.0, 7.0), random.uniform(-3.0, 3.0)};
    const Vec2 from = meets - time * velocity;
    if (norm(from - scene.robots[0].position) < radius + 3.4) continue;
    scene.moving_obstacles.push_back(mover(from, velocity, radius));
  }
  return scene;
}

struct Watched {
  double clearance = std::numeric_limits<double>::infinity();  // m, least, from movers
  double arrives = std::numeric_limits<double>::infinity();    // s
};
Watched watch(const Scenario& scene, double duration) {
  Simulation simulation(scene, 1);
  Watched result;
  const RobotSetup& robot = scene.robots[0];
  const double h = scene.time_step, radius = disc_radius(robot.model, robot.radius);
  const auto disc = [&] {
    const FleetView fleet = simulation.fleet();
    return disc_center(robot.model, fleet.position[0], fleet.heading[0]);
  };
  Vec2 p = disc(), v = robot.velocity;
  for (double time = 0.0; time < duration; time += h) {
    simulation.step();
    const Vec2 next = disc();
    for (int part = 1; part <= 16; ++part) {
      const double t = h * part / 16.0;
      const Vec2 place = p + t * v + (t * t / (h * h)) * (next - p - h * v);
      for (const MovingObstacle& m : scene.moving_obstacles) {
        const double at = time + t;
        const Vec2 c = m.position + at * m.velocity + (0.5 * at * at) * m.acceleration;
        result.clearance = std::min(result.clearance, norm(place - c) - m.radius - radius);
      }
    }
    p = next, v = simulation.fleet().velocity[0];
    const bool is_there =
        norm(simulation.fleet().position[0] - robot.goal) <= scene.arrival_distance;
    if (is_there) result.arrives = std::min(result.arrives, simulation.time());
  }
  return result;
}

TEST(Evasion, nobody_is_hit_alone_among_movers) {
  test::Random random(34);
  for (const double time_step : {0.1, 0.05, 0.25}) {
    for (const int count : {1, 3, 6}) {
      for (int trial = 0; trial < 8; ++trial) {
        SCOPED_TRACE(testing::Message() << time_step << " s, " << count << ", " << trial);
        const bool slow = trial % 2 == 0;
        const Watched way = watch(
            crossing(random, count, slow ? 0.6 : 2.0, slow ? 2.0 : 4.0, false, time_step), 30.0);
        EXPECT_GE(way.clearance, 0.0);
        EXPECT_LE(way.arrives, 30.0);
        EXPECT_GE(watch(crossing(random, count, 0.4, 3.0, true, time_step), 24.0).clearance, 0.0);
      }
    }
  }
}

// Robots with wheels: of those with a disc off the axle the place of that.
TEST(Evasion, nobody_on_wheels_is_hit_alone_among_movers) {
  Car narrow{.wheelbase = 0.5, .max_curvature = 1.0};
  Car with_body{.wheelbase = 0.5, .max_curvature = 0.8, .body = CarBody{0.25, 0.4}};
  with_body.reverse = true;
  test::Random random(38);
  for (const MotionModel& model : {MotionModel{Car{.wheelbase = 0.5}}, MotionModel{narrow},
                                   MotionModel{with_body}, MotionModel{DifferentialDrive{}}}) {
    for (const int count : {1, 4}) {
      for (int trial = 0; trial < 8; ++trial) {
        SCOPED_TRACE(testing::Message() << model.index() << ", " << count << ", " << trial);
        for (const bool rests : {false, true}) {
          Scenario scene = crossing(random, count, 0.6, trial % 2 == 0 ? 2.0 : 3.0, rests, 0.1);
          scene.robots[0].model = model;
          const Watched way = watch(scene, 30.0);
          EXPECT_GE(way.clearance, 0.0);
          EXPECT_TRUE(rests || way.arrives <= 30.0);
        }
      }
    }
  }
}

// Movers that pull away, or brake and come back.
TEST(Evasion, nobody_is_hit_by_movers_that_accelerate) {
  test::Random random(35);
  for (int trial = 0; trial < 24; ++trial) {
    Scenario scene = crossing(random, 2, 0.6, 2.0, trial % 3 == 0, 0.1);
    for (MovingObstacle& m : scene.moving_obstacles) {
      const Vec2 a = random.uniform(-0.15, 0.15) * m.velocity;
      const double meets = norm(scene.robots[0].position - m.position) / norm(m.velocity);
      m.acceleration = a, m.velocity = m.velocity - (0.5 * std::min(meets, 16.0)) * a;
    }
    EXPECT_GE(watch(scene, 24.0).clearance, 0.0) << trial;
  }
}

TEST(Evasion, of_what_anybody_tries_first) {
  Scenario walker_at_rest = one_robot({0, 0}, {0, 0}, 0.1);
  walker_at_rest.moving_obstacles = {mover({-8, 0}, {1, 0}, 0.3)};
  Scenario walker_ahead = one_robot({-5, 0}, {5, 0}, 0.1);
  walker_ahead.moving_obstacles = {mover({5, 0}, {-1, 0}, 0.3)};
  Scenario tram = one_robot({0, 0}, {25, 0}, 0.1);
  tram.robots[0].preferred_speed = 0.8;
  tram.moving_obstacles = {mover({-10, 0}, {1.5, 0}, 1.0)};
  for (const Scenario& scene : {walker_at_rest, walker_ahead, tram}) {
    const Watched found = watch(scene, 60.0);
    EXPECT_GE(found.clearance, 0.0);
    EXPECT_LE(found.arrives, 32.0);
  }
}

// What differences of measured velocities leave of an acceleration is none.
TEST(Evasion, of_movers_with_an_acceleration_that_is_rounding) {
  for (const Vec2 a : {Vec2{1e-16, 0}, Vec2{1e-15, 0}, Vec2{-1e-17, 1e-16}, Vec2{1e-170, 0}}) {
    Scenario scene = one_robot({0, 0}, {0, 0}, 0.1);
    scene.moving_obstacles = {mover({-10, 0}, {1, 0}, 0.5)};
    scene.moving_obstacles[0].acceleration = a;
    EXPECT_GE(watch(scene, 20.0).clearance, 0.0) << a.x;
  }
}

// What is not seen exactly is never touched in motion: no last-moment swerves then.
TEST(Evasion, is_at_rest_when_touched_where_velocities_are_noisy) {
  test::Random random(37);
  for (int trial = 0; trial < 40; ++trial) {
    Scenario scene = one_robot({0, 0}, {12, 0}, 0.1);
    scene.seed = static_cast<std::uint64_t>(trial + 1);
    scene.sensing.noise = MeasurementNoise{0.0, 0.1, NoiseDistribution::gaussian, 3.0};
    const Vec2 along = random.direction();
    const double speed = random.uniform(1.0, 4.0), time = random.uniform(1.0, 3.0);
    const Vec2 from = random.uniform(-0.8, 0.8) * Vec2{-along.y, along.x} - (time * speed) * along;
    if (norm(from) < 2.0) continue;
    scene.moving_obstacles = {mover(from, speed * along, 0.6)};
    Simulation simulation(scene, 1);
    for (int step = 1; step < 120; ++step) {
      const Vec2 before = simulation.fleet().velocity[0];
      simulation.step();
      const Vec2 c = from + (step * scene.time_step * speed) * along;
      const bool touches = norm(simulation.fleet().position[0] - c) < 1.0 - 1e-9;
      EXPECT_TRUE(!touches || before == Vec2{} || simulation.fleet().velocity[0] == Vec2{})
          << trial << ", step " << step;
    }
  }
}

// Between two walls there is no room aside, but a niche is room.
TEST(Evasion, among_walls) {
  Scenario scene = one_robot({0, 0}, {0, 0}, 0.1);
  scene.obstacles = {
      {.chains = {{{{-20, 1.0}, {-2.5, 1.0}, {-2.5, 3.0}, {-1.0, 3.0}, {-1.0, 1.0}, {20, 1.0}}}}},
      {.chains = {{{{-20, -1.0}, {20, -1.0}}}}}};
  scene.moving_obstacles = {mover({9, 0}, {-1, 0}, 0.55)};
  EXPECT_GE(watch(scene, 24.0).clearance, 0.0);
}

// The moving obstacle is wider than the distance that braking from v_max takes. Beside a wall, A
// goes as far as walls are known.
TEST(Evasion, of_a_wide_mover_beside_a_wall) {
  Scenario scene = one_robot({0, 0}, {0, 0}, 0.1);
  scene.obstacles = {{.chains = {{{{-40, 1.0}, {40, 1.0}}}}}};
  scene.moving_obstacles = {mover({20, -1.5}, {-1, 0}, 4.0)};
  EXPECT_GE(watch(scene, 40.0).clearance, 0.0);
}

// Where other robots block the first steps of all evasions, the robot takes what they admit.
TEST(Evasion, among_robots_that_are_in_the_way) {
  test::Random random(8);
  int touched = 0;
  for (int trial = 0; trial < 20; ++trial) {
    Scenario scene = crossing(random, 6, 0.6, 3.0, false, 0.1);
    scene.robots.clear();
    for (int k = 0; k < 8; ++k) {
      const double angle = k * std::numbers::pi / 4.0;
      const Vec2 p{8.0 * std::cos(angle), 8.0 * std::sin(angle)};
      scene.robots.push_back(robot_at(p, {-p.x, 0.1 - p.y}));
      scene.robots.back().radius = 0.4;
    }
    std::erase_if(scene.moving_obstacles, [&](const MovingObstacle& m) {
      return std::any_of(scene.robots.begin(), scene.robots.end(), [&](const RobotSetup& robot) {
        return norm(m.position - robot.position) < m.radius + 3.0;
      });
    });
    Simulation simulation(scene, 1);
    std::set<std::pair<int, std::size_t>> pairs;
    for (int step = 1; step <= 300; ++step) {
      simulation.step();
      for (int k = 0; k < 8; ++k)
        for (std::size_t m = 0; m < scene.moving_obstacles.size(); ++m) {
          const MovingObstacle& other = scene.moving_obstacles[m];
          const Vec2 c = other.position + simulation.time() * other.velocity;
          if (norm(simulation.fleet().position[k] - c) < other.radius + 0.4) pairs.insert({k, m});
        }
    }
    touched += static_cast<int>(pairs.size());
  }
  EXPECT_LE(touched, 10);
}

// The robot evades twice as far ahead as towards neighbors that do their share, and by half of its
// radius.
TEST(Evasion, begins_early_and_keeps_a_margin) {
  const Planner planner{PlannerOptions{}};
  PlanWorkspace workspace;
  const Robot robot{.velocity = {2, 0}, .preferred_velocity = {2, 0}, .radius = 0.4};
  const auto comes = [&](double time) {  // until contact
    Neighbor other{.position = {0.8 + 4.0 * time, 0.0}, .velocity = {-2, 0}, .radius = 0.4};
    other.behavior = Behavior::moves_on;
    return planner.plan(robot, std::vector{other}, workspace).next_velocity;
  };
  EXPECT_NE(comes(5.9), (Vec2{2, 0}));
  EXPECT_EQ(comes(6.1), (Vec2{2, 0}));
  for (const double aside : {-0.3, 0.0, 0.5, 0.7, 0.9}) {
    Scenario scene = one_robot({-10, 0}, {10, 0}, 0.1);
    scene.moving_obstacles = {mover({6, aside}, {-0.7, 0}, 0.4)};
    EXPECT_GE(watch(scene, 20.0).clearance, 0.15) << aside;
  }
}

// A mover that does as it likes within its bounds is met at rest, as before.
TEST(Evasion, lets_the_certificate_keep_its_promise) {
  test::Random random(36);
  for (int trial = 0; trial < 12; ++trial) {
    Scenario scene = crossing(random, 3, 0.3, 1.2, false, 0.1);
    for (MovingObstacle& m : scene.moving_obstacles) m.max_deviation = 0.5, m.max_speed = 1.5;
    Simulation simulation(scene, 1);
    Vec2 v;
    for (int step = 0; step < 300; ++step) {
      const Vec2 p = simulation.fleet().position[0];
      simulation.step();
      const bool moves = v != Vec2{} || simulation.fleet().velocity[0] != Vec2{};
      v = simulation.fleet().velocity[0];
      for (const MovingObstacle& m : scene.moving_obstacles) {
        const Vec2 c = m.position + (step * scene.time_step) * m.velocity;
        EXPECT_TRUE(!moves || norm(p - c) >= m.radius + 0.4) << trial << ", step " << step;
      }
    }
  }
}

}  // namespace
}  // namespace avo
