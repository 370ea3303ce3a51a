// SPDX-License-Identifier: Apache-2.0
#include "figures/time_lapse.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <string>

#include "avo/error.h"

namespace avo::figures {
namespace {

// Robots on parallel lines: from rest to 2 m/s and back to rest after 20 s, then still.
Scenario lines(int robots) {
  Scenario scenario;
  scenario.name = "lines";
  for (int i = 0; i < robots; ++i) {
    RobotSetup robot;
    robot.position = {0.0, 2.0 * i};
    robot.goal = {36.0, 2.0 * i};
    scenario.robots.push_back(robot);
  }
  return scenario;
}

std::vector<TrajectoryFrame> run(const Scenario& scenario, double duration) {
  std::vector<TrajectoryFrame> frames;
  for (int k = 0; k <= static_cast<int>(std::lround(10.0 * duration)); ++k) {
    const double t = 0.1 * k;
    const double to_rest = std::fmax(20.0 - t, 0.0);
    const double way = t < 2.0    ? 0.5 * t * t
                       : t < 18.0 ? 2.0 + 2.0 * (t - 2.0)
                                  : 36.0 - 0.5 * to_rest * to_rest;
    TrajectoryFrame frame{.time = t};
    for (const RobotSetup& robot : scenario.robots) {
      frame.position.push_back(robot.position + Vec2{way, 0.0});
    }
    frames.push_back(frame);
  }
  return frames;
}

TEST(TimeLapse, ends_when_everybody_rests) {
  const Scenario scenario = lines(3);
  const auto frames = run(scenario, 60.0);
  EXPECT_NEAR(frames[last_motion(scenario, frames)].time, 19.9, 0.3);
  const auto still = run(scenario, 0.0);
  EXPECT_EQ(last_motion(scenario, still), 0U);
}

TEST(TimeLapse, nobody_moves_then_the_whole_run_counts) {
  const Scenario scenario = lines(1);
  std::vector<TrajectoryFrame> frames;
  for (int k = 0; k < 5; ++k) frames.push_back({.time = 1.0 * k, .position = {{0.0, 0.0}}});
  EXPECT_EQ(last_motion(scenario, frames), 4U);
}

TEST(TimeLapse, discs_at_cruising_speed_hardly_overlap_and_leave_no_gap) {
  const Scenario scenario = lines(2);
  const auto frames = run(scenario, 20.0);
  const auto selected = select_frames(scenario, frames, frames.size() - 1, 1500);
  ASSERT_GE(selected.size(), 10U);
  EXPECT_EQ(selected.front(), 0U);
  EXPECT_EQ(selected.back(), frames.size() - 1);
  for (std::size_t k = 1; k < selected.size(); ++k) {
    const double t = frames[selected[k - 1]].time;
    if (t < 2.0 || frames[selected[k]].time > 18.0) continue;
    const double apart =
        norm(frames[selected[k]].position[0] - frames[selected[k - 1]].position[0]);
    EXPECT_GE(apart, 0.95);  // of a diameter of 1 m
    EXPECT_LE(apart, 1.6);
  }
}

TEST(TimeLapse, times_are_regular) {
  const Scenario scenario = lines(1);
  const auto frames = run(scenario, 20.0);
  const auto selected = select_frames(scenario, frames, frames.size() - 1, 1500);
  const double mean = 20.0 / static_cast<double>(selected.size() - 1);
  for (std::size_t k = 1; k < selected.size(); ++k) {
    EXPECT_NEAR(frames[selected[k]].time - frames[selected[k - 1]].time, mean, 0.11);
  }
}

TEST(TimeLapse, many_robots_get_fewer_frames) {
  const Scenario scenario = lines(100);
  const auto frames = run(scenario, 20.0);
  const auto selected = select_frames(scenario, frames, frames.size() - 1, 1000);
  EXPECT_LE(100 * selected.size(), 1000U);
  EXPECT_GE(100 * selected.size(), 800U);
  EXPECT_EQ(selected.back(), frames.size() - 1);
  const auto crowd = select_frames(scenario, frames, frames.size() - 1, 10);
  EXPECT_EQ(crowd.size(), 2U);  // first and last at least
}

TEST(TimeLapse, finds_the_frame_of_a_time) {
  const auto frames = run(lines(1), 20.0);
  EXPECT_EQ(frame_at(frames, -1.0), 0U);
  EXPECT_EQ(frame_at(frames, 0.3), 3U);  // 0.1 * 3 is a little more than 0.3
  EXPECT_EQ(frame_at(frames, 0.39), 3U);
  EXPECT_EQ(frame_at(frames, 1e9), frames.size() - 1);
}

TEST(TimeLapse, covers_the_discs_and_the_goals) {
  Scenario scenario = lines(2);
  scenario.robots[0].goal = {0.0, -7.0};
  const auto frames = run(scenario, 20.0);
  const Box box = covered(scenario, frames, 0, frames.size() - 1);
  EXPECT_EQ(box.lower, (Vec2{-0.5, -7.0}));
  EXPECT_NEAR(box.upper.x, 36.5, 1e-9);
  EXPECT_EQ(box.upper.y, 2.5);
}

TEST(TimeLapse, colors_differ_between_robots) {
  for (const int robots : {2, 6, 7, 30}) {
    Scenario scenario = lines(robots);
    for (int i = 0; i < robots; ++i) {
      const double angle = 6.283185307179586 * i / robots;
      scenario.robots[static_cast<std::size_t>(i)].position = {std::cos(angle), std::sin(angle)};
    }
    const auto colors = robot_colors(scenario);
    ASSERT_EQ(colors.size(), scenario.robots.size());
    for (std::size_t i = 0; i < colors.size(); ++i) {
      for (std::size_t j = i + 1; j < colors.size(); ++j) {
        const double apart = std::fabs(colors[i].red - colors[j].red) +
                             std::fabs(colors[i].green - colors[j].green) +
                             std::fabs(colors[i].blue - colors[j].blue);
        EXPECT_GT(apart, 0.02) << robots << ": " << i << ", " << j;
      }
    }
  }
}

TEST(TimeLapse, frames_that_do_not_fit_are_refused) {
  Scenario scenario = lines(2);
  const auto good = run(scenario, 1.0);
  EXPECT_NO_THROW(check_frames(scenario, good));
  EXPECT_THROW(check_frames(scenario, {}), Error);
  auto frames = good;
  frames[3].position.pop_back();
  EXPECT_THROW(check_frames(scenario, frames), Error);
  frames = good;
  frames[3].position[1].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(check_frames(scenario, frames), Error);
  frames = good;
  frames[3].time = frames[2].time;
  EXPECT_THROW(check_frames(scenario, frames), Error);
  scenario.moving_obstacles.push_back({});
  EXPECT_THROW(check_frames(scenario, good), Error);
  scenario.moving_obstacles.clear();
  scenario.robots[0].model = Car{};
  EXPECT_THROW(check_frames(scenario, good), Error);  // a car without heading
}

}  // namespace
}  // namespace avo::figures
