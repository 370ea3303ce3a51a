// SPDX-License-Identifier: Apache-2.0
#include "metrics/ideal_time.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/plane.h"

namespace avo::inline metrics {
namespace {

// A part of the route at one acceleration.
struct Phase {
  double length;        // m
  double speed;         // m/s, at its start
  double acceleration;  // m/s^2
};

// s, for its first `length` m.
double time_of(const Phase& phase, double length) {
  const double end_squared = phase.speed * phase.speed + 2.0 * phase.acceleration * length;
  return 2.0 * length / (phase.speed + std::sqrt(std::max(end_squared, 0.0)));
}

// The phases from a speed >= 0: up or down to the peak, on at it, and down to rest. A robot that is
// too fast to stop at the goal brakes all the time.
std::array<Phase, 3> phases_of(const IdealTrip& trip, double speed, double distance) {
  const double a = trip.acceleration, top = trip.top_speed;
  const double stopping = trip.stops ? speed * speed / (2.0 * a) : 0.0;
  if (stopping >= distance && trip.stops) return {{{distance, speed, -a}, {}, {}}};
  double peak = top;
  if (trip.stops && speed <= top)
    peak = std::min(top, std::sqrt(a * distance + 0.5 * speed * speed));
  const double change = std::min(std::abs(peak * peak - speed * speed) / (2.0 * a), distance);
  const double braking = trip.stops ? std::min(peak * peak / (2.0 * a), distance - change) : 0.0;
  return {{{change, speed, peak < speed ? -a : a},
           {distance - change - braking, peak, 0.0},
           {braking, peak, -a}}};
}

}  // namespace

double ideal_time(const IdealTrip& trip) {
  if (trip.distance <= trip.margin) return 0.0;
  if (!(trip.distance < kInfinity)) return kInfinity;
  double speed = trip.speed, distance = trip.distance, time = 0.0;
  if (speed < 0.0) {  // the robot must turn round first
    time = -speed / trip.acceleration;
    distance += 0.5 * time * -speed;
    speed = 0.0;
  }
  double left = distance - trip.margin;
  for (const Phase& phase : phases_of(trip, speed, distance)) {
    const double length = std::min(phase.length, left);
    if (!(length > 0.0)) continue;
    time += time_of(phase, length);
    left -= length;
  }
  return time;
}

}  // namespace avo::inline metrics
