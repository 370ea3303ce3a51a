// SPDX-License-Identifier: Apache-2.0
// The results of avo run, as text.
#include "reports/run_report.h"

#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <optional>
#include <span>

#include "avo_io/printable.h"
#include "system/terminal.h"

namespace avo_cli {
namespace {

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
    text += fmt::format("; {} more of which one avoids the other only, {} of them while it moved",
                        results.one_sided_collisions, results.one_sided_collisions_in_motion);
  text += fmt::format("; {} with moving obstacles", results.mover_collisions);
  if (results.mover_collisions > 0)
    text += fmt::format(", {} of them in motion", results.mover_collisions_in_motion);
  if (results.mover_collisions_evadable.value_or(0) > 0)
    text += fmt::format(", {} evadable at first sight", *results.mover_collisions_evadable);
  text += fmt::format("; {} robots with obstacles", results.static_collisions);
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
  add(d.refused, avo::PlanStatus::refused);
  add(d.detour, avo::PlanStatus::detour);
  add(d.braking, avo::PlanStatus::braking);
  add(d.overlapping, avo::PlanStatus::overlapping);
  add(d.invalid_input, avo::PlanStatus::invalid_input);
  return text;
}

/// Returns an empty text if no robot has accelerated twice.
std::string smoothness(const avo::RunMetrics& metrics) {
  if (!metrics.jerk) return "";
  std::string text = fmt::format("jerk {:.3g} m/s^3, acceleration {:.3g} a_max (rms)",
                                 *metrics.jerk, metrics.acceleration_rms.value_or(0.0));
  if (metrics.turned_back)
    text += fmt::format(", {:.3g} % of the steps turned back", 100.0 * *metrics.turned_back);
  return text;
}

/// Returns whether the robot moves at the end, and what stands before it.
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
  if (robot.passage)
    text += fmt::format(" at the passage at [{:.3g}, {:.3g}]", robot.passage->x, robot.passage->y);
  return text;
}

/// Returns the robots that have not arrived, the first of them by number and with their states;
/// empty if there are none.
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

/// Returns the decisions of all robots.
std::int64_t decided(const avo::RunSummary& results) {
  const avo::Decisions& d = results.decisions;
  return d.optimal + d.least_unsafe + d.refused + d.detour + d.braking + d.overlapping +
         d.invalid_input;
}

std::string steps_of(const avo::Scenario& scenario, std::int64_t steps) {
  if (scenario.clock == avo::Clock::common)
    return fmt::format("{} steps of {} s", steps, scenario.time_step);
  return fmt::format("{} steps by clocks of their own", steps);
}

}  // namespace

void tell_unreachable(const avo::RunSummary& results) {
  constexpr std::size_t kNamed = 10;
  const std::size_t count = results.unreachable.size();
  if (count == 0) return;
  const std::size_t named = std::min(kNamed, count);
  std::string who;
  for (const std::uint64_t robot : std::span(results.unreachable).first(named)) {
    who += fmt::format("{}{}", who.empty() ? "" : ", ", robot);
    const auto entry = std::find_if(results.not_arrived.begin(), results.not_arrived.end(),
                                    [&](const auto& other) { return other.robot == robot; });
    if (entry != results.not_arrived.end())
      who += fmt::format(" (to {:.3g} m)", entry->distance_left);
  }
  if (count > named) who += fmt::format(" and {} more", count - named);
  warn(
      {fmt::format("no route between the obstacles leads to the {} {}; a route has to be as wide "
                   "as the robot, and a goal as far from an obstacle as its radius; robots go as "
                   "near as they can",
                   count == 1 ? "goal of robot" : "goals of robots", who)});
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
  if (results.min_static_clearance)
    line("  from obstacles", number(results.min_static_clearance, "m"));
  line("largest", fmt::format("acceleration {:.6g} m/s^2, speed {:.6g} m/s",
                              results.max_acceleration, results.max_speed));
  if (results.acceleration_excess > 0.0)
    line("exceeds",
         fmt::format("max_acceleration, by up to {:.6g} m/s^2", results.acceleration_excess));
  line("no safe choice",
       fmt::format("{} of {} robot-steps", results.infeasible_steps, decided(results)));
  line("decisions", decisions(results));
  if (const std::string how = smoothness(results.metrics); !how.empty()) line("smoothness", how);
  if (const std::string who = not_arrived(results); !who.empty()) line("not arrived", who);
  line("time of a step", number(results.step_milliseconds_median, "ms (median)"));
  return text;
}

}  // namespace avo_cli
