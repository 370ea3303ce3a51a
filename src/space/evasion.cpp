// SPDX-License-Identifier: Apache-2.0
#include "space/evasion.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "space/evading.h"
#include "space/mover_constraints.h"
#include "space/own_space.h"

namespace avo::space {
namespace {

constexpr std::size_t kDirections = 26;

// The velocities that evasive maneuvers approach, of v_max, in the robot's own space. They are
// fixed in the world, so that after a step the rest of an evasive maneuver is an evasive maneuver
// as well.
constexpr std::array<Vec3, 2 * kDirections> kVelocities = [] {
  constexpr std::array<double, 4> kPerLength{0.0, 1.0, 0.70710678118654752, 0.57735026918962576};
  std::array<Vec3, 2 * kDirections> result{};
  std::size_t count = 0;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        const auto squared = static_cast<std::size_t>(x * x + y * y + z * z);
        if (squared == 0) continue;
        const Vec3 direction{static_cast<double>(x), static_cast<double>(y),
                             static_cast<double>(z)};
        result[count] = kPerLength[squared] * direction;
        result[kDirections + count] = 0.5 * result[count];
        ++count;
      }
    }
  }
  return result;
}();

// The velocity that an evasive maneuver approaches: within climb and sink.
Vec3 velocity_of(const Robot& robot, std::size_t k) {
  Vec3 w = from_own(robot.max_speed * kVelocities[k], robot.vertical);
  w.z = std::clamp(w.z, -robot.sink, robot.climb);
  return w;
}

enum class Then : unsigned char { brakes, holds, approaches };

// A first step, and the motion after it.
struct FirstStep {
  Vec3 next_velocity;
  Then then = Then::brakes;
  Vec3 w = {};          // m/s, the approached velocity
  double detour = 0.0;  // m²/s², squared distance from the wanted velocity
  std::size_t number = 0;
};
// The replacement of a choice, and the evasive maneuver that begins with it.
struct Taken {
  Vec3 next_velocity;  // m/s
  Evasion evasion;
};
using FirstSteps = std::array<FirstStep, kVelocities.size() + 2>;

bool is_clear(Evading& evading, const FirstStep& step) {
  if (!take_first_step(evading.search, step.next_velocity)) return false;
  if (step.then == Then::brakes) return may_brake(evading.search);
  return may_approach(evading.search,
                      step.then == Then::holds ? evading.search.after.velocity : step.w);
}

bool is_within_limits(const Evading& evading, Vec3 next) {
  const Robot& robot = evading.robot;
  constexpr double kSpeedRounding = 1.0 + 1e-12;
  if (next == backup_velocity(robot, evading.law)) return true;
  const double change = own_length(next - robot.velocity, robot.vertical);
  return own_length(next, robot.vertical) <= kSpeedRounding * robot.max_speed &&
         change <= robot.max_acceleration * evading.law.braking_time &&
         next.z <= std::max(robot.climb, robot.velocity.z) &&
         -next.z <= std::max(robot.sink, -robot.velocity.z);
}

// Returns whether (C2), which covers the moving obstacles, holds, and other robots and boxes admit
// it.
bool is_allowed(Evading& evading, Vec3 next) {
  return stops_in_time(evading.search, next) &&
         admits(evading.robot, next, evading.law, Asked::until_refused,
                evading.workspace.constraints);
}

// Returns the steps, nearest to the wanted velocity first.
FirstSteps first_steps(const Evading& evading, Vec3 wanted) {
  const EvasionState now{{}, evading.robot.velocity, 0.0};
  FirstSteps steps;
  for (std::size_t k = 0; k < kVelocities.size(); ++k) {
    const Vec3 w = velocity_of(evading.robot, k);
    steps[k] = {next_towards(evading.search, now, w), Then::approaches, w};
  }
  steps[kVelocities.size()] = {now.velocity, Then::holds, {}};
  steps[kVelocities.size() + 1] = {backup_velocity(evading.robot, evading.law), Then::brakes, {}};
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
std::optional<Evasion> find_evasion_after(Evading& evading, Vec3 next_velocity) {
  EvasionSearch& search = evading.search;
  if (!take_first_step(search, next_velocity)) return std::nullopt;
  const Vec3 after = search.after.velocity;
  if (may_brake(search) || may_approach(search, after)) return Evasion{-1, after, search.brakes_at};
  for (std::size_t k = 0; k < kVelocities.size(); ++k) {
    const Vec3 w = velocity_of(evading.robot, k);
    if (may_approach(search, w)) return Evasion{-1, w, search.brakes_at};
  }
  return std::nullopt;
}

// The replacement by the first step that was last found clear.
Taken taken(const Evading& evading, const FirstStep& step) {
  if (step.then == Then::brakes) return {step.next_velocity, {}};
  const EvasionSearch& search = evading.search;
  const Vec3 w = step.then == Then::holds ? search.after.velocity : step.w;
  return {step.next_velocity, {-1, w, search.brakes_at}};
}

bool may_take(Evading& evading, const FirstStep& step) {
  return is_within_limits(evading, step.next_velocity) && is_clear(evading, step) &&
         is_allowed(evading, step.next_velocity);
}

// The replacement nearest to the wanted velocity that bisection finds.
Taken nearer(Evading& evading, const FirstStep& step, Vec3 wanted) {
  double refused = 0.0, kept = 1.0;
  Taken best = taken(evading, step);
  for (int k = 0; k < kNearer; ++k) {
    const double part = 0.5 * (refused + kept);
    const FirstStep candidate{wanted + part * (step.next_velocity - wanted), step.then, step.w};
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
    if (!is_within_limits(evading, step.next_velocity) || !is_clear(evading, step)) continue;
    const Vec3 v =
        choose(evading.robot, step.next_velocity, evading.law, evading.workspace).next_velocity;
    const auto evasion = is_allowed(evading, v) ? find_evasion_after(evading, v) : std::nullopt;
    if (!evasion) continue;
    found = {v, *evasion};
    return true;
  }
  return false;
}

EvasionFound find_evasion(Evading& evading, const Level& level, Vec3 wanted, Taken& found) {
  look_around(evading, level);
  if (find_evasion_after(evading, wanted)) return EvasionFound::as_wanted;
  const FirstSteps steps = first_steps(evading, wanted);
  for (const FirstStep& step : steps) {
    if (!may_take(evading, step)) continue;
    found = nearer(evading, step, wanted);
    return EvasionFound::another;
  }
  return find_beside(evading, steps, found) ? EvasionFound::another : EvasionFound::none;
}

EvasionFound find_evasion_in_order(Evading& evading, std::span<const Level> levels, Vec3 wanted,
                                   Taken& found) {
  for (const Level& level : levels) {
    const EvasionFound outcome = find_evasion(evading, level, wanted, found);
    if (outcome != EvasionFound::none) return outcome;
  }
  return EvasionFound::none;
}

// Nearly always the first level has one; where the weakest has none, hardly any other has one.
EvasionFound find_evasion_by_levels(Evading& evading, Vec3 wanted, Taken& found) {
  const std::span<const Level> levels = kLevels;
  const EvasionFound outcome = find_evasion(evading, levels.front(), wanted, found);
  if (outcome != EvasionFound::none ||
      find_evasion(evading, levels.back(), wanted, found) == EvasionFound::none)
    return outcome;
  return find_evasion_in_order(evading, levels.subspan(1), wanted, found);
}

// Returns whether braking after that step is clear of moving obstacles.
bool is_far_from_movers(Evading& evading, Vec3 next_velocity) {
  look_around(evading, kLevels[0]);
  return take_first_step(evading.search, next_velocity) && may_brake(evading.search);
}

// Returns whether all moving obstacles are seen exactly, and surely keep their acceleration.
bool are_exact(const Evading& evading) {
  return std::all_of(
      evading.sight.movers.begin(), evading.sight.movers.end(), [&](const Mover& mover) {
        return mover.max_deviation == 0.0 && error_against(mover, evading.law) == SensingError{};
      });
}

}  // namespace

bool keep_evasion(const PlannerOptions& options, const StepLaw& law, const Robot& robot,
                  const Sight& sight, EvasionSearch& search, ChoiceWorkspace& workspace,
                  Vec3& next_velocity) {
  if (sight.movers.empty()) return false;
  std::optional<Evading> begun = begin_evading(options, law, robot, sight, search, workspace);
  if (!begun) return false;
  Evading& evading = *begun;
  const Vec3 wanted = next_velocity;
  if (is_far_from_movers(evading, wanted)) return false;
  // (C2) stands for the demands of the moving obstacles
  MoverConstraints& of_movers = workspace.constraints.movers;
  of_movers.counts = false;
  Taken found;
  EvasionFound outcome = find_evasion_by_levels(evading, wanted, found);
  if (outcome == EvasionFound::none && sight.may_swerve && are_exact(evading))
    outcome = find_evasion_in_order(evading, kLastLevels, wanted, found);
  if (outcome == EvasionFound::none)
    outcome = find_evasion_in_order(evading, kForAWhile, wanted, found);
  of_movers.counts = true;
  if (outcome != EvasionFound::another) return false;
  next_velocity = found.next_velocity;
  search.chosen = found.evasion, search.put_aside = wanted;
  return true;
}

int find_evaded(const PlannerOptions& options, const StepLaw& law, const Robot& robot,
                std::span<const Mover> movers, Vec3 put_aside, EvasionSearch& search,
                ChoiceWorkspace& workspace) {
  int evaded = -1;
  double nearest = 0.0;  // m²
  for (std::size_t k = 0; k < movers.size(); ++k) {
    const double squared = norm_squared(movers[k].position - robot.position);
    if (evaded >= 0 && !(squared < nearest)) continue;
    const Sight alone{movers.subspan(k, 1), {}};
    std::optional<Evading> begun = begin_evading(options, law, robot, alone, search, workspace);
    if (!begun || is_far_from_movers(*begun, put_aside)) continue;
    evaded = static_cast<int>(k), nearest = squared;
  }
  return evaded;
}

}  // namespace avo::space
