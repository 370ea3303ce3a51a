// SPDX-License-Identifier: Apache-2.0
// Nothing is allocated per step once a simulation is warm: every operator new is counted.
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <malloc.h>
#include <new>

#include "avo/error.h"
#include "avo/simulation.h"
#include "core/executor.h"
#include "unit/sim/scenes.h"
#include "unit/sim/walled_scenes.h"

namespace {

std::atomic<long> allocations{0};
std::atomic<long> bytes{0};  // held now
// Allocations that succeed before memory is out; never, where it is negative.
std::atomic<long> left{-1};

void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  if (left == 0) throw std::bad_alloc();
  if (left > 0) --left;
  const std::size_t rounded = (size + alignment - 1) / alignment * alignment;
  void* memory = alignment > alignof(std::max_align_t)
                     ? std::aligned_alloc(alignment, rounded)
                     : std::malloc(size > 0 ? size : 1);  // NOLINT
  if (memory == nullptr) throw std::bad_alloc();
  bytes += static_cast<long>(malloc_usable_size(memory));
  return memory;
}

void release(void* memory) {
  bytes -= static_cast<long>(malloc_usable_size(memory));
  std::free(memory);  // NOLINT
}

}  // namespace

// The other forms of new and delete call these.
void* operator new(std::size_t size) {
  return counted(size, 1);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
  release(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  release(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  release(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  release(memory);
}

namespace avo {
namespace {

TEST(Allocation, the_counter_counts) {
  const long before = allocations;
  delete new double(1.0);
  EXPECT_EQ(allocations - before, 1);
}

long allocations_when_warm(const Scenario& scene, int threads, int warm_up, int steps) {
  Simulation simulation(scene, threads);
  for (int k = 0; k < warm_up; ++k) simulation.step();
  const long before = allocations;
  for (int k = 0; k < steps; ++k) simulation.step();
  return allocations - before;
}

TEST(Allocation, none_per_step_in_a_dense_scene) {
  for (const int threads : {1, 2}) {
    for (const Motion motion : {Motion::held, Motion::exponential}) {
      const Scenario scene = test::dense_scene(280, motion);
      ASSERT_GE(scene.robots.size(), kFewestParallel);
      EXPECT_EQ(allocations_when_warm(scene, threads, 60, 60), 0) << threads << " threads";
    }
  }
}

TEST(Allocation, none_per_step_of_avo_under_any_certificate) {
  for (const test::AvoKind kind : test::kAvoKinds) {
    const Scenario scene = test::dense_avo_scene(280, kind.motion, kind.certificate);
    ASSERT_GE(scene.robots.size(), kFewestParallel);
    EXPECT_EQ(allocations_when_warm(scene, 2, 60, 60), 0)
        << "certificate " << static_cast<int>(kind.certificate);
  }
}

TEST(Allocation, none_per_step_of_orca) {
  Scenario scene = test::dense_scene(200, Motion::held);
  scene.method = Method::orca;
  EXPECT_EQ(allocations_when_warm(scene, 1, 60, 60), 0);
}

TEST(Allocation, none_per_step_of_velocity_obstacle) {
  Scenario scene = test::dense_scene(60, Motion::held);
  scene.method = Method::velocity_obstacle;
  scene.max_neighbors = 6;
  EXPECT_EQ(allocations_when_warm(scene, 1, 60, 40), 0);
}

TEST(Allocation, none_per_step_of_one_robot_among_movers) {
  for (const Method method : {Method::avo_paper, Method::avo}) {
    Scenario scene = test::dense_scene(1, Motion::held);
    scene.method = method;
    scene.robots[0].car.reset();
    scene.robots[0].goal = {12, 6};
    scene.sensing_radius = 100;
    EXPECT_EQ(allocations_when_warm(scene, 1, 30, 60), 0);
  }
}

TEST(Allocation, none_per_step_beside_walls) {
  for (const Method method :
       {Method::avo, Method::avo_paper, Method::orca, Method::velocity_obstacle}) {
    Scenario scene = test::dense_scene(60, Motion::held);
    scene.method = method;
    scene.certificate.reset();
    scene.max_neighbors = 6;
    scene.navigation = false;
    for (int k = 0; k < 60; ++k) {
      const Vec2 a{0.5 * k - 15.0, 1.5 * (k % 21) - 15.0};
      scene.obstacles.push_back({{{{a, a + Vec2{0.4, 0.2}}, false}}, 0.0});
    }
    EXPECT_EQ(allocations_when_warm(scene, 1, 60, 40), 0) << to_string(method);
  }
}

// Robots jostle each other off their ways, lose sight of where they were going, and look for
// something else.
TEST(Allocation, none_per_step_among_walls) {
  for (const int threads : {1, 2}) {
    const Scenario scene = test::crowded_maze(280);
    EXPECT_EQ(allocations_when_warm(scene, threads, 1, 150), 0) << threads << " threads";
  }
}

// Crowds gather at doors, and more and more robots claim each of them.
TEST(Allocation, none_per_step_at_passages) {
  for (const RightOfWay right_of_way : {RightOfWay::seen, RightOfWay::told}) {
    for (const int threads : {1, 2}) {
      const Scenario scene = test::crowd_at_doors(300, right_of_way);
      EXPECT_EQ(allocations_when_warm(scene, threads, 3, 150), 0) << threads << " threads";
    }
  }
}

TEST(Allocation, none_per_step_after_edits_of_obstacles) {
  Simulation simulation(test::crowded_maze(60), 1);
  simulation.step();
  const ObstacleId door = simulation.add_obstacle({{{{{3, 3}, {3, 6}}, false}}});
  simulation.step();
  long before = allocations;
  for (int k = 0; k < 40; ++k) simulation.step();
  EXPECT_EQ(allocations - before, 0);
  simulation.remove_obstacle(door);
  simulation.step();
  before = allocations;
  for (int k = 0; k < 40; ++k) simulation.step();
  EXPECT_EQ(allocations - before, 0);
}

// Held by so many robots once they have been put in order.
long bytes_of(int robots, Method method) {
  Scenario scene;
  scene.method = method;
  scene.max_neighbors = 10;
  for (int k = 0; k < robots; ++k) {
    scene.robots.push_back(test::robot_at({8.0 * (k % 200), 8.0 * (k / 200)}, {}));
  }
  const long before = bytes;
  Simulation simulation(scene, 2);
  for (int k = 0; k < 3; ++k) simulation.step();
  return bytes - before;
}

// The workers' own, whatever the number of robots, comes on top.
TEST(Allocation, four_hundred_bytes_a_robot) {
  for (const Method method : {Method::avo_paper, Method::avo}) {
    const long each = (bytes_of(60000, method) - bytes_of(20000, method)) / 40000;
    EXPECT_LE(each, 400);
    EXPECT_GT(each, 100);  // they are counted
  }
}

// On board: one planner, one workspace.
void expect_none_per_plan(const Scenario& scene) {
  const Simulation simulation(scene, 1);
  std::vector<Simulation::Perception> seen;
  for (std::size_t i = 0; i < 100; ++i) seen.push_back(simulation.perceive(i));
  PlanWorkspace workspace;
  std::vector<CertificateConstraint> constraints;
  const Planner& planner = simulation.planner();
  double sum = 0.0;
  long before = 0;
  for (int round = 0; round < 2; ++round) {
    before = allocations;
    for (const Simulation::Perception& each : seen) {
      sum += planner.plan(each.robot, each.neighbors, workspace).new_velocity.x;
      sum += planner.plan_among_obstacles(each.robot, each.neighbors, workspace).new_velocity.x;
      planner.collect_certificate(each.robot, each.neighbors, workspace, constraints);
    }
  }
  EXPECT_EQ(allocations - before, 0);
  EXPECT_TRUE(std::isfinite(sum));
}

TEST(Allocation, none_per_plan) {
  expect_none_per_plan(test::dense_scene(100, Motion::held));
  for (const test::AvoKind kind : test::kAvoKinds) {
    expect_none_per_plan(test::dense_avo_scene(100, kind.motion, kind.certificate));
  }
}

// What was reserved is enough for a crowd that comes later.
TEST(Allocation, none_per_plan_in_a_crowd_that_thickens) {
  const auto neighbors_on_a_spiral = [](int count) {
    std::vector<Neighbor> neighbors;
    for (int k = 0; k < count; ++k) {
      const double distance = 1.5 + 0.1 * k, angle = 2.4 * k;
      Neighbor neighbor;
      neighbor.position = distance * Vec2{std::cos(angle), std::sin(angle)};
      neighbor.velocity = -0.5 * Vec2{std::cos(angle), std::sin(angle)};
      neighbors.push_back(neighbor);
    }
    return neighbors;
  };
  const Planner planner(PlannerOptions{});
  const Robot robot{{}, {0.4, 0.0}, {1.0, 0.0}};
  const std::vector<Neighbor> few = neighbors_on_a_spiral(1), many = neighbors_on_a_spiral(60);
  PlanWorkspace workspace;
  workspace.reserve(60, 32);
  double sum = planner.plan(robot, few, workspace).new_velocity.x;
  const long before = allocations;
  sum += planner.plan(robot, many, workspace).new_velocity.x;
  EXPECT_EQ(allocations - before, 0);
  EXPECT_TRUE(std::isfinite(sum));
}

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
       {Method::avo, Method::avo_paper, Method::orca, Method::velocity_obstacle}) {
    Scenario scene = test::dense_scene(60, Motion::held);
    scene.method = method;
    const Simulation simulation(scene, 1);
    Simulation::Perception seen = simulation.perceive(0);
    std::swap(seen.neighbors.front(), seen.neighbors.back());  // has to be sorted
    const Planner& planner = simulation.planner();
    PlanWorkspace fresh;
    Detour expected_detour{0.5, 0.25};
    const Plan expected = planner.plan(seen.robot, seen.neighbors, fresh, &expected_detour);
    PlanWorkspace workspace;
    Plan plan;
    Detour detour{0.5, 0.25};
    const int failed = failures([&] {
      EXPECT_EQ(detour.angle, 0.5) << "unchanged by a plan that failed";
      plan = planner.plan(seen.robot, seen.neighbors, workspace, &detour);
    });
    EXPECT_GT(failed, 5);
    EXPECT_EQ(plan.new_velocity, expected.new_velocity);
    EXPECT_EQ(detour.angle, expected_detour.angle);
    PlanWorkspace other;
    EXPECT_GT(
        failures([&] { plan = planner.plan_among_obstacles(seen.robot, seen.neighbors, other); }),
        2);
  }
}

TEST(OutOfMemory, a_plan_with_what_was_reserved_needs_none) {
  const Scenario scene = test::dense_avo_scene(60, Motion::held, Certificate::braking_trajectories);
  const Simulation simulation(scene, 1);
  const Simulation::Perception seen = simulation.perceive(0);
  PlanWorkspace workspace;
  workspace.reserve(seen.neighbors.size(), 64);
  EXPECT_EQ(failures([&] {
              static_cast<void>(simulation.planner().plan(seen.robot, seen.neighbors, workspace));
            }),
            0);
}

// A fleet, and then a crowd such as nobody made room for.
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
