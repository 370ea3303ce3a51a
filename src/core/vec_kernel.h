// SPDX-License-Identifier: Apache-2.0
// Vectors (the paper's p, v and w) of packs, in the plane or, with D = 3, in space. core/scalar.h
// and core/lanes.h include this header.
#ifndef AVO_CORE_VEC_KERNEL_H
#define AVO_CORE_VEC_KERNEL_H

#include <concepts>
#include <cstddef>
#include <cstdint>

#include "avo/vec3.h"
#include "core/scalar.h"

AVO_BEGIN_KERNELS

template <typename Real, int D = 2>
struct Vec;

template <typename Real>
struct Vec<Real, 2> {
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
  friend AVO_KERNEL Real across(Vec a, Vec b) { return abs(cross(a, b)); }
  friend AVO_KERNEL Real one_norm(Vec a) { return abs(a.x) + abs(a.y); }
};

template <typename Real>
struct Vec<Real, 3> {
  Real x, y, z;
  friend AVO_KERNEL Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend AVO_KERNEL Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend AVO_KERNEL Vec operator*(Real s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }
  friend AVO_KERNEL Vec operator/(Vec a, Real s) { return {a.x / s, a.y / s, a.z / s}; }
  friend AVO_KERNEL Real dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  friend AVO_KERNEL Vec cross(Vec a, Vec b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
  friend AVO_KERNEL Real norm(Vec a) { return sqrt(dot(a, a)); }
  friend AVO_KERNEL Vec select(decltype(Real() < Real()) mask, Vec yes, Vec no) {
    return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
  }
  /// |a × b|, as in the plane.
  friend AVO_KERNEL Real across(Vec a, Vec b) { return norm(cross(a, b)); }
  friend AVO_KERNEL Real one_norm(Vec a) { return (abs(a.x) + abs(a.y)) + abs(a.z); }
};

/// The vectors of a pack's lanes, from columns by axis.
template <typename Real, int D, typename Columns>
AVO_KERNEL Vec<Real, D> load_vector(const Columns& columns, std::size_t k) {
  if constexpr (D == 2)
    return {Real::load(&columns[0][k]), Real::load(&columns[1][k])};
  else
    return {Real::load(&columns[0][k]), Real::load(&columns[1][k]), Real::load(&columns[2][k])};
}
template <typename Real, int D, typename Columns>
AVO_KERNEL void store_vector(Vec<Real, D> a, Columns& columns, std::size_t k) {
  a.x.store(&columns[0][k]);
  a.y.store(&columns[1][k]);
  if constexpr (D == 3) a.z.store(&columns[2][k]);
}
template <typename Real, int D>
AVO_KERNEL Vec<Real, D> zero_vector() {
  const Real zero(0.0);
  if constexpr (D == 2)
    return {zero, zero};
  else
    return {zero, zero, zero};
}

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
/// A template, so that {} is a vector of the plane.
template <typename Real, std::same_as<Vec3> V>
AVO_KERNEL Vec<Real, 3> constant(V a) {
  return {Real(a.x), Real(a.y), Real(a.z)};
}

/// The vector of a pack of one.
template <typename Real>
AVO_KERNEL Vec2 plain(Vec<Real> a) {
  return {a.x.value, a.y.value};
}
template <typename Real>
AVO_KERNEL Vec3 plain(Vec<Real, 3> a) {
  return {a.x.value, a.y.value, a.z.value};
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
