// SPDX-License-Identifier: Apache-2.0
// The fields of motion models. Footprints have keys of their own in scene files.
#pragma once
#include "fields/field.h"

namespace avo::inline fields {

template <>
AVO_LOCAL inline constexpr auto kFields<Car> = std::to_array<Field<Car>>({
    {"wheelbase", &Car::wheelbase, kOptional, kPositive, "m", "between the axles"},
    {"max_curvature", &Car::max_curvature, kOptional, kPositive, "1/m",
     "of its way; it turns in place only without", "unlimited"},
    {"body", kNested, kOptional, kNoNumber, "", "the disc that covers it",
     "that of radius, about the rear axle"},
    {"reverse", &Car::reverse, kOptional, kNoNumber, "", "it may drive backwards"},
    {"acceleration_set", &Car::acceleration_set, kOptional, kNoNumber, "",
     "exact: |a_lin| and |a_lat| <= max_acceleration; incircle: |a| is"},
});

template <>
AVO_LOCAL inline constexpr auto kFields<CarBody> = std::to_array<Field<CarBody>>({
    {"offset", &CarBody::offset, kOptional, kAnyValue, "m",
     "of its center, ahead of the rear axle"},
    {"radius", &CarBody::radius, kRequired, kPositive, "m", "of the disc, instead of radius"},
});

template <>
AVO_LOCAL inline constexpr auto kFields<DifferentialDrive> =
    std::to_array<Field<DifferentialDrive>>({
        {"track", &DifferentialDrive::track, kOptional, kPositive, "m", "between the wheels"},
        {"offset", &DifferentialDrive::offset, kOptional, kPositive, "m",
         "ahead of the axle, of the point that is planned for; the disc that others sense is about "
         "it, with radius + offset",
         "half of the smaller one of radius and track"},
        {"wheel_speed", &DifferentialDrive::wheel_speed, kOptional, kPositive, "m/s",
         "of each wheel, never exceeded"},
        {"wheel_acceleration", &DifferentialDrive::wheel_acceleration, kOptional, kPositive,
         "m/s^2", "of each wheel, never exceeded"},
    });

template <>
AVO_LOCAL inline constexpr auto kFields<Airplane> = std::to_array<Field<Airplane>>({
    {"min_speed", &Airplane::min_speed, kOptional, kPositive, "m/s", "never less"},
    {"lateral_acceleration", &Airplane::lateral_acceleration, kOptional, kPositive, "m/s^2",
     "across its way, never exceeded; max_acceleration is along it"},
    {"after_goal", &Airplane::after_goal, kOptional, kNoNumber, "",
     "once it has passed its goal: it turns right there for ever, or is gone"},
});

}  // namespace avo::inline fields
