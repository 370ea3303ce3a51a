// SPDX-License-Identifier: Apache-2.0
// One scene from its start to its end: what it did, what its decisions were and cost.
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
/// More than there are kinds of PlanStatus.
inline constexpr std::size_t kMostStatuses = 16;

struct Outcome {
  std::uint64_t seed = 0;
  Verdict verdict;
  PlannerOptions planner;  ///< what the robots planned with
  bool promised = true;    ///< whether their certificate, if any, covers how they sense
  std::int64_t robot_steps = 0;
  std::vector<double> arrival;      ///< s, of each robot: first within arrival_distance; kNever
  std::int64_t at_goal_at_end = 0;  ///< robots within arrival_distance
  double unit = 0.0, limit = 0.0, share = 0.0;             ///< see Scene
  double duration = 0.0;                                   ///< s, of the scene
  std::array<std::int64_t, kMostStatuses> decisions = {};  ///< robot-steps by PlanStatus
  double seconds = 0.0;                                    ///< CPU time in Simulation::step
  double worst_second = 0.0;  ///< CPU s a robot-step over the worst second simulated
  double density = 0.0;       ///< see densest_disc, the most
  /// s, of scenes with Scene::until_rest: since when nobody has moved; kNever where somebody has
  /// till the end
  std::optional<double> rest = {};
  /// Of scenes with Scene::flow: mean velocity towards where robots want to go, over the preferred;
  /// of the whole run, and from 60 s on.
  std::optional<double> flow = {}, late_flow = {};
};

/// On one thread. Ends early where all are at rest at their goals for good. `record`: path of a CSV
/// file, or empty. Throws Error on a bad scene, std::runtime_error where it cannot write.
/// A scene with Scene::sensing goes its own way, see run_sensing.
Outcome run_scene(const Scene& scene, std::uint64_t seed, const std::string& record);

/// The scene in a loop around Planner::plan: every robot knows itself exactly, knows the others as
/// scene.sensing tells, and acts as scene.acting tells. Fills in all of an outcome that the planner
/// and the run have to do with.
void run_sensing(const Scene& scene, const std::string& record, Outcome& outcome);

/// CPU time of this thread, s: what counts where other programs run as well.
double thread_seconds();

}  // namespace avo::safety
