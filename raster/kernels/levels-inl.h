// Which mip levels: from the level of detail λ to the levels a sample comes from and how they are mixed
// (OpenGL 1.3, section 3.8.8; docs/arithmetic.md, "Level of detail"), packed into 32 bits so that it is found
// once for a group of pixels and then handed to each of them.
#if defined(BARRIDO_LEVELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BARRIDO_LEVELS_INL_H
#undef BARRIDO_LEVELS_INL_H
#else
#define BARRIDO_LEVELS_INL_H
#endif

#include <hwy/highway.h>

#include "raster/fragments/fragment_batch.h"
#include "raster/kernels/lanes-inl.h"
#include "raster/kernels/simd_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::ScalableTag<float>;
using I = hn::ScalableTag<std::int32_t>;
using VF = hn::Vec<F>;
using VI = hn::Vec<I>;

/// How the two filters choose levels for a unit.
struct UnitFilters {
  float magnification_limit;  ///< λ up to which the magnification filter is used.
  bool min_linear;            ///< Four texels when minifying.
  bool mag_linear;
  bool mip_nearest;  ///< *_mipmap_nearest
  bool mip_linear;   ///< *_mipmap_linear
};

inline UnitFilters unit_filters(const TextureUnit& unit) {
  const MinFilter f = unit.min_filter;
  UnitFilters filters{};
  filters.min_linear =
      f == MinFilter::linear || f == MinFilter::linear_mipmap_nearest || f == MinFilter::linear_mipmap_linear;
  filters.mag_linear = unit.mag_filter == MagFilter::linear;
  filters.mip_nearest = f == MinFilter::nearest_mipmap_nearest || f == MinFilter::linear_mipmap_nearest;
  filters.mip_linear = f == MinFilter::nearest_mipmap_linear || f == MinFilter::linear_mipmap_linear;
  const bool half =
      filters.mag_linear && (f == MinFilter::nearest_mipmap_nearest || f == MinFilter::nearest_mipmap_linear);
  filters.magnification_limit = half ? 0.5f : 0.0f;
  return filters;
}

/// A vector of packed levels (raster/fragments/fragment_batch.h, SampleLevels).
HWY_INLINE VI pack_levels(VI lower, VI upper, VI weight, hn::Mask<I> linear) {
  const I di;
  const auto texels = hn::IfThenElse(linear, hn::Set(di, 4), hn::Set(di, 1));
  const auto twice = hn::Add(texels, hn::IfThenElseZero(hn::Gt(weight, hn::Zero(di)), texels));
  const auto flag = hn::IfThenElseZero(linear, hn::Set(di, kFourTexels));
  return hn::Or(
      hn::Or(weight, hn::ShiftLeft<kLowerLevelShift>(lower)),
      hn::Or(hn::Or(hn::ShiftLeft<kUpperLevelShift>(upper), flag), hn::ShiftLeft<kTexelCountShift>(twice)));
}

/// Levels for λ, the bias added already.
HWY_INLINE VI choose_levels(VF lod, const UnitFilters& filters, int last_level) {
  const F d;
  const I di;
  const auto zero = hn::Zero(di);
  const auto magnified_f = hn::Le(lod, hn::Set(d, filters.magnification_limit));
  const auto magnified = hn::RebindMask(di, magnified_f);
  const auto flag = [&](bool on) HWY_ATTR { return hn::MaskFromVec(hn::Set(di, on ? -1 : 0)); };
  const auto linear =
      hn::Or(hn::And(magnified, flag(filters.mag_linear)), hn::AndNot(magnified, flag(filters.min_linear)));
  if (!filters.mip_nearest && !filters.mip_linear) return pack_levels(zero, zero, zero, linear);
  const auto last = hn::Set(d, static_cast<float>(last_level));
  const auto bounded = minimum(maximum(lod, hn::Set(d, -64.0f)), hn::Set(d, 64.0f));
  if (filters.mip_nearest) {
    const auto level = hn::Sub(hn::Ceil(hn::Add(bounded, hn::Set(d, 0.5f))), hn::Set(d, 1.0f));
    const auto whole = whole_to_integer(d, minimum(maximum(level, hn::Zero(d)), last));
    const auto lower = hn::IfThenZeroElse(magnified, whole);
    return pack_levels(lower, lower, zero, linear);
  }
  const auto lambda = minimum(maximum(bounded, hn::Zero(d)), last);
  const auto below = hn::Floor(lambda);
  const auto part = hn::Floor(hn::Mul(hn::Sub(lambda, below), hn::Set(d, 256.0f)));
  const auto lower = hn::IfThenZeroElse(magnified, whole_to_integer(d, below));
  const auto weight = hn::IfThenZeroElse(magnified, whole_to_integer(d, part));
  const auto next = hn::Min(hn::Add(lower, hn::Set(di, 1)), hn::Set(di, last_level));
  return pack_levels(lower, hn::IfThenElse(hn::Gt(weight, zero), next, lower), weight, linear);
}

/// The levels of all fragments for filters that do not ask for λ.
inline std::int32_t level_zero(bool linear) {
  return linear ? kFourTexels | 4 << kTexelCountShift : 1 << kTexelCountShift;
}

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
