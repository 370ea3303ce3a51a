// SPDX-License-Identifier: Apache-2.0
// The judgement of a recording of any origin: the output of `avo check`.
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

/// The limits of the robots: those of a scene or, without one, these four for all. The four also
/// apply where the scene has no robots, and gives walls and moving obstacles alone.
struct JudgeOptions {
  std::optional<avo::Scenario> scenario = {};
  double radius = 0.0;  ///< m, > 0, without a scene
  /// m/s^2, > 0, without a scene; unset: it is unknown. Accelerations are not judged then. Jumps
  /// are judged by avo::CheckedRobot::largest_jump: a tenth of the radius, all of it where
  /// velocities are estimated.
  std::optional<double> max_acceleration = {};
  /// m/s, > 0, without a scene; unset: speeds are not judged
  std::optional<double> max_speed = {};
  std::optional<double> max_braking = {};  ///< m/s^2, > 0, without a scene; unset: max_acceleration
  double tolerance = 1e-9;                 ///< see avo::CheckOptions::relative_tolerance
  bool require_arrival = false;            ///< at the goals of the scene
  bool movers_at_rest = false;             ///< see avo::CheckOptions
  /// Called with each time of the recording, s, once it is judged.
  std::function<void(double time)> judged = {};
};

/// The findings in a recording, and the limits that were judged.
struct Judgement {
  avo::CheckReport report;
  std::string recording;
  std::optional<std::string> scene;
  std::optional<double> time_step;  ///< s, of the scene
  /// the ids of the robots, in their order; empty: robot k has the id k
  std::vector<std::int64_t> numbers;
  std::vector<std::int64_t> obstacle_of_wall;  ///< number of the static obstacle
  double tolerance = 0.0;
  std::int64_t uneven_steps = 0;   ///< steps that are not time_step long
  std::int64_t uneven_judged = 0;  ///< the uneven steps that lack no rows
  std::int64_t every = 1;          ///< the recording has rows of every so many steps, as it says
  bool require_arrival = false;
  bool free_clocks = false;  ///< in the scene
  /// whether the limits are known, which are judged then
  bool knows_accelerations = true, knows_speeds = true;
  /// whether the velocities are estimated, see RecordedTime
  bool estimated = false;
  /// Robots of the scene, ascending, that have no row at the first time or at the last time.
  /// Airplanes that left where they arrived, and robots that leave by exits, are not among them.
  std::vector<std::int64_t> lacking;
  /// The recording lasts from the start of the scene to its end, or to a time at which all have
  /// arrived. Missing times are not judged. Without a scene its start and end are unknown.
  bool whole = true;
  double scene_end = 0.0;  ///< s, the duration of the scene
  /// m: the rows are references of quadrotors; their radii contain a deviation of so much at most;
  /// 0: there are no quadrotors
  double deviation = 0.0;

  [[nodiscard]] bool passed() const {
    return safe() && (!require_arrival || report.arrived == report.with_goal);
  }
  /// Returns whether no rule is broken, and no rows are missing.
  [[nodiscard]] bool safe() const { return report.safe() && report.gaps == 0 && lacking.empty(); }
  /// Returns whether rows are missing, of all robots or of one, and the rows that are present break
  /// no rule.
  [[nodiscard]] bool incomplete() const { return !report.broken() && !safe(); }
};

/// Judges the recording in that file; "-" is the standard input. Throws FileError, RecordingError,
/// and Error on options out of range.
AVO_API Judgement judge(const std::string& recording, const JudgeOptions& options);

/// Returns a short table.
AVO_API std::string readable(const Judgement& judgement);
/// Returns one JSON object, keys in a fixed order; missing values are null.
AVO_API std::string to_json(const Judgement& judgement);

}  // namespace avo_io
