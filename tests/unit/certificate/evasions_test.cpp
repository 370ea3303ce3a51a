// SPDX-License-Identifier: Apache-2.0
// Evasive maneuvers (docs/movers.md): what is called clear is clear, and stays so as A executes it.
#include "certificate/evasions.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "core/plane.h"
#include "support/generators.h"

namespace avo {
namespace {

StepLaw law_of(double time_step, bool exponential) {
  StepLaw law{.time_step = time_step, .lag = 0.5 * time_step, .braking_time = time_step};
  if (exponential) law.lag = 0.4 * time_step;
  return law;
}

Predicted random_other(test::Random& random, int kind) {
  Predicted other;
  other.position = random.uniform(0.5, 12.0) * random.direction();
  other.velocity = random.uniform(0.3, 3.0) * random.direction();
  if (kind % 3 == 1) other.acceleration = random.uniform(0.05, 1.5) * random.direction();
  if (kind % 3 == 2) other.velocity = {};
  other.contact = random.uniform(0.3, 1.5);
  if (kind % 5 == 4) other.deviation = random.uniform(0.1, 1.0), other.reaction = 1.0;
  other.stop_contact = other.contact;
  other.asks_to_stop = kind % 2 == 0;
  other.fastest = norm(other.velocity) + 20.0 * norm(other.acceleration) + 4.0 * other.deviation;
  return other;
}

// Returns the least of many distances to a body from one time on, less what is to be kept, in m.
double sampled_rest(const Predicted& other, Vec2 place, double time) {
  double least = std::numeric_limits<double>::infinity();
  for (double t = time; t < std::min(time + 60.0, other.until); t += 2e-3)
    least = std::min(least, norm(place - other.place_at(t)) - other.contact - other.spread_at(t));
  return least;
}

TEST(Evasions, rest_that_is_clear_is_never_touched) {
  test::Random random(1);
  int clear = 0, touched = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    Predicted other = random_other(random, trial);
    if (trial % 4 == 1) other.until = random.uniform(0.0, 8.0);
    const Vec2 place = random.uniform(0.0, 3.0) * random.direction();
    const double time = random.uniform(0.0, 4.0);
    const double room = sampled_rest(other, place, time);
    if (rests_clear(other, place, time)) {
      ++clear;
      ASSERT_GE(room, -1e-6) << trial;
    } else if (other.deviation == 0.0) {  // a spread is reckoned with in full
      ++touched;
      ASSERT_LE(room, 0.02) << trial << ": nothing is refused without need";
    }
  }
  EXPECT_GT(clear, 300);
  EXPECT_GT(touched, 50);
}

struct Case {
  EvasionOptions options;
  Surroundings around;
  Vec2 v, next, w;
};
Case random_case(test::Random& random, int kind) {
  Case result;
  const double h = random.log_uniform(0.02, 0.25), a = random.log_uniform(0.4, 4.0);
  result.options.law = law_of(h, kind % 4 == 3);
  result.options.decrement = a * h;
  result.options.increment = (kind % 2 == 0 ? 0.6 : 1.0) * a * h;
  result.options.max_speed = 2.0;
  result.options.longest = 6.0;
  for (int k = 0; k <= kind % 4; ++k)
    result.around.others.push_back(random_other(random, random.below(30)));
  if (kind % 7 == 0)
    result.around.walls.push_back({{{1.5, -4.0}, {1.5, 4.0}}, random.uniform(0.2, 0.6)});
  result.v = random.uniform(0.0, 2.0) * random.direction();
  result.next = approach(result.v, 2.0 * random.direction(), a * h);
  if (norm(result.next) > 2.0) result.next = (2.0 / norm(result.next)) * result.next;
  result.w = kind % 3 == 0 ? result.next : 2.0 * random.direction();
  return result;
}

bool may_brake(Case& c) {
  begin_evasions(c.options, c.around);
  return take_first_step(c.options, c.around, {{}, c.v}, c.next) && may_brake(c.options, c.around);
}
bool has_clear_evasion(Case& c) {
  begin_evasions(c.options, c.around);
  return take_first_step(c.options, c.around, {{}, c.v}, c.next) &&
         may_approach(c.options, c.around, c.w);
}

// m, least room on the path by those velocities at the ends of steps, and at rest behind it.
double sampled_room(const Case& c, const std::vector<Vec2>& velocities) {
  const double h = c.options.law.time_step;
  double least = std::numeric_limits<double>::infinity();
  Vec2 p;
  const auto look = [&](Vec2 place, double time) {
    for (const Predicted& other : c.around.others) {
      const double room = norm(place - other.place_at(time)) - other.contact;
      least = std::min(least, room - (other.deviation > 0.0 ? 0.0 : other.spread_at(time)));
    }
    for (const KeptWall& wall : c.around.walls)
      least = std::min(least, distance(place, wall.segment) - wall.kept);
  };
  double time = 0.0;
  for (std::size_t k = 1; k < velocities.size(); ++k, time += h) {
    const Vec2 v = velocities[k - 1], change = velocities[k] - v;
    for (int part = 0; part < 8; ++part) {
      const double t = h * part / 8.0;
      if (c.options.law.lag == 0.5 * h) look(p + t * v + (0.5 * t * t / h) * change, time + t);
    }
    p = p + c.options.law.lag * v + (h - c.options.law.lag) * velocities[k];
    look(p, time + h);
  }
  for (const Predicted& other : c.around.others)
    least = std::min(least, sampled_rest(other, p, time) + other.spread_at(60.0));
  return least;
}

std::vector<Vec2> with_braking(std::vector<Vec2> velocities, const EvasionOptions& options) {
  while (velocities.back() != Vec2{})
    velocities.push_back(braked(velocities.back(), options.decrement));
  return velocities;
}

TEST(Evasions, that_are_clear_touch_nobody) {
  test::Random random(2);
  int clear = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    Case c = random_case(random, trial);
    if (may_brake(c)) {
      ASSERT_GE(sampled_room(c, with_braking({c.v, c.next}, c.options)), -1e-6) << trial;
    }
    if (!has_clear_evasion(c)) continue;
    ++clear;
    std::vector<Vec2> velocities{c.v, c.next};
    double best = -1.0;
    for (double t = 0.0; t <= c.options.longest && best < -1e-6; t += c.options.law.time_step) {
      best = sampled_room(c, with_braking(velocities, c.options));
      velocities.push_back(approach(velocities.back(), c.w, c.options.increment));
    }
    ASSERT_GE(best, -1e-6) << trial << ": it brakes nowhere in that maneuver without being touched";
  }
  EXPECT_GT(clear, 300);
}

Hull interval_of(Vec2 place, Vec2 v, Vec2 next, const StepLaw& law) {
  const Vec2 middle = place + law.lag * v;
  return {place, middle, middle + (law.time_step - law.lag) * next};
}

// Intervals of braking are left out where the other one is too far away to matter; all of them are
// looked at here.
TEST(Evasions, that_are_clear_stop_in_time_in_every_interval) {
  test::Random random(4);
  int clear = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    Case c = random_case(random, trial);
    for (Predicted& other : c.around.others) {
      other.deviation = random.uniform(0.0, 1.0), other.asks_to_stop = true;
      other.fastest +=
          other.deviation * (other.reaction + 2.0 / c.options.decrement * c.options.law.time_step);
    }
    if (!has_clear_evasion(c)) continue;
    ++clear;
    const StepLaw& law = c.options.law;
    EvasionState state = c.around.after;
    const double half_step = 0.5 * law.time_step;
    for (; state.time < c.around.brakes_at - half_step; state.time += law.time_step) {
      const Vec2 next = approach(state.velocity, c.w, c.options.increment);
      state.position = interval_of(state.position, state.velocity, next, law).end,
      state.velocity = next;
    }
    Vec2 place = state.position, v = state.velocity;
    for (double elapsed = 0.0; v != Vec2{}; elapsed += law.time_step) {
      const Hull own = interval_of(place, v, braked(v, c.options.decrement), law);
      for (Predicted other : c.around.others) {
        other.stop_contact -= 1e-9;
        ASSERT_TRUE(is_reached_at_rest(other, own, state.time, elapsed, law))
            << trial << " " << elapsed;
      }
      place = own.end, v = braked(v, c.options.decrement);
    }
  }
  EXPECT_GT(clear, 300);
}

// As A sees it one step later, others as they were predicted.
Case after_step(const Case& c) {
  Case later = c;
  const double h = c.options.law.time_step;
  const Vec2 moved = c.options.law.lag * c.v + (h - c.options.law.lag) * c.next;
  for (Predicted& other : later.around.others) {
    const Vec2 place = other.place_at(h), velocity = other.velocity_at(h);
    other.position = place - moved, other.velocity = velocity;
  }
  for (KeptWall& wall : later.around.walls)
    wall.segment = {wall.segment.a - moved, wall.segment.b - moved};
  later.v = c.next;
  return later;
}

// Remainders: after a step of a clear maneuver, the rest of it is clear, or its braking is clear.
// The second time, less is kept, by what rounding may cost.
TEST(Evasions, what_is_left_of_a_clear_maneuver_is_one) {
  test::Random random(3);
  int clear = 0;
  for (int trial = 0; trial < 6000; ++trial) {
    Case c = random_case(random, trial);
    std::erase_if(c.around.others, [](const Predicted& other) { return other.deviation > 0.0; });
    if (!has_clear_evasion(c)) continue;
    ++clear;
    Case later = after_step(c);
    for (Predicted& other : later.around.others) other.contact -= 1e-9, other.stop_contact -= 1e-9;
    for (KeptWall& wall : later.around.walls) wall.kept -= 1e-9;
    const Vec2 on = approach(later.v, c.w, c.options.increment);
    const Vec2 brakes = braked(later.v, c.options.decrement);
    later.next = brakes;
    const bool by_braking = may_brake(later);
    later.next = on;
    ASSERT_TRUE(by_braking || has_clear_evasion(later)) << trial;
    ASSERT_TRUE(stops_in_time(later.options, later.around, {{}, later.v}, on) ||
                stops_in_time(later.options, later.around, {{}, later.v}, brakes))
        << trial << ": the certificate would refuse it";
  }
  EXPECT_GT(clear, 1000);
}

}  // namespace
}  // namespace avo
