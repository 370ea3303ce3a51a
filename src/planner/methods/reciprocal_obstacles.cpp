// SPDX-License-Identifier: Apache-2.0
#include "planner/methods/reciprocal_obstacles.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "avo/half_plane.h"
#include "planner/methods/passive_candidates.h"
#include "planner/stages/pairs.h"

namespace avo::inline planner {
namespace {

constexpr double kLineTolerance = 1e-9;  // m/s, rounding of a velocity on a line

struct Penalty {
  double line = std::numeric_limits<double>::infinity();   // m/s, the largest violation of any line
  double value = std::numeric_limits<double>::infinity();  // m/s

  bool operator<(const Penalty& other) const {
    return line != other.line ? line < other.line : value < other.value;
  }
};

double worst_line(std::span<const Limit> limits, Vec2 v_new) {
  double worst = 0.0;
  for (const Limit& limit : limits) {
    if (limit.kind == Limit::Kind::line) worst = std::max(worst, violation(limit, v_new));
  }
  return worst > kLineTolerance ? worst : 0.0;
}

}  // namespace

PassiveObstacle reciprocal_obstacle(const PlannerOptions& options, const Robot& robot,
                                    const Neighbor& neighbor) {
  const double alpha = shares(neighbor)
                           ? reciprocal_share(robot.max_acceleration, neighbor.max_acceleration,
                                              robot.priority, neighbor.priority)
                           : 1.0;
  Pair pair = relative(robot, neighbor);
  pair.velocity = alpha * pair.velocity;
  // α VO: the disc of the time t is (-p/t, r/t), so times are longer by 1/α
  return {{pair, Response::velocity(), options.time_horizon / alpha},
          robot.velocity - pair.velocity,
          options.time_step / alpha};
}

double time_to_collision(const PassiveObstacle& obstacle, double time_horizon, Vec2 v_new) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const auto& [p, v, r] = obstacle.obstacle.pair;
  const Vec2 u = v_new - obstacle.v_new_B;
  const double gap = norm(p) - r, towards = -dot(p, u), squared = norm_squared(u);
  if (!(gap >= 0.0) || !(towards > 0.0)) return kNever;
  // |p + t u| = r, the earlier root; c = |p|² - r²
  const double c = gap * (norm(p) + r), discriminant = towards * towards - squared * c;
  if (!(discriminant > 0.0)) return kNever;
  const double time = c / (towards + std::sqrt(discriminant));
  if (!(time < obstacle.obstacle.time_horizon)) return kNever;
  return time * (time_horizon / obstacle.obstacle.time_horizon);
}

PassiveChoice least_penalty(std::span<const PassiveObstacle> obstacles, const Disc& speed,
                            double time_horizon, Vec2 preferred,
                            const PassiveWorkspace& workspace) {
  const Lens lens = make_lens({{}, std::numeric_limits<double>::infinity()}, speed.radius);
  const std::span<const Limit> limits = workspace.limits;
  PassiveChoice choice{{}, 0.0, PassiveState::least_unsafe};
  Penalty least;
  const auto offer = [&](Vec2 u) {
    const Vec2 allowed = nearest(lens, u);
    Penalty penalty{worst_line(limits, allowed), norm(preferred - allowed)};
    if (!(penalty < least)) return false;
    double first = std::numeric_limits<double>::infinity();
    for (const PassiveObstacle& obstacle : obstacles)
      first = std::min(first, time_to_collision(obstacle, time_horizon, allowed));
    penalty.value += first > 0.0 ? kSafetyFactor / first : std::numeric_limits<double>::infinity();
    if (!(penalty < least)) return false;
    least = penalty;
    choice.velocity = allowed;
    return true;
  };
  try_candidates({limits, workspace.points, lens, preferred}, choice.velocity, offer);
  for (const Limit& limit : limits) {
    if (limit.kind != Limit::Kind::disc)
      choice.violation = std::max(choice.violation, violation(limit, choice.velocity));
  }
  return choice;
}

}  // namespace avo::inline planner
