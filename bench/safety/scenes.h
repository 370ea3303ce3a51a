// SPDX-License-Identifier: Apache-2.0
// The scenes that safety and arrival are measured over. All robots start at rest.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "acting.h"
#include "avo/scenario.h"
#include "sensing.h"

namespace avo::safety {

/// Nobody ever arrives for good, in a square of 30 m.
enum class Flow : std::uint8_t {
  torus,       ///< whoever leaves comes in again on the other side; four directions
  to_and_fro,  ///< between the middles of opposite sides, reached within 1 m
};

struct Scene {
  Scenario scenario = {};
  double unit = 0.0;        ///< s, the time that arrivals are measured in; 0: nobody is to arrive
  double limit = 1.0;       ///< units, within which robots are to arrive
  double share = 1.0;       ///< of the robots that have to
  bool until_rest = false;  ///< lasts until nobody has moved for a while, bit for bit
  std::vector<Vec2> rallies = {};  ///< all robots are sent to one of them, then to another
  double rally_period = 5.0;       ///< s
  /// Robot i goes to one of errands[i % size], and to another one when it is there or has tried for
  /// long enough.
  std::vector<std::vector<Vec2>> errands = {};
  /// Unset: all know each other as the scenario says and do as they decide, as Simulation has it.
  std::optional<Sensing> sensing = {};
  bool alone = false;  ///< one robot among movers: a search judges whether hits were evadable
  std::optional<Flow> flow = {};  ///< set: goes its own way, see run_flow
  Acting acting = {};             ///< read only where `sensing` is set
};

inline constexpr double kSpeed = 1.5;  ///< m/s, preferred, of all robots but those of circles

/// What all scenes share; control_time and time_horizon stay what a scenario has by itself.
Scenario usual_scenario();
RobotSetup usual_robot(Vec2 position, Vec2 goal, double preferred_speed);

/// 99 % are to arrive within 4.5 times the straight way's time; the aim is 3.
Scene measured_by_straight_time(Scenario scenario);

/// Longest of the times that the robots, alone, take from rest to rest: d/v + v/a with v the
/// preferred speed, or 2 √(d/a) where the way is too short for it.
double straight_time(const Scenario& scenario);

/// Widens the sensing radius to what the scene's certificate needs.
void see_far_enough(Scenario& scenario);

/// The same robots with clocks of their own; `unequal`: every other one decides twice as often.
Scene with_clocks(Scene scene, bool unequal, std::uint64_t seed);

/// Circle-N of the paper's §VI-B.
struct CircleRow {
  int robots = 0;
  double target = 0.0;  ///< s
  std::optional<double> control_time = {}, time_horizon = {};
  double jitter = 0.0;  ///< m, of starts and goals along each axis
};
Scene circle(const CircleRow& row, std::uint64_t seed);

/// n robots from and to anywhere in a square of 8 m or of 12 % density.
Scene random_square(int n, std::uint64_t seed);

/// Two blocks of 10 x 10, 2 m apart, exchange places; 30 m between the blocks' centers. jitter: as
/// in CircleRow, here of robots with their goals.
Scene swap_blocks(double jitter, std::uint64_t seed);

/// Blocks of 4 x 4, 2 m apart, their centers 20 m from the crossing, each to the opposite side.
Scene crossing_streams(double jitter, std::uint64_t seed);

/// 10 x 10 robots, 2.5 m apart, to each other's places; nobody keeps his own.
Scene permutation(std::uint64_t seed);

/// 60 unequal robots, 15 % of the square's area, from and to anywhere in it.
Scene mixed(std::uint64_t seed);

/// 200 unequal robots, all sent to one point, every 5 s to another of five within 4 m along each
/// axis. `packed`: equal radii, and they start at four fifths of the densest packing.
Scene crush(bool packed, double robot_steps, std::uint64_t seed);

/// 100 unequal airplanes that loiter, all sent to one point, every 5 s to another of five.
/// `mixed`: of every three robots one is an airplane, one a car and one holonomic.
Scene airplanes(bool mixed, double robot_steps, std::uint64_t seed);

/// Two groups of 4 x 4 change sides through a gap of 2.5 m in a wall of obstacles at rest.
Scene doorway();

/// 20 robots from and to anywhere in a square that 8 obstacles cross, each at its own speed.
Scene among_movers(std::uint64_t seed);

/// The same among 6 people who walk from one random point to the next, and may turn at any time.
Scene among_people(std::uint64_t seed);

/// 60 robots of all kinds sent to one point after the other, and 5 people among them: cars, limits
/// of braking of 0.5 to 1 of a_max, shares of 1/64 to 63/64, some that avoid nobody of the others.
Scene mixed_crush(double robot_steps, std::uint64_t seed);

}  // namespace avo::safety
