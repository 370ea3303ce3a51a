// SPDX-License-Identifier: Apache-2.0
#include "planner/rules/evasion.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "core/plane.h"
#include "planner/rules/braking_evasion.h"
#include "planner/rules/flight_evasion.h"
#include "planner/scratch.h"
#include "planner/stages/certify.h"
#include "planner/validity.h"
#include "robots/model.h"

namespace avo::inline planner {
namespace {

// Where some neighbors are likely to deviate: this part of their likely_deviation counts.
constexpr Level likely_level(double part) {
  return {.part = 1.0, .margin = 0.0, .reaction = 0.5 * part, .likely = part};
}
constexpr int kLargerParts = 4;  // bisections

// Where no place is clear for ever, the disc of a circle, which can be left at once.
constexpr std::array<Level, 3> kCirclesForAWhile{{{1.0, 0.0, 0.0, true, 1.0},  //
                                                  {1.0, 0.0, 0.0, true, 0.5},
                                                  {1.0, 0.0, 0.0, true, 0.25}}};

bool flies(const Evading& evading) {
  return !can_rest(evading.robot.model);
}

EvasionFound find_evasion(Evading& evading, const Level& level, Vec2 wanted, Taken& found) {
  look_around(evading, level);
  return flies(evading) ? find_flight(evading, wanted, found)
                        : find_braking_evasion(evading, wanted, found);
}

bool are_some_likely_to_deviate(const Evading& evading) {
  return std::any_of(evading.sight.neighbors.begin(), evading.sight.neighbors.end(),
                     [](const Neighbor& n) { return !decides(n) && n.likely_deviation > 0.0; });
}

Level first_level(const Evading& evading) {
  return are_some_likely_to_deviate(evading) ? likely_level(1.0) : kLevels[0];
}

// Counts as much of the likely deviation as leaves an evasive maneuver, found by bisection.
EvasionFound find_evasion_if_likely(Evading& evading, Vec2 wanted, Taken& found) {
  EvasionFound outcome = find_evasion(evading, likely_level(1.0), wanted, found);
  if (outcome != EvasionFound::none) return outcome;
  outcome = find_evasion(evading, likely_level(0.0), wanted, found);
  if (outcome == EvasionFound::none) return outcome;
  double kept = 0.0, refused = 1.0;
  for (int k = 0; k < kLargerParts; ++k) {
    const double part = 0.5 * (kept + refused);
    const EvasionFound other = find_evasion(evading, likely_level(part), wanted, found);
    if (other == EvasionFound::none) {
      refused = part;
    } else {
      kept = part, outcome = other;
    }
  }
  return outcome;
}

EvasionFound find_evasion_in_order(Evading& evading, std::span<const Level> levels, Vec2 wanted,
                                   Taken& found) {
  for (const Level& level : levels) {
    const EvasionFound outcome = find_evasion(evading, level, wanted, found);
    if (outcome != EvasionFound::none) return outcome;
  }
  return EvasionFound::none;
}

// Nearly always the first level has one; where the weakest has none, hardly any other level has
// one.
EvasionFound find_evasion_by_levels(Evading& evading, std::span<const Level> levels, Vec2 wanted,
                                    Taken& found) {
  const EvasionFound outcome = find_evasion(evading, levels.front(), wanted, found);
  if (outcome != EvasionFound::none ||
      find_evasion(evading, levels.back(), wanted, found) == EvasionFound::none)
    return outcome;
  return find_evasion_in_order(evading, levels.subspan(1), wanted, found);
}

EvasionFound find_evasion_for_a_while(Evading& evading, Vec2 wanted, Taken& found) {
  const std::span<const Level> levels =
      flies(evading) ? std::span<const Level>(kCirclesForAWhile) : kForAWhile;
  return find_evasion_in_order(evading, levels, wanted, found);
}

// Returns whether the fallback after that step is clear of movers, for any other neighbors: the
// certificate has admitted the step.
bool is_far_from_movers(Evading& evading, Vec2 choice) {
  evading.workspace.around.walls.clear();
  look_around(evading, first_level(evading));
  return flies(evading) ? may_circle_after_choice(evading, choice)
                        : may_brake_after_choice(evading, choice);
}

// Returns whether all movers are seen exactly, and surely keep their acceleration.
bool are_exact(const Evading& evading) {
  return std::all_of(evading.sight.neighbors.begin(), evading.sight.neighbors.end(),
                     [&](const Neighbor& n) {
                       return n.max_deviation == 0.0 && n.likely_deviation == 0.0 &&
                              error_against(n, evading.law.step) == SensingError{};
                     });
}

bool needs_none(const Sight& sight) {
  return std::all_of(sight.neighbors.begin(), sight.neighbors.end(), decides);
}

// What the robot does until the next decision, see Taken::choice.
Vec2 choice_of(const Evading& evading, const Plan& plan) {
  if (flies(evading)) return plan.acceleration;
  return evading.robot.velocity + evading.law.step.braking_time * plan.acceleration;
}

// Replaces the choice of a plan.
void take(const Evading& evading, Vec2 choice, Plan& plan) {
  const Robot& robot = evading.robot;
  if (flies(evading)) {
    plan.new_velocity = robot.velocity + evading.law.step.control_time * choice;
    plan.acceleration = choice;
  } else {
    const Plan evasive =
        plan_under(evading.law, robot, choice, PlanStatus::refused, plan.violation);
    plan.new_velocity = evasive.new_velocity, plan.acceleration = evasive.acceleration;
  }
  if (plan.status != PlanStatus::overlapping) plan.status = PlanStatus::refused;
  plan.evading = true;
}

}  // namespace

void keep_evasion(const CertificateLaw& law, const Robot& robot, const Sight& sight,
                  bool may_swerve, EvasionWorkspace& workspace, Plan& plan) {
  if (needs_none(sight)) return;
  std::optional<Evading> begun = begin_evading(law, robot, sight, workspace);
  if (!begun) return;
  Evading& evading = *begun;
  const Vec2 wanted = choice_of(evading, plan);
  if (is_far_from_movers(evading, wanted)) return;
  keep_walls(evading);
  Taken found;
  EvasionFound outcome = are_some_likely_to_deviate(evading)
                             ? find_evasion_if_likely(evading, wanted, found)
                             : find_evasion_by_levels(evading, kLevels, wanted, found);
  if (outcome == EvasionFound::none && may_swerve && are_exact(evading))
    outcome = find_evasion_in_order(evading, kLastLevels, wanted, found);
  if (outcome == EvasionFound::none) outcome = find_evasion_for_a_while(evading, wanted, found);
  if (outcome != EvasionFound::another) return;
  take(evading, found.choice, plan);
  workspace.chosen = found.evasion, workspace.put_aside = wanted;
}

bool has_evasive_maneuver(const CertificateLaw& law, const Robot& robot, const Sight& sight,
                          EvasionWorkspace& workspace) {
  std::optional<Evading> evading = begin_evading(law, robot, sight, workspace);
  if (!evading) return false;
  keep_walls(*evading);
  // a robot that flies need not stop, so that a level has an evasive maneuver wherever a stronger
  // one has one
  const std::span<const Level> levels =
      flies(*evading) ? std::span(kLevels).last(1) : std::span(kLevels);
  return std::any_of(levels.begin(), levels.end(), [&](const Level& level) {
    look_around(*evading, level);
    return flies(*evading) ? has_clear_flight(*evading) : has_clear_evasion(*evading);
  });
}

bool may_go_on(const CertificateLaw& law, const Robot& robot, const Sight& sight,
               EvasionWorkspace& workspace) {
  return needs_none(sight) || has_evasive_maneuver(law, robot, sight, workspace);
}

int find_evaded(const CertificateLaw& law, const Robot& robot, std::span<const Neighbor> neighbors,
                Vec2 put_aside, EvasionWorkspace& workspace) {
  int evaded = -1;
  double nearest = 0.0;  // m²
  for (std::size_t k = 0; k < neighbors.size(); ++k) {
    const double squared = norm_squared(neighbors[k].position - robot.position);
    if (decides(neighbors[k]) || (evaded >= 0 && !(squared < nearest))) continue;
    std::optional<Evading> alone =
        begin_evading(law, robot, {neighbors.subspan(k, 1), {}}, workspace);
    if (!alone || is_far_from_movers(*alone, put_aside)) continue;
    evaded = static_cast<int>(k), nearest = squared;
  }
  return evaded;
}

}  // namespace avo::inline planner

namespace avo {

bool Planner::has_evasive_maneuver(const Robot& robot, std::span<const Neighbor> neighbors,
                                   PlanWorkspace& workspace, std::span<const Wall> walls) const {
  return can_decide(robot, neighbors, walls, options_) &&
         avo::has_evasive_maneuver(certificate_law(*this), robot,
                                   {neighbors, walls, options_.wall_range},
                                   PlanWorkspace::Scratch::of(workspace).evasion);
}

}  // namespace avo
