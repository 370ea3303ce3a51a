// SPDX-License-Identifier: Apache-2.0
// Straight full braking in steps, in closed form, for as many intervals at once as Pack has lanes.
// Included into a namespace that has Pack, once per instruction set.

/// Every lane the same.
template <typename Real>
AVO_KERNEL PackVec<Real> constant(Vec2 a) {
  return {Real(a.x), Real(a.y)};
}

/// Distances where an interval begins and at its middle Bézier point, m; it ends where the next one
/// begins.
template <typename Real>
struct PackDistances {
  Real start, middle;
};

/// Of the interval after `steps` >= 0 steps of braking. With c steps done, of which all were full,
/// and the speed T left: c [Δt (u (c - 1)/2 + T) + s u]. No term is negative, nothing cancels.
template <typename Real>
AVO_KERNEL PackDistances<Real> distances(const BrakingProfile& braking, const StepLaw& law,
                                         Real steps) {
  const Real u(braking.decrement), lag(law.lag), full(braking.full_steps);
  const Real done = min(steps, full);
  const Real left = max(Real(braking.speed) - done * u, Real(0.0));
  const Real mean = Real(0.5) * (done - Real(1.0)) * u + left;
  const Real start = done * (Real(law.time_step) * mean + lag * u);
  const Real middle = start + lag * left;
  return {select(steps > full, middle, start), middle};
}

/// The three Bézier points of an interval.
template <typename Real>
struct PackPoints {
  PackVec<Real> start, middle, end;
};

template <typename Real>
AVO_KERNEL PackPoints<Real> points(const BrakingProfile& braking, Vec2 direction,
                                   const StepLaw& law, Real steps) {
  const PackDistances<Real> now = distances(braking, law, steps);
  const PackDistances<Real> next = distances(braking, law, steps + Real(1.0));
  const PackVec<Real> along = constant<Real>(direction);
  return {now.start * along, now.middle * along, next.start * along};
}
