// SPDX-License-Identifier: Apache-2.0
// All lengths are in radii of the passage, so that robots of any size agree on them.
#include "navigation/right_of_way.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace avo::inline navigation {
namespace {

constexpr double kMoves = 0.2;  // radii a second: a slower robot is at rest
// a robot that rests farther away has come to its own goal, or makes room
constexpr double kNear = 5.0;
constexpr double kInARow = 2.2;     // for each robot that may stand between: the length of a row
constexpr double kTowards = 0.5;    // cosine: a robot that moves more across does not come
constexpr double kDeep = 6.0;       // outward depth of the area before a mouth that is kept clear
constexpr double kAside = 1.6;      // and its width from the axis to the side of the bay
constexpr double kQueue = 2.2;      // beside the entrance, from the mouth: no robot waits nearer
constexpr double kBack = 2.5;       // from the mouth: the target of a robot that backs out
constexpr double kOut = 0.6;        // before the mouth: where it turns
constexpr double kBackAside = 2.0;  // to the side of the bay
constexpr double kLaneRoom = 0.1;   // between walls and a robot in its lane
constexpr double kBothFit = 1e-9;   // of contact: goals that touch leave room for both
constexpr double kOverlaps = 1e-6;  // of contact, for crowds in contact
// from the axis, where there is room: robots in both lanes do not touch
constexpr double kLane = 1.3;

// The mouth of the robots that enter there.
struct Mouth {
  Vec2 center, inward, aside;  // m; unit; unit, to the side of the bay
};

Mouth mouth_of(const Passage& passage, bool forward) {
  const AxisPoint start = axis_point(passage, forward, 0.0);
  const double side = passage.bay_side[forward ? 0 : 1];
  return {start.point, start.direction, -side * perpendicular(start.direction)};
}

// The precedence between robots at equal distances; all robots can see it.
bool comes_first(Vec2 p, Vec2 q) {
  return std::pair(p.x, p.y) < std::pair(q.x, q.y);
}

// Returns whether there is no room at their goals for both: they come to rest side by side.
bool share_goal(const Claimant& a, const Claimant& b) {
  const double contact = (1.0 - kBothFit) * (a.room + b.room);
  return a.room > 0.0 && b.room > 0.0 && norm(b.goal - a.goal) < contact;
}

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

// Returns whether the other claimant matters to the robot; a claimant at its place is the robot
// itself.
bool senses(const Claimant& robot, const Claimant& other, double sensing_radius) {
  return !(other.position == robot.position) && (robot.avoids & other.layers) != 0 &&
         !share_goal(robot, other) && norm(other.position - robot.position) <= sensing_radius;
}

// Returns whether it rests too far away to block the robot.
bool rests_apart(const Passage& passage, const Claimant& robot, const Claimant& other) {
  return !other.claim.moves && norm(other.position - robot.position) > kNear * passage.radius;
}

// The robot of one direction that has come farthest.
struct Foremost {
  double way = -1.0;  // m, from where it entered; < 0: none is inside
  Vec2 position = {};

  void include(const Passage& passage, const Claimant& robot) {
    const double along = place_in(passage, robot.position).along;
    const double come = robot.claim.forward ? along : passage.length() - along;
    if (come > way) way = come, position = robot.position;
  }
  bool goes_on_before(const Foremost& other) const {
    return way > other.way || (way == other.way && comes_first(position, other.position));
  }
};

// The target of a robot inside that must clear the path of robots that come out of the mouth where
// that direction enters.
Vec2 way_out(const Passage& passage, bool forward, Vec2 position) {
  const Mouth mouth = mouth_of(passage, forward);
  const bool is_out = dot(position - mouth.center, mouth.inward) < kOut * passage.radius;
  const double aside = is_out ? kBackAside : 0.0;
  return mouth.center + passage.radius * (aside * mouth.aside - kBack * mouth.inward);
}

// With both directions inside, the direction that has come less far goes back, all of it.
Course go_on_or_back(const Passage& passage, const Claimant& robot,
                     std::span<const Claimant> claimants, double sensing_radius) {
  Foremost ours, theirs;
  ours.include(passage, robot);
  for (const Claimant& other : claimants) {
    if (!other.claim.inside || !senses(robot, other, sensing_radius) ||
        rests_apart(passage, robot, other))
      continue;
    (other.claim.forward == robot.claim.forward ? ours : theirs).include(passage, other);
  }
  if (theirs.way < 0.0 || ours.goes_on_before(theirs)) return {};
  return {.target = way_out(passage, robot.claim.forward, robot.position)};
}

// The number of others inside with the robot's goal.
double crowd_of(const Claimant& robot, std::span<const Claimant> claimants) {
  const auto is_of_it = [&](const Claimant& other) {
    return other.claim.inside && !(other.position == robot.position) && share_goal(robot, other);
  };
  return static_cast<double>(std::count_if(claimants.begin(), claimants.end(), is_of_it));
}

// A robot with its goal inside blocks robots that come near: it goes on before them, out of the
// passage, and enters again in turn. If robots of both directions are inside, it goes with the
// direction that goes on. Others take it for one of these, so it makes none of them change its
// decision. Where several robots rest at one goal, all of them must go, or the first one cannot.
Course make_room(const Passage& passage, const Claimant& robot, std::span<const Claimant> claimants,
                 double sensing_radius) {
  const double along = place_in(passage, robot.position).along;
  Foremost ahead, back;  // of the robots inside, by direction
  std::optional<bool> forward;
  double least = (kNear + kInARow * crowd_of(robot, claimants)) * passage.radius;
  for (const Claimant& other : claimants) {
    if (!other.claim.moves || !senses(robot, other, sensing_radius)) continue;
    if (other.claim.inside) (other.claim.forward ? ahead : back).include(passage, other);
    const double behind = along - place_in(passage, other.position).along;
    const double between = other.claim.forward ? behind : -behind;
    if (between > 0.0 && between < least) least = between, forward = other.claim.forward;
  }
  if (!forward) return {};
  if (ahead.way >= 0.0 && back.way >= 0.0) forward = ahead.goes_on_before(back);
  return {.target = way_out(passage, !*forward, robot.position)};
}

// The robot may enter if no robot comes towards it inside, or nearer to the mouth where it enters.
// A robot that rests farther inside does not come.
bool may_enter(const Passage& passage, const Claimant& robot, std::span<const Claimant> claimants,
               double sensing_radius) {
  return std::none_of(claimants.begin(), claimants.end(), [&](const Claimant& other) {
    if (other.claim.forward == robot.claim.forward || !senses(robot, other, sensing_radius))
      return false;
    if (other.claim.inside) return !rests_apart(passage, robot, other);
    const double ours = robot.claim.distance, theirs = other.claim.distance;
    return theirs < ours || (theirs == ours && comes_first(other.position, robot.position));
  });
}

// The course of a waiting robot, off the path of robots that come out. In the area before the mouth
// it goes to the bay; outside it stops at the border.
Course wait(const Passage& passage, const Claimant& robot, double braking) {
  const double unit = passage.radius;
  const Mouth mouth = mouth_of(passage, robot.claim.forward);
  const Vec2 from_mouth = robot.position - mouth.center;
  const double out = -dot(from_mouth, mouth.inward), aside = dot(from_mouth, mouth.aside);
  const bool is_beside = aside >= kAside * unit;
  if (out < kDeep * unit && !is_beside) {
    const Vec2 bay = mouth.center - std::max(out, kBayOut * unit) * mouth.inward +
                     kBayAside * unit * mouth.aside;
    return {.target = bay, .stops = true};
  }
  const double behind = out - kDeep * unit;
  const double beside = is_beside ? robot.claim.distance - kQueue * unit : 0.0;
  const double room = std::max({0.0, behind, beside});
  return {.max_speed = std::sqrt(2.0 * braking * room)};
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
  const Vec2 way = (is_first_near ? front : back) - position;
  const double towards = dot(velocity, way), range = kClaimRange * passage.radius;
  if (!(towards > 0.0) || norm_squared(way) > range * range) return {};
  const double distance = norm(way);
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
  return wait(passage, robot, braking);
}

double lane_offset(const Passage& passage) {
  const double free = passage.half_width - (1.0 + kLaneRoom) * passage.radius;
  return std::max(0.5 * passage.half_width, std::min(kLane * passage.radius, free));
}

}  // namespace avo::inline navigation
