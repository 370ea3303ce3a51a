// SPDX-License-Identifier: Apache-2.0
#include "planner/rules/evasion.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>

#include "core/plane.h"
#include "planner/certify.h"
#include "planner/rules/flight_evasion.h"
#include "robots/model.h"

namespace avo::inline planner {
namespace {

// The first levels are early, gentle and far off. Each level is tried where the one before has
// none, and keeps less than that by more than rounding may cost.
constexpr std::array<Level, 6> kLevels{{{0.6, 0.05, 0.5},
                                        {0.6, 0.035, 0.5},
                                        {1.0, 0.025, 0.25},
                                        {1.0, 0.015, 0.125},
                                        {1.0, 0.005, 0.0},
                                        {1.0, 0.0, 0.0}}};
// Where braking is too late, the way out itself is proof that A is not touched.
constexpr std::array<Level, 2> kLastLevels{{{1.0, 0.025, 0.0, false},  //
                                            {1.0, 0.0025, 0.0, false}}};

// Where some neighbors are likely to deviate: this part of their likely_deviation counts.
constexpr Level likely_level(double part) {
  return {.part = 1.0, .margin = 0.0, .reaction = 0.5 * part, .likely = part};
}
constexpr int kLargerParts = 4;  // bisections

// Where no place is clear for ever: rest must be clear for so long. An airplane does not rest, and
// finds another circle in less time.
constexpr std::array<Level, 3> kForAWhile{{{1.0, 0.0, 0.0, true, 2.0},  //
                                           {1.0, 0.0, 0.0, true, 1.0},
                                           {1.0, 0.0, 0.0, true, 0.5}}};

// The velocities that ways out approach, of v_max. They are fixed in the world, so that after a
// step the rest of a way out is a way out as well.
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
  const Surroundings& around = evading.workspace.around;
  if (!stops_in_time(evading.options, around, evading.now(), next_velocity)) return false;
  return admits(robot, next_velocity, evading.law, without_movers(evading).constraints);
}

enum class Then : unsigned char { brakes, holds, approaches };

// A first step, and the motion after it. The rest of a way out after a step is of the same kind: w
// is fixed in the world, or is the velocity after the step.
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

// Finds a way out that is clear after that step, (M).
std::optional<Evasion> find_way_after(Evading& evading, Vec2 next_velocity) {
  const WayOptions& options = evading.options;
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

// Where others refuse the first steps of ways out: finds the velocity nearest to one of them that
// leaves a way out.
bool find_beside(Evading& evading, const FirstSteps& steps, Taken& found) {
  for (const FirstStep& step : steps) {
    if (!is_clear(evading, step)) continue;
    const Vec2 v =
        choose_certified(evading.robot, step.next_velocity, evading.law, without_movers(evading))
            .next_velocity;
    const auto way = is_allowed(evading, v) ? find_way_after(evading, v) : std::nullopt;
    if (!way) continue;
    found = {v, *way};
    return true;
  }
  return false;
}

Way find_way(Evading& evading, const Level& level, Vec2 wanted, Taken& found) {
  look_around(evading, level);
  if (is_airplane(evading.robot.model)) return find_flight(evading, wanted, found);
  if (find_way_after(evading, wanted)) return Way::as_wanted;
  const FirstSteps steps = first_steps(evading, wanted);
  for (const FirstStep& step : steps) {
    if (!may_take(evading, step)) continue;
    found = nearer(evading, step, wanted);
    return Way::another;
  }
  return find_beside(evading, steps, found) ? Way::another : Way::none;
}

bool are_some_likely_to_deviate(const Evading& evading) {
  return std::any_of(evading.sight.neighbors.begin(), evading.sight.neighbors.end(),
                     [](const Neighbor& n) { return !decides(n) && n.likely_deviation > 0.0; });
}

Level first_level(const Evading& evading) {
  return are_some_likely_to_deviate(evading) ? likely_level(1.0) : kLevels[0];
}

// Counts as much of the likely deviation as leaves a way out, found by bisection.
Way find_way_if_likely(Evading& evading, Vec2 wanted, Taken& found) {
  Way way = find_way(evading, likely_level(1.0), wanted, found);
  if (way != Way::none) return way;
  way = find_way(evading, likely_level(0.0), wanted, found);
  if (way == Way::none) return way;
  double kept = 0.0, refused = 1.0;
  for (int k = 0; k < kLargerParts; ++k) {
    const double part = 0.5 * (kept + refused);
    const Way other = find_way(evading, likely_level(part), wanted, found);
    if (other == Way::none) {
      refused = part;
    } else {
      kept = part, way = other;
    }
  }
  return way;
}

Way find_way_in_order(Evading& evading, std::span<const Level> levels, Vec2 wanted, Taken& found) {
  for (const Level& level : levels) {
    const Way way = find_way(evading, level, wanted, found);
    if (way != Way::none) return way;
  }
  return Way::none;
}

// Nearly always the first level has one; where the weakest has none, hardly any other level has
// one.
Way find_way_by_levels(Evading& evading, std::span<const Level> levels, Vec2 wanted, Taken& found) {
  const Way way = find_way(evading, levels.front(), wanted, found);
  if (way != Way::none || find_way(evading, levels.back(), wanted, found) == Way::none) return way;
  return find_way_in_order(evading, levels.subspan(1), wanted, found);
}

Way find_way_for_a_while(Evading& evading, Vec2 wanted, Taken& found) {
  const std::size_t levels = is_airplane(evading.robot.model) ? kForAWhile.size() : 1;
  return find_way_in_order(evading, std::span(kForAWhile).first(levels), wanted, found);
}

// Returns whether the fallback after that step is clear of movers, for any other neighbors: the
// certificate has admitted the step.
bool is_far_from_movers(Evading& evading, Vec2 choice) {
  Surroundings& around = evading.workspace.around;
  around.walls.clear();
  look_around(evading, first_level(evading));
  if (is_airplane(evading.robot.model)) return may_circle_after_choice(evading, choice);
  return take_first_step(evading.options, around, evading.now(), choice) &&
         may_brake(evading.options, around);
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
  if (is_airplane(evading.robot.model)) return plan.acceleration;
  return evading.robot.velocity + evading.law.step.braking_time * plan.acceleration;
}

// Replaces the choice of a plan.
void take(const Evading& evading, Vec2 choice, Plan& plan) {
  const Robot& robot = evading.robot;
  if (is_airplane(robot.model)) {
    plan.new_velocity = robot.velocity + evading.law.step.control_time * choice;
    plan.acceleration = choice;
  } else {
    const Plan evasive =
        plan_under(evading.law, robot, choice, PlanStatus::candidate, plan.violation);
    plan.new_velocity = evasive.new_velocity, plan.acceleration = evasive.acceleration;
  }
  if (plan.status != PlanStatus::overlapping) plan.status = PlanStatus::candidate;
  plan.evading = true;
}

}  // namespace

void keep_a_way_out(const CertificateLaw& law, const Robot& robot, const Sight& sight,
                    bool may_swerve, EvasionWorkspace& workspace, Plan& plan) {
  if (needs_none(sight)) return;
  std::optional<Evading> begun = begin_evading(law, robot, sight, workspace);
  if (!begun) return;
  Evading& evading = *begun;
  const Vec2 wanted = choice_of(evading, plan);
  if (is_far_from_movers(evading, wanted)) return;
  keep_walls(evading);
  Taken found;
  Way way = are_some_likely_to_deviate(evading)
                ? find_way_if_likely(evading, wanted, found)
                : find_way_by_levels(evading, kLevels, wanted, found);
  if (way == Way::none && may_swerve && are_exact(evading))
    way = find_way_in_order(evading, kLastLevels, wanted, found);
  if (way == Way::none) way = find_way_for_a_while(evading, wanted, found);
  if (way != Way::another) return;
  take(evading, found.choice, plan);
  workspace.chosen = found.way, workspace.put_aside = wanted;
}

bool has_way_out(const CertificateLaw& law, const Robot& robot, const Sight& sight,
                 EvasionWorkspace& workspace) {
  std::optional<Evading> evading = begin_evading(law, robot, sight, workspace);
  if (!evading) return false;
  keep_walls(*evading);
  if (is_airplane(robot.model)) {
    look_around(*evading, kLevels.back());
    return has_clear_flight(*evading);
  }
  return std::any_of(kLevels.begin(), kLevels.end(), [&](const Level& level) {
    look_around(*evading, level);
    const FirstSteps steps = first_steps(*evading, robot.velocity);
    return std::any_of(steps.begin(), steps.end(),
                       [&](const FirstStep& step) { return is_clear(*evading, step); });
  });
}

bool may_go_on(const CertificateLaw& law, const Robot& robot, const Sight& sight,
               EvasionWorkspace& workspace) {
  return needs_none(sight) || has_way_out(law, robot, sight, workspace);
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
