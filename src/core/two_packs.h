// SPDX-License-Identifier: Apache-2.0
// Two packs as one: while one waits for its divisions the other continues. Code with packs of
// several lanes includes it, once per pass.
#include <cstddef>
#include <cstdint>

#include "core/scalar.h"

AVO_BEGIN_KERNELS

struct TwoMasks {
  MaskOf<double> a, b;
  friend AVO_KERNEL TwoMasks operator&(TwoMasks x, TwoMasks y) { return {x.a & y.a, x.b & y.b}; }
  friend AVO_KERNEL TwoMasks operator|(TwoMasks x, TwoMasks y) { return {x.a | y.a, x.b | y.b}; }
  friend AVO_KERNEL TwoMasks operator!(TwoMasks x) { return {!x.a, !x.b}; }
  friend AVO_KERNEL bool any(TwoMasks x) { return any(x.a | x.b); }
  friend AVO_KERNEL std::uint32_t bits(TwoMasks x) {
    return bits(x.a) | bits(x.b) << Pack<double>::kLanes;
  }
};

struct TwoPacks {
  using Mask = TwoMasks;
  static constexpr std::size_t kLanes = 2 * Pack<double>::kLanes;
  Pack<double> a, b;

  TwoPacks() = default;
  AVO_KERNEL TwoPacks(double constant) : a(constant), b(constant) {}  // NOLINT: as literals are
  AVO_KERNEL TwoPacks(Pack<double> first, Pack<double> second) : a(first), b(second) {}

  static AVO_KERNEL TwoPacks load(const double* from) {
    return {Pack<double>::load(from), Pack<double>::load(from + Pack<double>::kLanes)};
  }
  AVO_KERNEL void store(double* to) const {
    a.store(to);
    b.store(to + Pack<double>::kLanes);
  }

  friend AVO_KERNEL TwoPacks operator+(TwoPacks x, TwoPacks y) { return {x.a + y.a, x.b + y.b}; }
  friend AVO_KERNEL TwoPacks operator-(TwoPacks x, TwoPacks y) { return {x.a - y.a, x.b - y.b}; }
  friend AVO_KERNEL TwoPacks operator*(TwoPacks x, TwoPacks y) { return {x.a * y.a, x.b * y.b}; }
  friend AVO_KERNEL TwoPacks operator/(TwoPacks x, TwoPacks y) { return {x.a / y.a, x.b / y.b}; }
  friend AVO_KERNEL TwoPacks operator-(TwoPacks x) { return {-x.a, -x.b}; }
  friend AVO_KERNEL Mask operator<(TwoPacks x, TwoPacks y) { return {x.a < y.a, x.b < y.b}; }
  friend AVO_KERNEL Mask operator<=(TwoPacks x, TwoPacks y) { return {x.a <= y.a, x.b <= y.b}; }
  friend AVO_KERNEL Mask operator>(TwoPacks x, TwoPacks y) { return {x.a > y.a, x.b > y.b}; }
  friend AVO_KERNEL Mask operator>=(TwoPacks x, TwoPacks y) { return {x.a >= y.a, x.b >= y.b}; }
  friend AVO_KERNEL TwoPacks sqrt(TwoPacks x) { return {sqrt(x.a), sqrt(x.b)}; }
  friend AVO_KERNEL TwoPacks abs(TwoPacks x) { return {abs(x.a), abs(x.b)}; }
  friend AVO_KERNEL TwoPacks floor(TwoPacks x) { return {floor(x.a), floor(x.b)}; }
  friend AVO_KERNEL TwoPacks select(Mask mask, TwoPacks yes, TwoPacks no) {
    return {select(mask.a, yes.a, no.a), select(mask.b, yes.b, no.b)};
  }
  friend AVO_KERNEL TwoPacks lookup(const double* table, TwoPacks x) {
    return {lookup(table, x.a), lookup(table, x.b)};
  }
};

AVO_KERNEL std::size_t store_chosen(TwoMasks chosen, TwoPacks x, double* to) {
  const std::size_t count = store_chosen(chosen.a, x.a, to);
  return count + store_chosen(chosen.b, x.b, to + count);
}

AVO_KERNEL TwoPacks min(TwoPacks x, TwoPacks y) {
  return {min(x.a, y.a), min(x.b, y.b)};
}
AVO_KERNEL TwoPacks max(TwoPacks x, TwoPacks y) {
  return {max(x.a, y.a), max(x.b, y.b)};
}

AVO_END_KERNELS
