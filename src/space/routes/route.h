// SPDX-License-Identifier: Apache-2.0
// A robot's progress on its route.
#pragma once
#include <cstdint>
#include <vector>

#include "avo/decision_trace.h"
#include "avo/space/robot.h"
#include "space/routes/search.h"

namespace avo::space {

/// What a robot remembers of its route from step to step.
struct SpaceRoute {
  Vec3 goal;                            ///< m, for which it was found
  std::vector<SpaceRoutePoint> points;  ///< still to come; empty: no route is known
  std::vector<SpaceRoutePoint>
      passed;                ///< bends behind the robot, to which others may push it back
  bool is_moved = false;     ///< the next point has moved on from the last bend of `passed`
  bool reaches = true;       ///< whether it ends at the goal
  double left = 0.0;         ///< m, from its end to the goal
  bool is_in_box = false;    ///< whether the goal is nearer to a box than the radius
  bool is_searched = false;  ///< for this goal and these boxes
  double yielded = 0.0;      ///< s, for which it has let others enter a passage before it
  int rests = 0;             ///< steps until it may be searched again
};

/// Where a robot heads for, as far off as the end along the route, and its speed at most.
struct SpaceHeading {
  Vec3 goal;           ///< m
  double speed = 0.0;  ///< m/s
  double left = 0.0;   ///< m, of the route
  Guide guide = Guide::route;
};

/// Leaves so many points behind.
void pass(SpaceRoute& route, std::size_t count);

/// Leaves out the points that the robot sees past, and moves the next one on along its leg as far
/// as the robot sees. Where it has lost sight of the route, it goes back by a few bends. Returns
/// whether it sees the next point.
bool advance(const Solids& solids, Vec3 position, double radius, SpaceRoute& route);

/// The heading on a route with a next point that the robot sees.
SpaceHeading heading_on(const Robot& robot, double preferred_speed, const SpaceRoute& route);

}  // namespace avo::space
