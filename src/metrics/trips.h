// SPDX-License-Identifier: Apache-2.0
// Trips of robots, from where each is first seen with a goal until it first arrives there
// (docs/metrics.md).
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "avo/metrics.h"

namespace avo::inline metrics {

/// The sorted values' one that more than the share of them does not exceed; 0 <= share < 1, and
/// there is one. Orders the values anew.
double quantile(std::span<double> values, double share);

/// Of the preferred speed: no faster is no motion.
inline constexpr double kMoves = 0.01;

/// One robot's. Trips whose goal is changed under way begin anew there.
struct Trip {
  std::uint64_t robot = 0;
  std::optional<double> arrival = {};  // s
  bool parked = false;
  bool overlapped = false;           // before it arrived; a moving obstacle ever
  double begin = 0.0;                // s
  double end = 0.0;                  // s, so far
  Vec2 goal = {};                    // m
  double ideal_time = 0.0;           // s
  double preferred_speed = 0.0;      // m/s
  double step = 0.0;                 // s, of its own
  double way = 0.0, way_left = 0.0;  // m, at the beginning and now
  double progress = 0.0;             // m, what was left when it last made some
  double acceleration_limit = 0.0;   // [a_max] m/s^2, of its motion model

  Vec2 position = {}, velocity = {};      // m, m/s, as last seen
  Vec2 acceleration = {}, directed = {};  // m/s^2, of the last step; the last with a direction
  double length = 0.0;                    // m, gone
  double effort = 0.0;                    // m^2/s^3
  double jerk_squared = 0.0;              // sum over steps but the first, (m/s^3)^2
  double jerk_steps = 0.0;                // how many
  double deadlock_time = 0.0;             // s
  std::int64_t reversals = 0;
  std::int64_t moving_steps = 0, turned_back = 0;  // of its own steps but the first
  bool has_acceleration = false;
};

/// A step on, of that duration, s, > 0, to where so much of the way is left, m. By clocks of their
/// own it is a part of the robot's own step: the first one where the robot decided.
void go_on(Trip& trip, Vec2 position, Vec2 velocity, double way_left, double duration,
           bool decided);

/// Of every robot that ever was, by ascending id.
class Trips {
 public:
  /// judged: whose trips describe() and all_arrived() are of; empty: all.
  explicit Trips(const Scenario& scenario, std::span<const RobotId> judged = {});

  /// After a step of that duration, s, or before the first one.
  void observe(const Simulation& simulation, const FleetView& fleet, double duration);
  /// That the robots overlapped whom they avoid in the step that was just observed.
  void add_overlaps(std::span<const std::uint64_t> robots);
  /// That moving obstacles touched them then, on their trips or at their goals.
  void add_touched(std::span<const std::uint64_t> robots);

  [[nodiscard]] std::span<const Trip> all() const { return trips_; }
  [[nodiscard]] bool all_arrived() const;
  [[nodiscard]] bool is_judged(std::uint64_t robot) const;
  /// Whether the trip of that robot went on in the last step, and it is judged.
  [[nodiscard]] bool is_under_way(std::uint64_t robot) const;
  /// s; none where it has not arrived, or was never seen.
  [[nodiscard]] std::optional<double> arrival(std::uint64_t robot) const;
  /// Writes what trips tell into the metrics.
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
