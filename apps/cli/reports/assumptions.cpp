// SPDX-License-Identifier: Apache-2.0
// Remedies for scenes that break the assumptions of their certificate.
#include "reports/assumptions.h"

#include <algorithm>
#include <cstdint>
#include <fmt/format.h>

#include "avo/assumptions.h"
#include "avo_io/complaints.h"
#include "exit_codes.h"
#include "system/terminal.h"

namespace avo_cli {

void apply_remedies(const SceneArguments& arguments, avo::Scenario& scenario) {
  if (arguments.start_at_rest) {
    const std::int64_t count = avo::start_at_rest(scenario);
    const bool any_flies =
        std::any_of(scenario.robots.begin(), scenario.robots.end(),
                    [](const avo::RobotSetup& robot) { return !can_rest(robot.model); });
    say(fmt::format("--start-at-rest: {} of {} robots start {} instead of moving{}", count,
                    scenario.robots.size(),
                    any_flies ? "at rest, or at their min_speed," : "at rest",
                    any_flies ? " faster" : ""));
  }
  if (!arguments.limit_speed) return;
  const avo::LimitedSpeeds limited = avo::limit_speed(scenario);
  std::string text = fmt::format("--limit-speed: max_speed of {} of {} robots lowered",
                                 limited.robots, scenario.robots.size());
  if (limited.robots > 0) text += fmt::format(" to {} m/s", limited.limit);
  if (limited.starts > 0) text += fmt::format(", {} start slower", limited.starts);
  say(text);
}

void require_assumptions(const std::string& scene, const avo::Scenario& scenario) {
  std::vector<std::string> lines = avo_io::complaints(scenario);
  for (std::string& line : lines) line = fmt::format("{}: {}", scene, line);
  if (lines.empty()) return;
  if (!scenario.allow_broken_assumptions) throw BrokenScene(lines);
  warn(lines);
}

}  // namespace avo_cli
