// SPDX-License-Identifier: Apache-2.0
// Pairs in space that seek contact. They start in motion, as near as joint braking keeps them
// apart, and each takes the admitted velocity that brings them nearest. Judged by space::Check.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "avo/space/check.h"
#include "avo/space/planner.h"
#include "space/own_space.h"
#include "unit/space/crush.h"

namespace avo::space::tests {
namespace {

double own_speed(const Robot& robot) {
  return norm(to_own(robot.velocity, robot.vertical));
}

/// Two robots and their decisions.
class Pair {
 public:
  Pair(Draws draws, double time_step) : draws_(draws) {
    options_.time_step = time_step;
    options_.control_time = options_.time_horizon = std::max(3.0, time_step);
    planner_ = Planner(options_);
    for (Robot& robot : robots_) draw(robot);
    place();
  }

  CheckReport run(int steps) {
    Check check(bodies_of(robots_), {}, CheckOptions{.relative_tolerance = 1e-12});
    const double h = options_.time_step;
    for (int k = 0; k <= steps; ++k) {
      check.add(k * h, std::vector<CheckedState>{{0, robots_[0].position, robots_[0].velocity},
                                                 {1, robots_[1].position, robots_[1].velocity}});
      const Vec3 next[2] = {choose(0), choose(1)};
      for (int i = 0; i < 2; ++i) {
        Robot& robot = robots_[i];
        robot.position = robot.position + (0.5 * h) * (robot.velocity + next[i]);
        robot.velocity = next[i];
      }
    }
    return check.report();
  }

 private:
  void draw(Robot& robot) {
    robot.radius = std::exp(draws_.between(-3.0, -0.2));
    robot.max_acceleration = std::exp(draws_.between(-1.0, 1.0));
    if (draws_.below(2) == 0) robot.max_braking = robot.max_acceleration * draws_.between(0.4, 1.0);
    robot.max_speed = draws_.between(0.5, 6.0) * robot.max_acceleration * options_.time_step;
    robot.vertical = std::exp(draws_.between(-1.0, 0.7));
    if (draws_.below(3) == 0) robot.downwash = draws_.between(0.0, 2.5) * robot.radius;
    do robot.velocity = draws_.within(robot.max_speed);
    while (own_speed(robot) > robot.max_speed);
  }

  Neighbor neighbor(int k) const { return neighbor_of(robots_[k]); }

  bool is_kept_apart() {
    for (int i = 0; i < 2; ++i) {
      const std::vector<Neighbor> other{neighbor(1 - i)};
      if (planner_.plan(robots_[i], other, workspace_).state != SafetyState::safe) return false;
    }
    return true;
  }

  // Often on a collision course.
  void place() {
    Vec3 along = draws_.direction();
    const Vec3 closing = robots_[1].velocity - robots_[0].velocity;
    if (draws_.below(2) == 0) {
      along = closing / norm(closing) + draws_.within(1.0);
      along = along / norm(along);
    }
    double near = 0.0, far = 100.0;  // m
    for (int k = 0; k < 40; ++k) {
      const double middle = 0.5 * (near + far);
      robots_[0].position = middle * along;
      (is_kept_apart() ? far : near) = middle;
    }
    robots_[0].position = (far + 1e-9) * along;
  }

  // m: of each other, once both have braked.
  double apart_at_rest(const Robot& a, Vec3 next, const Robot& b) const {
    const auto stop = [](const Robot& robot, Vec3 v) {
      return (0.5 * norm(v) / robot.max_acceleration) * v;
    };
    const Vec3 p = a.position + (0.5 * options_.time_step) * (a.velocity + next);
    return norm(p + stop(a, next) - b.position - stop(b, b.velocity));
  }

  Vec3 choose(int k) {
    const Robot &robot = robots_[k], &other = robots_[1 - k];
    const std::vector<Neighbor> others{neighbor(1 - k)};
    const auto is_admitted = [&](Vec3 v) {
      return planner_.is_admitted(robot, others, workspace_, v);
    };
    const double braking = robot.max_braking.value_or(robot.max_acceleration);
    const double speed = own_speed(robot), less = braking * options_.time_step;
    const Vec3 backup = speed > less ? (1.0 - less / speed) * robot.velocity : Vec3{};
    const Vec3 there = other.position - robot.position;
    Vec3 chosen = backup;
    double least = apart_at_rest(robot, backup, other);
    for (int attempt = 0; attempt < 10; ++attempt) {
      Vec3 direction = draws_.direction();
      if (attempt < 4) direction = there / norm(there) + (0.25 * attempt) * direction;
      if (attempt == 4) direction = other.velocity - robot.velocity;
      const Vec3 wish = towards(robot, direction, options_.time_step);
      double admitted = 0.0, refused = 1.0;  // shares of the change from braking to the wish
      if (is_admitted(wish)) admitted = 1.0;
      for (int halving = 0; halving < 7 && admitted < 1.0; ++halving) {
        const double part = 0.5 * (admitted + refused);
        (is_admitted(backup + part * (wish - backup)) ? admitted : refused) = part;
      }
      const Vec3 v = backup + admitted * (wish - backup);
      const double apart = apart_at_rest(robot, v, other);
      if (apart < least) least = apart, chosen = v;
    }
    return chosen;
  }

  Draws draws_;
  PlannerOptions options_;
  Planner planner_{PlannerOptions{}};
  Robot robots_[2];
  PlanWorkspace workspace_;
};

TEST(SpacePairs, that_seek_contact_do_not_touch) {
  double clearance = 1e9;
  for (std::uint64_t k = 0; k < 2000; ++k) {
    const double time_steps[] = {0.1, 0.2, 0.4, 0.8, 1.5};
    const CheckReport report = Pair(Draws(1000 + k), time_steps[k % 5]).run(8);
    ASSERT_EQ(report.overlaps.count, 0) << k << ": " << report.overlaps.worst;
    ASSERT_EQ(report.accelerations.count, 0) << k << ": " << report.accelerations.worst;
    clearance = std::min(clearance, report.least_clearance.value_or(1e9));
  }
  EXPECT_LT(clearance, 1e-6) << "they come close: otherwise nothing has been tried";
}

}  // namespace
}  // namespace avo::space::tests
