// SPDX-License-Identifier: Apache-2.0
// Highway's vectors under the names of core/scalar.h. Included once per instruction set, after
// hwy/foreach_target.h; kernels are templates over Pack. Nothing here is approximate, and nothing
// depends on how an instruction set treats equal zeros or NaN.
#if defined(AVO_CORE_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef AVO_CORE_LANES_H
#undef AVO_CORE_LANES_H
#else
#define AVO_CORE_LANES_H
#endif

#include <cstddef>
#include <cstdint>
#include <hwy/highway.h>

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

  friend HWY_INLINE Pack operator+(Pack a, Pack b) { return Pack(hn::Add(a.raw, b.raw)); }
  friend HWY_INLINE Pack operator-(Pack a, Pack b) { return Pack(hn::Sub(a.raw, b.raw)); }
  friend HWY_INLINE Pack operator*(Pack a, Pack b) { return Pack(hn::Mul(a.raw, b.raw)); }
  friend HWY_INLINE Pack operator/(Pack a, Pack b) { return Pack(hn::Div(a.raw, b.raw)); }
  friend HWY_INLINE Pack operator-(Pack a) { return Pack(hn::Neg(a.raw)); }
  friend HWY_INLINE Mask operator<(Pack a, Pack b) { return {hn::Lt(a.raw, b.raw)}; }
  friend HWY_INLINE Mask operator<=(Pack a, Pack b) { return {hn::Le(a.raw, b.raw)}; }
  friend HWY_INLINE Mask operator>(Pack a, Pack b) { return {hn::Gt(a.raw, b.raw)}; }
  friend HWY_INLINE Mask operator>=(Pack a, Pack b) { return {hn::Ge(a.raw, b.raw)}; }
  friend HWY_INLINE Pack sqrt(Pack a) { return Pack(hn::Sqrt(a.raw)); }
  friend HWY_INLINE Pack abs(Pack a) { return Pack(hn::Abs(a.raw)); }
  friend HWY_INLINE Pack select(Mask mask, Pack yes, Pack no) {
    return Pack(hn::IfThenElse(mask.raw, yes.raw, no.raw));
  }
  friend HWY_INLINE Pack lookup(const T* table, Pack a) {
    return Pack(hn::GatherIndex(D(), table, hn::ConvertTo(hn::RebindToSigned<D>(), a.raw)));
  }
  friend HWY_INLINE Pack floor(Pack a) {
    return Pack(hn::ConvertTo(D(), hn::ConvertTo(hn::RebindToSigned<D>(), a.raw)));
  }
};

/// Stores the chosen lanes side by side and returns how many those are; may write all lanes.
/// (Highway's own compresses into memory, which is slow on some processors, or by tables that g++
/// copies first.)
template <typename T>
HWY_INLINE std::size_t store_chosen(MaskOf<T> chosen, Pack<T> a, T* to) {
#if HWY_TARGET == HWY_AVX3
  if constexpr (sizeof(T) == 8) {
    _mm512_storeu_pd(to, _mm512_maskz_compress_pd(chosen.raw.raw, a.raw.raw));
    return hn::CountTrue(hn::ScalableTag<T>(), chosen.raw);
  }
#endif
  alignas(HWY_MAX_BYTES) T lanes[Pack<T>::kLanes];
  a.store(lanes);
  const std::uint32_t chosen_bits = bits(chosen);
  std::size_t count = 0;
  for (std::size_t k = 0; k < Pack<T>::kLanes; ++k) {
    to[count] = lanes[k];
    count += (chosen_bits >> k) & 1U;
  }
  return count;
}

template <typename T>
HWY_INLINE Pack<T> min(Pack<T> a, Pack<T> b) {
  return select(a < b, a, b);
}
template <typename T>
HWY_INLINE Pack<T> max(Pack<T> a, Pack<T> b) {
  return select(a > b, a, b);
}

}  // namespace avo::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
