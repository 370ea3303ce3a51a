// SPDX-License-Identifier: Apache-2.0
// What a run did: arrivals, clearance in continuous time, limits. An observer of a simulation.
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
  std::int64_t candidate = 0;
  std::int64_t braking = 0;
  std::int64_t overlapping = 0;
  std::int64_t invalid_input = 0;
};

/// A robot that was never at its goal (Simulation::is_at_goal()), as it is at the end of the run.
struct NotArrived {
  std::uint64_t robot = 0;                  ///< RobotId
  double distance = 0.0;                    ///< m, to its goal
  double speed = 0.0;                       ///< m/s
  PlanStatus status = PlanStatus::optimal;  ///< of its last decision
  double detour = 0.0;                      ///< rad, see Detour
  /// Nearest first: who is no more than 0.15 of both radii from touching it, by RobotId, or -1 - k
  /// for moving obstacle k, five at most; then the robot that it waits for at a passage.
  std::vector<std::int64_t> held_by;
  std::optional<Vec2> passage = {};  ///< m, see Simulation::Wait; none where it waits at none
  /// m, from the nearest place that it can reach to its goal, see Simulation::Way; 0: it can.
  double distance_left = 0.0;
};

/// By published definitions: docs/metrics.md has the formulas and their sources. A trip is that of
/// a robot that is not parked, from where it is first seen with a goal until it first arrives, or
/// to the end of the run. What there is nothing to say of is unset.
struct RunMetrics {
  std::int64_t trips = 0;
  std::int64_t collision_robot_steps = 0;  ///< with another robot, as in collision_pairs
  double overlap_depth = 0.0;              ///< the deepest, as a part of r_A + r_B; 0: none
  std::optional<double> success;           ///< share of trips: no overlap, within 3 ideal times
  std::optional<double> collision;         ///< share of trips with an overlap
  std::optional<double> timeout;           ///< share of the others
  std::optional<double> extra_time_mean;   ///< s, of trips that end over their ideal times
  std::optional<double> extra_time_p75;
  std::optional<double> extra_time_p90;
  std::optional<double> flowtime;          ///< s, sum of all trips' times; only if all have arrived
  std::optional<double> path_ratio;        ///< mean over trips that end: length by the shortest way
  std::optional<double> effort;            ///< m^2/s^3, mean of the trips' integrals of |a|^2
  std::optional<double> acceleration_rms;  ///< |a|/a_max, root mean square over all trips' time
  std::optional<double> jerk;              ///< m/s^3, root mean square over all trips' steps
  std::optional<double> reversals;         ///< of the acceleration, mean number a trip
  /// Share of the steps in motion whose acceleration is more than 135 degrees from that of the step
  /// before, both of more than 0.3 a_max.
  std::optional<double> turned_back;
  std::optional<double> efficacy;       ///< mean speed along the way by the preferred speed
  std::optional<double> deadlock_time;  ///< s, mean time a trip without progress
  std::optional<double> step_ms_p50;    ///< ms, what a step took
  std::optional<double> step_ms_p99;
  // with MetricsOptions::crowd
  std::optional<double> danger;             ///< share of the trips' time nearer than 0.2 m
  std::optional<double> danger_separation;  ///< m, mean then
  std::optional<double> order;              ///< 0 to 1: how much all go in one direction
  std::optional<double> density_mean;       ///< 1/m^2, of the robots' Voronoi cells
  std::optional<double> density_max;
  // with MetricsOptions::line
  std::optional<double> flow;                         ///< 1/s, across the line
  std::optional<double> specific_flow;                ///< 1/(m s), by its length
  std::optional<std::vector<double>> crossing_times;  ///< s, ascending: the N-t curve
  friend bool operator==(const RunMetrics&, const RunMetrics&) = default;
};

/// The results of a run; what there is nothing to say of is unset.
struct RunSummary {
  std::string scene;
  std::int64_t robots = 0;
  std::int64_t parked = 0;  ///< of them; they have arrived where they stand
  std::int64_t steps = 0;
  std::int64_t arrived = 0;                    ///< robots that were ever at their goals
  std::optional<double> first_collision_time;  ///< s, of robots with each other
  /// Distinct pairs of robots that ever overlapped, of which both avoid the other.
  std::int64_t collision_pairs = 0;
  std::int64_t one_sided_collisions = 0;  ///< and those of which only one avoids the other
  std::int64_t obstacle_collisions = 0;   ///< distinct (robot, moving obstacle) pairs
  /// Those of them that overlapped in a step in which the robot moved. Any others ran into a robot
  /// at rest, which no robot can help.
  std::int64_t obstacle_collisions_in_motion = 0;
  /// Those of them in which the robot had a way out when it came to sense the obstacle
  /// (Planner::has_way_out(), docs/metrics.md); none without a certificate.
  std::optional<std::int64_t> obstacle_collisions_evadable;
  std::int64_t collision_obstacles = 0;          ///< distinct robots that touched a static obstacle
  std::optional<double> min_clearance;           ///< m, of robots that avoid each other, if any do
  std::optional<double> min_obstacle_clearance;  ///< m, from static obstacles; none without them
  /// Pairs of which one came into the other's sight after the start when braking was no longer
  /// proved to keep them apart; none without a certificate. Past a sensing radius that suffices it
  /// takes occlusion, or measurements that fail.
  std::optional<std::int64_t> first_seen_too_late;
  double max_acceleration = 0.0;           ///< m/s^2, the largest applied |a|
  double acceleration_excess = 0.0;        ///< m/s^2, the largest |a| - max(a_max, b); 0 if kept
  double max_speed = 0.0;                  ///< m/s
  std::optional<double> mean_arrival;      ///< s, over those that arrived and are not parked
  std::optional<double> last_arrival;      ///< s, only if all arrived
  std::int64_t infeasible_steps = 0;       ///< robot-steps whose set CA_A was empty
  Decisions decisions;                     ///< of all robot-steps
  std::vector<NotArrived> not_arrived;     ///< of those still there, by id; 100 at most
  std::vector<std::uint64_t> unreachable;  ///< RobotIds, see Simulation::unreachable()
  std::optional<double> step_milliseconds_median;
  RunMetrics metrics;
  std::uint64_t seed = 0;
};

/// A straight line on the ground, of which robots are counted that cross it.
struct MeasuringLine {
  Vec2 a, b;  ///< m, its ends: of a door from one jamb to the other
};

/// What is measured besides, and costs time.
struct MetricsOptions {
  bool crowd = false;  ///< danger, order and density: a search for neighbors a robot a step
  std::optional<MeasuringLine> line = {};
  /// Whose trips RunMetrics is of, and all_arrived() tells about; empty: those of all robots.
  std::vector<RobotId> judged = {};
};

/// Call observe() once before the first step and once after every step, before robots or static
/// obstacles are edited: each step is judged among the obstacles of the simulation observed.
class AVO_API Metrics {
 public:
  /// Throws Error on a line whose ends are not two points.
  explicit Metrics(const Scenario& scenario, const MetricsOptions& options = {});
  ~Metrics();
  void observe(const Simulation& simulation);
  void add_step_time(double milliseconds);
  /// Whether every robot that ever was, or that is judged, has arrived, each at its own time: of
  /// all of them RunSummary::arrived is RunSummary::robots.
  [[nodiscard]] bool all_arrived() const;
  [[nodiscard]] RunSummary summary() const;

 private:
  struct AVO_LOCAL State;
  std::unique_ptr<State> state_;
};

}  // namespace avo
