// SPDX-License-Identifier: Apache-2.0
// What a run did: arrivals, clearance in continuous time, limits. An observer of a simulation.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "avo/simulation.h"

namespace avo {

struct RunSummary {
  std::string scene;
  std::int64_t robots = 0;
  std::int64_t steps = 0;
  std::int64_t arrived = 0;                    ///< robots that were ever within arrival_distance
  std::optional<double> first_collision_time;  ///< s, of robots with each other
  std::int64_t collision_pairs = 0;            ///< distinct pairs of robots that ever overlapped
  std::int64_t obstacle_collisions = 0;        ///< distinct (robot, moving obstacle) pairs
  std::optional<double> min_clearance;         ///< m, of robots; none with fewer than two
  double max_acceleration = 0.0;               ///< m/s^2, the largest applied |a|
  double acceleration_excess = 0.0;            ///< m/s^2, the largest |a| - a_max; 0 if kept
  double max_speed = 0.0;                      ///< m/s
  std::optional<double> mean_arrival;          ///< s, over those that arrived
  std::optional<double> last_arrival;          ///< s, only if all arrived
  std::int64_t infeasible_steps = 0;           ///< robot-steps whose set CA_A was empty
  std::optional<double> step_milliseconds_median;
  std::uint64_t seed = 0;
};

/// Call observe() once before the first step and once after every step.
class Metrics {
 public:
  explicit Metrics(const Scenario& scenario);
  ~Metrics();
  void observe(const Simulation& simulation);
  void add_step_time(double milliseconds);
  [[nodiscard]] RunSummary summary() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace avo
