// SPDX-License-Identifier: Apache-2.0
#include "space/evasions.h"

#include <algorithm>
#include <cmath>

#include "space/certificate.h"
#include "space/own_space.h"

namespace avo::space {
namespace {

EvasionState now_of(const EvasionSearch& search) {
  return {{}, search.robot.velocity, 0.0};
}

// s: how long the room (m, > 0) lasts from that time on. After s seconds the two come nearer by c +
// |a| s in a second, with c of that time.
double lasts(const EvasionSearch& search, const Predicted& other, double room, double time) {
  const double pull = norm(other.acceleration);
  const double closing = search.max_speed + other.fastest + time * pull;
  return 2.0 * room / (closing + std::sqrt(closing * closing + 2.0 * pull * room));
}

// Stores how long the moving obstacle of that number cannot touch A.
void look_at(EvasionSearch& search, std::size_t k, const EvasionState& state) {
  const Predicted& other = search.others[k];
  const double room = room_to(other, state.position, state.time);
  if (!(room > 0.0)) return;
  const double until = state.time + lasts(search, other, room, state.time);
  search.clear_until[k] = std::max(search.clear_until[k], until);
}

bool is_known(const EvasionSearch& search, Vec3 place) {
  return norm_squared(place) <= search.known * search.known;
}

// One step of an evasive maneuver.
struct EvasionStep {
  Hull path;
  EvasionState next;
};

EvasionStep step_of(const EvasionSearch& search, const EvasionState& from, Vec3 next_velocity) {
  const StepLaw& law = search.law;
  const Vec3 middle = from.position + law.lag * from.velocity;
  const Vec3 last = middle + (law.time_step - law.lag) * next_velocity;
  return {{from.position, middle, last}, {last, next_velocity, from.time + law.time_step}};
}

// Tests (C1) of one step.
bool keeps_off_movers(EvasionSearch& search, const EvasionState& from, const Hull& step) {
  const double end = from.time + search.law.time_step;
  search.work -= static_cast<int>(search.others.size());
  for (std::size_t k = 0; k < search.others.size(); ++k) {
    if (search.clear_until[k] >= end) continue;
    look_at(search, k, from);
    if (search.clear_until[k] >= end) continue;
    const Predicted& other = search.others[k];
    if (!keeps_off(relative_to(other, step, from.time, search.law),
                   other.contact + other.spread_at(end)))
      return false;
  }
  return true;
}

// Tests (C3) of one step and of braking after it, as the certificate does.
bool keeps_off_boxes(EvasionSearch& search, const EvasionState& from, Vec3 next_velocity) {
  if (search.boxes.empty()) return true;
  Robot there = search.robot;
  there.position = search.robot.position + from.position, there.velocity = from.velocity;
  begin_boxes(there, search.boxes, search.law, search.of_boxes);
  return keeps_boxes(there, next_velocity, search.law, search.of_boxes);
}

// Tests (C1) and (C3) of one step.
bool is_clear(EvasionSearch& search, const EvasionState& from, const EvasionStep& step) {
  return keeps_off_movers(search, from, step.path) && is_known(search, step.path.end) &&
         keeps_off_boxes(search, from, step.next.velocity);
}

FullBraking braking_from(const EvasionSearch& search, const EvasionState& state) {
  const Robot& robot = search.robot;
  FullBraking result{braking_of(state.velocity, robot.max_acceleration, braking_limit(robot),
                                robot.vertical, search.law),
                     state.position, state.position, 0.0};
  if (!(result.braking.profile.speed > 0.0)) return result;
  result.steps = result.braking.profile.full_steps + 1.0;
  result.end = state.position + result.braking.length * result.braking.direction;
  return result;
}

Hull interval_of(const FullBraking& from, const StepLaw& law, int m) {
  const BrakingDistances along = braking_distances(from.braking.profile, law, m);
  const Vec3 direction = from.braking.direction;
  return {from.start + along.start * direction, from.start + along.middle * direction,
          from.start + along.end * direction};
}

// An interval of the present path of braking, computed once for all others.
const Hull& known_interval(EvasionSearch& search, const FullBraking& from, int m) {
  const auto k = static_cast<std::size_t>(m);
  if (search.has_hull[k] == 0)
    search.hulls[k] = interval_of(from, search.law, m), search.has_hull[k] = 1;
  return search.hulls[k];
}

// The result of braking from a state.
enum class BrakingVerdict : unsigned char {
  too_late,  // (C2) does not hold
  in_time,   // (C2) holds
  clear,     // and A is never touched, (C1)
};

// Judges braking towards one of the others. may_be_clear: no other body is known to touch A.
BrakingVerdict stop_before(EvasionSearch& search, std::size_t k, const EvasionState& state,
                           const FullBraking& braking, bool may_be_clear) {
  const Predicted& other = search.others[k];
  const StepLaw& law = search.law;
  const double h = law.time_step;
  bool clear = may_be_clear;
  double clear_until = search.clear_until[k];
  for (int m = 0; m < braking.steps; ++m) {
    const double time = state.time + h * m;
    if (clear_until >= time + h) continue;
    --search.work;
    const Hull& own = known_interval(search, braking, m);
    const Hull relative = relative_to(other, own, time, law);
    const double kept = clear ? other.contact + other.spread_at(time + h) : 0.0;
    const double before_rest =
        other.asks_to_stop ? kept_before_rest(other, state.time, h * m + h) : 0.0;
    // in most cases A keeps both distances at once
    if (!keeps_off(relative, std::max(kept, before_rest))) {
      if (other.asks_to_stop && !is_reached_at_rest(other, own, state.time, h * m, law))
        return BrakingVerdict::too_late;
      clear = clear && keeps_off(relative, kept);
    }
    if (!clear && !other.asks_to_stop) break;
    const double room = room_before_rest(other, own.start, state.time, h * m);
    clear_until = room > 0.0 ? time + lasts(search, other, room, time) : time;
  }
  // the slowest test comes last
  clear = clear && rests_clear(other, braking.end, state.time + h * braking.steps);
  return clear ? BrakingVerdict::clear : BrakingVerdict::in_time;
}

BrakingVerdict stop_from(EvasionSearch& search, const EvasionState& state) {
  const FullBraking braking = braking_from(search, state);
  search.work -= static_cast<int>(search.others.size());
  if (search.work < 0 || !is_known(search, braking.end)) return BrakingVerdict::too_late;
  const auto steps = static_cast<std::size_t>(braking.steps);
  if (search.hulls.size() < steps) search.hulls.resize(steps);
  search.has_hull.assign(search.hulls.size(), 0);
  BrakingVerdict worst = BrakingVerdict::clear;
  const auto look_at_one = [&](std::size_t k) {
    const BrakingVerdict stop =
        stop_before(search, k, state, braking, worst == BrakingVerdict::clear);
    if (stop != BrakingVerdict::clear && worst == BrakingVerdict::clear) search.refused_by = k;
    worst = std::min(worst, stop);
    return worst != BrakingVerdict::too_late;
  };
  // the mover that touched A in the last braking often does so again
  const std::size_t count = search.others.size(), first = search.refused_by;
  if (first < count && !look_at_one(first)) return worst;
  for (std::size_t k = 0; k < count; ++k)
    if (k != first && !look_at_one(k)) break;
  return worst;
}

}  // namespace

void begin_evasions(EvasionSearch& search) {
  const std::size_t count = search.others.size();
  search.refused_by = count;
  search.clear_until.assign(count, 0.0);
  for (std::size_t k = 0; k < count; ++k) look_at(search, k, now_of(search));
  search.clear_now = search.clear_until;
}

Vec3 next_towards(const EvasionSearch& search, const EvasionState& from, Vec3 w) {
  const double vertical = search.robot.vertical;
  const Vec3 change = to_own(w - from.velocity, vertical);
  const double length = norm(change);
  if (!(length > search.increment)) return w;
  return from.velocity + from_own((search.increment / length) * change, vertical);
}

bool take_first_step(EvasionSearch& search, Vec3 next_velocity) {
  const EvasionState now = now_of(search);
  const EvasionStep step = step_of(search, now, next_velocity);
  search.after = step.next;
  search.clear_until = search.clear_now;
  const bool clear = is_clear(search, now, step);
  search.clear_after = search.clear_until;
  return clear;
}

bool may_brake(EvasionSearch& search) {
  search.clear_until = search.clear_after;
  search.brakes_at = search.after.time;
  return stop_from(search, search.after) == BrakingVerdict::clear;
}

bool may_approach(EvasionSearch& search, Vec3 w) {
  search.clear_until = search.clear_after;
  for (EvasionState state = search.after;;) {
    const BrakingVerdict stop = stop_from(search, state);
    search.brakes_at = state.time;
    if (stop != BrakingVerdict::in_time) return stop == BrakingVerdict::clear;
    if (!(state.time < search.longest)) return false;
    const EvasionStep step = step_of(search, state, next_towards(search, state, w));
    if (!is_clear(search, state, step)) return false;
    state = step.next;
  }
}

bool stops_in_time(const EvasionSearch& search, Vec3 next_velocity) {
  const StepLaw& law = search.law;
  const EvasionStep step = step_of(search, now_of(search), next_velocity);
  const FullBraking braking = braking_from(search, step.next);
  if (search.robot.velocity == Vec3{} && next_velocity == Vec3{}) return true;
  return std::all_of(search.others.begin(), search.others.end(), [&](const Predicted& other) {
    if (!other.asks_to_stop) return true;
    if (!is_reached_at_rest(other, step.path, 0.0, 0.0, law)) return false;
    for (int m = 0; m < braking.steps; ++m) {
      const double elapsed = law.time_step * (m + 1);
      if (!is_reached_at_rest(other, interval_of(braking, law, m), 0.0, elapsed, law)) return false;
    }
    return true;
  });
}

}  // namespace avo::space
