// SPDX-License-Identifier: Apache-2.0
// The place where a robot comes to rest if others stand on its goal, or have it as well. It follows
// from what the robot sees of them, as in the plane (docs/arrival.md, rule 4), with balls for
// discs.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "avo/space/box.h"
#include "avo/space/robot.h"

namespace avo::space {

/// A robot that comes to its goal. Lengths in m.
struct SpaceSeeker {
  Vec3 position, goal;
  double radius = 0.0, max_speed = 0.0;  // m, m/s
  double downwash = 0.0;
  double range = 0.0;       ///< in which it considers others
  bool is_content = false;  ///< it stays as soon as robots at rest lead from it to its goal
  bool has_stood = false;   ///< it has come to rest at such a place
  bool is_at_rest = false;
  bool is_near = false;  ///< within the arrival distance of a goal that others have as well
};

/// Another robot that is nearly at rest.
struct SpaceResting {
  Vec3 position;                   ///< m
  double reach = 0.0;              ///< m, from its center to the seeker's, in contact
  double from_goal_squared = 0.0;  ///< m², of the seeker, from its downwash
  double downwash = 0.0;           ///< m
};

/// What a seeker sees of others. Allocates only while it grows.
struct SpaceOccupied {
  std::vector<SpaceResting> resting;
  std::vector<std::uint32_t> worth;  ///< scratch memory
  bool is_near = false;              ///< one of them is near the seeker
  bool is_on_goal = false;           ///< one of them stands on the goal
  bool comes_out = false;            ///< a robot beside the seeker comes from the goal

  [[nodiscard]] bool is_taken() const { return is_near && is_on_goal; }
};

/// Sets what the seeker sees, whatever the order of the neighbors.
void look_at_goal(const SpaceSeeker& seeker, std::span<const Neighbor> neighbors,
                  SpaceOccupied& seen);

/// m: a free place that is nearer to the goal, to which a straight line leads. Where there is none,
/// it is the seeker's own position.
Vec3 place_near(const SpaceSeeker& seeker, SpaceOccupied& occupied, std::span<const Box> boxes);

/// What a robot does that has its goal in sight.
struct SpaceAtSharedGoal {
  bool has_place = false;  ///< it heads for `place`, else for its goal
  Vec3 place;              ///< m; its own position: it stays
  bool is_taken = false;   ///< see Detour::goal_taken
  bool has_stood = false;  ///< the new value of SpaceSeeker::has_stood
};
SpaceAtSharedGoal at_shared_goal(const SpaceSeeker& seeker, std::span<const Box> boxes,
                                 SpaceOccupied& occupied);

}  // namespace avo::space
