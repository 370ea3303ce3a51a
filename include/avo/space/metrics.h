// SPDX-License-Identifier: Apache-2.0
// Measures of a run in space: the keys and definitions of avo/metrics.h.
#pragma once
#include <memory>

#include "avo/export.h"
#include "avo/metrics.h"
#include "avo/space/check.h"
#include "avo/space/simulation.h"

namespace avo::space {

/// The bodies and limits of the robots as a judge takes them, with their goals.
AVO_API std::vector<CheckedRobot> checked_robots(const Scenario& scenario);

/// The moving obstacles as a judge takes them.
AVO_API std::vector<CheckedMover> checked_movers(const Scenario& scenario);

/// Their states at that time, s.
AVO_API std::vector<CheckedState> mover_states(const Scenario& scenario, double time);

/// Observes a run. A result that space does not have is unset.
class AVO_API Metrics {
 public:
  explicit Metrics(const Scenario& scenario);
  ~Metrics();
  Metrics(Metrics&&) noexcept;
  Metrics& operator=(Metrics&&) noexcept;

  /// Call it before the first step, and after each.
  void observe(const Simulation& simulation);
  /// ms, the duration of a step.
  void add_step_time(double milliseconds);
  [[nodiscard]] bool all_arrived() const;
  [[nodiscard]] RunSummary summary() const;

 private:
  struct AVO_LOCAL State;
  std::unique_ptr<State> state_;
};

}  // namespace avo::space
