// SPDX-License-Identifier: Apache-2.0
// Braking trajectories: the test of a candidate against the constraints, and the half-planes of the
// candidates that would have been admitted.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "certificate/braking_trajectories.h"
#include "certificate/kernels.h"

namespace avo::inline certificate {

TrajectoryConstraint constraint_at(const ConstraintColumns& columns, std::size_t index) {
  const std::size_t k = index;
  return {columns.neighbor[k],
          static_cast<int>(columns.interval[k]),
          columns.needs[k] >= 0.0,
          {columns.normal[0][k], columns.normal[1][k]},
          {columns.offset[0][k], columns.offset[1][k], columns.offset[2][k]},
          columns.cone[k],
          columns.bound[k]};
}

namespace {

// m, for the middle point of the step itself, which moves off the braking path if the disc swings.
double swing_coefficient(const TrajectoryConstraints& constraints, std::size_t k,
                         const CandidatePath& path, const StepLaw& law) {
  const ConstraintColumns& columns = constraints.columns;
  const Vec2 normal{columns.normal[0][k], columns.normal[1][k]};
  const Braking& own = constraints.own;
  const Vec2 middle = braking_distances(own.profile, law, 0).middle * own.direction + path.swing;
  const double cone = constraints.has_cones ? columns.cone[k] * norm(path.swing) : 0.0;
  return dot(normal, middle) + columns.offset[1][k] - cone;
}

// Tests the middle points of all constraints, which keeps() has tested.
bool keeps_swing(const CandidatePath& path, const StepLaw& law,
                 TrajectoryConstraints& constraints) {
  ConstraintColumns& columns = constraints.columns;
  bool kept = true;
  for (std::size_t k = 0; k < columns.count; ++k) {
    const bool asked = columns.needs[k] < path.moving;
    if (columns.interval[k] != 0.0 || !asked) continue;
    const double middle = swing_coefficient(constraints, k, path, law);
    columns.coefficient[k] = std::min(columns.coefficient[k], middle);
    kept = kept && middle >= 0.0;
  }
  return kept;
}

}  // namespace

bool keeps_trajectories(const CandidatePath& path, const StepLaw& law,
                        TrajectoryConstraints& constraints, Asked asked_for) {
  bool kept =
      keeps(constraints.own, path, law, constraints.has_cones, asked_for, constraints.columns);
  if (!kept && asked_for == Asked::until_refused) return false;
  if (!(path.swing == Vec2{})) kept = keeps_swing(path, law, constraints) && kept;
  return kept && !(constraints.stays_at_rest && path.moving > 0);
}

namespace {

// The vector from the point of A's braking path to the point of the path.
Vec2 deviation_at(const Braking& own, const TrajectoryConstraint& constraint, int point,
                  const CandidatePath& path, const StepLaw& law) {
  const auto pick = [point](const BrakingDistances& along) {
    return point == 0 ? along.start : point == 1 ? along.middle : along.end;
  };
  const Vec2 x = pick(braking_distances(own.profile, law, constraint.interval)) * own.direction;
  if (constraint.interval == 0) return point == 1 ? path.swing : path.first - x;
  const BrakingDistances along = braking_distances(path.braking, law, constraint.interval - 1);
  return path.first + pick(along) * path.direction - x;
}

}  // namespace

WorstConstraint worst_constraint(const TrajectoryConstraints& constraints,
                                 const CandidatePath& path, const StepLaw& law, std::size_t first,
                                 std::size_t last) {
  const ConstraintColumns& columns = constraints.columns;
  const double* coefficient = columns.coefficient.data();
  const std::size_t behind = std::min(last, columns.tested);
  WorstConstraint worst{std::numeric_limits<double>::infinity()};
  if (first >= behind) return worst;
  const std::size_t k = static_cast<std::size_t>(
      std::min_element(coefficient + first, coefficient + behind) - coefficient);
  if (!(coefficient[k] < 0.0)) return worst;
  const auto [start, middle, end] = scalar::coefficients<scalar::Pack<double>>(
      columns, k, constraints.own, path, law, constraints.has_cones);
  worst.constraint = constraint_at(columns, k);
  worst.coefficient = coefficient[k];
  worst.point = start.value <= worst.coefficient ? 0 : middle.value <= worst.coefficient ? 1 : 2;
  if (worst.point == 2 && end.value > worst.coefficient) worst.point = 1;  // the disc swings
  if (worst.constraint.cone > 0.0) {
    const Vec2 deviation = deviation_at(constraints.own, worst.constraint, worst.point, path, law);
    const double length = norm(deviation);
    if (length > 0.0) worst.lean = (worst.constraint.cone / length) * deviation;
  }
  return worst;
}

HalfPlane tangent(const WorstConstraint& worst, const CandidatePath& path, const StepLaw& law) {
  const TrajectoryConstraint& constraint = worst.constraint;
  auto [across, along] =
      point_growth(path.braking, path.speed, constraint.interval, worst.point, law);
  if (path.lever != 0.0 && path.speed > 0.0)
    across += path.lever / path.speed;  // it turns with v_1
  const Vec2 normal = constraint.normal - worst.lean;
  const double n_along = dot(normal, path.direction);
  const Vec2 gradient = across * normal + ((along - across) * n_along) * path.direction;
  const double length = norm(gradient);
  if (!(length > 0.0)) return {constraint.normal, dot(constraint.normal, path.next_velocity)};
  return {gradient / length, (dot(gradient, path.next_velocity) - worst.coefficient) / length};
}

}  // namespace avo::inline certificate
