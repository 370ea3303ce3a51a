// SPDX-License-Identifier: Apache-2.0
// Scenes over which safety and arrival are measured, as far as no YAML says them (read_scene.h).
// Each of these scenes has something that no scene file says: sizes, limits, walls or movers at
// random, starts around a block, new goals during a run, a torus, or faults of some robots. All
// robots start at rest.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "acting.h"
#include "avo/scenario.h"
#include "sensing.h"

namespace avo::safety {

/// A flow in a square of 30 m, in which no robot ever arrives for good.
enum class Flow : std::uint8_t {
  torus,       ///< a robot that leaves comes in again on the other side; four directions
  to_and_fro,  ///< between the middles of opposite sides, each reached within 1 m
};

struct Scene {
  Scenario scenario = {};
  double unit = 0.0;               ///< s, the unit of arrival times; 0: no robot has to arrive
  double limit = 1.0;              ///< units, the time within which robots must arrive
  double share = 1.0;              ///< of the robots that must arrive
  bool until_rest = false;         ///< lasts until no robot has moved for a while, bit for bit
  std::vector<Vec2> rallies = {};  ///< all robots are sent to one of these, then to another
  double rally_period = 5.0;       ///< s
  /// Robot i goes to one of errands[i % size]. When it is there, or has tried for long enough, it
  /// goes to another one.
  std::vector<std::vector<Vec2>> errands = {};
  /// Unset: as in Simulation, robots know each other as the scenario says, and act as they decide.
  std::optional<Sensing> sensing = {};
  /// one robot among moving obstacles: a search judges whether hits were evadable
  bool alone = false;
  std::optional<Flow> flow = {};  ///< set: the scene is run by run_flow
  Acting acting = {};             ///< used only if `sensing` is set
};

/// m/s, the preferred speed of all robots except those of circles
inline constexpr double kSpeed = 1.5;

/// Returns the common part of all scenes; control_time and time_horizon keep the defaults of a
/// scenario.
Scenario usual_scenario();
RobotSetup usual_robot(Vec2 position, Vec2 goal, double preferred_speed);

/// Returns a scene in which all robots must arrive within its duration.
Scene within_duration(Scenario scenario);

/// Returns a scene in which 99 % must arrive within 4.5 times the straight line's time; the aim is
/// 3.
Scene measured_by_straight_time(Scenario scenario);

/// Returns a scene that lasts until all robots are at rest, in which every robot must arrive within
/// so many units, the straight line's time each.
Scene until_rest(Scenario scenario, double units);

/// Returns the longest of the times that the robots, alone, take from rest to rest. A time is d/v +
/// v/a with v the preferred speed, or 2 √(d/a) if the distance is too short for it.
double straight_time(const Scenario& scenario);

/// Widens the sensing radius to the value that the scene's certificate needs.
void see_far_enough(Scenario& scenario);

/// Returns the same robots with their own clocks; `unequal`: every second robot decides twice as
/// often.
Scene with_clocks(Scene scene, bool unequal, std::uint64_t seed);

/// Returns 60 unequal robots, 15 % of the square's area, with random starts and goals in it.
Scene mixed(std::uint64_t seed);

/// Returns n robots around a block of goals that touch; n is a square number. Rows form a square,
/// or every second row is shifted by half a robot, which is the densest packing.
Scene touching_goals(int n, bool hexagonal, std::uint64_t seed);

/// Returns 200 unequal robots, all sent to one point, every 5 s to another of five within 4 m along
/// each axis. `packed`: equal radii, and they start at four fifths of the densest packing.
Scene crush(bool packed, double robot_steps, std::uint64_t seed);

/// Returns 100 unequal airplanes that loiter, all sent to one point, every 5 s to another of five.
/// `mixed`: of every three robots one is an airplane, one a car and one holonomic.
Scene airplanes(bool mixed, double robot_steps, std::uint64_t seed);

/// Returns 20 robots with random starts and goals in a square that 8 obstacles cross, each at its
/// own speed.
Scene among_movers(std::uint64_t seed);

/// Returns the same among 6 people who walk from one random point to the next, and may turn at any
/// time.
Scene among_people(std::uint64_t seed);

/// Returns 60 robots of all kinds that are sent to one point after the other, and 5 people among
/// them. There are cars, limits of braking of 0.5 to 1 of a_max, shares of 1/64 to 63/64, and
/// robots that avoid no other robot.
Scene mixed_crush(double robot_steps, std::uint64_t seed);

}  // namespace avo::safety
