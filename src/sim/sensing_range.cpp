// SPDX-License-Identifier: Apache-2.0
// How far robots sense whose scene does not say it (docs/scenes.md, "How far robots sense").
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "avo/assumptions.h"
#include "core/ranges.h"
#include "planner/arrival.h"
#include "robots/model.h"
#include "sim/assumptions.h"

namespace avo {
namespace {

constexpr double kAlone = 1.0;         // m, where there is nobody to sense
constexpr std::size_t kSampled = 200;  // robots, whose neighbors are counted

// m: as far as a method's rules look, beside the certificate.
double rules_range(const Scenario& scenario, const PlannerOptions& options) {
  double radius = 0.0, range = 0.0;
  for (const RobotSetup& robot : scenario.robots)
    if (!robot.parked) radius = std::max(radius, disc_radius(robot));
  for (const RobotSetup& setup : scenario.robots) {
    if (setup.parked) continue;
    Robot robot;
    robot.radius = disc_radius(setup), robot.max_speed = setup.max_speed;
    robot.max_acceleration = setup.max_acceleration, robot.max_braking = setup.max_braking;
    range = std::max(range, arrival_range(robot, radius));
    if (options.method != Method::avo)
      range = std::max(range, robot.radius + radius + options.time_horizon * robot.max_speed);
  }
  return range;
}

}  // namespace

double needed_sensing_radius(const Scenario& scenario) {
  const PlannerOptions options = planner_options(scenario);
  const auto need = sensing_need(scenario, certificate_law(Planner(options)));
  const double range = std::max(need ? need->range : 0.0, rules_range(scenario, options));
  return range > 0.0 ? std::min(range, kLargest) : kAlone;
}

double mean_neighbors(const Scenario& scenario, double radius) {
  std::vector<Vec2> places;
  for (const RobotSetup& robot : scenario.robots)
    if (!robot.parked) places.push_back(disc_center(robot));
  const std::size_t sampled = std::min(places.size(), kSampled);
  std::int64_t near = 0;
  for (std::size_t k = 0; k < sampled; ++k) {
    const Vec2 own = places[k * places.size() / sampled];
    near += std::count_if(places.begin(), places.end(),
                          [&](Vec2 place) { return norm_squared(place - own) <= radius * radius; });
  }
  const auto others = static_cast<double>(near - static_cast<std::int64_t>(sampled));
  return sampled > 0 ? others / static_cast<double>(sampled) : 0.0;
}

double sensing_radius_of(const Scenario& scenario) {
  return scenario.sensing_radius ? *scenario.sensing_radius : needed_sensing_radius(scenario);
}

}  // namespace avo
