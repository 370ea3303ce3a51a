// SPDX-License-Identifier: Apache-2.0
// Highway's vectors under the names of core/scalar.h. Included once per instruction set, after
// hwy/foreach_target.h; kernels are templates over Pack. All operations are exact. min and max
// return the second operand where the comparison fails, as those of x86 do.
#include <bit>
#include <cstddef>
#include <cstdint>
#include <hwy/highway.h>

#include "core/scalar.h"

// this allows every kernel header to be included once more
#include "core/kernel_guards.h"

#undef AVO_BEGIN_KERNELS
#undef AVO_END_KERNELS
#define AVO_BEGIN_KERNELS \
  HWY_BEFORE_NAMESPACE(); \
  namespace avo::HWY_NAMESPACE {
#define AVO_END_KERNELS \
  }                     \
  HWY_AFTER_NAMESPACE();

HWY_BEFORE_NAMESPACE();
namespace avo::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <typename T>
struct MaskOf {
  using D = hn::ScalableTag<T>;
  hn::Mask<D> raw;
  friend HWY_INLINE MaskOf operator&(MaskOf a, MaskOf b) { return {hn::And(a.raw, b.raw)}; }
  friend HWY_INLINE MaskOf operator|(MaskOf a, MaskOf b) { return {hn::Or(a.raw, b.raw)}; }
  friend HWY_INLINE MaskOf operator!(MaskOf a) { return {hn::Not(a.raw)}; }
  friend HWY_INLINE bool any(MaskOf mask) { return !hn::AllFalse(D(), mask.raw); }
  friend HWY_INLINE std::uint32_t bits(MaskOf mask) {
    alignas(8) std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(D(), mask.raw, bytes);
    return bytes[0] | (static_cast<std::uint32_t>(bytes[1]) << 8);
  }
};

template <typename T>
struct Pack {
  using Number = T;
  using D = hn::ScalableTag<T>;
  using Mask = MaskOf<T>;
  static constexpr std::size_t kLanes = HWY_MAX_BYTES / sizeof(T);
  hn::Vec<D> raw;

  Pack() = default;
  HWY_INLINE Pack(double constant) : raw(hn::Set(D(), static_cast<T>(constant))) {}  // NOLINT
  HWY_INLINE explicit Pack(hn::Vec<D> vector) : raw(vector) {}

  static HWY_INLINE Pack load(const T* from) { return Pack(hn::LoadU(D(), from)); }
  HWY_INLINE void store(T* to) const { hn::StoreU(raw, D(), to); }
  static HWY_INLINE Pack numbers_from(std::size_t first) {
    return Pack(static_cast<double>(first)) + Pack(hn::Iota(D(), T(0)));
  }

  friend HWY_INLINE Pack operator+(Pack a, Pack b) { return Pack(hn::Add(a.raw, b.raw)); }
  friend HWY_INLINE Pack operator-(Pack a, Pack b) { return Pack(hn::Sub(a.raw, b.raw)); }
  friend HWY_INLINE Pack operator*(Pack a, Pack b) { return Pack(hn::Mul(a.raw, b.raw)); }
  friend HWY_INLINE Pack operator/(Pack a, Pack b) { return Pack(hn::Div(a.raw, b.raw)); }
  friend HWY_INLINE Pack operator-(Pack a) { return Pack(hn::Neg(a.raw)); }
  friend HWY_INLINE Mask operator<(Pack a, Pack b) { return {hn::Lt(a.raw, b.raw)}; }
  friend HWY_INLINE Mask operator<=(Pack a, Pack b) { return {hn::Le(a.raw, b.raw)}; }
  friend HWY_INLINE Mask operator>(Pack a, Pack b) { return {hn::Gt(a.raw, b.raw)}; }
  friend HWY_INLINE Mask operator>=(Pack a, Pack b) { return {hn::Ge(a.raw, b.raw)}; }
  friend HWY_INLINE Mask operator!=(Pack a, Pack b) { return {hn::Ne(a.raw, b.raw)}; }
  friend HWY_INLINE Pack sqrt(Pack a) { return Pack(hn::Sqrt(a.raw)); }
  friend HWY_INLINE Pack abs(Pack a) { return Pack(hn::Abs(a.raw)); }
  friend HWY_INLINE Pack select(Mask mask, Pack yes, Pack no) {
    return Pack(hn::IfThenElse(mask.raw, yes.raw, no.raw));
  }
  friend HWY_INLINE Pack floor(Pack a) { return Pack(hn::Trunc(a.raw)); }
};

/// table[a] of an integer a, 0 <= a < 2^52: added to 2^52, it is in the last bits.
HWY_INLINE Pack<double> lookup(const double* table, Pack<double> a) {
  const hn::ScalableTag<double> lanes;
  const hn::RebindToSigned<hn::ScalableTag<double>> whole;
  const auto shift = hn::Set(lanes, 0x1p52);
  return Pack<double>(hn::GatherIndex(
      lanes, table, hn::Xor(hn::BitCast(whole, hn::Add(a.raw, shift)), hn::BitCast(whole, shift))));
}

/// The sum of all lanes, for numbers with an exact sum.
template <typename T>
HWY_INLINE T sum_of(Pack<T> a) {
  return hn::GetLane(hn::SumOfLanes(hn::ScalableTag<T>(), a.raw));
}

/// Stores the chosen lanes side by side and returns their number; may write all lanes. (Highway's
/// own function compresses into memory, which is slow on some processors, or uses tables that g++
/// copies first.)
HWY_INLINE std::size_t store_chosen(MaskOf<double> chosen, Pack<double> a, double* to) {
#if HWY_TARGET == HWY_AVX3
  _mm512_storeu_pd(to, _mm512_maskz_compress_pd(chosen.raw.raw, a.raw.raw));
  return hn::CountTrue(hn::ScalableTag<double>(), chosen.raw);
#else
  alignas(HWY_MAX_BYTES) double lanes[Pack<double>::kLanes] = {};
  a.store(lanes);
  const std::uint32_t chosen_bits = bits(chosen);
  std::size_t count = 0;
  for (std::size_t k = 0; k < Pack<double>::kLanes; ++k) {
    to[count] = lanes[k];
    count += (chosen_bits >> k) & 1U;
  }
  return count;
#endif
}

#if HWY_TARGET == HWY_AVX3
HWY_INLINE std::size_t store_chosen(std::uint32_t chosen, const Pack<double> (&values)[2],
                                    std::uint32_t first, float* to, std::uint32_t* number) {
  const auto lanes = static_cast<__mmask16>(chosen);
  const __m512 narrow = _mm512_castpd_ps(_mm512_insertf64x4(
      _mm512_castpd256_pd512(_mm256_castps_pd(_mm512_cvtpd_ps(values[0].raw.raw))),
      _mm256_castps_pd(_mm512_cvtpd_ps(values[1].raw.raw)), 1));
  const __m512i numbers =
      _mm512_add_epi32(_mm512_set1_epi32(static_cast<int>(first)),
                       _mm512_set_epi32(15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0));
  _mm512_storeu_ps(to, _mm512_maskz_compress_ps(lanes, narrow));
  _mm512_storeu_si512(number, _mm512_maskz_compress_epi32(lanes, numbers));
  return static_cast<std::size_t>(std::popcount(chosen));
}
#endif

// Both functions return the second operand where the comparison fails, as on x86.
HWY_INLINE Pack<double> min(Pack<double> a, Pack<double> b) {
  return HWY_ARCH_X86 ? Pack<double>(hn::Min(a.raw, b.raw)) : select(a < b, a, b);
}
HWY_INLINE Pack<double> max(Pack<double> a, Pack<double> b) {
  return HWY_ARCH_X86 ? Pack<double>(hn::Max(a.raw, b.raw)) : select(a > b, a, b);
}

}  // namespace avo::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#include "core/two_packs.h"
#include "core/vec_kernel.h"
