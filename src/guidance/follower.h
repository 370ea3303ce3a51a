// SPDX-License-Identifier: Apache-2.0
// Where a robot on its route goes next: along it, through passages in turn, around passages that
// are held, or back out of a jam.
#pragma once
#include "guidance/claims.h"
#include "guidance/routes.h"
#include "guidance/travel.h"

namespace avo::inline guidance {

/// A robot that follows its route.
struct Follower {
  Vec2 place = {};   // m, of its disc, where the robot takes itself to be
  Claimant as_seen;  // the robot as others see it, without its claim
  RobotTraits traits;
  Vec2 end = {};              // m, of its route
  double own_path = 0.0;      // m, see own_path_of()
  double nearest = 0.0;       // m, distance of the nearest other that it senses; infinity: none
  float detour = 0.0F;        // rad, see Detour::angle
  bool looks_around = false;  // see looks_around()
  bool rests = false;         // it has come to rest at its goal, or as near as there was room
};

/// The heading by the robot's route alone; then by all rules among walls.
struct Headings {
  Heading by_route;  // `yields` is by all rules
  Heading heading;
};

/// time_step: s, until its next decision. sensing_radius: m, from which it knows claims of others.
Headings guide(const Routes& routes, const Claims& claims, const Follower& robot, double time_step,
               double sensing_radius, Travel& travel, LegScratch& scratch);

}  // namespace avo::inline guidance
