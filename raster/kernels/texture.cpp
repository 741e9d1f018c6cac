// The texture unit: from coordinates and level of detail to filtered texels, for one batch of fragments.
// Addresses and weights are computed in vectors, texels fetched by scalar loads of horizontal pairs (faster
// than gathers), and the filters work on 16-bit integers in vectors. docs/arithmetic.md ("Texels") defines
// every operation.
#include <algorithm>
#include <cstring>

#include "raster/kernels/kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/texture.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

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

/// Where a texture's levels stand, in texels, for lookups by level number.
struct LevelTable {
  static constexpr int kMaxLevels = 16;
  alignas(64) std::int32_t width[kMaxLevels];
  alignas(64) std::int32_t height[kMaxLevels];
  alignas(64) std::int32_t pitch[kMaxLevels];
  alignas(64) std::int32_t origin[kMaxLevels];       ///< Of texel (0, 0) of face 0.
  alignas(64) std::int32_t face_stride[kMaxLevels];  ///< From one face to the next.
};

LevelTable level_table(const Texture& texture) {
  LevelTable table;
  const std::size_t bytes = texture.format() == TexelFormat::rgba8 ? 4 : 8;
  for (int l = 0; l < LevelTable::kMaxLevels; ++l) {
    const int level = std::min(l, texture.level_count() - 1);
    const MipLevel& face0 = texture.level(level);
    table.width[l] = face0.width;
    table.height[l] = face0.height;
    table.pitch[l] = face0.pitch_texels;
    table.origin[l] = static_cast<std::int32_t>(face0.offset_bytes / bytes) + face0.pitch_texels + 1;
    table.face_stride[l] =
        texture.is_cube()
            ? static_cast<std::int32_t>((texture.level(level, 1).offset_bytes - face0.offset_bytes) / bytes)
            : 0;
  }
  return table;
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
  return hn::Min(hn::Max(u, hn::Zero(d)), hn::Set(d, 1.0f));
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
    return hn::Min(hn::Max(hn::IfThenElse(valid, u, half), hn::Zero(d)), one);
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
};

/// Nearest texel along one axis.
HWY_INLINE VI nearest_texel(VF u, VI size, bool border) {
  const F d;
  const I di;
  const auto size_f = hn::ConvertTo(d, size);
  const auto scaled = hn::Floor(hn::Mul(u, size_f));
  const auto low = hn::Set(d, border ? -1.0f : 0.0f);
  const auto high = border ? size_f : hn::Sub(size_f, hn::Set(d, 1.0f));
  return hn::ConvertTo(di, hn::Min(hn::Max(scaled, low), high));
}

/// Lower texel in 24.8 fixed point along one axis.
HWY_INLINE VI linear_texel(VF u, VI size) {
  const F d;
  const I di;
  const auto size_f = hn::ConvertTo(d, size);
  const auto fixed = hn::Mul(hn::Sub(hn::Mul(u, size_f), hn::Set(d, 0.5f)), hn::Set(d, 256.0f));
  const auto bounded = hn::Min(hn::Max(fixed, hn::Set(d, -256.0f)), hn::Mul(size_f, hn::Set(d, 256.0f)));
  return hn::ConvertTo(di, hn::Floor(bounded));
}

/// Addresses and weights of a vector of fragments at `level`. Where `linear` is false the weights are 0, so
/// that the four-texel filter gives exactly the nearest texel.
HWY_INLINE void address(const Coordinates& c, VI level, hn::Mask<I> linear, const LevelTable& table,
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
  hn::Store(hn::And(x, fraction), di, out.weight_x + i);
  hn::Store(hn::And(y, fraction), di, out.weight_y + i);
}

/// Filtered texels in 16 bits a channel: two vectors of 32-bit lanes hold (red, blue) and (green, alpha).
struct Filtered {
  alignas(64) std::uint32_t red_blue[kBatchStride];
  alignas(64) std::uint32_t green_alpha[kBatchStride];
};

using U16 = hn::ScalableTag<std::uint16_t>;
using U32 = hn::ScalableTag<std::uint32_t>;

HWY_INLINE hn::Vec<U32> as_u32(hn::Vec<U16> v) { return hn::BitCast(U32(), v); }
HWY_INLINE hn::Vec<U16> as_u16(hn::Vec<U32> v) { return hn::BitCast(U16(), v); }
/// The same 16-bit number in both halves of each 32-bit lane.
HWY_INLINE hn::Vec<U16> in_both_halves(hn::Vec<U32> v) { return as_u16(hn::Or(v, hn::ShiftLeft<16>(v))); }

/// (a − ((a·256·weight) >> 16)) + ((b·256·weight) >> 16) per 16-bit lane: a when the weight is 0 or a = b.
HWY_INLINE hn::Vec<U16> mix(hn::Vec<U16> a, hn::Vec<U16> b, hn::Vec<U16> weight) {
  const auto w = hn::ShiftLeft<8>(weight);
  return hn::Add(hn::Sub(a, hn::MulHigh(a, w)), hn::MulHigh(b, w));
}

/// Texels of rgba8 textures: each pair of horizontal neighbours is one 64-bit load.
void filter_rgba8(const std::uint8_t* texels, const Footprint& f, int count, bool linear, Filtered& out) {
  alignas(64) std::uint32_t lower[2 * kBatchStride];
  alignas(64) std::uint32_t upper[2 * kBatchStride];
  const U32 du;
  const U16 d16;
  const int lanes = static_cast<int>(hn::Lanes(du));
  const auto mask = hn::Set(du, 0x00ff00ffu);
  if (!linear) {
    for (int i = 0; i < count; ++i)
      std::memcpy(&lower[i], texels + 4 * static_cast<std::ptrdiff_t>(f.address[i]), 4);
    for (int i = 0; i < count; i += lanes) {
      const auto t = hn::Load(du, lower + i);
      hn::Store(hn::ShiftLeft<8>(hn::And(t, mask)), du, out.red_blue + i);
      hn::Store(hn::AndNot(mask, t), du, out.green_alpha + i);
    }
    return;
  }
  for (int i = 0; i < count; ++i) {
    const std::uint8_t* pair = texels + 4 * static_cast<std::ptrdiff_t>(f.address[i]);
    std::memcpy(&lower[2 * i], pair, 8);
    std::memcpy(&upper[2 * i], pair + 4 * static_cast<std::ptrdiff_t>(f.pitch[i]), 8);
  }
  for (int i = 0; i < count; i += lanes) {
    const auto wx = in_both_halves(hn::Load(du, reinterpret_cast<const std::uint32_t*>(f.weight_x) + i));
    const auto wy = in_both_halves(hn::Load(du, reinterpret_cast<const std::uint32_t*>(f.weight_y) + i));
    const auto wx0 = hn::Sub(hn::Set(d16, std::uint16_t{256}), wx);
    const auto across = [&](const std::uint32_t* pairs, auto select) HWY_ATTR {
      const auto a = hn::Load(du, pairs + 2 * i);
      const auto b = hn::Load(du, pairs + 2 * i + lanes);
      const auto left = as_u16(select(hn::ConcatEven(du, b, a)));
      const auto right = as_u16(select(hn::ConcatOdd(du, b, a)));
      return hn::Add(hn::Mul(left, wx0), hn::Mul(right, wx));
    };
    const auto red_blue = [&](hn::Vec<U32> t) HWY_ATTR { return hn::And(t, mask); };
    const auto green_alpha = [&](hn::Vec<U32> t) HWY_ATTR { return hn::And(hn::ShiftRight<8>(t), mask); };
    hn::Store(as_u32(mix(across(lower, red_blue), across(upper, red_blue), wy)), du, out.red_blue + i);
    hn::Store(as_u32(mix(across(lower, green_alpha), across(upper, green_alpha), wy)), du,
              out.green_alpha + i);
  }
}

/// Texels of rgba16 textures: 64 bits each; (red, green) and (blue, alpha) are re-sorted like those of rgba8.
void filter_rgba16(const std::uint8_t* texels, const Footprint& f, int count, bool linear, Filtered& out) {
  alignas(64) std::uint32_t corner[4][2 * kBatchStride];  // lower left, lower right, upper left, upper right
  const U32 du;
  const int lanes = static_cast<int>(hn::Lanes(du));
  for (int i = 0; i < count; ++i) {
    const std::uint8_t* texel = texels + 8 * static_cast<std::ptrdiff_t>(f.address[i]);
    std::memcpy(&corner[0][2 * i], texel, 8);
    if (!linear) continue;
    const std::uint8_t* above = texel + 8 * static_cast<std::ptrdiff_t>(f.pitch[i]);
    std::memcpy(&corner[1][2 * i], texel + 8, 8);
    std::memcpy(&corner[2][2 * i], above, 8);
    std::memcpy(&corner[3][2 * i], above + 8, 8);
  }
  const auto low_half = hn::Set(du, 0x0000ffffu);
  for (int i = 0; i < count; i += lanes) {
    const auto words = [&](int c, bool second) HWY_ATTR {
      const auto a = hn::Load(du, corner[c] + 2 * i);
      const auto b = hn::Load(du, corner[c] + 2 * i + lanes);
      return second ? hn::ConcatOdd(du, b, a) : hn::ConcatEven(du, b, a);
    };
    const auto filtered = [&](bool second) HWY_ATTR {
      if (!linear) return as_u16(words(0, second));
      const auto wx = in_both_halves(hn::Load(du, reinterpret_cast<const std::uint32_t*>(f.weight_x) + i));
      const auto wy = in_both_halves(hn::Load(du, reinterpret_cast<const std::uint32_t*>(f.weight_y) + i));
      return mix(mix(as_u16(words(0, second)), as_u16(words(1, second)), wx),
                 mix(as_u16(words(2, second)), as_u16(words(3, second)), wx), wy);
    };
    const auto red_green = as_u32(filtered(false));
    const auto blue_alpha = as_u32(filtered(true));
    hn::Store(hn::Or(hn::And(red_green, low_half), hn::ShiftLeft<16>(blue_alpha)), du, out.red_blue + i);
    hn::Store(hn::Or(hn::ShiftRight<16>(red_green), hn::AndNot(low_half, blue_alpha)), du,
              out.green_alpha + i);
  }
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
  const auto bounded = hn::Min(hn::Max(lod, hn::Set(d, -64.0f)), hn::Set(d, 64.0f));
  if (choice.mip_nearest) {
    const auto level = hn::Sub(hn::Ceil(hn::Add(bounded, hn::Set(d, 0.5f))), hn::Set(d, 1.0f));
    levels.lower = hn::ConvertTo(di, hn::Min(hn::Max(level, hn::Zero(d)), last));
    levels.lower = hn::IfThenZeroElse(magnified, levels.lower);
    levels.upper = levels.lower;
    return levels;
  }
  const auto lambda = hn::Min(hn::Max(bounded, hn::Zero(d)), last);
  const auto below = hn::Floor(lambda);
  const auto weight = hn::Floor(hn::Mul(hn::Sub(lambda, below), hn::Set(d, 256.0f)));
  levels.lower = hn::IfThenZeroElse(magnified, hn::ConvertTo(di, below));
  levels.weight = hn::IfThenZeroElse(magnified, hn::ConvertTo(di, weight));
  const auto next = hn::Min(hn::Add(levels.lower, hn::Set(di, 1)), hn::Set(di, last_level));
  levels.upper = hn::IfThenElse(hn::Gt(levels.weight, zero), next, levels.lower);
  return levels;
}

/// 16-bit channels to floats in [0, 1].
void store_texels(const Filtered& f, int count, float scale, float (*texel)[kBatchStride]) {
  const F d;
  const I di;
  const auto s = hn::Set(d, scale);
  const auto low = hn::Set(di, 0xffff);
  for (int i = 0; i < count; i += static_cast<int>(hn::Lanes(d))) {
    const auto rb = hn::Load(di, reinterpret_cast<const std::int32_t*>(f.red_blue) + i);
    const auto ga = hn::Load(di, reinterpret_cast<const std::int32_t*>(f.green_alpha) + i);
    const auto high = [&](VI v) HWY_ATTR { return hn::And(hn::ShiftRight<16>(v), low); };
    hn::Store(hn::Mul(hn::ConvertTo(d, hn::And(rb, low)), s), d, texel[0] + i);
    hn::Store(hn::Mul(hn::ConvertTo(d, hn::And(ga, low)), s), d, texel[1] + i);
    hn::Store(hn::Mul(hn::ConvertTo(d, high(rb)), s), d, texel[2] + i);
    hn::Store(hn::Mul(hn::ConvertTo(d, high(ga)), s), d, texel[3] + i);
  }
}

void blend_levels(Filtered& lower, const Filtered& upper, const std::int32_t* weight, int count) {
  const U32 du;
  for (int i = 0; i < count; i += static_cast<int>(hn::Lanes(du))) {
    const auto w = in_both_halves(hn::Load(du, reinterpret_cast<const std::uint32_t*>(weight) + i));
    const auto blend = [&](std::uint32_t* a, const std::uint32_t* b) HWY_ATTR {
      hn::Store(as_u32(mix(as_u16(hn::Load(du, a + i)), as_u16(hn::Load(du, b + i)), w)), du, a + i);
    };
    blend(lower.red_blue, upper.red_blue);
    blend(lower.green_alpha, upper.green_alpha);
  }
}

class TextureSampler {
 public:
  TextureSampler(const FragmentBatch& batch, int unit)
      : batch_(batch),
        number_(static_cast<std::size_t>(unit)),
        unit_(batch.state->texture_units[number_]),
        texture_(*unit_.texture),
        table_(level_table(texture_)),
        choice_(level_choice(unit_)) {}

  std::uint64_t sample(float (*texel)[kBatchStride]) {
    find_footprints();
    const int count = batch_.count;
    const auto filter = texture_.format() == TexelFormat::rgba8 ? filter_rgba8 : filter_rgba16;
    filter(texture_.data(), lower_, count, any_linear_, lower_texels_);
    if (any_blend_) {
      filter(texture_.data(), upper_, count, any_linear_, upper_texels_);
      blend_levels(lower_texels_, upper_texels_, level_weight_, count);
    }
    const float scale = texture_.format() == TexelFormat::rgba8 ? 1.0f / 65280.0f : 1.0f / 65535.0f;
    store_texels(lower_texels_, count, scale, texel);
    return static_cast<std::uint64_t>(count) * (any_linear_ ? 4 : 1) * (any_blend_ ? 2 : 1);
  }

 private:
  HWY_INLINE Coordinates coordinates(int i) const {
    const F d;
    const int v = batch_.state->varyings.texcoord[number_];
    const auto s = hn::LoadU(d, batch_.varying[v] + i);
    const auto t = hn::LoadU(d, batch_.varying[v + 1] + i);
    const TexcoordKind kind = batch_.state->varyings.texcoord_kind[number_];
    if (kind == TexcoordKind::plain) return coordinates_2d(s, t, texture_.options());
    const auto r = hn::LoadU(d, batch_.varying[v + 2] + i);
    if (kind == TexcoordKind::cube) return coordinates_cube(s, t, r);
    return coordinates_2d(hn::Div(s, r), hn::Div(t, r), texture_.options());
  }

  void find_footprints() {
    const F d;
    const I di;
    const bool lod_matters =
        choice_.mip_linear || choice_.mip_nearest || choice_.min_linear != choice_.mag_linear;
    const auto bias = hn::Set(d, unit_.lod_bias);
    for (int i = 0; i < batch_.count; i += static_cast<int>(hn::Lanes(d))) {
      const auto lod = lod_matters ? hn::Add(hn::LoadU(d, batch_.lod[number_] + i), bias) : hn::Zero(d);
      const Levels levels = choose_levels(lod, choice_, texture_.level_count() - 1);
      const Coordinates c = coordinates(i);
      address(c, levels.lower, levels.linear, table_, texture_.options(), texture_.is_cube(), lower_, i);
      any_linear_ = any_linear_ || !hn::AllFalse(di, levels.linear);
      if (!choice_.mip_linear) continue;
      address(c, levels.upper, levels.linear, table_, texture_.options(), texture_.is_cube(), upper_, i);
      hn::Store(levels.weight, di, level_weight_ + i);
      any_blend_ = any_blend_ || !hn::AllTrue(di, hn::Eq(levels.weight, hn::Zero(di)));
    }
  }

  const FragmentBatch& batch_;
  const std::size_t number_;
  const TextureUnit& unit_;
  const Texture& texture_;
  const LevelTable table_;
  const LevelChoice choice_;
  bool any_linear_ = false;
  bool any_blend_ = false;
  Footprint lower_, upper_;
  alignas(64) std::int32_t level_weight_[kBatchStride];
  Filtered lower_texels_, upper_texels_;
};

std::uint64_t SampleTexture(const FragmentBatch& batch, int unit, float (*texel)[kBatchStride]) {
  return TextureSampler(batch, unit).sample(texel);
}

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace barrido::raster {

HWY_EXPORT(SampleTexture);

std::uint64_t sample_texture(const FragmentBatch& batch, int unit, float (*texel)[kBatchStride]) {
  return HWY_DYNAMIC_DISPATCH(SampleTexture)(batch, unit, texel);
}

}  // namespace barrido::raster
#endif
