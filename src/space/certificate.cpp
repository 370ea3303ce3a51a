// SPDX-License-Identifier: Apache-2.0
#include "space/certificate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "avo/robot.h"
#include "certificate/allow_braking.h"
#include "space/own_space.h"

namespace avo::space {
namespace {

using Real = scalar::Pack<double>;

scalar::Vec<Real, 3> pack(Vec3 a) {
  return scalar::constant<Real>(a);
}

Braking plain(const scalar::PackBraking<Real, 3>& braking) {
  return {.profile = {braking.profile.speed.value, braking.profile.decrement.value,
                      braking.profile.full_steps.value},
          .increment = braking.increment.value,
          .direction = scalar::plain(braking.direction),
          .length = braking.length.value,
          .reach = braking.reach.value,
          .intervals = braking.intervals.value};
}

// What candidates can deviate from braking, in the robot's own space, where it brakes with u.
scalar::PackDeviation<Real> deviation_of(const Robot& robot, const Braking& braking,
                                         const StepLaw& law) {
  scalar::PackBraking<Real, 3> own = scalar::constant<Real, 3>(braking);
  if (robot.vertical != 1.0) {
    own.profile = scalar::profile(Real(own_length(robot.velocity, robot.vertical)),
                                  Real(braking_limit(robot) * law.braking_time));
  }
  return scalar::deviation_of(own, Real(0.0), Real(0.0), law);
}

Deviation plain(const scalar::PackDeviation<Real>& deviation) {
  const auto line = [](const auto& a) {
    return Deviation::Line{a.start.value, a.per_distance.value};
  };
  const auto profile = [](const scalar::PackProfile<Real>& a) {
    return BrakingProfile{a.speed.value, a.decrement.value, a.full_steps.value};
  };
  return {line(deviation.ahead),     line(deviation.across),  line(deviation.anyhow),
          profile(deviation.fast),   profile(deviation.slow), deviation.most_ahead.value,
          deviation.most_aside.value};
}

// A robot or a neighbor.
scalar::PackRobot<Real, 3> pack(const auto& robot, const Braking& braking) {
  return {pack(robot.position),
          pack(robot.velocity),
          robot.radius,
          robot.max_acceleration,
          braking_limit(robot),
          robot.priority,
          scalar::constant<Real, 3>(braking),
          robot.vertical,
          robot.downwash};
}

// For a pair that nearly coincides, drops the intervals on which it has no direction.
void drop_undirected(std::size_t first, ConstraintColumns& columns) {
  for (std::size_t k = first; k < columns.count; ++k) {
    const bool has_direction =
        columns.normal[0][k] != 0.0 || columns.normal[1][k] != 0.0 || columns.normal[2][k] != 0.0;
    if (!has_direction || columns.cone[k] > 0.0) columns.needs[k] = kNoConstraint;
  }
}

void append_pair(const BrakingPair& pair, const PairShape<3>& shape, int index, const StepLaw& law,
                 Constraints& constraints) {
  const double most = std::max(pair.a.intervals, pair.b.intervals);
  if (!(most <= kMostIntervals)) {
    constraints.invariant.unknown = true;
    return;
  }
  const auto intervals = static_cast<std::size_t>(most);
  if (intervals > constraints.own_columns.count) {
    constraints.own_columns.count = intervals;
    constraints.own_columns.reserve(intervals);
    kernels().fill_own(constraints.own, constraints.deviation, law, constraints.own_columns);
  }
  static constexpr avo::Neighbor kDecides;  // the pair has all its data that matter
  PairConstraints wanted{.pair = pair,
                         .other = kDecides,
                         .neighbor = index,
                         .intervals = intervals,
                         .inflated = pair.inflated,
                         .held = pair.inflated,
                         .moving = std::numeric_limits<double>::infinity(),
                         .shape = shape};
  ConstraintColumns& columns = constraints.columns;
  const std::size_t first = columns.count;
  columns.reserve(first + intervals);
  const double nearest =
      kernels().append_constraints(wanted, law, constraints.own_columns, columns);
  wanted.held = held_distance(pair, nearest, index, constraints.invariant);
  if (columns.count > first) kernels().hold(wanted, first, columns);
  if (nearest < pair.contact - pair.error && nearly_coincide(nearest, pair.contact))
    drop_undirected(first, columns);
  if (law.is_exact()) return;
  for (std::size_t k = first; k < columns.count; ++k) {
    if (!columns.is_constraint(k) || !(columns.cone[k] > 0.0)) continue;
    constraints.has_cones = true;
    allow_braking(constraints.own, law, columns, k);
  }
}

// What the pair can refuse: the gap is infinite where the pair refuses nothing, and -infinity where
// nothing is known. See docs/space.md, "What can refuse nothing".
scalar::PackClearance<Real> clearance_of(const scalar::PackRobot<Real, 3>& self,
                                         const scalar::PackRobot<Real, 3>& other,
                                         const scalar::PackPair<Real, 3>& pair,
                                         const PairShape<3>& shape, const StepLaw& law) {
  const double apart = scalar::distance_to(pair.p, shape).value;
  if (apart - (self.braking.reach.value + pair.b.reach.value) >
      pair.inflated.value + pair.error.value)
    return {std::numeric_limits<double>::infinity(), 1.0};
  if (!law.is_exact() || shape.vertical != 1.0 || other.vertical.value != 1.0)
    return {-std::numeric_limits<double>::infinity(), 1.0};
  scalar::PackClearance<Real> clearance = scalar::clearance_of(self, pair, other, law);
  if (!shape.has_wash()) return clearance;
  // directions between a robot and the far end of a downwash are not those of `against`
  return {clearance.gap - pair.share * Real(std::max(shape.up, shape.down)), 1.0};
}

/// A pair, and what else is asked of it.
struct CertifiedPair {
  scalar::PackRobot<Real, 3> self, other;
  StepLaw law;  // against this body
  scalar::PackPair<Real, 3> packed;
  PairShape<3> shape;

  scalar::PackClearance<Real> clearance() const {
    return clearance_of(self, other, packed, shape, law);
  }
};

CertifiedPair pair_of(const Robot& robot, const Bodies& bodies, std::uint32_t place,
                      const StepLaw& law, const Constraints& constraints) {
  CertifiedPair pair{pack(robot, constraints.own),
                     pack(bodies.neighbor(place), bodies.braking(place)),
                     law,
                     {},
                     {}};
  if (bodies.has_ages || (!law.is_exact() && bodies.has_vertical))
    pair.law = law_against(bodies.neighbor(place), law);
  pair.packed = scalar::pair_of(pair.self, pair.other, pair.law);
  pair.shape = {robot.downwash, pair.other.downwash.value, robot.vertical,
                constraints.own_direction};
  return pair;
}

void append_body(const Robot& robot, const NearBody& body, const StepLaw& law,
                 Constraints& constraints) {
  const Bodies& bodies = *constraints.bodies;
  const int number = static_cast<int>(body.number);
  const Braking b = bodies.braking(body.place);
  if (body.share > 0.0) {  // the look has computed the pair
    const BrakingPair pair{robot.position - bodies.place_of(body.place),
                           robot.radius + bodies.radius[body.place],
                           body.inflated,
                           0.0,
                           body.share,
                           true,
                           constraints.own,
                           b};
    const PairShape<3> ball{0.0, 0.0, 1.0, constraints.own_direction};
    return append_pair(pair, ball, number, law, constraints);
  }
  const CertifiedPair pair = pair_of(robot, bodies, body.place, law, constraints);
  const scalar::PackPair<Real, 3>& packed = pair.packed;
  const BrakingPair braking{scalar::plain(packed.p), packed.contact.value,
                            packed.inflated.value,   packed.error.value,
                            packed.share.value,      true,
                            constraints.own,         b};
  append_pair(braking, pair.shape, number, pair.law, constraints);
}

}  // namespace

Braking braking_of(Vec3 velocity, double max_acceleration, double max_braking, double vertical,
                   const StepLaw& law) {
  return plain(scalar::braking_of(pack(velocity), Real(max_acceleration), Real(max_braking),
                                  Real(vertical), law));
}

Braking braking_of(const Robot& robot, const StepLaw& law) {
  return braking_of(robot.velocity, robot.max_acceleration, braking_limit(robot), robot.vertical,
                    law);
}

void begin_constraints(const Robot& robot, const Braking& own, const StepLaw& law,
                       Constraints& constraints) {
  constraints.columns.count = constraints.columns.tested = 0;
  constraints.own_columns.count = constraints.own_columns.filled = 0;
  constraints.waiting.clear();
  constraints.invariant = {.slack = std::numeric_limits<double>::infinity()};
  constraints.has_cones = false;
  constraints.movers.clear();
  constraints.own = own;
  constraints.deviation = plain(deviation_of(robot, own, law));
  const Vec3 own_velocity = to_own(robot.velocity, robot.vertical);
  const double own_speed = norm(own_velocity);
  constraints.own_direction = own_speed > 0.0 ? own_velocity / own_speed : Vec3{};
}

void collect_constraints(const Robot& robot, const Bodies& bodies, std::span<const NearBody> near,
                         std::span<const Box> boxes, const StepLaw& law, Constraints& constraints) {
  const Deviation& deviation = constraints.deviation;
  constraints.bodies = &bodies;
  for (NearBody body : near) {
    if (body.gap == kUnknownGap) {
      const auto clearance = pair_of(robot, bodies, body.place, law, constraints).clearance();
      body.gap = clearance.gap.value, body.against = clearance.against.value;
      if (body.gap > body.against * deviation.most_ahead + deviation.most_aside) continue;
    }
    const bool is_short =
        std::max(constraints.own.intervals, bodies.intervals[body.place]) <= kMostIntervals;
    if (body.gap > 0.0 && is_short)
      constraints.waiting.push_back(body);
    else
      append_body(robot, body, law, constraints);
  }
  begin_boxes(robot, boxes, law, constraints.boxes);
}

void append_needed(const Robot& robot, Vec3 next_velocity, const StepLaw& law,
                   Constraints& constraints) {
  if (constraints.waiting.empty()) return;
  const auto deviation = scalar::candidate_deviation(scalar::constant<Real, 3>(constraints.own),
                                                     pack(next_velocity), law);
  std::erase_if(constraints.waiting, [&](const NearBody& body) {
    if (body.gap > body.against * deviation.ahead.value + deviation.aside.value) return false;
    append_body(robot, body, law, constraints);
    return true;
  });
}

}  // namespace avo::space
