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
#include "scenes.h"
#include "support/generators.h"

namespace avo {
namespace {

using test::robot_at;

MovingObstacle mover(Vec2 position, Vec2 velocity, double radius) {
  MovingObstacle result;
  result.position = position, result.velocity = velocity, result.radius = radius;
  return result;
}

Scenario one_robot(Vec2 position, Vec2 goal, double time_step) {
  Scenario scene;
  scene.time_step = time_step;
  scene.sensing_radius = 60.0;
  scene.robots = {robot_at(position, goal)};
  scene.robots[0].radius = 0.4;
  return scene;
}

// Movers that cross the way of the robot, or pass over where it rests.
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

// Between two walls there is no way aside; a niche is one.
TEST(Evasion, among_walls) {
  Scenario scene = one_robot({0, 0}, {0, 0}, 0.1);
  scene.obstacles = {
      {.chains = {{{{-20, 1.0}, {-2.5, 1.0}, {-2.5, 3.0}, {-1.0, 3.0}, {-1.0, 1.0}, {20, 1.0}}}}},
      {.chains = {{{{-20, -1.0}, {20, -1.0}}}}}};
  scene.moving_obstacles = {mover({9, 0}, {-1, 0}, 0.55)};
  EXPECT_GE(watch(scene, 24.0).clearance, 0.0);
}

// A mover that is wider than the way that braking from v_max takes: beside a wall, A goes as far as
// walls are known.
TEST(Evasion, of_a_wide_mover_beside_a_wall) {
  Scenario scene = one_robot({0, 0}, {0, 0}, 0.1);
  scene.obstacles = {{.chains = {{{{-40, 1.0}, {40, 1.0}}}}}};
  scene.moving_obstacles = {mover({20, -1.5}, {-1, 0}, 4.0)};
  EXPECT_GE(watch(scene, 40.0).clearance, 0.0);
}

// Where others stand in the way of the first steps of all ways, what they admit is taken.
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

// Twice as far ahead as towards those who do their share, and by half of its radius.
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

// One that goes to and fro between two points or more, from anywhere on its way.
MovingObstacle to_and_fro(test::Random& random, double x) {
  const double tilt = random.uniform(-1.5, 1.5), length = random.uniform(3.0, 6.0);
  const double middle = random.uniform(-1.5, 1.5), speed = random.uniform(0.8, 2.0);
  const Vec2 a{x - tilt, middle - length}, b{x + tilt, middle + length};
  const Vec2 along = (b - a) / norm(b - a);
  MovingObstacle m = mover(a + random.uniform(0.0, 1.0) * (b - a), (0.9 * speed) * along,
                           random.uniform(0.3, 1.0));
  m.max_deviation = random.uniform(0.7, 2.0), m.max_speed = speed;
  m.path = {b, a};
  if (random.below(2) == 0) std::swap(m.path[0], m.path[1]), m.velocity = -m.velocity;
  if (random.below(4) == 0) m.path.insert(m.path.begin() + 1, {x + random.uniform(-2, 2), middle});
  return m;
}

// Across the way of the robots.
Scenario among_paths(test::Random& random, int count, double time_step) {
  Scenario scene = one_robot({-10, 0}, {10, 0}, time_step);
  scene.sensing_radius = 20.0;
  for (int k = 0; k < count; ++k)
    scene.moving_obstacles.push_back(
        to_and_fro(random, -6.0 + 12.0 * (k + random.uniform(0.2, 0.8)) / count));
  return scene;
}

// m, least room beside movers on their paths; infinite where a robot has not arrived.
double room_beside_paths(const Scenario& scene) {
  Simulation simulation(scene, 1);
  const double h = scene.time_step;
  std::vector<PathWalk> walks;
  for (const MovingObstacle& m : scene.moving_obstacles) walks.push_back({m.position, m.velocity});
  double least = std::numeric_limits<double>::infinity();
  for (double time = 0.0; time < 60.0; time += h) {
    const FleetView before = simulation.fleet();
    const std::vector<Vec2> p(before.position.begin(), before.position.end());
    const std::vector<Vec2> v(before.velocity.begin(), before.velocity.end());
    simulation.step();
    for (std::size_t j = 0; j < walks.size(); ++j) {
      const PathWalk walk = walks[j];
      walks[j] = next_on_path(scene.moving_obstacles[j], walk, h);
      for (std::size_t i = 0; i < p.size(); ++i) {
        const Vec2 change =
            simulation.fleet().velocity[i] - v[i] - walks[j].velocity + walk.velocity;
        for (int part = 1; part <= 16; ++part) {
          const double t = h * part / 16.0;
          const Vec2 apart =
              p[i] - walk.position + t * (v[i] - walk.velocity) + (0.5 * t * t / h) * change;
          least = std::min(least,
                           norm(apart) - scene.moving_obstacles[j].radius - scene.robots[i].radius);
        }
      }
    }
  }
  EXPECT_TRUE(simulation.all_at_goal());
  return least;
}

// By its velocity alone such a mover leaves for ever, and its limits stop the robot in its way.
TEST(Evasion, nobody_is_hit_by_movers_that_come_back_on_their_paths) {
  for (const double y : {0.0, 1.0, 2.0}) {
    Scenario scene = one_robot({-10, y}, {10, y}, 0.1);
    scene.sensing_radius = 20.0;
    for (const Vec2 p : {Vec2{-2, -4}, Vec2{3, 4}}) {
      MovingObstacle m = mover(p, {0, p.y < 0.0 ? 1.0 : -1.0}, 1.0);
      m.max_deviation = 1.0, m.max_speed = 1.5, m.path = {{p.x, -p.y}, p};
      scene.moving_obstacles.push_back(m);
    }
    EXPECT_GE(room_beside_paths(scene), 0.0) << y;
  }
  test::Random random(38);
  for (const double time_step : {0.1, 0.05, 0.2}) {
    for (int trial = 0; trial < 8; ++trial)
      EXPECT_GE(room_beside_paths(among_paths(random, 1 + trial % 4, time_step)), 0.0)
          << time_step << " s, " << trial;
  }
}

// What is known of the future is no part of what is saved: it is found anew, to the last bit.
TEST(Evasion, knows_paths_when_it_is_restored) {
  test::Random random(39);
  for (int trial = 0; trial < 4; ++trial) {
    Simulation simulation(among_paths(random, 3, 0.1), 1);
    for (int step = 10 + 31 * trial; step > 0; --step) simulation.step();
    Simulation restored(simulation.save(), 1);
    for (int step = 0; step < 150; ++step) {
      const Simulation::Perception seen = restored.perceive(0);
      ASSERT_FALSE(seen.neighbors.empty());
      EXPECT_NE(seen.neighbors[0].trajectory, nullptr);
      simulation.step(), restored.step();
      ASSERT_EQ(simulation.state_hash(), restored.state_hash()) << trial << ", step " << step;
    }
  }
}

// On board: others are predicted with corners in time, at times that are no steps of the robot's.
TEST(Evasion, of_movers_whose_trajectories_are_predicted) {
  test::Random random(40);
  const Planner planner(PlannerOptions{});
  PlanWorkspace workspace;
  int turned = 0;
  for (int trial = 0; trial < 60; ++trial) {
    Robot robot{.position = {-6, 0}, .radius = 0.4};
    std::vector<Trajectory> trajectories;
    for (int k = 0; k < 2; ++k) {
      std::vector<TimedPlace> places{{-1.0, random.uniform(4.0, 9.0) * random.direction()}};
      if (norm(places[0].position - robot.position) < 4.0) places[0].position.x += 8.0;
      for (int leg = 0; leg < 5; ++leg) {
        const double lasts = random.uniform(0.7, 4.0);
        const Vec2 v = random.uniform(0.0, 1.8) * random.direction();
        places.push_back({places.back().time + lasts, places.back().position + lasts * v});
      }
      trajectories.emplace_back(places);
    }
    Detour detour;
    double least = std::numeric_limits<double>::infinity();
    bool was_safe = true;
    for (int step = 0; step < 250; ++step) {
      const double now = 0.1 * step;
      std::vector<Neighbor> neighbors;
      for (const Trajectory& trajectory : trajectories) {
        const Vec2 p = trajectory.at(now);
        neighbors.push_back({.position = p,
                             .velocity = (trajectory.at(now + 1e-6) - p) / 1e-6,
                             .radius = 0.6,
                             .behavior = Behavior::moves_on,
                             .trajectory = &trajectory,
                             .trajectory_time = now});
      }
      const Vec2 way = Vec2{6, 0} - robot.position;
      robot.preferred_velocity = std::min(1.0, 2.0 / std::max(norm(way), 1e-9)) * way;
      if (norm(robot.preferred_velocity) > 2.0)
        robot.preferred_velocity =
            (2.0 / norm(robot.preferred_velocity)) * robot.preferred_velocity;
      robot.distance_to_goal = norm(way);
      const Plan plan = planner.plan(robot, neighbors, workspace, &detour);
      if (step == 0) was_safe = plan.status != PlanStatus::overlapping;
      for (int part = 1; part <= 8; ++part) {
        const double t = 0.1 * part / 8.0;
        const Vec2 at = robot.position + t * robot.velocity +
                        (0.5 * t * t / 0.1) * (plan.next_velocity - robot.velocity);
        for (const Trajectory& trajectory : trajectories)
          least = std::min(least, norm(at - trajectory.at(now + t)) - 1.0);
      }
      robot.position = robot.position + 0.05 * (robot.velocity + plan.next_velocity);
      robot.velocity = plan.next_velocity;
    }
    EXPECT_TRUE(was_safe) << trial;
    EXPECT_GE(least, 0.0) << trial;
    turned += least < 0.4 ? 1 : 0;
  }
  EXPECT_GT(turned, 10) << "most are met";
}

}  // namespace
}  // namespace avo
