// SPDX-License-Identifier: Apache-2.0
// One robot that is unlike the others is looked for only where it is, and this changes no bit. The
// robot costs nothing to the robots that are not near it.
#include <bit>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/executor.h"
#include "sim/sensing/sense.h"
#include "sim/travels.h"
#include "sim/world.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::Random;
using test::robot_at;

// On a jittered lattice, ten within the sensing radius of each; robot 0 is in the midst of them.
Scenario fleet_of(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  Scenario scene;
  scene.sensing_radius = 15.0;
  scene.max_neighbors = 10;
  scene.allow_broken_assumptions = true;
  const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
  const double spacing = 8.4, extent = spacing * static_cast<double>(side);
  for (std::size_t k = 0; k < count; ++k) {
    const Vec2 jitter{random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0)};
    const Vec2 cell{static_cast<double>(k % side), static_cast<double>(k / side)};
    scene.robots.push_back(robot_at(spacing * cell + jitter,
                                    {random.uniform(0.0, extent), random.uniform(0.0, extent)}));
  }
  std::swap(scene.robots[0], scene.robots[(side / 2) * side + side / 2]);
  return scene;
}

struct Oddity {
  std::string name;
  std::function<void(Scenario&)> make;
};
void PrintTo(const Oddity& oddity, std::ostream* out) {
  *out << oddity.name;
}

std::vector<Oddity> oddities() {
  const auto of_robot = [](const std::function<void(RobotSetup&)>& make) {
    return [make](Scenario& scene) { make(scene.robots[0]); };
  };
  return {
      {"fast", of_robot([](RobotSetup& r) {
         r.max_speed = r.preferred_speed = 10.0, r.velocity = {9.0, 0.0};
       })},
      {"large", of_robot([](RobotSetup& r) { r.radius = 6.0; })},
      {"parked",
       of_robot([](RobotSetup& r) { r.behavior = Behavior::parked, r.goal = r.position; })},
      {"layer", of_robot([](RobotSetup& r) { r.layers = LayerSet{2}; })},
      {"avoids_nobody", of_robot([](RobotSetup& r) { r.avoids = LayerSet{0}; })},
      {"cooperates", of_robot([](RobotSetup& r) { r.behavior = Behavior::cooperates; })},
      {"priority", of_robot([](RobotSetup& r) { r.priority = 3.0; })},
      {"braking", of_robot([](RobotSetup& r) { r.max_braking = 0.6; })},
      {"method", of_robot([](RobotSetup& r) { r.method = Method::orca; })},
      {"certified",
       [](Scenario& scene) {
         scene.method = Method::orca;
         scene.robots[0].method = Method::avo;
       }},
      {"car", of_robot([](RobotSetup& r) { r.model = Car{}; })},
      {"airplane", of_robot([](RobotSetup& r) {
         r.model = Airplane{}, r.velocity = {1.5, 0.0};
       })},
      {"mover",
       [](Scenario& scene) {
         scene.moving_obstacles = {
             {.position = scene.robots[0].position + Vec2{3.0, 4.0}, .velocity = {0.4, -0.3}}};
       }},
      {"fast_layer_and_mover",
       [](Scenario& scene) {
         scene.robots[0].max_speed = scene.robots[0].preferred_speed = 8.0;
         scene.robots[0].layers = LayerSet{2};
         scene.robots[1].layers = LayerSet{3};
         scene.moving_obstacles = {{.position = scene.robots[0].position + Vec2{6.0, 0.0}}};
       }},
  };
}

struct Steps {
  World world;

  explicit Steps(const Scenario& scene) : world(scene, std::make_shared<SerialExecutor>()) {
    if (world.has_routes())
      world.travels = plan_travels(world.routes, world.fleet, world.floor, 0.5);
  }

  void step() { avo::step(world); }
  // From now on as if there were too many outliers to tell them apart.
  void look_at_everyone() {
    world.outliers.usual = Scrutiny::everyone;
    world.outliers.robots.clear();
  }
  // The result counts the candidates that all robots have ranked, and the neighbors that they have
  // sensed, at the end of a step.
  std::size_t work() {
    Worker& worker = world.workers[0];
    std::size_t sum = 0;
    std::vector<std::uint32_t> slots;
    for (std::uint32_t slot = 0; slot < world.fleet.size(); ++slot) {
      if (world.fleet.is_parked(slot)) continue;
      slots.assign(1, slot);
      worker.tile.clear();
      sense(world, slots, worker);
      sum += worker.search.used + worker.tile.neighbors.count;
    }
    worker.tile.clear();
    return sum;
  }
};

std::uint64_t bits_of(const Steps& run) {
  return hash_of(run.world.fleet, run.world.movers, run.world.steps);
}

class OneOutlier : public testing::TestWithParam<Oddity> {};

TEST_P(OneOutlier, changes_no_bit_by_being_looked_for_where_it_is) {
  for (const Method method : {Method::avo, Method::avo_paper}) {
    // an airplane decides by method avo alone
    if (method != Method::avo && GetParam().name == "airplane") continue;
    for (const int most : {3, 10}) {
      Scenario scene = fleet_of(200, 1);
      scene.method = method;
      scene.max_neighbors = most;
      GetParam().make(scene);
      Steps local(scene), slow(scene);
      for (int k = 0; k < 60; ++k) {
        local.step(), slow.step();
        slow.look_at_everyone();
        ASSERT_EQ(bits_of(local), bits_of(slow)) << "step " << k << ", most " << most;
      }
      EXPECT_EQ(local.world.outliers.usual, Scrutiny::plain);
    }
  }
}

TEST_P(OneOutlier, leaves_others_the_work_that_they_have) {
  Scenario scene = fleet_of(900, 3);
  scene.sensing_radius = 30.0;
  Steps plain(scene);
  GetParam().make(scene);
  Steps odd(scene);
  for (int k = 0; k < 20; ++k) plain.step(), odd.step();
  const auto usual = static_cast<double>(plain.work()), work = static_cast<double>(odd.work());
  EXPECT_LT(work, 1.25 * usual);
  odd.look_at_everyone();
  EXPECT_GT(static_cast<double>(odd.work()), 1.5 * usual);
}

INSTANTIATE_TEST_SUITE_P(Outliers, OneOutlier, testing::ValuesIn(oddities()),
                         [](const auto& test) { return test.param.name; });

TEST(Outliers, are_nobody_where_there_are_many) {
  Scenario scene = fleet_of(200, 4);
  for (std::size_t k = 0; k < 100; ++k) scene.robots[k].priority = 2.0;
  Steps unlike(scene);
  unlike.step();
  EXPECT_EQ(unlike.world.outliers.usual, Scrutiny::one_by_one);
  for (std::size_t k = 0; k < 100; ++k) scene.robots[k].layers = LayerSet{2};
  Steps apart(scene);
  apart.step();
  EXPECT_EQ(apart.world.outliers.usual, Scrutiny::everyone);
}

}  // namespace
}  // namespace avo
