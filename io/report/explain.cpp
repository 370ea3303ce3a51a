// SPDX-License-Identifier: Apache-2.0
// Finds the decision of a robot to explain, and gathers the facts about it.
#include <cmath>
#include <fmt/format.h>
#include <utility>
#include <variant>

#include "avo/error.h"
#include "avo/explanation.h"
#include "avo_io/decision.h"

namespace avo_io {
namespace {

bool leaves_at_goal(const avo::RobotSetup& robot) {
  const auto* airplane = std::get_if<avo::Airplane>(&robot.model);
  return airplane != nullptr && airplane->after_goal == avo::AfterGoal::leave;
}

const avo::RobotSetup& setup_of(const avo::Scenario& scenario, avo::RobotId robot) {
  return scenario.robots[static_cast<std::size_t>(robot.value)];
}

/// s: when the robot decides next. A robot that is about to leave decides no more.
double next_decision(const avo::Scenario& scenario, avo::RobotId robot, double time,
                     const avo::Simulation& simulation) {
  if (simulation.index_of(robot) &&
      !(leaves_at_goal(setup_of(scenario, robot)) && simulation.is_at_goal(robot)))
    return simulation.next_decision(robot);
  throw avo::Error(fmt::format("time: found {} s, must be < {:.9g} s, when robot {} left", time,
                               simulation.time(), robot.value));
}

// Returns s. Airplanes, and robots among moving obstacles alone, adopt the chosen velocity at once.
double response_time_in(const Decision& decision, const avo::PlannerOptions& options) {
  const avo::Robot& self = decision.seen.robot;
  if (!decision.by_half_planes || !can_rest(self.model)) return 0.0;
  return avo::response_time_of(options, self.max_speed, self.max_acceleration);
}

}  // namespace

void require_explainable(const avo::Scenario& scenario, std::int64_t robot, double time) {
  const auto robots = static_cast<std::int64_t>(scenario.robots.size());
  if (robot < 0 || robot >= robots)
    throw avo::Error(fmt::format("robot: found {}, must be 0 to {}", robot, robots - 1));
  if (is_parked(scenario.robots[static_cast<std::size_t>(robot)]))
    throw avo::Error(
        fmt::format("robot: found {}, which is parked, must be one that decides", robot));
  if (!std::isfinite(time) || time < 0.0)
    throw avo::Error(fmt::format("time: found {}, must be finite and >= 0 s", time));
  if (time > scenario.duration * (1.0 + 1e-12))
    throw avo::Error(
        fmt::format("time: found {} s, must be <= duration = {} s", time, scenario.duration));
}

bool approach_decision(const avo::Scenario& scenario, std::int64_t robot, double time,
                       avo::Simulation& simulation, const std::function<bool()>& go_on) {
  const avo::RobotId id{static_cast<std::uint64_t>(robot)};
  const double step = time_step_of(scenario, setup_of(scenario, id));
  const auto next = [&] { return next_decision(scenario, id, time, simulation); };
  const bool is_free = scenario.clock == avo::Clock::free;
  if (is_free && next() > time)
    throw avo::Error(fmt::format("time: found {} s, must be >= {} s, when robot {} first decides",
                                 time, next(), robot));
  const auto is_there = [&] {
    const double decides = next();
    return is_free && decides == simulation.time() && decides + step > time * (1.0 + 1e-12);
  };
  while (!is_there() && simulation.can_step_by(time)) {
    if (go_on && !go_on()) return false;
    simulation.step();
  }
  next();  // throws if the robot has left
  return true;
}

Decision explain(const avo::Simulation& simulation, const std::string& scene, avo::RobotId robot) {
  const avo::Planner& planner = simulation.planner(robot);
  Decision decision;
  avo::Explanation explained = simulation.explain(robot);
  decision.scene = scene;
  decision.robot = static_cast<std::int64_t>(explained.robot.value);
  decision.time = explained.time;
  decision.goal = explained.goal;
  decision.method = planner.options().method;
  decision.has_own_method = decision.method != simulation.planner().options().method;
  decision.trace = std::move(explained.decision);
  decision.sentence = std::move(explained.sentence);
  decision.plan = decision.trace.plan;
  decision.evasion = decision.trace.evasion;
  decision.state = explained.state;
  decision.seen = std::move(explained.seen);
  decision.by_half_planes = !decision.seen.among_movers;
  const avo::Robot& self = decision.seen.robot;
  const auto& neighbors = decision.seen.neighbors;
  const auto& walls = decision.seen.walls;
  avo::PlanWorkspace workspace;
  if (decision.by_half_planes)
    planner.collect_half_planes(self, neighbors, workspace, decision.half_planes, walls);
  const avo::SensingNoise& noise = planner.options().sensing_noise;
  if (decision.by_half_planes && (noise.position > 0.0 || noise.velocity > 0.0)) {
    const bool is_avo = avo::method_traits(decision.method).has_rules;
    const avo::Vec2 v = is_avo ? decision.plan.next_velocity : decision.plan.new_velocity;
    for (const avo::Neighbor& neighbor : neighbors)
      decision.risks.push_back(planner.half_plane_risk(self, neighbor, v));
  }
  planner.collect_half_planes(self, walls, decision.wall_planes);
  decision.certificate = planner.options().certificate;
  decision.response_time = response_time_in(decision, planner.options());
  if (decision.is_certified())
    planner.collect_certificate(self, neighbors, workspace, decision.constraints, walls);
  planner.collect_certificate(self, walls, workspace, decision.wall_constraints);
  decision.acceleration_disc = planner.acceleration_disc(self);
  decision.speed_disc = planner.speed_disc(self);
  return decision;
}

}  // namespace avo_io
