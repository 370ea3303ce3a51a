// SPDX-License-Identifier: Apache-2.0
#include "certificate/predicted.h"

#include <algorithm>
#include <cmath>

#include "core/plane.h"
#include "walls/segment.h"

namespace avo::inline certificate {

Vec2 Predicted::place_at(double time) const {
  if (trajectory != nullptr) return trajectory->place(trajectory->step_at(time));
  return position + time * (velocity + (0.5 * time) * acceleration);
}

Vec2 Predicted::velocity_at(double time) const {
  if (trajectory != nullptr) return trajectory->velocity(trajectory->step_at(time));
  return velocity + time * acceleration;
}

double Predicted::bend_at(double time) const {
  return trajectory != nullptr ? trajectory->bend[trajectory->step_at(time)] : 0.0;
}

double Predicted::spread_at(double time) const {
  const double t = std::min(time, reaction);
  return t * (drift + 0.5 * t * deviation);
}

// Tests three directions: any one of them is proof.
bool keeps_off(const Hull& relative, double distance) {
  const auto along = [&](Vec2 n) {
    const double least = (distance + relative.bend) * norm(n);
    return n != Vec2{} && dot(n, relative.start) >= least && dot(n, relative.middle) >= least &&
           dot(n, relative.end) >= least;
  };
  return along(nearest_on({relative.start, relative.end}, {})) ||
         along(nearest_on({relative.start, relative.middle}, {})) ||
         along(nearest_on({relative.middle, relative.end}, {}));
}

namespace {

// Returns whether A, at rest at the place, is not touched from one time to a later one.
bool keeps_beside_parabola(const Predicted& other, Vec2 place, double from, double to,
                           double distance, int bisections) {
  const Vec2 c = other.place_at(from);
  const Hull hull{place - c, place - c - (0.5 * (to - from)) * other.velocity_at(from),
                  place - other.place_at(to)};
  if (keeps_off(hull, distance)) return true;
  if (bisections == 0 || norm(hull.start) < distance || norm(hull.end) < distance) return false;
  const double half = 0.5 * (from + to);
  return keeps_beside_parabola(other, place, from, half, distance, bisections - 1) &&
         keeps_beside_parabola(other, place, half, to, distance, bisections - 1);
}

// s, the time after which a mover with constant acceleration moves away from the place, beyond the
// distance: along n = a/|a|, n·(c(t) - place) = s + n·v t + |a| t²/2.
double leaves_at(const Predicted& other, Vec2 place, double distance) {
  const double a = norm(other.acceleration);
  const Vec2 n = other.acceleration / a;
  const double s = dot(n, other.position - place) - distance, v = dot(n, other.velocity);
  if (s >= 0.0 && v >= 0.0) return 0.0;
  const double root = std::sqrt(std::max(v * v - 2.0 * a * s, 0.0));
  // the form without cancellation; where the mover comes back, the time at which it moves away
  // again
  return std::max(v > 0.0 ? -2.0 * s / (root + v) : (root - v) / a, 0.0);
}

constexpr int kBisections = 12;

}  // namespace

bool rests_clear(const Predicted& other, Vec2 place, double time, double wider) {
  const double contact = other.contact + wider;
  const double distance = contact + other.spread_at(other.reaction + time);
  if (other.trajectory != nullptr) {
    const TrajectorySteps& steps = *other.trajectory;
    return passes_by(steps.trajectory(), steps.now() + time, place + steps.origin(), distance);
  }
  if (!(time < other.until)) return true;
  if (!is_rest(other.acceleration)) {
    const double left = std::min(std::max(time, leaves_at(other, place, distance)), other.until);
    return keeps_beside_parabola(other, place, time, left, distance, kBisections);
  }
  const Vec2 way = place - other.place_at(time), v = other.velocity_at(time);
  const double squared = norm_squared(v), along = is_rest(v) ? 0.0 : dot(way, v);
  // for a mover that moves away, or rests, its place at that time counts
  if (!(along > 0.0)) return norm(way) >= contact + other.spread_at(time);
  return norm(way - std::min(along / squared, other.until - time) * v) >= distance;
}

Hull relative_to(const Predicted& other, const Hull& own, double time, const StepLaw& law) {
  const Vec2 place = other.place_at(time);
  return {own.start - place, own.middle - place - law.lag * other.velocity_at(time),
          own.end - other.place_at(time + law.time_step), own.bend + other.bend_at(time)};
}

namespace {

// m, the distance that A keeps from the place where the mover is seen at `from`, for any later
// motion of it: without [V].
double kept_of_place(const Predicted& other, double from, double end) {
  const double seen = std::min(from, other.reaction);
  return other.stop_contact + (from + end) * other.drift + 0.5 * other.deviation * seen * seen;
}

}  // namespace

double kept_before_rest(const Predicted& other, double from, double elapsed) {
  const double seen = std::min(from, other.reaction);
  return kept_of_place(other, from, elapsed) + other.deviation * elapsed * (seen + 0.5 * elapsed);
}

bool is_reached_at_rest(const Predicted& other, const Hull& own, double from, double elapsed,
                        const StepLaw& law) {
  const double end = elapsed + law.time_step;
  if (keeps_off(relative_to(other, own, from + elapsed, law), kept_before_rest(other, from, end)))
    return true;
  if (!(other.deviation > 0.0) || !std::isfinite(other.max_speed)) return false;
  const Vec2 c = other.place_at(from);
  return keeps_off({own.start - c, own.middle - c, own.end - c, own.bend},
                   kept_of_place(other, from, end) + other.max_speed * end);
}

double room_before_rest(const Predicted& other, Vec2 place, double from, double elapsed) {
  const double time = from + elapsed;
  return norm(place - other.place_at(time)) -
         std::max(other.contact + other.spread_at(time), kept_before_rest(other, from, elapsed));
}

double room_to(const Predicted& other, Vec2 place, double time) {
  const double stop = other.stop_contact + (time + other.reaction) * other.drift;
  return norm(place - other.place_at(time)) -
         (std::max(other.contact, stop) + other.spread_at(time));
}

}  // namespace avo::inline certificate
