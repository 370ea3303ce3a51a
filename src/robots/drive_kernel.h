// SPDX-License-Identifier: Apache-2.0
// The turns of differential drives within a step, as many at once as Pack has lanes.
#ifndef AVO_ROBOTS_DRIVE_KERNEL_H
#define AVO_ROBOTS_DRIVE_KERNEL_H

#include <cstddef>

#include "core/scalar.h"
#include "robots/drive_turns.h"

AVO_BEGIN_KERNELS

/// A step in the frame of its first heading, which is (1, 0).
template <typename Real>
struct Turning {
  Vec<Real> velocity, acceleration;  // of q, at the start
  Real length;                       // [h] s, of a substep
  Real substeps;

  AVO_KERNEL Vec<Real> velocity_at(Real substep) const {
    return velocity + (substep * length) * acceleration;
  }
};

/// h: the first heading, a unit vector.
template <typename Real>
AVO_KERNEL Turning<Real> turning_of(Real offset, Vec<Real> h, Vec<Real> velocity,
                                    Vec<Real> next_velocity, Real time) {
  const auto seen = [&](Vec<Real> a) { return Vec<Real>{dot(h, a), cross(h, a)}; };
  const Real turn = max(norm(velocity), norm(next_velocity)) * time / offset;
  const Real needed = min(turn / Real(kSubturn), Real(kMostSubsteps)), whole = floor(needed);
  const Real substeps =
      max(select(whole < needed, whole + Real(1.0), whole), Real(kFewestSubsteps));
  return {seen(velocity), seen(next_velocity - velocity) / time, time / substeps, substeps};
}

/// The heading is p²/|p|², where p has half its angle. From h' = ω n, with complex numbers h' = (V
/// - V* h²)/2L, it follows that p' = V p*/2L: linear, with V linear in time. So a power series
/// solves it exactly; the terms left out in a substep are below 1e-17.
template <typename Real>
struct HalfTurns {
  static constexpr int kTerms = 8;
  const Turning<Real>& turning;
  Vec<Real> gained;
  Real parts[kTerms];  // 1/(m/s), of the terms

  AVO_KERNEL HalfTurns(const Turning<Real>& of, Real offset)
      : turning(of), gained(of.length * of.acceleration) {
    const Real scale = Real(0.5) * of.length / offset;
    for (int n = 0; n < kTerms; ++n) parts[n] = scale / Real(n + 1.0);
  }

  /// p at the end of a substep, from p at its beginning.
  AVO_KERNEL Vec<Real> after(Real substep, Vec<Real> half) const {
    const auto by_conjugate = [](Vec<Real> a, Vec<Real> c) {
      return Vec<Real>{dot(a, c), cross(c, a)};
    };
    const Vec<Real> v = turning.velocity_at(substep);
    Vec<Real> sum = half, before = constant<Real>({}), term = half;
    for (const Real part : parts) {
      const Vec<Real> next = part * (by_conjugate(v, term) + by_conjugate(gained, before));
      sum = sum + next;
      before = term, term = next;
    }
    return sum / norm(sum);
  }
};

/// p at the end of the step.
template <typename Real>
AVO_KERNEL Vec<Real> half_turned(const Turning<Real>& turning, Real offset) {
  const HalfTurns<Real> turns(turning, offset);
  Vec<Real> half = constant<Real>({1.0, 0.0});
  Real substep(0.0);
  for (auto left = substep < turning.substeps; any(left); left = substep < turning.substeps) {
    half = select(left, turns.after(substep, half), half);
    substep = substep + Real(1.0);
  }
  return half;
}

template <typename Real>
void turn(DriveTurns& turns, double time) {
  for (std::size_t k = 0; k < turns.count; k += Real::kLanes) {
    const auto load = [k](const auto& column) { return Real::load(&column[k]); };
    const Real offset = load(turns.offset);
    const Turning<Real> turning = turning_of<Real>(
        offset, {load(turns.ahead_x), load(turns.ahead_y)}, {load(turns.v_x), load(turns.v_y)},
        {load(turns.next_x), load(turns.next_y)}, Real(time));
    const Vec<Real> half = half_turned(turning, offset);
    half.x.store(&turns.half_x[k]), half.y.store(&turns.half_y[k]);
  }
}

AVO_END_KERNELS

#endif  // once per pass
