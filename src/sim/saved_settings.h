// SPDX-License-Identifier: Apache-2.0
// The settings of a scene one by one, for all who treat them alike.
#pragma once
#include "avo/scenario.h"

namespace avo {

/// visit(key, member) for all that a scene has besides robots and obstacles.
template <typename Visit>
void for_each_setting(const Visit& visit) {
  visit("name", &Scenario::name);
  visit("time_step", &Scenario::time_step);
  visit("duration", &Scenario::duration);
  visit("control_time", &Scenario::control_time);
  visit("time_horizon", &Scenario::time_horizon);
  visit("sensing_radius", &Scenario::sensing_radius);
  visit("max_neighbors", &Scenario::max_neighbors);
  visit("method", &Scenario::method);
  visit("certificate", &Scenario::certificate);
  visit("motion", &Scenario::motion);
  visit("samples", &Scenario::samples);
  visit("arrival_distance", &Scenario::arrival_distance);
  visit("seed", &Scenario::seed);
}

/// visit(key, member) for all that a moving obstacle's setup has.
template <typename Visit>
void for_each_obstacle_value(const Visit& visit) {
  visit("position", &MovingObstacle::position);
  visit("velocity", &MovingObstacle::velocity);
  visit("acceleration", &MovingObstacle::acceleration);
  visit("radius", &MovingObstacle::radius);
}

}  // namespace avo
