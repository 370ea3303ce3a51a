// SPDX-License-Identifier: Apache-2.0
// Trips of robots: each lasts from the time when the robot is first seen with a goal, and may set
// out, until it first arrives there (docs/metrics.md).
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "avo/metrics.h"
#include "metrics/trip.h"

namespace avo::inline metrics {

/// The trips of all robots that were ever present, by ascending id.
class Trips {
 public:
  /// judged: the robots that describe() and all_arrived() cover; empty: all.
  explicit Trips(const Scenario& scenario, std::span<const RobotId> judged = {});

  /// Call it after a step of that duration, s, or before the first one.
  void observe(const Simulation& simulation, const FleetView& fleet, double duration);
  /// Notes that the robots overlapped robots that they avoid in the last observed step.
  void add_overlaps(std::span<const std::uint64_t> robots);
  /// Notes that moving obstacles touched them then, on their trips or at their goals.
  void add_touched(std::span<const std::uint64_t> robots);

  [[nodiscard]] std::span<const Trip> all() const { return trips_; }
  [[nodiscard]] bool all_arrived() const;
  [[nodiscard]] bool is_judged(std::uint64_t robot) const;
  /// Returns whether the trip of that robot went on in the last step, and is judged.
  [[nodiscard]] bool is_travelling(std::uint64_t robot) const;
  /// s; none if it has not arrived, or was never seen.
  [[nodiscard]] std::optional<double> arrival(std::uint64_t robot) const;
  /// Writes the results of the trips into the metrics.
  void describe(RunMetrics& metrics) const;

 private:
  [[nodiscard]] std::size_t find(std::uint64_t robot, std::size_t from) const;

  double step_ = 0.0, arrival_distance_ = 0.0;  // s, m
  double now_ = 0.0;                            // s
  std::vector<Trip> trips_;
  std::vector<std::uint64_t> judged_;  // ids, ascending
  std::size_t arrived_ = 0;
};

}  // namespace avo::inline metrics
