// SPDX-License-Identifier: Apache-2.0
// Rules at passages: who goes, who waits and where, who goes back, and which lane to keep
// (docs/arrival.md). They say where to go for now. Safety never depends on them.
#pragma once
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "avo/vec.h"
#include "navigation/passages.h"

namespace avo::inline navigation {

/// Radii of a passage, from its mouths, from which right of way is claimed.
inline constexpr double kClaimRange = 16.0;

/// Of a passage of one lane: to go through it, or that one does so already.
struct Claim {
  std::uint32_t passage = 0;
  bool forward = true;  // along the axis
  bool inside = false;
  double distance = 0.0;  // m, from outside to the mouth where it enters
  bool moves = true;      // not at rest; outside everybody who has a claim does
  bool ends = false;      // its goal is inside, too: known to the robot alone
};

/// What the rules know of a robot.
struct Claimant {
  Claim claim;
  Vec2 position;  // m
  // bits: it minds whoever is in a layer that it avoids
  std::uint32_t layers = 1, avoids = 0xffffffff;
  Vec2 goal = {};          // m, where it shares its goal
  double room = 0.0;       // m, its radius there; 0 where the goal is its own
  std::uint32_t rank = 0;  // of those who tell who waits for whom
};

/// The claim that others see, where there is one: inside the direction in which the robot moves, or
/// at rest the one in which it came from the nearer mouth; outside that it moves towards the mouth.
std::optional<Claim> seen_claim(const Passage& passage, std::uint32_t number, Vec2 position,
                                Vec2 velocity);

/// Where to go instead of farther on the way, if anywhere, and how fast at most.
struct Course {
  std::optional<Vec2> target = {};                             // m
  bool stops = false;                                          // at the target
  double max_speed = std::numeric_limits<double>::infinity();  // m/s
};

/// Among all who claim the same passage, are within the sensing radius and whom the robot avoids.
/// Who is at the robot's place is itself: what others see of it does not count. braking: m/s^2,
/// with which it slows down.
Course right_of_way(const Passage& passage, const Claimant& robot, double braking,
                    std::span<const Claimant> claimants, double sensing_radius);

/// m, from the axis to the middle of the right-hand lane.
double lane_offset(const Passage& passage);

}  // namespace avo::inline navigation
