// SPDX-License-Identifier: Apache-2.0
// A caller can ask which next velocities a certificate admits.
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <vector>

#include "avo/planner.h"
#include "avo/simulation.h"

namespace avo {
namespace {

Scenario circle(int robots) {
  Scenario scene;
  for (int k = 0; k < robots; ++k) {
    const double angle = 6.283185307179586 * k / robots;
    const Vec2 at{8.0 * std::cos(angle), 8.0 * std::sin(angle)};
    scene.robots.push_back({.position = at, .goal = -1.0 * at});
  }
  return scene;
}

std::vector<std::uint8_t> admitted_of(const Planner& planner, const Simulation::Perception& seen,
                                      const std::vector<Vec2>& velocities) {
  PlanWorkspace workspace;
  std::vector<std::uint8_t> admitted(velocities.size(), 2);
  planner.find_admitted(seen.robot, seen.neighbors, workspace, velocities, admitted, seen.walls);
  return admitted;
}

// The tests take this part of what a decision adds to the velocity. The rest is rounding to the
// decision and back. It is less than the 2^-30 of a step that choices keep from what the
// certificate refuses.
constexpr double kInside = 1.0 - 1e-12;

// What is decided is admitted, and to go on straight at somebody near is not.
TEST(Admitted, holds_the_decision_and_refuses_what_leads_to_contact) {
  Scenario scene = circle(12);
  Simulation simulation(scene, 1);
  int decided = 0, refused = 0, admitted_faster = 0;
  for (int step = 0; step < 120; ++step) {
    for (std::size_t i = 0; i < 12; ++i) {
      const Simulation::Perception seen = simulation.perceive({i});
      PlanWorkspace workspace;
      Detour detour = seen.detour;
      const Plan plan = simulation.planner().plan(seen.robot, seen.neighbors, workspace, &detour);
      const Vec2 v = seen.robot.velocity;
      const double speed = norm(v);
      const Vec2 on = speed > 0.0 ? (speed + 0.1) / speed * v : Vec2{0.1, 0.0};
      const auto admitted =
          admitted_of(simulation.planner(), seen,
                      {v + kInside * (plan.next_velocity - v), on, v + Vec2{0.11, 0}, {2.01, 0}});
      EXPECT_EQ(admitted[0], 1) << step << " " << i << " " << to_string(plan.status);
      EXPECT_EQ(admitted[2], 0) << "a_max";
      EXPECT_EQ(admitted[3], 0) << "v_max";
      ++decided;
      if (admitted[1] == 0 && norm(on) <= 2.0) ++refused;
      if (admitted[1] == 1) ++admitted_faster;
    }
    simulation.step();
  }
  EXPECT_GT(refused, decided / 20) << to_string(Certificate::braking_trajectories);
  EXPECT_GT(admitted_faster, decided / 20) << to_string(Certificate::braking_trajectories);
}

TEST(Admitted, without_a_certificate_the_limits_alone_count) {
  const Planner planner(default_options(Method::orca_clamped));
  const Robot robot{.velocity = {1.9, 0.0}};
  const Neighbor ahead{.position = {1.3, 0.0}};
  PlanWorkspace workspace;
  std::vector<std::uint8_t> admitted(3);
  planner.find_admitted(robot, {&ahead, 1}, workspace,
                        std::vector<Vec2>{{1.99, 0}, {2.01, 0}, {1.7, 0}}, admitted);
  EXPECT_EQ(admitted, (std::vector<std::uint8_t>{1, 0, 0}));
}

TEST(Admitted, nothing_where_plan_says_that_the_input_is_invalid) {
  const Planner planner(default_options(Method::avo));
  const Robot robot{};
  const Neighbor bad{.position = {3.0, 0.0}, .radius = -1.0};
  PlanWorkspace workspace;
  std::vector<std::uint8_t> admitted(1, 1);
  planner.find_admitted(robot, {&bad, 1}, workspace, std::vector<Vec2>{{0, 0}}, admitted);
  EXPECT_EQ(admitted[0], 0);
}

}  // namespace
}  // namespace avo
