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
AVO_KERNEL PackPair<Real> pair_of(const Robot& robot, const Braking& a, Vec<Real> position,
                                  Vec<Real> velocity, Real radius, Real max_acceleration,
                                  const StepLaw& law) {
  const Real a_A(robot.max_acceleration), one(1.0);
  PackPair<Real> pair;
  pair.b = braking_of(velocity, max_acceleration, law);
  pair.p = constant<Real>(robot.position) - position;
  pair.distance = norm(pair.p);
  pair.contact = Real(robot.radius) + radius;
  pair.share = a_A / (a_A + max_acceleration);
  const Real lengths =
      pair.contact + Real(a.reach) + pair.b.reach + Real(norm(robot.position)) + norm(position);
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
                                const PackPair<Real>& pair, Vec<Real> velocity,
                                Real max_acceleration, const StepLaw& law) {
  const Real zero(0.0), one(1.0), d = pair.distance, length_A(a.length);
  const Vec<Real> d_A = constant<Real>(a.direction), d_B = pair.b.direction;
  const auto apart = d > zero;
  // along p, whenever each of them stops
  const Real towards =
      min(zero, length_A * dot(pair.p, d_A)) - max(zero, pair.b.length * dot(pair.p, d_B));
  const Real alone = d + towards / select(apart, d, one);
  // equally able ones brake with less relative velocity than they have
  const Real steps = one + max(Real(a.profile.full_steps), pair.b.profile.full_steps);
  const Real drift = Real(law.time_step) * steps * norm(constant<Real>(robot.velocity) - velocity);
  const Real a_A(robot.max_acceleration);
  const auto able_alike = (max_acceleration <= a_A) & (max_acceleration >= a_A);
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

/// near.kept lists those that may meet A and can refuse a candidate; their columns are filled.
template <typename Real>
void judge_pairs(const Robot& robot, const Braking& a, const Deviation& deviation,
                 const StepLaw& law, NearColumns& near) {
  const bool exact = law.sensing_error == SensingError{};
  near.kept_count = 0;
  for (std::size_t k = 0; k < near.count; k += Real::kLanes) {
    const auto load = [k](const std::vector<double>& column) { return Real::load(&column[k]); };
    const Vec<Real> velocity{load(near.v_x), load(near.v_y)};
    const Real max_acceleration = load(near.max_acceleration);
    const PackPair<Real> pair = pair_of<Real>(robot, a, {load(near.x), load(near.y)}, velocity,
                                              load(near.radius), max_acceleration, law);
    const auto too_far =
        pair.distance - (Real(a.reach) + pair.b.reach) > pair.inflated + pair.error;
    const auto counted = lane_numbers<Real>() < Real(static_cast<double>(near.count - k));
    auto kept = counted & !too_far;
    if (exact) {
      kept = kept & !refuses_nothing(robot, a, deviation, pair, velocity, max_acceleration, law);
    }
    std::uint32_t lanes = bits(kept);
    if (lanes == 0) continue;
    const auto store = [k](Real value, std::vector<double>& column) { value.store(&column[k]); };
    store(pair.contact, near.contact);
    store(pair.inflated, near.inflated);
    store(pair.error, near.error);
    store(pair.share, near.share);
    store(pair.b.profile.speed, near.speed);
    store(pair.b.profile.decrement, near.decrement);
    store(pair.b.profile.full_steps, near.full_steps);
    store(pair.b.direction.x, near.direction_x);
    store(pair.b.direction.y, near.direction_y);
    store(pair.b.length, near.length);
    store(pair.b.reach, near.reach);
    store(pair.b.intervals, near.intervals);
    for (; lanes != 0; lanes &= lanes - 1) {
      near.kept[near.kept_count++] =
          static_cast<std::uint32_t>(k + static_cast<std::size_t>(std::countr_zero(lanes)));
    }
  }
}
