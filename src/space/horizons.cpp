// SPDX-License-Identifier: Apache-2.0
#include "space/horizons.h"

#include <algorithm>
#include <cstddef>

#include "avo/space/planner.h"

namespace avo::space {
namespace {

constexpr double kShortest = 0.5;  // of the full horizon
// Parts of what a robot flies in the full horizon. Within the first distance of its goal the
// horizon is the shortest one, and from the second distance on the full one.
constexpr double kNearGoal = 1.25, kFarFromGoal = 1.75;
constexpr int kParts = 16;  // a step of the horizon of 3 s is 0.1 s

// From 0 far from the goal to kParts near it.
int part_of(const Robot& robot, double time_horizon) {
  const double left = robot.distance_to_goal / (time_horizon * robot.max_speed);
  const double near = (kFarFromGoal - left) / (kFarFromGoal - kNearGoal);
  return static_cast<int>(kParts * std::clamp(near, 0.0, 1.0));
}

// s
double horizon_at(int part, const PlannerOptions& options) {
  const double least = std::max(kShortest * options.time_horizon, options.time_step);
  const double whole = static_cast<double>(part) / kParts;
  return options.time_horizon - whole * std::max(options.time_horizon - least, 0.0);
}

}  // namespace

std::vector<Horizon> horizons_of(const PlannerOptions& options) {
  std::vector<Horizon> horizons;
  for (int part = 0; part <= kParts; ++part)
    horizons.emplace_back(options.control_time, horizon_at(part, options), options.time_step);
  return horizons;
}

const Horizon& horizon_of(const Robot& robot, std::span<const Horizon> horizons) {
  return horizons[static_cast<std::size_t>(part_of(robot, horizons.front().end().time))];
}

double own_time_horizon(const Robot& robot, const PlannerOptions& options) {
  return horizon_at(part_of(robot, options.time_horizon), options);
}

}  // namespace avo::space
