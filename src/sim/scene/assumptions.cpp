// SPDX-License-Identifier: Apache-2.0
// The assumptions of a certificate that a scene breaks.
#include "sim/scene/assumptions.h"

#include <algorithm>
#include <cstddef>

#include "sim/columns/fleet.h"

namespace avo::inline sim {
namespace {

void find_fast_starts(const Scenario& scenario, const CertificateLaw& law,
                      BrokenAssumptions& result) {
  std::vector<FastStart> fast;
  for (std::size_t i = 0; i < scenario.robots.size(); ++i) {
    if (!keeps(scenario, scenario.robots[i], law)) continue;
    const double speed = norm(scenario.robots[i].velocity);
    if (exceeds(speed, scenario.robots[i].max_speed)) fast.push_back({RobotId{i}, speed});
  }
  const auto excess = [&](const FastStart& start) {
    return start.speed - listed_as(start.robot, scenario.robots).max_speed;
  };
  result.fast_count = static_cast<std::int64_t>(fast.size());
  result.fast.resize(std::min(fast.size(), BrokenAssumptions::kNamed));
  std::partial_sort_copy(fast.begin(), fast.end(), result.fast.begin(), result.fast.end(),
                         [&](const FastStart& a, const FastStart& b) {
                           const double of_a = excess(a), of_b = excess(b);
                           return of_a != of_b ? of_a > of_b : a.robot.value < b.robot.value;
                         });
}

}  // namespace

StepLaw step_law(const Scenario& scenario, const RobotSetup& robot, const CertificateLaw& law) {
  StepLaw own = law.step;
  if (!own.has_free_clocks()) return own;
  own.time_step = own.braking_time = time_step_of(scenario, robot);
  own.lag = 0.5 * own.time_step;
  return own;
}

double longest_first_step(const CertificateLaw& law) {
  if (!law.step.has_free_clocks()) return 0.0;
  return std::max(law.step.longest_step, law.step.time_step);
}

// Braking in steps of any lengths up to L is ahead of continuous braking by 0 to c L²/8.
double late_phase(const RobotSetup& robot, double longest_step) {
  if (robot.velocity == Vec2{}) return 0.0;
  return 0.125 * change_limit(robot) * longest_step * longest_step;
}

bool is_mixed(const Scenario& scenario) {
  const RobotSetup usual;
  return std::any_of(scenario.robots.begin(), scenario.robots.end(), [&](const RobotSetup& robot) {
    return !(robot.layers == usual.layers && robot.avoids == usual.avoids &&
             promises(robot.behavior) && method_of(scenario, robot) == scenario.method);
  });
}

Vec2 vector_to_rest(const RobotSetup& robot, const CertificateLaw& law) {
  return stopping_vector(start_velocity(robot), decrement_of(robot, law.step), law.step);
}

}  // namespace avo::inline sim

namespace avo {

BrokenAssumptions broken_assumptions(const Scenario& scenario) {
  if (scenario.execution) return broken_assumptions(with_references(scenario));
  BrokenAssumptions result;
  const CertificateLaw law = certificate_law(scenario);
  if (law.kind == Certificate::none) return result;
  find_broken_starts(scenario, law, result);
  std::vector<MotionState> starts;
  for (const RobotSetup& robot : scenario.robots) starts.push_back(start_of(robot));
  find_wall_starts(scenario, starts, law, result);
  find_fast_starts(scenario, law, result);
  const std::optional<SensingNeed> need = sensing_need(scenario);
  if (!suffices(sensing_radius_of(scenario), need)) result.unseen = need;
  return result;
}

}  // namespace avo
