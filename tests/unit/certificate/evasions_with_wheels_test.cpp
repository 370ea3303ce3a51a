// SPDX-License-Identifier: Apache-2.0
// Evasive maneuvers of robots with wheels (docs/movers.md): their arcs are clear where maneuvers
// are called clear, and what is left of a maneuver after a step is one.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <vector>

#include "certificate/evasions.h"
#include "core/elementary.h"
#include "core/plane.h"
#include "robots/model.h"
#include "support/generators.h"

namespace avo {
namespace {

MotionModel model_of(test::Random& random, int kind) {
  const Footprint row{.discs = 3, .radius = 0.4, .first = -0.3, .spacing = 0.6};
  if (kind == 0) return DifferentialDrive{};
  if (kind == 6) return DifferentialDrive{.footprint = row};
  Car car;
  if (kind >= 2) car.max_curvature = random.uniform(0.3, 1.5);
  if (kind >= 3) car.reverse = true;
  if (kind == 4) car.body = CarBody{random.uniform(-0.6, 0.6), 0.5};
  if (kind == 5) car.footprint = row;
  return car;
}
constexpr int kKinds = 7;

struct Case {
  Robot robot;
  EvasionOptions options;
  Surroundings around;
  EvasionState now;
  Vec2 w;

  Vec2 next() { return next_towards(at(), now, w); }
  const EvasionOptions& at() {
    options.wheels = &robot;
    if (const Footprint row = footprint_of(robot.model))
      options.footprint = row, options.lever = farthest_center(row);
    return options;
  }
};

Case random_case(test::Random& random, int kind) {
  Case result;
  Robot& robot = result.robot;
  const double h = random.log_uniform(0.05, 0.4);
  robot.model = model_of(random, kind % kKinds);
  robot.max_acceleration = random.log_uniform(0.5, 2.0), robot.max_speed = 1.5;
  robot.heading = random.uniform(-std::numbers::pi, std::numbers::pi);
  const bool backwards = model_traits(robot.model).can_reverse && random.below(2) == 0;
  const double speed = random.uniform(0.0, 1.0) * (backwards ? -1.0 : 1.0);
  // a drive turns while it brakes if its velocity is off its heading
  const double off = kind % kKinds == 6 ? random.uniform(-2.0, 2.0) : 0.0;  // rad
  robot.velocity = speed * elementary::direction(robot.heading + off);
  result.now = {{}, robot.velocity, 0.0, robot.heading};
  EvasionOptions& options = result.options;
  options.law = {.time_step = h, .lag = 0.5 * h, .braking_time = h};
  options.decrement = robot.max_acceleration * h;
  options.increment = (kind % 2 == 0 ? 0.6 : 1.0) * options.decrement;
  options.max_speed = model_traits(robot.model).speed_ratio * robot.max_speed;
  options.longest = 4.0;
  for (int k = 0; k <= kind % 3; ++k) {
    Predicted other;
    other.position = random.uniform(0.5, 6.0) * random.direction();
    other.velocity = random.uniform(0.0, 2.0) * random.direction();
    other.contact = other.stop_contact = random.uniform(0.3, 1.2);
    other.asks_to_stop = k % 2 == 0;
    other.fastest = norm(other.velocity);
    result.around.others.push_back(other);
  }
  if (kind % 7 == 0)
    result.around.walls.push_back({{{1.0, -4.0}, {1.0, 4.0}}, random.uniform(0.2, 0.6)});
  result.w = 1.5 * random.direction();
  return result;
}

bool has_clear_evasion(Case& c) {
  begin_evasions(c.at(), c.around);
  return take_first_step(c.at(), c.around, c.now, c.next()) && may_approach(c.at(), c.around, c.w);
}

bool has_clear_braking(Case& c) {
  begin_evasions(c.at(), c.around);
  return take_first_step(c.at(), c.around, c.now, braked(c.now.velocity, c.options.decrement)) &&
         may_brake(c.at(), c.around);
}

MotionState moved(const Case& c, const MotionState& from, Vec2 next_velocity) {
  Robot robot = c.robot;
  robot.velocity = from.velocity, robot.heading = from.heading;
  return advance(robot.model, {planned_braking(robot), robot.max_speed}, from,
                 plan_to(robot, next_velocity, c.options.law), c.options.law.time_step)
      .next;
}

// The centers of its discs.
std::vector<Vec2> centers_of(const MotionModel& model, const MotionState& at) {
  const Footprint row = footprint_of(model);
  if (!row) return {at.position};
  std::vector<Vec2> centers;
  for (int k = 0; k < row.discs; ++k)
    centers.push_back(at.position + row.ahead(k) * elementary::direction(at.heading));
  return centers;
}

// m, least room within a step from that time on.
double sampled_step(const Case& c, const MotionState& from, const MotionState& to, double time) {
  constexpr int kParts = 16;
  const double h = c.options.law.time_step;
  double least = std::numeric_limits<double>::infinity();
  for (int part = 0; part < kParts; ++part) {
    const double t = h * part / kParts;
    const MotionState at = within(c.robot.model, from, to, t, h);
    for (const Vec2 place : centers_of(c.robot.model, at)) {
      for (const Predicted& other : c.around.others)
        least = std::min(least, norm(place - other.place_at(time + t)) - other.contact);
      for (const KeptWall& wall : c.around.walls)
        least = std::min(least, distance(place, wall.segment) - wall.kept);
    }
  }
  return least;
}

// m, of braking from that state on, and at rest behind it.
double sampled_braking(const Case& c, MotionState state, double time) {
  double least = std::numeric_limits<double>::infinity();
  const double h = c.options.law.time_step;
  while (state.velocity != Vec2{}) {
    const MotionState next = moved(c, state, braked(state.velocity, c.options.decrement));
    least = std::min(least, sampled_step(c, state, next, time));
    state = next, time += h;
  }
  for (double t = time; t < time + 20.0; t += h)
    least = std::min(least, sampled_step(c, state, state, t));
  return least;
}

TEST(EvasionsWithWheels, that_are_clear_touch_nobody) {
  test::Random random(21);
  int clear = 0;
  for (int trial = 0; trial < 800; ++trial) {
    Case c = random_case(random, trial);
    if (!has_clear_evasion(c)) continue;
    ++clear;
    MotionState state{{}, c.now.velocity, c.now.heading};
    double room = std::numeric_limits<double>::infinity(), best = -1.0, time = 0.0;
    const double h = c.options.law.time_step;
    for (bool first = true; time <= c.options.longest + h && best < -1e-6; first = false) {
      if (!first) best = std::min(room, sampled_braking(c, state, time));
      const Vec2 next = next_towards(c.at(), {{}, state.velocity, 0.0, state.heading}, c.w);
      const MotionState later = moved(c, state, next);
      room = std::min(room, sampled_step(c, state, later, time));
      state = later, time += h;
    }
    ASSERT_GE(best, -1e-6) << trial << ": it brakes nowhere in that maneuver without being touched";
  }
  EXPECT_GT(clear, 200);
}

// As A sees it after a step of its maneuver, others as they were predicted.
Case after_step(Case& c) {
  Case later = c;
  const MotionState next = moved(c, {{}, c.now.velocity, c.now.heading}, c.next());
  const double h = c.options.law.time_step;
  for (Predicted& other : later.around.others) {
    other.position = other.place_at(h) - next.position;
    other.contact -= 1e-9, other.stop_contact -= 1e-9;
  }
  for (KeptWall& wall : later.around.walls)
    wall = {{wall.segment.a - next.position, wall.segment.b - next.position}, wall.kept - 1e-9};
  later.robot.velocity = next.velocity, later.robot.heading = next.heading;
  later.now = {{}, next.velocity, 0.0, next.heading};
  return later;
}

TEST(EvasionsWithWheels, what_is_left_of_a_clear_maneuver_is_one) {
  test::Random random(22);
  int clear = 0;
  for (int trial = 0; trial < 6000; ++trial) {
    Case c = random_case(random, trial);
    if (!has_clear_evasion(c)) continue;
    ++clear;
    Case later = after_step(c);
    const bool brakes = has_clear_braking(later), goes_on = has_clear_evasion(later);
    ASSERT_TRUE(brakes || goes_on) << trial;
    const Vec2 next = goes_on ? later.next() : braked(later.now.velocity, later.options.decrement);
    ASSERT_TRUE(stops_in_time(later.at(), later.around, later.now, next))
        << trial << ": the certificate would refuse it";
  }
  EXPECT_GT(clear, 1500);
}

// An arc comes nearer to some places than the parabola between its ends.
TEST(EvasionsWithWheels, keep_clear_of_what_the_arc_of_a_step_touches) {
  test::Random random(23);
  for (int trial = 0; trial < 4000; ++trial) {
    Case c = random_case(random, kKinds * trial + 4);  // with a disc off the axle
    c.around.walls.clear(), c.around.others.resize(1);
    Predicted& other = c.around.others[0];
    other.position = random.uniform(0.1, 1.0) * random.direction(), other.velocity = {};
    other.contact = other.fastest = 0.0;
    const MotionState from{{}, c.now.velocity, c.now.heading};
    other.contact = sampled_step(c, from, moved(c, from, c.next()), 0.0) + 1e-9;
    begin_evasions(c.at(), c.around);
    ASSERT_FALSE(take_first_step(c.at(), c.around, c.now, c.next())) << trial;
    // the step also fails by either disc of a body that does as it likes and may be touched at rest
    // alone
    other.asks_to_stop = true, other.stop_contact = other.contact;
    for (const double deviation : {0.0, 1e-12}) {
      other.deviation = deviation, other.max_speed = 0.0;
      ASSERT_FALSE(stops_in_time(c.at(), c.around, c.now, c.next())) << trial << ", " << deviation;
    }
  }
}

// A robot that cannot turn in place moves nowhere aside at once: no maneuver is straight.
TEST(EvasionsWithWheels, are_what_the_robot_can_drive) {
  Case c;
  c.robot.model = Car{.max_curvature = 0.5};
  c.options = {.law = {}, .increment = 0.1, .decrement = 0.1, .max_speed = 2.0, .longest = 4.0};
  Predicted other;
  other.position = {-3.0, 0.0}, other.velocity = {2.5, 0.0};
  other.contact = other.stop_contact = 0.5, other.fastest = 2.5;
  c.around.others = {other};
  c.w = {0.0, 2.0};
  EXPECT_FALSE(has_clear_evasion(c));  // from rest, aside of its heading
  c.robot.heading = c.now.heading = 0.5 * std::numbers::pi;
  EXPECT_TRUE(has_clear_evasion(c));
}

}  // namespace
}  // namespace avo
