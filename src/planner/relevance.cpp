// SPDX-License-Identifier: Apache-2.0
#include "planner/relevance.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "certificate/pair.h"
#include "planner/arrival.h"
#include "planner/certify.h"

namespace avo {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRounding = 1e-9;  // of a sum of lengths, generously

// Of a robot as fast as it may be: the reach grows with the speed.
Braking fastest(const Planner& planner, const Robot& robot) {
  return braking_of({(1.0 + kSpeedRounding) * robot.max_speed, 0.0}, robot.max_acceleration,
                    certificate_law(planner).step);
}

// Beyond it cannot_meet() holds of all pairs. What covers rounding grows with the places of both,
// of which the neighbor's is at most the distance farther out, √2 of it in one-norms.
double certificate_range(const Planner& planner, const Robot& robot, const Peers& peers) {
  const SensingError& error = planner.options().sensing_error;
  const double time = planner.options().time_step * peers.intervals;
  const double reach = robot.radius + fastest(planner, robot).reach + peers.reach;
  const double least_share =
      0.5 * peers.least_acceleration / (peers.least_acceleration + peers.most_acceleration);
  const double margin = 0x1p-48 * (1.0 + peers.intervals) / least_share;
  if (!(margin < 0.5)) return kInfinity;
  const double places = 4.0 * kMostRelevantPosition;
  return (reach + error.position + error.velocity * time + margin * (reach + places)) /
         (1.0 - std::numbers::sqrt2 * margin);
}

}  // namespace

void include(Peers& peers, const Planner& planner, const Robot& robot) {
  const Braking braking = fastest(planner, robot);
  peers.radius = std::max(peers.radius, robot.radius);
  peers.reach = std::max(peers.reach, robot.radius + braking.reach);
  peers.intervals = std::max(peers.intervals, braking.intervals);
  peers.least_acceleration = std::min(peers.least_acceleration, robot.max_acceleration);
  peers.most_acceleration = std::max(peers.most_acceleration, robot.max_acceleration);
}

double relevant_range(const Planner& planner, const Robot& robot, const Peers& peers) {
  const PlannerOptions& options = planner.options();
  if (!options.max_neighbors) return kInfinity;
  if (options.certificate == Certificate::none) return 0.0;
  const double range =
      std::max(certificate_range(planner, robot, peers), arrival_range(robot, peers.radius));
  return (1.0 + kRounding) * range;
}

}  // namespace avo
