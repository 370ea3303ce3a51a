// SPDX-License-Identifier: Apache-2.0
// Words for what a certificate assumes.
#include "avo_io/complaints.h"

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fmt/format.h>

#include "avo/assumptions.h"

namespace avo_io {
namespace {

using avo::BrokenAssumptions;

const avo::RobotSetup& setup_of(const avo::Scenario& scenario, int robot) {
  return scenario.robots[static_cast<std::size_t>(robot)];
}

std::string name_of(int source) {
  return source >= 0 ? fmt::format("robot {}", source)
                     : fmt::format("moving obstacle {}", -1 - source);
}

// One of the sixth digit: a power of ten, as formatting and reading round it, correctly.
double sixth_digit(double value) {
  const std::string digits = fmt::format("{:.5e}", value);
  const int exponent = std::atoi(digits.c_str() + digits.find('e') + 1);
  return std::strtod(fmt::format("1e{}", exponent - 5).c_str(), nullptr);
}
// Six digits, rounded so that whoever types them is within the limit: upwards or downwards.
std::string at_least(double value) {
  const double unit = sixth_digit(value);
  return fmt::format("{:.6g}", std::ceil(value / unit * (1.0 - 5e-13)) * unit);
}
std::string at_most(double value) {
  const double unit = sixth_digit(value);
  return fmt::format("{:.6g}", std::floor(value / unit) * unit);
}

std::string further(std::int64_t count, std::size_t named, const char* what) {
  const std::int64_t rest = count - static_cast<std::int64_t>(named);
  return fmt::format("{}{} further {}", count >= BrokenAssumptions::kCounted ? "at least " : "",
                     rest, what);
}

bool flies(const avo::Scenario& scenario, int source) {
  return source >= 0 && is_airplane(setup_of(scenario, source).model);
}

// What keeps the two apart, "both brake at once" or the like.
std::string fallback_of(const avo::BrokenStart& start, const avo::Scenario& scenario) {
  const auto alone = [&](int robot) {
    return name_of(robot) + (flies(scenario, robot) ? " circles" : " brakes");
  };
  if (start.other < 0) return alone(start.robot) + " at once";
  const bool flight = flies(scenario, start.robot);
  if (flight != flies(scenario, start.other))
    return alone(start.robot) + " and " + alone(start.other) + " at once";
  return flight ? "both circle at once" : "both brake at once";
}

// Whether --start-at-rest would change how it starts.
bool can_slow_down(const avo::Scenario& scenario, int source) {
  avo::Scenario alone;
  if (source >= 0) alone.robots.push_back(setup_of(scenario, source));
  return avo::start_at_rest(alone) > 0;
}

std::string complaint(const avo::BrokenStart& start, const avo::Scenario& scenario) {
  const double own = disc_radius(setup_of(scenario, start.robot));
  const double other =
      start.other >= 0
          ? disc_radius(setup_of(scenario, start.other))
          : scenario.moving_obstacles[static_cast<std::size_t>(-1 - start.other)].radius;
  const std::string pair = name_of(start.robot) + " and " + name_of(start.other);
  if (start.distance < (1.0 - 1e-9) * (own + other))
    return fmt::format(
        "{} overlap at the start: found {:.6g} m between the centers, must be >= {:.6g} + "
        "{:.6g} = {:.6g} m; move them apart",
        pair, start.distance, own, other, own + other);
  const bool are_fast =
      can_slow_down(scenario, start.robot) || can_slow_down(scenario, start.other);
  return fmt::format("{} start too {}: found {:.3g} m of overlap when {}, must be none; {}", pair,
                     are_fast ? "fast for their distance" : "near each other", start.depth,
                     fallback_of(start, scenario),
                     are_fast ? "slow down, move apart, or --start-at-rest" : "move apart");
}

std::string complaint(const avo::WallStart& start, const avo::Scenario& scenario) {
  const double own = disc_radius(setup_of(scenario, start.robot));
  const double wall = scenario.obstacles[static_cast<std::size_t>(start.obstacle)].radius;
  const double margin = start.required - own - wall;
  const avo::Vec2 p = setup_of(scenario, start.robot).position;
  if (start.distance < start.required)
    return fmt::format(
        "{} starts too near obstacles.{}: found [{}, {}], {:.9g} m from it, must be >= {:.6g} + "
        "{:.6g} m and {:.2g} m for rounding; move it away",
        name_of(start.robot), start.obstacle, p.x, p.y, start.distance, own, wall, margin);
  const bool is_fast = can_slow_down(scenario, start.robot);
  return fmt::format(
      "{} starts too {} obstacles.{}: found {:.6g} m left when it {}, must be >= {:.6g} + {:.6g} "
      "m; "
      "{}",
      name_of(start.robot), is_fast ? "fast for" : "near", start.obstacle, start.kept,
      flies(scenario, start.robot) ? "circles" : "brakes", own, wall,
      is_fast ? "slow down, move it away, or --start-at-rest" : "move it away");
}

std::string complaint(const avo::MisplacedStart& start, const avo::Scenario& scenario) {
  const avo::Vec2 p = setup_of(scenario, start.robot).position;
  const bool solid =
      scenario.obstacles[static_cast<std::size_t>(start.obstacle)].fill == avo::Fill::solid;
  return fmt::format("position of {}: found [{}, {}], must be {} obstacles.{}",
                     name_of(start.robot), p.x, p.y,
                     solid ? "outside of the solid" : "inside of the bounds", start.obstacle);
}

std::string complaint(const avo::FastStart& start, const avo::Scenario& scenario) {
  return fmt::format(
      "velocity of {}: found {} m/s at the start, must be <= its max_speed = {} m/s; "
      "slow down, or --limit-speed or --start-at-rest",
      name_of(start.robot), start.speed, setup_of(scenario, start.robot).max_speed);
}

std::string complaint(const avo::SensingNeed& need, const avo::Scenario& scenario) {
  const double speed = avo::admissible_speed(scenario);
  return fmt::format(
      "sensing_radius: found {} m, must be >= {} m for {} and {} to see each other in "
      "time, {:.6g} + {:.6g} m with one step and {} their highest speeds; {}",
      scenario.sensing_radius, at_least(need.range), name_of(need.robot), name_of(need.other),
      need.robot_part, need.other_part,
      flies(scenario, need.robot) || flies(scenario, need.other) ? "braking or circling at"
                                                                 : "braking from",
      speed > 0.0 ? fmt::format("sense farther, or lower max_speed to {} m/s "
                                "(--limit-speed)",
                                at_most(speed))
                  : std::string("sense farther, no max_speed is low enough"));
}

}  // namespace

std::vector<std::string> complaints(const avo::Scenario& scenario) {
  const BrokenAssumptions broken = avo::broken_assumptions(scenario);
  std::vector<std::string> lines;
  for (const avo::BrokenStart& start : broken.starts) lines.push_back(complaint(start, scenario));
  if (broken.start_count > static_cast<std::int64_t>(broken.starts.size()))
    lines.push_back(further(broken.start_count, broken.starts.size(),
                            "pairs overlap or start too fast for their distance"));
  for (const avo::WallStart& start : broken.beside) lines.push_back(complaint(start, scenario));
  if (broken.beside_count > static_cast<std::int64_t>(broken.beside.size()))
    lines.push_back(further(broken.beside_count, broken.beside.size(),
                            "robots start too near an obstacle, or too fast for it"));
  for (const avo::MisplacedStart& start : broken.misplaced)
    lines.push_back(complaint(start, scenario));
  if (broken.misplaced_count > static_cast<std::int64_t>(broken.misplaced.size()))
    lines.push_back(further(broken.misplaced_count, broken.misplaced.size(),
                            "robots start inside of solids or out of bounds"));
  for (const avo::FastStart& start : broken.fast) lines.push_back(complaint(start, scenario));
  if (broken.fast_count > static_cast<std::int64_t>(broken.fast.size()))
    lines.push_back(fmt::format("{} further robots start faster than their max_speed",
                                broken.fast_count - static_cast<std::int64_t>(broken.fast.size())));
  if (broken.unseen) lines.push_back(complaint(*broken.unseen, scenario));
  return lines;
}

}  // namespace avo_io
