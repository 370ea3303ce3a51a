// SPDX-License-Identifier: Apache-2.0
// What happened to robots since the last look, so that a host need not ask each robot. An observer
// of a simulation.
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "avo/export.h"
#include "avo/simulation.h"

namespace avo {

/// In the order in which the events of one robot are told.
enum class EventKind : unsigned char {
  gone,  ///< the robot was removed, or it is an airplane that left
  came,  ///< the robot was added
  /// The robot was at its goal and no longer is: it was pushed away, the host steers it, or it has
  /// a new goal.
  left,
  /// The robot is at its goal (Simulation::is_at_goal()), and was not. A new goal counts anew.
  arrived,
  /// Simulation::unreachable() names the robot, and did not. A new goal counts anew.
  unreachable,
  /// The robot makes no progress, see EventsOptions::stuck_after. It is told once, until the robot
  /// gets on again or has a new goal.
  stuck,
  /// The disc of the robot overlaps that of a moving obstacle, or of a robot that the host moves
  /// and that it avoids (Simulation::set_velocity()), and did not.
  contact,
};
AVO_API const char* to_string(EventKind kind);

/// What happened to one robot.
struct Event {
  EventKind kind = EventKind::came;
  RobotId robot;
  MovingObstacleId moving_obstacle = {};    ///< of a contact, where there is no moved_robot
  std::optional<RobotId> moved_robot = {};  ///< of a contact with a robot that the host moves
  bool at_rest = false;       ///< of a contact: the robot has not moved since the last look
  std::string sentence = {};  ///< why a robot is stuck, see Explanation::sentence; else empty
};

/// What Events counts as an event.
struct EventsOptions {
  /// s, > 0: a robot that makes no progress for so long is stuck. It makes progress if its route
  /// (Simulation::Route::length) has become shorter since its last progress. It must be shorter by
  /// more than a hundredth of what the preferred speed makes in that time. The robot's own motion
  /// counts, not a change of the route. Robots at their goals, robots that the host steers or
  /// moves, robots that do not start yet and robots that unreachable() names are never stuck.
  double stuck_after = 3.0;
};

/// Call observe() after every step. What holds when the object is made is no event. Each event is a
/// difference from the last look, also after edits and a restore. Parked robots only come and go.
class AVO_API Events {
 public:
  /// Throws Error on a bad stuck_after.
  explicit Events(const Simulation& simulation, const EventsOptions& options = {});
  ~Events();
  /// The events since the last look, by robot and then by kind. Contacts of one robot are by
  /// moving obstacle, and then by moved robot. They are valid until the next call. A call allocates
  /// nothing where nothing happens.
  std::span<const Event> observe(const Simulation& simulation);

 private:
  struct AVO_LOCAL State;
  std::unique_ptr<State> state_;
};

}  // namespace avo
