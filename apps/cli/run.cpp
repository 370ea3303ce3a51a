// SPDX-License-Identifier: Apache-2.0
// avo run: simulates a scene to its end, and writes what was asked for.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <fmt/format.h>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "avo/metrics.h"
#include "avo/simulation.h"
#include "avo_io/output_file.h"
#include "avo_io/printable.h"
#include "avo_io/recording.h"
#include "exit_codes.h"
#include "figures/trajectories.h"
#include "files.h"
#include "signals.h"
#include "terminal.h"
#include "verbs.h"

namespace avo_cli {
namespace {

std::vector<NamedFile> files_of(const RunArguments& arguments) {
  return {{"--record", arguments.record},
          {"--summary", arguments.summary},
          {"--figure", arguments.figure}};
}

/// Everything that a run writes. Opened before the simulation, so that a place that cannot be
/// written is reported at once; named after it.
struct Outputs {
  std::optional<avo_io::CsvRecording> record;
  std::optional<avo_io::OutputFile> summary, figure;
  std::optional<avo::figures::TrajectoryRecorder> trajectories;
  std::string figure_path;

  Outputs(const RunArguments& arguments, const avo::Scenario& scenario)
      : figure_path(arguments.figure) {
    if (!arguments.figure.empty()) {
      figure.emplace(arguments.figure);
      trajectories.emplace();
    }
    if (!arguments.summary.empty()) summary.emplace(arguments.summary);
    if (!arguments.record.empty()) record.emplace(arguments.record, avo_io::has_headings(scenario));
  }

  void observe(const avo::Simulation& simulation) {
    if (record) record->add(simulation);
    if (trajectories) trajectories->observe(simulation);
  }

  /// All of them, or none where one cannot be written. A figure can take longer to draw than a
  /// signal leaves: then the others come first.
  void finish(const avo::Scenario& scenario, const avo::RunSummary& results) {
    std::vector<avo_io::OutputFile*> files;
    if (record) files.push_back(&record->file());
    if (summary) files.push_back(&*summary);
    if (summary) summary->write(avo_io::to_json(results));
    if (signal_caught() != 0) commit_all(files);
    if (figure) files.push_back(&*figure);
    if (figure)
      figure->write(
          drawn([&] { return draw_trajectories(scenario, trajectories->frames(), figure_path); }));
    commit_all(files);
  }
};

avo::RunSummary simulate(const avo::Scenario& scenario, int threads, Outputs& outputs) {
  using Clock = std::chrono::steady_clock;
  avo::Simulation simulation(scenario, threads);
  avo::Metrics metrics(scenario);
  Progress progress(scenario.duration);
  metrics.observe(simulation);
  outputs.observe(simulation);
  while (simulation.can_step_by(scenario.duration) && signal_caught() == 0) {
    const Clock::time_point start = Clock::now();
    simulation.step();
    metrics.add_step_time(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    metrics.observe(simulation);
    outputs.observe(simulation);
    progress.show(simulation.time());
  }
  return metrics.summary();
}

std::string arrivals(const avo::RunSummary& results) {
  std::string text = fmt::format("{} of {}", results.arrived, results.robots);
  if (results.mean_arrival)
    text += fmt::format(", after {:.1f} s on average", *results.mean_arrival);
  if (results.last_arrival) text += fmt::format(", the last after {:.1f} s", *results.last_arrival);
  return text;
}

std::string collisions(const avo::RunSummary& results) {
  std::string text = fmt::format("{} pairs of robots", results.collision_pairs);
  if (results.first_collision_time)
    text += fmt::format(", the first at {:.1f} s", *results.first_collision_time);
  if (results.one_sided_collisions > 0)
    text +=
        fmt::format("; {} more of which one avoids the other only", results.one_sided_collisions);
  text += fmt::format("; {} with moving obstacles", results.obstacle_collisions);
  if (results.obstacle_collisions > 0)
    text += fmt::format(", {} of them in motion", results.obstacle_collisions_in_motion);
  text += fmt::format("; {} robots with obstacles", results.collision_obstacles);
  if (results.first_seen_too_late.value_or(0) > 0)
    text += fmt::format("; {} pairs first seen too late", *results.first_seen_too_late);
  return text;
}

std::string decisions(const avo::RunSummary& results) {
  const avo::Decisions& d = results.decisions;
  std::string text = fmt::format("{} optimal", d.optimal);
  const auto add = [&](std::int64_t count, avo::PlanStatus status) {
    if (count > 0) text += fmt::format(", {} {}", count, avo::to_string(status));
  };
  add(d.least_unsafe, avo::PlanStatus::least_unsafe);
  add(d.candidate, avo::PlanStatus::candidate);
  add(d.braking, avo::PlanStatus::braking);
  add(d.overlapping, avo::PlanStatus::overlapping);
  add(d.invalid_input, avo::PlanStatus::invalid_input);
  return text;
}

/// Whether the robot moves at the end, and who is in its way.
std::string state_of(const avo::NotArrived& robot) {
  constexpr double kAtRest = 1e-3;  // m/s
  std::string text =
      robot.speed > kAtRest ? fmt::format("moving at {:.2g} m/s", robot.speed) : "at rest";
  const char* separator = ", held by ";
  for (const std::int64_t other : robot.held_by) {
    text +=
        separator + (other >= 0 ? std::to_string(other) : fmt::format("obstacle {}", -1 - other));
    separator = ", ";
  }
  return text;
}

/// Who has not arrived, the first by number with their states; empty if nobody.
std::string not_arrived(const avo::RunSummary& results) {
  constexpr std::size_t kNamed = 5;
  const std::size_t named = std::min(kNamed, results.not_arrived.size());
  std::string text;
  for (const avo::NotArrived& robot : std::span(results.not_arrived).first(named))
    text += fmt::format("{}robot {}, {:.1f} m to go, {}", text.empty() ? "" : "; ", robot.robot,
                        robot.distance, state_of(robot));
  const std::int64_t others = results.robots - results.arrived - static_cast<std::int64_t>(named);
  return others > 0 ? fmt::format("{}{}{} more", text, text.empty() ? "" : "; ", others) : text;
}

/// One line on robots that walls keep from their goals; nothing where there are none.
void tell_unreachable(const avo::RunSummary& results) {
  constexpr std::size_t kNamed = 10;
  const std::size_t count = results.unreachable.size();
  if (count == 0) return;
  std::string who;
  for (const std::uint64_t robot : std::span(results.unreachable).first(std::min(kNamed, count)))
    who += fmt::format("{}{}", who.empty() ? "" : ", ", robot);
  if (count > kNamed) who += fmt::format(" and {} more", count - kNamed);
  say(fmt::format(
      "warning: no way between the obstacles leads to the {} {}; a way has to be as wide as the "
      "robot, and a goal as far from an obstacle as its radius",
      count == 1 ? "goal of robot" : "goals of robots", who));
}

/// Of all robots.
std::int64_t decided(const avo::RunSummary& results) {
  const avo::Decisions& d = results.decisions;
  return d.optimal + d.least_unsafe + d.candidate + d.braking + d.overlapping + d.invalid_input;
}

std::string steps_of(const avo::Scenario& scenario, std::int64_t steps) {
  if (scenario.clock == avo::Clock::common)
    return fmt::format("{} steps of {} s", steps, scenario.time_step);
  return fmt::format("{} steps by clocks of their own", steps);
}

std::string readable(const avo::Scenario& scenario, const avo::RunSummary& results) {
  const auto number = [](const std::optional<double>& value, const char* unit) {
    return value ? fmt::format("{:.3g} {}", *value, unit) : std::string("-");
  };
  const std::string parked =
      results.parked > 0 ? fmt::format(" ({} parked)", results.parked) : std::string();
  std::string text = fmt::format("{}: {} robots{}, {}\n", avo_io::printable(results.scene),
                                 results.robots, parked, steps_of(scenario, results.steps));
  const auto line = [&](const char* name, const std::string& value) {
    text += fmt::format("  {:<18} {}\n", name, value);
  };
  line("arrived", arrivals(results));
  line("collisions", collisions(results));
  line("least clearance", number(results.min_clearance, "m"));
  if (results.min_obstacle_clearance)
    line("  from obstacles", number(results.min_obstacle_clearance, "m"));
  line("largest", fmt::format("acceleration {:.6g} m/s^2, speed {:.6g} m/s",
                              results.max_acceleration, results.max_speed));
  if (results.acceleration_excess > 0.0)
    line("exceeds",
         fmt::format("max_acceleration, by up to {:.6g} m/s^2", results.acceleration_excess));
  line("no safe choice",
       fmt::format("{} of {} robot-steps", results.infeasible_steps, decided(results)));
  line("decisions", decisions(results));
  if (const std::string who = not_arrived(results); !who.empty()) line("not arrived", who);
  line("time of a step", number(results.step_milliseconds_median, "ms (median)"));
  return text;
}

}  // namespace

int run(const RunArguments& arguments) {
  require_ending({"--record", arguments.record}, ".csv");
  require_ending({"--summary", arguments.summary}, ".json");
  require_figure({"--figure", arguments.figure});
  catch_signals();
  const avo::Scenario scenario = load(arguments.scene, files_of(arguments));
  Outputs outputs(arguments, scenario);
  const avo::RunSummary results = simulate(scenario, arguments.threads, outputs);
  outputs.finish(scenario, results);
  tell_unreachable(results);
  const std::string text = readable(scenario, results);
  if (arguments.record == "-" || arguments.summary == "-")
    say(lines_of(text));
  else
    print(text);
  const int caught = signal_caught();
  if (caught == 0) return kDone;
  const std::string part = scenario.clock == avo::Clock::free
                               ? fmt::format("{} steps", results.steps)
                               : fmt::format("{} of {} steps", results.steps,
                                             avo::last_step(scenario, scenario.duration));
  say(fmt::format("stopped by a signal after {}; all outputs end there", part));
  return kSignal + caught;
}

}  // namespace avo_cli
