// SPDX-License-Identifier: Apache-2.0
#include "space/mover_constraints.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "certificate/take_off.h"

namespace avo::space {
namespace {

using Real = scalar::Pack<double>;

// m: the largest distance that the moving obstacle may move while A may move.
double length_of_mover(const Mover& mover, double time) {
  const double length = time * norm(mover.velocity) + 0.5 * time * time * norm(mover.acceleration);
  if (!(mover.max_deviation > 0.0)) return length;
  return std::min(length + 0.5 * time * time * mover.max_deviation, time * mover.max_speed);
}

double one_norm(Vec3 a) {
  return std::abs(a.x) + std::abs(a.y) + std::abs(a.z);
}

BrakingPair pair_of(const Robot& robot, const Mover& mover, const Braking& own, double length,
                    const StepLaw& law) {
  BrakingPair pair{};
  pair.p = robot.position - mover.position;
  pair.contact = robot.radius + mover.radius;
  pair.share = 1.0;
  pair.a = own;
  const double lengths =
      pair.contact + own.reach + one_norm(robot.position) + one_norm(mover.position) + length;
  pair.inflated =
      pair.contact + scalar::rounding_margin<Real, 3>(lengths, own.intervals, 1.0).value;
  pair.error = error_at(law, law.time_step * own.intervals);
  return pair;
}

double append(const PairConstraints& wanted, const Mover& mover, const StepLaw& law,
              MoverConstraints& constraints) {
  using scalar::DeviatingOther, scalar::MovingOther;
  const MovingOther<Real, 3, Mover> other{mover, law};
  if (mover.max_deviation > 0.0)
    return scalar::append<Real, false>(wanted, DeviatingOther<Real, 3, Mover>{other}, law,
                                       constraints.own_columns, constraints.columns);
  return scalar::append<Real, false>(wanted, other, law, constraints.own_columns,
                                     constraints.columns);
}

void collect(const BrakingPair& pair, const Mover& mover, int index, const PairShape<3>& shape,
             const StepLaw& law, MoverConstraints& constraints) {
  static constexpr avo::Neighbor kNone;  // the kernel takes the moving obstacle itself
  const double inflation = parabola_error(mover, law);
  PairConstraints wanted{
      .pair = pair,
      .other = kNone,
      .neighbor = index,
      .intervals = static_cast<std::size_t>(pair.a.intervals),
      .inflated = pair.inflated + inflation,
      .held = pair.inflated + inflation,
      .moving = braking_steps_at_least(pair.a.profile.speed, pair.a.profile.decrement),
      .shape = shape};
  ConstraintColumns& columns = constraints.columns;
  Invariant& invariant = constraints.invariant;
  const std::size_t first = columns.count;
  columns.reserve(first + wanted.intervals);
  const double nearest = append(wanted, mover, law, constraints);
  wanted.held = held_distance(pair, nearest, index, invariant) + inflation;
  if (nearest < pair.contact + pair.error + inflation) invariant.doubtful = true;
  scalar::hold<Real>(wanted, first, columns);
  if (nearest < pair.contact - pair.error) invariant.touched = true;
  take_off(wanted, first, law, constraints);
}

}  // namespace

void MoverConstraints::clear() {
  columns.count = columns.tested = 0;
  own_columns.count = own_columns.filled = 0;
  invariant = {.slack = std::numeric_limits<double>::infinity()};
  stays_at_rest = has_cones = counts = false;
}

SensingError error_against(const Mover& mover, const StepLaw& law) {
  const auto& [position, velocity] = law.sensing_error;
  const double time = mover.age * law.time_step;
  return {position + time * velocity + 0.5 * mover.max_deviation * time * time,
          velocity + mover.max_deviation * time};
}

double parabola_error(const Mover& mover, const StepLaw& law) {
  if (law.lag == 0.5 * law.time_step) return 0.0;
  return 0.125 * law.time_step * law.time_step * norm(mover.acceleration);
}

void begin_movers(const Robot& robot, std::span<const Mover> movers, const Braking& own,
                  Vec3 own_direction, const Deviation& deviation, const StepLaw& law,
                  MoverConstraints& constraints) {
  constraints.clear();
  if (movers.empty()) return;
  constraints.counts = true;
  if (!(own.intervals <= kMostIntervals)) {
    constraints.invariant.unknown = true;
    return;
  }
  const auto intervals = static_cast<std::size_t>(own.intervals);
  constraints.own_columns.count = intervals;
  constraints.own_columns.reserve(intervals);
  scalar::fill_own<Real>(own, deviation, law, constraints.own_columns);
  const PairShape<3> shape{0.0, 0.0, robot.vertical, own_direction};
  for (std::size_t k = 0; k < movers.size(); ++k) {
    const Mover& mover = movers[k];
    StepLaw pair_law = law;
    pair_law.sensing_error = error_against(mover, law);
    const double length = length_of_mover(mover, law.time_step * own.intervals);
    const BrakingPair pair = pair_of(robot, mover, own, length, pair_law);
    const double apart = norm(pair.p);
    if (apart < pair.contact + pair_law.sensing_error.position)
      constraints.invariant.touched = true;
    if (apart - (own.reach + length) > pair.inflated + pair.error) continue;
    collect(pair, mover, static_cast<int>(k), shape, pair_law, constraints);
  }
}

}  // namespace avo::space
