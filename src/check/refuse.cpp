// SPDX-License-Identifier: Apache-2.0
// The numbers that the judge accepts.
#include "check/refuse.h"

#include <cmath>

#include "check/course.h"
#include "core/ranges.h"

namespace avo::judge {
namespace {

// Speeds and accelerations of a step then stay finite.
constexpr double kShortestStep = 1e-12;  // s

constexpr std::size_t kMostDiscs = 5;

// A holonomic robot may have one: its positions may be those of a place beside its disc.
bool may_have(std::size_t discs, const CheckedKinematics& kinematics) {
  if (is_holonomic(kinematics)) return discs <= 1;
  return discs == 0 || !std::holds_alternative<CheckedAirplane>(kinematics);
}

// Infinity: no limit.
void require_limit(const std::string& name, double value, const char* unit) {
  if (!(std::isinf(value) && value > 0.0)) require(name, value, kPositive, unit);
}

void require_kinematics(const std::string& /*place*/, const CheckedHolonomic& /*any*/) {}

void require_kinematics(const std::string& place, const CheckedCar& car) {
  require(place + ".wheelbase", car.wheelbase, kPositive, "m");
  require_limit(place + ".max_curvature", car.max_curvature, "1/m");
  require(place + ".body_offset", car.body_offset, kAnyValue, "m");
}

void require_kinematics(const std::string& place, const CheckedDrive& drive) {
  require(place + ".track", drive.track, kPositive, "m");
  require(place + ".offset", drive.offset, kPositive, "m");
  require_limit(place + ".wheel_speed", drive.wheel_speed, "m/s");
  require_limit(place + ".wheel_acceleration", drive.wheel_acceleration, "m/s^2");
}

void require_kinematics(const std::string& place, const CheckedAirplane& model) {
  require(place + ".min_speed", model.min_speed, kNotNegative, "m/s");
  require_limit(place + ".lateral_acceleration", model.lateral_acceleration, "m/s^2");
}

}  // namespace

void require_sound(const std::string& place, const CheckedRobot& robot) {
  require(place + ".radius", robot.radius, kPositive, "m");
  require_limit(place + ".max_acceleration", robot.max_acceleration, "m/s^2");
  require_limit(place + ".max_speed", robot.max_speed, "m/s");
  if (robot.max_braking) require_limit(place + ".max_braking", *robot.max_braking, "m/s^2");
  require(place + ".interpolation_error", robot.interpolation_error, kNotNegative, "m");
  if (robot.largest_jump) require(place + ".largest_jump", *robot.largest_jump, kNotNegative, "m");
  if (robot.time_step) require(place + ".time_step", *robot.time_step, kPositive, "s");
  if (robot.goal) require(place + ".goal", *robot.goal, "m");
  if (robot.discs.size() > kMostDiscs)
    refuse(place + ".discs", std::to_string(robot.discs.size()),
           "at most " + std::to_string(kMostDiscs));
  if (!may_have(robot.discs.size(), robot.kinematics))
    refuse(place + ".discs", std::to_string(robot.discs.size()), "none: it is no car and no drive");
  for (std::size_t k = 0; k < robot.discs.size(); ++k)
    require(place + ".discs." + std::to_string(k), robot.discs[k], kAnyValue, "m");
  std::visit([&](const auto& kinematics) { require_kinematics(place + ".kinematics", kinematics); },
             robot.kinematics);
}

void require_sound(const std::string& place, const CheckedMover& obstacle) {
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

// The common case without a string: every row of a recording passes this test.
void require_sound(const CheckedRobot& robot, const CheckedState& row) {
  const auto good = [](Vec2 v) { return kAnyValue.contains(v.x) && kAnyValue.contains(v.y); };
  const bool has_heading = row.heading.has_value();
  if (good(row.position) && good(row.velocity) &&
      (!has_heading || good({row.heading->angle, row.heading->speed})) &&
      (has_heading || !needs_heading(robot)))
    return;
  const std::string place = "robot " + std::to_string(row.robot);
  require(place + ": position", row.position, "m");
  require(place + ": velocity", row.velocity, "m/s");
  if (!has_heading)
    throw Error(place + ": heading: found none, must be there: its disc, or what its velocity is " +
                "of, is ahead of its position");
  require(place + ": heading", row.heading->angle, kAnyValue, "rad");
  require(place + ": speed", row.heading->speed, kAnyValue, "m/s");
}

}  // namespace avo::judge
