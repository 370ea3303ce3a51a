// SPDX-License-Identifier: Apache-2.0
#include "planner/evasion.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "core/plane.h"
#include "planner/arrival.h"
#include "planner/certify.h"
#include "robots/model.h"

namespace avo {
namespace {

constexpr double kLongestWay = 2.0;      // T, until a way brakes,
constexpr double kMostSteps = 400.0;     // and steps
constexpr double kMostBraking = 1024.0;  // steps of braking; who takes more has no ways
constexpr int kMostWork = 100000;        // movers and intervals that a decision looks at
constexpr int kNearer = 4;               // bisections

// What a way reckons with; each is tried where the one before has none.
struct Level {
  double part;        // of a_max that the way uses
  double margin;      // of contact
  double reaction;    // T
  bool stops = true;  // (C2)
};
// Early, gently and far off at first. Each keeps less than the one before by more than rounding
// may cost.
constexpr std::array<Level, 6> kLevels{{{0.6, 0.05, 0.5},
                                        {0.6, 0.035, 0.5},
                                        {1.0, 0.025, 0.25},
                                        {1.0, 0.015, 0.125},
                                        {1.0, 0.005, 0.0},
                                        {1.0, 0.0, 0.0}}};
// Where braking is too late, the way itself is proof that A is not touched.
constexpr std::array<Level, 2> kLastLevels{{{1.0, 0.025, 0.0, false},  //
                                            {1.0, 0.0025, 0.0, false}}};

// What ways approach, of v_max. They are fixed in the world, so that after a step the rest of a way
// is a way as well.
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

// One decision.
struct Evading {
  const CertificateLaw& law;
  const Robot& robot;
  std::span<const Neighbor> neighbors;
  std::span<const Wall> walls;
  EvasionWorkspace& workspace;
  WayOptions options;
  double braking = 0.0;          // s, that it takes at most
  bool has_constraints = false;  // in the workspace
  double brakes_at = 0.0;        // s, of the way that is taken

  WayState now() const { return {{}, robot.velocity, 0.0, robot.heading}; }
};

bool decides(const Neighbor& neighbor) {
  return !is_predicted(neighbor);
}

// m/s: from the end of a trajectory that goes round on, it is not known where the mover is.
double fastest_until(const Neighbor& neighbor, double time) {
  const Trajectory& trajectory = *neighbor.trajectory;
  const double end = trajectory.places().back().time;
  return trajectory.repeats_from() && neighbor.trajectory_time + time >= end
             ? kInfinity
             : trajectory.max_speed(neighbor.trajectory_time);
}

Predicted predicted(const Evading& evading, const Neighbor& neighbor, const Level& level,
                    TrajectorySteps* trajectory) {
  const StepLaw& law = evading.law.step;
  const Robot& robot = evading.robot;
  const SensingError error = error_against(neighbor, law);
  Predicted other;
  other.position = neighbor.position - robot.position;
  other.velocity = neighbor.velocity;
  const double contact = robot.radius + neighbor.radius, speed = norm(neighbor.velocity);
  const bool is_followed = neighbor.trajectory != nullptr;
  const Vec2 acceleration = shares(neighbor) || is_followed ? Vec2{} : neighbor.acceleration;
  const double kept = contact + error.position +
                      (is_followed ? neighbor.trajectory->error() : parabola_error(acceleration, law));
  const double braking = evading.braking;
  const double time = evading.options.longest + law.time_step + braking;
  const double reaction = level.reaction * time_to_speed(robot);
  // what does not matter within that time is rounding
  const bool accelerates = norm(acceleration) * time * time > 0x1p-30 * contact;
  if (is_followed) other.trajectory = trajectory;
  if (accelerates) other.acceleration = acceleration;
  other.contact = kept + level.margin * contact;
  other.stop_contact = kept + 0.5 * level.margin * contact;
  other.drift = error.velocity;
  other.deviation = neighbor.max_deviation;
  other.reaction = reaction;
  other.asks_to_stop = level.stops;
  other.max_speed = neighbor.max_speed;
  other.fastest =
      (is_followed ? fastest_until(neighbor, time) : speed + time * norm(acceleration)) +
      error.velocity + neighbor.max_deviation * (reaction + braking);
  return other;
}

void look_around(Evading& evading, const Level& level) {
  Surroundings& around = evading.workspace.around;
  evading.options.increment =
      level.part * increment(evading.robot.max_acceleration, evading.law.step);
  around.others.clear();
  TrajectorySteps* trajectory = around.trajectories.data();
  for (const Neighbor& neighbor : evading.neighbors) {
    if (decides(neighbor)) continue;
    around.others.push_back(predicted(evading, neighbor, level, trajectory));
    if (neighbor.trajectory != nullptr) ++trajectory;
  }
  begin_ways(evading.options, around);
}

// The certificate without movers: those are left to (C2).
CertifiedWorkspace& without_movers(Evading& evading) {
  auto& [around, deciding, certified] = evading.workspace;
  if (evading.has_constraints) return certified;
  deciding.clear();
  std::copy_if(evading.neighbors.begin(), evading.neighbors.end(), std::back_inserter(deciding),
               decides);
  collect_constraints(evading.robot, deciding, evading.law, certified.constraints, evading.walls);
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

// A first step, and what comes behind it. What is left of a way after a step is a way of the same
// kind: w is fixed in the world, or what the step has led to.
struct FirstStep {
  Vec2 next_velocity;
  Then then = Then::brakes;
  Vec2 w = {};          // m/s, that is approached
  double detour = 0.0;  // m²/s², from what is wanted, squared
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

// Nearest to what is wanted first.
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

// Whether some way is clear after that step, (M).
bool has_way_out(Evading& evading, Vec2 next_velocity) {
  const WayOptions& options = evading.options;
  Surroundings& around = evading.workspace.around;
  if (!take_first_step(options, around, evading.now(), next_velocity)) return false;
  return may_brake(options, around) || may_approach(options, around, around.after.velocity) ||
         std::any_of(kVelocities.begin(), kVelocities.end(), [&](Vec2 part) {
           return may_approach(options, around, evading.robot.max_speed * part);
         });
}

Vec2 followed(const Evading& evading, Vec2 next_velocity) {
  if (evading.options.wheels == nullptr) return next_velocity;
  return within_own_limits(evading.robot, evading.law.step.braking_time, next_velocity);
}

// As near to what is wanted as bisection finds.
Vec2 nearer(Evading& evading, const FirstStep& step, Vec2 wanted) {
  double refused = 0.0, kept = 1.0;
  Vec2 best = step.next_velocity;
  for (int k = 0; k < kNearer; ++k) {
    const double part = 0.5 * (refused + kept);
    const Vec2 between = followed(evading, wanted + part * (step.next_velocity - wanted));
    if (is_clear(evading, {between, step.then, step.w}) && is_allowed(evading, between)) {
      kept = part, best = between;
      evading.brakes_at = evading.workspace.around.brakes_at;
    } else {
      refused = part;
    }
  }
  return best;
}

enum class Way : unsigned char { none, as_wanted, another };

// Where others refuse the first steps of ways, what is nearest to one of them and leaves a way.
bool find_beside(Evading& evading, const FirstSteps& steps, Vec2& next_velocity) {
  for (const FirstStep& step : steps) {
    if (!is_clear(evading, step)) continue;
    const Vec2 v = choose_certified(evading.robot, step.next_velocity, evading.law,
                                    without_movers(evading))
                       .next_velocity;
    if (!is_allowed(evading, v) || !has_way_out(evading, v)) continue;
    next_velocity = v;
    return true;
  }
  return false;
}

Way find_way(Evading& evading, const Level& level, Vec2 wanted, Vec2& next_velocity) {
  look_around(evading, level);
  if (has_way_out(evading, wanted)) return Way::as_wanted;
  const FirstSteps steps = first_steps(evading, wanted);
  for (const FirstStep& step : steps) {
    if (!is_clear(evading, step) || !is_allowed(evading, step.next_velocity)) continue;
    evading.brakes_at = evading.workspace.around.brakes_at;
    next_velocity = nearer(evading, step, wanted);
    const Vec2 w = step.then == Then::holds ? next_velocity : step.w;
    evading.workspace.chosen = {-1, w, step.then == Then::brakes ? 0.0 : evading.brakes_at};
    return Way::another;
  }
  return find_beside(evading, steps, next_velocity) ? Way::another : Way::none;
}

// Whether braking after that step is clear of movers, whoever else is there: it is admitted.
bool is_far_from_movers(Evading& evading, Vec2 next_velocity) {
  Surroundings& around = evading.workspace.around;
  around.walls.clear();
  look_around(evading, kLevels[0]);
  return take_first_step(evading.options, around, evading.now(), next_velocity) &&
         may_brake(evading.options, around);
}

// Whether all are seen exactly, and keep their acceleration.
bool are_exact(const Evading& evading) {
  return std::all_of(evading.neighbors.begin(), evading.neighbors.end(), [&](const Neighbor& n) {
    return n.max_deviation == 0.0 && error_against(n, evading.law.step) == SensingError{};
  });
}

// Of those that are known, in the order of the neighbors.
void follow_trajectories(Evading& evading) {
  const auto is_followed = [](const Neighbor& n) { return !decides(n) && n.trajectory != nullptr; };
  std::vector<TrajectorySteps>& trajectories = evading.workspace.around.trajectories;
  const auto count = static_cast<std::size_t>(
      std::count_if(evading.neighbors.begin(), evading.neighbors.end(), is_followed));
  if (trajectories.size() < count) trajectories.resize(count);
  const double h = evading.law.step.time_step;
  const double most = (evading.options.longest + evading.braking) / h + 3.0;
  std::size_t k = 0;
  for (const Neighbor& neighbor : evading.neighbors) {
    if (!is_followed(neighbor)) continue;
    trajectories[k].reserve(static_cast<std::size_t>(most));
    trajectories[k++].begin(*neighbor.trajectory, neighbor.trajectory_time, evading.robot.position,
                            h);
  }
}

// Those within reach: which others there are is not known for sure. Where there is one, ways stay
// within that reach.
void keep_walls(double wall_range, Evading& evading) {
  const Robot& robot = evading.robot;
  std::vector<KeptWall>& kept = evading.workspace.around.walls;
  kept.clear();
  if (evading.walls.empty()) return;
  const StepLaw& law = evading.law.step;
  const WallRounding rounding =
      wall_rounding(robot.radius, robot.max_speed, ability_of(robot), law);
  const double reach =
      std::max(wall_reach(robot.max_speed, robot.max_speed, ability_of(robot), law), wall_range);
  for (const Wall& wall : evading.walls) {
    const Segment segment{wall.a - robot.position, wall.b - robot.position};
    const double held = robot.radius + wall.radius + law.localization_error;
    if (distance(Vec2{}, segment) > held + reach) continue;
    kept.push_back({segment, held + wall_margin(wall, rounding)});
  }
  if (!kept.empty()) evading.options.known = reach;
}

// s: what a robot as fast as that takes to brake, and a step and rounding more.
double braking_time_of(const Robot& robot, double speed, const StepLaw& law) {
  return law.time_step * (2.0 + speed / decrement_of(robot, law));
}

// Nothing of robots that have no ways.
std::optional<Evading> begin(const CertificateLaw& law, const Robot& robot,
                             std::span<const Neighbor> neighbors, std::span<const Wall> walls,
                             EvasionWorkspace& workspace) {
  if (law.kind == Certificate::none || is_airplane(robot.model)) return std::nullopt;
  Evading evading{law, robot, neighbors, walls, workspace, {}};
  evading.options = {
      .law = law.step,
      .decrement = decrement_of(robot, law.step),
      .max_speed = fastest_of(robot.model, std::max(robot.max_speed, norm(robot.velocity))),
      .longest = std::min(kLongestWay * time_to_speed(robot), kMostSteps * law.step.time_step),
      .wheels = is_holonomic(robot.model) ? nullptr : &robot};
  if (!(evading.options.max_speed <= kMostBraking * evading.options.decrement)) return std::nullopt;
  evading.braking = braking_time_of(robot, evading.options.max_speed, law.step);
  workspace.around.work = kMostWork;
  follow_trajectories(evading);
  return evading;
}

}  // namespace

double way_range(double radius, double max_speed, double max_acceleration) {
  Robot robot{.radius = radius, .max_acceleration = max_acceleration, .max_speed = max_speed};
  const double time = time_to_speed(robot);
  return (kLongestWay + 0.5) * time * max_speed;
}

double longest_way_out(const Robot& robot, const StepLaw& law) {
  const double longest = std::min(kLongestWay * time_to_speed(robot), kMostSteps * law.time_step);
  const double braking = braking_time_of(robot, fastest_of(robot.model, robot.max_speed), law);
  return longest + law.time_step + std::min(braking, kMostBraking * law.time_step);
}

void keep_a_way_out(const CertificateLaw& law, const Robot& robot,
                    std::span<const Neighbor> neighbors, std::span<const Wall> walls,
                    double wall_range, bool may_swerve, EvasionWorkspace& workspace, Plan& plan) {
  if (std::all_of(neighbors.begin(), neighbors.end(), decides)) return;
  std::optional<Evading> begun = begin(law, robot, neighbors, walls, workspace);
  if (!begun) return;
  Evading& evading = *begun;
  const Vec2 wanted = robot.velocity + law.step.braking_time * plan.acceleration;
  if (is_far_from_movers(evading, wanted)) return;
  keep_walls(wall_range, evading);
  Vec2 next_velocity;
  const auto try_all = [&](std::span<const Level> levels) {
    for (const Level& level : levels) {
      const Way way = find_way(evading, level, wanted, next_velocity);
      if (way != Way::none) return way;
    }
    return Way::none;
  };
  // nearly always the first; and where the weakest has none, hardly any other one has
  const std::span<const Level> levels = kLevels;
  Way way = try_all(levels.first(1));
  if (way == Way::none && try_all(levels.last(1)) != Way::none) way = try_all(levels.subspan(1));
  if (way == Way::none && may_swerve && are_exact(evading)) way = try_all(kLastLevels);
  if (way != Way::another) return;
  const Plan found = plan_under(law, robot, next_velocity, PlanStatus::candidate, plan.violation);
  plan.new_velocity = found.new_velocity, plan.acceleration = found.acceleration;
  if (plan.status != PlanStatus::overlapping) plan.status = found.status;
  plan.evading = true;
  workspace.put_aside = wanted;
}

bool has_way_out(const CertificateLaw& law, const Robot& robot, std::span<const Neighbor> neighbors,
                 std::span<const Wall> walls, EvasionWorkspace& workspace) {
  std::optional<Evading> evading = begin(law, robot, neighbors, walls, workspace);
  if (!evading) return false;
  keep_walls(0.0, *evading);
  return std::any_of(kLevels.begin(), kLevels.end(), [&](const Level& level) {
    look_around(*evading, level);
    const FirstSteps steps = first_steps(*evading, robot.velocity);
    return std::any_of(steps.begin(), steps.end(),
                       [&](const FirstStep& step) { return is_clear(*evading, step); });
  });
}

int find_evaded(const CertificateLaw& law, const Robot& robot, std::span<const Neighbor> neighbors,
                Vec2 put_aside, EvasionWorkspace& workspace) {
  int evaded = -1;
  double nearest = 0.0;  // m²
  for (std::size_t k = 0; k < neighbors.size(); ++k) {
    const double squared = norm_squared(neighbors[k].position - robot.position);
    if (decides(neighbors[k]) || (evaded >= 0 && !(squared < nearest))) continue;
    std::optional<Evading> alone = begin(law, robot, neighbors.subspan(k, 1), {}, workspace);
    if (!alone || is_far_from_movers(*alone, put_aside)) continue;
    evaded = static_cast<int>(k), nearest = squared;
  }
  return evaded;
}

}  // namespace avo
