// SPDX-License-Identifier: Apache-2.0
// The fields of a planner's options: those of a scene, and what a scene derives.
#pragma once
#include "fields/scene_fields.h"

namespace avo::inline fields {

template <>
struct MembersOf<PlannerOptions> {
  using type = MemberOf<PlannerOptions, double, std::optional<double>, std::optional<int>, bool,
                        Method, Motion, Certificate, Clock>;
};

template <>
AVO_LOCAL inline constexpr auto kFields<PlannerOptions> = [] {
  using Options = PlannerOptions;
  return std::to_array<Field<Options>>({
      as_in<Scenario>("method", &Options::method),
      as_in<Scenario>("motion", &Options::motion),
      as_in<Scenario>("control_time", &Options::control_time),
      as_in<Scenario>("time_horizon", &Options::time_horizon),
      as_in<Scenario>("response_time", &Options::response_time),
      as_in<Scenario>("comfort_acceleration", &Options::comfort_acceleration),
      as_in<Scenario>("comfort_jerk", &Options::comfort_jerk),
      as_in<Scenario>("margin", &Options::margin),
      as_in<Scenario>("time_step", &Options::time_step),
      as_in<Scenario>("certificate", &Options::certificate),
      as_in<Scenario>("max_neighbors", &Options::max_neighbors),
      {"sensing_error", kNested, kOptional, kNoNumber, "",
       "that it declares to braking_trajectories"},
      {"sensing_noise", kNested, kOptional, kNoNumber, "", "for which half-planes keep a margin"},
      {"localization_error", &Options::localization_error, kOptional, kNotNegative, "m",
       "of its own position among the walls"},
      {"wall_range", kNested, kOptional, kNoNumber, "m",
       "from its disc, within which all walls are given; may be infinite", "0"},
      as_in<Scenario>("clock", &Options::clock),
      {"longest_step", &Options::longest_step, kOptional, kNotNegative, "s",
       "the largest time_step of any other robot, with a free clock"},
      as_in<Scenario>("arrival_distance", &Options::arrival_distance),
      as_in<Scenario>("never_swerves", &Options::never_swerves),
  });
}();

template <>
AVO_LOCAL inline constexpr auto kFields<SensingNoise> = std::to_array<Field<SensingNoise>>({
    {"position", &SensingNoise::position, kOptional, kNotNegative, "m",
     "of each coordinate: standard deviation"},
    {"velocity", &SensingNoise::velocity, kOptional, kNotNegative, "m/s",
     "standard deviation of the velocity"},
    {"quantile", &SensingNoise::quantile, kOptional, kNotNegative, "",
     "standard deviations that the margin covers"},
});

}  // namespace avo::inline fields
