// SPDX-License-Identifier: Apache-2.0
// Robots that do not do what the others expect: the loop does to them what it says, and the rows of
// faults on board find what docs/on_board.md says of them.
#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "families.h"
#include "fleet_loop.h"
#include "run.h"
#include "table.h"

namespace avo::safety {
namespace {

Scene scene_of(const std::string& row, std::uint64_t seed) {
  for (const Family& family : families(1e4)) {
    if (family.name == row) return family.make(seed);
  }
  ADD_FAILURE() << "no row " << row;
  return {};
}

// The row's first scenes, of `duration` (s) at most each.
RowResult result_of(const std::string& row, int scenes, double duration) {
  std::vector<Outcome> outcomes;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scenes); ++seed) {
    Scene scene = scene_of(row, seed);
    scene.scenario.duration = std::min(scene.scenario.duration, duration);
    outcomes.push_back(run_scene(scene, seed, ""));
  }
  return summarize(row, outcomes);
}

// A robot that drives at 1 m/s, alone.
Scene lone_robot(const Acting& acting) {
  Scene scene{usual_scenario()};
  scene.scenario.response_time = 0.0;  // decisions are executed at once
  scene.scenario.robots = {usual_robot({}, {20.0, 0.0}, 2.0)};
  scene.scenario.robots[0].velocity = {1.0, 0.0};
  scene.sensing.emplace();
  scene.acting = acting;
  return scene;
}

Robot after(const Acting& acting, int ticks) {
  const Scene scene = lone_robot(acting);
  FleetLoop loop(scene, 1, planner_options(scene.scenario));
  for (int k = 0; k < ticks; ++k) loop.tick();
  return loop.robots()[0];
}

TEST(FleetLoop, holds_the_acceleration_within_a_step) {
  Acting fine;
  fine.ticks = 10;
  const Robot robot = after(fine, 5);
  EXPECT_NEAR(robot.velocity.x, 1.05, 1e-12);
  EXPECT_NEAR(robot.position.x, 0.05 + 0.5 * 0.05 * 0.05, 1e-12);
  EXPECT_NEAR(after(fine, 30).position.x, after({}, 3).position.x, 1e-12);
}

TEST(FleetLoop, weak_drives_reach_their_part_of_a_decision) {
  Acting weak;
  weak.strength = 0.8;
  EXPECT_NEAR(after(weak, 1).velocity.x, 1.08, 1e-12);
}

TEST(FleetLoop, late_commands_leave_the_velocity_as_it_was) {
  Acting late;
  late.ticks = 10;
  late.latency = 5;
  EXPECT_EQ(after(late, 5).velocity.x, 1.0);
  EXPECT_NEAR(after(late, 10).velocity.x, 1.05, 1e-12);
}

TEST(FleetLoop, robots_out_of_phase_decide_once_a_step) {
  Scene scene = scene_of("board-phases-circle", 1);
  FleetLoop loop(scene, 1, planner_options(scene.scenario));
  std::size_t decisions = 0, most = 0;
  for (int tick = 0; tick < 10; ++tick) {
    loop.tick();
    decisions += loop.plans().size();
    most = std::max(most, loop.plans().size());
  }
  EXPECT_EQ(decisions, loop.robots().size());
  EXPECT_LT(most, loop.robots().size());
}

TEST(FleetLoop, without_a_fault_robots_do_not_touch_at_any_part_of_a_step) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Scene scene = scene_of("board-phases-crush", seed);
    scene.acting.phases = false;
    scene.scenario.duration = 20.0;
    EXPECT_EQ(run_scene(scene, seed, "").verdict.overlapping_pairs, 0);
  }
}

TEST(OnBoard, each_fault_lets_robots_overlap_in_a_crush_and_is_not_ruled_out) {
  for (const std::string fault : {"phases", "jitter", "steps", "one-sided", "stale",
                                  "stale-carried", "missed", "radius", "weak", "latency"}) {
    const int scenes = fault == "one-sided" ? 1 : 2;  // it takes long
    const RowResult row = result_of("board-" + fault + "-crush", scenes, 20.0);
    EXPECT_FALSE(row.certified) << fault;
    EXPECT_GE(row.unsafe_scenes, 1) << fault;
    EXPECT_EQ(row.acceleration_violations + row.speed_violations + row.jumps, 0) << fault;
  }
}

TEST(OnBoard, clocks_out_of_phase_cost_millimeters_and_nothing_where_declared) {
  EXPECT_GT(result_of("board-phases-crush", 3, 30.0).least_clearance, -0.01);
  EXPECT_GT(result_of("board-phases-declared-crush", 3, 30.0).least_clearance, 0.0);
}

TEST(OnBoard, a_wrong_radius_gives_no_status) {
  const RowResult row = result_of("board-radius-random", 6, 60.0);
  EXPECT_EQ(row.unsafe_scenes, 6);
  EXPECT_NEAR(*row.least_clearance, -0.05, 1e-3);
  EXPECT_EQ(row.decisions[static_cast<std::size_t>(PlanStatus::overlapping)], 0);
}

TEST(OnBoard, obstacles_with_whims_touch_robots_in_motion) {
  const RowResult row = result_of("board-movers", 10, 30.0);
  EXPECT_GT(row.moving_contacts, 3);
  EXPECT_GT(row.deepest_contact, 0.02);
  EXPECT_EQ(row.overlapping_pairs, 0);
}

}  // namespace
}  // namespace avo::safety
