// SPDX-License-Identifier: Apache-2.0
// What a look leaves out changes nothing: the certificate admits the same velocities, every
// half-space that can cut is there, and a fleet decides as each robot does on board.
#include "space/look.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>
#include <vector>

#include "avo/half_plane.h"
#include "avo/space/simulation.h"
#include "planner/rules/arrival.h"
#include "space/cells.h"
#include "space/certificate.h"
#include "space/frame.h"
#include "space/own_space.h"
#include "space/step_law.h"
#include "unit/space/draws.h"

namespace avo::space::tests {
namespace {

/// A robot among others, some of which are like it.
struct Crowd {
  PlannerOptions options;
  Horizon horizon;
  StepLaw law;
  Robot robot;
  Bodies bodies;
  Constraints constraints;

  Crowd(Draws& draws, bool is_mixed)
      : horizon(options.control_time, options.time_horizon, options.time_step),
        law(step_law(options, horizon)) {
    robot = draw(draws, false);
    robot.position = {};
    bodies.reserve(40);
    while (bodies.count < 40) {
      const Robot other = draw(draws, is_mixed);
      if (norm(other.position) > 1.2) bodies.add(neighbor_of(other), bodies.count);
    }
    fill_braking(law, bodies);
  }
  static Robot draw(Draws& draws, bool is_mixed) {
    Robot robot;
    robot.position = draws.within(9.0);
    robot.velocity = draws.within(2.0);
    robot.preferred_velocity = draws.within(2.0);
    if (!is_mixed) return robot;
    robot.radius = draws.between(0.2, 0.6);
    if (draws.below(2) == 0) robot.max_acceleration = draws.between(0.5, 2.0);
    if (draws.below(3) == 0) robot.priority = draws.between(0.2, 5.0);
    if (draws.below(3) == 0) robot.max_braking = draws.between(0.5, 2.0);
    if (draws.below(4) == 0) robot.vertical = draws.between(0.5, 2.0);
    if (draws.below(6) == 0) robot.downwash = 1.0;
    return robot;
  }

  Viewer look() {
    begin_constraints(robot, braking_of(robot, law), law, constraints);
    return {.robot = robot,
            .braking = constraints.own,
            .deviation = constraints.deviation,
            .law = law,
            .horizon = horizon,
            .control_time = options.control_time,
            .traffic_range = 6.0};
  }
  Looked seen() {
    Looked looked;
    Viewer around = look();
    const Run all{0, bodies.count};
    look_at(around, bodies, std::span(&all, 1), {}, looked);
    return looked;
  }
};

TEST(Viewer, leaves_out_nobody_who_can_refuse_a_velocity) {
  Draws draws(31);
  int refused = 0;
  for (int k = 0; k < 300; ++k) {
    Crowd crowd(draws, k % 2 == 1);
    const Looked looked = crowd.seen();
    collect_constraints(crowd.robot, crowd.bodies, looked.near, {}, crowd.law, crowd.constraints);
    Constraints all;
    begin_constraints(crowd.robot, crowd.constraints.own, crowd.law, all);
    // whatever the bounds say, all constraints are there
    all.deviation.most_ahead = all.deviation.most_aside = 1e9;
    std::vector<NearBody> everybody;
    for (std::uint32_t at = 0; at < crowd.bodies.count; ++at)
      everybody.push_back({at, crowd.bodies.number[at]});
    collect_constraints(crowd.robot, crowd.bodies, everybody, {}, crowd.law, all);
    append_needed(crowd.robot, {1e6, 0, 0}, crowd.law, all);
    ASSERT_TRUE(all.waiting.empty());
    for (int candidate = 0; candidate < 20; ++candidate) {
      const Vec3 v = crowd.robot.velocity + draws.within(0.0999);
      const bool admitted =
          admits(crowd.robot, v, crowd.law, Asked::until_refused, crowd.constraints);
      ASSERT_EQ(admitted, admits(crowd.robot, v, crowd.law, Asked::until_refused, all)) << k;
      refused += admitted ? 0 : 1;
    }
  }
  EXPECT_GT(refused, 100);
}

TEST(Viewer, leaves_out_no_half_space_that_cuts) {
  Draws draws(32);
  int left_out = 0, cutting = 0;
  for (int k = 0; k < 200; ++k) {
    Crowd crowd(draws, false);
    Looked looked = crowd.seen();
    const Viewer look = crowd.look();
    const Vec3 wish = crowd.robot.velocity + draws.within(0.5);
    const auto numbers = [&] {
      const auto end =
          looked.pairs.number.begin() + static_cast<std::ptrdiff_t>(looked.pairs.count);
      return std::set<double>(looked.pairs.number.begin(), end);
    };
    pairs_that_cut(look, crowd.bodies, looked);
    const std::set<double> cut = numbers();
    pairs_without(look, wish, crowd.bodies, looked);
    const std::set<double> without = numbers();
    for (std::size_t at = 0; at < crowd.bodies.count; ++at) {
      const Neighbor other = crowd.bodies.neighbor(at);
      const PairFrame frame =
          frame_of(crowd.robot.position - other.position, crowd.robot.velocity - other.velocity);
      const RelativeHalfPlane plane =
          half_plane({{frame.distance, 0.0}, frame.velocity, 1.0}, 4.0, crowd.horizon);
      if (plane.state == PairState::free) continue;
      const Vec3 n = turned_back(frame, plane.plane.normal);
      const double offset = dot(n, crowd.robot.velocity) + 0.5 * plane.plane.offset;
      const bool cuts = 0.5 * plane.plane.offset > -2.0 && offset > -2.0;
      if (!cuts) continue;
      ++cutting;
      ASSERT_TRUE(cut.contains(static_cast<double>(at))) << k;
      if (dot(n, wish) < offset) {
        ASSERT_TRUE(without.contains(static_cast<double>(at))) << k;
      }
    }
    left_out += static_cast<int>(crowd.bodies.count - without.size());
    EXPECT_LE(without.size(), cut.size());
  }
  EXPECT_GT(cutting, 1000);
  EXPECT_GT(left_out, 1000);
}

TEST(Viewer, counts_a_robot_ahead_as_far_as_its_course_leads_to_contact) {
  const auto ahead = [](Vec3 place, Vec3 velocity) {
    Draws draws(33);
    Crowd crowd(draws, false);
    crowd.robot.velocity = crowd.robot.preferred_velocity = {2, 0, 0};
    crowd.bodies.clear();
    crowd.bodies.add({.position = place, .velocity = velocity}, 0);
    fill_braking(crowd.law, crowd.bodies);
    return crowd.seen().ahead;
  };
  EXPECT_NEAR(ahead({3, 0, 0}, {-2, 0, 0}), 0.5, 1e-9);  // head-on, at half of the range
  EXPECT_GT(ahead({3, 0, 0.9}, {-2, 0, 0}), 0.4);
  EXPECT_EQ(ahead({3, 0, 2.1}, {-2, 0, 0}), 0.0);  // it passes with two contact distances
  EXPECT_EQ(ahead({-3, 0, 0}, {4, 0, 0}), 0.0);    // behind
  EXPECT_GT(ahead({3, 0, 0}, {}), 0.4);            // at rest on the robot's line
}

// What one body ahead adds to the traffic, by the formula alone.
double weight_of(const Crowd& crowd, double range, const Neighbor& other) {
  const Robot& robot = crowd.robot;
  const Vec3 p = robot.position - other.position, v = robot.velocity - other.velocity;
  const double distance = norm(p), closing = -dot(p, v);
  const double in_front =
      -dot(p, robot.preferred_velocity) / distance / (kInFront * norm(robot.preferred_velocity));
  if (!(distance < range) || !(in_front > 0.0)) return 0.0;
  const double time = closing > 0.0 ? closing / norm_squared(v) : 0.0;
  const double miss = norm(p + time * v) / (robot.radius + other.radius);
  const double closes = 1.0 + closing / distance / (kCloses * robot.max_speed);
  const double rests = 2.0 - norm(other.velocity) / (kSlow * robot.max_speed);
  const double defers = 2.0 * room_share(1.0, 1.0, other.priority, robot.priority);
  return std::clamp(2.0 - miss, 0.0, 1.0) * defers * (1.0 - distance / range) *
         std::clamp(std::max(closes, rests), 0.0, 1.0) * std::min(in_front, 1.0);
}

TEST(Viewer, counts_all_robots_ahead_by_the_formula) {
  Draws draws(35);
  int counted = 0;
  for (int k = 0; k < 1000; ++k) {
    Crowd crowd(draws, k % 2 == 1);
    double expected = 0.0;
    for (std::size_t at = 0; at < crowd.bodies.count; ++at) {
      const double weight = weight_of(crowd, 6.0, crowd.bodies.neighbor(at));
      expected += weight, counted += weight > 0.0 ? 1 : 0;
    }
    ASSERT_NEAR(crowd.seen().ahead, expected, 1e-9) << k;
  }
  EXPECT_GT(counted, 1000);
}

TEST(SpaceCells, find_everybody_within_the_radius_once) {
  Draws draws(34);
  for (int k = 0; k < 40; ++k) {
    const double radius = draws.between(0.5, 10.0), size = draws.between(1.0, 60.0);
    std::vector<Robot> robots(300);
    for (Robot& robot : robots) robot.position = draws.within(size);
    if (k % 4 == 0) robots[7].position = {1e9, -1e12, 3e7};  // an outlier
    if (k % 4 == 1) {
      for (Robot& robot : robots) robot.position = robot.position + Vec3{1e7, -3e7, 2e7};
    }
    SpaceCells cells(radius);
    cells.sort(robots);
    for (const Robot& robot : robots) {
      SpaceCells::Runs runs;
      std::vector<int> found(robots.size(), 0);
      const std::size_t count = cells.around(robot.position, runs);
      for (std::size_t run = 0; run < count; ++run) {
        for (std::size_t at = runs[run].first; at < runs[run].last; ++at)
          ++found[cells.order()[at]];
      }
      for (std::size_t other = 0; other < robots.size(); ++other) {
        ASSERT_LE(found[other], 1);
        if (norm(robots[other].position - robot.position) <= radius) {
          ASSERT_EQ(found[other], 1) << k;
        }
      }
    }
  }
}

TEST(SpaceFleets, decide_as_robots_on_board_bit_for_bit) {
  Scenario scene;
  for (int k = 0; k < 60; ++k) {
    const double angle = 0.7 * k, z = -1.0 + 2.0 * (k + 0.5) / 60.0, r = std::sqrt(1.0 - z * z);
    RobotSetup robot;
    robot.position = 6.0 * Vec3{r * std::cos(2.4 * k), r * std::sin(2.4 * k), z};
    robot.goal = -robot.position + 0.3 * Vec3{std::cos(angle), std::sin(angle), 0.0};
    robot.radius = k % 3 == 0 ? 0.4 : 0.45;
    scene.robots.push_back(robot);
  }
  scene.max_neighbors = 20;
  const Planner planner(planner_options(scene));
  const double range = sensing_radius_of(scene);
  Simulation simulation(scene);
  std::vector<Detour> detours(scene.robots.size());
  PlanWorkspace workspace;
  for (int step = 0; step < 80; ++step) {
    const std::vector<Robot> before(simulation.robots().begin(), simulation.robots().end());
    simulation.step();
    for (std::size_t k = 0; k < before.size(); ++k) {
      std::vector<Neighbor> sensed;
      for (std::size_t other = 0; other < before.size(); ++other) {
        if (other != k &&
            norm_squared(before[other].position - before[k].position) <= range * range)
          sensed.push_back(neighbor_of(before[other]));
      }
      // what it wants in this step is told with the robot after the step
      Robot robot = simulation.robots()[k];
      robot.position = before[k].position, robot.velocity = before[k].velocity;
      const Plan plan = planner.plan(robot, sensed, workspace, &detours[k]);
      ASSERT_EQ(plan.next_velocity, simulation.plans()[k].next_velocity) << step << " " << k;
    }
  }
}

}  // namespace
}  // namespace avo::space::tests
