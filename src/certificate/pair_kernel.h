// SPDX-License-Identifier: Apache-2.0
// Pairs that may have to brake for each other, as many at once as Pack has lanes. Included into a
// namespace that has Pack, after braking_kernel.h, once per instruction set.

/// See Braking.
template <typename Real>
struct PackBraking {
  PackProfile<Real> profile;
  Vec<Real> direction;
  Real length, reach, intervals;
};

template <typename Real>
AVO_KERNEL PackBraking<Real> braking_of(Vec<Real> velocity, Real max_acceleration,
                                        const StepLaw& law) {
  const Real zero(0.0), one(1.0), speed = norm(velocity);
  const Real u = max_acceleration * Real(law.braking_time);
  const auto moves = speed > zero;
  const Vec<Real> direction = velocity / select(moves, speed, one);
  PackBraking<Real> result;
  result.profile = profile(speed, u);
  result.direction = {select(moves, direction.x, zero), select(moves, direction.y, zero)};
  // it may be faster than it looks
  const PackProfile<Real> top = profile(speed + Real(law.sensing_error.velocity) + u, u);
  result.length = stopping_length(result.profile, law);
  result.reach =
      Real(law.lag) * speed + Real(law.time_step - law.lag) * top.speed + stopping_length(top, law);
  result.intervals = Real(2.0) + top.full_steps;
  return result;
}

/// See Neighbor.
template <typename Real>
struct PackNeighbor {
  Vec<Real> position, velocity;
  Real radius, max_acceleration;
};

/// See BrakingPair, of one that decides.
template <typename Real>
struct PackPair {
  Vec<Real> p;
  Real distance, contact, inflated, error, share;
  PackBraking<Real> b;
};

/// Rounding moves a pair by at most 2^-50 of its lengths a step. While both brake such errors add
/// up, for at most so many steps; a decision shrinks what has added up by a share.
/// docs/certificate.md, "Rounding"; four times what is derived there.
template <typename Real>
AVO_KERNEL Real rounding_margin(Real lengths, Real intervals, Real shrinks) {
  return Real(0x1p-48) * lengths * (Real(1.0) + intervals) / shrinks;
}

template <typename Real>
AVO_KERNEL PackPair<Real> pair_of(const Robot& robot, const Braking& a,
                                  const PackNeighbor<Real>& of, const StepLaw& law) {
  const Real a_A(robot.max_acceleration), one(1.0);
  const Vec<Real> p_A = constant<Real>(robot.position);
  PackPair<Real> pair;
  pair.b = braking_of(of.velocity, of.max_acceleration, law);
  pair.p = p_A - of.position;
  pair.distance = norm(pair.p);
  pair.contact = Real(robot.radius) + of.radius;
  pair.share = a_A / (a_A + of.max_acceleration);
  const Real lengths = pair.contact + Real(a.reach) + pair.b.reach + norm(p_A) + norm(of.position);
  pair.inflated = pair.contact + rounding_margin(lengths, max(Real(a.intervals), pair.b.intervals),
                                                 min(pair.share, one - pair.share));
  pair.error = Real(law.sensing_error.position) +
               Real(law.sensing_error.velocity * law.time_step) * pair.b.intervals;
  return pair;
}

/// Whether A's share of the gap that joint braking leaves exceeds all that a candidate of A's can
/// deviate (docs/certificate.md, "What can refuse nothing"): B can refuse nothing, whatever it
/// does.
template <typename Real>
AVO_KERNEL auto refuses_nothing(const Robot& robot, const Braking& a, const Deviation& deviation,
                                const PackPair<Real>& pair, const PackNeighbor<Real>& of,
                                const StepLaw& law) {
  const Real zero(0.0), one(1.0), d = pair.distance, length_A(a.length);
  const Vec<Real> d_A = constant<Real>(a.direction), d_B = pair.b.direction;
  const auto apart = d > zero;
  // along p, whenever each of them stops
  const Real towards =
      min(zero, length_A * dot(pair.p, d_A)) - max(zero, pair.b.length * dot(pair.p, d_B));
  const Real alone = d + towards / select(apart, d, one);
  // equally able ones brake with less relative velocity than they have
  const Real steps = one + max(Real(a.profile.full_steps), pair.b.profile.full_steps);
  const Real drift =
      Real(law.time_step) * steps * norm(constant<Real>(robot.velocity) - of.velocity);
  const Real a_A(robot.max_acceleration);
  const auto able_alike = (of.max_acceleration <= a_A) & (of.max_acceleration >= a_A);
  const Real together = select(able_alike, d - drift, alone);
  const Real nearest = max(alone, together);
  const Real passes = pair.b.length * max(zero, dot(d_A, d_B));
  const Real shift = select(able_alike, min(passes, drift), passes);
  const auto clear = apart & (nearest > zero);
  // largest part of any of the walls' normals against A's direction
  const Real against = max(zero, shift - dot(pair.p, d_A)) / select(clear, nearest, one);
  const Real loss = min(against, one) * Real(deviation.most_ahead) + Real(deviation.most_aside);
  return clear & (pair.share * (nearest - pair.inflated) > loss);
}

template <typename Real>
AVO_KERNEL PackNeighbor<Real> load(const Neighbors& neighbors, std::size_t k) {
  const NeighborColumns& of = *neighbors.columns;
  const std::size_t at = neighbors.first + k;
  return {{Real::load(&of.x[at]), Real::load(&of.y[at])},
          {Real::load(&of.v_x[at]), Real::load(&of.v_y[at])},
          Real::load(&of.radius[at]),
          Real::load(&of.max_acceleration[at])};
}

/// Those of the lanes that there are.
template <typename Real>
AVO_KERNEL auto counted(const Neighbors& neighbors, std::size_t k) {
  return lane_numbers<Real>() < Real(static_cast<double>(neighbors.count - k));
}

/// See FarBound.
template <typename Real>
AVO_KERNEL auto are_far(const FarBound& bound, Vec<Real> p, const PackNeighbor<Real>& of) {
  const Real a_max(bound.max_acceleration), squared = dot(of.velocity, of.velocity);
  const Real reach =
      Real(bound.reach[0]) + Real(bound.reach[1]) * sqrt(squared) + Real(bound.reach[2]) * squared;
  const Real distance = Real(bound.distance) + of.radius + reach;
  return (dot(p, p) > Real(kFarther) * (distance * distance)) &
         (squared <= Real(bound.speed_squared)) & (of.max_acceleration <= a_max) &
         (of.max_acceleration >= a_max);
}

template <typename Real>
AVO_KERNEL void store(const PackPair<Real>& pair, std::size_t k, NearColumns& pairs) {
  const auto store = [k](Real value, std::vector<double>& column) { value.store(&column[k]); };
  store(pair.p.x, pairs.p_x);
  store(pair.p.y, pairs.p_y);
  store(pair.contact, pairs.contact);
  store(pair.inflated, pairs.inflated);
  store(pair.error, pairs.error);
  store(pair.share, pairs.share);
  store(pair.b.profile.speed, pairs.speed);
  store(pair.b.profile.decrement, pairs.decrement);
  store(pair.b.profile.full_steps, pairs.full_steps);
  store(pair.b.direction.x, pairs.direction_x);
  store(pair.b.direction.y, pairs.direction_y);
  store(pair.b.length, pairs.length);
  store(pair.b.reach, pairs.reach);
  store(pair.b.intervals, pairs.intervals);
}

template <typename Real>
Present look_for(const Robot& robot, const Neighbors& neighbors, const FarBound& bound) {
  const Real zero(0.0);
  auto near = zero < zero, movers = near;
  for (std::size_t k = 0; k < neighbors.count; k += Real::kLanes) {
    const PackNeighbor<Real> of = load<Real>(neighbors, k);
    const auto here = counted<Real>(neighbors, k), decides = of.max_acceleration > zero;
    const Vec<Real> p = constant<Real>(robot.position) - of.position;
    near = near | (here & decides & !are_far(bound, p, of));
    movers = movers | (here & !decides);
  }
  return {any(near), any(movers)};
}

/// pairs.kept lists those that may meet A and can refuse a candidate; their columns are filled.
template <typename Real>
void judge_pairs(const Robot& robot, const Neighbors& neighbors, const FarBound& bound,
                 const Braking& a, const Deviation& deviation, const StepLaw& law,
                 NearColumns& pairs) {
  const bool exact = law.sensing_error == SensingError{};
  const Real zero(0.0), one(1.0);
  pairs.kept_count = 0;
  for (std::size_t k = 0; k < neighbors.count; k += Real::kLanes) {
    PackNeighbor<Real> of = load<Real>(neighbors, k);
    const auto decides = of.max_acceleration > zero;
    const Vec<Real> p = constant<Real>(robot.position) - of.position;
    auto kept = counted<Real>(neighbors, k) & decides & !are_far(bound, p, of);
    if (!any(kept)) continue;
    of.max_acceleration = select(decides, of.max_acceleration, one);  // a divisor
    const PackPair<Real> pair = pair_of<Real>(robot, a, of, law);
    kept = kept & !(pair.distance - (Real(a.reach) + pair.b.reach) > pair.inflated + pair.error);
    if (exact) kept = kept & !refuses_nothing(robot, a, deviation, pair, of, law);
    std::uint32_t lanes = bits(kept);
    if (lanes == 0) continue;
    store(pair, k, pairs);
    for (; lanes != 0; lanes &= lanes - 1) {
      pairs.kept[pairs.kept_count++] =
          static_cast<std::uint32_t>(k + static_cast<std::size_t>(std::countr_zero(lanes)));
    }
  }
}
