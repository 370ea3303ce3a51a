// SPDX-License-Identifier: Apache-2.0
// One trip of one robot, step by step (docs/metrics.md).
#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>

#include "avo/metrics.h"
#include "core/vector_of.h"

namespace avo::inline metrics {

/// of the preferred speed, nearer than ever before: less is no progress
inline constexpr double kProgress = 0.01;
inline constexpr double kNoDirection = 0.01;  // of a_max: a smaller acceleration has no direction
inline constexpr double kStrong = 0.3;        // of a_max: a smaller acceleration cannot turn back

/// Part of the preferred speed: a slower robot is not in motion.
inline constexpr double kMoves = 0.01;

/// The trip of one robot, in the plane or in space. If its goal changes during the trip, the trip
/// begins anew there.
template <int D>
struct TripOf {
  using Vector = VectorOf<D>;
  std::uint64_t robot = 0;
  std::optional<double> arrival = {};  // s
  bool parked = false;
  bool overlapped = false;                      // before it arrived; a moving obstacle at any time
  double begin = 0.0;                           // s
  double end = 0.0;                             // s, so far
  Vector goal = {};                             // m
  double ideal_time = 0.0;                      // s
  double preferred_speed = 0.0;                 // m/s
  double step = 0.0;                            // s, of the robot itself
  double route_length = 0.0, route_left = 0.0;  // m, route length at the beginning and now
  double progress = 0.0;                        // m, route length left when it last made progress
  double acceleration_limit = 0.0;              // [a_max] m/s^2, of its motion model

  Vector position = {}, velocity = {};  // m, m/s, as last seen
  Vector acceleration = {},
         directed = {};        // m/s^2, of the last step; the last one with a direction
  double length = 0.0;         // m, of its path so far
  double effort = 0.0;         // m^2/s^3
  double jerk_squared = 0.0;   // sum over all steps except the first, (m/s^3)^2
  double jerk_steps = 0.0;     // number of these steps
  double deadlock_time = 0.0;  // s
  std::int64_t reversals = 0;
  std::int64_t moving_steps = 0, turned_back = 0;  // of its own steps except the first
  bool has_acceleration = false;
};

using Trip = TripOf<2>;

/// Returns whether two accelerations are both more than that, m/s^2, and more than 135 degrees
/// apart.
template <typename Vector>
bool turns_back(Vector a, Vector b, double least) {
  const double along = dot(a, b), a_squared = norm_squared(a), b_squared = norm_squared(b);
  return along < 0.0 && 2.0 * along * along > a_squared * b_squared &&
         std::min(a_squared, b_squared) > least * least;
}

/// Adds the robot's own step in which it accelerates by a, if it moves before it.
template <int D>
void add_step(TripOf<D>& trip, VectorOf<D> a) {
  const double least = kMoves * trip.preferred_speed;  // m/s
  if (!(norm_squared(trip.velocity) > least * least)) return;
  ++trip.moving_steps;
  if (turns_back(a, trip.acceleration, kStrong * trip.acceleration_limit)) ++trip.turned_back;
}

/// Advances the trip by a step of that duration, s, > 0, after which that length of the route is
/// left, m. With free clocks it is a part of the robot's own step: the first part where the robot
/// decided.
template <int D>
void go_on(TripOf<D>& trip, VectorOf<D> position, VectorOf<D> velocity, double route_left,
           double duration, bool decided) {
  const VectorOf<D> a = (velocity - trip.velocity) / duration;
  const double a_squared = norm_squared(a);
  trip.length += norm(position - trip.position);
  trip.route_left = route_left;
  if (trip.progress - route_left >= kProgress * trip.preferred_speed * duration)
    trip.progress = route_left;
  else
    trip.deadlock_time += duration;
  trip.effort += a_squared * duration;
  if (trip.has_acceleration) {
    trip.jerk_squared += norm_squared(a - trip.acceleration) / (trip.step * trip.step);
    trip.jerk_steps += duration == trip.step ? 1.0 : duration / trip.step;
    if (decided) add_step(trip, a);
  }
  const double least = kNoDirection * trip.acceleration_limit;
  if (a_squared >= least * least) {
    if (dot(a, trip.directed) < 0.0) ++trip.reversals;
    trip.directed = a;
  }
  trip.acceleration = a;
  trip.has_acceleration = true;
  trip.position = position;
  trip.velocity = velocity;
}

/// The value among the sorted values that more than the share of them does not exceed; 0 <= share <
/// 1, and there must be a value. It reorders the values.
double quantile(std::span<double> values, double share);

/// Writes the results of these trips into the metrics.
template <int D>
void describe_trips(std::span<const TripOf<D>* const> trips, RunMetrics& metrics);

}  // namespace avo::inline metrics
