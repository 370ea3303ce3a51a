// SPDX-License-Identifier: Apache-2.0
// What is known of a robot from look to look, in the plane and in space (avo/events.h).
#pragma once
#include <algorithm>
#include <limits>
#include <tuple>
#include <vector>

#include "avo/events.h"
#include "avo/ids.h"

namespace avo::inline metrics {

inline constexpr double kGetsOn = 0.01;  // of the preferred speed: a slower robot makes no progress
inline constexpr double kPutDown = 2.0;  // of max_speed: a faster robot was put down elsewhere
inline constexpr double kStandsStill = 1e-9;  // of max_speed: a slower robot has not moved
inline constexpr double kSumOfSteps = 1e-9;   // of a duration: its rounding

/// A robot as it was observed last.
template <typename Vec>
struct WatchedRobot {
  RobotId id;
  bool at_goal = false, unreachable = false;
  bool stuck = false;                             // that is told
  double preferred_speed = 0.0, max_speed = 0.0;  // m/s
  Vec goal = {}, position = {};                   // m
  double length = 0.0;                            // m, of its route
  double moved = 0.0;                             // m, since the observation before
  double since = 0.0;                             // s, when it last made progress
  double made = 0.0;                              // m, of its route since then; < 0: it went back
};

/// A look at one robot. Times in s.
struct RobotLook {
  double before = 0.0, now = 0.0;
  double stuck_after = 0.0;
  bool has_new_goal = false;
};

/// Tells whether it has left its goal, or has arrived.
template <typename Vec>
void watch_goal(WatchedRobot<Vec>& robot, Vec goal, bool is_at_goal, std::vector<Event>& events) {
  const bool is_new = !(goal == robot.goal);
  const auto tell = [&](EventKind kind) { events.push_back({.kind = kind, .robot = robot.id}); };
  if (robot.at_goal && (is_new || !is_at_goal)) tell(EventKind::left);
  if (is_at_goal && (is_new || !robot.at_goal)) tell(EventKind::arrived);
  robot.goal = goal, robot.at_goal = is_at_goal;
}

/// Tells whether its goal is out of reach, and whether it is stuck: returns true where that is told
/// and needs its sentence. The part of the route that the robot made is at most what it moved. So a
/// route that changes, as when a door opens, is no progress. is_steered(): whether the robot's
/// motion is the host's, or it waits for its start.
template <typename Vec, typename IsSteered>
bool watch_progress(WatchedRobot<Vec>& robot, Vec position, double length, const RobotLook& look,
                    const IsSteered& is_steered, std::vector<Event>& events) {
  const bool unreachable = length == std::numeric_limits<double>::infinity();
  if (unreachable && (look.has_new_goal || !robot.unreachable))
    events.push_back({.kind = EventKind::unreachable, .robot = robot.id});
  robot.unreachable = unreachable;
  robot.moved = norm(position - robot.position);
  robot.made += std::clamp(robot.length - length, -robot.moved, robot.moved);
  robot.position = position, robot.length = length;
  // where time went back, too
  const bool was_put_down = robot.moved > kPutDown * robot.max_speed * (look.now - look.before);
  if (look.has_new_goal || robot.at_goal || unreachable || was_put_down ||
      robot.made > kGetsOn * robot.preferred_speed * look.stuck_after || is_steered()) {
    robot.made = 0.0, robot.since = look.now, robot.stuck = false;
    return false;
  }
  if (robot.stuck || !(look.now - robot.since >= look.stuck_after * (1.0 - kSumOfSteps)))
    return false;
  robot.stuck = true;
  events.push_back({.kind = EventKind::stuck, .robot = robot.id});
  return true;
}

/// The robot has begun to touch a mover. duration: s, since the observation before.
template <typename Vec>
Event contact_of(const WatchedRobot<Vec>& robot, double duration) {
  return {.kind = EventKind::contact,
          .robot = robot.id,
          .at_rest = robot.moved <= kStandsStill * robot.max_speed * duration};
}

/// Puts events into the order in which they are told.
inline void sort_events(std::vector<Event>& events) {
  const auto place = [](const Event& event) {
    return std::tuple(event.robot.value, event.kind,
                      event.moved_robot ? event.moved_robot->value + 1 : 0,
                      event.moving_obstacle.value);
  };
  std::sort(events.begin(), events.end(),
            [&](const Event& a, const Event& b) { return place(a) < place(b); });
}

}  // namespace avo::inline metrics
