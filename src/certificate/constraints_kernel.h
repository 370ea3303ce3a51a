// SPDX-License-Identifier: Apache-2.0
// The constraints of one pair, for as many intervals at once as Pack has lanes:
// docs/certificate.md, "Braking trajectories", and docs/certificate/left_out.md.
#ifndef AVO_CERTIFICATE_CONSTRAINTS_KERNEL_H
#define AVO_CERTIFICATE_CONSTRAINTS_KERNEL_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

#include "certificate/braking_kernel.h"
#include "certificate/constraint_columns.h"
#include "certificate/pair_constraints.h"
#include "certificate/pair_kernel.h"
#include "certificate/shape_kernel.h"

AVO_BEGIN_KERNELS

/// A's braking path and the largest deviation of its candidates from it.
template <typename Real, int D>
void fill_own(const BrakingOf<D>& a, const Deviation& deviation, const StepLaw& law,
              OwnColumnsOf<D>& own) {
  for (; own.filled <= own.count; own.filled += Real::kLanes) {
    const std::size_t k = own.filled;
    const Real m = Real::numbers_from(k);
    const PackDistances<Real> braking = distances(constant<Real>(a.profile), law, m);
    const Vec<Real, D> along = constant<Real>(a.direction);
    const Vec<Real, D> start = braking.start * along, middle = braking.middle * along;
    store_vector(start, own.start, k);
    store_vector(middle, own.middle, k);
    const Real fast = distances(constant<Real>(deviation.fast), law, m).start;
    const Real gained = fast - distances(constant<Real>(deviation.slow), law, m).start;
    const auto bound = [](const Deviation::Line& line, Real distance) {
      return Real(line.start) + Real(line.per_distance) * distance;
    };
    const Real ahead = bound(deviation.ahead, gained), across = bound(deviation.across, fast);
    const Real anyhow = bound(deviation.anyhow, fast);
    ahead.store(&own.ahead[k]);
    across.store(&own.across[k]);
    anyhow.store(&own.anyhow[k]);
    (ahead + across + anyhow).store(&own.most[k]);
  }
}

/// B's path from p_B, where it brakes like A.
template <typename Real, int D = 2>
struct BrakingOther {
  const BrakingPairOf<D>& pair;
  const StepLaw& law;

  AVO_KERNEL PackPoints<Real, D> operator()(Real m) const {
    return points(pair.b.profile, pair.b.direction, law, m);
  }
};

/// B's path from p_B, where it holds its velocity for one step and then brakes like A.
template <typename Real>
struct HoldingOther {
  const BrakingPair& pair;
  const StepLaw& law;

  AVO_KERNEL PackPoints<Real> operator()(Real m) const {
    const Real zero(0.0), one(1.0);
    const Vec<Real> v = Real(pair.b.profile.speed) * constant<Real>(pair.b.direction);
    const Vec<Real> end = Real(law.time_step) * v, middle = Real(law.lag) * v;
    PackPoints<Real> x = points(pair.b.profile, pair.b.direction, law, max(m - one, zero));
    const auto holds = m < one;
    const auto pick = [&](Vec<Real> held, Vec<Real> braked) {
      return Vec<Real>{select(holds, held.x, end.x + braked.x),
                       select(holds, held.y, end.y + braked.y)};
    };
    return {pick({zero, zero}, x.start), pick(middle, x.middle), pick(end, x.end)};
  }
};

/// B's path from p_B, where it keeps its sensed acceleration. In space B is a space::Mover.
template <typename Real, int D = 2, typename Body = Neighbor>
struct MovingOther {
  const Body& body;
  const StepLaw& law;

  AVO_KERNEL PackPoints<Real, D> operator()(Real m) const {
    const Real h(law.time_step), lag(law.lag), half(0.5), t = m * h;
    const Vec<Real, D> a = constant<Real>(body.acceleration);
    const Vec<Real, D> v_0 = constant<Real>(body.velocity), v = v_0 + t * a;
    const Vec<Real, D> x = t * v_0 + (half * t * t) * a;
    return {x, x + lag * v, x + h * v + (half * h * h) * a};
  }
};

/// B's path from p_B, where its acceleration may differ from the sensed one.
template <typename Real, int D = 2, typename Body = Neighbor>
struct DeviatingOther : MovingOther<Real, D, Body> {};

/// B's path from p_B, where its trajectory is known.
template <typename Real>
struct FollowingOther {
  const TrajectorySteps& steps;
  double lag;  // fraction of a step

  /// The points of as many intervals as Pack has lanes, from k on.
  AVO_KERNEL PackPoints<Real> at(std::size_t k) const {
    const Vec<Real> start{Real::load(&steps.x[k]), Real::load(&steps.y[k])};
    const Vec<Real> end{Real::load(&steps.x[k + 1]), Real::load(&steps.y[k + 1])};
    return {start, start + Real(lag) * (end - start), end};
  }
};

/// q_i - radius keeps A clear of all places of B in the interval.
template <typename Real, int D>
struct PackReach {
  PackPoints<Real, D> q;
  Real radius;  // m
};

/// B is in each of two discs by the end of the interval; this is the disc that is farther from A.
/// One is about the place with constant acceleration, with the radius of the possible deviation.
/// The other is about the present place, with the radius of the distance at its speed. Each
/// contains the disc of the next decision, so that A may always brake (docs/certificate/movers.md,
/// "Movers that do as they like").
template <typename Real, int D, typename Body>
AVO_KERNEL PackReach<Real, D> reach_of(const Body& mover, const PackPoints<Real, D>& q,
                                       const PackPoints<Real, D>& from_start, Real time) {
  const auto left = [](const PackPoints<Real, D>& points, Real radius) {
    const Vec<Real, D> n = normal_of(points, PairShape<D>{});
    return min(min(dot(n, points.start), dot(n, points.middle)), dot(n, points.end)) - radius;
  };
  const Real by_deviation = Real(0.5 * mover.max_deviation) * time * time;
  const bool has_speed = mover.max_deviation > 0.0;  // false: the mover is on its trajectory
  const Real by_speed =
      Real(has_speed ? mover.max_speed : std::numeric_limits<double>::infinity()) * time;
  const auto slow = left(from_start, by_speed) > left(q, by_deviation);
  const auto pick = [&slow](Vec<Real, D> a, Vec<Real, D> b) { return select(slow, a, b); };
  return {{pick(from_start.start, q.start), pick(from_start.middle, q.middle),
           pick(from_start.end, q.end)},
          select(slow, by_speed, by_deviation)};
}

/// The demands of the sensing errors of one interval (docs/certificate/errors.md, "Sensing
/// errors").
template <typename Real>
struct PackMargin {
  Real distance;  // m, beyond the inflated contact
  Real cone;      // the largest difference of the normal from that of the true paths
};

/// distance: of the constraint; moved: how far B moves relative to A on the interval, m.
template <typename Real, int D>
AVO_RARE_KERNEL PackMargin<Real> error_margin(const BrakingPairOf<D>& pair,
                                              const PairShape<D>& shape, const StepLaw& law, Real m,
                                              Real distance, Real moved) {
  const auto& [position, velocity] = law.sensing_error;
  const Real seen = m + Real(1.0), two(2.0);
  const Real error = pair.decides ? braking_error(constant<Real>(pair.b.profile), law, seen)
                                  : Real(position) + Real(velocity) * (Real(law.time_step) * seen);
  const Real one_step(velocity * law.time_step);
  const auto beyond = distance > error;
  // if not, any value beyond it, which is not used
  const Real d = select(beyond, distance, two * error);
  const Real by_angle = two * sqrt(error / (d + error));
  const Real by_length = (with_shape(moved, shape) + error) / sqrt(d * (d - error));
  const Real cone = select(beyond, min(by_angle, by_length), two);
  return {error + cone * (moved + one_step), cone};
}

/// The margin where clocks are free. At a distance within the margin B may come as near as contact:
/// the cone alone then limits A.
template <typename Real, int D>
AVO_KERNEL PackMargin<Real> drift_margin(const BrakingPairOf<D>& pair, const StepLaw& law, Real m,
                                         Real distance, Real moved) {
  const auto& [position, velocity] = law.sensing_error;
  const BrakingProfile& b = pair.b.profile;
  const PackDrift<Real> drift =
      drift_of(Real(b.speed), Real(pair.b.increment), Real(b.decrement), law);
  const Real time = Real(law.time_step) * (m + Real(1.0));
  const Real error =
      Real(position) + Real(velocity) * time + min(drift.start + drift.per_time * time, drift.most);
  const Real zero(0.0), two(2.0);
  const auto is_clear = distance >= Real(pair.inflated) + error;
  const auto is_known = distance > zero;
  const Real turned =
      (moved + error) / sqrt(Real(pair.contact) * select(is_known, distance, Real(1.0)));
  const Real cone = select(is_known, min(turned, two), two);
  return {error, select(is_clear, zero, cone)};
}

/// Whether the other body may be anywhere within a radius that grows with the time.
template <typename Other>
inline constexpr bool kDeviating = false;
template <typename Real, int D, typename Body>
inline constexpr bool kDeviating<DeviatingOther<Real, D, Body>> = true;
template <typename Real>
inline constexpr bool kDeviating<FollowingOther<Real>> = true;

/// The constraints of a pair.
template <typename Real, int D>
struct PackConstraints {
  Vec<Real, D> normal;
  Real cone, bound;
  std::array<Real, 3> offset;
};

template <bool is_free, typename Real, int D>
AVO_KERNEL PackConstraints<Real, D> constraints_of(const PairConstraintsOf<D>& wanted,
                                                   const PackPoints<Real, D>& own,
                                                   const PackPoints<Real, D>& q, Vec<Real, D> n,
                                                   Real distance, const PackMargin<Real>& margin) {
  const Real share(wanted.pair.share), held(wanted.pair.share * wanted.held);
  const auto offset = [&](Vec<Real, D> of_q, Vec<Real, D> of_x) {
    if constexpr (is_free) {  // a cone does not use the gap
      const Real gap = dot(n, of_q) - margin.distance - held;
      const Real rounding(wanted.pair.contact - wanted.pair.inflated);
      return select(margin.cone > Real(0.0), rounding, gap) - dot(n, of_x);
    } else {
      return share * (dot(n, of_q) - margin.distance) - dot(n, of_x);  // see hold()
    }
  };
  const Real loss = share * (margin.distance - distance);
  return {n,
          margin.cone,
          is_free ? loss + held : loss,
          {offset(q.start, own.start), offset(q.middle, own.middle), offset(q.end, own.end)}};
}

/// Stores the constraints of all lanes. Lanes that are not kept are marked as no constraints, so
/// that no gap has to be closed.
template <typename Real, int D, typename Mask>
AVO_KERNEL void push(const PackConstraints<Real, D>& fresh, Real m, Mask kept,
                     const PairConstraintsOf<D>& wanted, ConstraintColumnsOf<D>& constraints) {
  const std::size_t w = constraints.count;
  store_vector(fresh.normal, constraints.normal, w);
  fresh.cone.store(&constraints.cone[w]);
  fresh.bound.store(&constraints.bound[w]);
  for (std::size_t i = 0; i < 3; ++i) fresh.offset[i].store(&constraints.offset[i][w]);
  m.store(&constraints.interval[w]);
  const Real needs = select(m < Real(wanted.moving), Real(-1.0), m);
  select(kept, needs, Real(kNoConstraint)).store(&constraints.needs[w]);
  for (std::size_t k = 0; k < Real::kLanes; ++k) constraints.neighbor[w + k] = wanted.neighbor;
  constraints.count += Real::kLanes;
}

/// Appends the constraints that can refuse a candidate. Returns the least distance of the intervals
/// that are computed in full; in the others it is beyond contact.
template <typename Real, bool is_free, int D, typename Other>
double append(const PairConstraintsOf<D>& wanted, const Other& other, const StepLaw& law,
              const OwnColumnsOf<D>& own, ConstraintColumnsOf<D>& constraints) {
  const BrakingPairOf<D>& pair = wanted.pair;
  const Real infinity(std::numeric_limits<double>::infinity()), zero(0.0), one(1.0);
  const Real share(pair.share), contact(pair.contact);
  constexpr bool kFollows = std::is_same_v<Other, FollowingOther<Real>>;
  constexpr bool kDeviates = kDeviating<Other>;
  constexpr bool kSpreads = kDeviates || D == 3;
  const PairShape<D>& shape = wanted.shape;
  const Vec<Real, D> p = constant<Real>(pair.p),
                     d = constant<Real>(own_direction(pair.a.direction, shape));
  const bool is_exact = law.sensing_error == SensingError{} && !is_free;
  const auto margin_at = [&](Real m, Real distance, Real moved) {
    if constexpr (is_free)
      return drift_margin(pair, law, m, distance, moved);
    else
      return is_exact ? PackMargin<Real>{zero, zero}
                      : error_margin(pair, shape, law, m, distance, moved);
  };
  Real nearest = infinity;
  for (std::size_t k = 0; k < wanted.intervals; k += Real::kLanes) {
    const Real m = Real::numbers_from(k);
    const PackPoints<Real, D> x_A{load_vector<Real, D>(own.start, k),
                                  load_vector<Real, D>(own.middle, k),
                                  load_vector<Real, D>(own.start, k + 1)};
    const PackPoints<Real, D> x_B = [&] {
      if constexpr (kFollows)
        return other.at(k);
      else
        return other(m);
    }();
    PackPoints<Real, D> q{p + (x_A.start - x_B.start), p + (x_A.middle - x_B.middle),
                          p + (x_A.end - x_B.end)};
    const Real most = longest(Real::load(&own.most[k]), shape);
    Real spread = zero, inflated(wanted.inflated);
    if constexpr (kDeviates) {
      const PackPoints<Real, D> from_start{p + x_A.start, p + x_A.middle, p + x_A.end};
      const Real time = (m + one) * Real(law.time_step);
      const PackReach<Real, D> reach = [&] {
        if constexpr (kFollows)
          return reach_of(wanted.other, q, from_start, time);
        else
          return reach_of(other.body, q, from_start, time);
      }();
      q = reach.q, spread = reach.radius;
      if constexpr (kFollows)
        spread = spread + Real::load(&other.steps.bend[k]) + Real(other.steps.trajectory().error());
      inflated = inflated + spread;
    }
    // intervals that are computed in full, each by itself, so that the number of lanes has no
    // influence
    auto close = m < Real(static_cast<double>(wanted.intervals));
    {
      const Real before = one_norm(q.middle - q.start), after = one_norm(q.end - q.middle);
      PackMargin<Real> margin = margin_at(m, contact, before + after);
      if (is_free) margin.cone = zero;  // a neighbor out of reach needs no cone
      const Real around = max(before, after), length = distance_to(q.middle, shape);
      const Real gap = share * (length - (inflated + around + margin.distance));
      const Real left = gap - margin.cone * most;
      close = close & !(left > most);
      if (!any(close)) continue;
      if (!has_wash(shape)) {
        // n points to a point so near q_1 that n is turned by less than around/w
        const Real w = length - Real(0.5) * around, turned = longest(around, shape);
        const Real E = Real::load(&own.ahead[k]), F = Real::load(&own.across[k]);
        const Real anyhow = longest(Real::load(&own.anyhow[k]), shape);
        const Vec<Real, D> own_q = in_own_space(q.middle, shape);
        const Real loss = max(-dot(own_q, d), zero) * E + across(own_q, d) * F;
        close = close & !((left > zero) & ((left - anyhow) * w > loss + turned * (E + F)));
        if (!any(close)) continue;
      }
    }
    const Vec<Real, D> n = normal_of(q, shape);
    const Real distance = min(min(dot(n, q.start), dot(n, q.middle)), dot(n, q.end));
    Real apart = distance;  // from the shape
    if constexpr (D == 3) {
      const Real wash = support(n, shape);
      spread = spread + wash;
      inflated = inflated + wash;
      apart = distance - wash;
    }
    const auto holds = m < Real(wanted.moving);  // the invariant covers the interval
    const Real left = kSpreads ? distance - spread : distance;
    nearest = select(close & holds & (left < nearest), left, nearest);
    const Real moved =
        is_exact ? zero : norm(q.middle - q.start) + norm(q.end - q.middle);  // only errors need it
    PackMargin<Real> margin = margin_at(m, apart, moved);
    const Vec<Real, D> own_n = in_own_space(n, shape);
    const Real loss = max(-dot(own_n, d), zero) * Real::load(&own.ahead[k]) +
                      across(own_n, d) * Real::load(&own.across[k]) +
                      times_length(Real::load(&own.anyhow[k]), own_n, shape) + margin.cone * most;
    const auto kept = close & !(share * (distance - inflated - margin.distance) > loss);
    // the invariant does not cover intervals in which A rests: the margin is 0 there
    margin = {select(holds, margin.distance, zero), select(holds, margin.cone, zero)};
    if constexpr (kSpreads) margin.distance = margin.distance + spread;
    if (any(kept))
      push(constraints_of<is_free>(wanted, x_A, q, n, distance, margin), m, kept, wanted,
           constraints);
  }
  alignas(64) std::array<double, Real::kLanes> lanes;
  nearest.store(lanes.data());
  return *std::min_element(lanes.begin(), lanes.end());
}

/// Subtracts the held distance from the pair's constraints, the last ones from `first` on.
/// Constraints of free clocks already contain it.
template <typename Real, int D>
void hold(const PairConstraintsOf<D>& wanted, std::size_t first,
          ConstraintColumnsOf<D>& constraints) {
  const Real held(wanted.pair.share * wanted.held);
  for (std::size_t k = first; k < constraints.count; k += Real::kLanes) {
    (Real::load(&constraints.bound[k]) + held).store(&constraints.bound[k]);
    for (std::size_t i = 0; i < 3; ++i) {
      double* offset = &constraints.offset[i][k];
      (Real::load(offset) - held).store(offset);
    }
  }
}

template <typename Real>
double append_constraints(const PairConstraints& wanted, const StepLaw& law, const OwnColumns& own,
                          ConstraintColumns& constraints) {
  if (wanted.trajectory != nullptr)
    return append<Real, false>(wanted,
                               FollowingOther<Real>{*wanted.trajectory, law.lag / law.time_step},
                               law, own, constraints);
  const MovingOther<Real> mover{wanted.other, law};
  if (!wanted.pair.decides && wanted.other.max_deviation > 0.0)
    return append<Real, false>(wanted, DeviatingOther<Real>{mover}, law, own, constraints);
  if (!wanted.pair.decides) return append<Real, false>(wanted, mover, law, own, constraints);
  if (wanted.is_free)
    return append<Real, true>(wanted, HoldingOther<Real>{wanted.pair, law}, law, own, constraints);
  return append<Real, false>(wanted, BrakingOther<Real>{wanted.pair, law}, law, own, constraints);
}

/// The same in space, of a neighbor that decides at the same times.
template <typename Real>
double append_in_space(const PairConstraintsOf<3>& wanted, const StepLaw& law,
                       const OwnColumnsOf<3>& own, ConstraintColumnsOf<3>& constraints) {
  return append<Real, false>(wanted, BrakingOther<Real, 3>{wanted.pair, law}, law, own,
                             constraints);
}

AVO_END_KERNELS

#endif  // once per pass
