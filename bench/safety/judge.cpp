// SPDX-License-Identifier: Apache-2.0
// Whether a run was safe: what Metrics saw of it.
#include "judge.h"

#include "avo/metrics.h"

namespace avo::safety {

struct Judge::State {
  Metrics metrics;
  std::int64_t accelerations = 0, speeds = 0;
};

Judge::Judge(const Scenario& scenario) : state_(new State{Metrics(scenario)}) {}
Judge::~Judge() = default;

void Judge::observe(const Simulation& simulation) {
  state_->metrics.observe(simulation);
  constexpr double kTolerance = 1.0 + 1e-9;
  const FleetView fleet = simulation.fleet();
  for (std::size_t i = 0; i < fleet.id.size(); ++i) {
    const RobotSetup& setup = fleet.setup[i];
    if (fleet.applied_acceleration[i] > kTolerance * setup.max_acceleration) {
      ++state_->accelerations;
    }
    if (norm(fleet.velocity[i]) > kTolerance * setup.max_speed) ++state_->speeds;
  }
}

Verdict Judge::verdict() const {
  const RunSummary summary = state_->metrics.summary();
  Verdict verdict;
  verdict.overlapping_pairs = summary.collision_pairs;
  verdict.moving_contacts = summary.obstacle_collisions;
  verdict.acceleration_violations = state_->accelerations;
  verdict.speed_violations = state_->speeds;
  verdict.least_clearance = summary.min_clearance;
  if (summary.first_collision_time) {
    verdict.first = "first overlap at " + std::to_string(*summary.first_collision_time) + " s";
  }
  return verdict;
}

}  // namespace avo::safety
