// SPDX-License-Identifier: Apache-2.0
// B's path, for as many intervals at once as Pack has lanes: where B brakes, or moves on as it may.
// `at` has the points of the intervals k, k + 1, ...; their numbers are also in the lanes of m.
#ifndef AVO_CERTIFICATE_OTHER_KERNEL_H
#define AVO_CERTIFICATE_OTHER_KERNEL_H

#include <cstddef>
#include <limits>

#include "certificate/braking_kernel.h"
#include "certificate/pair_constraints.h"
#include "certificate/shape_kernel.h"

AVO_BEGIN_KERNELS

/// B's path from p_B, where it brakes like A.
template <typename Real, int D = 2>
struct BrakingOther {
  const BrakingPairOf<D>& pair;
  const StepLaw& law;

  AVO_KERNEL PackPoints<Real, D> at(std::size_t, Real m) const {
    return points(pair.b.profile, pair.b.direction, law, m);
  }
};

/// B's path from p_B, where it holds its velocity for one step and then brakes like A.
template <typename Real>
struct HoldingOther {
  const BrakingPair& pair;
  const StepLaw& law;

  AVO_KERNEL PackPoints<Real> at(std::size_t, Real m) const {
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

  AVO_KERNEL PackPoints<Real, D> at(std::size_t, Real m) const {
    const Real h(law.time_step), lag(law.lag), half(0.5), t = m * h;
    const Vec<Real, D> a = constant<Real>(body.acceleration);
    const Vec<Real, D> v_0 = constant<Real>(body.velocity), v = v_0 + t * a;
    const Vec<Real, D> x = t * v_0 + (half * t * t) * a;
    return {x, x + lag * v, x + h * v + (half * h * h) * a};
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

/// B's path from p_B, where its acceleration may differ from the sensed one.
template <typename Real, int D = 2, typename Body = Neighbor>
struct DeviatingOther : MovingOther<Real, D, Body> {
  AVO_KERNEL PackReach<Real, D> reach(std::size_t, const PackPoints<Real, D>& q,
                                      const PackPoints<Real, D>& from_start, Real time) const {
    return reach_of(this->body, q, from_start, time);
  }
};

/// B's path from p_B, where its trajectory is known.
template <typename Real>
struct FollowingOther {
  const Neighbor& body;
  const TrajectorySteps& steps;
  double lag;  // fraction of a step

  AVO_KERNEL PackPoints<Real> at(std::size_t k, Real) const {
    const Vec<Real> start{Real::load(&steps.x[k]), Real::load(&steps.y[k])};
    const Vec<Real> end{Real::load(&steps.x[k + 1]), Real::load(&steps.y[k + 1])};
    return {start, start + Real(lag) * (end - start), end};
  }
  AVO_KERNEL PackReach<Real, 2> reach(std::size_t k, const PackPoints<Real>& q,
                                      const PackPoints<Real>& from_start, Real time) const {
    PackReach<Real, 2> result = reach_of(body, q, from_start, time);
    result.radius = result.radius + Real::load(&steps.bend[k]) + Real(steps.trajectory().error());
    return result;
  }
};

/// Whether B may be anywhere within a radius of its path, which grows with the time.
template <typename Other>
inline constexpr bool kDeviates = requires {
  &Other::reach;
};

AVO_END_KERNELS

#endif  // once per pass
