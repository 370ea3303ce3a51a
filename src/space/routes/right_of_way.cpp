// SPDX-License-Identifier: Apache-2.0
#include "space/routes/right_of_way.h"

#include <algorithm>
#include <cmath>

#include "guidance/claims.h"

namespace avo::space {
namespace {

// in radii of the robot, as in the plane (src/navigation/prospect.cpp)
constexpr double kFarthestPassage = 24.0;
constexpr double kAhead = 3.0;
constexpr double kAlong = 0.5;        // cosine: a route that leads more across keeps no lane
constexpr double kRoom = 1.0 - 1e-3;  // of the radius, that the entrance of a lane needs
constexpr double kGate = 1.3;         // radii of the passage, from the mouth to the faces
constexpr double kEntrance =
    2.5;  // radii of the passage, from there: the place of a robot in the entrance
constexpr double kBeside = 1.1;                  // of contact
constexpr double kPatience = 8.0;                // s
constexpr double kBack = 1.0, kBackAside = 1.5;  // radii: where the second robot goes meanwhile
constexpr double kBesideFaces = 1.1;  // radii, that a robot in a lane keeps from the faces

// Calls visit(from, to, before) for the pieces of the route until it returns false, or the route
// has become longer than `farthest` m.
template <typename Visit>
void walk(const SpaceClaimer& robot, double farthest, const Visit& visit) {
  Vec3 from = robot.position;
  double before = 0.0;
  for (const SpaceRoutePoint& point : robot.route) {
    if (before > farthest || !visit(from, point.place, before)) return;
    before += norm(point.place - from), from = point.place;
  }
}

// The direction in which the route leaves the passage that it begins in.
Claim claim_inside(const SpacePassage& passage, std::uint32_t number, const SpaceClaimer& robot) {
  const double along = passage.place(robot.position).along;
  Claim claim{.passage = number, .forward = true, .inside = true, .ends = true};
  double end = along;
  walk(robot, Bounds::kFar, [&](Vec3, Vec3 to, double) {
    end = passage.place(to).along;
    claim.ends = passage.contains(to);
    return claim.ends;
  });
  claim.forward = end > (claim.ends ? along : 0.5 * passage.length());
  return claim;
}

std::optional<Claim> claim_of(const SpacePassages& passages, const SpaceClaimer& robot) {
  if (const auto inside = passages.at(robot.position, false))
    return claim_inside(passages[*inside], *inside, robot);
  std::optional<Claim> claim;
  walk(robot, kFarthestPassage * robot.radius, [&](Vec3 from, Vec3 to, double) {
    const auto crossed = passages.first_crossed(from, to);
    if (!crossed) return true;
    const SpacePassage& passage = passages[crossed->passage];
    const Vec3 mouth = passage.point(crossed->forward ? 0.0 : passage.length(), {}, 0.0);
    claim = Claim{crossed->passage, crossed->forward, false, norm(mouth - robot.position)};
    return false;
  });
  return claim;
}

// The neighbor that stands beside the robot before the same mouth, nearer to the entrance; their
// end if there is none. Two robots that both push into it would hold each other up for ever.
std::span<const Neighbor>::iterator first_beside(const SpacePassage& passage,
                                                 const SpaceClaimer& robot, bool forward) {
  const double unit = passage.plane.radius, in = kGate * unit;
  const Vec3 gate = passage.point(forward ? in : passage.length() - in, {}, 0.0);
  const double own = norm(robot.position - gate);
  if (own > kEntrance * unit || robot.yielded > kPatience) return robot.neighbors.end();
  return std::find_if(robot.neighbors.begin(), robot.neighbors.end(), [&](const Neighbor& other) {
    return norm(other.position - robot.position) < kBeside * (robot.radius + other.radius) &&
           norm(other.position - gate) < own;
  });
}

// The claimants that the robot senses.
void collect_others(std::span<const SpaceClaimant> claimants, const SpaceClaimer& robot,
                    std::vector<Claimant>& others) {
  others.clear();
  for (const SpaceClaimant& other : claimants) {
    if (other.robot != robot.robot && norm(other.position - robot.position) <= robot.sensing_radius)
      others.push_back(other.plane);
  }
}

}  // namespace

void SpaceClaims::clear(std::size_t passages) {
  of.resize(passages);
  for (std::vector<SpaceClaimant>& claimants : of) claimants.clear();
}

void append_claims(const SpacePassages& passages, const Solids& solids, Vec3 position,
                   Vec3 velocity, std::uint32_t robot, SpaceClaims& claims) {
  for (std::uint32_t k = 0; k < passages.size(); ++k) {
    const SpacePassage& passage = passages[k];
    if (passage.plane.two_lanes) continue;
    const PlaceInTube in = passage.place(position);
    const double range = kClaimRange * passage.plane.radius;
    if (in.along < -range || in.along > passage.length() + range || in.aside > range) continue;
    const Vec3 off = in.lanes * passage.lanes + in.other * passage.other;
    const Vec2 folded{dot(velocity, passage.axis),
                      in.aside > 0.0 ? dot(velocity, off) / in.aside : 0.0};
    const Vec2 place{in.along, in.aside};
    const auto claim = seen_claim(passage.plane, k, place, folded);
    if (!claim) continue;
    const Vec3 mouth = passage.point(claim->forward ? 0.0 : passage.length(), {}, 0.0);
    if (!claim->inside && !solids.sees(position, mouth)) continue;
    claims.of[k].push_back({{.claim = *claim, .position = place, .rank = robot}, position, robot});
  }
}

SpaceCourse right_of_way(const SpacePassages& passages, const SpaceClaims& claims,
                         const SpaceClaimer& robot, std::vector<Claimant>& others) {
  const std::optional<Claim> claim = claim_of(passages, robot);
  if (!claim) return {};
  const SpacePassage& passage = passages[claim->passage];
  collect_others(claims.of[claim->passage], robot, others);
  const Vec3 across = passages.side_of(claim->passage, claim->forward, robot.position);
  const PlaceInTube in = passage.place(robot.position);
  const Claimant own{.claim = *claim, .position = {in.along, in.aside}};
  const Course course =
      right_of_way(passage.plane, own, robot.braking, others, robot.sensing_radius);
  SpaceCourse result{.stops = course.stops, .max_speed = course.max_speed};
  const double entered = claim->forward ? in.along : passage.length() - in.along;
  if (!course.target && entered < kGate * passage.plane.radius &&
      first_beside(passage, robot, claim->forward) != robot.neighbors.end()) {
    result.is_after_others = true;
    const double out = kBack * passage.plane.radius;
    result.target = passage.point(claim->forward ? -out : passage.length() + out, across,
                                  kBackAside * passage.plane.radius);
    return result;
  }
  if (course.target) result.target = passage.point(course.target->x, across, course.target->y);
  return result;
}

std::optional<SpaceWait> waited_for(const SpacePassages& passages, const SpaceClaims& claims,
                                    const SpaceClaimer& robot, std::vector<Claimant>& others) {
  const std::optional<Claim> claim = claim_of(passages, robot);
  if (!claim) return std::nullopt;
  const SpacePassage& passage = passages[claim->passage];
  SpaceWait wait{.passage = passage.point(0.5 * passage.length(), {}, 0.0)};
  if (right_of_way(passages, claims, robot, others).is_after_others) {
    const auto first = first_beside(passage, robot, claim->forward);
    wait.robot = static_cast<std::uint32_t>(first - robot.neighbors.begin());
    return wait;
  }
  const PlaceInTube in = passage.place(robot.position);
  const Claimant own{.claim = *claim, .position = {in.along, in.aside}};
  const Claimant* first = nullptr;
  for (const Claimant& other : others)
    if (first == nullptr || is_waited_for_first(own, other, *first)) first = &other;
  if (first == nullptr) return std::nullopt;
  wait.is_claim = true, wait.robot = first->rank, wait.inside = first->claim.inside;
  return wait;
}

std::optional<Vec3> lane_ahead(const SpacePassages& passages, const Solids& solids,
                               const SpaceClaimer& robot) {
  std::optional<Vec3> lane;
  const double ahead = kAhead * robot.radius;
  walk(robot, ahead, [&](Vec3 from, Vec3 to, double before) {
    const double length = norm(to - from);
    if (!(length > 0.0) || before + length < ahead) return true;
    const Vec3 direction = (to - from) / length;
    const Vec3 place = from + (ahead - before) * direction;
    const auto number = passages.at(place, true);
    if (!number) return false;
    const SpacePassage& passage = passages[*number];
    const double cosine = dot(passage.axis, direction);
    if (std::abs(cosine) <= kAlong) return false;
    const PlaceInTube in = passage.place(place);
    const double own = passage.place(robot.position).other;
    const double most = std::max(0.0, passage.half_other - kBesideFaces * robot.radius);
    const Vec3 middle = passage.point(in.along, passage.other, std::clamp(own, -most, most));
    const double side = std::copysign(lane_offset(passage.plane), cosine);
    for (const double part : {1.0, 0.5}) {
      const Vec3 target = middle + (part * side) * passage.lanes;
      if (!solids.is_clear(robot.position, target, kRoom * robot.radius)) continue;
      lane = target;
      break;
    }
    return false;
  });
  return lane;
}

}  // namespace avo::space
