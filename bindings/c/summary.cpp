// SPDX-License-Identifier: Apache-2.0
// The results of a run.
#include <limits>

#include "simulations.h"

namespace avo_c {
namespace {

double or_none(const std::optional<double>& value) {
  return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

avo_run_metrics to_c(const avo::RunMetrics& metrics) {
  return {.trips = metrics.trips,
          .collision_robot_steps = metrics.collision_robot_steps,
          .overlap_depth = metrics.overlap_depth,
          .success = or_none(metrics.success),
          .collision = or_none(metrics.collision),
          .timeout = or_none(metrics.timeout),
          .extra_time_mean = or_none(metrics.extra_time_mean),
          .extra_time_p75 = or_none(metrics.extra_time_p75),
          .extra_time_p90 = or_none(metrics.extra_time_p90),
          .flowtime = or_none(metrics.flowtime),
          .path_ratio = or_none(metrics.path_ratio),
          .effort = or_none(metrics.effort),
          .acceleration_rms = or_none(metrics.acceleration_rms),
          .jerk = or_none(metrics.jerk),
          .reversals = or_none(metrics.reversals),
          .turned_back = or_none(metrics.turned_back),
          .efficacy = or_none(metrics.efficacy),
          .deadlock_time = or_none(metrics.deadlock_time)};
}

avo_summary to_c(const avo::RunSummary& run) {
  const avo::Decisions& decisions = run.decisions;
  return {
      .size = sizeof(avo_summary),
      .robots = run.robots,
      .parked = run.parked,
      .steps = run.steps,
      .arrived = run.arrived,
      .collision_pairs = run.collision_pairs,
      .one_sided_collisions = run.one_sided_collisions,
      .one_sided_collisions_in_motion = run.one_sided_collisions_in_motion,
      .mover_collisions = run.mover_collisions,
      .mover_collisions_in_motion = run.mover_collisions_in_motion,
      .static_collisions = run.static_collisions,
      .first_seen_too_late = run.first_seen_too_late.value_or(-1),
      .infeasible_steps = run.infeasible_steps,
      .unreachable = static_cast<std::int64_t>(run.unreachable.size()),
      .decisions = {decisions.optimal, decisions.least_unsafe, decisions.refused, decisions.braking,
                    decisions.overlapping, decisions.invalid_input, decisions.detour},
      .first_collision_time = or_none(run.first_collision_time),
      .min_clearance = or_none(run.min_clearance),
      .min_static_clearance = or_none(run.min_static_clearance),
      .max_acceleration = run.max_acceleration,
      .acceleration_excess = run.acceleration_excess,
      .max_speed = run.max_speed,
      .mean_arrival = or_none(run.mean_arrival),
      .last_arrival = or_none(run.last_arrival),
      .metrics = to_c(run.metrics),
      .mover_collisions_evadable = run.mover_collisions_evadable.value_or(-1)};
}

}  // namespace
}  // namespace avo_c

using namespace avo_c;  // NOLINT(google-build-using-namespace): what follows is C

avo_summary avo_default_summary(void) {
  return to_c(avo::RunSummary{});
}

avo_result avo_simulation_summary(avo_simulation_id simulation, avo_summary* summary) {
  return guarded([&] {
    const Simulation& own = simulations.at(simulation);
    if (own.metrics == nullptr)
      fail(AVO_ERROR_UNSUPPORTED,
           "metrics: found false, must be true in the definition of a "
           "simulation whose summary is asked for");
    write(summary, to_c(own.metrics->summary()), {"summary"});
  });
}
