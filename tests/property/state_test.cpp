// SPDX-License-Identifier: Apache-2.0
// The tests check docs/states.md by brute force. No robot escapes from doomed, and few other robots
// cannot escape. A robot that is safe brakes without contact.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <span>
#include <vector>

#include "avo/planner.h"
#include "support/generators.h"
#include "support/walls.h"

namespace avo::test {
namespace {

constexpr double kNoLimit = 1e9;  // m/s

// A and one of the others: a neighbor, or a wall.
struct Meeting {
  Robot robot;
  Neighbor neighbor;
  Wall wall;
  bool at_wall = false;

  double contact() const { return robot.radius + (at_wall ? wall.radius : neighbor.radius); }
};

SafetyReport state_of(const Meeting& meeting, const PlannerOptions& options = {}) {
  PlanWorkspace workspace;
  const Planner planner(options);
  if (meeting.at_wall)
    return planner.state(meeting.robot, {}, workspace, std::span(&meeting.wall, 1));
  return planner.state(meeting.robot, std::span(&meeting.neighbor, 1), workspace);
}

Meeting random_meeting(Random& random, bool at_wall) {
  Meeting meeting;
  meeting.at_wall = at_wall;
  Robot& robot = meeting.robot;
  robot.radius = random.log_uniform(0.03, 1.0);
  robot.max_acceleration = random.log_uniform(0.3, 3.0);
  robot.max_speed = random.log_uniform(0.2, 4.0);
  robot.velocity = random.uniform(0.3, 1.0) * robot.max_speed * random.direction();
  if (random.below(4) == 0) robot.velocity = {};
  Neighbor& other = meeting.neighbor;
  other.radius = random.uniform(0.1, 1.0);
  other.max_acceleration = random.log_uniform(0.3, 3.0);
  other.behavior = random.below(2) == 0 ? Behavior::decides : Behavior::moves_on;
  const double gap = random.log_uniform(1e-3, 3.0);
  other.position = (robot.radius + other.radius + gap) * random.direction();
  other.velocity = in_disc(random, 4.0);
  other.acceleration = in_disc(random, random.below(2) == 0 ? 0.0 : 2.0);
  if (random.below(3) == 0) {
    robot.max_braking = random.log_uniform(0.5, 3.0) * robot.max_acceleration;
    other.max_braking = random.log_uniform(0.5, 3.0) * other.max_acceleration;
  }
  meeting.wall.radius = random.below(2) == 0 ? 0.0 : other.radius;
  do {
    meeting.wall.a = random.uniform(0.0, 2.5) * random.direction();
    meeting.wall.b = meeting.wall.a + random.log_uniform(0.1, 10.0) * random.direction();
  } while (gap_to({}, meeting.wall) < robot.radius);
  return meeting;
}

// Accelerations one after the other, each for an equal time.
using Control = std::vector<Vec2>;

Control random_control(Random& random, double max_acceleration) {
  Control control(static_cast<std::size_t>(1 + random.below(4)));
  for (Vec2& a : control)
    a = random.below(3) == 0 ? in_disc(random, max_acceleration)
                             : max_acceleration * random.direction();
  return control;
}

struct Point {
  Vec2 position, velocity;

  // A velocity that the limit cuts off has changed by no more than a does.
  void move(const Control& control, double part, double max_speed, double dt) {
    const auto piece = static_cast<std::size_t>(part * static_cast<double>(control.size()));
    Vec2 next = velocity + dt * control[std::min(piece, control.size() - 1)];
    const double limit = std::max(max_speed, norm(velocity));
    if (norm(next) > limit) next = (limit / norm(next)) * next;
    position = position + (0.5 * dt) * (velocity + next);
    velocity = next;
  }
};

// m: the least gap until the time, while both do as they are told.
double least_gap(const Meeting& meeting, double time, const Control& own, const Control& others) {
  constexpr int kSteps = 200;
  Point a{meeting.robot.position, meeting.robot.velocity};
  Point b{meeting.neighbor.position, meeting.neighbor.velocity};
  const auto gap = [&] {
    const double away = meeting.at_wall ? gap_to(a.position, {meeting.wall.a, meeting.wall.b, 0.0})
                                        : norm(a.position - b.position);
    return away - meeting.contact();
  };
  double least = gap();
  for (int k = 0; k < kSteps; ++k) {
    const double part = (k + 0.5) / kSteps;
    a.move(own, part, meeting.robot.max_speed, time / kSteps);
    b.move(others, part, kNoLimit, time / kSteps);
    least = std::min(least, gap());
  }
  return least;
}

// Returns whether some of many controls avoid contact until the time.
bool can_escape(const Meeting& meeting, double time, int ways, Random& random) {
  const Neighbor& other = meeting.neighbor;
  const bool decides = other.behavior == Behavior::decides;
  constexpr double kTouch = 1e-7;
  for (int way = 0; way < ways; ++way) {
    const double angle = 2.0 * std::numbers::pi * way / ways;
    const Vec2 d{std::cos(angle), std::sin(angle)};
    const double a_A = change_limit(meeting.robot), a_B = change_limit(other);
    const Control kept{other.acceleration};
    if (least_gap(meeting, time, {a_A * d}, decides ? Control{-a_B * d} : kept) > kTouch)
      return true;
    const Control own = random_control(random, a_A);
    if (least_gap(meeting, time, own, decides ? random_control(random, a_B) : kept) > kTouch)
      return true;
  }
  return false;
}

void nothing_escapes(bool at_wall) {
  Random random(at_wall ? 71 : 70);
  int doomed = 0, by_speed = 0;
  for (int k = 0; k < 15'000; ++k) {
    const Meeting meeting = random_meeting(random, at_wall);
    const SafetyReport report = state_of(meeting);
    if (report.state != SafetyState::doomed) continue;
    ++doomed;
    EXPECT_EQ(at_wall ? report.wall : report.neighbor, 0);
    EXPECT_EQ(at_wall ? report.neighbor : report.wall, -1);
    EXPECT_FALSE(can_escape(meeting, report.time, 40, random)) << k;
    Meeting unlimited = meeting;
    unlimited.robot.max_speed = 100.0;
    by_speed += state_of(unlimited).state != SafetyState::doomed ? 1 : 0;
  }
  EXPECT_GT(doomed, 400);
  EXPECT_TRUE(at_wall || by_speed > 10) << by_speed;
}

TEST(State, nothing_escapes_from_one_that_dooms) {
  nothing_escapes(false);
}

TEST(State, nothing_escapes_from_a_wall_that_dooms) {
  nothing_escapes(true);
}

// Most of the states for which the search finds no escape are proved.
void most_are_proved(bool at_wall, double share) {
  Random random(at_wall ? 73 : 72);
  int lost = 0, proved = 0;
  for (int k = 0; k < 4000; ++k) {
    const Meeting meeting = random_meeting(random, at_wall);
    if (can_escape(meeting, 4.0, 60, random)) continue;
    ++lost;
    proved += state_of(meeting).state == SafetyState::doomed ? 1 : 0;
  }
  EXPECT_GT(lost, 100);
  EXPECT_GT(proved, share * lost) << proved << " of " << lost;
}

TEST(State, most_that_cannot_escape_are_doomed) {
  most_are_proved(false, 0.97);
  most_are_proved(true, 0.97);
}

// Full braking in steps of Δt, at a time.
struct Stop {
  Vec2 position, velocity;
  double braking = 0.0;  // m/s^2

  double time(double dt) const { return dt * std::ceil(norm(velocity) / (braking * dt)); }
  Vec2 at(double t, double dt) const {
    Vec2 p = position, v = velocity;
    for (; t > 0.0 && !(v == Vec2{}); t -= dt) {
      const double speed = norm(v), left = std::max(speed - braking * dt, 0.0);
      const double h = std::min(t, dt);
      p = p + h * v - (0.5 * h * h / dt) * (v - (left / speed) * v);
      v = (left / speed) * v;
    }
    return p;
  }
};

// m: the least gap while A brakes, and a neighbor that decides too.
double gap_of_braking(const Meeting& meeting, double dt) {
  constexpr int kSamples = 400;
  const Robot& robot = meeting.robot;
  const Neighbor& other = meeting.neighbor;
  const bool decides = other.behavior == Behavior::decides;
  const Stop a{robot.position, robot.velocity, braking_limit(robot)};
  const Stop b{other.position, other.velocity, braking_limit(other)};
  const double time = decides && !meeting.at_wall ? std::max(a.time(dt), b.time(dt)) : a.time(dt);
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= kSamples; ++k) {
    const double t = time * k / kSamples;
    const Vec2 q = decides
                       ? b.at(t, dt)
                       : other.position + t * other.velocity + (0.5 * t * t) * other.acceleration;
    const Vec2 p = a.at(t, dt);
    least = std::min(
        least, meeting.at_wall ? gap_to(p, {meeting.wall.a, meeting.wall.b, 0.0}) : norm(p - q));
  }
  return least - meeting.contact();
}

void braking_tells(bool at_wall) {
  Random random(at_wall ? 75 : 74);
  int safe = 0, clear = 0, doomed_in_time = 0;
  const double dt = PlannerOptions{}.time_step;
  for (int k = 0; k < 6000; ++k) {
    const Meeting meeting = random_meeting(random, at_wall);
    const SafetyState state = state_of(meeting).state;
    const double gap = gap_of_braking(meeting, dt);
    const bool decides = at_wall || meeting.neighbor.behavior == Behavior::decides;
    clear += gap > 0.0 ? 1 : 0;
    if (state == SafetyState::safe) {
      ++safe;
      EXPECT_GT(gap, -1e-9) << k;
    } else if (state == SafetyState::doomed && gap > 1e-3) {
      EXPECT_FALSE(decides) << k;
      ++doomed_in_time;  // at rest when it is touched
    }
  }
  EXPECT_GT(clear, 1000);
  EXPECT_GT(safe + doomed_in_time, 0.97 * clear) << safe << " of " << clear;
}

TEST(State, whoever_is_safe_brakes_without_contact_and_nearly_all_who_can_are_safe) {
  braking_tells(false);
  braking_tells(true);
}

// What is sensed is off, or was sensed some steps ago.
TEST(State, holds_for_all_that_errors_and_age_allow) {
  Random random(76);
  int doomed = 0, safe = 0, weaker = 0;
  for (int k = 0; k < 20'000; ++k) {
    Meeting meeting = random_meeting(random, false);
    PlannerOptions options;
    options.sensing_error = {random.uniform(0.0, 0.1), random.uniform(0.0, 0.3)};
    meeting.neighbor.age = random.below(4);
    const SafetyReport report = state_of(meeting, options);
    if (report.state == SafetyState::unknown) {
      meeting.neighbor.age = 0;
      weaker += state_of(meeting).state != SafetyState::unknown ? 1 : 0;
      continue;
    }
    const bool decides = meeting.neighbor.behavior == Behavior::decides;
    const double late = meeting.neighbor.age * options.time_step;
    const double a = decides ? change_limit(meeting.neighbor) : 0.0;
    const auto& [position, velocity] = options.sensing_error;
    const Vec2 e_v = in_disc(random, velocity), done = in_disc(random, a);
    meeting.neighbor.position = meeting.neighbor.position + position * random.direction() +
                                late * e_v + (0.5 * late * late) * done;
    meeting.neighbor.velocity = meeting.neighbor.velocity + e_v + late * done;
    if (report.state == SafetyState::safe) {
      ++safe;
      EXPECT_GT(gap_of_braking(meeting, options.time_step), -1e-9) << k;
    } else {
      ++doomed;
      EXPECT_FALSE(can_escape(meeting, report.time, 12, random)) << k;
    }
  }
  EXPECT_GT(safe, 1000);
  EXPECT_GT(doomed, 500);
  EXPECT_GT(weaker, 500);
}

}  // namespace
}  // namespace avo::test
