// SPDX-License-Identifier: Apache-2.0
// What is near a place, or in sight of it.
#include "layouts.h"
#include "simulations.h"

using namespace avo_c;  // NOLINT(google-build-using-namespace): what follows is C

avo_result avo_simulation_robots_within(avo_simulation_id simulation, avo_vec2 center,
                                        double radius, avo_robot_id* buffer, size_t capacity,
                                        size_t* count) {
  return guarded([&] {
    const avo::Simulation& own = simulations.at(simulation).simulation;
    list(own.robots_within(from_c(center), radius), buffer, capacity, count);
  });
}

avo_result avo_simulation_nearest_robots(avo_simulation_id simulation, avo_vec2 position,
                                         avo_robot_id* buffer, size_t capacity, size_t* count) {
  return guarded([&] {
    const avo::Simulation& own = simulations.at(simulation).simulation;
    list(own.nearest_robots(from_c(position), capacity), buffer, capacity, count);
  });
}

avo_result avo_simulation_is_free(avo_simulation_id simulation, avo_vec2 position, double radius,
                                  uint32_t layers, bool* is_free) {
  return get(simulation, is_free, [&](const avo::Simulation& own) {
    return own.is_free(from_c(position), radius, {layers});
  });
}

avo_result avo_simulation_cast_ray(avo_simulation_id simulation, avo_vec2 from, avo_vec2 to,
                                   double radius, uint32_t layers, avo_hit* hit) {
  return get(simulation, hit, [&](const avo::Simulation& own) {
    const auto number = [](const auto& id) { return id ? id->value + 1 : 0; };
    const auto found = own.cast_ray(from_c(from), from_c(to), radius, {layers});
    if (!found) return avo_hit{norm(from_c(to) - from_c(from)), to, {0}, {0}, {0}};
    return avo_hit{found->distance,
                   to_c(found->center),
                   {number(found->robot)},
                   {number(found->moving_obstacle)},
                   {number(found->obstacle)}};
  });
}

avo_result avo_simulation_is_in_sight(avo_simulation_id simulation, avo_vec2 from, avo_vec2 to,
                                      double radius, uint32_t layers, bool* is_in_sight) {
  return get(simulation, is_in_sight, [&](const avo::Simulation& own) {
    return own.is_in_sight(from_c(from), from_c(to), radius, {layers});
  });
}
