// SPDX-License-Identifier: Apache-2.0
// Finds a decision in space to explain.
#include "avo_io/space_decision.h"

#include <cmath>
#include <fmt/format.h>

#include "avo/error.h"

namespace avo_io {
namespace {

using avo::space::Scenario;

void require_explainable(const Scenario& scenario, std::int64_t robot, double time) {
  const auto robots = static_cast<std::int64_t>(scenario.robots.size());
  if (robot < 0 || robot >= robots)
    throw avo::Error(fmt::format("robot: found {}, must be 0 to {}", robot, robots - 1));
  if (!std::isfinite(time) || time < 0.0)
    throw avo::Error(fmt::format("time: found {}, must be finite and >= 0 s", time));
  if (time > scenario.duration * (1.0 + 1e-12))
    throw avo::Error(
        fmt::format("time: found {} s, must be <= duration = {} s", time, scenario.duration));
}

}  // namespace

std::optional<avo::space::Explanation> explain_in_space(
    const Scenario& scenario, std::int64_t robot, double time, int threads,
    const std::function<bool(double time)>& go_on) {
  require_explainable(scenario, robot, time);
  avo::space::Simulation simulation(scenario, threads);
  while (simulation.time() + scenario.time_step <= time * (1.0 + 1e-12)) {
    if (go_on && !go_on(simulation.time())) return std::nullopt;
    simulation.step();
  }
  return simulation.explain({static_cast<std::uint64_t>(robot)});
}

}  // namespace avo_io
