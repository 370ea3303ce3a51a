// SPDX-License-Identifier: Apache-2.0
// Why a robot of a simulation decides as it does, as data and in words.
#pragma once
#include <cstdint>
#include <string>

#include "avo/decision_trace.h"
#include "avo/export.h"
#include "avo/simulation.h"

namespace avo {

/// The next decision of one robot, see Simulation::explain().
struct Explanation {
  RobotId robot;
  double time = 0.0;            ///< s
  Vec2 goal;                    ///< m
  double start_time = 0.0;      ///< s; before, it stands at its start
  bool is_at_goal = false;      ///< see Simulation::is_at_goal()
  double distance_left = 0.0;   ///< m, see Simulation::Route
  Simulation::Perception seen;  ///< what the robot senses, and wants
  /// The decision. Its neighbors and walls are those of `seen`. The plan is Perception::stop where
  /// the robot stops near a goal that others share.
  DecisionTrace decision;
  SafetyReport state;  ///< of the state in which the robot decides
  /// One or two sentences: what the robot does, and the reason with the names of those that cause
  /// it. Robots and moving obstacles are named by the values of their ids.
  std::string sentence;
};

}  // namespace avo
