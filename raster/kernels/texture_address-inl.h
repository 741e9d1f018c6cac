// Which texels: from coordinates and level of detail to levels, texel addresses and 8-bit weights, a vector
// of fragments at a time (docs/arithmetic.md, "Level of detail" and "Texels").
#if defined(BARRIDO_TEXTURE_ADDRESS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BARRIDO_TEXTURE_ADDRESS_INL_H
#undef BARRIDO_TEXTURE_ADDRESS_INL_H
#else
#define BARRIDO_TEXTURE_ADDRESS_INL_H
#endif

#include <hwy/highway.h>

#include "raster/kernels/lanes-inl.h"
#include "raster/kernels/simd_math-inl.h"

#include <algorithm>

#include "raster/fragment_batch.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::ScalableTag<float>;
using I = hn::ScalableTag<std::int32_t>;
using VF = hn::Vec<F>;
using VI = hn::Vec<I>;

/// How the two filters choose levels for a unit.
struct LevelChoice {
  float magnification_limit;  ///< λ up to which the magnification filter is used.
  bool min_linear;            ///< Four texels when minifying.
  bool mag_linear;
  bool mip_nearest;  ///< *_mipmap_nearest
  bool mip_linear;   ///< *_mipmap_linear
};

LevelChoice level_choice(const TextureUnit& unit) {
  const MinFilter f = unit.min_filter;
  LevelChoice choice{};
  choice.min_linear =
      f == MinFilter::linear || f == MinFilter::linear_mipmap_nearest || f == MinFilter::linear_mipmap_linear;
  choice.mag_linear = unit.mag_filter == MagFilter::linear;
  choice.mip_nearest = f == MinFilter::nearest_mipmap_nearest || f == MinFilter::linear_mipmap_nearest;
  choice.mip_linear = f == MinFilter::nearest_mipmap_linear || f == MinFilter::linear_mipmap_linear;
  const bool half =
      choice.mag_linear && (f == MinFilter::nearest_mipmap_nearest || f == MinFilter::nearest_mipmap_linear);
  choice.magnification_limit = half ? 0.5f : 0.0f;
  return choice;
}

/// Levels of a vector of fragments.
struct Levels {
  VI lower, upper;     ///< The same when one level is used.
  VI weight;           ///< 8 bits, of the upper level.
  hn::Mask<I> linear;  ///< Four texels a level.
};

HWY_INLINE Levels choose_levels(VF lod, const LevelChoice& choice, int last_level) {
  const F d;
  const I di;
  const auto zero = hn::Zero(di);
  const auto magnified_f = hn::Le(lod, hn::Set(d, choice.magnification_limit));
  const auto magnified = hn::RebindMask(di, magnified_f);
  const auto flag = [&](bool on) HWY_ATTR { return hn::MaskFromVec(hn::Set(di, on ? -1 : 0)); };
  Levels levels{
      zero, zero, zero,
      hn::Or(hn::And(magnified, flag(choice.mag_linear)), hn::AndNot(magnified, flag(choice.min_linear)))};
  if (!choice.mip_nearest && !choice.mip_linear) return levels;
  const auto last = hn::Set(d, static_cast<float>(last_level));
  const auto bounded = barrido::HWY_NAMESPACE::minimum(
      barrido::HWY_NAMESPACE::maximum(lod, hn::Set(d, -64.0f)), hn::Set(d, 64.0f));
  if (choice.mip_nearest) {
    const auto level = hn::Sub(hn::Ceil(hn::Add(bounded, hn::Set(d, 0.5f))), hn::Set(d, 1.0f));
    levels.lower = barrido::HWY_NAMESPACE::whole_to_integer(
        d, barrido::HWY_NAMESPACE::minimum(barrido::HWY_NAMESPACE::maximum(level, hn::Zero(d)), last));
    levels.lower = hn::IfThenZeroElse(magnified, levels.lower);
    levels.upper = levels.lower;
    return levels;
  }
  const auto lambda =
      barrido::HWY_NAMESPACE::minimum(barrido::HWY_NAMESPACE::maximum(bounded, hn::Zero(d)), last);
  const auto below = hn::Floor(lambda);
  const auto weight = hn::Floor(hn::Mul(hn::Sub(lambda, below), hn::Set(d, 256.0f)));
  levels.lower = hn::IfThenZeroElse(magnified, barrido::HWY_NAMESPACE::whole_to_integer(d, below));
  levels.weight = hn::IfThenZeroElse(magnified, barrido::HWY_NAMESPACE::whole_to_integer(d, weight));
  const auto next =
      barrido::HWY_NAMESPACE::minimum(hn::Add(levels.lower, hn::Set(di, 1)), hn::Set(di, last_level));
  levels.upper = hn::IfThenElse(hn::Gt(levels.weight, zero), next, levels.lower);
  return levels;
}

/// A number per lane from a table by level; one broadcast when all lanes share the level, which is the usual
/// case.
struct LevelLookup {
  VI level;
  bool uniform;
  std::int32_t first;

  explicit LevelLookup(VI l) : level(l) {
    const I di;
    first = hn::GetLane(l);
    uniform = hn::AllTrue(di, hn::Eq(l, hn::Set(di, first)));
  }
  HWY_INLINE VI operator()(const std::int32_t* table) const {
    const I di;
    return uniform ? hn::Set(di, table[first]) : hn::GatherIndex(di, table, level);
  }
};

/// Coordinates of a vector of fragments: on a face of a cube map or on the one image.
struct Coordinates {
  VF u, v;
  VI face;
};

/// Coordinates not below 2^22 in magnitude, and NaN, count as 0.
HWY_INLINE VF usable(VF c) {
  const F d;
  return hn::IfThenElseZero(hn::Lt(hn::Abs(c), hn::Set(d, 4194304.0f)), c);
}

HWY_INLINE VF wrap(VF u, Wrap mode) {
  const F d;
  switch (mode) {
    case Wrap::repeat:
      return hn::Sub(u, hn::Floor(u));
    case Wrap::mirrored_repeat: {
      const auto two = hn::Set(d, 2.0f);
      const auto m = hn::Sub(u, hn::Mul(two, hn::Floor(hn::Mul(u, hn::Set(d, 0.5f)))));
      return hn::IfThenElse(hn::Gt(m, hn::Set(d, 1.0f)), hn::Sub(two, m), m);
    }
    case Wrap::clamp_to_border:
      return u;
    case Wrap::clamp_to_edge:
    case Wrap::clamp:
      break;
  }
  return barrido::HWY_NAMESPACE::minimum(barrido::HWY_NAMESPACE::maximum(u, hn::Zero(d)), hn::Set(d, 1.0f));
}

HWY_INLINE Coordinates coordinates_2d(VF s, VF t, const TextureOptions& options) {
  return {wrap(usable(s), options.wrap_s), wrap(usable(t), options.wrap_t), hn::Zero(I())};
}

/// Face and (u, v) in [0, 1] by the major axis (OpenGL 1.3, table 3.19).
HWY_INLINE Coordinates coordinates_cube(VF x, VF y, VF z) {
  const F d;
  const I di;
  const auto ax = hn::Abs(x);
  const auto ay = hn::Abs(y);
  const auto az = hn::Abs(z);
  const auto is_x = hn::And(hn::Ge(ax, ay), hn::Ge(ax, az));
  const auto is_y = hn::And(hn::Not(is_x), hn::Ge(ay, az));
  const auto ma = hn::IfThenElse(is_x, x, hn::IfThenElse(is_y, y, z));
  const auto negative = hn::Lt(ma, hn::Zero(d));
  const auto negated = [&](VF v) HWY_ATTR { return hn::IfThenElse(negative, hn::Neg(v), v); };
  // +X (−z, −y), −X (z, −y), +Y (x, z), −Y (x, −z), +Z (x, −y), −Z (−x, −y)
  const auto sc = hn::IfThenElse(is_x, hn::Neg(negated(z)), hn::IfThenElse(is_y, x, negated(x)));
  const auto tc = hn::IfThenElse(is_y, negated(z), hn::Neg(y));
  const auto w = hn::Div(hn::Set(d, 1.0f), hn::Abs(ma));
  const auto one = hn::Set(d, 1.0f);
  const auto half = hn::Set(d, 0.5f);
  const auto valid = hn::Gt(hn::Abs(ma), hn::Zero(d));
  const auto to_unit = [&](VF c) HWY_ATTR {
    const auto u = hn::Mul(hn::Add(hn::Mul(c, w), one), half);
    return barrido::HWY_NAMESPACE::minimum(
        barrido::HWY_NAMESPACE::maximum(hn::IfThenElse(valid, u, half), hn::Zero(d)), one);
  };
  const auto axis = hn::IfThenElse(hn::RebindMask(di, is_x), hn::Zero(di),
                                   hn::IfThenElse(hn::RebindMask(di, is_y), hn::Set(di, 2), hn::Set(di, 4)));
  const auto side = hn::IfThenElseZero(hn::RebindMask(di, negative), hn::Set(di, 1));
  return {to_unit(sc), to_unit(tc), hn::Add(axis, side)};
}

/// Texel addresses and 8-bit weights of a batch, for one level of each fragment.
struct Footprint {
  alignas(64) std::int32_t address[kBatchStride];  ///< Of the (nearest or lower left) texel, in texels.
  alignas(64) std::int32_t pitch[kBatchStride];    ///< To the texel above.
  alignas(64) std::int32_t weight_x[kBatchStride];
  alignas(64) std::int32_t weight_y[kBatchStride];
  bool has_one_pitch = true;  ///< The same for all, the usual case.
};

/// Nearest texel along one axis.
HWY_INLINE VI nearest_texel(VF u, VI size, bool border) {
  const F d;
  const auto size_f = hn::ConvertTo(d, size);
  const auto scaled = hn::Floor(hn::Mul(u, size_f));
  const auto low = hn::Set(d, border ? -1.0f : 0.0f);
  const auto high = border ? size_f : hn::Sub(size_f, hn::Set(d, 1.0f));
  return barrido::HWY_NAMESPACE::whole_to_integer(
      d, barrido::HWY_NAMESPACE::minimum(barrido::HWY_NAMESPACE::maximum(scaled, low), high));
}

/// Lower texel in 24.8 fixed point along one axis.
HWY_INLINE VI linear_texel(VF u, VI size) {
  const F d;
  const auto size_f = hn::ConvertTo(d, size);
  // Half a texel, less half a step of 1/256: the floor below rounds to the nearest step.
  const auto half = hn::Set(d, 0.5f - 0x1p-9f);
  const auto fixed = hn::Mul(hn::Sub(hn::Mul(u, size_f), half), hn::Set(d, 256.0f));
  const auto bounded = barrido::HWY_NAMESPACE::minimum(
      barrido::HWY_NAMESPACE::maximum(fixed, hn::Set(d, -256.0f)), hn::Mul(size_f, hn::Set(d, 256.0f)));
  return barrido::HWY_NAMESPACE::whole_to_integer(d, hn::Floor(bounded));
}

/// Addresses and weights of a vector of fragments at `level`. Where `linear` is false the weights are 0, so
/// that the four-texel filter gives exactly the nearest texel.
HWY_INLINE void address(const Coordinates& c, VI level, hn::Mask<I> linear, const TexelLevels& table,
                        const TextureOptions& options, bool cube, Footprint& out, int i) {
  const I di;
  const LevelLookup lookup(level);
  const auto width = lookup(table.width);
  const auto height = lookup(table.height);
  const auto pitch = lookup(table.pitch);
  auto origin = lookup(table.origin);
  if (cube) origin = hn::Add(origin, hn::Mul(c.face, lookup(table.face_stride)));
  auto x = hn::Zero(di);
  auto y = hn::Zero(di);
  if (!hn::AllFalse(di, linear)) {
    x = linear_texel(c.u, width);
    y = linear_texel(c.v, height);
  }
  if (!hn::AllTrue(di, linear)) {
    const bool border_s = !cube && options.wrap_s == Wrap::clamp_to_border;
    const bool border_t = !cube && options.wrap_t == Wrap::clamp_to_border;
    x = hn::IfThenElse(linear, x, hn::ShiftLeft<8>(nearest_texel(c.u, width, border_s)));
    y = hn::IfThenElse(linear, y, hn::ShiftLeft<8>(nearest_texel(c.v, height, border_t)));
  }
  const auto column = hn::ShiftRight<8>(x);
  const auto row = hn::ShiftRight<8>(y);
  const auto fraction = hn::Set(di, 255);
  hn::Store(hn::Add(origin, hn::Add(column, hn::Mul(row, pitch))), di, out.address + i);
  hn::Store(pitch, di, out.pitch + i);
  out.has_one_pitch = out.has_one_pitch && lookup.uniform && table.pitch[lookup.first] == out.pitch[0];
  hn::Store(hn::And(x, fraction), di, out.weight_x + i);
  hn::Store(hn::And(y, fraction), di, out.weight_y + i);
}

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
