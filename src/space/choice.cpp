// SPDX-License-Identifier: Apache-2.0
#include "space/choice.h"

#include <algorithm>
#include <cmath>

#include "planner/stages/cuts.h"
#include "space/own_space.h"
#include "space/trace.h"

namespace avo::space {
namespace {

constexpr double kBelow = 1.0 - 0x1p-48;  // a bound is kept in spite of rounding
constexpr double kByRounding = 1e-6;      // m/s, more than rounding moves a velocity

// The limits of v_1 in the robot's own space, m/s.
struct Limits {
  Vec3 velocity;
  double change = 0.0, speed = 0.0;
};

Limits limits_of(const Robot& robot, const StepLaw& law) {
  return {to_own(robot.velocity, robot.vertical), robot.max_acceleration * law.braking_time,
          robot.max_speed};
}

// The nearest velocity of the ball of the change, where rounding has left it: the certificate
// counts on that ball.
Vec3 within(const Limits& limits, Vec3 own) {
  const double speed = norm(own);
  if (speed > limits.speed) own = (kBelow * limits.speed / speed) * own;
  const Vec3 change = own - limits.velocity;
  const double length = norm(change);
  return length > limits.change ? limits.velocity + (kBelow * limits.change / length) * change
                                : own;
}

bool is_within(const Limits& limits, const std::vector<HalfSpace>& own_planes, Vec3 own) {
  return norm(own - limits.velocity) <= limits.change && norm(own) <= limits.speed &&
         std::all_of(own_planes.begin(), own_planes.end(),
                     [&](const HalfSpace& plane) { return violation(plane, own) <= 0.0; });
}

// Whether a velocity keeps climb and sink. Where the present velocity breaks them, it may not break
// them by more.
bool keeps_climb(const Robot& robot, Vec3 next) {
  return next.z <= std::max(robot.climb, robot.velocity.z) &&
         -next.z <= std::max(robot.sink, -robot.velocity.z);
}

// The candidate with its height within climb and sink, which rounding may have left: slower, and
// nearer to the present velocity.
Vec3 within_climb(const Robot& robot, Vec3 next) {
  if (keeps_climb(robot, next)) return next;
  constexpr double kLeft = 1e-6;  // of the limit, at most
  const double most = next.z > 0.0 ? robot.climb : robot.sink;
  if (std::abs(next.z) <= (1.0 + kLeft) * most) next.z = next.z > 0.0 ? most : -most;
  return next;
}

}  // namespace

void append_climb(const Robot& robot, std::vector<HalfSpace>& half_spaces) {
  const double per = 1.0 / robot.vertical;
  if (std::isfinite(robot.climb)) half_spaces.push_back({{0.0, 0.0, -1.0}, -robot.climb * per});
  if (std::isfinite(robot.sink)) half_spaces.push_back({{0.0, 0.0, 1.0}, -robot.sink * per});
}

template <typename Trace>
Choice choose(const Robot& robot, Vec3 wanted, const StepLaw& law, ChoiceWorkspace& workspace,
              Trace trace) {
  Constraints& constraints = workspace.constraints;
  std::vector<HalfSpace>& cuts = workspace.cuts;
  const Limits limits = limits_of(robot, law);
  const std::array<Ball, 2> balls{Ball{limits.velocity, limits.change}, Ball{{}, limits.speed}};
  const Vec3 own_wanted = to_own(wanted, robot.vertical);
  cuts.clear();
  append_climb(robot, cuts);
  for (int round = 0; round < kRounds; ++round) {
    SpaceProgramResult result{.point = own_wanted};
    const bool is_wanted = round == 0 && is_within(limits, cuts, own_wanted);
    if (!is_wanted) result = nearest_point(cuts, balls, own_wanted, workspace.program);
    if (result.state == SpaceProgramState::balls_disjoint) break;
    const Vec3 own = is_wanted ? own_wanted : within(limits, result.point);
    const Vec3 candidate = is_wanted ? wanted : within_climb(robot, from_own(own, robot.vertical));
    const bool is_last = result.state == SpaceProgramState::least_unsafe || round + 1 == kRounds;
    const Asked asked = is_last ? Asked::until_refused : Asked::all;
    const bool is_rounded = round == 0 && !is_wanted && norm(candidate - wanted) < kByRounding;
    if (round == 0 && !is_wanted && !is_rounded) trace.is_refused();  // by its own limits
    if (!keeps_climb(robot, candidate)) break;  // no point keeps all cuts and the climb
    if (admits(robot, candidate, law, asked, constraints))
      return {candidate, is_wanted ? Chosen::wanted : Chosen::candidate, is_rounded};
    if (round == 0) trace.is_refused(robot, candidate, law, constraints);
    if (is_last) break;
    const std::size_t before = cuts.size();
    append_cuts(robot, law, constraints, cuts);
    for (std::size_t k = before; k < cuts.size(); ++k)
      cuts[k].offset += moved_in(norm(own), violation(cuts[k], own), limits.change);
  }
  const Vec3 backup = backup_velocity(robot, law);
  Choice choice{backup, Chosen::backup};
  cuts.clear();
  append_climb(robot, cuts);
  const SpaceProgramResult farthest = nearest_point(cuts, balls, own_wanted, workspace.program);
  if (farthest.state == SpaceProgramState::balls_disjoint) return choice;
  const Vec3 own_backup = to_own(backup, robot.vertical), to_farthest = farthest.point - own_backup;
  double admitted = 0.0, refused = 1.0;
  for (int i = 0; i < kCutBisections; ++i) {
    const double part = 0.5 * (admitted + refused);
    const Vec3 candidate =
        from_own(within(limits, own_backup + part * to_farthest), robot.vertical);
    if (keeps_climb(robot, candidate) &&
        admits(robot, candidate, law, Asked::until_refused, constraints)) {
      admitted = part;
      choice = {candidate, Chosen::candidate};
    } else {
      refused = part;
    }
  }
  return choice;
}

template Choice choose(const Robot&, Vec3, const StepLaw&, ChoiceWorkspace&, NoTrace);
template Choice choose(const Robot&, Vec3, const StepLaw&, ChoiceWorkspace&, Recorder);

}  // namespace avo::space
