// SPDX-License-Identifier: Apache-2.0
// Evasive maneuvers of airplanes (docs/movers.md, "Airplanes"): what is called clear is clear for
// ever, and stays so as A executes it. Judged by places on arcs that are computed from the
// equations.
#include "certificate/flight_evasions.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "core/plane.h"
#include "support/generators.h"

namespace avo {
namespace {

constexpr double kLongest = 6.0;                  // s
constexpr double kSlowest = 0.8, kFastest = 2.0;  // m/s

// An airplane at 0 among movers and walls, and the control that it holds.
struct FlightCase {
  Robot robot;
  EvasionOptions options;
  Surroundings around;
  FlightControl control;
};

Predicted random_mover(test::Random& random, int kind) {
  Predicted other;
  other.position = random.uniform(1.0, 14.0) * random.direction();
  other.velocity = random.uniform(0.3, 3.0) * random.direction();
  if (kind % 3 == 1) other.acceleration = random.uniform(0.05, 0.8) * random.direction();
  if (kind % 3 == 2) other.velocity = {};
  other.contact = random.uniform(0.3, 1.5);
  if (kind % 5 == 4) other.deviation = random.uniform(0.1, 1.0), other.reaction = 1.0;
  other.fastest = norm(other.velocity) + 8.0 * norm(other.acceleration) + 2.0 * other.deviation;
  return other;
}

void begin(FlightCase& c) {
  c.options.wheels = &c.robot;
  begin_evasions(c.options, c.around);
  take_no_flight(c.around, c.robot.velocity);
}

FlightCase random_case(test::Random& random, int kind) {
  FlightCase c;
  const double h = random.log_uniform(0.02, 0.4);
  c.robot.max_acceleration = random.log_uniform(0.3, 3.0), c.robot.max_speed = kFastest;
  c.robot.model = Airplane{kSlowest, random.log_uniform(0.6, 4.0)};
  c.robot.velocity = random.uniform(kSlowest, kFastest) * random.direction();
  c.options.law = {.time_step = h, .lag = 0.5 * h, .braking_time = h};
  c.options.max_speed = kFastest, c.options.longest = kLongest;
  for (int k = 0; k <= kind % 3; ++k)
    c.around.others.push_back(random_mover(random, random.below(30)));
  if (kind % 6 == 0)
    c.around.walls.push_back({{{2.5, -4.0}, {2.5, 4.0}}, random.uniform(0.2, 0.6)});
  const double speeds[]{norm(c.robot.velocity), kSlowest, kFastest};
  c.control = {speeds[random.below(3)], random.below(3) - 1.0};
  return c;
}

// Returns the room of a place at a time, beyond what is to be kept from every body, in m.
double room_at(const FlightCase& c, Vec2 place, double time) {
  double least = std::numeric_limits<double>::infinity();
  for (const Predicted& other : c.around.others)
    least = std::min(least, norm(place - other.place_at(time)) - other.contact -
                                (other.deviation > 0.0 ? 0.0 : other.spread_at(time)));
  for (const KeptWall& wall : c.around.walls)
    least = std::min(least, distance(place, wall.segment) - wall.kept);
  return least;
}

// The state of an airplane in the middle of its step, by small parts of it.
struct Sampled {
  Vec2 place;
  double course, speed;  // rad, m/s
  double time = 0.0;     // s
  double room = std::numeric_limits<double>::infinity();
};
Sampled sampled_start(const FlightCase& c) {
  return {{}, std::atan2(c.robot.velocity.y, c.robot.velocity.x), norm(c.robot.velocity)};
}
// One step with that control: the speed changes evenly, and the curvature is held.
void fly_one_step(const FlightCase& c, FlightControl control, Sampled& at) {
  constexpr int kParts = 16;
  const double h = c.options.law.time_step, a = c.robot.max_acceleration;
  const double next = std::clamp(control.speed, at.speed - a * h, at.speed + a * h);
  const double top = std::max(at.speed, next);
  const double side = usable_acceleration(std::get<Airplane>(c.robot.model)) * control.turn;
  const Sampled from = at;
  for (int part = 1; part <= kParts; ++part) {
    const double t = h * part / kParts;
    const double along = t * (from.speed + 0.5 * (next - from.speed) * t / h);
    const double turn = side / (top * top) * along, half = 0.5 * turn;
    const double straight = std::abs(half) < 1e-9 ? along : along * std::sin(half) / half;
    at.place =
        from.place + straight * Vec2{std::cos(from.course + half), std::sin(from.course + half)};
    at.course = from.course + turn, at.time = from.time + t;
    at.room = std::min(at.room, room_at(c, at.place, at.time));
  }
  at.speed = next;
}

// Flies as the last clear maneuver says, and then for a minute on its circle.
double sampled_room_of(const FlightCase& c) {
  Sampled at = sampled_start(c);
  const double half_step = 0.5 * c.options.law.time_step;
  while (at.time < c.around.last.time - half_step) fly_one_step(c, c.control, at);
  EXPECT_LT(norm(at.place - c.around.last.position), 1e-9);
  while (at.time < 60.0) fly_one_step(c, {at.speed, -1.0}, at);
  return at.room;
}

TEST(FlightEvasions, that_are_clear_touch_nobody_for_ever) {
  test::Random random(1);
  int clear = 0, at_once = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    FlightCase c = random_case(random, trial);
    begin(c);
    if (c.around.walls.empty() && may_circle(c.options, c.around)) {
      ++at_once;
      ASSERT_GE(sampled_room_of(c), -1e-6) << trial;
    } else if (may_circle_after(c.options, c.around, c.control)) {
      ++clear;
      ASSERT_GE(sampled_room_of(c), -1e-6) << trial;
    }
  }
  EXPECT_GT(at_once, 200);
  EXPECT_GT(clear, 150);
}

// One step later A knows the same movers, where they are then.
FlightCase after_step(const FlightCase& c) {
  FlightCase later = c;
  const double h = c.options.law.time_step;
  Sampled at = sampled_start(c);
  fly_one_step(c, c.control, at);
  later.robot.velocity = at.speed * Vec2{std::cos(at.course), std::sin(at.course)};
  for (Predicted& other : later.around.others) {
    other.position = other.place_at(h) - at.place, other.velocity = other.velocity_at(h);
    other.contact *= 1.0 - 1e-6;  // rounding
  }
  for (KeptWall& wall : later.around.walls) {
    wall.segment = {wall.segment.a - at.place, wall.segment.b - at.place};
    wall.kept -= 1e-9;
  }
  return later;
}

TEST(FlightEvasions, what_is_left_of_a_clear_maneuver_is_one) {
  test::Random random(2);
  int clear = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    FlightCase c = random_case(random, trial);
    for (Predicted& other : c.around.others) other.deviation = 0.0;
    begin(c);
    if (!may_circle_after(c.options, c.around, c.control)) continue;
    ++clear;
    while (c.around.last.time > 1.5 * c.options.law.time_step) {
      c = after_step(c);
      begin(c);
      if (c.around.walls.empty() && may_circle(c.options, c.around)) break;
      ASSERT_TRUE(may_circle_after(c.options, c.around, c.control)) << trial;
    }
  }
  EXPECT_GT(clear, 150);
}

// In long steps the arc leaves the parabola through its ends: the largest contact that a clear
// maneuver leaves is looked for.
TEST(FlightEvasions, keep_clear_of_what_the_arc_of_a_step_touches) {
  test::Random random(4);
  int clear = 0;
  for (int trial = 0; trial < 200; ++trial) {
    FlightCase c = random_case(random, 3 * trial + 1);
    c.options.law = {.time_step = 0.8, .lag = 0.4, .braking_time = 0.8};
    c.robot.model = Airplane{kSlowest, 2.9};  // almost 3 rad a step
    c.around.others.resize(1);
    Predicted& other = c.around.others[0];
    other.deviation = 0.0;
    double kept = 0.0, refused = 10.0;
    for (int k = 0; k < 30; ++k) {
      other.contact = 0.5 * (kept + refused);
      begin(c);
      (may_circle_after(c.options, c.around, c.control) ? kept : refused) = other.contact;
    }
    other.contact = kept;
    begin(c);
    if (!may_circle_after(c.options, c.around, c.control)) continue;
    ++clear;
    ASSERT_GE(sampled_room_of(c), -1e-6) << trial;
  }
  EXPECT_GT(clear, 100);
}

// A maneuver that is refused comes too near to a body, or the circles of the maneuver do.
TEST(FlightEvasions, are_refused_for_a_reason) {
  test::Random random(3);
  int refused = 0;
  for (int trial = 0; trial < 800; ++trial) {
    FlightCase c = random_case(random, 3 * trial + 1);  // one or two movers and no wall
    for (Predicted& other : c.around.others) {
      other.deviation = 0.0;
      other.contact *= 1.01;  // what three points lose
    }
    begin(c);
    if (may_circle_after(c.options, c.around, c.control)) continue;
    ++refused;
    for (Predicted& other : c.around.others) other.contact *= 1.02;
    Sampled at = sampled_start(c);
    while (at.time < kLongest && at.room >= 0.0) {
      fly_one_step(c, c.control, at);
      const Vec2 ahead{std::cos(at.course), std::sin(at.course)};
      const LoiterCircle circle =
          loiter_circle(std::get<Airplane>(c.robot.model), at.place, at.speed * ahead);
      double least = std::numeric_limits<double>::infinity();
      for (double t = at.time; t < 60.0; t += 0.01) {
        for (const Predicted& other : c.around.others)
          least = std::min(least, norm(circle.center - other.place_at(t)) - other.contact);
      }
      ASSERT_TRUE(least < circle.radius || at.room < 0.0) << trial << " at " << at.time;
    }
  }
  EXPECT_GT(refused, 60);
}

}  // namespace
}  // namespace avo
