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

namespace avo {

/// One that looks for its place.
struct Seeker {
  Vec2 position, goal;                   // m, of its disc
  double radius = 0.0, max_speed = 0.0;  // m, m/s
  double range = 0.0;                    // m: at least so far it sees others
  bool has_stood = false;                // it has come to rest at such a place
};

/// Another robot that is nearly at rest.
struct Resting {
  Vec2 position;                   // m
  double reach = 0.0;              // m, from its center to the seeker's, in contact
  double from_goal_squared = 0.0;  // m², of the seeker
};

/// What a seeker sees of others: add() them.
struct Occupied {
  std::vector<Resting> resting;
  mutable std::vector<std::uint32_t> worth;  // scratch memory of place_near()
  bool is_near = false;                      // one of them is near the seeker
  bool comes_out = false;                    // one beside the seeker comes from the goal
  bool has_movers = false;  // some do not decide, so that the seeker may have to evade them

  void clear() { resting.clear(), is_near = comes_out = has_movers = false; }
  void add(const Seeker& seeker, const Neighbor& neighbor);
  void add(const Seeker& seeker, const Neighbors& neighbors);
};

/// The goal, where nobody stands on it. Else a free place that is nearer to the goal
/// and that a straight way leads to, or the seeker's own position where there is none: it is at its
/// place.
Vec2 place_near(const Seeker& seeker, const Occupied& occupied, std::span<const Wall> walls);

/// Whether those at rest lead from the seeker to its goal, and one stands there: it gets through
/// between none of them and the next. Puts those first that it has looked at.
bool is_at_crowd(const Seeker& seeker, Occupied& occupied);

/// Where the seeker heads for: stays: to where it is. Sets Detour::goal_taken: whoever comes out
/// from among those at rest has the way.
Vec2 place_of(const Seeker& seeker, const Occupied& occupied, std::span<const Wall> walls,
              bool stays, Detour& detour);

}  // namespace avo
