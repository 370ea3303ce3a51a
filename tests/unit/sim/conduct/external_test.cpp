// SPDX-License-Identifier: Apache-2.0
// Methods of the caller's own: what their functions see, what becomes of their choices, and the
// certificate behind them.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <string>
#include <thread>
#include <vector>

#include "avo/explanation.h"
#include "avo/metrics.h"
#include "avo/simulation.h"
#include "support/refusal.h"
#include "unit/sim/hosted.h"

namespace avo {
namespace {

using test::Random;
using test::refusal;
using test::robot_at;

// The sum of the preferred velocity and a repulsion from each neighbor and wall.
void potential_field(const MethodBatch& batch, std::span<Vec2> velocities) {
  constexpr double kRange = 1.0, kStrength = 2.0;  // m, m/s
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const Robot& robot = batch.robot[i];
    for (const Neighbor& neighbor : batch.neighbors_of(i)) {
      const Vec2 away = robot.position - neighbor.position;
      const double distance = norm(away), gap = distance - robot.radius - neighbor.radius;
      if (distance > 0.0 && gap < 3.0 * kRange)
        velocities[i] = velocities[i] + (kStrength * std::exp(-gap / kRange) / distance) * away;
    }
  }
}

// What ORCA's planner chooses.
ExternalMethod planned(Scenario scene) {
  scene.method = Method::orca;
  return [planner = Planner(planner_options(scene))](const MethodBatch& batch,
                                                     std::span<Vec2> velocities) {
    PlanWorkspace workspace;
    for (std::size_t i = 0; i < batch.size(); ++i)
      velocities[i] =
          planner.plan(batch.robot[i], batch.neighbors_of(i), workspace, nullptr, batch.walls_of(i))
              .new_velocity;
  };
}

// Robots on a circle, off by chance, that exchange places.
Scenario circle(int robots, double radius, Method method, std::uint64_t seed = 1) {
  Random random(seed);
  Scenario scene;
  scene.method = method;
  scene.duration = 60.0;
  for (int k = 0; k < robots; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / robots;
    const Vec2 place = radius * Vec2{std::cos(angle), std::sin(angle)} + test::in_disc(random, 0.3);
    scene.robots.push_back(robot_at(place, {-place.x, -place.y}));
  }
  return scene;
}

Scenario with(ExternalMethod function, Scenario scene, Method method = Method::external_clamped,
              Certificate certificate = Certificate::none) {
  scene.method = method;
  scene.certificate = certificate;
  scene.external_method = "mine";
  scene.external = std::move(function);
  return scene;
}

Scenario certified(ExternalMethod function, const Scenario& scene) {
  return with(std::move(function), scene, Method::external_clamped,
              Certificate::braking_trajectories);
}

RunSummary outcome_of(const Scenario& scene) {
  Simulation simulation(scene, 1);
  Metrics metrics(scene);
  metrics.observe(simulation);
  while (!metrics.all_arrived() && simulation.can_step_by(scene.duration)) {
    simulation.step();
    metrics.observe(simulation);
  }
  return metrics.summary();
}

std::uint64_t hash_of_run(const Scenario& scene, int steps, int threads = 1) {
  Simulation simulation(scene, threads);
  for (int k = 0; k < steps; ++k) simulation.step();
  return simulation.state_hash();
}

// A solid obstacle and a wall stand on the courses of the robots.
Scenario furnished(Method method) {
  Scenario scene = circle(24, 9.0, method);
  scene.obstacles = {{{{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, true}}, 0.1, Fill::solid},
                     {{{{{-5, 3}, {-4, 4}}, false}}, 0.2, Fill::none}};
  return scene;
}

// What a function of the caller's own chooses for a robot is not taken before the robot starts.
TEST(ExternalMethod, waits_for_the_start_time_of_a_robot) {
  Scenario scene;
  scene.robots = {robot_at({0, 0}, {9, 0}), robot_at({0, 9}, {9, 9})};
  scene.robots[0].start_time = 1.0;
  Simulation simulation(with(
      [](const MethodBatch& batch, std::span<Vec2> velocities) {
        for (std::size_t i = 0; i < batch.size(); ++i) velocities[i] = {1.0, 0.0};
      },
      scene));
  test::run_for(simulation, 1.0);
  EXPECT_EQ(simulation.robot({0}).position, Vec2{});
  EXPECT_GT(simulation.robot({1}).position.x, 0.1);
  simulation.step();
  EXPECT_GT(simulation.robot({0}).velocity.x, 0.0);
}

TEST(ExternalMethod, chooses_as_a_planner_of_the_library_to_the_bit) {
  for (const auto& [builtin, method] :
       {std::pair{Method::orca, Method::external},
        std::pair{Method::orca_clamped, Method::external_clamped}}) {
    for (const Scenario& scene : {circle(24, 9.0, builtin), furnished(builtin)})
      EXPECT_EQ(hash_of_run(with(planned(scene), scene, method), 150), hash_of_run(scene, 150))
          << to_string(method);
  }
}

TEST(ExternalMethod, is_asked_once_a_step_about_all_its_robots_by_id_on_the_calling_thread) {
  Scenario scene = circle(300, 100.0, Method::avo);
  for (std::size_t k = 0; k < scene.robots.size(); k += 3)
    scene.robots[k].method = Method::external_clamped;
  scene.robots[9].method.reset(), scene.robots[9].behavior = Behavior::parked;
  scene.robots[9].goal = scene.robots[9].position;
  scene.external_method = "mine";
  std::vector<double> times;
  scene.external = [&, thread = std::this_thread::get_id()](const MethodBatch& batch,
                                                            std::span<Vec2>) {
    times.push_back(batch.time);
    EXPECT_EQ(std::this_thread::get_id(), thread);
    ASSERT_EQ(batch.size(), 99U);
    for (std::size_t i = 0; i < batch.size(); ++i)
      EXPECT_EQ(batch.id[i].value, 3 * (i < 3 ? i : i + 1));
  };
  Simulation simulation(scene, 3);
  for (int k = 0; k < 20; ++k) simulation.step();
  ASSERT_EQ(times.size(), 20U);
  EXPECT_DOUBLE_EQ(times[19], 1.9);
}

TEST(ExternalMethod, sees_what_its_robots_would_plan_with) {
  for (bool noisy : {false, true}) {
    Scenario scene = furnished(Method::avo);
    scene.max_neighbors = 3;  // limits half-planes, and not what the function sees
    if (noisy) scene.sensing.noise.position = 0.05, scene.sensing.delay = 2;
    Simulation* simulation = nullptr;
    scene = certified(
        [&](const MethodBatch& batch, std::span<Vec2> velocities) {
          for (std::size_t i = 0; i < batch.size(); ++i) {
            const Simulation::Perception seen = simulation->perceive({i});
            EXPECT_EQ(batch.robot[i].position, seen.robot.position);
            EXPECT_EQ(batch.robot[i].preferred_velocity, seen.robot.preferred_velocity);
            EXPECT_EQ(batch.goal[i], simulation->robot({i}).goal);
            ASSERT_EQ(batch.neighbors_of(i).size(), seen.neighbors.size());
            for (std::size_t k = 0; k < seen.neighbors.size(); ++k)
              EXPECT_EQ(batch.neighbors_of(i)[k].position, seen.neighbors[k].position);
            ASSERT_EQ(batch.walls_of(i).size(), seen.walls.size());
            for (std::size_t k = 0; k < seen.walls.size(); ++k)
              EXPECT_EQ(batch.walls_of(i)[k].a, seen.walls[k].a);
          }
          potential_field(batch, velocities);
        },
        scene);
    Simulation own(scene, 1);
    simulation = &own;
    for (int k = 0; k < 30; ++k) own.step();
  }
}

TEST(ExternalMethod, has_the_same_bits_for_any_number_of_threads) {
  Scenario scene = certified(potential_field, circle(400, 120.0, Method::avo));
  scene.obstacles = furnished(Method::avo).obstacles;
  EXPECT_EQ(hash_of_run(scene, 40, 1), hash_of_run(scene, 40, 3));
}

TEST(ExternalMethod, keeps_max_acceleration_where_it_is_clamped) {
  const ExternalMethod turns = [](const MethodBatch&, std::span<Vec2> velocities) {
    for (Vec2& v : velocities) v = {-v.y, v.x};
  };
  const Scenario scene = circle(2, 9.0, Method::avo);
  Simulation clamped(with(turns, scene), 1), at_once(with(turns, scene, Method::external), 1);
  clamped.step(), at_once.step();
  EXPECT_DOUBLE_EQ(norm(clamped.robot({0}).velocity), 0.1);
  EXPECT_GT(norm(at_once.robot({0}).velocity), 1.9);
}

TEST(ExternalMethod, by_acceleration_changes_the_velocity) {
  const Scenario scene =
      with(by_acceleration([](const MethodBatch&, std::span<Vec2> accelerations) {
             for (Vec2& a : accelerations) a = {0.0, 0.5};
           }),
           circle(2, 9.0, Method::avo));
  Simulation simulation(scene, 1);
  for (int k = 0; k < 4; ++k) simulation.step();
  EXPECT_NEAR(simulation.robot({0}).velocity.y, 0.2, 1e-12);
  EXPECT_EQ(simulation.robot({0}).velocity.x, 0.0);
}

TEST(ExternalMethod, takes_the_preferred_velocity_of_the_host) {
  Vec2 seen;
  Simulation simulation(
      certified([&](const MethodBatch& batch,
                    std::span<Vec2>) { seen = batch.robot[0].preferred_velocity; },
                circle(2, 9.0, Method::avo)),
      1);
  simulation.set_preferred_velocity({0}, Vec2{0.25, 0.75});
  simulation.step();
  EXPECT_EQ(seen, (Vec2{0.25, 0.75}));
}

TEST(ExternalMethod, without_a_function_or_with_a_velocity_that_is_not_finite_moves_nobody) {
  Scenario scene = with({}, circle(3, 9.0, Method::avo));
  Simulation simulation(scene, 1);
  const std::uint64_t before = simulation.state_hash();
  EXPECT_EQ(refusal([&] { simulation.step(); }),
            "external_method mine: found no function, must have one (Scenario::external, or "
            "set_external())");
  const auto half = [](const MethodBatch& batch, std::span<Vec2> velocities) {
    if (batch.time < 0.05) velocities[1].y = std::numeric_limits<double>::quiet_NaN();
  };
  simulation.set_external(half);
  EXPECT_EQ(refusal([&] { simulation.step(); }),
            "external_method mine: velocity of robot 1.1: found nan, must be a finite number");
  EXPECT_EQ(simulation.state_hash(), before);
  simulation.set_external([](const MethodBatch&, std::span<Vec2>) { throw Error("tired"); });
  EXPECT_EQ(refusal([&] { simulation.step(); }), "tired");
  EXPECT_EQ(simulation.state_hash(), before);
  simulation.set_external([](const MethodBatch&, std::span<Vec2>) {});
  simulation.step();
  EXPECT_EQ(simulation.state_hash(),
            hash_of_run(with([](const MethodBatch&, std::span<Vec2>) {}, scene), 1));
}

TEST(ExternalMethod, is_named_by_saved_states) {
  const Scenario scene = certified(potential_field, circle(12, 6.0, Method::avo));
  Simulation simulation(scene, 1);
  for (int k = 0; k < 10; ++k) simulation.step();
  const std::vector<std::byte> saved = simulation.save();
  Simulation again(saved, 1);
  EXPECT_EQ(again.state_hash(), simulation.state_hash());
  EXPECT_NE(refusal([&] { again.step(); }), "");
  again.set_external(potential_field);
  for (int k = 0; k < 10; ++k) simulation.step(), again.step();
  EXPECT_EQ(again.state_hash(), simulation.state_hash());
  Scenario other = scene;
  other.external_method = "yours";
  Simulation yours(other, 1);
  EXPECT_EQ(
      refusal([&] { yours.restore(saved); }),
      "saved state: external_method: found \"mine\", must be \"yours\" as in this simulation");
}

TEST(ExternalMethod, is_refused_without_a_name_and_where_clocks_are_free) {
  Scenario scene = with(potential_field, circle(2, 9.0, Method::avo));
  scene.external_method.clear();
  EXPECT_EQ(refusal(scene),
            "external_method: found none, must be a name of 1 to 64 bytes, for robots of method "
            "external");
  scene.external_method = "orca";
  EXPECT_EQ(refusal(scene), "external_method: found orca, must be another name than avo's own");
  scene.external_method = "mine";
  EXPECT_EQ(refusal(scene), "");
  scene.clock = Clock::free;
  EXPECT_EQ(refusal(scene), "clock: found free, must be common, for robots of method external");
  scene.clock = Clock::common, scene.method = Method::external;
  scene.certificate = Certificate::braking_trajectories;
  EXPECT_EQ(refusal(scene),
            "certificate: found braking_trajectories, must be none with method external");
}

TEST(ExternalMethod, is_explained) {
  Scenario scene = certified(potential_field, circle(12, 6.0, Method::avo));
  scene.max_neighbors = 3;
  Simulation simulation(scene, 1);
  for (int k = 0; k < 30; ++k) {
    std::vector<Plan> expected;
    for (std::size_t i = 0; i < 12; ++i) {
      const Explanation explanation = simulation.explain({i});
      EXPECT_EQ(explanation.seen.guide, Guide::host);
      expected.push_back(explanation.decision.plan);
    }
    simulation.step();
    for (std::size_t i = 0; i < 12; ++i) {
      EXPECT_EQ(simulation.robot({i}).plan.next_velocity, expected[i].next_velocity);
      EXPECT_EQ(simulation.robot({i}).plan.status, expected[i].status);
    }
  }
}

TEST(ExternalMethod, may_not_change_the_simulation_that_asks_it) {
  Simulation* simulation = nullptr;
  std::vector<std::string> refusals;
  const Scenario scene = certified(
      [&](const MethodBatch&, std::span<Vec2>) {
        refusals = {refusal([&] { simulation->step(); }),
                    refusal([&] { simulation->remove_robot({0}); }), refusal([&] {
                      simulation->set_goal({0}, {1, 1});
                    }),
                    refusal([&] { simulation->set_external(potential_field); })};
      },
      circle(6, 6.0, Method::avo));
  Simulation own(scene, 1);
  simulation = &own;
  own.step();
  ASSERT_EQ(refusals.size(), 4U);
  for (const std::string& said : refusals)
    EXPECT_EQ(said,
              "external_method: found a change within the step that asks it, must be after it");
  own.remove_robot({0});
  own.step();
}

TEST(ExternalMethod, keeps_its_name_while_no_robot_has_it) {
  Scenario scene = circle(6, 6.0, Method::avo);
  scene.external_method = "mine";
  scene.external = potential_field;
  Simulation a(scene, 1);
  Simulation b(a.save(), 1);
  b.set_external(potential_field);
  RobotSetup setup = a.setup({0});
  setup.method = Method::external_clamped;
  a.change_robot({0}, setup);
  b.change_robot({0}, setup);
  for (int k = 0; k < 50; ++k) a.step(), b.step();
  EXPECT_EQ(a.state_hash(), b.state_hash());
  b.restore(a.save());
  EXPECT_EQ(a.save(), b.save());
}

// Near its goal an own choice is no approach to the goal: rule 3 lets both turn aside.
TEST(ExternalMethod, passes_a_robot_that_it_meets_near_its_goal) {
  Scenario scene;
  scene.robots = {robot_at({-6, 0}, {-0.55, 0}), robot_at({6, 0}, {0.55, 0})};
  Simulation simulation(certified(
                            [](const MethodBatch& batch, std::span<Vec2> velocities) {
                              for (std::size_t i = 0; i < batch.size(); ++i)
                                velocities[i] = {batch.id[i].value == 0 ? 1.0 : -1.0, 0.0};
                            },
                            scene),
                        1);
  test::run_for(simulation, 40.0);
  EXPECT_GT(simulation.robot({0}).position.x, 5.0);
  EXPECT_LT(simulation.robot({1}).position.x, -5.0);
}

// What the certificate is for: contacts without it, and none with it.
TEST(Certificate, keeps_robots_of_other_methods_apart) {
  for (const Scenario& scene : {circle(40, 10.0, Method::avo), furnished(Method::avo)}) {
    const Scenario alone = with(potential_field, scene);
    const RunSummary without = outcome_of(alone),
                     behind = outcome_of(certified(potential_field, scene));
    EXPECT_GT(without.collision_pairs + without.static_collisions, 0);
    EXPECT_EQ(behind.collision_pairs, 0);
    EXPECT_EQ(behind.static_collisions, 0);
  }
  for (const Method method : {Method::orca_clamped, Method::buffered_voronoi}) {
    for (Scenario scene : {circle(40, 10.0, method), furnished(method)}) {
      scene.duration = 120.0;
      scene.time_horizon = 2.0;
      scene.certificate = Certificate::braking_trajectories;
      const RunSummary behind = outcome_of(scene);
      EXPECT_EQ(behind.collision_pairs, 0) << to_string(method);
      EXPECT_EQ(behind.static_collisions, 0) << to_string(method);
      EXPECT_GE(behind.arrived, 20) << to_string(method);
    }
  }
}

TEST(Certificate, is_common_to_robots_of_several_methods) {
  Scenario scene = certified(potential_field, circle(40, 10.0, Method::avo));
  for (std::size_t k = 0; k < scene.robots.size(); k += 2) scene.robots[k].method = Method::avo;
  const RunSummary mixed = outcome_of(scene);
  EXPECT_EQ(mixed.collision_pairs, 0);
  EXPECT_GE(mixed.arrived, 38);
  Simulation simulation(scene, 1);
  for (const Neighbor& neighbor : simulation.perceive({0}).neighbors)
    EXPECT_EQ(neighbor.behavior, Behavior::decides);
}

TEST(Certificate, is_counted_on_by_no_robot_where_the_other_keeps_none) {
  Scenario scene = certified(potential_field, circle(4, 4.0, Method::avo));
  scene.allow_broken_assumptions = true;
  scene.robots[1].method = Method::orca;
  Simulation simulation(scene, 1);
  std::size_t movers = 0;
  for (const Neighbor& neighbor : simulation.perceive({0}).neighbors)
    movers += neighbor.behavior == Behavior::moves_on ? 1 : 0;
  EXPECT_EQ(movers, 1U);
  for (const Neighbor& neighbor : simulation.perceive({1}).neighbors)
    EXPECT_EQ(neighbor.behavior, Behavior::decides);
}

TEST(Certificate, keeps_cars_drives_and_late_clocks_of_other_methods_apart) {
  Scenario scene = circle(24, 10.0, Method::orca_clamped);
  scene.time_horizon = 2.0;
  scene.certificate = Certificate::braking_trajectories;
  for (std::size_t k = 0; k < scene.robots.size(); k += 3) {
    scene.robots[k].model = Car{0.7};
    scene.robots[k + 1].model = DifferentialDrive{};
  }
  const RunSummary wheels = outcome_of(scene);
  EXPECT_EQ(wheels.collision_pairs, 0);
  EXPECT_EQ(wheels.arrived, 24);
  for (RobotSetup& robot : scene.robots) robot.model = Holonomic{};
  scene.clock = Clock::free;
  scene.robots[3].time_step = 0.05;
  EXPECT_EQ(outcome_of(scene).collision_pairs, 0);
}

TEST(Certificate, evades_movers_for_other_methods) {
  Scenario scene = certified(potential_field, circle(6, 8.0, Method::avo));
  scene.moving_obstacles = {{.position = {-20, 0.3}, .velocity = {1.0, 0}, .radius = 0.5},
                            {.position = {0.2, 25}, .velocity = {0, -1.2}, .radius = 0.4}};
  const RunSummary summary = outcome_of(scene);
  EXPECT_EQ(summary.collision_pairs, 0);
  EXPECT_EQ(summary.mover_collisions_in_motion, 0);
}

}  // namespace
}  // namespace avo
