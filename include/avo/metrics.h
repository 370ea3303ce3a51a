// SPDX-License-Identifier: Apache-2.0
// Measures of a run: arrivals, clearance in continuous time, limits. An observer of a simulation.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "avo/export.h"
#include "avo/simulation.h"

namespace avo {

/// Robot-steps by how they were decided, see PlanStatus.
struct Decisions {
  std::int64_t optimal = 0;
  std::int64_t least_unsafe = 0;
  std::int64_t refused = 0;
  std::int64_t braking = 0;
  std::int64_t overlapping = 0;
  std::int64_t invalid_input = 0;
  std::int64_t detour = 0;
};

/// A robot that was never at its goal (Simulation::is_at_goal()), in its state at the end of the
/// run.
struct NotArrived {
  std::uint64_t robot = 0;                  ///< RobotId
  double distance = 0.0;                    ///< m, to its goal
  double speed = 0.0;                       ///< m/s
  PlanStatus status = PlanStatus::optimal;  ///< status of its last decision
  double detour_angle = 0.0;                ///< rad, see Detour
  /// The neighbors that hold the robot, nearest first, five at most: each is no more than 0.15 of
  /// both radii from touching the robot. An entry is the value of a RobotId, or -1 - k with the
  /// value k of a MovingObstacleId.
  /// The robot that it waits for at a passage comes last.
  std::vector<std::int64_t> held_by;
  /// m, see Simulation::Wait; none where the robot waits at no passage
  std::optional<Vec2> passage = {};
  /// m, from the nearest place that the robot can reach to its goal, see Simulation::Route. 0: it
  /// can reach the goal.
  double distance_left = 0.0;
};

/// Metrics by published definitions: docs/metrics.md has the formulas and their sources. A trip
/// belongs to a robot that is not parked. It lasts from the time when the robot is first seen with
/// a goal until it first arrives, or to the end of the run. A metric without data is unset.
struct RunMetrics {
  std::int64_t trips = 0;
  std::int64_t collision_robot_steps = 0;  ///< with another robot, as in collision_pairs
  double overlap_depth = 0.0;              ///< the deepest, as a part of r_A + r_B; 0: none
  std::optional<double> success;           ///< share of trips: no overlap, within 3 ideal times
  std::optional<double> collision;         ///< share of trips with an overlap
  std::optional<double> timeout;           ///< share of the other trips
  /// s, excess of the duration of trips that end over their ideal times
  std::optional<double> extra_time_mean;
  std::optional<double> extra_time_p75;
  std::optional<double> extra_time_p90;
  std::optional<double> flowtime;  ///< s, sum of all trips' times; only if all have arrived
  /// mean over trips that end: length divided by the length of the shortest route
  std::optional<double> path_ratio;
  std::optional<double> effort;            ///< m^2/s^3, mean of the trips' integrals of |a|^2
  std::optional<double> acceleration_rms;  ///< |a|/a_max, root mean square over all trips' time
  std::optional<double> jerk;              ///< m/s^3, root mean square over all trips' steps
  std::optional<double> reversals;         ///< of the acceleration, mean number a trip
  /// Share of the steps in motion in which the acceleration turned by more than 135 degrees from
  /// the step before, both of more than 0.3 a_max.
  std::optional<double> turned_back;
  /// mean speed along the route, divided by the preferred speed
  std::optional<double> efficacy;
  std::optional<double> deadlock_time;  ///< s, mean time a trip without progress
  std::optional<double> step_ms_p50;    ///< ms, duration of a step
  std::optional<double> step_ms_p99;
  // Set with MetricsOptions::crowd:
  std::optional<double> danger;             ///< share of the trips' time nearer than 0.2 m
  std::optional<double> danger_separation;  ///< m, mean separation during that time
  std::optional<double> order;              ///< 0 to 1: how much all go in one direction
  std::optional<double> density_mean;       ///< 1/m^2, of the robots' Voronoi cells
  std::optional<double> density_max;
  // Set with MetricsOptions::line:
  std::optional<double> flow;  ///< 1/s, across the line
  /// 1/(m s), flow divided by the length of the line
  std::optional<double> specific_flow;
  std::optional<std::vector<double>> crossing_times;  ///< s, ascending: the N-t curve
  friend bool operator==(const RunMetrics&, const RunMetrics&) = default;
};

/// The results of a run; a result without data is unset.
struct RunSummary {
  std::string scene;
  std::int64_t robots = 0;
  std::int64_t parked = 0;  ///< parked robots among them; they have arrived where they stand
  std::int64_t steps = 0;
  std::int64_t arrived = 0;                    ///< robots that were ever at their goals
  std::optional<double> first_collision_time;  ///< s, between robots
  /// Distinct pairs of robots that ever overlapped and that avoid each other.
  std::int64_t collision_pairs = 0;
  /// distinct pairs in which only one robot avoids the other
  std::int64_t one_sided_collisions = 0;
  /// Pairs that did in a step in which the one that avoids the other moved.
  std::int64_t one_sided_collisions_in_motion = 0;
  std::int64_t mover_collisions = 0;  ///< distinct (robot, moving obstacle) pairs
  /// The pairs among them that overlapped in a step in which the robot moved. In any other pair the
  /// obstacle ran into a robot at rest, which no robot can prevent.
  std::int64_t mover_collisions_in_motion = 0;
  /// The pairs among them in which the robot had an evasive maneuver when it first sensed the
  /// obstacle (Planner::has_evasive_maneuver(), docs/metrics.md); none without a certificate.
  std::optional<std::int64_t> mover_collisions_evadable;
  std::int64_t static_collisions = 0;   ///< distinct robots that touched a static obstacle
  std::optional<double> min_clearance;  ///< m, of robots that avoid each other, if any do
  /// m, from static obstacles; none without obstacles
  std::optional<double> min_static_clearance;
  /// Pairs in which one robot came into the other's sight after the start, when braking was no
  /// longer proved to keep them apart. None without a certificate. With a sufficient sensing radius
  /// this takes occlusion, or measurements that fail.
  std::optional<std::int64_t> first_seen_too_late;
  /// m/s^2, the largest applied |a|. With Scenario::execution it is the largest change of a body's
  /// velocity over a step, by the step's length.
  double max_acceleration = 0.0;
  double acceleration_excess = 0.0;        ///< m/s^2, the largest |a| - max(a_max, b); 0 if kept
  double max_speed = 0.0;                  ///< m/s
  std::optional<double> mean_arrival;      ///< s, over robots that arrived and are not parked
  std::optional<double> last_arrival;      ///< s, only if all arrived
  std::int64_t infeasible_steps = 0;       ///< robot-steps with an empty set CA_A
  Decisions decisions;                     ///< over all robot-steps
  std::vector<NotArrived> not_arrived;     ///< robots that are still present, by id; 100 at most
  std::vector<std::uint64_t> unreachable;  ///< RobotIds, see Simulation::unreachable()
  std::optional<double> step_milliseconds_median;
  RunMetrics metrics;
  std::uint64_t seed = 0;
};

/// A straight line on the ground; robots that cross it are counted.
struct MeasuringLine {
  Vec2 a, b;  ///< m, its ends: for a door from one jamb to the other
};

/// Further measurements, which cost time.
struct MetricsOptions {
  bool crowd = false;  ///< danger, order and density: a search for neighbors a robot a step
  std::optional<MeasuringLine> line = {};
  /// RunMetrics covers the trips of these robots, and all_arrived() tells about them; empty: all
  /// robots.
  std::vector<RobotId> judged = {};
};

/// Call observe() once before the first step and once after every step, before robots or static
/// obstacles are edited. Each step is judged among the obstacles of the observed simulation.
class AVO_API Metrics {
 public:
  /// Throws Error on a line with ends that are not two points.
  explicit Metrics(const Scenario& scenario, const MetricsOptions& options = {});
  ~Metrics();
  void observe(const Simulation& simulation);
  void add_step_time(double milliseconds);
  /// Returns whether every robot that was ever present, or that is judged, has arrived, each at its
  /// own time. For all robots RunSummary::arrived is then RunSummary::robots.
  [[nodiscard]] bool all_arrived() const;
  [[nodiscard]] RunSummary summary() const;

 private:
  struct AVO_LOCAL State;
  std::unique_ptr<State> state_;
};

}  // namespace avo
