// SPDX-License-Identifier: Apache-2.0
// Why a robot of a simulation in space decides as it does, as data and in words.
#pragma once
#include <string>

#include "avo/export.h"
#include "avo/space/decision_trace.h"
#include "avo/space/simulation.h"

namespace avo::space {

/// The next decision of one robot, see space::Simulation::explain().
struct Explanation {
  RobotId robot;
  double time = 0.0;                 ///< s
  Vec3 goal = {};                    ///< m
  bool is_at_goal = false;           ///< see Simulation::is_at_goal()
  double distance_left = 0.0;        ///< m, see Simulation::Route
  Simulation::Perception seen = {};  ///< what the robot senses, and wants
  /// The decision. Its neighbors, boxes and moving obstacles are those of `seen`.
  DecisionTrace decision = {};
  /// One or two sentences: what the robot does, and the reason with the names of those that cause
  /// it. Robots, static obstacles and moving obstacles are named by the values of their ids.
  std::string sentence = {};
};

/// The name in sentences of what limits the decision: "robot 7", "obstacle 2", "moving obstacle 1",
/// or "its own limits".
AVO_API std::string name_of(const Explanation& explanation, Cause cause);

}  // namespace avo::space
