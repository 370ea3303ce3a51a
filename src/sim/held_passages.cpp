// SPDX-License-Identifier: Apache-2.0
// A robot cannot know how long others will hold a passage. It takes another route once it has
// waited for as long as that route takes in addition. So it loses at most twice the time that it
// would lose with that knowledge. Where there is no other route, some robots in a jam must go back,
// and only those at its ends can: all of them try to, for half of the time. A crowd before a
// passage of one lane is no jam, but waits in turn.
#include "sim/held_passages.h"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/plane.h"
#include "navigation/prospect.h"
#include "planner/rules/arrival.h"
#include "sim/clocks.h"
#include "sim/world.h"

namespace avo::inline sim {
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
  robot.radius = traits.radius;
  robot.max_speed = traits.max_speed, robot.max_acceleration = traits.max_acceleration;
  return time_to_speed(robot);
}

void wait_on(Waiting& waiting, double left, const RobotTraits& traits, double time) {
  waiting.waited += time;
  if (!(left < waiting.least - kComesNearer * traits.radius)) return;
  waiting.least = left, waiting.waited = 0.0;
  waiting.looks_at = kPatience * time_of(traits);
}

// s: as long as the additional time of another route.
double worth_waiting(double longer, const RobotTraits& traits) {
  return longer > 0.0 ? longer / traits.preferred_speed : 0.0;
}

std::optional<Passages::Crossing> gap_ahead(const World& world, const Travel& travel, Vec2 p) {
  return next_gap(world.ways.passages, *travel.graph, *travel.map, p, travel.target);
}

bool has_two_lanes(const World& world, const Passages::Crossing& next) {
  return world.ways.passages[next.passage].two_lanes;
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

void look_for_another_way(const World& world, std::size_t slot, Travel& travel,
                          LegScratch& scratch) {
  const RobotTraits& traits = world.fleet.traits[slot];
  const Vec2 p = world.fleet.position[slot];
  Waiting& waiting = travel.waiting;
  const auto next = gap_ahead(world, travel, p);
  const double time = time_of(traits);
  if (!next) {
    waiting.looks_at = waiting.waited + kPatience * time;
    return;
  }
  if (has_two_lanes(world, *next) && waiting.waited < kPatienceOfTwo * time) {
    waiting.looks_at = kPatienceOfTwo * time;
    return;
  }
  Travel other = way_around(travel, next->gap, p, traits.radius, scratch);
  waiting.looks_at = other.is_known()
                         ? worth_waiting(length_of(other, p) - length_of(travel, p), traits)
                         : kInfinity;
  if (waiting.looks_at <= waiting.waited) travel = std::move(other);
}

// Opens the gaps once the robot has come as near to its end as where it waited, and the shortest
// route leads elsewhere.
void open_again(const World& world, std::size_t slot, Travel& travel, LegScratch& scratch) {
  const double radius = world.fleet.traits[slot].radius;
  const Vec2 p = world.fleet.position[slot];
  if (length_of(travel, p) > travel.waiting.opens_at) return;
  Travel open = reopened(travel, p, radius, scratch);
  if (!open.is_known()) return;
  if (length_of(open, p) < length_of(travel, p) - kLengthRounding * radius) return;
  travel = std::move(open);
}

}  // namespace

void go_around_held(const World& world, std::size_t slot, double left, double time, Travel& travel,
                    LegScratch& scratch) {
  if (!travel.is_known() || world.settings.right_of_way != RightOfWay::seen) return;
  const Fleet& fleet = world.fleet;
  const bool rests = rests_at_place(world, slot);
  wait_on(travel.waiting, left, fleet.traits[slot], rests ? 0.0 : time);
  if (travel.waiting.waited >= travel.waiting.looks_at)
    look_for_another_way(world, slot, travel, scratch);
  if (!travel.waiting.closed.empty() && looks_around(fleet.id[slot], decisions_of(world, slot)))
    open_again(world, slot, travel, scratch);
}

bool goes_back(const World& world, std::size_t slot, const Travel& travel) {
  const Waiting& waiting = travel.waiting;
  if (!travel.is_known() || waiting.looks_at < kInfinity || rests_at_place(world, slot))
    return false;
  const double waited = waiting.waited / (kSteadfast * time_of(world.fleet.traits[slot]));
  int power = 0;
  if (waited < 1.0 || std::frexp(waited, &power) >= kForth) return false;
  const Vec2 p = world.fleet.position[slot];
  return gap_ahead(world, travel, p) &&
         has_room_for_two(world.ways.passages, *travel.graph, *travel.map, p, travel.target);
}

}  // namespace avo::inline sim
