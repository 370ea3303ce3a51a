// SPDX-License-Identifier: Apache-2.0
// One decision of a robot in space, and what it followed from: the output of `avo explain`.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "avo/export.h"
#include "avo/space/simulation.h"

namespace avo_io {

/// The soft half-space of a neighbor, normal . v' >= offset, Eqs. (15) to (20) in space.
struct NeighborHalfSpace {
  int neighbor = 0;     ///< index into SpaceDecision::neighbors
  avo::Vec3 normal;     ///< unit
  double offset = 0.0;  ///< m/s
};

/// A neighbor or a box that limits a decision, by its position in the lists of SpaceDecision.
struct SpaceCause {
  int neighbor = -1;
  int box = -1;

  friend bool operator==(const SpaceCause&, const SpaceCause&) = default;
};

/// All facts about one decision.
struct SpaceDecision {
  std::string scene;
  std::int64_t robot = 0;
  double time = 0.0;  ///< s
  avo::Vec3 goal;     ///< m
  bool is_at_goal = false;
  avo::space::Robot self;                       ///< as it decides, with its preferred velocity
  std::vector<avo::space::Neighbor> neighbors;  ///< within the sensing radius, nearest first
  std::vector<std::int64_t> numbers;            ///< of the neighbors in the scene
  std::vector<avo::space::Box> boxes;           ///< within its range
  std::vector<std::int64_t> obstacles;          ///< of the boxes: the numbers in the scene
  std::vector<NeighborHalfSpace> half_spaces;   ///< of the neighbors
  avo::Vec3 proposal;                           ///< m/s: next velocity without the certificate
  /// Neighbors without which the proposal would be another one: those with half-spaces that the
  /// preferred velocity breaks, and those that the rules for arriving heed.
  std::vector<SpaceCause> binding, heeded;
  std::vector<SpaceCause> refusing;  ///< for which the certificate refuses the proposal
  avo::space::Plan plan;
  std::string sentence;  ///< the decision in words
};

/// Steps to the last decision of the robot by `time`, s, and explains it. Where go_on() is given,
/// it is asked before each step; the result is none where it returns false. Throws Error unless the
/// scene has that robot, and lasts until `time`.
AVO_API std::optional<SpaceDecision> explain_in_space(
    const avo::space::Scenario& scenario, std::int64_t robot, double time, int threads = 0,
    const std::function<bool(double time)>& go_on = {});

/// Takes the next step, and explains the robot's decision in it. Throws as explain_in_space().
AVO_API SpaceDecision explain_step(avo::space::Simulation& simulation, std::int64_t robot);

/// Returns one line for each fact.
AVO_API std::string readable(const SpaceDecision& decision);
/// Returns one JSON object (docs/space.md).
AVO_API std::string to_json(const SpaceDecision& decision);

}  // namespace avo_io
