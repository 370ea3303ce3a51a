// SPDX-License-Identifier: Apache-2.0
#include "planner/rules/braking_evasion.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>

#include "core/plane.h"
#include "robots/model.h"

namespace avo::inline planner {
namespace {

// The velocities that evasive maneuvers approach, of v_max. They are fixed in the world, so that
// after a step the rest of an evasive maneuver is an evasive maneuver as well.
constexpr double kDiagonal = 0.70710678118654752;
constexpr std::array<Vec2, 8> kCompass{{{1, 0},
                                        {kDiagonal, kDiagonal},
                                        {0, 1},
                                        {-kDiagonal, kDiagonal},
                                        {-1, 0},
                                        {-kDiagonal, -kDiagonal},
                                        {0, -1},
                                        {kDiagonal, -kDiagonal}}};
constexpr std::array<Vec2, 16> kVelocities = [] {
  std::array<Vec2, 16> result;
  for (std::size_t k = 0; k < 8; ++k) result[k] = kCompass[k], result[8 + k] = 0.5 * kCompass[k];
  return result;
}();

// The certificate without movers: (C2) covers the movers.
CertifiedWorkspace& without_movers(Evading& evading) {
  std::vector<Neighbor>& deciding = evading.workspace.deciding;
  CertifiedWorkspace& certified = evading.workspace.certified;
  if (evading.has_constraints) return certified;
  deciding.clear();
  std::copy_if(evading.sight.neighbors.begin(), evading.sight.neighbors.end(),
               std::back_inserter(deciding), decides);
  collect_constraints(evading.robot, deciding, evading.law, certified.constraints,
                      evading.sight.walls);
  evading.has_constraints = true;
  return certified;
}

bool is_allowed(Evading& evading, Vec2 next_velocity) {
  const Robot& robot = evading.robot;
  if (norm(next_velocity) > robot.max_speed * (1.0 + 1e-12)) return false;
  if (!stops_in_time(evading.options, evading.workspace.around, evading.now(), next_velocity))
    return false;
  return admits(robot, next_velocity, evading.law, without_movers(evading).constraints);
}

enum class Then : unsigned char { brakes, holds, approaches };

// A first step, and the motion after it. The rest of an evasive maneuver after a step is of the
// same kind. w is fixed in the world, or is the velocity after the step.
struct FirstStep {
  Vec2 next_velocity;
  Then then = Then::brakes;
  Vec2 w = {};          // m/s, the approached velocity
  double detour = 0.0;  // m²/s², squared distance from the wanted velocity
  std::size_t number = 0;
};

bool is_clear(Evading& evading, const FirstStep& step) {
  Surroundings& around = evading.workspace.around;
  if (!take_first_step(evading.options, around, evading.now(), step.next_velocity)) return false;
  if (step.then == Then::brakes) return may_brake(evading.options, around);
  const Vec2 w = step.then == Then::holds ? around.after.velocity : step.w;
  return may_approach(evading.options, around, w);
}

using FirstSteps = std::array<FirstStep, kVelocities.size() + 2>;

// Returns the steps, nearest to the wanted velocity first.
FirstSteps first_steps(const Evading& evading, Vec2 wanted) {
  const Vec2 v = evading.robot.velocity;
  FirstSteps steps;
  for (std::size_t k = 0; k < kVelocities.size(); ++k) {
    const Vec2 w = evading.robot.max_speed * kVelocities[k];
    steps[k] = {next_towards(evading.options, evading.now(), w), Then::approaches, w};
  }
  steps[kVelocities.size()] = {v, Then::holds, {}};
  steps[kVelocities.size() + 1] = {braked(v, evading.options.decrement), Then::brakes, {}};
  for (std::size_t k = 0; k < steps.size(); ++k) {
    steps[k].detour = norm_squared(steps[k].next_velocity - wanted);
    steps[k].number = k;
  }
  std::sort(steps.begin(), steps.end(), [](const FirstStep& a, const FirstStep& b) {
    return a.detour < b.detour || (a.detour == b.detour && a.number < b.number);
  });
  return steps;
}

// Finds an evasive maneuver that is clear after that step, (M).
std::optional<Evasion> find_evasion_after(Evading& evading, Vec2 next_velocity) {
  const EvasionOptions& options = evading.options;
  Surroundings& around = evading.workspace.around;
  if (!take_first_step(options, around, evading.now(), next_velocity)) return std::nullopt;
  const Vec2 after = around.after.velocity;
  if (may_brake(options, around) || may_approach(options, around, after))
    return Evasion{-1, after, around.brakes_at};
  for (const Vec2 part : kVelocities) {
    const Vec2 w = evading.robot.max_speed * part;
    if (may_approach(options, around, w)) return Evasion{-1, w, around.brakes_at};
  }
  return std::nullopt;
}

Vec2 followed(const Evading& evading, Vec2 next_velocity) {
  if (evading.options.wheels == nullptr) return next_velocity;
  return within_own_limits(evading.robot, evading.law.step.braking_time, next_velocity);
}

// The replacement by the first step that was last found clear.
Taken taken(const Evading& evading, const FirstStep& step) {
  const Surroundings& around = evading.workspace.around;
  if (step.then == Then::brakes) return {step.next_velocity, {}};
  const Vec2 w = step.then == Then::holds ? around.after.velocity : step.w;
  return {step.next_velocity, {-1, w, around.brakes_at}};
}

bool may_take(Evading& evading, const FirstStep& step) {
  return is_clear(evading, step) && is_allowed(evading, step.next_velocity);
}

// The replacement nearest to the wanted velocity that bisection finds.
Taken nearer(Evading& evading, const FirstStep& step, Vec2 wanted) {
  double refused = 0.0, kept = 1.0;
  Taken best = taken(evading, step);
  for (int k = 0; k < kNearer; ++k) {
    const double part = 0.5 * (refused + kept);
    const Vec2 between = followed(evading, wanted + part * (step.next_velocity - wanted));
    const FirstStep candidate{between, step.then, step.w};
    if (may_take(evading, candidate)) {
      kept = part, best = taken(evading, candidate);
    } else {
      refused = part;
    }
  }
  return best;
}

// Where others refuse the first steps of evasive maneuvers: finds the velocity nearest to one of
// them that leaves an evasive maneuver.
bool find_beside(Evading& evading, const FirstSteps& steps, Taken& found) {
  for (const FirstStep& step : steps) {
    if (!is_clear(evading, step)) continue;
    const Vec2 v =
        choose_certified(evading.robot, step.next_velocity, evading.law, without_movers(evading))
            .next_velocity;
    const auto evasion = is_allowed(evading, v) ? find_evasion_after(evading, v) : std::nullopt;
    if (!evasion) continue;
    found = {v, *evasion};
    return true;
  }
  return false;
}

}  // namespace

bool may_brake_after_choice(Evading& evading, Vec2 next_velocity) {
  Surroundings& around = evading.workspace.around;
  return take_first_step(evading.options, around, evading.now(), next_velocity) &&
         may_brake(evading.options, around);
}

bool has_clear_evasion(Evading& evading) {
  const FirstSteps steps = first_steps(evading, evading.robot.velocity);
  return std::any_of(steps.begin(), steps.end(),
                     [&](const FirstStep& step) { return is_clear(evading, step); });
}

EvasionFound find_braking_evasion(Evading& evading, Vec2 wanted, Taken& found) {
  if (find_evasion_after(evading, wanted)) return EvasionFound::as_wanted;
  const FirstSteps steps = first_steps(evading, wanted);
  for (const FirstStep& step : steps) {
    if (!may_take(evading, step)) continue;
    found = nearer(evading, step, wanted);
    return EvasionFound::another;
  }
  return find_beside(evading, steps, found) ? EvasionFound::another : EvasionFound::none;
}

}  // namespace avo::inline planner
