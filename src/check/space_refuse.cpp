// SPDX-License-Identifier: Apache-2.0
#include "check/space_refuse.h"

#include <cmath>
#include <string>

#include "avo/error.h"

namespace avo::judge {
namespace {

void require_that(bool holds, const char* body, std::size_t number, const char* rule) {
  if (!holds) throw Error(std::string(body) + " " + std::to_string(number) + ": " + rule);
}

bool has_nan(Vec3 p) {
  return std::isnan(p.x) || std::isnan(p.y) || std::isnan(p.z);
}

}  // namespace

void require_sound(const space::CheckedRobot& robot, std::size_t number) {
  require_that(robot.radius > 0.0, "robot", number, "radius must be > 0");
  require_that(robot.downwash >= 0.0, "robot", number, "downwash must be >= 0");
  require_that(robot.max_acceleration > 0.0, "robot", number, "max_acceleration must be > 0");
  require_that(robot.max_speed > 0.0, "robot", number, "max_speed must be > 0");
  require_that(robot.vertical > 0.0, "robot", number, "vertical must be > 0");
  require_that(robot.climb > 0.0, "robot", number, "climb must be > 0");
  require_that(robot.sink > 0.0, "robot", number, "sink must be > 0");
  require_that(robot.max_braking.value_or(1.0) > 0.0, "robot", number, "max_braking must be > 0");
  require_that(!robot.goal || is_finite(*robot.goal), "robot", number, "goal must be finite");
}

void require_sound(const space::CheckedMover& mover, std::size_t number) {
  require_that(mover.radius > 0.0, "moving obstacle", number, "radius must be > 0");
}

void require_sound(const space::Box& box, std::size_t number) {
  require_that(!has_nan(box.min) && !has_nan(box.max), "box", number,
               "min and max must be numbers");
  require_that(box.min.x <= box.max.x && box.min.y <= box.max.y && box.min.z <= box.max.z, "box",
               number, "min must not exceed max");
  require_that(box.radius >= 0.0 && std::isfinite(box.heading), "box", number,
               "radius must be >= 0, and heading finite");
}

void require_all(std::size_t movers, std::span<const space::CheckedState> states) {
  if (states.size() != movers)
    throw Error("found " + std::to_string(states.size()) + " moving obstacles, must be " +
                std::to_string(movers));
}

}  // namespace avo::judge
