// SPDX-License-Identifier: Apache-2.0
#include "guidance/claims.h"

#include <algorithm>

#include "guidance/follower.h"

namespace avo::inline guidance {
namespace {

constexpr double kLeavesLane = 1.0;  // rad: a robot that has turned off by more is in a jam

// A point as far off as the rest of the route, so that no robot brakes for the place, unless it
// must stop.
Vec2 beyond(Vec2 p, Vec2 target, double rest) {
  const Vec2 to_target = target - p;
  const double distance = norm(to_target);
  return distance > 0.0 && rest > distance ? p + (rest / distance) * to_target : target;
}

// The robot's own prospect; its route must be known.
Prospect prospect_of(const Routes& routes, const Follower& robot, const Travel& travel) {
  return look_ahead(routes.passages, *travel.graph, *travel.map, robot.as_seen.position,
                    travel.target, reach_of(robot.traits));
}

Claimant claimant_of(const Follower& robot, const Claim& claim) {
  Claimant claimant = robot.as_seen;
  claimant.claim = claim;
  return claimant;
}

// A robot inside comes before a robot outside. Then a robot in the opposite direction comes before
// one in the same direction, and then the nearer one first.
bool is_waited_for_first(const Claimant& robot, const Claimant& a, const Claimant& b) {
  if (a.claim.inside != b.claim.inside) return a.claim.inside;
  const bool a_comes = a.claim.forward != robot.claim.forward;
  const bool b_comes = b.claim.forward != robot.claim.forward;
  if (a_comes != b_comes) return a_comes;
  return norm_squared(a.position - robot.position) < norm_squared(b.position - robot.position);
}

}  // namespace

void append_claims(const Routes& routes, Claimant robot, Vec2 velocity,
                   std::vector<Claimant>& claimants) {
  routes.passages.for_each_watched(robot.position, [&](std::uint32_t number) {
    const Passage& passage = routes.passages[number];
    const auto claim = seen_claim(passage, number, robot.position, velocity);
    if (!claim) return;
    const Vec2 mouth = axis_point(passage, claim->forward, 0.0).point;
    if (!claim->inside && !routes.is_in_sight(robot.position, mouth)) return;
    robot.claim = *claim;
    claimants.push_back(robot);
  });
}

void order_claims(std::size_t passages, std::size_t parts, Claims& claims) {
  std::vector<std::uint32_t>& first = claims.first;
  first.assign(passages + 1, 0);
  const auto for_each = [&](const auto& visit) {
    for (std::size_t part = 0; part < parts; ++part) {
      for (const Claimant& claimant : claims.parts[part]) visit(claimant);
    }
  };
  for_each([&](const Claimant& claimant) { ++first[claimant.claim.passage + 1]; });
  for (std::size_t k = 1; k < first.size(); ++k) first[k] += first[k - 1];
  claims.claimants.resize(first.back());
  // each `first` becomes that of the next passage, and then its own again
  for_each([&](const Claimant& claimant) {
    claims.claimants[first[claimant.claim.passage]++] = claimant;
  });
  std::copy_backward(first.begin(), first.end() - 1, first.end());
  first[0] = 0;
}

Heading heed_passages(const Routes& routes, const Claims& claims, const Follower& robot,
                      const Travel& travel, const Heading& heading, double sensing_radius) {
  if (!travel.is_known()) return heading;
  const Vec2 p = robot.as_seen.position;
  const auto [claim, lane] = prospect_of(routes, robot, travel);
  const double rest = norm(heading.goal - p);
  Heading heeding = heading;
  const bool in_company = is_in_company(robot.traits.radius, robot.nearest);
  if (lane && in_company && robot.detour <= kLeavesLane)
    heeding.goal = beyond(p, *lane, rest), heeding.next = *lane, heeding.guide = Guide::lane;
  if (!claim) return heeding;
  const Course course =
      right_of_way(routes.passages[claim->passage], claimant_of(robot, *claim),
                   planned_braking(robot.traits), claims.of(claim->passage), sensing_radius);
  heeding.yields = course.target || course.max_speed < heeding.preferred_speed;
  if (heeding.yields) heeding.guide = Guide::passage;
  heeding.preferred_speed = std::min(heeding.preferred_speed, course.max_speed);
  if (!course.target) return heeding;
  heeding.goal = course.stops ? *course.target : beyond(p, *course.target, rest);
  heeding.next = *course.target;
  return heeding;
}

std::optional<Simulation::Wait> wait_of(const Routes& routes, const Claims& claims,
                                        const Follower& follower, const Travel& travel,
                                        double sensing_radius) {
  if (!travel.is_known()) return std::nullopt;
  const auto claim = prospect_of(routes, follower, travel).claim;
  if (!claim) return std::nullopt;
  const Passage& passage = routes.passages[claim->passage];
  const Claimant robot = claimant_of(follower, *claim);
  const std::span<const Claimant> claimants = claims.of(claim->passage);
  const Course course =
      right_of_way(passage, robot, planned_braking(follower.traits), claimants, sensing_radius);
  if (!course.target && course.max_speed >= follower.traits.preferred_speed) return std::nullopt;
  const Claimant* first = nullptr;
  for (const Claimant& other : claimants) {
    const bool is_seen = norm(other.position - robot.position) <= sensing_radius;
    if (other.rank == robot.rank || (robot.avoids & other.layers) == 0 || !is_seen) continue;
    if (first == nullptr || is_waited_for_first(robot, other, *first)) first = &other;
  }
  if (first == nullptr) return std::nullopt;
  const Segment gap = routes.passages.narrowest_gap(claim->passage);
  return Simulation::Wait{.passage = axis_point(passage, true, 0.5 * passage.length()).point,
                          .robot = {first->rank},
                          .inside = first->claim.inside,
                          .a = gap.a,
                          .b = gap.b};
}

}  // namespace avo::inline guidance
