// SPDX-License-Identifier: Apache-2.0
// The place where a robot comes to rest if others stand on its goal (docs/arrival.md, rule 4), from
// what the robot sees of them.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "avo/planner.h"
#include "avo/wall.h"
#include "core/neighbor_columns.h"

namespace avo::inline guidance {

class Routes;

/// A robot that searches for its place.
struct Seeker {
  Vec2 position, goal;  // m, of its disc
  // m, next point of its route: the goal itself, or a corner before it
  Vec2 next = {};
  Vec2 beyond = {};                      // m, past that, as far off as the goal is along the route
  double radius = 0.0, max_speed = 0.0;  // m, m/s
  double range = 0.0;                    // m: the range in which it surely sees others
  bool steers = false;                   // it has wheels: it cannot reach every place beside it
  bool yields = false;                   // to others at a passage
  bool has_stood = false;                // it has come to rest at such a place
  bool is_at_rest = false;
  bool is_near = false;  // within the arrival distance of a goal that others have as well
};

/// Another robot that is nearly at rest.
struct Resting {
  Vec2 position;                   // m
  double reach = 0.0;              // m, from its center to the seeker's, in contact
  double from_goal_squared = 0.0;  // m², of the seeker
  double from_next_squared = 0.0;  // m², from the seeker's next point
};

/// What a seeker sees of others: call add() for them.
struct Occupied {
  std::vector<Resting> resting;
  mutable std::vector<std::uint32_t> worth;  // scratch memory of place_near()
  bool is_near = false;                      // one of them is near the seeker
  bool is_on_goal = false;                   // one of them stands on the goal
  bool comes_out = false;                    // a robot beside the seeker comes from the goal
  bool has_movers = false;  // some do not decide, so that the seeker may have to evade them

  void clear() { resting.clear(), is_near = is_on_goal = comes_out = has_movers = false; }
  void add(const Seeker& seeker, const Neighbor& neighbor);
  void add(const Seeker& seeker, const Neighbors& neighbors);
};

/// Returns whether another is seen to stand on the goal, from nearby.
inline bool is_taken(const Occupied& occupied) {
  return occupied.is_near && occupied.is_on_goal;
}

/// The next point of its route, where the goal is not taken. Otherwise a free place that is nearer
/// to that point and that a straight line leads to. Where there is none, it is the seeker's own
/// position: the seeker is at its place.
Vec2 place_near(const Seeker& seeker, const Occupied& occupied, std::span<const Wall> walls);

/// Returns whether the robots at rest lead from the seeker to its goal, and one stands there. The
/// seeker then fits through between none of them and the next. It moves the examined ones to the
/// front. `routes`: the walls of these routes separate robots, if any.
bool is_at_crowd(const Seeker& seeker, Occupied& occupied, const Routes* routes = nullptr);

/// Where the seeker moves to. stays: to its present place. Sets Detour::goal_taken, except if a
/// robot comes out from among the robots at rest.
Vec2 place_of(const Seeker& seeker, const Occupied& occupied, std::span<const Wall> walls,
              bool stays, Detour& detour);

}  // namespace avo::inline guidance
