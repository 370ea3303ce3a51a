// SPDX-License-Identifier: Apache-2.0
// What single precision costs (docs/single_precision.md): pairs are planned with a radius larger by
// more than rounding moves their paths, and so near contact that this matters, in double precision.
// Nothing of it is done where Number is double.
// Included before half_plane_kernel.h, once per instruction set.

template <typename Real>
struct Local;

template <typename Real>
constexpr bool kSingle = std::is_same_v<typename Real::Number, float>;

/// By how much rounding moves x(t), at most, until τ, m.
template <typename Real>
AVO_KERNEL Real blur(const Local<Real>& pair, Real tau) {
  return Real(kBlur) * (pair.d + tau * (abs(pair.v.x) + abs(pair.v.y)));
}

template <typename Real>
AVO_KERNEL Local<Real> widened(Local<Real> pair, Real tau) {
  if constexpr (kSingle<Real>) pair.r = pair.r + blur(pair, tau);
  return pair;
}

/// Of a widened pair: the radius whose demand is the offset. Where n . y = r is met to rounding
/// only, that rounding is a demand of its own.
template <typename Real>
AVO_KERNEL Real demanding_radius(const Local<Real>& pair, Real tau) {
  return widened(pair, tau).r;
}

/// Of a widened pair: so near contact that the blur is a part of the gap that matters, with a reach
/// whose own rounding is a part of the velocities that matter, or very small.
template <typename Real>
AVO_KERNEL auto in_doubt(const Local<Real>& pair, const ResponseAt& end) {
  if constexpr (kSingle<Real>) {
    const Real moved = blur(pair, Real(end.time));
    return (pair.d - pair.r < Real(kLeastGap) * moved) |
           (pair.R * Real(end.gain) > Real(kMostReach) * moved) | (pair.d < Real(kLeastDistance));
  }
  return pair.d < Real(0.0);
}
