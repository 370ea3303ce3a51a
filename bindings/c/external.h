// SPDX-License-Identifier: Apache-2.0
// External methods that are functions of C.
#pragma once
#include <cstdint>
#include <string>

#include "avo/error.h"
#include "avo/external_method.h"
#include "layouts.h"

namespace avo_c {

inline const avo_vec2* lent(std::span<const avo::Vec2> values) {
  return reinterpret_cast<const avo_vec2*>(values.data());
}

/// The batch as C knows it. It points to the columns.
inline avo_method_batch batch_of(const avo::MethodBatch& batch, const avo::MethodColumns& columns) {
  return {.size = sizeof(avo_method_batch),
          .time = batch.time,
          .time_step = batch.time_step,
          .robot_count = batch.size(),
          .id = reinterpret_cast<const avo_robot_id*>(columns.id.data()),
          .position = lent(columns.position),
          .velocity = lent(columns.velocity),
          .preferred_velocity = lent(columns.preferred_velocity),
          .goal = lent(batch.goal),
          .radius = columns.radius.data(),
          .max_speed = columns.max_speed.data(),
          .max_acceleration = columns.max_acceleration.data(),
          .max_braking = columns.max_braking.data(),
          .heading = columns.heading.data(),
          .first_neighbor = batch.first_neighbor.data(),
          .first_wall = batch.first_wall.data(),
          .neighbor_count = batch.neighbor.size(),
          .neighbor_position = lent(columns.neighbor_position),
          .neighbor_velocity = lent(columns.neighbor_velocity),
          .neighbor_radius = columns.neighbor_radius.data(),
          .neighbor_max_acceleration = columns.neighbor_max_acceleration.data(),
          .neighbor_behavior = columns.neighbor_behavior.data(),
          .wall_count = batch.wall.size(),
          .wall = reinterpret_cast<const avo_wall*>(batch.wall.data())};
}

/// None where the function is null.
inline avo::ExternalMethod external_of(avo_external_method* function, void* context) {
  if (function == nullptr) return {};
  return [function, context](const avo::MethodBatch& batch, std::span<avo::Vec2> velocities) {
    avo::MethodColumns columns;
    columns.take(batch);
    for (std::uint64_t& id : columns.id) ++id;  // in C they begin with 1
    const avo_method_batch known = batch_of(batch, columns);
    const std::int32_t result =
        function(context, &known, reinterpret_cast<avo_vec2*>(velocities.data()));
    if (result != 0)
      throw avo::Error("external method: found the result " + std::to_string(result) +
                       ", must be 0");
  };
}

}  // namespace avo_c
