// SPDX-License-Identifier: Apache-2.0
// Many robots: against all pairs one by one, and against the metrics of the simulation.
#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <optional>
#include <set>
#include <vector>

#include "avo/metrics.h"
#include "avo/simulation.h"
#include "check/relative_path.h"
#include "support/generators.h"
#include "unit/check/recordings.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::free_robot;
using test::Moment;
using test::Random;
using test::report_of;

struct Fleet {
  std::vector<CheckedRobot> robots;
  std::vector<Moment> recording;
};

// Robots follow random courses in a box. Now and then a robot is missing, and radii are of very
// different size.
Fleet random_fleet(Random& random, std::size_t number, Vec2 box) {
  Fleet fleet;
  for (std::size_t i = 0; i < number; ++i)
    fleet.robots.push_back(free_robot(i % 13 == 0 ? 2.0 : random.log_uniform(0.05, 0.5)));
  for (int k = 0; k <= 8; ++k) {
    Moment moment{0.25 * k, {}};
    for (std::size_t i = 0; i < number; ++i) {
      if (random.below(20) == 0) continue;
      const double x = random.uniform(-box.x, box.x), y = random.uniform(-box.y, box.y);
      const Vec2 velocity = test::in_disc(random, 4.0);
      moment.rows.push_back({static_cast<std::int64_t>(i), {x, y}, velocity});
    }
    fleet.recording.push_back(moment);
  }
  return fleet;
}

const CheckedState* row_of(const Moment& moment, std::int64_t robot) {
  const auto found = std::find_if(moment.rows.begin(), moment.rows.end(),
                                  [robot](const CheckedState& row) { return row.robot == robot; });
  return found == moment.rows.end() ? nullptr : &*found;
}

// The pair's nearest instant between two times, where both are there at one of them at least.
std::optional<judge::Instant> nearest(const Moment& before, const Moment& now, std::int64_t a,
                                      std::int64_t b) {
  const CheckedState *a1 = row_of(now, a), *b1 = row_of(now, b);
  const CheckedState *a0 = row_of(before, a), *b0 = row_of(before, b);
  if (a1 == nullptr || b1 == nullptr) return std::nullopt;
  const Vec2 to = a1->position - b1->position;
  if (a0 == nullptr || b0 == nullptr) return judge::Instant{1.0, norm(to)};
  const double third = (now.time - before.time) / 3.0;
  const Vec2 from = a0->position - b0->position;
  return judge::nearest_instant(
      judge::RelativePath{{from, from + third * (a0->velocity - b0->velocity),
                           to - third * (a1->velocity - b1->velocity), to}});
}

struct Expected {
  std::set<std::pair<std::int64_t, std::int64_t>> pairs;
  double least = std::numeric_limits<double>::infinity(), worst = 0.0;
  double first_from = 0.0, first_to = 0.0;  // the first overlap is between these times
};

Expected all_pairs(const Fleet& fleet) {
  Expected expected;
  const auto number = static_cast<std::int64_t>(fleet.robots.size());
  for (std::size_t k = 0; k < fleet.recording.size(); ++k) {
    const Moment &before = fleet.recording[k == 0 ? 0 : k - 1], &now = fleet.recording[k];
    for (std::int64_t a = 0; a < number; ++a) {
      for (std::int64_t b = a + 1; b < number; ++b) {
        const auto instant = nearest(before, now, a, b);
        if (!instant) continue;
        const double contact = fleet.robots[static_cast<std::size_t>(a)].radius +
                               fleet.robots[static_cast<std::size_t>(b)].radius;
        expected.least = std::min(expected.least, instant->distance - contact);
        if (!(instant->distance < contact * (1.0 - 1e-9))) continue;
        if (expected.pairs.empty()) {
          expected.first_from = before.time;
          expected.first_to = now.time;
        }
        expected.pairs.insert({a, b});
        expected.worst = std::max(expected.worst, contact * (1.0 - 1e-9) - instant->distance);
      }
    }
  }
  return expected;
}

TEST(CheckFleets, agree_with_all_pairs_one_by_one) {
  Random random(6);
  for (const Vec2 box : {Vec2{20, 20}, Vec2{200, 200}, Vec2{0.0, 300}, Vec2{300, 1}, Vec2{2, 2}}) {
    for (int k = 0; k < 10 && !HasFailure(); ++k) {
      const Fleet fleet = random_fleet(random, 2 + 6 * static_cast<std::size_t>(k), box);
      const Expected expected = all_pairs(fleet);
      const CheckReport report = report_of(fleet.robots, fleet.recording);
      EXPECT_EQ(report.overlaps.count, static_cast<std::int64_t>(expected.pairs.size()));
      EXPECT_EQ(report.least_clearance.value_or(expected.least), expected.least);
      EXPECT_EQ(report.overlaps.worst, expected.worst);
      ASSERT_EQ(report.overlaps.first.has_value(), !expected.pairs.empty());
      if (!report.overlaps.first) continue;
      EXPECT_GE(report.overlaps.first->time, expected.first_from);
      EXPECT_LE(report.overlaps.first->time, expected.first_to);
    }
  }
}

// The same robots under other numbers: the same report, by their new numbers.
TEST(CheckFleets, the_numbers_of_the_robots_do_not_matter) {
  Random random(7);
  const Fleet fleet = random_fleet(random, 40, {15, 15});
  Fleet turned = fleet;
  std::reverse(turned.robots.begin(), turned.robots.end());
  for (Moment& moment : turned.recording) {
    std::reverse(moment.rows.begin(), moment.rows.end());
    for (CheckedState& row : moment.rows) row.robot = 39 - row.robot;
  }
  const CheckReport one = report_of(fleet.robots, fleet.recording);
  const CheckReport other = report_of(turned.robots, turned.recording);
  EXPECT_GT(one.overlaps.count, 10);
  EXPECT_EQ(one.overlaps.count, other.overlaps.count);
  EXPECT_EQ(one.least_clearance, other.least_clearance);
  EXPECT_EQ(one.overlaps.first->time, other.overlaps.first->time);
  EXPECT_EQ(one.overlaps.first->robot, 39 - *other.overlaps.first->other);
  EXPECT_EQ(one.gaps, other.gaps);
}

// A crowd that collides, by the paper's method alone. The judge reads rows, and the metrics observe
// the simulation; both share the distances within a step, and nothing else. Many pairs pass in
// exact contact: without the interpolation error of exponential motion six more overlap, with it a
// contact by less than that error is none.
TEST(CheckFleets, agree_with_the_metrics_of_a_run) {
  for (const Motion motion : {Motion::held, Motion::exponential}) {
    Scenario scene = test::dense_scene(60, motion);
    scene.method = Method::avo_paper;
    for (RobotSetup& each : scene.robots) each.model = Holonomic{};
    scene.obstacles = {{{{{{-6, -4}, {5, -7}, {7, 3}}}}, 0.0}, {{{{{0, 6}}}}, 0.7}};
    std::vector<CheckedRobot> robots;
    for (const RobotSetup& each : scene.robots) {
      robots.push_back({each.radius, each.max_acceleration, each.max_speed, each.goal});
      if (motion == Motion::exponential)  // Δt⁴ a_max/(384 δ²)
        robots.back().interpolation_error = 1e-4 * each.max_acceleration / (384.0 * 2.0 * 2.0);
    }
    std::vector<CheckedMover> obstacles;
    for (const MovingObstacle& each : scene.moving_obstacles)
      obstacles.push_back({each.position, each.velocity, each.acceleration, each.radius});
    std::vector<CheckedWall> walls;
    for (const Wall& each : walls_of(scene.obstacles))
      walls.push_back({each.a, each.b, each.radius});
    Check check(robots, obstacles, {.arrival_distance = scene.arrival_distance});
    check.set_walls(walls);
    Simulation simulation(scene, 1);
    Metrics metrics(scene);
    for (int k = 0; k <= 400; ++k) {
      if (k > 0) simulation.step();
      std::vector<CheckedState> rows;
      const FleetView now = simulation.fleet();
      for (std::size_t i = 0; i < now.id.size(); ++i)
        rows.push_back({static_cast<std::int64_t>(i), now.position[i], now.velocity[i]});
      check.add(simulation.time(), rows);
      metrics.observe(simulation);
    }
    const CheckReport report = check.report();
    const RunSummary summary = metrics.summary();
    SCOPED_TRACE(motion == Motion::held ? "held" : "exponential");
    const std::int64_t contacts =
        report.mover_contacts_moving.count + report.mover_contacts_at_rest;
    EXPECT_GT(report.overlaps.count, 10);
    EXPECT_GT(contacts, 10);
    EXPECT_LE(report.overlaps.count, summary.collision_pairs);
    EXPECT_LE(contacts, summary.mover_collisions);
    if (motion == Motion::held) {
      EXPECT_EQ(report.overlaps.count, summary.collision_pairs);
      EXPECT_EQ(contacts, summary.mover_collisions);
    }
    EXPECT_NEAR(report.overlaps.first->time, *summary.first_collision_time, 1e-6);
    EXPECT_NEAR(*report.least_clearance, *summary.min_clearance, 1e-7);
    EXPECT_LE(report.static_contacts.count, summary.static_collisions);
    if (motion == Motion::held) {
      EXPECT_EQ(report.static_contacts.count, summary.static_collisions);
    }
    EXPECT_NEAR(*report.least_static_clearance, *summary.min_static_clearance, 1e-7);
    EXPECT_EQ(report.arrived, summary.arrived);
    EXPECT_NEAR(report.largest_speed, summary.max_speed, 1e-12);
    EXPECT_EQ(report.accelerations.count + report.speeds.count + report.jumps.count, 0);
  }
}

}  // namespace
}  // namespace avo
