// SPDX-License-Identifier: Apache-2.0
// Every step of the proof in docs/certificate/walls.md is needed: without it a directed search
// finds a robot that overlaps a wall, and with it the same search finds none. The rule is written
// out plainly here, for held motion.
#include <functional>
#include <gtest/gtest.h>
#include <string>

#include "support/walls.h"

namespace avo::test {
namespace {

// What rounding may cost: the plain rule is not inflated.
constexpr double kWallRounding = 1e-9;
constexpr double kTimeStep = 0.4;  // s

struct WallRule {
  bool tests_step = true;       // or only where braking after it leads
  bool discrete_length = true;  // or v²/2a
  bool whole_capsule = true;    // or where the robot stops only
};

double length_of(const WallRule& rule, double speed, double u) {
  const StepLaw law{.time_step = kTimeStep, .lag = 0.5 * kTimeStep, .braking_time = kTimeStep};
  return rule.discrete_length ? stopping_length(speed, u, law)
                              : 0.5 * speed * speed * kTimeStep / u;
}

// m, from a segment to a wall's surface: where they do not cross, one of the ends is nearest.
double between(Vec2 a, Vec2 b, const Wall& wall) {
  const Vec2 d = b - a, e = wall.b - wall.a;
  const bool meets = cross(d, wall.a - a) * cross(d, wall.b - a) < 0.0 &&
                     cross(e, a - wall.a) * cross(e, b - wall.a) < 0.0;
  if (meets) return 0.0;
  const Wall way{a, b, wall.radius};
  return std::min({gap_to(a, wall), gap_to(b, wall), gap_to(wall.a, way), gap_to(wall.b, way)});
}

bool admits(const WallRule& rule, const Robot& robot, Vec2 next, const std::vector<Wall>& walls) {
  const double u = robot.max_acceleration * kTimeStep, speed = norm(next), r = robot.radius;
  const Vec2 p = robot.position, middle = p + 0.5 * kTimeStep * robot.velocity;
  const Vec2 first = middle + 0.5 * kTimeStep * next;
  const Vec2 stop = speed > 0.0 ? first + (length_of(rule, speed, u) / speed) * next : first;
  return std::all_of(walls.begin(), walls.end(), [&](const Wall& wall) {
    const bool steps =
        !rule.tests_step || (between(middle, first, wall) >= r && between(p, first, wall) >= r);
    return steps && between(rule.whole_capsule ? first : stop, stop, wall) >= r;
  });
}

// m by which a robot that pushes as hard as the rule admits overlaps a wall at most; it brakes in
// the end.
double deepest_overlap(const WallRule& rule) {
  const PlannerOptions options =
      options_of(Certificate::braking_trajectories, Motion::held, kTimeStep, 2.0);
  double least = std::numeric_limits<double>::infinity();
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    Random random(seed);
    Robot robot;
    robot.radius = random.uniform(0.3, 0.5);
    robot.max_acceleration = random.uniform(1.0, 3.0);
    robot.max_speed = random.uniform(1.0, 4.0);
    const double u = robot.max_acceleration * kTimeStep;
    const std::vector<Wall> walls = random_walls(random, 8.0, robot.radius);
    robot.position = free_place(random, walls, 8.0, robot.radius + 1e-6);
    Vec2 direction = random.direction();
    bool overlaps = false;  // then nothing is promised any more: it brakes
    for (int k = 0; k < 100; ++k) {
      if (random.below(6) == 0) direction = random.direction();
      const Vec2 backup = braked(robot.velocity, u), pushed = robot.velocity + u * direction;
      const double speed = norm(pushed);
      const Vec2 wish = speed > robot.max_speed ? (robot.max_speed / speed) * pushed : pushed;
      Vec2 next = backup;
      for (double part = 1.0; k < 90 && !overlaps && part > 1e-3; part *= 0.7) {
        const Vec2 candidate = backup + part * (wish - backup);
        if (!admits(rule, robot, candidate, walls)) continue;
        next = candidate;
        break;
      }
      const TrueStep step{robot.position, robot.velocity, next};
      const double gap = least_gap(step, walls, options) - robot.radius;
      least = std::min(least, gap);
      overlaps = overlaps || gap < -kWallRounding;
      robot.position = step.at(kTimeStep, options);
      robot.velocity = next;
    }
  }
  return -least;
}

void expect_needed(const WallRule& broken, double depth) {
  const double deepest = deepest_overlap(broken);
  testing::Test::RecordProperty("overlap", std::to_string(deepest));
  EXPECT_GE(deepest, depth);
  EXPECT_LE(deepest_overlap(WallRule{}), kWallRounding);
}

TEST(BrokenWallProof, step) {
  WallRule broken;
  broken.tests_step = false;
  expect_needed(broken, 0.01);
}

TEST(BrokenWallProof, continuous_stopping_length) {
  WallRule broken;
  broken.discrete_length = false;
  expect_needed(broken, 0.03);
}

TEST(BrokenWallProof, end_of_braking_only) {
  WallRule broken;
  broken.whole_capsule = false;
  expect_needed(broken, 0.3);
}

}  // namespace
}  // namespace avo::test
