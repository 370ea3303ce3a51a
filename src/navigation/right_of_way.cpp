// SPDX-License-Identifier: Apache-2.0
#include "navigation/right_of_way.h"

#include <cmath>

#include "navigation/rules/passage_rules.h"

namespace avo::inline navigation {
namespace {

// radii of the passage a second: a slower robot is at rest
constexpr double kMoves = 0.2;
constexpr double kTowards = 0.5;    // cosine: a robot that moves more across does not come
constexpr double kOverlaps = 1e-6;  // of contact, for crowds in contact

// Returns whether two robots with shared goals overlap. Walls may have squeezed them together.
bool some_overlap(std::span<const Claimant> claimants) {
  for (std::size_t k = 0; k < claimants.size(); ++k) {
    const Claimant& a = claimants[k];
    for (const Claimant& b : claimants.first(a.room > 0.0 ? k : 0)) {
      const double contact = (1.0 - kOverlaps) * (a.room + b.room);
      if (b.room > 0.0 && norm_squared(b.position - a.position) < contact * contact) return true;
    }
  }
  return false;
}

}  // namespace

std::optional<Claim> seen_claim(const Passage& passage, std::uint32_t number, Vec2 position,
                                Vec2 velocity) {
  const double least = kMoves * passage.radius;
  const PassagePlace place = place_in(passage, position);
  if (is_inside(passage, place)) {
    const double speed = dot(velocity, axis_point(passage, true, place.along).direction);
    const bool came_from_first = place.along < 0.5 * passage.length();
    const bool moves = std::abs(speed) > least;
    return Claim{number, moves ? speed > 0.0 : came_from_first, true, 0.0, moves};
  }
  const Vec2 front = passage.axis.front(), back = passage.axis.back();
  const bool is_first_near = norm_squared(position - front) < norm_squared(position - back);
  const Vec2 to_mouth = (is_first_near ? front : back) - position;
  const double towards = dot(velocity, to_mouth), range = kClaimRange * passage.radius;
  if (!(towards > 0.0) || norm_squared(to_mouth) > range * range) return {};
  const double distance = norm(to_mouth);
  if (!(towards > distance * std::max(least, kTowards * norm(velocity)))) return {};
  return Claim{number, is_first_near, false, distance};
}

Course right_of_way(const Passage& passage, const Claimant& one, double braking,
                    std::span<const Claimant> claimants, double sensing_radius) {
  Claimant robot = one;
  // the overlapping robots must part first
  if (robot.room > 0.0 && some_overlap(claimants)) robot.room = 0.0;
  if (robot.claim.inside && robot.claim.ends)
    return make_room(passage, robot, claimants, sensing_radius);
  if (robot.claim.inside) return go_on_or_back(passage, robot, claimants, sensing_radius);
  if (may_enter(passage, robot, claimants, sensing_radius)) return {};
  return wait_beside(passage, robot, braking);
}

}  // namespace avo::inline navigation
