// SPDX-License-Identifier: Apache-2.0
// Plane vectors (the paper's p, v and w) of packs, which core/scalar.h and core/lanes.h include.
#ifndef AVO_CORE_VEC_KERNEL_H
#define AVO_CORE_VEC_KERNEL_H

#include <cstddef>
#include <cstdint>

#include "core/scalar.h"

AVO_BEGIN_KERNELS

template <typename Real>
struct Vec {
  Real x, y;
  friend AVO_KERNEL Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y}; }
  friend AVO_KERNEL Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y}; }
  friend AVO_KERNEL Vec operator*(Real s, Vec a) { return {s * a.x, s * a.y}; }
  friend AVO_KERNEL Vec operator/(Vec a, Real s) { return {a.x / s, a.y / s}; }
  friend AVO_KERNEL Real dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y; }
  friend AVO_KERNEL Real cross(Vec a, Vec b) { return a.x * b.y - a.y * b.x; }
  friend AVO_KERNEL Real norm(Vec a) { return sqrt(dot(a, a)); }
  friend AVO_KERNEL Vec perpendicular(Vec a) { return {-a.y, a.x}; }
  friend AVO_KERNEL Vec select(decltype(Real() < Real()) mask, Vec yes, Vec no) {
    return {select(mask, yes.x, no.x), select(mask, yes.y, no.y)};
  }
};

/// 0, 1, 2, ... in packs of double.
template <typename Real>
AVO_KERNEL Real lane_numbers() {
  return Real::load(kLaneNumbers.data());
}

/// Every lane the same.
template <typename Real>
AVO_KERNEL Vec<Real> constant(Vec2 a) {
  return {Real(a.x), Real(a.y)};
}

/// The vector of a pack of one.
template <typename Real>
AVO_KERNEL Vec2 plain(Vec<Real> a) {
  return {a.x.value, a.y.value};
}

/// Stores those of `values` with set bits, narrowed, side by side, and beside them their numbers;
/// the first number is `first`. Returns how many there are. May write all.
template <typename Real, std::size_t N>
AVO_KERNEL std::size_t store_chosen(std::uint32_t chosen, const Real (&values)[N],
                                    std::uint32_t first, float* to, std::uint32_t* number) {
  alignas(64) double lanes[N * Real::kLanes];
  for (std::size_t k = 0; k < N; ++k) values[k].store(lanes + k * Real::kLanes);
  std::size_t count = 0;
  for (std::uint32_t k = 0; k < N * Real::kLanes; ++k) {
    to[count] = static_cast<float>(lanes[k]);
    number[count] = first + k;
    count += chosen >> k & 1U;
  }
  return count;
}

AVO_END_KERNELS

#endif  // once per pass
