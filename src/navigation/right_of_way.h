// SPDX-License-Identifier: Apache-2.0
// Rules at passages: which robots go, which wait and where, which go back, and which lane to keep
// (docs/arrival.md). They give the present heading. Safety never depends on them.
#pragma once
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "avo/vec.h"
#include "navigation/passages.h"

namespace avo::inline navigation {

/// Radii of a passage, from its mouths: the range in which robots claim it.
inline constexpr double kClaimRange = 16.0;

/// A claim of a passage of one lane: the robot will go through it, or is inside already.
struct Claim {
  std::uint32_t passage = 0;
  bool forward = true;  // along the axis
  bool inside = false;
  double distance = 0.0;  // m, from outside to the mouth where it enters
  bool moves = true;      // not at rest; every claimant outside moves
  bool ends = false;      // its goal is inside, too: only the robot itself knows that
};

/// What the rules know of a robot.
struct Claimant {
  Claim claim;
  Vec2 position;  // m
  // bits: it avoids every robot that is in a layer that it avoids
  std::uint32_t layers = 1, avoids = 0xffffffff;
  Vec2 goal = {};          // m, where it shares its goal
  double room = 0.0;       // m, its radius there; 0 where the goal is its own
  std::uint32_t rank = 0;  // for the reports of which robot waits for which
};

/// The claim that others see, if any. Inside, it has the direction in which the robot moves, or at
/// rest the direction from the nearer mouth. Outside, it means that the robot moves towards the
/// mouth.
std::optional<Claim> seen_claim(const Passage& passage, std::uint32_t number, Vec2 position,
                                Vec2 velocity);

/// Where to go instead of farther on the route, if anywhere, and the largest speed.
struct Course {
  std::optional<Vec2> target = {};                             // m
  bool stops = false;                                          // at the target
  double max_speed = std::numeric_limits<double>::infinity();  // m/s
};

/// Decides among all claimants of the same passage that are within the sensing radius and that the
/// robot avoids. A claimant at the robot's place is the robot itself: what others see of it does
/// not count. braking: m/s^2, with which it slows down.
Course right_of_way(const Passage& passage, const Claimant& robot, double braking,
                    std::span<const Claimant> claimants, double sensing_radius);

/// m, from the axis to the middle of the right-hand lane.
double lane_offset(const Passage& passage);

}  // namespace avo::inline navigation
