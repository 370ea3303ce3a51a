// SPDX-License-Identifier: Apache-2.0
// The common results of the trips of a fleet (docs/metrics.md).
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/plane.h"
#include "metrics/trips.h"

namespace avo::inline metrics {
namespace {

constexpr double kPatience = 3.0;  // ideal times: a later arrival is no success

// Sums up values and their number.
struct Mean {
  double sum = 0.0, count = 0.0;

  void add(double value) { sum += value, count += 1.0; }
  [[nodiscard]] std::optional<double> value() const {
    return count > 0.0 ? std::optional(sum / count) : std::nullopt;
  }
};

template <int D>
double duration_of(const TripOf<D>& trip) {
  return trip.end - trip.begin;
}

// Arrivals are seen at the ends of steps.
template <int D>
bool is_in_time(const TripOf<D>& trip) {
  return trip.arrival && duration_of(trip) <= kPatience * trip.ideal_time + trip.step;
}

}  // namespace

double quantile(std::span<double> values, double share) {
  const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[static_cast<std::size_t>(place)];
}

template <int D>
void describe_trips(std::span<const TripOf<D>* const> trips, RunMetrics& metrics) {
  Mean success, collision, timeout, extra, ratio, effort, reversals, efficacy, deadlock;
  double flowtime = 0.0, jerk_squared = 0.0, jerk_steps = 0.0, acceleration_squared = 0.0;
  std::int64_t moving_steps = 0, turned_back = 0;
  bool have_arrived = true;
  std::vector<double> extra_times;
  for (const TripOf<D>* const each : trips) {
    const TripOf<D>& trip = *each;
    ++metrics.trips;
    collision.add(trip.overlapped ? 1.0 : 0.0);
    success.add(!trip.overlapped && is_in_time(trip) ? 1.0 : 0.0);
    timeout.add(!trip.overlapped && !is_in_time(trip) ? 1.0 : 0.0);
    effort.add(trip.effort);
    reversals.add(static_cast<double>(trip.reversals));
    deadlock.add(trip.deadlock_time);
    flowtime += duration_of(trip);
    acceleration_squared += trip.effort / (trip.acceleration_limit * trip.acceleration_limit);
    jerk_squared += trip.jerk_squared;
    jerk_steps += trip.jerk_steps;
    moving_steps += trip.moving_steps;
    turned_back += trip.turned_back;
    const bool has_route = trip.route_length < kInfinity && trip.route_left < kInfinity;
    const double best = trip.preferred_speed * duration_of(trip);  // m
    if (has_route && best > 0.0) efficacy.add((trip.route_length - trip.route_left) / best);
    if (!trip.arrival) {
      have_arrived = false;
      continue;
    }
    if (trip.ideal_time < kInfinity) {
      extra_times.push_back(duration_of(trip) - trip.ideal_time);
      extra.add(extra_times.back());
    }
    if (has_route && duration_of(trip) > 0.0)
      ratio.add((trip.length + trip.route_left) / trip.route_length);
  }
  metrics.success = success.value();
  metrics.collision = collision.value();
  metrics.timeout = timeout.value();
  metrics.extra_time_mean = extra.value();
  if (!extra_times.empty()) {
    metrics.extra_time_p75 = quantile(extra_times, 0.75);
    metrics.extra_time_p90 = quantile(extra_times, 0.90);
  }
  if (metrics.trips > 0 && have_arrived) metrics.flowtime = flowtime;
  metrics.path_ratio = ratio.value();
  metrics.effort = effort.value();
  if (flowtime > 0.0) metrics.acceleration_rms = std::sqrt(acceleration_squared / flowtime);
  if (jerk_steps > 0.0) metrics.jerk = std::sqrt(jerk_squared / jerk_steps);
  metrics.reversals = reversals.value();
  if (moving_steps > 0)
    metrics.turned_back = static_cast<double>(turned_back) / static_cast<double>(moving_steps);
  metrics.efficacy = efficacy.value();
  metrics.deadlock_time = deadlock.value();
}
template void describe_trips<2>(std::span<const TripOf<2>* const>, RunMetrics&);
template void describe_trips<3>(std::span<const TripOf<3>* const>, RunMetrics&);

void Trips::describe(RunMetrics& metrics) const {
  std::vector<const Trip*> judged;
  for (const Trip& trip : trips_) {
    if (!trip.parked && is_judged(trip.robot)) judged.push_back(&trip);
  }
  describe_trips<2>(judged, metrics);
}

}  // namespace avo::inline metrics
