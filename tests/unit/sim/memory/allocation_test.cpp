// SPDX-License-Identifier: Apache-2.0
// Nothing is allocated per step once a simulation is warm: every operator new is counted.
#include <cmath>
#include <gtest/gtest.h>
#include <memory>

#include "avo/events.h"
#include "avo/simulation.h"
#include "core/executor.h"
#include "core/thread_pool.h"
#include "unit/navigation/buildings.h"
#include "unit/navigator/on_board.h"
#include "unit/sim/counting_new.h"
#include "unit/sim/scenes.h"
#include "unit/sim/walled_scenes.h"

namespace avo {
namespace {

using test::allocations;
using test::bytes;

TEST(Allocation, the_counter_counts) {
  const long before = allocations;
  double* volatile kept = new double(1.0);  // or the compiler leaves both out
  delete kept;
  EXPECT_EQ(allocations - before, 1);
}

// Two workers that change places with every call, so that each of them comes to know every part of
// the work: which one of a pool does what is left to chance.
class TakingTurns final : public Executor {
 public:
  [[nodiscard]] std::size_t workers() const override { return 2; }
  void run(std::size_t count, Task task, void* context) override {
    ++calls_;
    for (std::size_t k = 0; k < count; ++k) task(context, k, (k + calls_) % 2);
  }

 private:
  std::size_t calls_ = 0;
};

Simulation simulation_on(int workers, const Scenario& scene) {
  return workers == 1 ? Simulation(scene, 1) : Simulation(scene, std::make_shared<TakingTurns>());
}

long allocations_when_warm(const Scenario& scene, int workers, int warm_up, int steps) {
  Simulation simulation = simulation_on(workers, scene);
  for (int k = 0; k < warm_up; ++k) simulation.step();
  const long before = allocations;
  for (int k = 0; k < steps; ++k) simulation.step();
  return allocations - before;
}

TEST(Allocation, none_per_call_of_a_pool) {
  ThreadPool pool(2);
  const auto call = [&] { parallel_for(pool, 8, [](std::size_t, std::size_t) {}); };
  call();
  const long before = allocations;
  for (int k = 0; k < 100; ++k) call();
  EXPECT_EQ(allocations - before, 0);
}

TEST(Allocation, none_per_step_in_a_dense_scene) {
  for (const int workers : {1, 2}) {
    for (const Motion motion : {Motion::held, Motion::exponential}) {
      const Scenario scene = test::dense_scene(280, motion);
      ASSERT_GE(scene.robots.size(), kFewestParallel);
      EXPECT_EQ(allocations_when_warm(scene, workers, 60, 60), 0) << workers << " workers";
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

TEST(Allocation, none_per_step_of_free_clocks) {
  for (const int workers : {1, 2}) {
    Scenario scene = test::dense_avo_scene(280, Motion::held, Certificate::braking_trajectories);
    scene.clock = Clock::free;
    for (std::size_t i = 0; i < scene.robots.size(); i += 3) scene.robots[i].time_step = 0.05;
    EXPECT_EQ(allocations_when_warm(scene, workers, 1500, 1500), 0) << workers << " workers";
  }
}

TEST(Allocation, none_for_a_look_at_one_robot_and_a_goal_for_it) {
  Simulation simulation(test::dense_scene(100, Motion::held), 1);
  const long before = allocations;
  for (std::size_t i = 0; i < simulation.size(); ++i) {
    const RobotState state = simulation.robot({i});
    simulation.set_goal(state.id, state.position);
  }
  EXPECT_EQ(allocations - before, 0);
}

// A newcomer is checked against the kinds of robots that are there: a list of all would grow four
// times more often.
TEST(Allocation, as_many_for_a_newcomer_whatever_the_number_of_robots) {
  const auto for_the_third = [](int robots) {
    Scenario scene;
    for (int k = 0; k < robots; ++k) scene.robots.push_back(test::robot_at({3.0 * k, 0}, {}));
    Simulation simulation(scene, 1);
    simulation.add_robot(test::robot_at({-50, 0}, {}));
    simulation.add_robot(test::robot_at({-60, 0}, {}));  // makes a grid of all
    const long before = allocations;
    simulation.add_robot(test::robot_at({-70, 0}, {}));
    return allocations - before;
  };
  EXPECT_LE(for_the_third(16000), for_the_third(1000) + 2);
}

TEST(Allocation, none_per_step_of_orca) {
  Scenario scene = test::dense_scene(200, Motion::held);
  scene.method = Method::orca;
  EXPECT_EQ(allocations_when_warm(scene, 1, 60, 60), 0);
}

TEST(Allocation, none_per_step_of_the_baselines) {
  for (const Method method : {Method::velocity_obstacle, Method::reciprocal_velocity_obstacle,
                              Method::buffered_voronoi}) {
    Scenario scene = test::dense_scene(60, Motion::held);
    scene.method = method;
    scene.max_neighbors = 6;
    EXPECT_EQ(allocations_when_warm(scene, 1, 60, 40), 0) << to_string(method);
  }
}

TEST(Allocation, none_per_step_of_several_methods) {
  for (const int workers : {1, 2}) {
    Scenario scene = test::dense_scene(280, Motion::held);  // as many as two threads plan
    scene.method = Method::avo;
    for (std::size_t i = 0; i < scene.robots.size(); i += 2) {
      scene.robots[i].method = i % 4 == 0 ? Method::orca : Method::avo_paper;
      if (i % 3 == 0) scene.robots[i].time_horizon = 4.0;
    }
    EXPECT_EQ(allocations_when_warm(scene, workers, 25, 25), 0) << workers << " workers";
  }
}

TEST(Allocation, none_per_step_of_one_robot_among_movers) {
  for (const Method method : {Method::avo_paper, Method::avo}) {
    Scenario scene = test::dense_scene(1, Motion::held);
    scene.method = method;
    scene.robots[0].model = Holonomic{};
    scene.robots[0].goal = {12, 6};
    scene.sensing_radius = 100;
    EXPECT_EQ(allocations_when_warm(scene, 1, 30, 60), 0);
  }
}

TEST(Allocation, none_per_step_beside_walls) {
  for (const Method method :
       {Method::avo, Method::avo_paper, Method::orca, Method::velocity_obstacle,
        Method::orca_clamped, Method::reciprocal_velocity_obstacle, Method::buffered_voronoi}) {
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
  for (const int workers : {1, 2}) {
    const Scenario scene = test::crowded_maze(280);
    EXPECT_EQ(allocations_when_warm(scene, workers, 1, 150), 0) << workers << " workers";
  }
}

// Crowds gather at doors, and more and more robots claim each of them. No robot has waited there
// for long enough yet to look for another route, which needs a map of its own.
TEST(Allocation, none_per_step_at_passages) {
  for (const int workers : {1, 2}) {
    const Scenario scene = test::crowd_at_doors(300, RightOfWay::seen);
    EXPECT_EQ(allocations_when_warm(scene, workers, 3, 70), 0) << workers << " workers";
  }
}

TEST(Allocation, none_per_step_where_others_look_as_the_scene_says) {
  for (const int workers : {1, 2}) {
    Scenario scene = test::crowded_maze(280);
    scene.sensing.noise.position = 0.01;
    scene.sensing.delay = 1;
    scene.sensing.dropped = 0.1;
    scene.sensing.occlusion = true;
    EXPECT_EQ(allocations_when_warm(scene, workers, 1, 60), 0) << workers << " workers";
    scene.sensing.localization.position = 0.01;
    EXPECT_EQ(allocations_when_warm(scene, workers, 1, 60), 0) << workers << " workers";
    scene.clock = Clock::free;
    EXPECT_EQ(allocations_when_warm(scene, workers, 400, 400), 0) << workers << " workers";
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

// Beside movers and among arrivals; what is told takes memory.
TEST(Allocation, none_per_look_for_events_where_nothing_happens) {
  Simulation simulation(test::dense_scene(100, Motion::held), 1);
  Events events(simulation, {.stuck_after = 1.0});
  int without = 0, with = 0;  // steps
  for (int k = 0; k < 200; ++k) {
    simulation.step();
    static_cast<void>(simulation.fleet(Columns::position | Columns::goal));
    const long before = allocations;
    const bool is_empty = events.observe(simulation).empty();
    (is_empty ? without : with) += 1;
    if (!is_empty || k <= 60) continue;
    EXPECT_EQ(allocations, before) << k;
  }
  EXPECT_GT(without, 60);
  EXPECT_GT(with, 10);
}

// On board: one planner, one workspace.
void expect_none_per_plan(const Scenario& scene) {
  const Simulation simulation(scene, 1);
  std::vector<Simulation::Perception> seen;
  for (std::size_t i = 0; i < 100; ++i) seen.push_back(simulation.perceive({i}));
  PlanWorkspace workspace;
  std::vector<CertificateConstraint> constraints;
  const Planner& planner = simulation.planner();
  double sum = 0.0;
  long before = 0;
  for (int round = 0; round < 2; ++round) {
    before = allocations;
    for (const Simulation::Perception& each : seen) {
      sum += planner.plan(each.robot, each.neighbors, workspace).new_velocity.x;
      sum += planner.plan_among_movers(each.robot, each.neighbors, workspace).new_velocity.x;
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

// Four robots change rooms, and one follows a route; each with a navigator of its own.
TEST(Allocation, none_per_step_of_a_warm_navigator) {
  Scenario scene;
  scene.obstacles = {test::pieces(test::doorway(1.6))};
  for (int k = 0; k < 2; ++k) {
    scene.robots.push_back(test::robot_at({-8, 2.0 * k - 4.0}, {8, 4.0 - 2.0 * k}));
    scene.robots.push_back(test::robot_at({8, 2.0 * k - 4.0}, {-8, 4.0 - 2.0 * k}));
  }
  test::OnBoard fleet(scene);
  fleet.navigators[0].set_route({{-8, -4}, {-4, 0}, {4, 0}, {8, 4}});
  for (int k = 0; k < 50; ++k) fleet.step();
  std::vector<Neighbor> seen;
  seen.reserve(fleet.bases.size());
  const long before = allocations;
  for (int k = 0; k < 100; ++k) {
    for (std::size_t own = 0; own < fleet.bases.size(); ++own) {
      seen.clear();
      for (std::size_t other = 0; other < fleet.bases.size(); ++other)
        if (other != own) seen.push_back(test::seen_of(fleet.bases[other].robot));
      fleet.decisions[own] = fleet.navigators[own].step(fleet.bases[own].robot, seen, fleet.time);
    }
    for (std::size_t own = 0; own < fleet.bases.size(); ++own)
      fleet.bases[own].hold(fleet.navigators[own].planner(), fleet.decisions[own].plan);
    fleet.time += 0.1;
  }
  EXPECT_EQ(allocations - before, 0);
}

}  // namespace
}  // namespace avo
