// SPDX-License-Identifier: Apache-2.0
#include "planner/stages/relevance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "avo/half_plane.h"
#include "certificate/kernels.h"
#include "certificate/pair.h"
#include "core/plane.h"
#include "planner/rules/arrival.h"
#include "planner/stages/certify.h"

namespace avo::inline planner {
namespace {

using Real = scalar::Pack<double>;

constexpr double kReachRounding = 1e-9;  // of a sum of lengths, generously

// The braking of a robot at its largest speed: the reach grows with the speed.
Braking fastest(const Planner& planner, const Robot& robot) {
  return braking_of({(1.0 + kSpeedRounding) * robot.max_speed, 0.0}, ability_of(robot),
                    certificate_law(planner).step);
}

double least_of_shares(const Peers& peers) {
  const double share =
      peers.least_acceleration / (peers.least_acceleration + peers.most_acceleration);
  return peers.least_priority == peers.most_priority ? share : std::min(share, kLeastShare);
}

// m: an upper bound of drift_of() of all of them, where clocks are free.
double most_drift(const Peers& peers, const StepLaw& law) {
  const double H = law.time_step, L = law.longest_step, V = std::max(H, 2.0 * L - H);
  const double time = H * (peers.intervals + 1.0);  // until rest
  const double later = 0.5 * V * peers.most_weakness;
  return peers.most_change * (V * (time + later) + 0.125 * (H * H + L * L));
}

// Beyond it cannot_meet() holds for all pairs. The margin for rounding grows with the places of
// both. The neighbor's place is at most the distance farther out, √2 of it in one-norms.
std::array<double, 3> certificate_range(const Planner& planner, const Robot& robot,
                                        const Peers& peers) {
  const StepLaw law = certificate_law(planner).step;
  const SensingError& error = law.sensing_error;
  const double time = law.time_step * peers.intervals;
  const double drift = law.has_free_clocks() ? most_drift(peers, law) : 0.0;
  const double least_share = law.has_free_clocks() ? 1.0 : 0.5 * least_of_shares(peers);
  const double margin = 0x1p-48 * (1.0 + peers.intervals) / least_share;
  if (!(margin < 0.5)) return {kInfinity, 0.0, 0.0};
  const double wider = (1.0 + margin) / (1.0 - std::numbers::sqrt2 * margin);
  const auto [at_rest, slope, curvature] = scalar::reach_bound(
      Real(increment(robot.max_acceleration, law)), Real(decrement_of(robot, law)), law);
  const double others = robot.radius + peers.reach + error.position + error.velocity * time +
                        drift + 4.0 * margin * kMostRelevantPosition;
  return {wider * (at_rest.value + others), wider * slope.value, wider * curvature.value};
}

float rounded_up(double value) {
  const auto narrow = static_cast<float>(value);
  return narrow < value ? std::nextafter(narrow, std::numeric_limits<float>::infinity()) : narrow;
}

}  // namespace

void include(Peers& peers, const Planner& planner, const Robot& robot) {
  const Braking braking = fastest(planner, robot);
  const Real later = scalar::later_intervals(
      Real(braking.increment), Real(braking.profile.decrement), certificate_law(planner).step);
  peers.radius = std::max(peers.radius, robot.radius);
  peers.reach = std::max(peers.reach, robot.radius + braking.reach);
  peers.intervals = std::max(peers.intervals, braking.intervals + later.value);
  peers.most_weakness =
      std::max(peers.most_weakness, robot.max_acceleration / braking_limit(robot));
  peers.most_change = std::max(peers.most_change, change_limit(robot));
  peers.least_acceleration = std::min(peers.least_acceleration, robot.max_acceleration);
  peers.most_acceleration = std::max(peers.most_acceleration, robot.max_acceleration);
  peers.least_priority = std::min(peers.least_priority, robot.priority);
  peers.most_priority = std::max(peers.most_priority, robot.priority);
}

RelevantRange relevant_range(const Planner& planner, const Robot& robot, const Peers& peers) {
  const PlannerOptions& options = planner.options();
  if (!options.max_neighbors) return {std::numeric_limits<float>::infinity()};
  if (options.certificate == Certificate::none) return {};
  const std::array<double, 3> reach = certificate_range(planner, robot, peers);
  const auto wide = [](double part) { return rounded_up((1.0 + kReachRounding) * part); };
  return {wide(arrival_range(robot, peers.radius)),
          {wide(reach[0]), wide(reach[1]), wide(reach[2])}};
}

}  // namespace avo::inline planner
