// SPDX-License-Identifier: Apache-2.0
// From groups to robots: starts, goals and headings.
#pragma once
#include <cstdint>
#include <string>

#include "io/fields/fields.h"
#include "io/scene/random.h"

namespace avo_io {

/// Point k of n on the unit circle, from angle 0 counter-clockwise. Bit for bit the same on every
/// machine, and symmetric: point k + n/2 is the negative of point k where n is even.
avo::Vec2 circle_point(int k, int n);

/// m: of the disc about its position that holds the robot's own, whatever its heading.
double room_of(const avo::RobotSetup& robot);

/// Appends a robot with that start and goal, and the heading of one that has any.
void append_robot(const avo::RobotSetup& model, GroupHeading heading, avo::Vec2 start,
                  avo::Vec2 goal, Random& random, avo::Scenario& scenario);

/// Appends the robots of `group` to the scene; `stream` (its place in the list) makes its random
/// numbers its own. Returns an empty text, or what could not be done; then the scene is not usable.
std::string append_group(const Group& group, std::uint64_t stream, avo::Scenario& scenario);

}  // namespace avo_io
