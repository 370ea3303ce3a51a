// SPDX-License-Identifier: Apache-2.0
// The fields of a scene, of its sensing and of its moving obstacles.
#pragma once
#include "fields/field.h"

namespace avo::inline fields {

inline constexpr Range kSeed{0.0, 18446744073709551615.0, false};
inline constexpr Range kDelay{0.0, kMostDelay, false};  // steps
inline constexpr Range kSceneName{1.0, 200.0, false};   // bytes
inline constexpr Range kMethodName{1.0, 64.0, false};   // bytes

template <>
AVO_LOCAL inline constexpr auto kFields<Scenario> = std::to_array<Field<Scenario>>({
    {"version", kNested, kRequired, {1.0, 1.0, false}, "", "version of this format"},
    {"name", &Scenario::name, kOptional, kSceneName, "", "of the scene", "the file's name"},
    {"time_step", &Scenario::time_step, kOptional, kPositive, "s", "between decisions"},
    {"duration", &Scenario::duration, kOptional, kPositive, "s", "of the whole scene",
     "60 s and twice the longest straight way to a goal"},
    {"control_time", &Scenario::control_time, kOptional, kPositive, "s",
     "delta: time constant with which a new velocity is approached",
     "2 s for method avo, else 4 s"},
    {"response_time", &Scenario::response_time, kOptional, kNotNegative, "",
     "of max_speed/max_acceleration: with which a new velocity is approached; 0: at once; method "
     "avo only",
     "0.1 for method avo, else 0"},
    {"comfort_acceleration", &Scenario::comfort_acceleration, kOptional, kPositive, "m/s^2",
     "what is used of max_acceleration but where the certificate asks for more; method avo only",
     "no limit"},
    {"comfort_jerk", &Scenario::comfort_jerk, kOptional, kPositive, "m/s^3",
     "what is used of any change of the acceleration in a second but where the certificate asks "
     "for "
     "more; method avo only",
     "max_acceleration in 0.8 of the response time"},
    {"margin", &Scenario::margin, kOptional, kNotNegative, "m",
     "clearance from others that is wished for; fades in narrow places; method avo only"},
    {"never_swerves", &Scenario::never_swerves, kOptional, kNoNumber, "",
     "a robot is at rest whenever a mover touches it that keeps to what is known of it; else it "
     "may swerve where it could no longer stop; method avo only"},
    {"time_horizon", &Scenario::time_horizon, kOptional, kPositive, "s",
     "tau: how far collisions are looked for", "3 s for method avo, else 10 s"},
    {"sensing_radius", &Scenario::sensing_radius, kOptional, kPositive, "m",
     "between centers: a robot farther away is not sensed",
     "what the robots need, see docs/scenes.md"},
    {"max_neighbors", &Scenario::max_neighbors, kOptional, kAtLeastOne, "",
     "nearest neighbors that get a half-plane", "no limit"},
    {"method", &Scenario::method, kOptional, kNoNumber, "", "how new velocities are chosen"},
    {"external_method", &Scenario::external_method, kOptional, kMethodName, "",
     "the name of your own method, for robots of method external or external_clamped", "none"},
    {"certificate", &Scenario::certificate, kOptional, kNoNumber, "",
     "what no decision may break; not with methods that adopt v' at once, nor avo_paper",
     "braking_trajectories for method avo, else none"},
    {"motion", &Scenario::motion, kOptional, kNoNumber, "",
     "between decisions: acceleration held, or proportional control exactly"},
    {"arrival_distance", &Scenario::arrival_distance, kOptional, kPositive, "m",
     "from the goal, within which a robot has arrived"},
    {"seed", &Scenario::seed, kOptional, kSeed, "",
     "of random placements, goals, headings and phases, and of what is sensed"},
    {"robots", kNested, kOptional, kNoNumber, "", "numbered 0, 1, ... in this order"},
    {"groups", kNested, kOptional, kNoNumber, "", "many like robots each, numbered after `robots`"},
    {"robots_from", kNested, kOptional, kNoNumber, "",
     "robots of a MovingAI scenario, numbered after `robots` and before `groups`"},
    {"moving_obstacles", kNested, kOptional, kNoNumber, "", "discs that react to no robot"},
    {"obstacles", kNested, kOptional, kNoNumber, "", "what does not move, and no robot may touch"},
    {"navigation", &Scenario::navigation, kOptional, kNoNumber, "",
     "the preferred velocity follows a route around the obstacles",
     "true where there are obstacles, or moving ones at rest"},
    {"right_of_way", &Scenario::right_of_way, kOptional, kNoNumber, "",
     "with navigation, how robots know which others are about to go through a narrow passage"},
    {"sensing",
     kNested,
     kOptional,
     {},
     "",
     "how robots sense others, and themselves; omitted: as they are"},
    {"sensing_error",
     kNested,
     kOptional,
     {},
     "",
     "what robots declare to braking_trajectories; omitted: what covers noise and delay"},
    {"execution", kNested, kOptional, kNoNumber, "",
     "how bases execute commands; omitted: exactly, as decided"},
    {"execution_error", &Scenario::execution_error, kOptional, kNotNegative, "m",
     "with execution: what each robot adds to its radius", "what covers the execution"},
    {"clock", &Scenario::clock, kOptional, kNoNumber, "",
     "free: each robot decides at times of its own, from a phase that the seed gives it"},
    {"allow_broken_assumptions",
     &Scenario::allow_broken_assumptions,
     kOptional,
     {},
     "",
     "it is simulated though robots start where the certificate cannot keep them apart"},
});

template <>
AVO_LOCAL inline constexpr auto kFields<SensingModel> = std::to_array<Field<SensingModel>>({
    {"noise", kNested, kOptional, {}, "", "by which a measurement is off"},
    {"delay", &SensingModel::delay, kOptional, kDelay, "steps",
     "from a measurement to the decision; carried on meanwhile"},
    {"dropped", &SensingModel::dropped, kOptional, kShareMissed, "",
     "share of the measurements that are missed, each by chance"},
    {"occlusion",
     &SensingModel::occlusion,
     kOptional,
     {},
     "",
     "a robot is not sensed if its center is behind an obstacle"},
    {"localization",
     kNested,
     kOptional,
     {},
     "",
     "by which the robot's own place on the map of the obstacles is off"},
});

template <>
AVO_LOCAL inline constexpr auto kFields<MeasurementNoise> = std::to_array<Field<MeasurementNoise>>({
    {"position", &MeasurementNoise::position, kOptional, kNoise, "m",
     "of each coordinate: standard deviation, or bound of uniform noise"},
    {"velocity", &MeasurementNoise::velocity, kOptional, kNoise, "m/s",
     "of each coordinate: standard deviation, or bound of uniform noise"},
    {"distribution", &MeasurementNoise::distribution, kOptional, {}, "", "of each coordinate"},
    {"truncated", &MeasurementNoise::truncated, kOptional, kTruncation, "",
     "gaussian noise stays within so many standard deviations", "3"},
});

template <>
AVO_LOCAL inline constexpr auto kFields<LocalizationNoise> =
    std::to_array<Field<LocalizationNoise>>({
        {"position", &LocalizationNoise::position, kOptional, kNoise, "m",
         "of each coordinate: standard deviation, or bound of uniform noise"},
        {"distribution", &LocalizationNoise::distribution, kOptional, {}, "", "of each coordinate"},
        {"truncated", &LocalizationNoise::truncated, kOptional, kTruncation, "",
         "gaussian noise stays within so many standard deviations", "3"},
    });

template <>
AVO_LOCAL inline constexpr auto kFields<SensingError> = std::to_array<Field<SensingError>>({
    {"position", &SensingError::position, kOptional, kNotNegative, "m",
     "at most so far from where it is sensed"},
    {"velocity", &SensingError::velocity, kOptional, kNotNegative, "m/s",
     "at most so far from what is sensed"},
});

template <>
AVO_LOCAL inline constexpr auto kFields<ExecutionModel> = std::to_array<Field<ExecutionModel>>({
    {"time_constant", &ExecutionModel::time_constant, kOptional, kNotNegative, "s",
     "T: of the velocity's first-order lag"},
    {"time_constant_error", &ExecutionModel::time_constant_error, kOptional, kNotNegative, "s",
     "at most so far from it, 0 to T; drawn for each base"},
    {"dead_time", &ExecutionModel::dead_time, kOptional, kNotNegative, "s",
     "d: from a command until it acts"},
    {"dead_time_error", &ExecutionModel::dead_time_error, kOptional, kNotNegative, "s",
     "at most so far from it, 0 to d; drawn for each base"},
    {"deadband", &ExecutionModel::deadband, kOptional, kNotNegative, "m/s",
     "a slower coordinate of a command does not move the base"},
    {"quantum", &ExecutionModel::quantum, kOptional, kNotNegative, "m/s",
     "coordinates of commands are whole multiples of it; 0: any"},
    {"velocity_error", &ExecutionModel::velocity_error, kOptional, kNotNegative, "m/s",
     "at most so far is the executed velocity off; drawn for each step"},
    {"heading_age", &ExecutionModel::heading_age, kOptional, kNotNegative, "s",
     "of differential drives: period of the wheels' controller, at least time_step/1000"},
    {"measured_position_error", &ExecutionModel::measured_position_error, kOptional, kNotNegative,
     "m", "at most so far off is where the base measures itself; drawn for each step"},
    {"measured_velocity_error", &ExecutionModel::measured_velocity_error, kOptional, kNotNegative,
     "m/s", "at most so far off is the velocity that it measures; drawn for each step"},
});

template <>
AVO_LOCAL inline constexpr auto kFields<MovingObstacle> = std::to_array<Field<MovingObstacle>>({
    {"position", &MovingObstacle::position, kOptional, kAnyValue, "m", "where it starts",
     "where its trajectory has it at 0 s; without one it has to be given"},
    {"velocity", &MovingObstacle::velocity, kOptional, kAnyValue, "m/s", "at the start"},
    {"acceleration", &MovingObstacle::acceleration, kOptional, kAnyValue, "m/s^2", "constant"},
    {"radius", &MovingObstacle::radius, kOptional, kPositive, "m", "of its disc"},
    {"max_deviation", &MovingObstacle::max_deviation, kOptional, kNotNegative, "m/s^2",
     "by which robots count on its acceleration being another one at any time"},
    {"max_speed", &MovingObstacle::max_speed, kOptional, kPositive, "m/s",
     "with max_deviation: that it never exceeds", "no limit"},
    {"path", &MovingObstacle::path, kOptional, kAnyValue, "m",
     "that it goes along within these, from point to point and on to the first again",
     "none: it keeps its acceleration"},
    {"trajectory", &MovingObstacle::trajectory, kOptional, kAnyValue, "",
     "[time, x, y] in s and m, by ascending times: it goes straight and evenly from each to the "
     "next, and stands there before the first and after the last",
     "none"},
    {"trajectory_file", kNested, kOptional, kNoNumber, "",
     "a CSV file of time, x, y in place of `trajectory`", "none"},
});

}  // namespace avo::inline fields
