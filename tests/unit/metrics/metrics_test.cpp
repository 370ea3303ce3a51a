// SPDX-License-Identifier: Apache-2.0
// What a run is said to have done, against cases solved by hand and against brute force.
#include "avo/metrics.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include "avo/events.h"
#include "runs.h"
#include "support/brute_force.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::robot_at;

TEST(Metrics, overlap_begins_at_a_billionth_of_the_radii) {
  for (const double scale : {1e-3, 1.0, 1e4}) {
    for (const double overlap : {-1e-10, 0.0, 0.9e-9, 1.1e-9, 1e-3}) {
      const Vec2 away{scale * (1.0 - overlap), 0};
      Scenario scene = blind({robot_at({0, 0}, {0, 0}), robot_at(away, away)});
      scene.sensing_radius = 1e-6 * scale;
      for (RobotSetup& robot : scene.robots) robot.radius = 0.5 * scale;
      const RunSummary summary = run(scene, 0);
      const bool collides = overlap > 1e-9;
      EXPECT_EQ(summary.collision_pairs, collides ? 1 : 0) << scale << " " << overlap;
      EXPECT_EQ(summary.first_collision_time.has_value(), collides);
      EXPECT_EQ(summary.first_collision_time.value_or(0.0), 0.0);
      ASSERT_TRUE(summary.min_clearance);
      EXPECT_NEAR(*summary.min_clearance, -overlap * scale, 1e-15 * scale);
    }
  }
}

// Closing at 4 m/s with a miss distance m: contact where (10 - 4 t)² + m² = 1.
TEST(Metrics, first_collision_time_of_two_cruising_robots) {
  for (const Motion motion : {Motion::held, Motion::exponential}) {
    for (const double miss : {0.0, 0.3, 0.999, 1.001}) {
      Scenario scene = blind({cruising({-5, 0}, {50, 0}), cruising({5, miss}, {-50, miss})});
      scene.motion = motion;
      const RunSummary summary = run(scene, 40);
      EXPECT_NEAR(*summary.min_clearance, miss - 1.0, 1e-9);
      EXPECT_EQ(summary.collision_pairs, miss < 1.0 ? 1 : 0);
      if (miss > 1.0) continue;
      const double r = 1.0 - 1e-9;  // less is rounding
      EXPECT_NEAR(*summary.first_collision_time, (10.0 - std::sqrt(r * r - miss * miss)) / 4.0,
                  1e-11);
    }
  }
}

// From rest with v' = 2 m/s all along: 10 - 4 g(t) = 1, Eq. (9), in the exponential motion.
TEST(Metrics, first_collision_time_of_two_starting_robots) {
  Scenario scene = blind({robot_at({-5, 0}, {50, 0}), robot_at({5, 0}, {-50, 0})});
  scene.motion = Motion::exponential;
  double low = 0.0, high = 20.0;
  for (int k = 0; k < 80; ++k) {
    const double t = 0.5 * (low + high);
    (4.0L * test::slow_gain(t, 2.0L) < 9.0L ? low : high) = t;
  }
  EXPECT_NEAR(*run(scene, 80).first_collision_time, low, 1e-7);
}

// A pair is counted once, however often it meets, and all pairs are.
TEST(Metrics, collision_pairs_are_distinct) {
  Scenario scene = blind({});
  for (int k = 0; k < 4; ++k) {
    const double x = 0.9 * k;
    scene.robots.push_back(robot_at({x, 0}, {x, 0}));
  }
  EXPECT_EQ(run(scene, 5).collision_pairs, 3);
}

// The clearance of all pairs, from the equations of motion and samples of each step.
double slow_clearance(const Scenario& scene, int steps) {
  double least = std::numeric_limits<double>::infinity();
  for_each_step(scene, steps, [&](const FleetView& fleet, const auto& place) {
    for (std::size_t i = 0; i < fleet.id.size(); ++i) {
      for (std::size_t j = i + 1; j < fleet.id.size(); ++j) {
        const double contact = fleet.setup[i].radius + fleet.setup[j].radius;
        if (norm(place(i, 0.0) - place(j, 0.0)) - contact > least + 1.0) continue;
        const auto nearness = [&](double t) { return -norm(place(i, t) - place(j, t)); };
        double best = std::max(nearness(0.0), nearness(scene.time_step));
        const double half = 0.5 * scene.time_step;
        best = std::max(best, test::golden_section(nearness, 0.0, half, 40));
        best = std::max(best, test::golden_section(nearness, half, scene.time_step, 40));
        least = std::min(least, -best - contact);
      }
    }
  });
  return least;
}

TEST(Metrics, min_clearance_is_that_of_all_pairs) {
  for (const Method method : {Method::avo_paper, Method::avo, Method::orca}) {
    for (const Motion motion : {Motion::held, Motion::exponential}) {
      for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        Scenario scene = test::dense_scene(12, motion, seed);
        scene.method = method;
        scene.moving_obstacles.clear();
        for (RobotSetup& robot : scene.robots) robot.model = Holonomic{};
        if (seed % 2 == 0) {  // sparse, never in contact
          for (RobotSetup& robot : scene.robots) {
            robot.position = 6.0 * robot.position;
            robot.goal = 6.0 * robot.goal;
          }
        }
        const RunSummary summary = run(scene, 150);
        EXPECT_NEAR(*summary.min_clearance, slow_clearance(scene, 150), 1e-7);
        EXPECT_EQ(*summary.min_clearance<-1e-9, summary.collision_pairs> 0);
      }
    }
  }
}

TEST(Metrics, one_robot_has_no_clearance) {
  EXPECT_FALSE(run(blind({robot_at({0, 0}, {5, 0})}), 20).min_clearance);
  EXPECT_FALSE(run(blind({robot_at({0, 0}, {5, 0})}), 20).first_collision_time);
}

TEST(Metrics, obstacle_collisions_are_counted_apart_and_once) {
  Scenario scene = blind({cruising({-5, 0}, {50, 0}), cruising({-5, 20}, {50, 20})});
  scene.moving_obstacles = {{{5, 0.2}, {-1, 0}, {}, 0.5},     // meets the first
                            {{8, -0.4}, {0, 0.06}, {}, 0.5},  // so does this
                            {{-5, 18.8}, {2, 0}, {}, 0.5},    // follows the second, apart
                            {{0, 28}, {0, 0}, {0, -1}, 0.5},  // misses: the second is past
                            {{10, 40}, {2, -1}, {}, 0.5}};
  const RunSummary summary = run(scene, 100);
  EXPECT_EQ(summary.mover_collisions, 2);
  EXPECT_EQ(summary.mover_collisions_in_motion, 2);
  EXPECT_EQ(summary.collision_pairs, 0);
  EXPECT_FALSE(summary.first_collision_time);
}

// The robot stands at its goal, or waits 30 m before its goal.
TEST(Metrics, a_robot_that_is_run_over_at_rest_is_no_success) {
  for (const double goal : {0.0, 30.0}) {
    Scenario scene = blind({robot_at({0, 0}, {goal, 0}), robot_at({0, 30}, {0, 30})});
    scene.robots[0].preferred_speed = 0.0;
    scene.moving_obstacles = {{{6, 0.2}, {-1, 0}, {}, 0.5}};
    const RunSummary summary = run(scene, 100);
    EXPECT_EQ(summary.mover_collisions, 1);
    EXPECT_EQ(summary.mover_collisions_in_motion, 0);
    EXPECT_EQ(summary.metrics.collision, 0.5);
    EXPECT_EQ(summary.metrics.success, 0.5);
    EXPECT_EQ(summary.metrics.timeout, 0.0);
  }
}

// An obstacle with an acceleration is where x = 10 - t²/2 says.
TEST(Metrics, accelerating_obstacles_are_met_on_their_curve) {
  for (const Motion motion : {Motion::held, Motion::exponential}) {
    for (const double aside : {0.999, 1.001}) {
      Scenario scene = blind({robot_at({0, 0}, {0, 0})});
      scene.motion = motion;
      // it turns round at (0, aside) after 4 s
      scene.moving_obstacles = {{{0.5, aside + 8}, {-0.125, -4}, {0, 1}, 0.5}};
      const RunSummary summary = run(scene, 80);
      EXPECT_EQ(summary.mover_collisions, aside < 1.0 ? 1 : 0) << aside;
      EXPECT_EQ(summary.mover_collisions_in_motion, 0);
    }
  }
}

TEST(Metrics, arrivals_are_first_times) {
  // 2.55 m and 7.55 m to go at 2 m/s, to the next step: 1.3 s and 3.8 s
  Scenario scene = blind({cruising({0, 0}, {12.55, 0}), cruising({0, 9}, {17.55, 9})});
  scene.arrival_distance = 10.0;
  RunSummary summary = run(scene, 100);
  EXPECT_EQ(summary.arrived, 2);
  EXPECT_NEAR(*summary.last_arrival, 3.8, 1e-9);
  EXPECT_NEAR(*summary.mean_arrival, 2.55, 1e-9);
  summary = run(scene, 30);
  EXPECT_EQ(summary.arrived, 1);
  EXPECT_NEAR(*summary.mean_arrival, 1.3, 1e-9);
  EXPECT_FALSE(summary.last_arrival);
  summary = run(scene, 5);
  EXPECT_EQ(summary.arrived, 0);
  EXPECT_FALSE(summary.mean_arrival);
}

TEST(Metrics, arrived_at_the_start) {
  const RunSummary summary = run(blind({robot_at({1, 1}, {1.4, 1})}), 0);
  EXPECT_EQ(summary.arrived, 1);
  EXPECT_EQ(*summary.last_arrival, 0.0);
}

TEST(Metrics, robots_that_come_and_go_are_counted) {
  Scenario scene = blind({robot_at({0, 0}, {0, 0}), robot_at({9, 0}, {9, 0})});
  Simulation simulation(scene, 1);
  Metrics metrics(scene);
  metrics.observe(simulation);
  const auto step = [&] {
    simulation.step();
    metrics.observe(simulation);
  };
  step();
  const RobotId third = simulation.add_robot(robot_at({20, 0}, {20, 0}));
  step();
  EXPECT_EQ(metrics.summary().robots, 3);
  EXPECT_EQ(metrics.summary().collision_pairs, 0);
  simulation.remove_robot({0});
  step();
  // the new robot stands where the first robot was, and no robot overlaps with a removed robot
  simulation.add_robot(robot_at({0.2, 0}, {0.2, 0}));
  step();
  step();
  EXPECT_EQ(metrics.summary().collision_pairs, 0);
  simulation.remove_robot(third);
  simulation.add_robot(robot_at({9.3, 0}, {9.3, 0}));
  step();
  step();
  const RunSummary summary = metrics.summary();
  EXPECT_EQ(summary.collision_pairs, 1);
  EXPECT_EQ(summary.robots, 5);
  EXPECT_EQ(summary.arrived, 5);
  EXPECT_NEAR(*summary.min_clearance, -0.7, 1e-12);
  EXPECT_EQ(summary.steps, 7);
}

TEST(Metrics, robots_that_leave_by_an_exit_have_arrived) {
  Scenario scene;
  Team crowd{.task = Flow{.exits = {{14, -1}, {14, 1}}}};
  for (std::uint64_t k = 0; k < 12; ++k) {
    const Vec2 place{1.5 * static_cast<double>(k % 4), 1.5 * static_cast<double>(k / 4)};
    scene.robots.push_back(robot_at(place, place));
    crowd.members.push_back({.robot = {k}});
  }
  scene.teams = {crowd};
  Simulation simulation(scene, 1);
  Metrics metrics(scene);
  Events events(simulation);
  metrics.observe(simulation);
  std::set<std::uint64_t> arrived, gone;
  while (simulation.size() > 0 && simulation.time() < 60.0) {
    simulation.step();
    metrics.observe(simulation);
    for (const Event& event : events.observe(simulation)) {
      if (event.kind == EventKind::arrived) arrived.insert(event.robot.value);
      if (event.kind == EventKind::gone) gone.insert(event.robot.value);
    }
  }
  const RunSummary summary = metrics.summary();
  EXPECT_EQ(summary.arrived, 12);
  EXPECT_GT(summary.mean_arrival.value_or(0.0), 4.0) << "of the whole trips";
  EXPECT_EQ(arrived.size(), 12U);
  EXPECT_EQ(gone, arrived);
}

// Robots stand in a row, and the first one is put down behind the last one.
TEST(Metrics, a_robot_that_is_put_down_elsewhere_has_driven_through_nobody) {
  Scenario scene;
  for (const double x : {0.0, 5.0, 10.0}) scene.robots.push_back(robot_at({x, 0}, {x, 0}));
  Simulation simulation(scene, 1);
  Metrics metrics(scene);
  metrics.observe(simulation);
  const auto step = [&] {
    simulation.step();
    metrics.observe(simulation);
  };
  step();
  simulation.move_robot({0}, {20, 0});
  step();
  EXPECT_EQ(metrics.summary().collision_pairs, 0);
  // and what it does there counts
  Simulation other(scene, 1);
  Metrics seen(scene);
  seen.observe(other);
  other.move_robot({0}, {6.1, 0});
  other.step();
  seen.observe(other);
  other.step();
  seen.observe(other);
  EXPECT_LT(seen.summary().min_clearance.value_or(9.0), 0.2);
}

TEST(Metrics, limits_are_the_largest_applied) {
  for (const Motion motion : {Motion::held, Motion::exponential}) {
    Scenario scene = blind({robot_at({0, 0}, {30, 0}), robot_at({0, 5}, {10, 5})});
    scene.motion = motion;
    scene.robots[1].max_speed = 1.0;
    const RunSummary summary = run(scene, 200);
    EXPECT_NEAR(summary.max_acceleration, 1.0, 1e-9);
    EXPECT_EQ(summary.acceleration_excess, 0.0);
    EXPECT_LE(summary.max_speed, 2.0 + 1e-12);
    EXPECT_GT(summary.max_speed, 1.9);
  }
  Scenario scene = blind({robot_at({0, 0}, {30, 0})});
  scene.method = Method::orca;
  const RunSummary orca = run(scene, 20);
  EXPECT_NEAR(orca.max_acceleration, 20.0, 1e-9);  // 2 m/s within one step
  EXPECT_NEAR(orca.acceleration_excess, 19.0, 1e-9);
}

TEST(Metrics, infeasible_steps_are_robot_steps_with_an_empty_set) {
  const Scenario scene = test::dense_scene(60, Motion::held, 3);
  Simulation simulation(scene, 1);
  Metrics metrics(scene);
  metrics.observe(simulation);
  std::int64_t infeasible = 0;
  for (int k = 0; k < 50; ++k) {
    simulation.step();
    metrics.observe(simulation);
    for (const Plan& plan : simulation.fleet().plan) infeasible += plan.violation > 0.0 ? 1 : 0;
  }
  EXPECT_GT(infeasible, 100);
  EXPECT_EQ(metrics.summary().infeasible_steps, infeasible);
}

TEST(Metrics, decisions_are_counted_by_status) {
  Scenario scene = test::dense_avo_scene(60, Motion::held, Certificate::braking_trajectories, 3);
  Simulation simulation(scene, 1);
  Metrics metrics(scene);
  metrics.observe(simulation);
  std::map<PlanStatus, std::int64_t> expected;
  for (int k = 0; k < 50; ++k) {
    simulation.step();
    metrics.observe(simulation);
    for (const Plan& plan : simulation.fleet().plan) ++expected[plan.status];
  }
  const Decisions found = metrics.summary().decisions;
  EXPECT_EQ(found.optimal, expected[PlanStatus::optimal]);
  EXPECT_EQ(found.least_unsafe, expected[PlanStatus::least_unsafe]);
  EXPECT_EQ(found.refused, expected[PlanStatus::refused]);
  EXPECT_EQ(found.detour, expected[PlanStatus::detour]);
  EXPECT_EQ(found.braking, expected[PlanStatus::braking]);
  EXPECT_EQ(found.overlapping, expected[PlanStatus::overlapping]);
  EXPECT_EQ(found.invalid_input, 0);
  EXPECT_GT(found.refused, 100);
  EXPECT_GT(found.detour, 100);
  EXPECT_GT(found.overlapping, 0);
}

TEST(Metrics, who_has_not_arrived_is_told_with_those_that_touch_it) {
  Scenario scene =
      blind({robot_at({0, 0}, {9, 0}), robot_at({20, 0}, {20.4, 0}), robot_at({-1.05, 0}, {-9, 0}),
             robot_at({0, 1.16}, {0, 9}), robot_at({0.5, -0.95}, {0.5, -0.95})});
  scene.moving_obstacles = {{{9, 9}, {}, {}, 0.5}, {{0.9, 0.9}, {}, {}, 0.7}};
  RunSummary summary = run(scene, 0);
  ASSERT_EQ(summary.not_arrived.size(), 3u);  // without robots 1 and 4
  const NotArrived& first = summary.not_arrived[0];
  EXPECT_EQ(first.robot, 0u);
  EXPECT_EQ(first.distance, 9.0);
  EXPECT_EQ(first.speed, 0.0);
  EXPECT_EQ(first.detour_angle, 0.0);
  // 0.05 m beyond contact with a robot, 0.0728 m with an obstacle, 0.0735 m; robot 3 is too far
  EXPECT_EQ(first.held_by, (std::vector<std::int64_t>{2, -2, 4}));
  EXPECT_EQ(summary.not_arrived[1].robot, 2u);
  EXPECT_EQ(summary.not_arrived[2].robot, 3u);
  scene.robots.assign(130, robot_at({0, 0}, {9, 0}));
  for (std::size_t i = 0; i < 130; ++i) scene.robots[i].position.y = 3.0 * static_cast<double>(i);
  summary = run(scene, 3);
  EXPECT_EQ(summary.not_arrived.size(), 100u);
  EXPECT_EQ(summary.robots - summary.arrived, 130);
  EXPECT_GT(summary.not_arrived[99].speed, 0.0);
}

TEST(Metrics, step_time_is_the_median) {
  Metrics metrics{Scenario{}};
  EXPECT_FALSE(metrics.summary().step_milliseconds_median);
  for (const double t : {5.0, 1.0, 100.0, 2.0, 3.0}) metrics.add_step_time(t);
  EXPECT_EQ(*metrics.summary().step_milliseconds_median, 3.0);
}

}  // namespace
}  // namespace avo
