// SPDX-License-Identifier: Apache-2.0
// Robots at rest around a goal, in the plane and in space (docs/arrival.md, rule 4).
#pragma once
#include <algorithm>
#include <cmath>

namespace avo::inline guidance {

// radii: a seeker within this distance is near the robots at rest
inline constexpr double kNearResting = 8.0;
// of contact: others within this distance are beside it
inline constexpr double kBesideReach = 1.25;
inline constexpr double kStill = 0.2;        // of v_max: slower robots rest, or soon will
inline constexpr double kComesOut = 0.004;   // of v_max, away from the goal
inline constexpr double kPlaceGap = 0.02;    // of contact, between a place and those at rest
inline constexpr double kLineGap = 0.01;     // of contact, for the line to the place
inline constexpr double kRoundedOff = 1e-9;  // places touch circles, and lines begin in contact

// of the distance to a place: it must be nearer to the goal by that
inline constexpr double kWorth = 0.25;
inline constexpr double kGain = 0.1;        // radii: and by so much in addition,
inline constexpr double kGainAtRest = 0.8;  // or by so much for a robot that has come to rest

/// Returns whether a robot at rest stands so near the seeker's goal that both could not be there.
template <typename Resting>
bool stands_on_goal(const Resting& other) {
  const double most = (1.0 + kRoundedOff) * other.reach;  // most are decided without a root
  return other.from_goal_squared < most * most && std::sqrt(other.from_goal_squared) < other.reach;
}

/// Returns whether robots at rest lead from the seeker to a robot that stands on its goal.
/// For a robot, starts(next) tells whether the seeker does not fit through between the two.
/// leads(one) gives the same test for a robot at rest. The examined robots are moved to the front.
template <typename Iterator, typename Starts, typename Leads>
bool leads_to_goal(Iterator first, Iterator last, const Starts& starts, const Leads& leads) {
  auto reached = std::partition(first, last, starts);
  const auto is_nearer = [](const auto& one, const auto& other) {
    return one.from_goal_squared < other.from_goal_squared;
  };
  for (auto one = first; one != reached; ++one) {  // towards the goal first
    std::iter_swap(one, std::min_element(one, reached, is_nearer));
    if (stands_on_goal(*one)) return true;
    reached = std::partition(reached, last, leads(*one));
  }
  return false;
}

}  // namespace avo::inline guidance
