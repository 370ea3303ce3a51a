// SPDX-License-Identifier: Apache-2.0
// A robot cannot know how long others will hold a passage. It takes another route once it has
// waited for as long as that route takes in addition. So it loses at most twice the time that it
// would lose with that knowledge. Where there is no other route, some robots in a jam must go back,
// and only those at its ends can: all of them try to, for half of the time. A crowd before a
// passage of one lane is no jam, but waits in turn.
#include "guidance/held_passages.h"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/plane.h"
#include "navigation/prospect.h"
#include "planner/rules/arrival.h"

namespace avo::inline guidance {
namespace {

// radii of route length: a robot that comes nearer by this does not wait
constexpr double kComesNearer = 1.0;
// T: a robot that lets a few others pass waits for less; and for two lanes, where robots do not
// wait in turn
constexpr double kPatience = 4.0;
constexpr double kPatienceOfTwo = 8.0;
constexpr double kSteadfast = 32.0;  // T: a jam that has lasted as long does not end by itself
// of a power of two: from there to the next power the robot goes on
constexpr double kForth = 0.75;

double time_of(const RobotTraits& traits) {
  Robot robot;
  robot.radius = traits.way_radius;
  robot.max_speed = traits.max_speed, robot.max_acceleration = traits.max_acceleration;
  return time_to_speed(robot);
}

void wait_on(Waiting& waiting, double left, const RobotTraits& traits, double time) {
  waiting.waited += time;
  if (!(left < waiting.least - kComesNearer * traits.way_radius)) return;
  waiting.least = left, waiting.waited = 0.0;
  waiting.looks_at = kPatience * time_of(traits);
}

// s: as long as the additional time of another route.
double worth_waiting(double longer, const RobotTraits& traits) {
  return longer > 0.0 ? longer / traits.preferred_speed : 0.0;
}

std::optional<Passages::Crossing> gap_ahead(const Ways& ways, const Travel& travel, Vec2 p) {
  return next_gap(ways.passages, *travel.graph, *travel.map, p, travel.target);
}

bool has_two_lanes(const Ways& ways, const Passages::Crossing& next) {
  return ways.passages[next.passage].two_lanes;
}

// A route around that gap as well, or around it alone where that leads nowhere.
Travel way_around(const Travel& travel, const Segment& gap, Vec2 position, double radius,
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

void look_for_another_way(const Ways& ways, const Follower& robot, Travel& travel,
                          LegScratch& scratch) {
  const RobotTraits& traits = robot.traits;
  const Vec2 p = robot.as_seen.position;
  Waiting& waiting = travel.waiting;
  const auto next = gap_ahead(ways, travel, p);
  const double time = time_of(traits);
  if (!next) {
    waiting.looks_at = waiting.waited + kPatience * time;
    return;
  }
  if (has_two_lanes(ways, *next) && waiting.waited < kPatienceOfTwo * time) {
    waiting.looks_at = kPatienceOfTwo * time;
    return;
  }
  Travel other = way_around(travel, next->gap, p, traits.way_radius, scratch);
  waiting.looks_at = other.is_known()
                         ? worth_waiting(length_of(other, p) - length_of(travel, p), traits)
                         : kInfinity;
  if (waiting.looks_at <= waiting.waited) travel = std::move(other);
}

// Opens the gaps once the robot has come as near to its end as where it waited, and the shortest
// route leads elsewhere.
void open_again(const Follower& robot, Travel& travel, LegScratch& scratch) {
  const double radius = robot.traits.way_radius;
  const Vec2 p = robot.as_seen.position;
  if (length_of(travel, p) > travel.waiting.opens_at) return;
  Travel open = reopened(travel, p, radius, scratch);
  if (!open.is_known()) return;
  if (length_of(open, p) < length_of(travel, p) - kLengthRounding * radius) return;
  travel = std::move(open);
}

}  // namespace

void go_around_held(const Ways& ways, const Follower& robot, double left, double time,
                    Travel& travel, LegScratch& scratch) {
  if (!travel.is_known()) return;
  wait_on(travel.waiting, left, robot.traits, robot.rests ? 0.0 : time);
  if (travel.waiting.waited >= travel.waiting.looks_at)
    look_for_another_way(ways, robot, travel, scratch);
  if (!travel.waiting.closed.empty() && robot.looks_around) open_again(robot, travel, scratch);
}

bool goes_back(const Ways& ways, const Follower& robot, const Travel& travel) {
  const Waiting& waiting = travel.waiting;
  if (!travel.is_known() || waiting.looks_at < kInfinity || robot.rests) return false;
  const double waited = waiting.waited / (kSteadfast * time_of(robot.traits));
  int power = 0;
  if (waited < 1.0 || std::frexp(waited, &power) >= kForth) return false;
  const Vec2 p = robot.as_seen.position;
  return gap_ahead(ways, travel, p) &&
         has_room_for_two(ways.passages, *travel.graph, *travel.map, p, travel.target);
}

}  // namespace avo::inline guidance
