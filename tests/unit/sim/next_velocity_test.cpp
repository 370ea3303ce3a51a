// SPDX-License-Identifier: Apache-2.0
// Plan::next_velocity is where the simulation takes the robot's velocity, bit for bit.
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "avo/simulation.h"
#include "scenes.h"

namespace avo {
namespace {

using test::dense_avo_scene;
using test::dense_scene;

// Cars drive under a certificate, and some of them start across their course.
Scenario scene_of_cars(Certificate certificate) {
  Scenario scene = dense_scene(60, Motion::held, 4);
  scene.method = Method::avo;
  scene.certificate = certificate;
  return scene;
}

std::vector<Scenario> scenes() {
  std::vector<Scenario> all{dense_scene(60, Motion::held), dense_scene(60, Motion::exponential)};
  for (const test::AvoKind& kind : test::kAvoKinds) {
    all.push_back(dense_avo_scene(60, kind.motion, kind.certificate));
  }
  for (const Motion motion : {Motion::held, Motion::exponential}) {
    all.push_back(dense_avo_scene(60, motion, Certificate::none));
  }
  for (const Certificate certificate : {Certificate::none, Certificate::braking_trajectories}) {
    all.push_back(scene_of_cars(certificate));
  }
  for (const Method method : {Method::orca, Method::velocity_obstacle, Method::orca_clamped,
                              Method::reciprocal_velocity_obstacle, Method::buffered_voronoi}) {
    all.push_back(dense_scene(60, Motion::held));
    all.back().method = method;
  }
  return all;
}

struct Counts {
  int cars = 0, turning_in_place = 0, at_rest = 0, short_of_the_target = 0;
};

// One step of the simulation, of which each robot says before where it leads.
void expect_next_velocities(Simulation& simulation, PlanWorkspace& workspace, Counts& counts) {
  std::vector<Plan> plans;
  for (std::size_t i = 0; i < simulation.fleet().id.size(); ++i) {
    const Simulation::Perception seen = simulation.perceive({i});
    Detour detour = seen.detour;
    plans.push_back(simulation.planner().plan(seen.robot, seen.neighbors, workspace, &detour));
  }
  simulation.step();
  const FleetView fleet = simulation.fleet();
  for (std::size_t i = 0; i < plans.size(); ++i) {
    const Vec2 next = plans[i].next_velocity;
    ASSERT_EQ(next, fleet.velocity[i]) << "robot " << i << " step " << simulation.steps();
    ASSERT_EQ(next, fleet.plan[i].next_velocity);
    const bool is_car = !is_holonomic(fleet.setup[i].model), rests = next == Vec2{};
    counts.cars += is_car ? 1 : 0;
    counts.turning_in_place += is_car && rests && plans[i].new_velocity != Vec2{} ? 1 : 0;
    counts.at_rest += rests ? 1 : 0;
    counts.short_of_the_target += next != plans[i].new_velocity ? 1 : 0;
  }
}

TEST(NextVelocity, is_where_the_simulation_takes_it) {
  PlanWorkspace workspace;
  Counts counts;
  for (const Scenario& scene : scenes()) {
    Simulation simulation(scene, 1);
    for (int k = 0; k < 40 && !HasFailure(); ++k) {
      expect_next_velocities(simulation, workspace, counts);
    }
  }
  EXPECT_GT(counts.cars, 1000);
  EXPECT_GT(counts.turning_in_place, 10);
  EXPECT_GT(counts.at_rest, 100);
  EXPECT_GT(counts.short_of_the_target, 10'000);
}

TEST(NextVelocity, of_a_robot_that_does_not_know_its_own_is_0) {
  const Planner planner(PlannerOptions{});
  PlanWorkspace workspace;
  const Robot lost{.velocity = {std::nan(""), 1.0}};
  EXPECT_EQ(planner.plan(lost, {}, workspace).next_velocity, Vec2{});
  // Only the preferred velocity of this robot is wrong: it brakes.
  const Robot confused{.velocity = {1.0, 0.0}, .preferred_velocity = {std::nan(""), 0.0}};
  const Plan plan = planner.plan(confused, {}, workspace);
  EXPECT_EQ(plan.status, PlanStatus::invalid_input);
  EXPECT_NEAR(norm(plan.next_velocity - Vec2{0.9, 0.0}), 0.0, 1e-15);
}

}  // namespace
}  // namespace avo
