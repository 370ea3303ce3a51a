// SPDX-License-Identifier: Apache-2.0
// Makes a line of the table and a line of JSON from the outcomes of a row's scenes.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "run.h"

namespace avo::safety {

/// The results over all scenes of a row. Quantiles are over all robots of all scenes; a robot that
/// never arrives counts as infinitely late.
struct RowResult {
  std::string name;
  std::int64_t scenes = 0, robots = 0, robot_steps = 0;
  std::int64_t overlapping_pairs = 0, moving_contacts = 0, resting_contacts = 0,
               static_contacts = 0, evadable_hits = 0;
  double deepest_contact = 0.0;  ///< m, for robots in motion
  std::int64_t acceleration_violations = 0, speed_violations = 0, jumps = 0, changes = 0;
  std::int64_t kinematic_violations = 0;
  std::int64_t unsafe_scenes = 0;
  bool certified = false;  ///< whether a certificate rules out unsafe events
  std::optional<double> least_clearance, least_static_clearance;  ///< m
  double interpolation_error = 0.0;  ///< m, the largest error of the judged paths
  bool has_goals = true;
  std::int64_t arrived = 0, at_goal_at_end = 0;  ///< robots
  std::int64_t full_scenes = 0;                  ///< scenes in which all arrive
  std::int64_t fewest_arrived = 0;               ///< of the scenes, robots
  double median_last = 0.0;  ///< s, of the scenes' last arrivals; never counts as their duration
  double mean = 0.0;         ///< s, of the robots that arrive
  double last = 0.0, late = 0.0;                ///< s: the last arrival, and the 99 % quantile
  double last_ratio = 0.0, late_ratio = 0.0;    ///< the same in the scenes' units
  double limit = 0.0;                           ///< units
  double median_ratio = 0.0, high_ratio = 0.0;  ///< of the last arrivals, and the 95 % quantile
  std::int64_t resting_scenes = 0;              ///< scenes in which no robot moves at the end
  /// s, since no robot has moved; never counts as the duration
  std::optional<double> median_rest, last_rest;
  std::optional<double> longest_to_rest;        ///< s, after the last arrival of a scene
  std::optional<double> mean_flow, least_flow;  ///< of the scenes, see Outcome::flow
  std::optional<double> mean_late_flow, least_late_flow;
  std::int64_t late_scenes = 0;  ///< scenes in which too few arrived within the limit
  std::array<std::int64_t, kMostStatuses> decisions = {};
  double microseconds = 0.0, worst_microseconds = 0.0;  ///< CPU, per robot-step
  double density = 0.0;
};

/// Returns s; kNever if a robot does not arrive.
double last_arrival(const Outcome& outcome);

RowResult summarize(const std::string& name, const std::vector<Outcome>& outcomes);

std::string table_header();
/// Returns the line of the table and its additional lines.
std::string table_lines(const RowResult& row);
/// Returns one line for each scene that failed, with the command that repeats it.
std::string failure_lines(const RowResult& row, const std::vector<Outcome>& outcomes,
                          const std::string& settings);
/// Returns one line.
std::string json_line(const RowResult& row, const std::vector<Outcome>& outcomes);

}  // namespace avo::safety
