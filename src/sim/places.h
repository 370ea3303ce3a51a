// SPDX-License-Identifier: Apache-2.0
// Where a robot comes to rest whose goal others stand on (docs/arrival.md, rule 4): by what it sees
// of them.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "avo/planner.h"
#include "avo/wall.h"
#include "core/neighbor_columns.h"

namespace avo::inline sim {

class Ways;

/// One that looks for its place.
struct Seeker {
  Vec2 position, goal;                   // m, of its disc
  Vec2 next = {};                        // m, of its way: the goal itself, or a corner before it
  Vec2 beyond = {};                      // m, past that, as far off as the goal is by way
  double radius = 0.0, max_speed = 0.0;  // m, m/s
  double range = 0.0;                    // m: at least so far it sees others
  bool steers = false;                   // it has wheels: not every place beside it can be reached
  bool yields = false;                   // to others at a passage
  bool has_stood = false;                // it has come to rest at such a place
};

/// Another robot that is nearly at rest.
struct Resting {
  Vec2 position;                   // m
  double reach = 0.0;              // m, from its center to the seeker's, in contact
  double from_goal_squared = 0.0;  // m², of the seeker
  double from_next_squared = 0.0;  // m², likewise
};

/// What a seeker sees of others: add() them.
struct Occupied {
  std::vector<Resting> resting;
  mutable std::vector<std::uint32_t> worth;  // scratch memory of place_near()
  bool is_near = false;                      // one of them is near the seeker
  bool is_on_goal = false;                   // one of them stands there
  bool comes_out = false;                    // one beside the seeker comes from the goal
  bool has_movers = false;  // some do not decide, so that the seeker may have to evade them

  void clear() { resting.clear(), is_near = is_on_goal = comes_out = has_movers = false; }
  void add(const Seeker& seeker, const Neighbor& neighbor);
  void add(const Seeker& seeker, const Neighbors& neighbors);
};

/// Whether somebody is seen to stand on the goal, from nearby.
inline bool is_taken(const Occupied& occupied) {
  return occupied.is_near && occupied.is_on_goal;
}

/// What is next on its way, where the goal is not taken. Else a free place that is nearer to that
/// and that a straight way leads to, or the seeker's own position where there is none: it is at its
/// place.
Vec2 place_near(const Seeker& seeker, const Occupied& occupied, std::span<const Wall> walls);

/// Whether those at rest lead from the seeker to its goal, and one stands there: it gets through
/// between none of them and the next. Puts those first that it has looked at. ways: whose walls
/// part them, if any.
bool is_at_crowd(const Seeker& seeker, Occupied& occupied, const Ways* ways = nullptr);

/// Where the seeker heads for: stays: to where it is. Sets Detour::goal_taken: whoever comes out
/// from among those at rest has the way.
Vec2 place_of(const Seeker& seeker, const Occupied& occupied, std::span<const Wall> walls,
              bool stays, Detour& detour);

}  // namespace avo::inline sim
