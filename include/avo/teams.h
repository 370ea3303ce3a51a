// SPDX-License-Identifier: Apache-2.0
// Teams: robots with one task, such as a queue or a patrol. A layer of functions above a
// simulation: they set goals and preferred velocities, and the robots avoid each other as ever.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "avo/export.h"
#include "avo/ids.h"
#include "avo/vec.h"

namespace avo {

class Simulation;

/// The shape of a formation.
enum class Formation : std::uint8_t {
  line,    ///< side by side
  column,  ///< one behind the other
  wedge,   ///< a V with its point ahead
  block,   ///< rows, as wide as deep
  ring,    ///< on a circle
};
AVO_API const char* to_string(Formation formation);

/// Returns the slots of `count` robots, m, with the direction of travel along +x and their mean at
/// the origin. Neighboring slots are `spacing` apart: m, > 0. Throws Error on a bad spacing.
AVO_API std::vector<Vec2> formation_slots(Formation formation, std::size_t count, double spacing);

/// Returns slots turned by `heading`, rad, and moved so that their origin is at `center`, m. Throws
/// Error on numbers that are not finite or out of range.
AVO_API std::vector<Vec2> place_slots(std::span<const Vec2> slots, Vec2 center, double heading);

/// Returns for each robot the position of its slot in the list. The sum of the distances is least,
/// to a millionth of the longest distance. The straight lines of two robots then do not cross,
/// unless they are nearly on one line. There must be at least as many slots as robots, else it
/// throws Error. The time is that of the Hungarian method: at most the square of the robots times
/// the slots.
AVO_API std::vector<std::size_t> assign_slots(std::span<const Vec2> positions,
                                              std::span<const Vec2> slots);

/// Sends each robot to a slot as assign_slots() says: the slots are their goals. Throws Error as
/// Simulation::set_goals() does, and changes nothing then.
AVO_API void form_up(Simulation& simulation, std::span<const RobotId> robots,
                     std::span<const Vec2> slots);

/// Robots stand in a row and move up. New members line up by their distance to the head.
struct Queue {
  /// m: the row begins at the first point and follows the points; beyond the last one it goes
  /// straight on. At least two points.
  std::vector<Vec2> line = {};
  double spacing = 1.5;  ///< m, > 0, between two places along the line
  /// s, >= 0: the first robot waits that long at the head, then leaves the team for its own goal.
  /// Unset: until serve() is called.
  std::optional<double> service = {};
  friend bool operator==(const Queue&, const Queue&) = default;
};

/// The first member goes to its goal, and the others follow it. They stand near it once it rests.
/// They drive up to their max_speed to catch up.
struct Follow {
  double spacing = 1.5;  ///< m, > 0, between two robots along the trail of the first one
  /// m: places of the others about the first one, x ahead and y to its left. Robots for which there
  /// is no slot, or a slot behind a wall, follow the trail. Empty: all follow the trail.
  std::vector<Vec2> slots = {};
  friend bool operator==(const Follow&, const Follow&) = default;
};

/// Each member goes from point to point for ever. It begins with the point that is nearest to it.
/// It goes on too where it rests beside its point because others leave no room, and passes over
/// points that it cannot reach.
struct Patrol {
  std::vector<Vec2> points = {};  ///< m, at least one
  double pass_distance = 1.0;     ///< m, > 0: a robot that near to a point goes on to the next
  friend bool operator==(const Patrol&, const Patrol&) = default;
};

/// The members leave by the nearest exit. Within the arrival distance of an exit, with no wall
/// between, a member has arrived. Its goal is then where it is, and it is removed one step later.
struct Flow {
  /// m: two points each, the ends of a line, e.g. of a door. At least one exit
  std::vector<Vec2> exits = {};
  double spacing = 1.0;  ///< m, > 0, between the goals on an exit
  friend bool operator==(const Flow&, const Flow&) = default;
};

/// What the robots of a team do together.
using TeamTask = std::variant<Queue, Follow, Patrol, Flow>;

/// A robot of a team.
struct TeamMember {
  RobotId robot;
  bool is_led = false;       ///< lead() has taken it up
  Vec2 goal = {};            ///< m: the robot's own goal, from before lead() took it up
  std::uint32_t number = 0;  ///< index of its slot, or of the point or the goal that it goes to
  friend constexpr bool operator==(const TeamMember&, const TeamMember&) = default;
};

/// Robots with one task. A robot is in one team at most.
struct Team {
  std::vector<TeamMember> members = {};  ///< of a queue the first at the head, of Follow the leader
  TeamTask task = {};
  // what lead() remembers
  std::vector<Vec2> trail = {};  ///< m: of Follow, where the leader was, the latest place last
  RobotId leader = {};           ///< of Follow: the trail is that of this robot
  double since = -1.0;  ///< s: of a queue, when its first robot reached the head; < 0: not yet
  friend bool operator==(const Team&, const Team&) = default;
};

/// Returns a team of these robots. Add to Team::members, or take from them, at any time. Throws
/// Error on a robot that is named twice.
AVO_API Team make_team(std::span<const RobotId> robots, TeamTask task);

/// Throws Error on a task with values out of range, e.g. "spacing: found 0, must be > 0 m".
AVO_API void validate(const TeamTask& task);

/// Sets the goals and preferred velocities of the members for the next step, in place of those that
/// the host has set. Call it before each step. Members that are gone from the simulation leave the
/// team. A simulation leads the teams of its scenario itself, from the moment it is made. Throws
/// Error on a bad task, and on a member that is named twice.
AVO_API void lead(Simulation& simulation, Team& team);

/// Sends the first robot of a queue to its own goal; the others move up. Returns the robot, also
/// where its service has ended just now; none if the team is empty or not a queue.
AVO_API std::optional<RobotId> serve(Simulation& simulation, Team& team);

/// Gives the team another task, which the members begin with the next lead(). They keep the goals
/// that they had before they joined. Throws Error on a bad task, and changes nothing then.
AVO_API void set_task(Simulation& simulation, Team& team, TeamTask task);

/// Members go to the goals again that they had before they joined. The team is empty then.
AVO_API void disband(Simulation& simulation, Team& team);

}  // namespace avo
