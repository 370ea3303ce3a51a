// SPDX-License-Identifier: Apache-2.0
// These tests check what a scene's sensing makes of true states. Noise stays within its bounds,
// measurements are late, missed ones are carried on, and walls hide neighbors. The results are the
// same whichever caller asks, and errors are declared.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "avo/assumptions.h"
#include "avo/error.h"
#include "certificate/pair.h"
#include "core/elementary.h"
#include "core/hash.h"
#include "robots/model.h"
#include "unit/sim/judged.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::Random;
using test::robot_at;

// So many robots on their ways through each other, none of which is out of sight of another one.
Scenario crossing(int robots, const SensingModel& sensing) {
  Scenario scene;
  scene.sensing_radius = 30.0;
  scene.sensing = sensing;
  scene.duration = 30.0;
  for (int k = 0; k < robots; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / robots;
    const double far = std::max(5.0, 0.3 * robots);
    const Vec2 place{far * std::cos(angle), far * std::sin(angle)};
    scene.robots.push_back(robot_at(place, -place));
  }
  return scene;
}

SensingModel noisy(double position, double velocity,
                   NoiseDistribution distribution = NoiseDistribution::gaussian,
                   std::optional<double> truncated = {}) {
  SensingModel model;
  model.noise = {position, velocity, distribution, truncated};
  return model;
}

// These are errors of each coordinate of each neighbor in 25 steps, in units of the noise.
struct Errors {
  std::vector<double> position, velocity;
};
Errors errors_of(const Scenario& scene) {
  Simulation simulation(scene, 1);
  Errors errors;
  for (int step = 0; step < 25; ++step, simulation.step()) {
    const FleetView fleet = simulation.fleet();
    for (std::size_t i = 0; i < fleet.id.size(); ++i) {
      const Simulation::Perception seen = simulation.perceive({i});
      for (std::size_t k = 0; k < seen.neighbors.size(); ++k) {
        const auto other = static_cast<std::size_t>(seen.source[k]);
        const Vec2 p = seen.neighbors[k].position - fleet.position[other];
        const Vec2 v = seen.neighbors[k].velocity - fleet.velocity[other];
        for (const double e : {p.x, p.y})
          errors.position.push_back(e / scene.sensing.noise.position);
        for (const double e : {v.x, v.y})
          errors.velocity.push_back(e / scene.sensing.noise.velocity);
      }
    }
  }
  return errors;
}

struct Moments {
  double mean = 0.0, deviation = 0.0, most = 0.0, beyond_one = 0.0;
};
Moments moments_of(const std::vector<double>& numbers) {
  Moments moments;
  const auto count = static_cast<double>(numbers.size());
  for (const double x : numbers) {
    moments.mean += x / count;
    moments.deviation += x * x / count;
    moments.most = std::max(moments.most, std::abs(x));
    moments.beyond_one += (std::abs(x) > 1.0 ? 1.0 : 0.0) / count;
  }
  moments.deviation = std::sqrt(moments.deviation);
  return moments;
}

TEST(Senses, gaussian_noise_is_cut_off_where_the_scene_says) {
  const Errors errors = errors_of(crossing(20, noisy(0.02, 0.05)));
  for (const std::vector<double>* numbers : {&errors.position, &errors.velocity}) {
    const Moments all = moments_of(*numbers);
    EXPECT_NEAR(all.mean, 0.0, 0.03);
    EXPECT_NEAR(all.deviation, 0.987, 0.02);  // of a normal density cut off at 3
    EXPECT_NEAR(all.beyond_one, (0.317311 - 0.0027) / 0.9973, 0.015);
    EXPECT_GT(all.most, 2.8);
    EXPECT_LE(all.most, 3.0 + 1e-9);
  }
  const Scenario narrow = crossing(20, noisy(0.02, 0.05, NoiseDistribution::gaussian, 1.5));
  EXPECT_LE(moments_of(errors_of(narrow).position).most, 1.5 + 1e-9);
}

// Draws in pairs, one pair after the other, each held against the exponential function itself.
class DrawsOneByOne {
 public:
  DrawsOneByOne(std::uint64_t seed, std::int64_t step, RobotId observer, RobotId other)
      : key_(mixed(0, seed)) {
    for (const std::uint64_t word : {static_cast<std::uint64_t>(step), observer.value, other.value})
      key_ = mixed(key_, word);
  }

  double gaussian(double most) {
    for (;;) {
      const double x = most * (2.0 * uniform() - 1.0);
      if (uniform() < 1.0 + elementary::expm1(-0.5 * x * x)) return x;
    }
  }

 private:
  double uniform() { return 0x1p-53 * static_cast<double>(mixed(key_, ++count_) >> 11); }

  std::uint64_t key_, count_ = 0;  // number 0 tells whether it is missed
};

TEST(Senses, gaussian_noise_is_that_of_drawing_one_after_the_other) {
  for (const double most : {0.5, 3.0, 8.0}) {
    Scenario scene = crossing(60, noisy(0.02, 0.05, NoiseDistribution::gaussian, most));
    scene.seed = 7;
    Simulation simulation(scene, 1);
    for (int step = 0; step < 3; ++step, simulation.step()) {
      const FleetView fleet = simulation.fleet();
      for (std::size_t i = 0; i < fleet.id.size(); ++i) {
        const Simulation::Perception seen = simulation.perceive({i});
        ASSERT_GT(seen.neighbors.size(), 10U);
        for (std::size_t k = 0; k < seen.neighbors.size(); ++k) {
          const auto other = static_cast<std::size_t>(seen.source[k]);
          DrawsOneByOne draws(7, step, fleet.id[i], fleet.id[other]);
          const auto off = [&](double scale) {
            const double x = draws.gaussian(most);
            return scale * Vec2{x, draws.gaussian(most)};
          };
          EXPECT_EQ(seen.neighbors[k].position, fleet.position[other] + off(0.02));
          EXPECT_EQ(seen.neighbors[k].velocity, fleet.velocity[other] + off(0.05));
        }
      }
    }
  }
}

TEST(Senses, uniform_noise_stays_within_what_is_given) {
  const Errors errors = errors_of(crossing(20, noisy(0.02, 0.05, NoiseDistribution::uniform)));
  for (const std::vector<double>* numbers : {&errors.position, &errors.velocity}) {
    const Moments all = moments_of(*numbers);
    EXPECT_NEAR(all.deviation, 1.0 / std::sqrt(3.0), 0.01);
    EXPECT_GT(all.most, 0.99);
    EXPECT_LE(all.most, 1.0 + 1e-9);
  }
}

TEST(Senses, states_come_as_many_steps_late_as_the_scene_says) {
  SensingModel model;
  model.delay = 3;
  Scenario scene = crossing(8, model);
  scene.moving_obstacles = {{{4.0, 9.0}, {0.0, -1.0}, {0.1, 0.2}, 0.4}};
  Simulation simulation(scene, 1);
  std::vector<std::vector<Vec2>> position, velocity;  // by step and id
  for (int step = 0; step < 30; ++step, simulation.step()) {
    if (step == 12) simulation.remove_robot({4});
    const FleetView fleet = simulation.fleet();
    position.emplace_back(8), velocity.emplace_back(8);
    for (std::size_t i = 0; i < fleet.id.size(); ++i) {
      position.back()[fleet.id[i].value] = fleet.position[i];
      velocity.back()[fleet.id[i].value] = fleet.velocity[i];
    }
    const int late = std::min(step, 3);
    const auto then = static_cast<std::size_t>(step - late);
    const Simulation::Perception seen = simulation.perceive({2});
    ASSERT_EQ(seen.neighbors.size(), step < 12 ? 8U : 7U);
    for (std::size_t k = 0; k < seen.neighbors.size(); ++k) {
      const Neighbor& neighbor = seen.neighbors[k];
      EXPECT_EQ(neighbor.age, 0);  // it is declared
      if (seen.source[k] < 0) {    // it keeps its acceleration: carried on, it is where it is
        EXPECT_EQ(neighbor.position, simulation.moving_obstacles().position[0]);
        continue;
      }
      const auto other = static_cast<std::size_t>(seen.source[k]);
      EXPECT_EQ(neighbor.velocity, velocity[then][other]);
      EXPECT_EQ(neighbor.position, position[then][other] + 0.1 * late * velocity[then][other]);
    }
  }
}

TEST(Senses, those_that_are_missed_are_carried_on_and_then_forgotten) {
  for (const double dropped : {0.3, 0.9}) {
    SensingModel model;
    model.dropped = dropped;
    const Scenario scene = crossing(10, model);
    Simulation simulation(scene, 1);
    std::vector<std::vector<Vec2>> position, velocity;
    double missed = 0.0, forgotten = 0.0, all = 0.0;
    for (int step = 0; step < 120; ++step, simulation.step()) {
      const FleetView fleet = simulation.fleet();
      position.emplace_back(fleet.position.begin(), fleet.position.end());
      velocity.emplace_back(fleet.velocity.begin(), fleet.velocity.end());
      for (std::size_t i = 0; i < 10; ++i) {
        const Simulation::Perception seen = simulation.perceive({i});
        if (step == 0) {
          EXPECT_EQ(seen.neighbors.size(), 9U);  // a start is known
        }
        all += step > 20 ? 9.0 : 0.0;
        forgotten += step > 20 ? 9.0 - static_cast<double>(seen.neighbors.size()) : 0.0;
        for (std::size_t k = 0; k < seen.neighbors.size(); ++k) {
          const int age = seen.neighbors[k].age;
          missed += step > 20 && age > 0 ? 1.0 : 0.0;
          ASSERT_LE(age, kMostCarried);
          const auto then = static_cast<std::size_t>(step - age);
          const auto other = static_cast<std::size_t>(seen.source[k]);
          EXPECT_EQ(seen.neighbors[k].position,
                    position[then][other] + 0.1 * age * velocity[then][other]);
        }
      }
    }
    EXPECT_NEAR(forgotten / all, std::pow(dropped, kMostCarried + 1), 0.05);
    EXPECT_NEAR((missed + forgotten) / all, dropped, 0.03);
  }
}

// A robot passes behind a wall and comes out again; another one stands.
Scenario behind_a_wall(bool occlusion) {
  Scenario scene;
  scene.robots = {robot_at({-8.3, 4.0}, {8.3, 4.0}), robot_at({0.0, -4.0}, {0.0, -4.0})};
  scene.obstacles.push_back({{{{{-3.0, 0.0}, {3.0, 0.0}}, false}}, 0.0});
  scene.sensing.occlusion = occlusion;
  return scene;
}

TEST(Senses, walls_hide_whoever_has_its_center_behind_them) {
  Simulation simulation(behind_a_wall(true), 1);
  int hidden = 0, carried = 0;
  for (int step = 0; step < 120; ++step, simulation.step()) {
    const FleetView fleet = simulation.fleet();
    const Vec2 a = fleet.position[0], b = fleet.position[1];
    const double crossing_x = a.x + (b.x - a.x) * a.y / (a.y - b.y);
    const bool is_hidden = std::abs(crossing_x) <= 3.0;
    hidden = is_hidden ? hidden + 1 : 0;
    for (const std::size_t observer : {0U, 1U}) {
      const Simulation::Perception seen = simulation.perceive({observer});
      ASSERT_EQ(seen.neighbors.size(), hidden <= kMostCarried ? 1U : 0U) << step;
      if (seen.neighbors.empty()) continue;
      EXPECT_EQ(seen.neighbors[0].age, hidden);
      carried += hidden > 0 ? 1 : 0;
    }
  }
  EXPECT_EQ(carried, 2 * kMostCarried);
  EXPECT_EQ(hidden, 0);  // it has come out
  Simulation sees_all(behind_a_wall(false), 1);
  for (int step = 0; step < 120; ++step, sees_all.step())
    EXPECT_EQ(sees_all.perceive({0}).neighbors.size(), 1U);
}

// Two that go round the tip of a wall, each to where the other one comes from.
TEST(Senses, at_first_sight_round_a_corner_it_may_be_too_late) {
  for (const bool occlusion : {false, true}) {
    Scenario scene;
    scene.robots = {robot_at({-0.8, -9.0}, {0.8, -9.0}), robot_at({0.8, -9.0}, {-0.8, -9.0})};
    scene.obstacles.push_back({{{{{0.0, -12.0}, {0.0, 0.0}}, false}}, 0.0});
    scene.sensing.occlusion = occlusion;
    Simulation simulation(scene, 1);
    int too_late = 0;
    for (int step = 0; step < 300; ++step) {
      simulation.step();
      for (const Plan& plan : simulation.fleet().plan)
        too_late += plan.status == PlanStatus::overlapping ? 1 : 0;
    }
    EXPECT_EQ(too_late > 0, occlusion);
  }
}

SensingModel all_at_once() {
  SensingModel model = noisy(0.02, 0.05);
  model.delay = 1;
  model.dropped = 0.2;
  model.occlusion = true;
  return model;
}

// Returns how many neighbors were carried on.
int expect_decisions_of_what_perceive_tells(Scenario scene) {
  int carried = 0;
  scene.obstacles.push_back({{{{{-3.0, 0.5}, {-3.0, 3.0}}, false}}, 0.0});
  scene.navigation = false;
  for (const Method method : {Method::avo, Method::avo_paper}) {
    scene.method = method;
    scene.max_neighbors = method == Method::avo ? std::nullopt : std::optional(7);
    Simulation simulation(scene, 1);
    for (int step = 0; step < 60 && !testing::Test::HasFailure(); ++step) {
      std::vector<Plan> expected;
      PlanWorkspace workspace;
      for (std::size_t i = 0; i < 30; ++i) {
        Simulation::Perception seen = simulation.perceive({i});
        for (const Neighbor& neighbor : seen.neighbors) carried += neighbor.age > 0 ? 1 : 0;
        expected.push_back(simulation.planner().plan(seen.robot, seen.neighbors, workspace,
                                                     &seen.detour, seen.walls));
      }
      simulation.step();
      for (std::size_t i = 0; i < 30; ++i) {
        EXPECT_EQ(simulation.fleet().plan[i].new_velocity, expected[i].new_velocity)
            << to_string(method) << ", robot " << i << ", step " << step;
      }
    }
  }
  return carried;
}

TEST(Senses, decisions_are_made_of_what_perceive_tells) {
  Scenario scene = crossing(30, all_at_once());
  scene.moving_obstacles = {{{4.0, 9.0}, {0.0, -1.0}, {}, 0.4}};
  EXPECT_GT(expect_decisions_of_what_perceive_tells(scene), 100);
}

// Most are seen as they are, and go into the columns at once; others have just vanished.
TEST(Senses, decisions_behind_walls_are_made_of_what_perceive_tells) {
  SensingModel model;
  model.occlusion = true;
  Scenario scene = crossing(30, model);
  for (const double y : {-6.0, -3.0, 3.0, 6.0})
    scene.obstacles.push_back({{{{{-1.0, y}, {1.0, y}}, false}}, 0.0});
  EXPECT_GT(expect_decisions_of_what_perceive_tells(scene), 100);
  for (std::size_t i = 0; i < scene.robots.size(); i += 5) scene.robots[i].priority = 2.0;
  EXPECT_GT(expect_decisions_of_what_perceive_tells(scene), 100);
}

TEST(Senses, neither_threads_nor_others_change_what_is_sensed) {
  Scenario scene = crossing(300, all_at_once());
  Simulation one(scene, 1), three(scene, 3);
  scene.seed = 2;
  Simulation other(scene, 1);
  for (int step = 0; step < 40; ++step) {
    one.step(), three.step(), other.step();
    ASSERT_EQ(one.state_hash(), three.state_hash()) << step;
  }
  EXPECT_NE(one.state_hash(), other.state_hash());
}

TEST(Senses, what_is_remembered_is_saved_and_belongs_to_the_state) {
  SensingModel late;
  late.delay = 2;
  for (const SensingModel& model : {all_at_once(), late, noisy(0.02, 0.05)}) {
    Scenario scene = crossing(12, model);
    scene.robots[3].max_acceleration = 2.5;
    scene.seed = 7;
    Simulation original(scene, 1), used(scene, 2);
    for (int step = 0; step < 23; ++step) original.step();
    for (int step = 0; step < 9; ++step) used.step();
    original.remove_robot({3});  // the strongest, for which all have allowed
    RobotSetup late_comer = robot_at({11.0, 9.0}, {-9.0, -9.0});
    original.add_robot(late_comer);
    original.step();
    const std::vector<std::byte> saved = original.save();
    used.restore(saved);
    Simulation fresh(saved, 1);
    EXPECT_EQ(fresh.planner().options().sensing_error, original.planner().options().sensing_error);
    for (int step = 0; step < 40; ++step) {
      ASSERT_EQ(original.state_hash(), used.state_hash()) << step;
      ASSERT_EQ(original.state_hash(), fresh.state_hash()) << step;
      original.step(), used.step(), fresh.step();
    }
    EXPECT_EQ(original.save(), fresh.save());
  }
}

TEST(Senses, two_that_came_at_different_times_are_of_different_states) {
  SensingModel late;
  late.delay = 2;
  for (const SensingModel& model : {late, noisy(0.02, 0.05)}) {
    const Scenario scene = crossing(4, model);
    Simulation early(scene, 1), later(scene, 1);
    const RobotSetup setup = robot_at({90.0, 0.0}, {90.0, 0.0});  // out of sight, at its goal
    early.add_robot(setup);
    for (int step = 0; step < 5; ++step) early.step(), later.step();
    later.add_robot(setup);
    EXPECT_EQ(early.state_hash() == later.state_hash(), model.delay == 0);
  }
}

TEST(Senses, robots_declare_what_covers_noise_and_delay) {
  Scenario scene = crossing(3, noisy(0.02, 0.05));
  const double both = std::sqrt(2.0);
  EXPECT_NEAR(planner_options(scene).sensing_error.position, 3.0 * both * 0.02, 1e-12);
  EXPECT_NEAR(planner_options(scene).sensing_error.velocity, 3.0 * both * 0.05, 1e-12);
  scene.sensing = noisy(0.02, 0.05, NoiseDistribution::uniform);
  EXPECT_NEAR(planner_options(scene).sensing_error.position, both * 0.02, 1e-12);
  scene.sensing.delay = 2;
  scene.robots[1].max_acceleration = 1.5;
  const SensingError late = planner_options(scene).sensing_error;
  EXPECT_NEAR(late.velocity, both * 0.05 + 1.5 * 0.2, 1e-12);
  EXPECT_NEAR(late.position, both * (0.02 + 0.2 * 0.05) + 0.5 * 1.5 * 0.04, 1e-12);
  scene.sensing_error = {0.01, 0.0};
  EXPECT_EQ(planner_options(scene).sensing_error, (SensingError{0.01, 0.0}));
  scene.sensing_error.reset();
  scene.certificate = Certificate::none;
  EXPECT_EQ(planner_options(scene).sensing_error, SensingError{});
  scene = crossing(3, {});
  EXPECT_EQ(planner_options(scene).sensing_error, SensingError{});
}

// A swing takes the place elsewhere, and not the velocity from which the car brakes. A slow car
// swings little. So no other robot has to allow for it.
TEST(Senses, a_car_that_comes_late_may_have_swung_as_far_as_it_can_turn) {
  SensingModel model = noisy(0.0, 0.05, NoiseDistribution::uniform);
  model.delay = 2;
  Scenario scene = crossing(3, model);
  const SensingError declared = planner_options(scene).sensing_error;
  scene.robots[1].model = Car{.max_curvature = 0.8, .body = CarBody{0.5, 0.6}};
  EXPECT_EQ(planner_options(scene).sensing_error, declared);
  Simulation simulation(scene, 1);
  for (int step = 0; step < 40; ++step, simulation.step()) {
    const Simulation::Perception seen = simulation.perceive({0});
    for (std::size_t k = 0; k < seen.neighbors.size(); ++k) {
      const Neighbor& neighbor = seen.neighbors[k];
      const double time = 0.1 * std::min(step, 2);
      const double speed = norm(neighbor.velocity) + std::sqrt(2.0) * 0.05 + time;
      const double turning = std::min(0.8 * std::min(speed, 2.0), std::sqrt(0.8));  // v κ, √(a κ)
      EXPECT_NEAR(neighbor.position_error, seen.source[k] == 1 ? 0.5 * turning * time : 0.0, 1e-12);
    }
  }
}

// Cars on their ways through each other, seen late and missed at times: what is declared, and what
// ages add to it, covers where their discs are, and without the swing it would not.
TEST(Senses, bounds_of_cars_cover_where_their_discs_have_swung) {
  for (const std::optional<double> curvature : {std::optional(0.8), std::optional<double>{}}) {
    SensingModel model;
    model.delay = 1, model.dropped = 0.5;
    Scenario scene = crossing(6, model);
    for (std::size_t k = 0; k < scene.robots.size(); ++k) {
      scene.robots[k].model = Car{1.0, curvature, CarBody{k % 2 == 0 ? 0.8 : -0.8, 0.9}};
      scene.robots[k].heading = 1.1 * static_cast<double>(k);
    }
    StepLaw law;
    law.time_step = scene.time_step, law.sensing_error = planner_options(scene).sensing_error;
    Simulation simulation(scene, 1);
    double most = 0.0, without = 0.0;  // of what is allowed for
    for (int step = 0; step < 200; ++step, simulation.step()) {
      const FleetView fleet = simulation.fleet();
      for (std::size_t i = 0; i < fleet.id.size(); ++i) {
        const Simulation::Perception seen = simulation.perceive({i});
        for (std::size_t k = 0; k < seen.neighbors.size(); ++k) {
          Neighbor neighbor = seen.neighbors[k];
          const auto other = static_cast<std::size_t>(seen.source[k]);
          const Vec2 place =
              disc_center(fleet.setup[other].model, fleet.position[other], fleet.heading[other]);
          const auto [position, velocity] = error_against(neighbor, law);
          const double off = norm(neighbor.position - place);
          most = std::max(
              {most, off / position, norm(neighbor.velocity - fleet.velocity[other]) / velocity});
          neighbor.position_error = 0.0;
          without = std::max(without, off / error_against(neighbor, law).position);
        }
      }
    }
    EXPECT_LE(most, 1.0 + 1e-9);
    if (curvature) {
      EXPECT_GT(without, 1.0);
    }
  }
}

TEST(Senses, what_comes_late_has_to_be_seen_from_farther_away) {
  Scenario scene = crossing(3, {});
  const double need = sensing_need(scene)->range;
  scene.sensing.delay = 2;
  EXPECT_NEAR(sensing_need(scene)->range, need + 2 * 2.0 * 0.2, 1e-12);
  scene.sensing.dropped = 0.1;
  EXPECT_NEAR(sensing_need(scene)->range, need + 2 * 2.0 * (0.2 + 0.1 * kMostCarried), 1e-12);
}

TEST(Senses, nobody_comes_who_is_too_strong_for_the_declared_delay) {
  SensingModel model = noisy(0.01, 0.02);
  model.delay = 1;
  Simulation simulation(crossing(3, model), 1);
  RobotSetup setup = robot_at({9.0, 9.0}, {0.0, 9.0});
  simulation.add_robot(setup);
  setup.position.x = 12.0;
  setup.max_acceleration = 1.1;
  try {
    simulation.add_robot(setup);
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "robot 4: sensing_error: found {position: 0.0564117, velocity: 0.194853}, must be "
                 "at most {position: 0.0559117, velocity: 0.184853}, what all have declared");
  }
}

TEST(Senses, nobody_comes_whose_disc_moves_as_nobody_has_declared) {
  const RobotSetup plain = robot_at({9.0, 9.0}, {0.0, 9.0});
  RobotSetup swinging = robot_at({14.0, 9.0}, {0.0, 9.0}), exact = swinging;
  swinging.model = Car{.max_curvature = 0.5, .body = CarBody{0.4, 0.6}};
  exact.model = Car{.acceleration_set = AccelerationSet::exact};
  SensingModel late;
  late.delay = 1;
  for (const bool free : {false, true}) {
    Scenario scene = crossing(3, free ? SensingModel{} : late);
    if (free) scene.clock = Clock::free;
    for (const RobotSetup& setup : {swinging, exact}) {
      Simulation simulation(scene, 1);
      simulation.add_robot(plain);
      if (!free && model_traits(setup.model).swings) {  // robots that see it late know of it
        EXPECT_NO_THROW(simulation.add_robot(setup));
        continue;
      }
      EXPECT_THROW(simulation.add_robot(setup), Error) << free;
      Scenario with = scene;
      with.robots.push_back(setup);
      with.robots.back().position.y = -14.0;
      EXPECT_NO_THROW(Simulation(with, 1).add_robot(setup)) << free;
    }
  }
}

int overlaps(const Scenario& scene) {
  test::Judged judged(scene, 1);
  judged.run(scene.duration);
  EXPECT_EQ(judged.report().accelerations.count + judged.report().speeds.count, 0);
  return static_cast<int>(judged.report().overlaps.count);
}

TEST(Senses, declared_ones_cost_no_contact_and_others_do) {
  SensingModel strong = noisy(0.1, 0.3, NoiseDistribution::uniform);  // without quantiles
  strong.delay = 4;
  strong.dropped = 0.2;
  int undeclared = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Scenario scene = crossing(16, strong);
    scene.seed = seed;
    EXPECT_EQ(overlaps(scene), 0);
    scene.sensing_error = SensingError{};
    undeclared += overlaps(scene);
  }
  EXPECT_GT(undeclared, 0);
}

}  // namespace
}  // namespace avo
