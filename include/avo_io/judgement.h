// SPDX-License-Identifier: Apache-2.0
// A recording judged, whoever made it: what `avo check` says.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "avo/check.h"
#include "avo/export.h"
#include "avo/scenario.h"

namespace avo_io {

/// What the robots are held to: what a scene says of them or, without one, these four for all. They
/// also do where the scene has no robots, and tells of walls and of moving obstacles alone.
struct JudgeOptions {
  std::optional<avo::Scenario> scenario = {};
  double radius = 0.0;  ///< m, > 0, without a scene
  /// m/s^2, > 0, likewise; unset: nobody knows it. Accelerations are not judged then, and jumps by
  /// avo::CheckedRobot::largest_jump: a tenth of the radius, all of it where velocities are
  /// estimated.
  std::optional<double> max_acceleration = {};
  std::optional<double> max_speed = {};    ///< m/s, > 0, likewise; unset: speeds are not judged
  std::optional<double> max_braking = {};  ///< m/s^2, > 0, likewise; unset: max_acceleration
  double tolerance = 1e-9;                 ///< see avo::CheckOptions::relative_tolerance
  bool require_arrival = false;            ///< at the goals of the scene
  bool movers_at_rest = false;             ///< see avo::CheckOptions
  /// Called with each time of the recording, s, once it is judged.
  std::function<void(double time)> judged = {};
};

/// What is found of a recording, and what it was held to.
struct Judgement {
  avo::CheckReport report;
  std::string recording;
  std::optional<std::string> scene;
  std::optional<double> time_step;             ///< s, of the scene
  std::vector<std::int64_t> numbers;           ///< of the robots by index; empty: their indices
  std::vector<std::int64_t> obstacle_of_wall;  ///< number of the static obstacle
  double tolerance = 0.0;
  std::int64_t uneven_steps = 0;   ///< not time_step long
  std::int64_t uneven_judged = 0;  ///< of them, those that lack no rows
  std::int64_t every = 1;          ///< the recording has rows of every so many steps, as it says
  bool require_arrival = false;
  bool free_clocks = false;                              ///< in the scene
  bool knows_accelerations = true, knows_speeds = true;  ///< the limits, which are judged then
  bool estimated = false;                                ///< the velocities, see RecordedTime
  /// Robots of the scene, ascending, that have no row at the first time or at the last one; but for
  /// airplanes that left where they arrived.
  std::vector<std::int64_t> lacking;
  /// From the start of the scene to its end, or to a time at which all have arrived; what is not
  /// there is not judged. Without a scene nobody knows its start and end.
  bool whole = true;
  double scene_end = 0.0;  ///< s, the duration of the scene

  [[nodiscard]] bool passed() const {
    return safe() && (!require_arrival || report.arrived == report.with_goal);
  }
  /// No rule is broken, and nobody's rows are missing.
  [[nodiscard]] bool safe() const { return report.safe() && report.gaps == 0 && lacking.empty(); }
  /// Rows are missing, of all robots or of one, and those that are there break no rule.
  [[nodiscard]] bool incomplete() const { return !report.broken() && !safe(); }
};

/// Judges the recording in that file; "-" is the standard input. Throws FileError, RecordingError,
/// and Error on options out of range.
AVO_API Judgement judge(const std::string& recording, const JudgeOptions& options);

/// A short table.
AVO_API std::string readable(const Judgement& judgement);
/// One JSON object, keys in a fixed order; what there is not is null.
AVO_API std::string to_json(const Judgement& judgement);

}  // namespace avo_io
