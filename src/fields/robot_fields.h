// SPDX-License-Identifier: Apache-2.0
// The fields of a robot's setup, in the order of the documentation. New ones come last: saved
// states number them.
#pragma once
#include "fields/field.h"

namespace avo::inline fields {

/// The heading of a robot; a car has this key too.
struct HeadingField {
  std::string_view key, unit, doc;
  Range range;
};
inline constexpr HeadingField kHeadingField{"heading", "rad", "counter-clockwise from +x", kAngle};

using RobotField = Field<RobotSetup>;
template <>
AVO_LOCAL inline constexpr auto kFields<RobotSetup> = std::to_array<Field<RobotSetup>>({
    {"position", &RobotSetup::position, kRequired, kAnyValue, "m", "where it starts"},
    {"velocity", &RobotSetup::velocity, kOptional, kAnyValue, "m/s",
     "at the start; of one with a heading its length counts, along it"},
    {"goal", &RobotSetup::goal, kRequired, kAnyValue, "m", "where it wants to come to rest", "",
     Whose::all, kWants},
    {"radius", &RobotSetup::radius, kOptional, kPositive, "m", "of its disc"},
    {"max_speed", &RobotSetup::max_speed, kOptional, kPositive, "m/s", "never exceeded",
     "2; of a differential drive its wheel_speed"},
    {"max_acceleration", &RobotSetup::max_acceleration, kOptional, kPositive, "m/s^2",
     "never exceeded",
     "1; of a differential drive half of what its wheels can do in any direction"},
    {"preferred_speed", &RobotSetup::preferred_speed, kOptional, kNotNegative, "m/s",
     "towards the goal", "max_speed", Whose::all, kWants},
    {"model", kNested, kOptional, kNoNumber, "", "how it moves",
     "the model of the keys that are present, else holonomic"},
    {"heading", kNested, kOptional, kHeadingField.range, kHeadingField.unit, kHeadingField.doc,
     "0"},
    {"car", kNested, kOptional, kNoNumber, "", "a car's own; its position is its rear axle"},
    {"drive", kNested, kOptional, kNoNumber, "",
     "a differential drive's own; its position is the middle of its axle"},
    {"airplane", kNested, kOptional, kNoNumber, "", "an airplane's own; it cannot stop"},
    {"footprint", kNested, kOptional, kNoNumber, "",
     "its body where that is no disc, of a car or a drive: up to five discs cover it",
     "that of radius, or of car.body"},
    {"priority", &RobotSetup::priority, kOptional, kPositive, "",
     "of a pair, A takes the part p_B/(p_A + p_B) of what both have to do, 1/64 to 63/64 of it"},
    {"max_braking", &RobotSetup::max_braking, kOptional, kPositive, "m/s^2",
     "that it surely brakes with whenever it has to; may be more than max_acceleration",
     "max_acceleration"},
    {"parked", kNested, kOptional, kNoNumber, "", "true is short for behavior: parked", "false"},
    {"layers", &RobotSetup::layers, kOptional, kLayer, "", "that it is in", "", kDeciding},
    {"avoids", &RobotSetup::avoids, kOptional, kLayer, "",
     "it avoids the robots that are in one of these layers", "all of them", kDeciding},
    {"behavior", &RobotSetup::behavior, kOptional, kNoNumber, "",
     "cooperates: it does its share, and the others do not count on it to brake; parked: it never "
     "moves and never decides, a disc that no robot may touch, and its goal is its position"},
    {"time_step", &RobotSetup::time_step, kOptional, kPositive, "s",
     "between its own decisions; only where clock is free", "the scene's", kDeciding},
    {"method", &RobotSetup::method, kOptional, kNoNumber, "",
     "how it chooses its velocities; one of another method than the scene's has what is "
     "customary for its own",
     "the scene's", kDeciding},
    {"time_horizon", &RobotSetup::time_horizon, kOptional, kPositive, "s",
     "tau: how far it looks for collisions",
     "the scene's where it has its method, else what is customary", kDeciding},
    {"arrival_distance", &RobotSetup::arrival_distance, kOptional, kPositive, "m",
     "to its goal: it has arrived once it is that near", "the scene's", kDeciding, kWants},
    {"start_time", &RobotSetup::start_time, kOptional, kNotNegative, "s",
     "until then it stands at its start, and others pass it", "", kDeciding, kWants},
});

}  // namespace avo::inline fields
