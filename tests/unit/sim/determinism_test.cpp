// SPDX-License-Identifier: Apache-2.0
// P13: the same bits for any number of threads and any order of the robots.
#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <numeric>
#include <vector>

#include "avo/simulation.h"
#include "core/executor.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::dense_avo_scene;
using test::dense_scene;
using test::Random;

std::vector<std::uint64_t> hashes(const Scenario& scene, int threads, int steps) {
  Simulation simulation(scene, threads);
  std::vector<std::uint64_t> all{simulation.state_hash()};
  for (int k = 0; k < steps; ++k) {
    simulation.step();
    all.push_back(simulation.state_hash());
  }
  return all;
}

TEST(Determinism, P13_any_number_of_threads_gives_the_same_bits) {
  for (const Motion motion : {Motion::held, Motion::exponential}) {
    const Scenario scene = dense_scene(280, motion);
    ASSERT_GE(scene.robots.size(), kFewestParallel);
    const std::vector<std::uint64_t> one = hashes(scene, 1, 200);
    for (const int threads : {2, 3, 7, 16}) EXPECT_EQ(hashes(scene, threads, 200), one) << threads;
    // all different: the hash sees the motion
    std::vector<std::uint64_t> sorted = one;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(std::unique(sorted.begin(), sorted.end()), sorted.end());
  }
}

TEST(Determinism, P13_any_number_of_threads_gives_the_same_bits_under_any_certificate) {
  for (const test::AvoKind kind : test::kAvoKinds) {
    const Scenario scene = dense_avo_scene(280, kind.motion, kind.certificate);
    ASSERT_GE(scene.robots.size(), kFewestParallel);
    const std::vector<std::uint64_t> one = hashes(scene, 1, 60);
    for (const int threads : {2, 3, 7, 16}) EXPECT_EQ(hashes(scene, threads, 60), one) << threads;
  }
}

TEST(Determinism, P13_other_methods_too) {
  for (const Method method : {Method::orca, Method::velocity_obstacle, Method::orca_clamped,
                              Method::reciprocal_velocity_obstacle, Method::buffered_voronoi}) {
    Scenario scene = dense_scene(280, Motion::held);
    ASSERT_GE(scene.robots.size(), kFewestParallel);
    scene.method = method;
    scene.max_neighbors = 3;
    EXPECT_EQ(hashes(scene, 3, 10), hashes(scene, 1, 10));
  }
}

TEST(Determinism, the_hash_sees_every_bit_of_the_state) {
  const Scenario scene = dense_scene(30, Motion::held);
  const std::uint64_t hash = Simulation(scene, 1).state_hash();
  const auto changed = [&](auto&& change) {
    Scenario other = scene;
    change(other);
    return Simulation(other, 1).state_hash();
  };
  const auto nudged = [](double& x) { x = std::nextafter(x, 1e9); };
  EXPECT_NE(hash, changed([&](Scenario& s) { nudged(s.robots[7].position.x); }));
  EXPECT_NE(hash, changed([&](Scenario& s) { nudged(s.robots[29].velocity.y); }));
  EXPECT_NE(hash, changed([&](Scenario& s) { nudged(s.robots[5].heading); }));
  EXPECT_NE(hash, changed([&](Scenario& s) { nudged(s.moving_obstacles[2].position.y); }));
  EXPECT_NE(hash, changed([&](Scenario& s) { nudged(s.moving_obstacles[0].velocity.x); }));
  EXPECT_EQ(hash, changed([](Scenario&) {}));
}

TEST(Determinism, P13_order_of_the_robots_permutes_the_trajectories) {
  std::vector<Scenario> scenes{dense_scene(120, Motion::held, 5),
                               dense_scene(120, Motion::exponential, 5)};
  for (const test::AvoKind kind : test::kAvoKinds) {
    scenes.push_back(dense_avo_scene(120, kind.motion, kind.certificate, 5));
  }
  for (const Scenario& scene : scenes) {
    std::vector<std::size_t> from(scene.robots.size());
    std::iota(from.begin(), from.end(), std::size_t{0});
    Random random(17);
    for (std::size_t i = from.size(); i > 1; --i) {
      std::swap(from[i - 1], from[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
    }
    Scenario permuted = scene;
    for (std::size_t i = 0; i < from.size(); ++i) permuted.robots[i] = scene.robots[from[i]];
    Simulation a(scene, 2), b(permuted, 2);
    for (int k = 0; k < 200 && !HasFailure(); ++k) {
      a.step();
      b.step();
      for (std::size_t i = 0; i < from.size(); ++i) {
        ASSERT_EQ(b.fleet().position[i], a.fleet().position[from[i]]) << "step " << k;
        ASSERT_EQ(b.fleet().velocity[i], a.fleet().velocity[from[i]]);
        ASSERT_EQ(b.fleet().heading[i], a.fleet().heading[from[i]]);
      }
    }
  }
}

// What is planned is what can be asked for: perceive() and the planner give the plan of step().
void expect_perception_is_planned_with(const Scenario& scene, int steps) {
  Simulation simulation(scene, 1);
  int detours = 0;
  for (int k = 0; k < steps; ++k) {
    std::vector<Plan> expected;
    PlanWorkspace workspace;
    for (std::size_t i = 0; i < simulation.fleet().id.size(); ++i) {
      const Simulation::Perception seen = simulation.perceive({i});
      const bool nobody_decides =
          std::ranges::all_of(seen.source, [](std::int64_t source) { return source < 0; });
      EXPECT_EQ(seen.among_movers, nobody_decides && !seen.neighbors.empty());
      ASSERT_EQ(seen.source.size(), seen.neighbors.size());
      if (scene.method != Method::avo) {  // a certificate needs all of them
        ASSERT_LE(seen.neighbors.size(), 10u);
      }
      double last = 0.0;
      for (const Neighbor& each : seen.neighbors) {  // nearest first
        EXPECT_GE(norm(each.position - seen.robot.position), last * (1.0 - 1e-15));
        last = norm(each.position - seen.robot.position);
        EXPECT_LE(last, 8.0);
      }
      const Planner& planner = simulation.planner();
      Detour detour = seen.detour;
      detours += detour.angle > 0.0 ? 1 : 0;
      expected.push_back(planner.plan(seen.robot, seen.neighbors, workspace, &detour));
      if (seen.among_movers) {
        const Plan among = planner.plan_among_movers(seen.robot, seen.neighbors, workspace);
        EXPECT_EQ(expected.back().new_velocity, among.new_velocity);
        EXPECT_EQ(detour.angle, 0.0);
      }
    }
    simulation.step();
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_EQ(simulation.fleet().plan[i].new_velocity, expected[i].new_velocity);
    }
  }
  // what is remembered matters to method avo in a crowd
  EXPECT_EQ(detours > 0, scene.method == Method::avo && scene.robots.size() > 1);
}

TEST(Determinism, perception_is_what_the_step_plans_with) {
  for (const int robots : {1, 40}) {
    expect_perception_is_planned_with(dense_scene(robots, Motion::held, 3), 20);
    for (const test::AvoKind kind : test::kAvoKinds) {
      expect_perception_is_planned_with(dense_avo_scene(robots, kind.motion, kind.certificate, 3),
                                        40);
    }
  }
}

}  // namespace
}  // namespace avo
