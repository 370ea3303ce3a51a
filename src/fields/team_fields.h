// SPDX-License-Identifier: Apache-2.0
// The fields of the tasks of teams.
#pragma once
#include "avo/teams.h"
#include "fields/field.h"

namespace avo::inline fields {

template <>
AVO_LOCAL inline constexpr auto kFields<Queue> = std::to_array<Field<Queue>>({
    {"line", &Queue::line, kRequired, kAnyValue, "m", "from the head of the row backward"},
    {"spacing", &Queue::spacing, kOptional, kPositive, "m", "from place to place"},
    {"service", &Queue::service, kOptional, kNotNegative, "s",
     "that the first one waits at the head", "for ever"},
});

template <>
AVO_LOCAL inline constexpr auto kFields<Follow> = std::to_array<Field<Follow>>({
    {"spacing", &Follow::spacing, kOptional, kPositive, "m", "from robot to robot"},
    {"slots", &Follow::slots, kOptional, kAnyValue, "m",
     "places about the first one, x ahead and y to its left", "they follow its trail"},
});

template <>
AVO_LOCAL inline constexpr auto kFields<Patrol> = std::to_array<Field<Patrol>>({
    {"points", &Patrol::points, kRequired, kAnyValue, "m", "to pass in turn"},
    {"pass_distance", &Patrol::pass_distance, kOptional, kPositive, "m",
     "from a point, at which a robot goes on to the next"},
});

template <>
AVO_LOCAL inline constexpr auto kFields<Flow> = std::to_array<Field<Flow>>({
    {"exits", &Flow::exits, kRequired, kAnyValue, "m", "the two ends of each exit"},
    {"spacing", &Flow::spacing, kOptional, kPositive, "m", "between goals on an exit"},
});

}  // namespace avo::inline fields
