// From texel addresses and weights to filtered texels. Texels are fetched by scalar loads of horizontal pairs
// (faster than gathers), and filtered as 16-bit integers in vectors (docs/arithmetic.md, "Texels").
#if defined(BARRIDO_TEXTURE_FILTER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BARRIDO_TEXTURE_FILTER_INL_H
#undef BARRIDO_TEXTURE_FILTER_INL_H
#else
#define BARRIDO_TEXTURE_FILTER_INL_H
#endif

#include <hwy/highway.h>

#include <cstring>

#include "raster/kernels/texture_address-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

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

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
