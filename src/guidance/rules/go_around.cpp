// SPDX-License-Identifier: Apache-2.0
// Rule 11 of docs/arrival.md, go around a held passage. A robot cannot know how long others will
// hold the passage. The robot takes another route once it has waited for as long as that route
// takes in addition. So it loses at most twice the time that it would lose with that knowledge.
#include <optional>
#include <utility>
#include <vector>

#include "core/plane.h"
#include "guidance/rules/held_passages.h"

namespace avo::inline guidance {
namespace {

// radii of route length: a robot that comes nearer by this does not wait
constexpr double kComesNearer = 1.0;
// T: a robot that lets a few others pass waits for less; and for two lanes, where robots do not
// wait in turn
constexpr double kPatience = 4.0;
constexpr double kPatienceOfTwo = 8.0;

void wait_on(Waiting& waiting, double left, const RobotTraits& traits, double time) {
  waiting.waited += time;
  if (!(left < waiting.least - kComesNearer * traits.route_radius)) return;
  waiting.least = left, waiting.waited = 0.0;
  waiting.looks_at = kPatience * unit_of_time(traits);
}

// s: as long as the additional time of another route.
double worth_waiting(double longer, const RobotTraits& traits) {
  return longer > 0.0 ? longer / traits.preferred_speed : 0.0;
}

bool has_two_lanes(const Routes& routes, const Passages::Crossing& next) {
  return routes.passages[next.passage].two_lanes;
}

// A route around that gap as well, or around it alone where that leads nowhere.
Travel route_around(const Travel& travel, const Segment& gap, Vec2 position, double radius,
                    LegScratch& scratch) {
  std::vector<Segment> closed = travel.waiting.closed;
  closed.push_back(gap);
  const bool is_first = closed.size() == 1;
  Travel other = around(travel, position, radius, std::move(closed), scratch);
  other.waiting.opens_at = is_first ? travel.waiting.least : travel.waiting.opens_at;
  if (other.is_known() || is_first) return other;
  other = around(travel, position, radius, {gap}, scratch);
  other.waiting.opens_at = travel.waiting.least;
  return other;
}

void look_for_another_route(const Routes& routes, const Follower& robot, Travel& travel,
                            LegScratch& scratch) {
  const RobotTraits& traits = robot.traits;
  const Vec2 p = robot.as_seen.position;
  Waiting& waiting = travel.waiting;
  const auto next = gap_ahead(routes, travel, p);
  const double time = unit_of_time(traits);
  if (!next) {
    waiting.looks_at = waiting.waited + kPatience * time;
    return;
  }
  if (has_two_lanes(routes, *next) && waiting.waited < kPatienceOfTwo * time) {
    waiting.looks_at = kPatienceOfTwo * time;
    return;
  }
  Travel other = route_around(travel, next->gap, p, traits.route_radius, scratch);
  waiting.looks_at = other.is_known()
                         ? worth_waiting(length_of(other, p) - length_of(travel, p), traits)
                         : kInfinity;
  if (waiting.looks_at <= waiting.waited) travel = std::move(other);
}

// Opens the gaps once the robot has come as near to its end as where it waited, and the shortest
// route leads elsewhere.
void open_again(const Follower& robot, Travel& travel, LegScratch& scratch) {
  const double radius = robot.traits.route_radius;
  const Vec2 p = robot.as_seen.position;
  if (length_of(travel, p) > travel.waiting.opens_at) return;
  Travel open = reopened(travel, p, radius, scratch);
  if (!open.is_known()) return;
  if (length_of(open, p) < length_of(travel, p) - kLengthRounding * radius) return;
  travel = std::move(open);
}

}  // namespace

void go_around_held(const Routes& routes, const Follower& robot, double left, double time,
                    Travel& travel, LegScratch& scratch) {
  if (!travel.is_known()) return;
  wait_on(travel.waiting, left, robot.traits, robot.rests ? 0.0 : time);
  if (travel.waiting.waited >= travel.waiting.looks_at)
    look_for_another_route(routes, robot, travel, scratch);
  if (!travel.waiting.closed.empty() && robot.looks_around) open_again(robot, travel, scratch);
}

}  // namespace avo::inline guidance
