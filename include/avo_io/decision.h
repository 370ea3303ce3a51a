// SPDX-License-Identifier: Apache-2.0
// One decision of a robot, and all its inputs: the output of `avo explain`.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "avo/decision_trace.h"
#include "avo/export.h"
#include "avo/simulation.h"

namespace avo_io {

/// All facts about one decision.
struct Decision {
  std::string scene;
  std::int64_t robot = 0;
  double time = 0.0;
  avo::Vec2 goal;
  avo::Method method{};
  bool has_own_method = false;  ///< a method other than the scene's
  /// Returns whether a certificate, or the rules of method avo, had a say.
  [[nodiscard]] bool is_certified() const {
    return avo::method_traits(method).has_rules || certificate != avo::Certificate::none;
  }
  avo::Simulation::Perception seen;
  bool by_half_planes = true;  ///< false: outside the union of the obstacles (§III-C)
  avo::HalfPlanes half_planes;
  std::vector<double> risks;  ///< for each neighbor seen, see Planner::half_plane_risk(); or none
  std::vector<avo::CertificateConstraint> constraints;
  avo::WallPlanes wall_planes;
  std::vector<avo::WallConstraint> wall_constraints;
  avo::Certificate certificate{};
  double response_time = 0.0;  ///< s, with which the robot approaches v'; 0: at once
  avo::Plan plan;
  std::optional<avo::Evasion> evasion;
  avo::DecisionTrace trace;  ///< the stages of the decision
  std::string sentence;      ///< the decision in words, see avo::Explanation
  avo::SafetyReport state;   ///< of the state in which it decides
  avo::Disc acceleration_disc, speed_disc;
};

/// Returns what the robot would decide now. `scene`: the name of the scene.
AVO_API Decision explain(const avo::Simulation& simulation, const std::string& scene,
                         avo::RobotId robot);

/// Throws Error unless the scene has that robot, it decides, and the scene lasts until `time`, s.
AVO_API void require_explainable(const avo::Scenario& scenario, std::int64_t robot, double time);
/// Steps to the last decision of the robot by `time`, s. Where go_on() is given, it is asked before
/// each step; the result is false where it returns false. Throws Error where there is no such
/// decision.
AVO_API bool approach_decision(const avo::Scenario& scenario, std::int64_t robot, double time,
                               avo::Simulation& simulation,
                               const std::function<bool()>& go_on = {});

/// Returns one line for each fact.
AVO_API std::string readable(const Decision& decision);
/// Returns one JSON object (docs/scenes.md).
AVO_API std::string to_json(const Decision& decision);

}  // namespace avo_io
