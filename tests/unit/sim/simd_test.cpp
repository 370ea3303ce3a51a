// SPDX-License-Identifier: Apache-2.0
// One result for every instruction set and number of threads.
#include <gtest/gtest.h>
#include <optional>
#include <string>

#include "avo/simulation.h"
#include "core/simd_target.h"
#include "unit/sim/certified_scenes.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

// The instruction set that the machine would choose is set again at the end.
class Simd : public testing::Test {
 protected:
  ~Simd() override { use_simd_target(before_); }
  const std::string before_ = simd_target();
};

std::uint64_t hash_after(const Scenario& scene, int threads, int steps) {
  Simulation simulation(scene, threads);
  for (int k = 0; k < steps; ++k) simulation.step();
  return simulation.state_hash();
}

void expect_one_hash(const Scenario& scene, int steps) {
  ASSERT_GE(scene.robots.size(), std::size_t{256});  // fewer are planned by one thread
  std::optional<std::uint64_t> hash;
  for (const char* target : simd_targets()) {
    ASSERT_TRUE(use_simd_target(target));
    ASSERT_STREQ(simd_target(), target);
    for (const int threads : {1, 2, 3, 7}) {
      const std::uint64_t found = hash_after(scene, threads, steps);
      EXPECT_EQ(hash.value_or(found), found) << target << ", " << threads << " threads";
      hash = hash.value_or(found);
    }
  }
}

TEST_F(Simd, one_hash_of_the_paper) {
  expect_one_hash(test::dense_scene(300, Motion::held), 80);
}

TEST_F(Simd, one_hash_of_avo) {
  for (const Motion motion : {Motion::held, Motion::exponential}) {
    expect_one_hash(test::dense_avo_scene(300, motion, Certificate::braking_trajectories), 80);
  }
}

TEST_F(Simd, one_hash_of_noise) {
  Scenario scene = test::dense_avo_scene(300, Motion::held, Certificate::braking_trajectories);
  scene.sensing.noise = {0.01, 0.02};
  expect_one_hash(scene, 20);
}

TEST_F(Simd, targets_are_told_by_name) {
  EXPECT_FALSE(simd_targets().empty());
  EXPECT_STREQ(simd_targets().back(), "scalar");
  const std::string now = simd_target();
  EXPECT_FALSE(use_simd_target("avx1024"));
  EXPECT_EQ(simd_target(), now);
}

}  // namespace
}  // namespace avo
