// SPDX-License-Identifier: Apache-2.0
// Creates the robots of groups: starts, goals and headings.
#pragma once
#include <cstdint>
#include <string>

#include "io/fields/fields.h"
#include "io/scene/random.h"

namespace avo_io {

/// Returns the radius, m, of the disc about the robot's position that contains its own disc,
/// whatever its heading.
double room_of(const avo::RobotSetup& robot);

/// Appends a robot with that start and goal, and with the heading if its model has one.
void append_robot(const avo::RobotSetup& model, GroupHeading heading, avo::Vec2 start,
                  avo::Vec2 goal, Random& random, avo::Scenario& scenario);

/// Appends the robots of `group` to the scene. `stream` (the group's place in the list) selects its
/// own random numbers. Returns an empty text, or a text about what failed; then the scene is not
/// usable.
std::string append_group(const Group& group, std::uint64_t stream, avo::Scenario& scenario);

}  // namespace avo_io
