// SPDX-License-Identifier: Apache-2.0
#include "space/validity.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "avo/error.h"
#include "planner/options.h"
#include "space/own_space.h"

namespace avo::space {
namespace {

void refuse_option(const char* option, const char* found, const char* allowed) {
  throw Error(std::string("PlannerOptions.") + option + ": space has no " + found +
              "; allowed: " + allowed);
}

}  // namespace

void validate_in_space(const PlannerOptions& options) {
  validate(options, "PlannerOptions.");
  if (options.method != Method::avo) refuse_option("method", to_string(options.method), "avo");
  if (options.clock != Clock::common) refuse_option("clock", to_string(options.clock), "common");
  if (options.sensing_noise.position > 0.0 || options.sensing_noise.velocity > 0.0)
    refuse_option("sensing_noise", "noise of half-spaces", "0");
  if (options.margin > 0.0) refuse_option("margin", "margin", "0");
}

namespace {

bool is_positive(double x) {
  return std::isfinite(x) && x > 0.0;
}

template <typename Body>
bool is_valid_body(const Body& body) {
  return is_finite(body.position) && is_finite(body.velocity) && is_positive(body.radius) &&
         is_positive(body.max_acceleration) && is_positive(body.vertical) &&
         std::isfinite(body.downwash) && body.downwash >= 0.0 && is_positive(body.priority) &&
         is_positive(braking_limit(body));
}

}  // namespace

bool is_valid(const Robot& robot) {
  return is_valid_body(robot) && is_finite(robot.preferred_velocity) &&
         is_positive(robot.max_speed) && robot.climb > 0.0 && robot.sink > 0.0 &&
         robot.distance_to_goal >= 0.0;
}

namespace {

bool is_valid(const Box& box) {
  return box.min.x <= box.max.x && box.min.y <= box.max.y && box.min.z <= box.max.z &&
         std::isfinite(box.heading) && std::isfinite(box.radius) && box.radius >= 0.0;
}

bool is_valid(const Mover& mover) {
  return is_finite(mover.position) && is_finite(mover.velocity) && is_finite(mover.acceleration) &&
         is_positive(mover.radius) && std::isfinite(mover.max_deviation) &&
         mover.max_deviation >= 0.0 && mover.max_speed > 0.0 && mover.age >= 0 &&
         mover.age <= kMostAge;
}

}  // namespace

bool are_valid(const Robot& robot, std::span<const Neighbor> neighbors, std::span<const Box> boxes,
               std::span<const Mover> movers) {
  return is_valid(robot) &&
         std::all_of(neighbors.begin(), neighbors.end(),
                     [](const Neighbor& neighbor) {
                       return is_valid_body(neighbor) && neighbor.age >= 0 &&
                              neighbor.age <= kMostAge;
                     }) &&
         std::all_of(boxes.begin(), boxes.end(), [](const Box& box) { return is_valid(box); }) &&
         std::all_of(movers.begin(), movers.end(),
                     [](const Mover& mover) { return is_valid(mover); });
}

}  // namespace avo::space
