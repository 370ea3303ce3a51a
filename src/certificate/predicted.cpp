// SPDX-License-Identifier: Apache-2.0
#include "certificate/predicted.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/plane.h"
#include "walls/segment.h"

namespace avo::inline certificate {
namespace {

Vec2 nearest_to_origin(Vec2 a, Vec2 b) {
  return nearest_on({a, b}, {});
}
Vec3 nearest_to_origin(Vec3 a, Vec3 b) {
  const Vec3 ab = b - a;
  const double squared = norm_squared(ab);
  return squared > 0.0 ? a + std::clamp(-dot(a, ab) / squared, 0.0, 1.0) * ab : a;
}

constexpr bool is_rest(Vec3 velocity) {
  return norm_squared(velocity) < std::numeric_limits<double>::min();
}

}  // namespace

template <int D>
VectorOf<D> PredictedOf<D>::place_at(double time) const {
  if constexpr (D == 2) {
    if (trajectory != nullptr) return trajectory->place(trajectory->step_at(time));
  }
  return position + time * (velocity + (0.5 * time) * acceleration);
}

template <int D>
VectorOf<D> PredictedOf<D>::velocity_at(double time) const {
  if constexpr (D == 2) {
    if (trajectory != nullptr) return trajectory->velocity(trajectory->step_at(time));
  }
  return velocity + time * acceleration;
}

template <int D>
double PredictedOf<D>::bend_at(double time) const {
  return trajectory != nullptr ? trajectory->bend[trajectory->step_at(time)] : 0.0;
}

template <int D>
double PredictedOf<D>::spread_at(double time) const {
  const double t = std::min(time, reaction);
  return t * (drift + 0.5 * t * deviation);
}

// Tests three directions, and in space that of the plane of the points: any one of them is proof.
template <int D>
bool keeps_off(const HullOf<D>& relative, double distance) {
  const auto along = [&](VectorOf<D> n) {
    const double least = (distance + relative.bend) * norm(n);
    return n != VectorOf<D>{} && dot(n, relative.start) >= least &&
           dot(n, relative.middle) >= least && dot(n, relative.end) >= least;
  };
  const auto [start, middle, end, bend] = relative;
  if (along(nearest_to_origin(start, end)) || along(nearest_to_origin(start, middle)) ||
      along(nearest_to_origin(middle, end)))
    return true;
  if constexpr (D == 3) {
    const Vec3 face = cross(middle - start, end - start);
    return along(dot(face, start) < 0.0 ? -face : face);
  }
  return false;
}

namespace {

// Returns whether A, at rest at the place, is not touched from one time to a later one.
template <int D>
bool keeps_beside_parabola(const PredictedOf<D>& other, VectorOf<D> place, double from, double to,
                           double distance, int bisections) {
  const VectorOf<D> c = other.place_at(from);
  const HullOf<D> hull{place - c, place - c - (0.5 * (to - from)) * other.velocity_at(from),
                       place - other.place_at(to)};
  if (keeps_off(hull, distance)) return true;
  if (bisections == 0 || norm(hull.start) < distance || norm(hull.end) < distance) return false;
  const double half = 0.5 * (from + to);
  return keeps_beside_parabola(other, place, from, half, distance, bisections - 1) &&
         keeps_beside_parabola(other, place, half, to, distance, bisections - 1);
}

// s, the time after which a mover with constant acceleration moves away from the place, beyond the
// distance: along n = a/|a|, n·(c(t) - place) = s + n·v t + |a| t²/2.
template <int D>
double leaves_at(const PredictedOf<D>& other, VectorOf<D> place, double distance) {
  const double a = norm(other.acceleration);
  const VectorOf<D> n = other.acceleration / a;
  const double s = dot(n, other.position - place) - distance, v = dot(n, other.velocity);
  if (s >= 0.0 && v >= 0.0) return 0.0;
  const double root = std::sqrt(std::max(v * v - 2.0 * a * s, 0.0));
  // the form without cancellation; where the mover comes back, the time at which it moves away
  // again
  return std::max(v > 0.0 ? -2.0 * s / (root + v) : (root - v) / a, 0.0);
}

constexpr int kBisections = 12;

}  // namespace

template <int D>
bool rests_clear(const PredictedOf<D>& other, VectorOf<D> place, double time, double wider) {
  const double contact = other.contact + wider;
  const double distance = contact + other.spread_at(other.reaction + time);
  if constexpr (D == 2) {
    if (other.trajectory != nullptr) {
      const TrajectorySteps& steps = *other.trajectory;
      return passes_by(steps.trajectory(), steps.now() + time, place + steps.origin(), distance);
    }
  }
  if (!(time < other.until)) return true;
  if (!is_rest(other.acceleration)) {
    const double left = std::min(std::max(time, leaves_at(other, place, distance)), other.until);
    return keeps_beside_parabola(other, place, time, left, distance, kBisections);
  }
  const VectorOf<D> to_place = place - other.place_at(time), v = other.velocity_at(time);
  const double squared = norm_squared(v), along = is_rest(v) ? 0.0 : dot(to_place, v);
  // for a mover that moves away, or rests, its place at that time counts
  if (!(along > 0.0)) return norm(to_place) >= contact + other.spread_at(time);
  return norm(to_place - std::min(along / squared, other.until - time) * v) >= distance;
}

template <int D>
HullOf<D> relative_to(const PredictedOf<D>& other, const HullOf<D>& own, double time,
                      const StepLaw& law) {
  const VectorOf<D> place = other.place_at(time);
  return {own.start - place, own.middle - place - law.lag * other.velocity_at(time),
          own.end - other.place_at(time + law.time_step), own.bend + other.bend_at(time)};
}

namespace {

// m, the distance that A keeps from the place where the mover is seen at `from`, for any later
// motion of it: without [V].
template <int D>
double kept_of_place(const PredictedOf<D>& other, double from, double end) {
  const double seen = std::min(from, other.reaction);
  return other.stop_contact + (from + end) * other.drift + 0.5 * other.deviation * seen * seen;
}

}  // namespace

template <int D>
double kept_before_rest(const PredictedOf<D>& other, double from, double elapsed) {
  const double seen = std::min(from, other.reaction);
  return kept_of_place(other, from, elapsed) + other.deviation * elapsed * (seen + 0.5 * elapsed);
}

template <int D>
bool is_reached_at_rest(const PredictedOf<D>& other, const HullOf<D>& own, double from,
                        double elapsed, const StepLaw& law) {
  const double end = elapsed + law.time_step;
  if (keeps_off(relative_to(other, own, from + elapsed, law), kept_before_rest(other, from, end)))
    return true;
  if (!(other.deviation > 0.0) || !std::isfinite(other.max_speed)) return false;
  const VectorOf<D> c = other.place_at(from);
  return keeps_off(HullOf<D>{own.start - c, own.middle - c, own.end - c, own.bend},
                   kept_of_place(other, from, end) + other.max_speed * end);
}

template <int D>
double room_before_rest(const PredictedOf<D>& other, VectorOf<D> place, double from,
                        double elapsed) {
  const double time = from + elapsed;
  return norm(place - other.place_at(time)) -
         std::max(other.contact + other.spread_at(time), kept_before_rest(other, from, elapsed));
}

template <int D>
double room_to(const PredictedOf<D>& other, VectorOf<D> place, double time) {
  const double stop = other.stop_contact + (time + other.reaction) * other.drift;
  return norm(place - other.place_at(time)) -
         (std::max(other.contact, stop) + other.spread_at(time));
}

#define AVO_PREDICTED(D)                                                                           \
  template struct PredictedOf<D>;                                                                  \
  template HullOf<D> relative_to(const PredictedOf<D>&, const HullOf<D>&, double, const StepLaw&); \
  template bool keeps_off(const HullOf<D>&, double);                                               \
  template bool rests_clear(const PredictedOf<D>&, VectorOf<D>, double, double);                   \
  template bool is_reached_at_rest(const PredictedOf<D>&, const HullOf<D>&, double, double,        \
                                   const StepLaw&);                                                \
  template double kept_before_rest(const PredictedOf<D>&, double, double);                         \
  template double room_to(const PredictedOf<D>&, VectorOf<D>, double);                             \
  template double room_before_rest(const PredictedOf<D>&, VectorOf<D>, double, double);
AVO_PREDICTED(2)
AVO_PREDICTED(3)
#undef AVO_PREDICTED

}  // namespace avo::inline certificate
