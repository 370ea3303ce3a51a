// SPDX-License-Identifier: Apache-2.0
// Cutting planes: the walls that a choice violates are added to the program as their tangents there.
// Whatever comes out is admitted by the certificate's own test, or it is braking.
#include "planner/certified.h"

#include <cstddef>

namespace avo {
namespace {

constexpr int kRounds = 6;
constexpr int kBisections = 5;

Vec2 next_velocity(const CertifiedProgram& program, Vec2 v_new) {
  return program.robot.velocity + program.rate * (v_new - program.robot.velocity);
}

WorstWall judge(const CertifiedProgram& program, Vec2 v_new, CertifiedWorkspace& workspace) {
  follow(program.robot, next_velocity(program, v_new), program.law, workspace.walls.intervals,
         workspace.path);
  return worst_wall(workspace.walls, workspace.path);
}

// The worst wall of every neighbor that workspace.path violates, as a half-plane in v'.
void append_cuts(const CertifiedProgram& program, CertifiedWorkspace& workspace) {
  const auto& walls = workspace.walls.walls;
  TrajectoryWalls& all = workspace.walls;
  for (std::size_t first = 0; first < walls.size();) {
    std::size_t last = first;
    while (last < walls.size() && walls[last].neighbor == walls[first].neighbor) ++last;
    const WorstWall worst = worst_wall(all, workspace.path, first, last);
    if (worst.coefficient < 0.0 && worst.wall >= 0) {
      const HalfPlane next = tangent(walls[static_cast<std::size_t>(worst.wall)], worst.point,
                                     workspace.path, program.robot, program.law);
      const double kept = (1.0 - program.rate) * dot(next.normal, program.robot.velocity);
      workspace.cuts.push_back({next.normal, (next.offset - kept) / program.rate});
    }
    first = last;
  }
}

// The admitted point of the segment from braking towards `choice` that bisection finds.
CertifiedChoice towards(const CertifiedProgram& program, Vec2 choice,
                        CertifiedWorkspace& workspace) {
  CertifiedChoice result{program.braking, Chosen::braking, false};
  double admitted = 0.0, refused = 1.0;
  for (int i = 0; i < kBisections; ++i) {
    const double part = 0.5 * (admitted + refused);
    const Vec2 candidate = program.braking + part * (choice - program.braking);
    if (judge(program, candidate, workspace).coefficient >= 0.0) {
      admitted = part;
      result = {candidate, Chosen::candidate, false};
    } else {
      refused = part;
    }
  }
  return result;
}

}  // namespace

CertifiedChoice choose_certified(const CertifiedProgram& program, Vec2 preferred,
                                 CertifiedWorkspace& workspace) {
  workspace.cuts.clear();
  Vec2 first;
  for (int round = 0; round < kRounds; ++round) {
    const ProgramResult result =
        nearest_point(workspace.cuts, program.soft, program.acceleration, program.speed, preferred,
                      workspace.projected);
    if (result.state == ProgramState::discs_disjoint) return {program.braking, Chosen::braking, true};
    if (round == 0) first = result.point;
    if (judge(program, result.point, workspace).coefficient >= 0.0) {
      return {result.point, round == 0 ? Chosen::program : Chosen::candidate, false};
    }
    if (result.state == ProgramState::hard_infeasible) break;
    append_cuts(program, workspace);
  }
  return towards(program, first, workspace);
}

}  // namespace avo
