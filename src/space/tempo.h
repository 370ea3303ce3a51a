// SPDX-License-Identifier: Apache-2.0
// What the limits of a robot make of the rules of one planner. It is the same in every step.
#pragma once
#include "avo/space/robot.h"
#include "planner/stages/execution.h"

namespace avo::space {

/// The values of a planner that landings depend on.
struct Landing {
  ResponseLaw law;
  double lag = 0.05;          ///< s, see StepLaw
  double braking_time = 0.1;  ///< s, see StepLaw
};

struct Tempo {
  Haste haste;           ///< far from the goal
  double there;          ///< m: nearer to its goal, changes of its acceleration have no limit
  double landing;        ///< m: nearer to its goal, see is_landing()
  double unhurried;      ///< see unhurried_part()
  double traffic_range;  ///< m: others ahead within it are traffic
  double time_to_speed;  ///< [T] s
  double used_braking;   ///< m/s², in the robot's own space, where it lands
  double response_time;  ///< s, where it lands
};

Tempo tempo_of(const Robot& robot, const Landing& planner);

/// The haste at that distance from the goal, m. remembers: see Execution.
Haste haste_at(const Tempo& tempo, double distance_to_goal, bool remembers);

}  // namespace avo::space
