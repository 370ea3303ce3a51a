// SPDX-License-Identifier: Apache-2.0
// Memory that runs out, after any number of allocations, leaves everything whole.
#include <gtest/gtest.h>
#include <new>

#include "avo/error.h"
#include "avo/simulation.h"
#include "unit/sim/counting_new.h"
#include "unit/sim/scenes.h"
#include "unit/sim/walled_scenes.h"

namespace avo {
namespace {

using test::allocations;
using test::left;

// Calls action() with memory that is out after 0, 1, 2 ... allocations until it succeeds; returns
// how often it failed.
template <typename Action>
int failures(const Action& action) {
  for (int count = 0;; ++count) {
    left = count;
    try {
      action();
      left = -1;
      return count;
    } catch (const std::bad_alloc&) {
      left = -1;
    }
  }
}

TEST(OutOfMemory, a_plan_throws_and_the_next_one_is_as_good_as_ever) {
  for (const Method method :
       {Method::avo, Method::avo_paper, Method::orca, Method::velocity_obstacle,
        Method::orca_clamped, Method::reciprocal_velocity_obstacle, Method::buffered_voronoi}) {
    Scenario scene = test::dense_scene(60, Motion::held);
    scene.method = method;
    const Simulation simulation(scene, 1);
    Simulation::Perception seen = simulation.perceive({0});
    std::swap(seen.neighbors.front(), seen.neighbors.back());  // has to be sorted
    const Planner& planner = simulation.planner();
    PlanWorkspace fresh;
    Detour expected_detour{0.5F, 0.25F};
    const Plan expected = planner.plan(seen.robot, seen.neighbors, fresh, &expected_detour);
    PlanWorkspace workspace;
    Plan plan;
    Detour detour{0.5F, 0.25F};
    const int failed = failures([&] {
      EXPECT_EQ(detour.angle, 0.5) << "unchanged by a plan that failed";
      plan = planner.plan(seen.robot, seen.neighbors, workspace, &detour);
    });
    EXPECT_GT(failed, 5);
    EXPECT_EQ(plan.new_velocity, expected.new_velocity);
    EXPECT_EQ(detour.angle, expected_detour.angle);
    PlanWorkspace other;
    EXPECT_GT(
        failures([&] { plan = planner.plan_among_movers(seen.robot, seen.neighbors, other); }), 2);
  }
}

TEST(OutOfMemory, a_plan_with_what_was_reserved_needs_none) {
  const Scenario scene = test::dense_avo_scene(60, Motion::held, Certificate::braking_trajectories);
  const Simulation simulation(scene, 1);
  const Simulation::Perception seen = simulation.perceive({0});
  PlanWorkspace workspace;
  workspace.reserve(seen.neighbors.size(), 64);
  EXPECT_EQ(failures([&] {
              static_cast<void>(simulation.planner().plan(seen.robot, seen.neighbors, workspace));
            }),
            0);
}

// A fleet takes a step, and then a crowd comes for which no memory is set aside.
Simulation crowded(int threads) {
  Simulation simulation(test::dense_avo_scene(280, Motion::held, Certificate::braking_trajectories),
                        threads);
  simulation.step();
  for (int k = 0; k < 300; ++k) {
    simulation.add_robot(test::robot_at({60.0 + 0.2 * (k % 20), 0.2 * (k / 20)}, {}));
  }
  return simulation;
}

bool fails(Simulation& simulation, long allowed) {
  left = allowed;
  try {
    simulation.step();
    left = -1;
    return false;
  } catch (const std::bad_alloc&) {
    left = -1;
    return true;
  }
}

TEST(OutOfMemory, a_step_in_which_nobody_has_moved_can_be_tried_again) {
  Simulation expected = crowded(1);
  const std::uint64_t before = expected.state_hash();
  expected.step();
  for (const int threads : {1, 3}) {
    for (const long allowed : {0L, 1L, 2L}) {
      Simulation simulation = crowded(threads);
      ASSERT_TRUE(fails(simulation, allowed));
      EXPECT_EQ(simulation.state_hash(), before);
      simulation.step();
      EXPECT_EQ(simulation.state_hash(), expected.state_hash());
    }
  }
}

// Method velocity_obstacle takes memory as it plans.
TEST(OutOfMemory, a_step_that_ends_while_robots_are_moved_is_the_last) {
  Scenario scene = test::dense_scene(400, Motion::held);
  scene.method = Method::velocity_obstacle;
  scene.max_neighbors = 6;
  for (const int threads : {1, 3}) {
    Simulation whole(scene, threads);
    const long before = allocations;
    whole.step();
    const long taken = allocations - before;
    Simulation simulation(scene, threads);
    ASSERT_TRUE(fails(simulation, threads == 1 ? taken - 1 : taken / 2));
    EXPECT_THROW(simulation.step(), Error);
    EXPECT_THROW(simulation.step(), Error);
    EXPECT_EQ(simulation.fleet().id.size(), 400U);  // to be looked at
  }
}

TEST(OutOfMemory, what_was_saved_makes_a_torn_simulation_whole) {
  Scenario scene = test::dense_scene(400, Motion::held);
  scene.method = Method::velocity_obstacle;
  scene.max_neighbors = 6;
  Simulation whole(scene, 1), torn(scene, 1);
  const std::vector<std::byte> saved = torn.save();
  const long before = allocations;
  whole.step();
  ASSERT_TRUE(fails(torn, allocations - before - 1));
  EXPECT_THROW(static_cast<void>(torn.save()), Error);
  torn.restore(saved);
  torn.step();
  EXPECT_EQ(torn.state_hash(), whole.state_hash());
}

TEST(OutOfMemory, a_state_is_restored_or_nothing_changes) {
  Simulation simulation(test::dense_scene(40, Motion::held), 1);
  const std::vector<std::byte> saved = simulation.save();
  const std::uint64_t hash = simulation.state_hash();
  simulation.step();
  const std::uint64_t stepped = simulation.state_hash();
  EXPECT_GT(failures([&] {
              EXPECT_EQ(simulation.state_hash(), stepped);
              simulation.restore(saved);
            }),
            5);
  EXPECT_EQ(simulation.state_hash(), hash);
}

TEST(OutOfMemory, a_robot_of_another_radius_comes_to_walls_whole_or_not_at_all) {
  Scenario scene;
  scene.arrival_distance = 0.05;
  scene.obstacles = {test::pieces({{{5, -3}, {5, 3}}})};
  scene.robots = {test::robot_at({0, 0}, {10, 0})};
  RobotSetup other = test::robot_at({0, 4}, {5.2, 0});  // it cannot get there
  other.radius = 0.3;
  for (int allowed = 0;; ++allowed) {
    Simulation simulation(scene, 1);
    left = allowed;
    bool is_added = true;
    try {
      simulation.add_robot(other);
    } catch (const std::bad_alloc&) {
      is_added = false;
    }
    left = -1;
    for (int k = 0; k < 3; ++k) simulation.step();
    EXPECT_EQ(simulation.fleet().id.size(), is_added ? 2U : 1U);
    EXPECT_EQ(simulation.unreachable().size(), is_added ? 1U : 0U);
    if (!is_added) continue;
    EXPECT_GT(allowed, 20);
    return;
  }
}

TEST(OutOfMemory, an_obstacle_comes_and_goes_whole_or_not_at_all) {
  Simulation simulation(test::crowded_maze(20), 1);
  for (int k = 0; k < 7; ++k) simulation.step();
  const StaticObstacle wall{{{{{-5, 0}, {-5, 9}}, false}}};
  const auto try_edit = [&](const auto& edit) {
    const std::vector<std::byte> before = simulation.save();
    int failed_edits = 0;
    for (long count = 0;; count += 1 + count / 8) {
      left = count;
      try {
        edit();
        left = -1;
        break;
      } catch (const std::bad_alloc&) {
        left = -1;
        ++failed_edits;
        EXPECT_TRUE(simulation.save() == before);
      }
    }
    EXPECT_GT(failed_edits, 20);
  };
  ObstacleId id;
  try_edit([&] { id = simulation.add_obstacle(wall); });
  EXPECT_EQ(id.value, 1u);
  simulation.step();
  try_edit([&] { simulation.remove_obstacle(id); });
  simulation.step();
}

TEST(OutOfMemory, a_robot_comes_whole_or_not_at_all) {
  Simulation simulation(test::dense_scene(20, Motion::held), 1);
  for (int k = 0; k < 40; ++k) {
    const std::uint64_t hash = simulation.state_hash();
    RobotId id;
    const int failed = failures([&] {
      EXPECT_EQ(simulation.state_hash(), hash);
      id = simulation.add_robot(test::robot_at({100.0 + 3.0 * k, 0.0}, {}));
    });
    EXPECT_GE(failed, 0);
    EXPECT_EQ(id.value, 20U + static_cast<unsigned>(k));
  }
  simulation.step();
}

}  // namespace
}  // namespace avo
