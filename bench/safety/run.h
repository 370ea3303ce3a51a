// SPDX-License-Identifier: Apache-2.0
// Runs one scene from its start to its end: its results, its decisions and their cost.
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "judge.h"
#include "scenes.h"

namespace avo::safety {

inline constexpr double kNever = std::numeric_limits<double>::infinity();
/// More than the number of kinds of PlanStatus.
inline constexpr std::size_t kMostStatuses = 16;

struct Outcome {
  std::uint64_t seed = 0;
  Verdict verdict;
  PlannerOptions planner;  ///< the options that the robots planned with
  bool promised = true;    ///< whether their certificate, if there is one, covers their sensing
  std::int64_t robot_steps = 0;
  std::vector<double> arrival;  ///< s, for each robot: first time within arrival_distance; kNever
  std::int64_t at_goal_at_end = 0;                         ///< robots within arrival_distance
  double unit = 0.0, limit = 0.0, share = 0.0;             ///< see Scene
  double duration = 0.0;                                   ///< s, of the scene
  std::array<std::int64_t, kMostStatuses> decisions = {};  ///< robot-steps by PlanStatus
  double seconds = 0.0;                                    ///< CPU time in Simulation::step
  double worst_second = 0.0;  ///< CPU s per robot-step over the worst simulated second
  double density = 0.0;       ///< the largest value of densest_disc
  /// s, for scenes with Scene::until_rest: the time since no robot has moved; kNever if robots move
  /// until the end.
  std::optional<double> rest = {};
  /// For scenes with Scene::flow: the mean velocity towards the robots' waypoints, over the
  /// preferred speed; of the whole run, and from 60 s on.
  std::optional<double> flow = {}, late_flow = {};
};

/// Runs the scene on one thread. It ends early if all robots are at rest at their goals for good.
/// `record`: path of a CSV file, or empty. Throws Error for a bad scene, and std::runtime_error if
/// it cannot write. A scene with Scene::sensing is run by run_sensing.
Outcome run_scene(const Scene& scene, std::uint64_t seed, const std::string& record);

/// Runs the scene in a loop around Planner::plan. Every robot knows itself exactly, knows the
/// others as scene.sensing sets, and acts as scene.acting sets. It fills in all parts of an outcome
/// that concern the planner and the run.
void run_sensing(const Scene& scene, const std::string& record, Outcome& outcome);

/// Returns the CPU time of this thread, s: it does not count other programs.
double thread_seconds();

}  // namespace avo::safety
