// SPDX-License-Identifier: Apache-2.0
#include "certificate/evasions.h"

#include <algorithm>
#include <cstddef>
#include <span>

#include "certificate/evasion_braking.h"
#include "core/plane.h"
#include "robots/model.h"

namespace avo::inline certificate {
namespace {

// Stores how long the mover of that number cannot touch A; A's speed is at most v_max.
void look_at(const EvasionOptions& options, Surroundings& around, std::size_t k,
             const EvasionState& state) {
  const Predicted& other = around.others[k];
  const double closing = options.max_speed + other.fastest;
  const double room = room_to(other, state.position, state.time) - options.lever;
  if (room > 0.0)
    around.clear_until[k] = std::max(around.clear_until[k], state.time + room / closing);
}

bool is_known(const EvasionOptions& options, Vec2 place) {
  return norm_squared(place) <= options.known * options.known;
}

// One step of an evasive maneuver.
struct EvasionStep {
  Hull path;  // of A's position
  EvasionState next;
  std::span<const Hull> footprint = {};  // the paths of its discs

  // The paths of A's discs.
  std::span<const Hull> discs() const {
    return footprint.empty() ? std::span(&path, 1) : footprint;
  }
};

// A, in that state.
Robot on_wheels(const EvasionOptions& options, const EvasionState& state) {
  Robot robot = *options.wheels;
  robot.velocity = state.velocity, robot.heading = state.heading;
  return robot;
}

EvasionStep step_of(const EvasionOptions& options, const EvasionState& from, Vec2 next_velocity,
                    EvasionDiscs& discs) {
  const StepLaw& law = options.law;
  const double end = from.time + law.time_step;
  const Vec2 middle = from.position + law.lag * from.velocity;
  if (options.wheels == nullptr) {
    const Vec2 last = middle + (law.time_step - law.lag) * next_velocity;
    return {{from.position, middle, last}, {last, next_velocity, end}};
  }
  const Robot robot = on_wheels(options, from);
  const Plan plan = plan_to(robot, next_velocity, law);
  const MotionStep step =
      advance(robot.model, {planned_braking(robot), robot.max_speed},
              {from.position, from.velocity, from.heading}, plan, law.time_step);
  const auto& [position, velocity, heading, circle] = step.next;
  const std::span<const Hull> footprint =
      options.footprint ? move_discs(options, from, plan, step, discs) : std::span<const Hull>{};
  return {{from.position, middle + law.lag * step.swing, position, step.bend},
          {position, velocity, end, heading},
          footprint};
}

// Tests (C3) of a disc. The first side of the triangle of a step is part of braking, unless the
// disc swings.
bool keeps_off_wall(const KeptWall& wall, const Hull& disc, bool swings) {
  const double kept = wall.kept + disc.bend;
  return distance({disc.start, disc.end}, wall.segment) >= kept &&
         distance({disc.middle, disc.end}, wall.segment) >= kept &&
         (!swings || distance({disc.start, disc.middle}, wall.segment) >= kept);
}

// Tests (C1) and (C3) of one step.
bool is_clear(const EvasionOptions& options, Surroundings& around, const EvasionState& from,
              const EvasionStep& step) {
  const std::span<const Hull> discs = step.discs();
  if (!keeps_off_movers(options, around, from, discs)) return false;
  const bool swings = !step.footprint.empty();
  return is_known(options, step.path.end) &&
         std::all_of(around.walls.begin(), around.walls.end(), [&](const KeptWall& wall) {
           return wall.clear_until >= step.next.time ||
                  std::all_of(discs.begin(), discs.end(),
                              [&](const Hull& disc) { return keeps_off_wall(wall, disc, swings); });
         });
}

// An interval of the last path of braking, computed once for all others.
const Hull& known_interval(const FullBraking& braking, const StepLaw& law, std::size_t m,
                           Surroundings& around) {
  KnownInterval& known = around.intervals[m];
  if (known.braking != around.brakings) known = {interval_of(braking, law, m), around.brakings};
  return known.path;
}

// The result of braking from a state.
enum class BrakingVerdict : unsigned char {
  too_late,  // (C2) or (C3) does not hold
  in_time,   // (C2) and (C3) hold
  clear,     // and A is never touched, (C1)
};

// Judges braking towards one of the others. may_be_clear: no other body is known to touch A.
BrakingVerdict stop_before(const EvasionOptions& options, Surroundings& around, std::size_t k,
                           const EvasionState& state, const FullBraking& braking,
                           bool may_be_clear) {
  const Predicted& other = around.others[k];
  const double h = options.law.time_step, closing = options.max_speed + other.fastest;
  bool clear = may_be_clear;
  double clear_until = around.clear_until[k];
  for (int m = 0; m < braking.steps; ++m) {
    const double time = state.time + h * m;
    if (clear_until >= time + h) continue;
    --around.work;
    const Hull& own = known_interval(braking, options.law, static_cast<std::size_t>(m), around);
    const double kept = clear ? other.contact + other.spread_at(time + h) : 0.0;
    const double before_rest =
        other.asks_to_stop ? kept_before_rest(other, state.time, h * m + h) : 0.0;
    const bool in_time = braking.all_discs(own, [&](const Hull& disc) {
      const Hull relative = relative_to(other, disc, time, options.law);
      // in most cases A keeps both distances at once
      if (keeps_off(relative, std::max(kept, before_rest))) return true;
      if (other.asks_to_stop && !is_reached_at_rest(other, disc, state.time, h * m, options.law))
        return false;
      clear = clear && keeps_off(relative, kept);
      return true;
    });
    if (!in_time) return BrakingVerdict::too_late;
    if (!clear && !other.asks_to_stop) break;
    const double room = room_before_rest(other, own.start, state.time, h * m) - options.lever;
    clear_until = time + room / closing;
  }
  // the slowest test comes last
  clear = clear && stays_clear(other, braking, state.time + h * braking.steps);
  return clear ? BrakingVerdict::clear : BrakingVerdict::in_time;
}

BrakingVerdict stop_from(const EvasionOptions& options, Surroundings& around,
                         const EvasionState& state) {
  const FullBraking braking = braking_from(options, state, around.discs);
  around.work -= static_cast<int>(around.others.size());
  if (around.work < 0 || !is_known(options, braking.end)) return BrakingVerdict::too_late;
  const double end = state.time + options.law.time_step * braking.steps;
  for (const KeptWall& wall : around.walls) {
    if (wall.clear_until >= end) continue;
    const bool is_clear =
        braking.all_discs({state.position, {}, braking.end}, [&](const Hull& disc) {
          return distance({disc.start, disc.end}, wall.segment) >= wall.kept + disc.bend;
        });
    if (!is_clear) return BrakingVerdict::too_late;
  }
  ++around.brakings;
  if (const auto most = static_cast<std::size_t>(braking.steps); around.intervals.size() < most)
    around.intervals.resize(most);
  BrakingVerdict worst = BrakingVerdict::clear;
  const auto look_at_one = [&](std::size_t k) {
    const BrakingVerdict stop =
        stop_before(options, around, k, state, braking, worst == BrakingVerdict::clear);
    if (stop != BrakingVerdict::clear && worst == BrakingVerdict::clear) around.refused_by = k;
    worst = std::min(worst, stop);
    return worst != BrakingVerdict::too_late;
  };
  // the mover that touched A in the last braking often does so again: the tests of the others then
  // matter less
  const std::size_t count = around.others.size(), first = around.refused_by;
  if (first < count && !look_at_one(first)) return worst;
  for (std::size_t k = 0; k < count; ++k)
    if (k != first && !look_at_one(k)) break;
  return worst;
}

}  // namespace

void Surroundings::reserve(std::size_t most_others, std::size_t braking_steps) {
  if (intervals.size() < braking_steps) intervals.resize(braking_steps);
  others.reserve(most_others);
  for (std::vector<double>* column : {&clear_now, &clear_after, &clear_until})
    column->reserve(most_others);
}

bool keeps_off_movers(const EvasionOptions& options, Surroundings& around, const EvasionState& from,
                      std::span<const Hull> discs) {
  const double end = from.time + options.law.time_step;
  around.work -= static_cast<int>(around.others.size());
  for (std::size_t k = 0; k < around.others.size(); ++k) {
    if (around.clear_until[k] >= end) continue;
    look_at(options, around, k, from);
    if (around.clear_until[k] >= end) continue;
    const Predicted& other = around.others[k];
    const double kept = other.contact + other.spread_at(end);
    const bool clear = std::all_of(discs.begin(), discs.end(), [&](const Hull& disc) {
      return keeps_off(relative_to(other, disc, from.time, options.law), kept);
    });
    if (!clear) return false;
  }
  return true;
}

void begin_evasions(const EvasionOptions& options, Surroundings& around) {
  around.refused_by = around.others.size();
  around.clear_until.assign(around.others.size(), 0.0);
  for (std::size_t k = 0; k < around.others.size(); ++k) look_at(options, around, k, {});
  around.clear_now = around.clear_until;
  for (KeptWall& wall : around.walls)
    wall.clear_until =
        (distance(Vec2{}, wall.segment) - wall.kept - options.lever) / options.max_speed;
}

Vec2 next_towards(const EvasionOptions& options, const EvasionState& from, Vec2 w) {
  if (options.wheels == nullptr) return approach(from.velocity, w, options.increment);
  const Robot robot = on_wheels(options, from);
  return approached(robot, options.law.braking_time, options.increment, within_steering(robot, w));
}

bool take_first_step(const EvasionOptions& options, Surroundings& around, const EvasionState& now,
                     Vec2 next_velocity) {
  const EvasionStep step = step_of(options, now, next_velocity, around.discs);
  around.after = step.next;
  around.clear_until = around.clear_now;
  const bool clear = is_clear(options, around, now, step);
  around.clear_after = around.clear_until;
  return clear;
}

bool may_brake(const EvasionOptions& options, Surroundings& around) {
  around.clear_until = around.clear_after;
  around.brakes_at = around.after.time;
  return stop_from(options, around, around.after) == BrakingVerdict::clear;
}

bool may_approach(const EvasionOptions& options, Surroundings& around, Vec2 w) {
  around.clear_until = around.clear_after;
  for (EvasionState state = around.after;;) {
    const BrakingVerdict stop = stop_from(options, around, state);
    around.brakes_at = state.time;
    if (stop != BrakingVerdict::in_time) return stop == BrakingVerdict::clear;
    if (!(state.time < options.longest)) return false;
    const EvasionStep step = step_of(options, state, next_towards(options, state, w), around.discs);
    if (!is_clear(options, around, state, step)) return false;
    state = step.next;
  }
}

bool stops_in_time(const EvasionOptions& options, Surroundings& around, const EvasionState& now,
                   Vec2 next_velocity) {
  const StepLaw& law = options.law;
  const EvasionStep step = step_of(options, now, next_velocity, around.discs);
  const std::span<const Hull> discs = step.discs();
  const FullBraking braking = braking_from(options, step.next, around.discs);
  const bool moves = !is_rest(now.velocity) || !is_rest(next_velocity);
  return std::all_of(around.others.begin(), around.others.end(), [&](const Predicted& other) {
    if (!other.asks_to_stop || !moves) return true;
    const auto is_kept = [&](double elapsed) {
      return [&other, &law, elapsed](const Hull& disc) {
        return is_reached_at_rest(other, disc, 0.0, elapsed, law);
      };
    };
    if (!std::all_of(discs.begin(), discs.end(), is_kept(0.0))) return false;
    for (int m = 0; m < braking.steps; ++m) {
      const Hull path = interval_of(braking, law, static_cast<std::size_t>(m));
      if (!braking.all_discs(path, is_kept(law.time_step * (m + 1)))) return false;
    }
    return true;
  });
}

}  // namespace avo::inline certificate
