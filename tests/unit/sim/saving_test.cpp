// SPDX-License-Identifier: Apache-2.0
// A saved simulation goes on, bit by bit, as the one that saved it.
#include "unit/sim/saving.h"

#include <algorithm>
#include <cstddef>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "avo/simulation.h"

namespace avo {
namespace {

using test::Bytes;
using test::dense_avo_scene;
using test::dense_scene;
using test::holonomic_scene;
using test::Random;
using test::with_clocks;

Vec2 somewhere(Random& random, double low, double high) {
  const double x = random.uniform(low, high);
  return {x, random.uniform(low, high)};
}

void add_any_robot(Random& random, Simulation& simulation) {
  const Vec2 place = somewhere(random, 300.0, 600.0);  // out of sight of the others
  RobotSetup setup = test::robot_at(place, somewhere(random, 0.0, 20.0));
  setup.max_speed = setup.preferred_speed = random.uniform(0.05, 0.2);
  if (random.below(3) == 0) setup.priority = random.log_uniform(0.01, 100.0);
  if (random.below(3) == 0) setup.max_braking = 0.6 * setup.max_acceleration;
  if (random.below(2) == 0 && simulation.planner().options().motion == Motion::held) {
    setup.model = Car{0.7}, setup.heading = random.uniform(-3.0, 3.0);
  }
  simulation.add_robot(setup);
}

// Anything that a user can do to a simulation.
void edit(Random& random, Simulation& simulation) {
  const int robots = static_cast<int>(simulation.fleet().id.size());
  const int kind = random.below(4);
  if (kind == 0) return simulation.step();
  if (kind == 1 || robots == 0) return add_any_robot(random, simulation);
  const RobotId robot = simulation.fleet().id[static_cast<std::size_t>(random.below(robots))];
  if (kind == 2) return simulation.remove_robot(robot);
  const std::size_t index = simulation.fleet().id.size();
  for (std::size_t k = 0; k < index; ++k) {
    if (simulation.fleet().id[k] == robot && is_parked(simulation.fleet().setup[k])) return;
  }
  simulation.set_goal(robot, somewhere(random, 0.0, 20.0));
}

// Some are parked, and not all avoid each other.
void mix_conduct(Random& random, Scenario& scene) {
  for (RobotSetup& robot : scene.robots) {
    if (random.below(8) == 0) {
      robot.behavior = Behavior::parked;
      robot.goal = robot.position;
      robot.velocity = {};
    } else if (random.below(3) == 0) {
      robot.layers.bits = 1U + static_cast<std::uint32_t>(random.below(3));
      robot.avoids.bits = static_cast<std::uint32_t>(random.below(4));
    }
  }
}

// The hashes of what comes later, edits included, and at last the saved bytes.
std::pair<std::vector<std::uint64_t>, Bytes> future(Simulation& simulation, std::uint64_t seed) {
  Random random(seed);
  std::vector<std::uint64_t> hashes{simulation.state_hash()};
  for (int k = 0; k < 30; ++k) {
    k % 3 == 0 ? edit(random, simulation) : simulation.step();
    hashes.push_back(simulation.state_hash());
  }
  return {hashes, simulation.save()};
}

Scenario random_scene(Random& random) {
  const Motion motion = random.below(2) == 0 ? Motion::held : Motion::exponential;
  const int robots = random.below(12) == 0 ? 270 : random.below(60);
  const std::uint64_t seed = random.bits();
  const bool mixed = random.below(3) == 0;
  if (random.below(4) == 0) {
    Scenario scene = dense_scene(robots, motion, seed);
    if (mixed) mix_conduct(random, scene);
    return scene;
  }
  Scenario scene = dense_avo_scene(robots, motion, Certificate::braking_trajectories, seed);
  scene.sensing_radius = 20.0;
  if (random.below(3) == 0) scene.moving_obstacles.clear();
  for (MovingObstacle& each : scene.moving_obstacles) {
    if (random.below(3) > 0) continue;
    each.acceleration = {};
    each.max_deviation = 0.5, each.max_speed = norm(each.velocity) + 0.1;
    if (random.below(2) == 0) each.path = {somewhere(random, 0.0, 20.0), {3.0, 4.0}, {5.0, 4.0}};
  }
  if (mixed) mix_conduct(random, scene);
  return scene;
}

TEST(Saving, any_simulation_goes_on_as_before) {
  for (std::uint64_t seed = 0; seed < 24 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Scenario scene = random_scene(random);
    if (seed % 3 == 0) scene = with_clocks(random, scene);
    Simulation original(scene, 1), fresh(scene, 2), used(scene, 2);
    for (int k = random.below(60); k > 0; --k) edit(random, original);
    for (int k = random.below(30); k > 0; --k) edit(random, used);
    const Bytes saved = original.save();
    Simulation alone(saved, 1);
    fresh.restore(saved);
    used.restore(saved);
    EXPECT_EQ(used.save(), saved);
    const auto expected = future(original, seed);
    for (Simulation* restored : {&fresh, &used, &alone}) {
      EXPECT_EQ(future(*restored, seed), expected);
    }
  }
}

// Robots in the order of their cells, on several threads, with their nearest neighbors remembered.
TEST(Saving, large_fleets_go_on_as_before) {
  Scenario scene = dense_avo_scene(1100, Motion::held, Certificate::braking_trajectories);
  scene.max_neighbors = 6;
  Simulation original(scene, 2);
  for (int k = 0; k < 19; ++k) original.step();
  const Bytes saved = original.save();
  Simulation one(saved, 1), two(scene, 2);
  two.restore(saved);
  for (int k = 0; k < 20; ++k) {
    original.step(), one.step(), two.step();
    ASSERT_EQ(one.state_hash(), original.state_hash()) << k;
    ASSERT_EQ(two.state_hash(), original.state_hash()) << k;
  }
}

TEST(Saving, goes_back_and_forth_in_one_simulation) {
  Simulation simulation(dense_scene(40, Motion::held), 1);
  std::vector<Bytes> saved;
  std::vector<std::uint64_t> hashes;
  for (int k = 0; k < 30; ++k) {
    saved.push_back(simulation.save());
    hashes.push_back(simulation.state_hash());
    simulation.step();
  }
  for (const std::size_t k : {20u, 3u, 29u, 0u, 14u}) {
    simulation.restore(saved[k]);
    EXPECT_EQ(simulation.steps(), static_cast<std::int64_t>(k));
    EXPECT_EQ(simulation.state_hash(), hashes[k]);
    while (simulation.steps() < 29) simulation.step();
    EXPECT_EQ(simulation.state_hash(), hashes[29]);
  }
}

TEST(Saving, shows_the_saved_robots_and_nothing_of_the_last_step) {
  Simulation simulation(dense_scene(20, Motion::held), 1);
  for (int k = 0; k < 5; ++k) simulation.step();
  simulation.set_goal({7}, {3, 4});
  simulation.remove_robot({2});
  const Simulation restored(simulation.save(), 1);
  const FleetView a = simulation.fleet(), b = restored.fleet();
  ASSERT_EQ(b.id.size(), 19u);
  for (std::size_t k = 0; k < b.id.size(); ++k) {
    EXPECT_EQ(a.id[k], b.id[k]);
    EXPECT_EQ(a.position[k], b.position[k]);
    EXPECT_EQ(a.velocity[k], b.velocity[k]);
    EXPECT_EQ(a.heading[k], b.heading[k]);
    EXPECT_EQ(a.goal[k], b.goal[k]);
    EXPECT_EQ(a.setup[k].radius, b.setup[k].radius);
    EXPECT_EQ(a.setup[k].max_speed, b.setup[k].max_speed);
    EXPECT_EQ(a.setup[k].max_acceleration, b.setup[k].max_acceleration);
    EXPECT_EQ(a.setup[k].preferred_speed, b.setup[k].preferred_speed);
    EXPECT_EQ(a.setup[k].model, b.setup[k].model);
    EXPECT_EQ(b.plan[k].new_velocity, Vec2{});
    EXPECT_EQ(b.applied_acceleration[k], 0.0);
  }
  EXPECT_EQ(restored.time(), simulation.time());
  EXPECT_EQ(restored.threads(), 1);
}

TEST(Saving, ids_are_not_reused_after_it) {
  Simulation simulation(dense_scene(5, Motion::held), 1);
  simulation.remove_robot({4});
  Simulation restored(simulation.save(), 1);
  EXPECT_EQ(restored.add_robot(test::robot_at({500, 500}, {500, 500})).value, 5u);
}

// Robots at a shared goal search for places among the walls that are listed for them.
TEST(Saving, walls_are_listed_for_the_robots_that_are_there) {
  for (int trial = 0; trial < 12; ++trial) {
    Random random(static_cast<std::uint64_t>(trial));
    Scenario scene;
    for (int k = 0; k < 8; ++k) {
      scene.robots.push_back(test::robot_at({-10.0 + 1.5 * k, -8.0}, {0, 0}));
      scene.robots.back().max_speed = scene.robots.back().preferred_speed = 1.0;
    }
    scene.robots.push_back(test::robot_at({60, 60}, {60, 60}));
    scene.robots.back().max_speed = 6.0;  // it needs walls from farther away
    const Vec2 a = somewhere(random, -4.0, 4.0);
    scene.obstacles = {{{{{a, a + Vec2{2.0, random.uniform(-1.0, 1.0)}}, false}}}};
    Simulation simulation(scene, 1);
    simulation.step();
    simulation.remove_robot({8});
    Simulation restored(simulation.save(), 1);
    for (int step = 0; step < 300; ++step) simulation.step(), restored.step();
    EXPECT_EQ(simulation.state_hash(), restored.state_hash()) << trial;
  }
}

TEST(Saving, takes_72_bytes_a_robot_beside_its_setup) {
  constexpr std::size_t kSetup = 11 * sizeof(double);  // goal, radius, limits, model, conduct
  Simulation few(holonomic_scene(10), 1), many(holonomic_scene(110), 1);
  few.step(), many.step();
  EXPECT_LE(many.save().size() - few.save().size(), 100 * (kSetup + 72));
}

}  // namespace
}  // namespace avo
