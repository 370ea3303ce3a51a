// SPDX-License-Identifier: Apache-2.0
// The data on which the future of a simulation depends, as data and as bytes. Data that affect only
// the duration of a step are not saved, such as the order of the robots in memory.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "avo/scenario.h"
#include "avo/simulation.h"
#include "guidance/routes.h"
#include "robots/motion.h"
#include "sim/bases/bases.h"
#include "sim/columns/fleet.h"
#include "sim/sensing/senses.h"

namespace avo::inline sim {

struct World;

/// The part of a robot that steps change: its state, beside its setup.
struct SavedRobot {
  RobotId id;
  Vec2 position, velocity;  // m, m/s
  double heading = 0.0;     // rad
  Detour detour;
};
static_assert(sizeof(SavedRobot) == 72, "it says so in avo/simulation.h");

/// A preferred velocity that the host gave to a robot.
struct SavedTold {
  std::uint64_t robot = 0;  // id
  Vec2 velocity;            // m/s
};

/// The motion of a robot that the host moves.
struct SavedHostMotion {
  std::uint64_t robot = 0;  // id
  HostMotion motion;
};

/// The part of a robot's route around walls that steps change.
struct SavedRoute {
  std::uint32_t target = 0;    // see Travel
  bool is_exact = false;       // with the graph of the robot's own radius
  bool around_movers = false;  // with the graph around movers at rest
  RouteEnd ends = RouteEnd::goal;
  Vec2 place = {};       // m, where it ends, if not at the goal
  Waiting waiting = {};  // without the map that is made from it
};

/// The additional state of a robot that flies, which steps change.
struct SavedFlight {
  LoiterCircle circle;
  bool has_arrived = false;
};

/// The additional state of a robot with a free clock, see OwnClock.
struct SavedClock {
  std::int64_t begin = 0, end = 0;  // ns
  MotionState from, to;
  bool has_decided = false;
};

struct SavedState {
  Scenario scene;               // values in SavedRobot do not count in its robots
  double sensing_radius = 0.0;  // m, at present
  std::int64_t steps = 0;
  std::uint64_t next_id = 0;
  std::vector<SavedRobot> robots;  // by ascending id, as many as the scene has
  // in the order of the scene, as many as it has; without a path next_point is 0
  std::vector<PathWalk> movers;
  std::vector<SavedRoute> routes;  // of the robots; none without walls and movers at rest
  std::uint64_t next_obstacle = 0;
  std::vector<ObstacleId> static_ids;  // ascending, as many as the scene has static obstacles
  std::vector<std::int64_t> since;  // of the robots, see Senses; empty where they remember nothing
  std::vector<PastState> past;
  std::int64_t now = 0;                     // ns, of free clocks
  std::vector<SavedClock> clocks;           // of the robots; empty where the clock is common
  std::vector<std::uint64_t> stood;         // ids of robots with Fleet::has_stood; ascending
  std::vector<SavedFlight> flights;         // of the robots that fly, in their order
  std::vector<MovingObstacleId> mover_ids;  // ascending, as many as the scene has moving obstacles
  std::uint64_t next_mover = 0;
  std::vector<SavedTold> told;                // by ascending id
  std::vector<SavedHostMotion> host_motions;  // by ascending id
  std::vector<std::vector<Knot>> tracks;  // of the robots, where senses are by time, oldest first
  Bases bases;  // where bases do not execute exactly; the scene is that of the references then
};

/// visit(key, member) for all values of a scene that affect its motion, except robots and
/// obstacles.
template <typename Visit>
void for_each_setting(const Visit& visit) {
  visit("name", &Scenario::name);
  visit("time_step", &Scenario::time_step);
  visit("duration", &Scenario::duration);
  visit("control_time", &Scenario::control_time);
  visit("response_time", &Scenario::response_time);
  visit("comfort_acceleration", &Scenario::comfort_acceleration);
  visit("comfort_jerk", &Scenario::comfort_jerk);
  visit("margin", &Scenario::margin);
  visit("time_horizon", &Scenario::time_horizon);
  visit("sensing_radius", &Scenario::sensing_radius);
  visit("max_neighbors", &Scenario::max_neighbors);
  visit("method", &Scenario::method);
  visit("certificate", &Scenario::certificate);
  visit("motion", &Scenario::motion);
  visit("arrival_distance", &Scenario::arrival_distance);
  visit("seed", &Scenario::seed);
  visit("navigation", &Scenario::navigation);
  visit("right_of_way", &Scenario::right_of_way);
  visit("sensing", &Scenario::sensing);
  visit("sensing_error", &Scenario::sensing_error);
  visit("clock", &Scenario::clock);
  visit("longest_step", &Scenario::longest_step);
  visit("never_swerves", &Scenario::never_swerves);
}

/// visit(key, member) for all values of a moving obstacle's setup.
template <typename Visit>
void for_each_mover_value(const Visit& visit) {
  visit("position", &MovingObstacle::position);
  visit("velocity", &MovingObstacle::velocity);
  visit("acceleration", &MovingObstacle::acceleration);
  visit("radius", &MovingObstacle::radius);
  visit("max_deviation", &MovingObstacle::max_deviation);
  visit("max_speed", &MovingObstacle::max_speed);
  visit("path", &MovingObstacle::path);
  visit("trajectory", &MovingObstacle::trajectory);
}

/// Throws Error on a state that no simulation can reach.
void check_saved(const SavedState& state);
[[noreturn]] void refuse_saved(const std::string& given, const std::string& allowed);

std::vector<std::byte> to_bytes(SavedState state);
/// Throws Error on bytes that to_bytes() did not make; reads no size without a check.
SavedState from_bytes(std::span<const std::byte> bytes);

SavedState saved_state(const World& world);
/// Throws Error unless the state is of a scene with the world's settings and moving obstacles.
/// Changes nothing where it throws.
void restore(const SavedState& state, World& world);

}  // namespace avo::inline sim
