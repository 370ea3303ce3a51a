// SPDX-License-Identifier: Apache-2.0
#include "certificate/near_pairs.h"

#include <algorithm>

#include "robots/footprint.h"
#include "robots/model.h"

namespace avo::inline certificate {

void BrakingColumns::reserve(std::size_t robots) {
  if (far_reach[2].size() >= robots + kSpareNeighbors) return;  // this column grows last
  for (Column* column :
       {&speed,          &decrement,    &increment,      &full_steps,     &direction_x,
        &direction_y,    &length,       &stray_velocity, &stray_distance, &reach,
        &intervals,      &ahead_start,  &ahead_slope,    &across_start,   &across_slope,
        &anyhow_start,   &anyhow_slope, &fast_speed,     &fast_steps,     &slow_speed,
        &slow_steps,     &most_ahead,   &most_aside,     &far_distance,   &far_speed_squared,
        &clear_distance, &next_ahead,   &next_aside,     &per_decrement,  &far_reach[0],
        &far_reach[1],   &far_reach[2]}) {
    column->resize(robots + kSpareNeighbors, 1.0);
  }
}

void BrakingColumns::take_strays(const RobotColumns& robots, const StepLaw& law) {
  has_discs.clear();
  if (!robots.has_models) {
    std::fill_n(stray_velocity.begin(), robots.count, 0.0);
    std::fill_n(stray_distance.begin(), robots.count, 0.0);
    return;
  }
  has_discs.resize(robots.count);
  for (std::size_t i = 0; i < robots.count; ++i) {
    Stray stray;
    if (robots.model[i] != nullptr) {
      stray = stray_of(*robots.model[i], robots.max_acceleration[i], law.time_step);
      has_discs[i] = has_footprint(*robots.model[i]) ? 1 : 0;
    }
    stray_velocity[i] = stray.velocity, stray_distance[i] = stray.distance;
  }
}

Braking BrakingColumns::braking(std::size_t i) const {
  return {.profile = {.speed = speed[i], .decrement = decrement[i], .full_steps = full_steps[i]},
          .increment = increment[i],
          .direction = {direction_x[i], direction_y[i]},
          .length = length[i],
          .reach = reach[i],
          .intervals = intervals[i]};
}

Deviation BrakingColumns::deviation(std::size_t i) const {
  return {.ahead = {.start = ahead_start[i], .per_distance = ahead_slope[i]},
          .across = {.start = across_start[i], .per_distance = across_slope[i]},
          .anyhow = {.start = anyhow_start[i], .per_distance = anyhow_slope[i]},
          .fast = {.speed = fast_speed[i], .decrement = decrement[i], .full_steps = fast_steps[i]},
          .slow = {.speed = slow_speed[i], .decrement = decrement[i], .full_steps = slow_steps[i]},
          .most_ahead = most_ahead[i],
          .most_aside = most_aside[i]};
}

}  // namespace avo::inline certificate
