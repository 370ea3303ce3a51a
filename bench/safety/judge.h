// SPDX-License-Identifier: Apache-2.0
// Judges whether a run was safe.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "avo/check.h"
#include "avo/simulation.h"

namespace avo::safety {

struct Verdict {
  std::int64_t overlapping_pairs = 0;
  std::int64_t moving_contacts = 0;   ///< robots that touched an obstacle while they moved
  std::int64_t resting_contacts = 0;  ///< robots that an obstacle ran into while they stood
  std::int64_t static_contacts = 0;   ///< robots that touched a static obstacle
  /// robots of Scene::alone that could have kept clear, but were hit
  std::int64_t evadable_hits = 0;
  double deepest_contact = 0.0;                                    ///< m, for robots in motion
  std::int64_t acceleration_violations = 0, speed_violations = 0;  ///< robot-steps, robot-states
  std::int64_t jumps = 0;  ///< robot-steps whose positions do not follow the velocities
  std::int64_t kinematic_violations = 0;         ///< of headings, turns, gears, wheels, wings
  std::int64_t changes = 0;                      ///< of an acceleration, between two decisions
  std::optional<double> least_clearance;         ///< m, of two robots
  std::optional<double> least_static_clearance;  ///< m, of a robot and a static obstacle
  double interpolation_error = 0.0;  ///< m, the largest error of judged paths: see CheckReport
  std::string violations;            ///< in words, empty if there are none

  [[nodiscard]] bool safe() const {
    return overlapping_pairs + moving_contacts + static_contacts + evadable_hits +
               acceleration_violations + speed_violations + jumps + kinematic_violations +
               changes ==
           0;
  }
  /// Adds a later run of the same robots.
  void add(const Verdict& later);
};

/// Returns the least of the values that exist.
std::optional<double> least_of(std::optional<double> a, std::optional<double> b);

/// Call observe() once before the first step and once after every step.
class Judge {
 public:
  explicit Judge(const Scenario& scenario);
  ~Judge();
  void observe(const Simulation& simulation);
  void observe(double time, std::span<const CheckedState> rows);
  [[nodiscard]] Verdict verdict() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace avo::safety
