// SPDX-License-Identifier: Apache-2.0
// avo explain: why a robot chooses the velocity that it chooses (paper Figs. 3 to 6).
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <variant>

#include "avo/simulation.h"
#include "avo_io/output_file.h"
#include "exit_codes.h"
#include "explain_report.h"
#include "figures/state_map.h"
#include "figures/velocity_space.h"
#include "files.h"
#include "settings_report.h"
#include "signals.h"
#include "terminal.h"
#include "verbs.h"

namespace avo_cli {
namespace {

constexpr double kFigureWidth = 340.0;  // pt

Decision decide(const avo::Simulation& simulation, const avo::Scenario& scenario,
                std::size_t index) {
  const avo::Planner& planner = simulation.planner(index);
  Decision decision;
  decision.scene = scenario.name;
  decision.robot = static_cast<std::int64_t>(simulation.fleet().id[index].value);
  decision.time = simulation.time();
  decision.goal = simulation.fleet().goal[index];
  decision.method = scenario.method;
  decision.seen = simulation.perceive(index);
  const auto& [self, neighbors, source, detour, among_movers, walls] = decision.seen;
  avo::Detour next_detour = detour;
  decision.by_half_planes = !among_movers;
  avo::PlanWorkspace workspace;
  decision.plan = planner.plan(self, neighbors, workspace, &next_detour, walls);
  decision.state = planner.state(self, neighbors, workspace, walls);
  if (decision.by_half_planes)
    planner.collect_half_planes(self, neighbors, workspace, decision.half_planes, walls);
  const avo::SensingNoise& noise = planner.options().sensing_noise;
  if (decision.by_half_planes && (noise.position > 0.0 || noise.velocity > 0.0)) {
    const bool is_avo = decision.method == avo::Method::avo;
    const avo::Vec2 v = is_avo ? decision.plan.next_velocity : decision.plan.new_velocity;
    for (const avo::Neighbor& neighbor : neighbors)
      decision.risks.push_back(planner.half_plane_risk(self, neighbor, v));
  }
  planner.collect_half_planes(self, walls, decision.wall_planes);
  decision.certificate = planner.options().certificate;
  if (decision.method == avo::Method::avo)
    planner.collect_certificate(self, neighbors, workspace, decision.constraints, walls);
  planner.collect_certificate(self, walls, workspace, decision.wall_constraints);
  decision.acceleration_disc = planner.acceleration_disc(self);
  decision.speed_disc = planner.speed_disc(self);
  return decision;
}

std::string title_of(const Decision& decision) {
  return fmt::format("robot {} at {:.6g} s: {}", decision.robot, decision.time,
                     avo::to_string(decision.state.state));
}

void require_robot(const ExplainArguments& arguments, const avo::Scenario& scenario) {
  const auto robots = static_cast<std::int64_t>(scenario.robots.size());
  if (arguments.robot < 0 || arguments.robot >= robots)
    throw UsageError(
        fmt::format("--robot: found {}, must be 0 to {}", arguments.robot, robots - 1));
  if (scenario.robots[static_cast<std::size_t>(arguments.robot)].parked)
    throw UsageError(fmt::format("--robot: found {}, which is parked, must be one that decides",
                                 arguments.robot));
}

bool leaves_at_goal(const avo::RobotSetup& robot) {
  const auto* airplane = std::get_if<avo::Airplane>(&robot.model);
  return airplane != nullptr && airplane->after_goal == avo::AfterGoal::leave;
}

/// Of the robot, into the fleet, where others may be missing. One that is to leave decides no more.
std::size_t index_of(const ExplainArguments& arguments, const avo::Scenario& scenario,
                     const avo::Simulation& simulation) {
  const auto number = static_cast<std::size_t>(arguments.robot);
  const auto index = simulation.index_of({number});
  if (index && !(leaves_at_goal(scenario.robots[number]) && simulation.is_at_goal(*index)))
    return *index;
  throw UsageError(fmt::format("--time: found {} s, must be < {:.9g} s, when robot {} left",
                               arguments.time, simulation.time(), arguments.robot));
}

/// To the robot's last decision by that time. False where a signal came first.
bool approach(const ExplainArguments& arguments, const avo::Scenario& scenario,
              avo::Simulation& simulation) {
  const double step =
      time_step_of(scenario, scenario.robots[static_cast<std::size_t>(arguments.robot)]);
  const auto next = [&] {
    return simulation.next_decision(index_of(arguments, scenario, simulation));
  };
  const bool is_free = scenario.clock == avo::Clock::free;
  if (is_free && next() > arguments.time)
    throw UsageError(fmt::format("--time: found {} s, must be >= {} s, when robot {} first decides",
                                 arguments.time, next(), arguments.robot));
  const auto is_there = [&] {
    const double time = next();
    return is_free && time == simulation.time() && time + step > arguments.time * (1.0 + 1e-12);
  };
  Progress progress(arguments.time);
  while (!is_there() && simulation.can_step_by(arguments.time)) {
    if (signal_caught() != 0) return false;
    simulation.step();
    progress.show(simulation.time());
  }
  return true;
}

}  // namespace

int explain(const ExplainArguments& arguments) {
  const NamedFile velocities{"--figure", arguments.figure}, places{"--states", arguments.states};
  require_figure(velocities);
  require_figure(places);
  if (!std::isfinite(arguments.time) || arguments.time < 0.0)
    throw UsageError(fmt::format("--time: found {}, must be finite and >= 0 s", arguments.time));
  catch_signals();
  const avo::Scenario scenario = load(arguments.scene, {velocities, places});
  require_robot(arguments, scenario);
  if (arguments.time > scenario.duration * (1.0 + 1e-12))
    throw UsageError(fmt::format("--time: found {} s, must be <= duration = {} s", arguments.time,
                                 scenario.duration));
  std::optional<avo_io::OutputFile> figure, states;
  if (!arguments.figure.empty()) figure.emplace(arguments.figure);
  if (!arguments.states.empty()) states.emplace(arguments.states);

  avo::Simulation simulation(scenario);
  tell_machine(simulation);
  if (!approach(arguments, scenario, simulation)) return kSignal + signal_caught();
  const std::size_t index = index_of(arguments, scenario, simulation);
  const Decision decision = decide(simulation, scenario, index);
  const avo::figures::FigureOptions options{.width = kFigureWidth, .title = title_of(decision)};
  if (figure) {
    figure->write(drawn([&] {
      return draw_velocity_space(
          avo::figures::velocity_space(decision.seen, simulation.planner(index)), arguments.figure,
          options);
    }));
  }
  if (states) {
    states->write(drawn([&] {
      return draw_state_map(decision.seen, simulation.planner(index), arguments.states, options);
    }));
  }
  if (figure) figure->commit();
  if (states) states->commit();
  if (arguments.json)
    print(to_json(decision));
  else
    print_results(readable(decision));
  return kDone;
}

}  // namespace avo_cli
