// SPDX-License-Identifier: Apache-2.0
// The tests check evasive maneuvers in space. A clear maneuver touches no body, and what is left of
// a clear maneuver is an evasive maneuver.
#include "space/evasions.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "space/certificate.h"
#include "space/own_space.h"
#include "unit/space/draws.h"

namespace avo::space::tests {
namespace {

// A robot that moves, among some moving obstacles.
EvasionSearch search_of(Draws& draws) {
  EvasionSearch search;
  search.law = {.time_step = draws.between(0.05, 0.25)};
  search.law.lag = 0.5 * search.law.time_step;
  search.law.braking_time = search.law.time_step;
  Robot& robot = search.robot;
  robot.vertical = draws.below(2) == 0 ? 1.0 : draws.between(0.4, 1.6);
  robot.velocity = from_own(draws.within(1.5), robot.vertical);
  robot.radius = 0.4;
  search.increment = draws.between(0.6, 1.0) * robot.max_acceleration * search.law.braking_time;
  search.max_speed = robot.max_speed * std::max(robot.vertical, 1.0);
  search.longest = 4.0;
  const int count = 1 + draws.below(4);
  while (static_cast<int>(search.others.size()) < count) {
    Predicted other;
    other.position = draws.between(2.0, 9.0) * draws.direction();
    other.velocity = draws.within(2.5);
    if (draws.below(3) == 0) other.acceleration = draws.within(1.0);
    other.contact = draws.between(0.6, 1.6);
    other.stop_contact = other.contact;
    other.asks_to_stop = draws.below(4) != 0;
    if (draws.below(2) == 0) other.deviation = draws.between(0.0, 0.3), other.reaction = 1.0;
    other.fastest = norm(other.velocity) + 20.0 * other.deviation;
    search.others.push_back(other);
  }
  return search;
}

// The search of the next decision, after the first step.
EvasionSearch after_step(const EvasionSearch& before) {
  EvasionSearch next = before;
  next.robot.position = before.robot.position + before.after.position;
  next.robot.velocity = before.after.velocity;
  const double h = before.law.time_step;
  for (Predicted& other : next.others) {
    other.position = other.place_at(h) - before.after.position;
    other.velocity = other.velocity + h * other.acceleration;
  }
  return next;
}

// An evasive maneuver that is clear: the velocity that it approaches, and when it brakes.
struct ClearWay {
  Vec3 w;
  double brakes_at = 0.0;  // s
};
bool find_clear(EvasionSearch& search, Draws& draws, ClearWay& way) {
  begin_evasions(search);
  for (int attempt = 0; attempt < 6; ++attempt) {
    way.w = from_own(2.0 * draws.direction(), search.robot.vertical);
    const EvasionState now{{}, search.robot.velocity, 0.0};
    if (!take_first_step(search, next_towards(search, now, way.w))) continue;
    if (!may_approach(search, way.w)) continue;
    way.brakes_at = search.brakes_at;
    return true;
  }
  return false;
}

TEST(SpaceEvasions, that_are_clear_touch_nobody) {
  int clear = 0;
  double nearest = 1e9;
  for (int k = 0; k < 1500; ++k) {
    Draws draws(static_cast<std::uint64_t>(k) + 1);
    EvasionSearch search = search_of(draws);
    ClearWay way;
    if (!find_clear(search, draws, way)) continue;
    ++clear;
    const double h = search.law.time_step;
    Vec3 position, velocity = search.robot.velocity;
    Robot robot = search.robot;
    for (int step = 0; step < 120; ++step) {
      const double from = step * h;
      robot.velocity = velocity;
      const Vec3 next = from < way.brakes_at - 1e-9
                            ? next_towards(search, {position, velocity, from}, way.w)
                            : backup_velocity(robot, search.law);
      for (int i = 0; i < 8; ++i) {
        const double s = i * h / 8.0;
        const Vec3 place = position + s * velocity + (0.5 * s * s / h) * (next - velocity);
        for (const Predicted& other : search.others)
          nearest = std::min(nearest, norm(place - other.place_at(from + s)) - other.contact -
                                          (next == Vec3{} ? 0.0 : other.spread_at(from + s)));
      }
      position = position + (0.5 * h) * (velocity + next), velocity = next;
    }
    ASSERT_GE(nearest, -1e-9) << k;
  }
  EXPECT_GT(clear, 300);
  EXPECT_LT(nearest, 0.1);
}

TEST(SpaceEvasions, what_is_left_of_a_clear_maneuver_is_one) {
  int clear = 0;
  for (int k = 0; k < 1500; ++k) {
    Draws draws(static_cast<std::uint64_t>(k) + 3000);
    EvasionSearch search = search_of(draws);
    for (Predicted& other : search.others) other.deviation = other.reaction = 0.0;
    ClearWay way;
    if (!find_clear(search, draws, way)) continue;
    ++clear;
    EvasionSearch next = after_step(search);
    // less by what rounding may cost
    for (Predicted& other : next.others) other.contact -= 1e-9, other.stop_contact -= 1e-9;
    begin_evasions(next);
    const bool brakes = way.brakes_at < 1.5 * search.law.time_step;
    const EvasionState now{{}, next.robot.velocity, 0.0};
    const Vec3 step =
        brakes ? backup_velocity(next.robot, next.law) : next_towards(next, now, way.w);
    EXPECT_TRUE(take_first_step(next, step)) << k;
    EXPECT_TRUE(brakes ? may_brake(next) : may_approach(next, way.w)) << k;
    EXPECT_TRUE(stops_in_time(next, step)) << k;
  }
  EXPECT_GT(clear, 300);
}

TEST(SpaceEvasions, keep_off_boxes_as_the_certificate_does) {
  int clear = 0, refused = 0;
  for (int k = 0; k < 400; ++k) {
    Draws draws(static_cast<std::uint64_t>(k) + 6000);
    EvasionSearch search = search_of(draws);
    ClearWay way;
    if (!find_clear(search, draws, way)) continue;
    search.boxes = {{{0.6, -2, -2}, {1.6, 2, 2}, draws.between(-3.0, 3.0), 0.0}};
    const EvasionState now{{}, search.robot.velocity, 0.0};
    begin_evasions(search);
    const Vec3 next = next_towards(search, now, way.w);
    if (!take_first_step(search, next) || !may_approach(search, way.w)) {
      ++refused;
      continue;
    }
    ++clear;
    Constraints constraints;
    begin_boxes(search.robot, search.boxes, search.law, constraints.boxes);
    EXPECT_TRUE(keeps_boxes(search.robot, next, search.law, constraints.boxes)) << k;
  }
  EXPECT_GT(clear, 50);
  EXPECT_GT(refused, 10);
}

}  // namespace
}  // namespace avo::space::tests
