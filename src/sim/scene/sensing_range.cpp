// SPDX-License-Identifier: Apache-2.0
// The sensing radius where the scene does not give it (docs/scenes.md, "How far robots sense").
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "avo/assumptions.h"
#include "core/ranges.h"
#include "planner/rules/arrival.h"
#include "planner/stages/certify.h"
#include "robots/model.h"
#include "sim/bases/bases.h"
#include "sim/scene/assumptions.h"

namespace avo::inline sim {
namespace {

constexpr std::size_t kSampled = 200;  // number of robots for which neighbors are counted

}  // namespace

double mean_neighbors(const Scenario& scenario, double radius) {
  std::vector<Vec2> places;
  for (const RobotSetup& robot : scenario.robots)
    if (!is_parked(robot)) places.push_back(disc_center(robot));
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

}  // namespace avo::inline sim

namespace avo {
namespace {

constexpr double kAlone = 1.0;  // m, where there is no other to sense

// Radii: the range in which robots among walls search for claims of passages (docs/arrival.md).
constexpr double kAmongWalls = 30.0;

// The largest values of the robots that decide.
struct Largest {
  double radius = 0.0, speed = 0.0;  // m, m/s
  bool some_yield = false;           // whether priorities differ
};

Largest largest_of(const Scenario& scenario) {
  Largest largest;
  std::optional<double> priority;  // of the first one
  for (const RobotSetup& robot : scenario.robots) {
    if (is_parked(robot)) continue;
    largest.radius = std::max(largest.radius, disc_radius(robot));
    largest.speed = std::max(largest.speed, robot.max_speed);
    if (!priority) priority = robot.priority;
    largest.some_yield = largest.some_yield || robot.priority != *priority;
  }
  return largest;
}

// m: the robot sees another one that moves towards it in time to get out of its path alone, from
// rest to rest. For the distance r this takes 2 √(r/a). Where one of two has to make more of the
// correction, it must see the other as soon as half-planes ask for it. That is from the time
// horizon on. If it sees the other later, less of the correction is left to the one that should
// make it, against the order of priorities.
double evading_range(const Robot& robot, const Largest& others, double time_horizon) {
  const double r = robot.radius + others.radius;
  const double time = 2.0 * std::sqrt(r / robot.max_acceleration);
  return r + (robot.max_speed + others.speed) *
                 (others.some_yield ? std::max(time, time_horizon) : time);
}

// m: the range of a method's rules, beside the certificate.
double rules_range(const Scenario& scenario) {
  const bool among_walls = !scenario.obstacles.empty() && scenario.navigation.value_or(true) &&
                           scenario.right_of_way != RightOfWay::none;
  const Largest largest = largest_of(scenario);
  double range = 0.0;
  for (const RobotSetup& setup : scenario.robots) {
    if (is_parked(setup)) continue;
    Robot robot;
    robot.radius = disc_radius(setup), robot.max_speed = setup.max_speed;
    robot.max_acceleration = setup.max_acceleration, robot.max_braking = setup.max_braking;
    range = std::max(range, arrival_range(robot, largest.radius));
    if (among_walls) range = std::max(range, kAmongWalls * robot.radius);
    const double tau = time_horizon_of(scenario, setup);
    range = std::max(range, method_traits(method_of(scenario, setup)).has_rules
                                ? evading_range(robot, largest, tau)
                                : robot.radius + largest.radius + tau * robot.max_speed);
  }
  return range;
}

}  // namespace

double needed_sensing_radius(const Scenario& scenario) {
  if (scenario.execution) return needed_sensing_radius(with_references(scenario));
  const auto need = sensing_need(scenario, certificate_law(scenario));
  const double range = std::max(need ? need->range : 0.0, rules_range(scenario));
  return range > 0.0 ? std::min(range, kLargest) : kAlone;
}

double sensing_radius_of(const Scenario& scenario) {
  return scenario.sensing_radius ? *scenario.sensing_radius : needed_sensing_radius(scenario);
}

}  // namespace avo
