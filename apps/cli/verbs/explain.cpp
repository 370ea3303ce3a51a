// SPDX-License-Identifier: Apache-2.0
// avo explain: why a robot chooses the velocity that it chooses (paper Figs. 3 to 6).
#include <fmt/format.h>
#include <optional>

#include "arguments/files.h"
#include "avo/simulation.h"
#include "avo_io/decision.h"
#include "avo_io/output_file.h"
#include "exit_codes.h"
#include "figures/state_map.h"
#include "figures/velocity_space.h"
#include "reports/settings_report.h"
#include "system/signals.h"
#include "system/terminal.h"
#include "verbs/space_verbs.h"
#include "verbs/verbs.h"

namespace avo_cli {
namespace {

constexpr double kFigureWidth = 340.0;  // pt

std::string title_of(const avo_io::Decision& decision) {
  return fmt::format("robot {} at {:.6g} s: {}", decision.robot, decision.time,
                     avo::to_string(decision.state.state));
}

/// Calls f(); errors then name the option that caused them.
template <typename F>
auto by_option(F f) {
  try {
    return f();
  } catch (const avo::Error& error) {
    throw UsageError(std::string("--") + error.what());
  }
}

bool approach(const ExplainArguments& arguments, const avo::Scenario& scenario,
              avo::Simulation& simulation) {
  Progress progress(arguments.time);  // wiped before other output
  const auto go_on = [&] {
    progress.show(simulation.time());
    return signal_caught() == 0;
  };
  return by_option([&] {
    return avo_io::approach_decision(scenario, arguments.robot, arguments.time, simulation, go_on);
  });
}

}  // namespace

int explain(const ExplainArguments& arguments) {
  const NamedFile velocities{"--figure", arguments.figure}, places{"--states", arguments.states};
  require_figure(velocities);
  require_figure(places);
  catch_signals();
  if (const auto in_space = load_in_space(arguments.scene, {velocities, places}))
    return explain_in_space(arguments, *in_space);
  const avo::Scenario scenario = load(arguments.scene, {velocities, places});
  by_option([&] { avo_io::require_explainable(scenario, arguments.robot, arguments.time); });
  std::optional<avo_io::OutputFile> figure, states;
  if (!arguments.figure.empty()) figure.emplace(arguments.figure);
  if (!arguments.states.empty()) states.emplace(arguments.states);

  avo::Simulation simulation(scenario);
  tell_machine(simulation);
  if (!approach(arguments, scenario, simulation)) return kSignal + signal_caught();
  const avo::RobotId robot{static_cast<std::uint64_t>(arguments.robot)};
  const avo_io::Decision decision = avo_io::explain(simulation, scenario.name, robot);
  const avo::figures::FigureOptions options{.width = kFigureWidth, .title = title_of(decision)};
  if (figure) {
    figure->write(drawn([&] {
      return draw_velocity_space(
          avo::figures::velocity_space(decision.seen, simulation.planner(robot)), arguments.figure,
          options);
    }));
  }
  if (states) {
    states->write(drawn([&] {
      return draw_state_map(decision.seen, simulation.planner(robot), arguments.states, options);
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
