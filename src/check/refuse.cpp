// SPDX-License-Identifier: Apache-2.0
// Which numbers the judge takes.
#include "check/refuse.h"

#include <cmath>

#include "core/ranges.h"

namespace avo::judge {
namespace {

// Speeds and accelerations of a step stay finite.
constexpr double kShortestStep = 1e-12;  // s

// Infinity: no limit.
void require_limit(const std::string& name, double value, const char* unit) {
  if (!(std::isinf(value) && value > 0.0)) require(name, value, kPositive, unit);
}

}  // namespace

void require_sound(const std::string& place, const CheckedRobot& robot) {
  require(place + ".radius", robot.radius, kPositive, "m");
  require_limit(place + ".max_acceleration", robot.max_acceleration, "m/s^2");
  require_limit(place + ".max_speed", robot.max_speed, "m/s");
  require(place + ".interpolation_error", robot.interpolation_error, kNotNegative, "m");
  if (robot.time_step) require(place + ".time_step", *robot.time_step, kPositive, "s");
  if (robot.goal) require(place + ".goal", *robot.goal, "m");
}

void require_sound(const std::string& place, const CheckedObstacle& obstacle) {
  require(place + ".position", obstacle.position, "m");
  require(place + ".velocity", obstacle.velocity, "m/s");
  require(place + ".acceleration", obstacle.acceleration, "m/s^2");
  require(place + ".radius", obstacle.radius, kPositive, "m");
}

void require_sound(const std::string& place, const CheckedWall& wall) {
  require(place + ".a", wall.a, "m");
  require(place + ".b", wall.b, "m");
  require(place + ".radius", wall.radius, kNotNegative, "m");
}

void require_sound(const CheckOptions& options) {
  const double tolerance = options.relative_tolerance;
  if (!(tolerance >= 0.0 && tolerance < 1.0))
    refuse("relative_tolerance", text(tolerance), ">= 0 and < 1");
  require("arrival_distance", options.arrival_distance, kPositive, "m");
}

void require_time(double time, std::optional<double> before) {
  require("time", time, kAnyValue, "s");
  if (before && !(time - *before >= kShortestStep))
    refuse("time", text(time) + " s",
           "at least " + text(kShortestStep) + " s after the time before, " + text(*before) + " s");
}

// The common case without a string: every row of a recording passes here.
void require_sound(const CheckedState& row) {
  const auto good = [](Vec2 v) { return kAnyValue.contains(v.x) && kAnyValue.contains(v.y); };
  if (good(row.position) && good(row.velocity)) return;
  const std::string place = "robot " + std::to_string(row.robot);
  require(place + ": position", row.position, "m");
  require(place + ": velocity", row.velocity, "m/s");
}

}  // namespace avo::judge
