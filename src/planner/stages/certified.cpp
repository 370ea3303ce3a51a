// SPDX-License-Identifier: Apache-2.0
// Chooses under a certificate: linear programs propose, the certificate's own test decides.
#include "planner/stages/certified.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "lp/linear_program.h"
#include "planner/stages/cuts.h"
#include "robots/model.h"

namespace avo::inline planner {
namespace {

// The inputs of the proposals.
struct Proposals {
  const Robot& robot;
  const CertificateLaw& law;
  Disc acceleration;  // of v_1
  double top_speed;   // m/s
  Vec2 wanted;
  Follows follows;  // for the wanted velocity
  CertifiedWorkspace& workspace;

  // begins with the half-planes of the robot's own motion alone
  void begin() const {
    workspace.hard.clear();
    if (!is_holonomic(robot.model))
      append_own_half_planes(robot, law.step.braking_time, workspace.hard);
  }
};

ProgramResult propose(const Proposals& proposals, double top_speed) {
  return nearest_point(proposals.workspace.hard, proposals.acceleration, top_speed,
                       proposals.wanted, proposals.workspace.rows);
}

// Returns whether a program with the robot's own half-planes alone would return the wanted
// velocity.
bool is_within_limits(const Proposals& proposals) {
  const auto within = [](Vec2 a, double radius) {
    return norm_squared(a) <= kLimitRounding * radius * radius;
  };
  const std::vector<HalfPlane>& own = proposals.workspace.hard;
  return within(proposals.wanted - proposals.robot.velocity, proposals.acceleration.radius) &&
         within(proposals.wanted, proposals.top_speed) &&
         std::all_of(own.begin(), own.end(), [&](const HalfPlane& plane) {
           return violation(plane, proposals.wanted) <= 0.0;
         });
}

// The part of a proposal that the robot can follow.
Vec2 followed(const Proposals& proposals, Vec2 next_velocity) {
  const Robot& robot = proposals.robot;
  if (!model_traits(robot.model).has_limits_within_steps) return next_velocity;
  if (proposals.follows == Follows::surely && next_velocity == proposals.wanted)
    return next_velocity;
  return within_own_limits(robot, proposals.law.step.braking_time, next_velocity);
}

bool is_admitted(const Proposals& proposals, Vec2 next_velocity,
                 Asked asked_for = Asked::until_refused) {
  return admits(proposals.robot, next_velocity, proposals.law, proposals.workspace.constraints,
                asked_for);
}

void move_in(HalfPlane& cut, const CandidatePath& refused, double u) {
  cut.offset += moved_in(refused.speed, violation(cut, refused.next_velocity), u);
}

// For every neighbor that refuses the tested path of the robot or one of its discs, appends the
// tangent of its worst constraint.
void append_trajectory_cuts(const Proposals& proposals, const TrajectoryConstraints& constraints,
                            const CandidatePath& path) {
  const ConstraintColumns& columns = constraints.columns;
  for (std::size_t first = 0; first < columns.count;) {
    std::size_t last = first;
    while (last < columns.count && columns.neighbor[last] == columns.neighbor[first]) ++last;
    const WorstConstraint worst =
        worst_constraint(constraints, path, proposals.law.step, first, last);
    if (worst.coefficient < 0.0 && std::isfinite(worst.coefficient)) {
      HalfPlane cut = tangent(worst, path, proposals.law.step);
      move_in(cut, path, proposals.acceleration.radius);
      proposals.workspace.hard.push_back(cut);
    }
    first = last;
  }
}

// The cuts of loiterers are exact: their half-planes are no tangents.
void append_loiterer_cuts(const Proposals& proposals) {
  const CertificateConstraints& constraints = proposals.workspace.constraints;
  if (keeps_loiterers(constraints.loiterers, constraints.path, proposals.law.step)) return;
  std::vector<HalfPlane>& hard = proposals.workspace.hard;
  const std::size_t before = hard.size();
  const double u = proposals.acceleration.radius;
  const double fastest = std::min(norm(proposals.robot.velocity) + u, proposals.top_speed);
  append_half_planes(constraints.loiterers, proposals.robot, proposals.law.step, fastest, hard);
  for (std::size_t k = before; k < hard.size(); ++k) hard[k].offset += kInside * u;
}

void append_cuts_of_walls(const Proposals& proposals, const WallConstraints& walls,
                          const CandidatePath& path) {
  std::vector<HalfPlane>& hard = proposals.workspace.hard;
  const std::size_t before = hard.size();
  append_wall_cuts(walls, path, proposals.law.step, hard);
  for (std::size_t k = before; k < hard.size(); ++k)
    move_in(hard[k], path, proposals.acceleration.radius);
}

// Appends the cuts of all constraints that refuse the last tested path.
void append_cuts(const Proposals& proposals) {
  const CertificateConstraints& constraints = proposals.workspace.constraints;
  append_trajectory_cuts(proposals, constraints.trajectories, constraints.path);
  for (const DiscConstraints& disc : constraints.footprint.all())
    append_trajectory_cuts(proposals, disc.trajectories, disc.path);
  append_loiterer_cuts(proposals);
  append_cuts_of_walls(proposals, constraints.walls, constraints.path);
  for (const DiscConstraints& disc : constraints.footprint.all())
    append_cuts_of_walls(proposals, disc.walls, disc.path);
}

// Braking trajectories are not convex in v_1: the constraints that a proposal violates are added as
// their tangents there. The last resort is the admitted point between the backup and the wanted
// velocity that bisection finds.
template <typename Trace>
CertifiedChoice choose_by_cuts(const Proposals& proposals, Trace trace) {
  const bool rests = proposals.wanted == Vec2{} && proposals.robot.velocity == Vec2{};
  if (rests && is_admitted(proposals, {})) return {{}, Chosen::wanted};
  proposals.begin();
  const bool has_own_planes = !proposals.workspace.hard.empty();
  for (int round = 0; round < kRounds; ++round) {
    ProgramResult result;
    result.point = proposals.wanted;
    if (round > 0 || !is_within_limits(proposals)) result = propose(proposals, proposals.top_speed);
    if (result.state == ProgramState::discs_disjoint) break;
    // the result violates all half-planes, also those of the robot's own motion
    if (result.state == ProgramState::least_unsafe && has_own_planes) break;
    const Vec2 candidate = followed(proposals, result.point);
    const bool is_last = result.state == ProgramState::least_unsafe || round + 1 == kRounds;
    if (is_admitted(proposals, candidate, is_last ? Asked::until_refused : Asked::all)) {
      const bool wanted = round == 0 && candidate == result.point;
      return {candidate, wanted ? Chosen::wanted : Chosen::candidate};
    }
    if (round == 0) trace.is_refused(proposals.law.step, proposals.workspace.constraints);
    if (is_last) break;
    append_cuts(proposals);
  }
  const Vec2 backup = backup_velocity(proposals.robot, proposals.law);
  CertifiedChoice choice{backup, Chosen::backup};
  proposals.begin();
  const ProgramResult farthest = propose(proposals, proposals.top_speed);
  if (farthest.state == ProgramState::discs_disjoint) return choice;
  double admitted = 0.0, refused = 1.0;
  for (int i = 0; i < kCutBisections; ++i) {
    const double part = 0.5 * (admitted + refused);
    const Vec2 candidate = followed(proposals, backup + part * (farthest.point - backup));
    if (is_admitted(proposals, candidate)) {
      admitted = part;
      choice = {candidate, Chosen::candidate};
    } else {
      refused = part;
    }
  }
  return choice;
}

Proposals proposals_of(const Robot& robot, Vec2 wanted, const CertificateLaw& law, Follows follows,
                       CertifiedWorkspace& workspace) {
  const double u = increment(robot.max_acceleration, law.step);
  return {robot,
          law,
          {robot.velocity, model_traits(robot.model).reach * u},
          is_holonomic(robot.model) ? robot.max_speed : top_speed_of(robot, u),
          wanted,
          follows,
          workspace};
}

}  // namespace

bool may_choose(const Robot& robot, Vec2 next_velocity, const CertificateLaw& law,
                CertifiedWorkspace& workspace) {
  const Proposals proposals = proposals_of(robot, next_velocity, law, Follows::perhaps, workspace);
  proposals.begin();
  if (!is_within_limits(proposals)) return false;
  return law.kind == Certificate::none ||
         is_admitted(proposals, followed(proposals, next_velocity));
}

template <typename Trace>
CertifiedChoice choose_certified(const Robot& robot, Vec2 wanted, const CertificateLaw& law,
                                 CertifiedWorkspace& workspace, Follows follows, Trace trace) {
  return choose_by_cuts(proposals_of(robot, wanted, law, follows, workspace), trace);
}

template CertifiedChoice choose_certified(const Robot&, Vec2, const CertificateLaw&,
                                          CertifiedWorkspace&, Follows, NoTrace);
template CertifiedChoice choose_certified(const Robot&, Vec2, const CertificateLaw&,
                                          CertifiedWorkspace&, Follows, Recorder);

}  // namespace avo::inline planner
