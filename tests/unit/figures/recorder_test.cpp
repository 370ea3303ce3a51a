// SPDX-License-Identifier: Apache-2.0
// The recorder on a real simulation: which frames it keeps, and that they are the true ones.
#include <cmath>
#include <gtest/gtest.h>

#include "avo/error.h"
#include "figures/trajectories.h"

namespace avo::figures {
namespace {

Scenario two_robots_and_a_mover() {
  Scenario scenario;
  scenario.name = "recorder";
  scenario.robots.resize(2);
  scenario.robots[0].position = {-5.0, 0.0};
  scenario.robots[0].goal = {5.0, 0.0};
  scenario.robots[1].position = {5.0, 1.5};
  scenario.robots[1].goal = {-5.0, 1.5};
  scenario.moving_obstacles.resize(1);
  scenario.moving_obstacles[0].position = {0.0, 9.0};
  scenario.moving_obstacles[0].velocity = {0.1, 0.0};
  return scenario;
}

struct Recording {
  std::vector<TrajectoryFrame> all, kept;
};

Recording record(int steps, std::size_t most_frames) {
  Simulation simulation(two_robots_and_a_mover(), 1);
  TrajectoryRecorder recorder(most_frames);
  Recording recording;
  for (int k = 0; k <= steps; ++k) {
    if (k > 0) simulation.step();
    recorder.observe(simulation);
    const auto position = simulation.fleet().position;
    const auto mover = simulation.moving_obstacles().position;
    recording.all.push_back({.time = simulation.time(),
                             .position = {position.begin(), position.end()},
                             .mover_position = {mover.begin(), mover.end()}});
  }
  recording.kept = recorder.frames();
  return recording;
}

TEST(Recorder, keeps_everything_while_there_is_room) {
  const Recording run = record(40, 41);
  ASSERT_EQ(run.kept.size(), 41U);
  for (std::size_t k = 0; k < run.kept.size(); ++k) {
    EXPECT_EQ(run.kept[k].time, run.all[k].time);
    EXPECT_EQ(run.kept[k].position, run.all[k].position);
    EXPECT_EQ(run.kept[k].mover_position, run.all[k].mover_position);
  }
  EXPECT_NE(run.kept.front().position, run.kept.back().position);  // something moved
}

TEST(Recorder, thins_out_evenly_and_keeps_both_ends) {
  for (const int steps : {41, 100, 163, 200}) {
    for (const std::size_t most : {2U, 7U, 16U}) {
      const Recording run = record(steps, most);
      ASSERT_LE(run.kept.size(), most + 1);
      ASSERT_GE(2 * run.kept.size(), most);
      EXPECT_EQ(run.kept.front().time, 0.0);
      EXPECT_EQ(run.kept.back().time, run.all.back().time);
      EXPECT_EQ(run.kept.back().position, run.all.back().position);
      const double spacing = run.kept.size() > 2 ? run.kept[1].time - run.kept[0].time : 0.0;
      for (std::size_t k = 0; k + 2 < run.kept.size(); ++k) {
        EXPECT_NEAR(run.kept[k + 1].time - run.kept[k].time, spacing, 1e-9);
      }
      for (const TrajectoryFrame& frame : run.kept) {
        const auto index = static_cast<std::size_t>(std::lround(frame.time / 0.1));
        EXPECT_EQ(frame.position, run.all[index].position);
      }
    }
  }
}

TEST(Recorder, before_anything_is_seen_there_is_nothing) {
  EXPECT_TRUE(TrajectoryRecorder().frames().empty());
  EXPECT_THROW(TrajectoryRecorder(1), Error);
}

}  // namespace
}  // namespace avo::figures
