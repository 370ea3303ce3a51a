// SPDX-License-Identifier: Apache-2.0
// Whether a candidate keeps the constraints, and what cuts it off where it does not.
#include <algorithm>
#include <cmath>

#include "space/certificate.h"
#include "space/own_space.h"

namespace avo::space {
namespace {

constexpr double kForEver = 1e9;  // more than any constraint's interval

CandidatePath follow(const Robot& robot, Vec3 next_velocity, const StepLaw& law) {
  CandidatePath path;
  path.first = law.lag * robot.velocity + (law.time_step - law.lag) * next_velocity;
  path.next_velocity = next_velocity;
  const Braking braking =
      braking_of(next_velocity, robot.max_acceleration, braking_limit(robot), robot.vertical, law);
  path.speed = braking.profile.speed;
  path.direction = braking.direction;
  path.braking = braking.profile;
  const bool stays = path.speed == 0.0 && robot.velocity == Vec3{};
  const double steps = path.speed > 0.0 ? std::min(path.braking.full_steps + 1.0, kForEver) : 0.0;
  path.moving = stays ? 0 : 1 + static_cast<int>(steps);
  return path;
}

/// The constraint that a path violates most, and the distances along its braking, m.
struct Worst {
  double coefficient = 0.0;  ///< m, < 0
  std::size_t k = 0;
  int point = 0;
};

Worst worst_of(const Constraints& constraints, const ConstraintColumns& columns, bool has_cones,
               const StepLaw& law, std::size_t first, std::size_t last) {
  const double* coefficient = columns.coefficient.data();
  Worst worst;
  worst.k = static_cast<std::size_t>(std::min_element(coefficient + first, coefficient + last) -
                                     coefficient);
  worst.coefficient = coefficient[worst.k];
  if (!(worst.coefficient < 0.0)) return worst;
  const auto [start, middle, end] = scalar::coefficients<scalar::Pack<double>>(
      columns, worst.k, constraints.own, constraints.path, law, has_cones);
  worst.point = start.value <= worst.coefficient ? 0 : middle.value <= worst.coefficient ? 1 : 2;
  return worst;
}

HalfSpace tangent(const Robot& robot, const Worst& worst, const StepLaw& law,
                  const ConstraintColumns& columns, const CandidatePath& path) {
  const auto [across, along] = point_growth(
      path.braking, path.speed, static_cast<int>(columns.interval[worst.k]), worst.point, law);
  const Vec3 normal =
      from_own({columns.normal[0][worst.k], columns.normal[1][worst.k], columns.normal[2][worst.k]},
               robot.vertical);
  const Vec3 v = to_own(path.next_velocity, robot.vertical);
  const double speed = norm(v);
  const Vec3 direction = speed > 0.0 ? v / speed : Vec3{};
  const Vec3 gradient = across * normal + ((along - across) * dot(normal, direction)) * direction;
  const double length = norm(gradient);
  if (!(length > 0.0)) return {normal / norm(normal), dot(normal, v) / norm(normal)};
  return {gradient / length, (dot(gradient, v) - worst.coefficient) / length};
}

// The cuts of neighbors or of moving obstacles.
void append_cuts_of(const Robot& robot, const StepLaw& law, const Constraints& constraints,
                    const ConstraintColumns& columns, bool has_cones,
                    std::vector<HalfSpace>& cuts) {
  for (std::size_t first = 0; first < columns.tested;) {
    std::size_t last = first;
    while (last < columns.tested && columns.neighbor[last] == columns.neighbor[first]) ++last;
    const Worst worst = worst_of(constraints, columns, has_cones, law, first, last);
    if (worst.coefficient < 0.0 && std::isfinite(worst.coefficient))
      cuts.push_back(tangent(robot, worst, law, columns, constraints.path));
    first = last;
  }
}

bool keeps_movers(const StepLaw& law, Asked asked_for, Constraints& constraints) {
  MoverConstraints& movers = constraints.movers;
  movers.columns.tested = 0;
  if (!movers.counts) return true;
  const bool kept = kernels().keeps(constraints.own, constraints.path, law, movers.has_cones,
                                    asked_for, movers.columns);
  return kept && !movers.must_rest(constraints.path.moving);
}

}  // namespace

bool admits(const Robot& robot, Vec3 next_velocity, const StepLaw& law, Asked asked_for,
            Constraints& constraints) {
  if (constraints.invariant.unknown) return false;
  append_needed(robot, next_velocity, law, constraints);
  if (constraints.columns.count == 0 && !constraints.movers.counts) {
    constraints.movers.columns.tested = 0;
    constraints.path.next_velocity = next_velocity;
    return keeps_boxes(robot, next_velocity, law, constraints.boxes);
  }
  constraints.path = follow(robot, next_velocity, law);
  bool kept = kernels().keeps(constraints.own, constraints.path, law, constraints.has_cones,
                              asked_for, constraints.columns);
  if (!kept && asked_for == Asked::until_refused) return false;
  kept = keeps_movers(law, asked_for, constraints) && kept;
  if (!kept && asked_for == Asked::until_refused) return false;
  return keeps_boxes(robot, next_velocity, law, constraints.boxes) && kept;
}

Vec3 backup_velocity(const Robot& robot, const StepLaw& law) {
  const double speed = own_length(robot.velocity, robot.vertical);
  const double u = braking_limit(robot) * law.braking_time;
  return speed > u ? ((speed - u) / speed) * robot.velocity : Vec3{};
}

void append_cuts(const Robot& robot, const StepLaw& law, const Constraints& constraints,
                 std::vector<HalfSpace>& cuts) {
  append_cuts_of(robot, law, constraints, constraints.columns, constraints.has_cones, cuts);
  const MoverConstraints& movers = constraints.movers;
  append_cuts_of(robot, law, constraints, movers.columns, movers.has_cones, cuts);
  append_box_cuts(robot, constraints.path.next_velocity, law, constraints.boxes, cuts);
}

}  // namespace avo::space
