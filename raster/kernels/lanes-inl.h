// Numbers of the lanes of a vector, as values and as masks. Highway's Iota builds them in memory at each use,
// which costs more than most of the loops that need them; here they are loaded from a constant.
#if defined(BARRIDO_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BARRIDO_LANES_INL_H
#undef BARRIDO_LANES_INL_H
#else
#define BARRIDO_LANES_INL_H
#endif

#include <hwy/highway.h>

#include <cstdint>

#include "raster/fragments/primitive.h"

#ifndef BARRIDO_LANE_NUMBERS
#define BARRIDO_LANE_NUMBERS
namespace barrido {
/// 0 … 15 in the type of the lanes: as many as the widest vector has.
template <class T>
struct LaneNumberTable {
  alignas(64) static constexpr T kNumbers[16] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
};
}  // namespace barrido
#endif

HWY_BEFORE_NAMESPACE();
namespace barrido::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// first, first + 1, … (exact while the numbers are below 2^24).
template <class D>
HWY_INLINE hn::Vec<D> lanes_from(D d, hn::TFromD<D> first) {
  return hn::Add(hn::Load(d, LaneNumberTable<hn::TFromD<D>>::kNumbers), hn::Set(d, first));
}

/// Whole numbers of magnitude up to 2^22 as integers. Highway's ConvertTo guards against overflow at several
/// times the cost: the sum with 3·2^22 has the number in its low bits.
template <class D>
HWY_INLINE hn::Vec<hn::RebindToSigned<D>> whole_to_integer(D d, hn::Vec<D> whole) {
  const hn::RebindToSigned<D> di;
  const auto biased = hn::Add(whole, hn::Set(d, 12582912.0f));
  return hn::Sub(hn::BitCast(di, biased), hn::Set(di, 0x4b400000));
}

/// ⌊v⌋ as integers, for magnitudes up to 2^22.
HWY_INLINE hn::Vec<hn::ScalableTag<std::int32_t>> floor_to_integer(hn::Vec<hn::ScalableTag<float>> v) {
#if HWY_TARGET <= HWY_AVX3 && HWY_ARCH_X86
  // One instruction where rounding and converting take four.
  return hn::Vec<hn::ScalableTag<std::int32_t>>{
      _mm512_cvt_roundps_epi32(v.raw, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC)};
#else
  return whole_to_integer(hn::ScalableTag<float>(), hn::Floor(v));
#endif
}

/// ⌈v⌉ of doubles as 32-bit integers, which must fit.
template <class D>
HWY_INLINE hn::Vec<hn::Rebind<std::int32_t, D>> ceiling_to_integer([[maybe_unused]] D d, hn::Vec<D> v) {
#if HWY_TARGET <= HWY_AVX3 && HWY_ARCH_X86
  if constexpr (hn::MaxLanes(d) == 8) {
    return hn::Vec<hn::Rebind<std::int32_t, D>>{
        _mm512_cvt_roundpd_epi32(v.raw, _MM_FROUND_TO_POS_INF | _MM_FROUND_NO_EXC)};
  }
#endif
  return hn::DemoteTo(hn::Rebind<std::int32_t, D>(), hn::Ceil(v));
}

/// The lanes below n; none when n ≤ 0, all when n is large.
template <class D>
HWY_INLINE hn::Mask<D> lanes_below(D d, int n) {
  const hn::RebindToSigned<D> di;
  return hn::RebindMask(d, hn::Lt(hn::Load(di, LaneNumberTable<std::int32_t>::kNumbers), hn::Set(di, n)));
}

/// See raster::first_centre_at.
template <class V>
HWY_INLINE V first_centres_at(V coordinate) {
  const hn::DFromV<V> di;
  return hn::ShiftRight<raster::kSubpixelBits>(hn::Add(coordinate, hn::Set(di, raster::kToFirstCentre)));
}

}  // namespace barrido::HWY_NAMESPACE

namespace barrido::raster::HWY_NAMESPACE {
using namespace barrido::HWY_NAMESPACE;  // here and in simd_math-inl.h: kernels use these everywhere
}
HWY_AFTER_NAMESPACE();

#endif
