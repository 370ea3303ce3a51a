// SPDX-License-Identifier: Apache-2.0
// Robots have clocks of their own, and measurements of the past. These tests check the instant of
// each measurement, and that the declared bounds cover it. No robot touches another one, and a run
// is the same however it is made.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "avo/assumptions.h"
#include "avo/check.h"
#include "avo/checked.h"
#include "avo/error.h"
#include "avo/simulation.h"
#include "certificate/pair.h"
#include "robots/model.h"
#include "sim/sensing/senses.h"
#include "support/refusal.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::Random;
using test::refusal;
using test::robot_at;

constexpr double kSteps[] = {0.1, 0.04, 0.07};  // s

SensingModel late(int delay, double dropped, double position = 0.0, double velocity = 0.0) {
  SensingModel model;
  model.delay = delay, model.dropped = dropped;
  model.noise.position = position, model.noise.velocity = velocity;
  return model;
}

// On a circle, each to the other side; they decide 10, 25 and 14 times a second.
Scenario crossing(int robots, const SensingModel& sensing, std::uint64_t seed = 1) {
  Scenario scene;
  scene.clock = Clock::free;
  scene.seed = seed;
  scene.sensing_radius = 40.0;
  scene.sensing = sensing;
  const double far = std::max(5.0, 0.35 * robots);
  for (int k = 0; k < robots; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / robots;
    const Vec2 place{far * std::cos(angle), far * std::sin(angle)};
    scene.robots.push_back(robot_at(place, -1.0 * place));
    scene.robots.back().time_step = kSteps[k % 3];
  }
  return scene;
}

// Where holonomic robots were: between two instants of the simulation accelerations are held.
class Past {
 public:
  void note(const Simulation& simulation) {
    const FleetView fleet = simulation.fleet();
    rows_[simulation.time()] = {{fleet.position.begin(), fleet.position.end()},
                                {fleet.velocity.begin(), fleet.velocity.end()}};
  }
  [[nodiscard]] PastState at(std::size_t robot, double time) const {
    auto next = rows_.lower_bound(time - 1e-10);
    if (std::abs(next->first - time) < 1e-10 || next == rows_.begin())
      return {next->second.first[robot], next->second.second[robot]};
    const auto last = std::prev(next);
    const double t = time - last->first, all = next->first - last->first;
    const Vec2 p = last->second.first[robot], v = last->second.second[robot];
    const Vec2 a = (next->second.second[robot] - v) / all;
    return {p + t * v + (0.5 * t * t) * a, v + t * a};
  }

 private:
  std::map<double, std::pair<std::vector<Vec2>, std::vector<Vec2>>> rows_;
};

TEST(LateClocks, measurements_are_as_old_as_the_scene_says) {
  Scenario scene = crossing(9, late(2, 0.0));
  scene.time_step = 0.06;
  scene.moving_obstacles = {{{4.0, 9.0}, {0.0, -1.0}, {0.1, 0.2}, 0.4}};
  Simulation simulation(scene, 1);
  Past past;
  int seen_late = 0;
  while (simulation.can_step_by(3.0)) {
    past.note(simulation);
    const double now = simulation.time(), then = std::max(now - 0.12, 0.0);
    for (const std::size_t observer : {0U, 1U, 2U}) {
      const Simulation::Perception seen = simulation.perceive({observer});
      ASSERT_EQ(seen.neighbors.size(), 9U);
      for (std::size_t k = 0; k < seen.neighbors.size(); ++k) {
        const Neighbor& neighbor = seen.neighbors[k];
        EXPECT_EQ(neighbor.age, 0);  // it is declared
        if (seen.source[k] < 0) {
          EXPECT_LT(norm(neighbor.position - simulation.moving_obstacles().position[0]), 1e-12);
          continue;
        }
        const PastState was = past.at(static_cast<std::size_t>(seen.source[k]), then);
        EXPECT_LT(norm(neighbor.velocity - was.velocity), 1e-9);
        EXPECT_LT(norm(neighbor.position - (was.position + (now - then) * was.velocity)), 1e-9);
        seen_late += norm(neighbor.velocity) > 0.5 ? 1 : 0;
      }
    }
    simulation.step();
  }
  EXPECT_GT(seen_late, 1000);
}

// Each try of a robot fails by itself, one of its own steps after the other; the age counts those.
TEST(LateClocks, missed_ones_are_carried_on_by_steps_of_the_observers_own) {
  const Scenario scene = crossing(9, late(1, 0.6));
  Simulation simulation(scene, 1);
  Past past;
  double missed = 0.0, all = 0.0;
  int oldest = 0;
  while (simulation.can_step_by(8.0)) {
    past.note(simulation);
    const double now = simulation.time();
    for (std::size_t i = 0; i < 9; ++i) {
      if (simulation.next_decision({i}) != now || now < 1.5) continue;
      const Simulation::Perception seen = simulation.perceive({i});
      all += 8.0, missed += 8.0 - static_cast<double>(seen.neighbors.size());
      for (std::size_t k = 0; k < seen.neighbors.size(); ++k) {
        const Neighbor& neighbor = seen.neighbors[k];
        ASSERT_LE(neighbor.age, kMostCarried);
        oldest = std::max(oldest, neighbor.age);
        missed += neighbor.age > 0 ? 1.0 : 0.0;
        const double ago = 0.1 + neighbor.age * *scene.robots[i].time_step;
        const PastState was = past.at(static_cast<std::size_t>(seen.source[k]), now - ago);
        EXPECT_LT(norm(neighbor.position - (was.position + ago * was.velocity)), 1e-9) << ago;
        EXPECT_LT(norm(neighbor.velocity - was.velocity), 1e-9);
      }
    }
    simulation.step();
  }
  EXPECT_NEAR(missed / all, 0.6, 0.02);
  EXPECT_GT(oldest, 7);
}

// What is missed stays missed: each decision sees what the one before it saw of the same moment.
TEST(LateClocks, a_track_goes_on_from_the_measurement_that_it_had) {
  const Scenario scene = crossing(3, late(0, 0.5, 0.05, 0.1));
  Simulation simulation(scene, 1);
  std::map<std::int64_t, Neighbor> before;
  int carried = 0;
  while (simulation.can_step_by(20.0)) {
    if (simulation.next_decision({0}) == simulation.time()) {
      const Simulation::Perception seen = simulation.perceive({0});
      for (std::size_t k = 0; k < seen.neighbors.size(); ++k) {
        const Neighbor& now = seen.neighbors[k];
        if (now.age > 0 && before.contains(seen.source[k])) {
          const Neighbor& was = before[seen.source[k]];
          EXPECT_EQ(now.age, was.age + 1);
          EXPECT_EQ(now.velocity, was.velocity);
          EXPECT_LT(norm(now.position - (was.position + 0.1 * was.velocity)), 1e-9);
          ++carried;
        }
        before[seen.source[k]] = now;
      }
    }
    simulation.step();
  }
  EXPECT_GT(carried, 100);
}

TEST(LateClocks, walls_hide_for_as_many_steps_of_the_observers_own) {
  Scenario scene;
  scene.clock = Clock::free;
  scene.robots = {robot_at({-8.3, 4.0}, {8.3, 4.0}), robot_at({0.0, -4.0}, {0.0, -4.0})};
  scene.robots[1].time_step = 0.025;
  scene.obstacles.push_back({{{{{-3.0, 0.0}, {3.0, 0.0}}, false}}, 0.0});
  scene.sensing.occlusion = true;
  Simulation simulation(scene, 1);
  int hidden[2] = {0, 0}, forgotten[2] = {0, 0};
  for (; simulation.can_step_by(12.0); simulation.step()) {
    const FleetView fleet = simulation.fleet();
    const Vec2 a = fleet.position[0], b = fleet.position[1];
    const bool is_hidden = std::abs(a.x + (b.x - a.x) * a.y / (a.y - b.y)) <= 3.0;
    for (const std::size_t observer : {0U, 1U}) {
      if (simulation.next_decision({observer}) != simulation.time()) continue;
      hidden[observer] = is_hidden ? hidden[observer] + 1 : 0;
      const Simulation::Perception seen = simulation.perceive({observer});
      ASSERT_EQ(seen.neighbors.size(), hidden[observer] <= kMostCarried ? 1U : 0U);
      if (seen.neighbors.empty())
        ++forgotten[observer];
      else
        EXPECT_EQ(seen.neighbors[0].age, hidden[observer]);
    }
  }
  EXPECT_GT(forgotten[0], 5);
  EXPECT_GT(forgotten[1], 50);
}

// Robots of all kinds: what is declared, and what ages and swings add, covers where everybody is.
TEST(LateClocks, bounds_cover_where_everybody_is) {
  double most = 0.0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Scenario scene = crossing(9, late(static_cast<int>(seed % 3), 0.5, 0.01, 0.02), seed);
    for (std::size_t k = 0; k < scene.robots.size(); ++k) {
      if (k % 3 == 1) continue;
      const double e = k % 2 == 0 ? 0.8 : -0.8;
      Car car{.wheelbase = 1.0, .body = CarBody{e, 0.9}};
      if (seed % 2 == 0) car.max_curvature = 0.8;
      if (k == 3) car.body.reset(), car.acceleration_set = AccelerationSet::exact;
      scene.robots[k].model = car;
      scene.robots[k].heading = 1.1 * static_cast<double>(k);
    }
    Simulation simulation(scene, 1);
    for (; simulation.can_step_by(12.0); simulation.step()) {
      const FleetView fleet = simulation.fleet();
      for (std::size_t i = 0; i < fleet.id.size(); ++i) {
        if (simulation.next_decision({i}) != simulation.time()) continue;
        StepLaw law;
        law.time_step = *scene.robots[i].time_step;
        law.sensing_error = declared_error(scene);
        const Simulation::Perception seen = simulation.perceive({i});
        for (std::size_t k = 0; k < seen.neighbors.size(); ++k) {
          const auto other = static_cast<std::size_t>(seen.source[k]);
          const Vec2 place =
              disc_center(fleet.setup[other].model, fleet.position[other], fleet.heading[other]);
          const auto [position, velocity] = error_against(seen.neighbors[k], law);
          most = std::max({most, norm(seen.neighbors[k].position - place) / position,
                           norm(seen.neighbors[k].velocity - fleet.velocity[other]) / velocity});
        }
      }
    }
  }
  EXPECT_LE(most, 1.0 + 1e-9);
  EXPECT_GT(most, 0.5);
}

// Everybody to one point, for ever.
Scenario crush(int robots, const SensingModel& sensing, std::uint64_t seed) {
  Scenario scene = crossing(robots, sensing, seed);
  Random random(seed);
  for (RobotSetup& robot : scene.robots) {
    robot.goal = {random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3)};
    robot.radius = random.uniform(0.3, 0.6);
    robot.max_speed = robot.preferred_speed = random.uniform(0.8, 2.0);
    robot.max_acceleration = random.uniform(0.5, 2.0);
    robot.max_braking = robot.max_acceleration * random.uniform(0.5, 1.0);
  }
  return scene;
}

CheckReport judged_among_walls(const Scenario& scene, double duration) {
  std::vector<CheckedRobot> robots;
  for (const RobotSetup& setup : scene.robots) {
    robots.push_back(checked_robot(setup));
    robots.back().time_step = time_step_of(scene, setup);
    robots.back().goal.reset();
  }
  Check check(robots);
  std::vector<CheckedWall> walls;
  for (const Wall& wall : walls_of(scene.obstacles)) walls.push_back({wall.a, wall.b, wall.radius});
  check.set_walls(walls);
  Simulation simulation(scene, 1);
  check.add(0.0, checked_states(simulation.fleet()));
  while (simulation.can_step_by(duration)) {
    simulation.step();
    check.add(simulation.time(), checked_states(simulation.fleet()));
  }
  return check.report();
}

TEST(LateClocks, in_a_crush_nobody_touches_anybody) {
  std::int64_t steps = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const SensingModel model =
        late(static_cast<int>(seed % 4), 0.05 * static_cast<double>(seed % 3),
             seed % 2 == 0 ? 0.01 : 0.0, seed % 2 == 0 ? 0.03 : 0.0);
    const Scenario scene = crush(14, model, seed);
    ASSERT_TRUE(broken_assumptions(scene).none());
    const CheckReport report = judged_among_walls(scene, 25.0);
    EXPECT_TRUE(report.safe()) << seed << ": " << report.overlaps.count << " overlaps, "
                               << report.changes.count << " changes";
    steps += report.robot_steps;
  }
  EXPECT_GT(steps, 100000);
}

// The same delay undeclared, so that the test above would notice.
TEST(LateClocks, what_is_not_declared_makes_contact) {
  std::int64_t overlaps = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Scenario scene = crush(14, late(3, 0.0), seed);
    scene.sensing_error = SensingError{};
    overlaps += judged_among_walls(scene, 15.0).overlaps.count;
  }
  EXPECT_GT(overlaps, 0);
}

TEST(LateClocks, decisions_are_made_of_what_perceive_tells) {
  Scenario scene = crossing(12, late(1, 0.2, 0.02, 0.05));
  scene.sensing.occlusion = true;
  scene.obstacles.push_back({{{{{-3.0, 0.5}, {-3.0, 3.0}}, false}}, 0.0});
  scene.navigation = false;
  Simulation simulation(scene, 1);
  PlanWorkspace workspace;
  for (; simulation.can_step_by(6.0); simulation.step()) {
    for (std::size_t i = 0; i < 12; ++i) {
      if (simulation.next_decision({i}) != simulation.time()) continue;
      Simulation::Perception seen = simulation.perceive({i});
      const Plan expected = simulation.planner({i}).plan(seen.robot, seen.neighbors, workspace,
                                                         &seen.detour, seen.walls);
      Simulation next(simulation.save(), 1);
      next.step();
      ASSERT_EQ(next.fleet().plan[i].new_velocity, expected.new_velocity) << i;
      break;  // one of them is enough at each instant
    }
  }
}

Scenario of_all_kinds(int robots) {
  Scenario scene = crossing(robots, late(2, 0.2, 0.01, 0.02));
  scene.sensing.occlusion = true;
  scene.obstacles.push_back({{{{{-0.5, 0.5}, {-0.5, 3.0}}, false}}, 0.0});
  for (std::size_t k = 0; k < scene.robots.size(); k += 4) {
    scene.robots[k].model = Car{.max_curvature = 0.8, .body = CarBody{0.3, 0.6}};
    scene.robots[k].heading = 0.7 * static_cast<double>(k);
  }
  return scene;
}

TEST(LateClocks, every_number_of_threads_gives_the_same_bits) {
  const Scenario scene = of_all_kinds(280);
  Simulation one(scene, 1), two(scene, 2), three(scene, 3);
  for (int k = 0; k < 200; ++k) {
    one.step(), two.step(), three.step();
    if (k % 20 != 0) continue;
    ASSERT_EQ(one.state_hash(), two.state_hash()) << k;
    ASSERT_EQ(one.state_hash(), three.state_hash()) << k;
  }
}

TEST(LateClocks, what_is_remembered_is_saved_and_belongs_to_the_state) {
  const Scenario scene = of_all_kinds(12);
  Simulation original(scene, 1), used(scene, 1);
  for (int k = 0; k < 9; ++k) used.step();
  for (int k = 0; k < 150; ++k) {
    original.step();
    if (k == 40) original.remove_robot({5});
    if (k == 60) original.move_robot({6}, {40.0, 3.0});
    if (k == 80) {
      RobotSetup setup = robot_at({45.0, 0.0}, {-9.0, -9.0});
      setup.time_step = 0.05;
      original.add_robot(setup);
    }
    if (k % 10 != 3) continue;
    const std::vector<std::byte> saved = original.save();
    Simulation ahead(saved, 1), fresh(saved, 2);
    used.restore(saved);
    for (int step = 0; step < 40; ++step) {
      ASSERT_EQ(ahead.state_hash(), fresh.state_hash()) << k << ' ' << step;
      ASSERT_EQ(ahead.state_hash(), used.state_hash()) << k << ' ' << step;
      ahead.step(), fresh.step(), used.step();
    }
    EXPECT_EQ(ahead.save(), fresh.save());
  }
  Simulation again(original.save(), 1);
  for (int k = 0; k < 100; ++k) original.step(), again.step();
  EXPECT_EQ(original.state_hash(), again.state_hash());
}

TEST(LateClocks, a_past_that_differs_is_another_state) {
  Simulation simulation(crossing(3, late(3, 0.0)), 1), other(crossing(3, late(3, 0.0)), 1);
  const RobotSetup setup = robot_at({90.0, 0.0}, {90.0, 0.0});
  simulation.add_robot(setup);
  for (int k = 0; k < 5; ++k) simulation.step(), other.step();
  other.add_robot(setup);
  EXPECT_NE(simulation.state_hash(), other.state_hash());
}

TEST(LateClocks, whoever_comes_late_has_to_be_seen_from_farther_away) {
  Scenario scene = crossing(3, {});
  const double need = sensing_need(scene)->range;
  scene.sensing.delay = 2;
  EXPECT_NEAR(sensing_need(scene)->range, need + 2 * 2.0 * 0.2, 1e-12);
  scene.sensing.dropped = 0.1;  // the robot that decides most seldom counts
  EXPECT_NEAR(sensing_need(scene)->range, need + 2 * 2.0 * (0.2 + 0.1 * kMostCarried), 1e-12);
}

TEST(LateClocks, what_the_rest_of_a_step_adds_is_declared_besides) {
  Scenario scene = crossing(3, late(2, 0.0, 0.02, 0.05));
  scene.sensing.noise.distribution = NoiseDistribution::uniform;
  const double both = std::sqrt(2.0);
  const SensingError late = declared_error(scene);
  EXPECT_NEAR(late.velocity, both * 0.05 + 0.2, 1e-12);
  EXPECT_NEAR(late.position, both * (0.02 + 0.2 * 0.05) + 0.5 * 0.04, 1e-12);
  scene.robots[0].model = Car{.acceleration_set = AccelerationSet::exact};
  const SensingError exact = declared_error(scene);
  EXPECT_NEAR(exact.velocity, both * 0.05 + both * 0.2 + (both - 1.0) * 0.1, 1e-12);
  EXPECT_NEAR(exact.position,
              both * (0.02 + 0.2 * 0.05) + both * 0.5 * 0.04 + (both - 1.0) * 0.5 * 0.01, 1e-12);
}

TEST(LateClocks, a_memory_without_end_is_refused) {
  Scenario scene = crossing(3, late(100, 0.0));
  EXPECT_EQ(refusal(scene), "");
  scene.robots[1].time_step = 1e-4;
  EXPECT_EQ(refusal(scene),
            "robots.1.time_step: found 1e-04, must be >= 0.000152587890625 s, of "
            "which 65536 are in the 10 s that sensing looks back");
}

}  // namespace
}  // namespace avo
