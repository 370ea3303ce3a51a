// SPDX-License-Identifier: Apache-2.0
// Trips of robots: each lasts from the time when the robot is first seen with a goal until it first
// arrives there (docs/metrics.md).
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "avo/metrics.h"

namespace avo::inline metrics {

/// The value among the sorted values that more than the share of them does not exceed; 0 <= share <
/// 1, and there must be a value. It reorders the values.
double quantile(std::span<double> values, double share);

/// Part of the preferred speed: a slower robot is not in motion.
inline constexpr double kMoves = 0.01;

/// The trip of one robot. If its goal changes during the trip, the trip begins anew there.
struct Trip {
  std::uint64_t robot = 0;
  std::optional<double> arrival = {};  // s
  bool parked = false;
  bool overlapped = false;           // before it arrived; a moving obstacle at any time
  double begin = 0.0;                // s
  double end = 0.0;                  // s, so far
  Vec2 goal = {};                    // m
  double ideal_time = 0.0;           // s
  double preferred_speed = 0.0;      // m/s
  double step = 0.0;                 // s, of the robot itself
  double way = 0.0, way_left = 0.0;  // m, route length at the beginning and now
  double progress = 0.0;             // m, route length left when it last made progress
  double acceleration_limit = 0.0;   // [a_max] m/s^2, of its motion model

  Vec2 position = {}, velocity = {};      // m, m/s, as last seen
  Vec2 acceleration = {}, directed = {};  // m/s^2, of the last step; the last one with a direction
  double length = 0.0;                    // m, of its path so far
  double effort = 0.0;                    // m^2/s^3
  double jerk_squared = 0.0;              // sum over all steps except the first, (m/s^3)^2
  double jerk_steps = 0.0;                // number of these steps
  double deadlock_time = 0.0;             // s
  std::int64_t reversals = 0;
  std::int64_t moving_steps = 0, turned_back = 0;  // of its own steps except the first
  bool has_acceleration = false;
};

/// Advances the trip by a step of that duration, s, > 0, after which that length of the route is
/// left, m. With free clocks it is a part of the robot's own step: the first part where the robot
/// decided.
void go_on(Trip& trip, Vec2 position, Vec2 velocity, double way_left, double duration,
           bool decided);

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
  [[nodiscard]] bool is_under_way(std::uint64_t robot) const;
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
