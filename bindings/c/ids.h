// SPDX-License-Identifier: Apache-2.0
// Ids of robots and obstacles: in C they begin with 1, and 0 is a null id.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "avo/ids.h"
#include "avo_c/avo.h"
#include "errors.h"

namespace avo_c {

inline avo::RobotId from_c(avo_robot_id robot) {
  return {robot.value - 1};
}
inline avo_robot_id to_c(avo::RobotId robot) {
  return {robot.value + 1};
}

[[noreturn]] inline void fail_absent(avo_robot_id robot) {
  fail(AVO_ERROR_INVALID_ID, "robot: found " +
                                 (robot.value == 0 ? "a null id" : std::to_string(robot.value)) +
                                 ", must be the id of one that is there");
}

/// The id of an obstacle among those that are there.
template <typename Id>
Id among(std::span<const Id> ids, std::uint64_t number) {
  for (const Id id : ids)
    if (id.value + 1 == number) return id;
  fail(AVO_ERROR_INVALID_ID,
       "obstacle: found " + std::to_string(number) + ", must be the id of one that is there");
}

/// Writes the ids into the buffer, if they fit.
template <typename Id, typename Ids>
void list(const Ids& ids, Id* buffer, std::size_t capacity, std::size_t* count) {
  at(count, "count") = ids.size();
  if (buffer == nullptr) return;
  require_room(capacity, ids.size());
  for (const auto id : ids) *buffer++ = Id{id.value + 1};
}

}  // namespace avo_c
