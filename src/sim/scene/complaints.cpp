// SPDX-License-Identifier: Apache-2.0
// The words for broken assumptions of a certificate.
#include "sim/scene/complaints.h"

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <utility>
#include <vector>

#include "avo/error.h"
#include "robots/footprint.h"
#include "sim/scene/assumptions.h"
#include "sim/scene/edit_checks.h"
#include "sim/scene/scene_checks.h"

namespace avo::inline sim {
namespace {

const RobotSetup& setup_of(const Scenario& scenario, RobotId robot) {
  return listed_as(robot, scenario.robots);
}
const RobotSetup* setup_of(const Scenario& scenario, BodyId body) {
  const auto* robot = std::get_if<RobotId>(&body);
  return robot != nullptr ? &setup_of(scenario, *robot) : nullptr;
}

// One unit of the sixth digit: a power of ten, as formatting and reading round it, correctly.
double sixth_digit(double value) {
  char buffer[32];
  constexpr auto kScientific = std::chars_format::scientific;
  const std::string digits(
      buffer, std::to_chars(buffer, buffer + sizeof buffer, value, kScientific, 5).ptr);
  const int power = std::atoi(digits.c_str() + digits.find('e') + 1);
  return std::strtod(("1e" + std::to_string(power - 5)).c_str(), nullptr);
}
// Six digits, rounded upwards or downwards so that a user with these digits is within the limit.
std::string at_least(double value) {
  const double unit = sixth_digit(value);
  return rounded(std::ceil(value / unit * (1.0 - 5e-13)) * unit, 6);
}
std::string at_most(double value) {
  const double unit = sixth_digit(value);
  return rounded(std::floor(value / unit) * unit, 6);
}

std::string further(std::int64_t count, std::size_t named, const std::string& what) {
  const std::int64_t rest = count - static_cast<std::int64_t>(named);
  return (count >= BrokenAssumptions::kCounted ? "at least " : "") + std::to_string(rest) +
         " further " + what;
}

bool flies(const Scenario& scenario, BodyId body) {
  const RobotSetup* robot = setup_of(scenario, body);
  return robot != nullptr && !can_rest(robot->model);
}

// What should keep the two apart, "both brake at once" or the like.
std::string fallback_of(const BrokenStart& start, const Scenario& scenario,
                        const Wording& wording) {
  const auto alone = [&](BodyId robot) {
    return wording.name_of(robot) + (flies(scenario, robot) ? " circles" : " brakes");
  };
  if (std::holds_alternative<MovingObstacleId>(start.other)) return alone(start.robot) + " at once";
  const bool flight = flies(scenario, start.robot);
  if (flight != flies(scenario, start.other))
    return alone(start.robot) + " and " + alone(start.other) + " at once";
  return flight ? "both circle at once" : "both brake at once";
}

// Returns whether start_at_rest() would change its start.
bool can_slow_down(const Scenario& scenario, BodyId body) {
  Scenario alone;
  if (const RobotSetup* robot = setup_of(scenario, body)) alone.robots.push_back(*robot);
  return start_at_rest(alone) > 0;
}

std::string complaint_of(const SensingNeed& need, const Scenario& scenario,
                         const Wording& wording) {
  const double speed = admissible_speed(scenario);
  const bool fly = flies(scenario, need.robot) || flies(scenario, need.other);
  return "sensing_radius: found " + text(sensing_radius_of(scenario)) +
         " m, must be >= " + at_least(need.range) + " m for " + wording.name_of(need.robot) +
         " and " + wording.name_of(need.other) + " to see each other in time, " +
         rounded(need.robot_part, 6) + " + " + rounded(need.other_part, 6) +
         " m with one step and " + (fly ? "braking or circling at" : "braking from") +
         " their highest speeds; " +
         (speed > 0.0 ? "sense farther, or lower max_speed to " + at_most(speed) + " m/s (" +
                            wording.remedies.limit_speed + ")"
                      : "sense farther, no max_speed is low enough");
}

}  // namespace

namespace {

bool is_disc(const Scenario& scenario, BodyId body) {
  const RobotSetup* robot = setup_of(scenario, body);
  return robot == nullptr || !has_footprint(robot->model);
}

double radius_of(const Scenario& scenario, BodyId body) {
  if (const RobotSetup* robot = setup_of(scenario, body)) return disc_radius(*robot);
  return listed_as(std::get<MovingObstacleId>(body), scenario.moving_obstacles).radius;
}

}  // namespace

std::string complaint(const BrokenStart& start, const Scenario& scenario, const Wording& wording) {
  const double own = radius_of(scenario, start.robot), other = radius_of(scenario, start.other);
  const std::string pair = wording.name_of(start.robot) + " and " + wording.name_of(start.other);
  const bool are_discs = is_disc(scenario, start.robot) && is_disc(scenario, start.other);
  if (start.distance < (1.0 - 1e-9) * (own + other) && !are_discs)
    return pair + " overlap at the start: found " + rounded(own + other - start.distance, 6) +
           " m of overlap of their footprints, must be none; move them apart";
  if (start.distance < (1.0 - 1e-9) * (own + other))
    return pair + " overlap at the start: found " + rounded(start.distance, 6) +
           " m between the centers, must be >= " + rounded(own, 6) + " + " + rounded(other, 6) +
           " = " + rounded(own + other, 6) + " m; move them apart";
  const bool are_fast =
      can_slow_down(scenario, start.robot) || can_slow_down(scenario, start.other);
  return pair + " start too " + (are_fast ? "fast for their distance" : "near each other") +
         ": found " + rounded(start.depth, 3) + " m of overlap when " +
         fallback_of(start, scenario, wording) + ", must be none; " +
         (are_fast ? "slow down, move apart, or " + wording.remedies.start_at_rest : "move apart");
}

std::string complaint(const WallStart& start, const Scenario& scenario, const Wording& wording) {
  const RobotSetup& setup = setup_of(scenario, start.robot);
  const double own = route_radius(setup.model, disc_radius(setup));
  const double wall = listed_as(start.obstacle, scenario.obstacles).radius;
  const double margin = start.required - own - wall;
  const std::string name = wording.name_of(start.robot);
  const std::string place = wording.name_of_static(start.obstacle);
  if (start.distance < start.required)
    return name + " starts too near " + place + ": found " +
           text(setup_of(scenario, start.robot).position) + ", " + rounded(start.distance, 9) +
           " m from it, must be >= " + rounded(own, 6) + " + " + rounded(wall, 6) + " m and " +
           rounded(margin, 2) + " m for rounding; move it away";
  const bool is_fast = can_slow_down(scenario, start.robot);
  return name + " starts too " + (is_fast ? "fast for " : "near ") + place + ": found " +
         rounded(start.kept, 6) + " m left when it " +
         (flies(scenario, start.robot) ? "circles" : "brakes") + ", must be >= " + rounded(own, 6) +
         " + " + rounded(wall, 6) + " m; " +
         (is_fast ? "slow down, move it away, or " + wording.remedies.start_at_rest
                  : "move it away");
}

std::string complaint(const MisplacedStart& start, const Scenario& scenario,
                      const Wording& wording) {
  const bool solid = listed_as(start.obstacle, scenario.obstacles).fill == Fill::solid;
  return "position of " + wording.name_of(start.robot) + ": found " +
         text(setup_of(scenario, start.robot).position) + ", must be " +
         (solid ? "outside of the solid " : "inside of the bounds ") +
         wording.name_of_static(start.obstacle);
}

std::string complaint(const FastStart& start, const Scenario& scenario, const Wording& wording) {
  return "velocity of " + wording.name_of(start.robot) + ": found " + text(start.speed) +
         " m/s at the start, must be <= its max_speed = " +
         text(setup_of(scenario, start.robot).max_speed) + " m/s; slow down, or " +
         wording.remedies.limit_speed + " or " + wording.remedies.start_at_rest;
}

void refuse_start(const std::string& complaint) {
  throw Error(complaint + "; or allow_broken_assumptions");
}

void require_assumptions(const Scenario& scenario) {
  if (scenario.allow_broken_assumptions) return;
  const std::vector<std::string> lines = complaints(scenario);
  if (lines.empty()) return;
  const std::size_t more = lines.size() - 1;
  refuse_start(lines.front() + (more > 0 ? " [" + std::to_string(more) + " more]" : ""));
}

}  // namespace avo::inline sim

namespace avo {

std::vector<std::string> complaints(const Scenario& scenario, const RemedyNames& remedies) {
  const Wording wording{remedies, [](BodyId body) { return name_of(body); },
                        [](ObstacleId id) { return "obstacles." + std::to_string(id.value); }};
  const BrokenAssumptions broken = broken_assumptions(scenario);
  std::vector<std::string> lines;
  const auto tell = [&](const auto& list, std::int64_t count, const char* others) {
    for (const auto& start : list) lines.push_back(complaint(start, scenario, wording));
    if (count > static_cast<std::int64_t>(list.size()))
      lines.push_back(further(count, list.size(), others));
  };
  tell(broken.starts, broken.start_count, "pairs overlap or start too fast for their distance");
  tell(broken.beside, broken.beside_count, "robots start too near an obstacle, or too fast for it");
  tell(broken.misplaced, broken.misplaced_count, "robots start inside of solids or out of bounds");
  tell(broken.fast, broken.fast_count, "robots start faster than their max_speed");
  if (broken.unseen) lines.push_back(complaint_of(*broken.unseen, scenario, wording));
  return lines;
}

}  // namespace avo
