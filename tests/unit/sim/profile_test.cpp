// SPDX-License-Identifier: Apache-2.0
// What a measured step tells of itself, and that measuring changes nothing.
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "avo/simulation.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::dense_avo_scene;
using test::dense_scene;

TEST(Profile, counts_what_the_steps_did) {
  for (const int threads : {1, 3}) {
    Scenario scene = dense_avo_scene(300, Motion::held, Certificate::braking_trajectories);
    scene.max_neighbors = 7;
    Simulation simulation(scene, threads);
    simulation.step();
    simulation.measure(true);
    std::int64_t pairs = 0, infeasible = 0;
    for (int k = 0; k < 5; ++k) {
      for (std::size_t i = 0; i < 300; ++i) {
        pairs += std::min(7, static_cast<int>(simulation.perceive({i}).neighbors.size()));
      }
      simulation.step();
      for (const Plan& plan : simulation.fleet().plan) infeasible += plan.violation > 0.0 ? 1 : 0;
    }
    const StepProfile profile = simulation.profile();
    EXPECT_EQ(profile.robot_steps, 5 * 300);
    EXPECT_EQ(profile.pairs, pairs);
    EXPECT_EQ(profile.infeasible, infeasible);
    EXPECT_GT(infeasible, 0);
    std::vector<std::string> names;
    double sum = 0.0;
    for (const StageTime& stage : profile.stages) {
      names.emplace_back(stage.name);
      EXPECT_GE(stage.nanoseconds, 0.0) << stage.name;
      sum += stage.nanoseconds;
    }
    EXPECT_EQ(names, (std::vector<std::string>{"index", "search", "half_planes", "program",
                                               "certificate", "motion"}));
    EXPECT_GT(sum, 0.0);
  }
}

TEST(Profile, begins_anew_and_is_empty_where_nothing_is_measured) {
  Simulation simulation(dense_scene(40, Motion::held), 1);
  simulation.measure(true);
  simulation.step();
  EXPECT_EQ(simulation.profile().robot_steps, 40);
  simulation.measure(false);
  simulation.step();
  const StepProfile profile = simulation.profile();
  EXPECT_EQ(profile.robot_steps + profile.pairs + profile.infeasible, 0);
  for (const StageTime& stage : profile.stages) EXPECT_EQ(stage.nanoseconds, 0.0) << stage.name;
}

TEST(Profile, measuring_changes_no_bit) {
  const Scenario scene = dense_scene(280, Motion::held);
  Simulation plain(scene, 2), measured(scene, 2);
  measured.measure(true);
  for (int k = 0; k < 20; ++k) plain.step(), measured.step();
  EXPECT_EQ(plain.state_hash(), measured.state_hash());
}

}  // namespace
}  // namespace avo
