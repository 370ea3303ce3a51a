// SPDX-License-Identifier: Apache-2.0
#include "space/evading.h"

#include <algorithm>
#include <limits>

#include "avo/space/planner.h"
#include "planner/rules/arrival.h"
#include "space/mover_constraints.h"
#include "space/own_space.h"

namespace avo::space {
namespace {

double time_to_evade(const Robot& robot) {
  return time_to_speed(numbers_of(robot));
}

// m/s: its highest speed in any direction.
double fastest_of(const Robot& robot) {
  const double own = std::max(robot.max_speed, own_length(robot.velocity, robot.vertical));
  return own * std::max(robot.vertical, 1.0);
}

Predicted predicted(const Evading& evading, const Mover& mover, const Level& level) {
  const StepLaw& law = evading.law;
  const Robot& robot = evading.robot;
  const SensingError error = error_against(mover, law);
  const double contact = robot.radius + mover.radius;
  const double kept = contact + error.position + parabola_error(mover, law);
  const double time = evading.search.longest + law.time_step + evading.braking;
  Predicted other;
  other.position = mover.position - robot.position;
  other.velocity = mover.velocity;
  // an effect below this within that time is rounding
  if (norm(mover.acceleration) * time * time > 0x1p-30 * contact)
    other.acceleration = mover.acceleration;
  other.contact = kept + level.margin * contact;
  other.stop_contact = kept + 0.5 * level.margin * contact;
  other.drift = error.velocity;
  other.deviation = mover.max_deviation;
  other.reaction = level.reaction * time_to_evade(robot);
  other.asks_to_stop = level.stops;
  other.until = level.until * evading.search.longest;
  other.max_speed = mover.max_speed;
  other.fastest =
      norm(mover.velocity) + error.velocity + other.deviation * (other.reaction + evading.braking);
  return other;
}

// s, until an evasive maneuver brakes: long enough to leave the strip of the widest moving
// obstacle.
double longest_beside(const Robot& robot, std::span<const Mover> movers, const StepLaw& law) {
  const double time = time_to_evade(robot);
  double contact = 0.0;  // m
  for (const Mover& mover : movers) contact = std::max(contact, robot.radius + mover.radius);
  const double wide = time + 2.0 * contact / robot.max_speed;
  return std::min(std::clamp(wide, kLongestEvasion * time, kWideEvasion * time),
                  kMostEvasionSteps * law.time_step);
}

}  // namespace

void look_around(Evading& evading, const Level& level) {
  EvasionSearch& search = evading.search;
  search.work = kMostWork;
  // the certificate counts on that much, in spite of rounding
  constexpr double kWithin = 1.0 - 0x1p-48;
  search.increment =
      kWithin * level.part * evading.robot.max_acceleration * evading.law.braking_time;
  search.others.clear();
  for (const Mover& mover : evading.sight.movers)
    search.others.push_back(predicted(evading, mover, level));
  begin_evasions(search);
}

std::optional<Evading> begin_evading(const PlannerOptions& options, const StepLaw& law,
                                     const Robot& robot, const Sight& sight, EvasionSearch& search,
                                     ChoiceWorkspace& workspace) {
  const double own = std::max(robot.max_speed, own_length(robot.velocity, robot.vertical));
  const double decrement = braking_limit(robot) * law.braking_time;
  if (!(own <= kMostBraking * decrement)) return std::nullopt;
  search.law = law;
  search.robot = robot;
  search.max_speed = fastest_of(robot);
  search.longest = longest_beside(robot, sight.movers, law);
  const double range = std::max((1.0 + 1e-9) * box_reach(robot, law), options.wall_range);
  search.boxes.clear();
  for (const Box& box : sight.boxes) {
    if (nearest(robot.position, robot.position, box).distance - box.radius <= range)
      search.boxes.push_back(box);
  }
  search.known = search.boxes.empty() ? std::numeric_limits<double>::infinity()
                                      : range - (1.0 + 1e-9) * robot.radius;
  Evading evading{law, robot, sight, search, workspace, law.time_step * (2.0 + own / decrement)};
  return evading;
}

double evasion_range(const Robot& robot) {
  return (kWideEvasion + 0.5) * time_to_evade(robot) * fastest_of(robot);
}

}  // namespace avo::space
