// Blending and the 8-bit form of colours (OpenGL 1.3, section 4.1.7; docs/arithmetic.md, "Colours"), a vector
// of fragments at a time. Enters: source and destination colours. Leaves: what is to be stored.
#if defined(BARRIDO_BLEND_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BARRIDO_BLEND_INL_H
#undef BARRIDO_BLEND_INL_H
#else
#define BARRIDO_BLEND_INL_H
#endif

#include <hwy/highway.h>

#include "raster/kernels/simd_math-inl.h"
#include "raster/tiles/kernel_key.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::ScalableTag<float>;
using V = hn::Vec<F>;

HWY_INLINE V one() { return hn::Set(F(), 1.0f); }

struct Rgba {
  V c[4];
};

/// The same colour in every lane.
HWY_INLINE Rgba one_color(const float* c) {
  const F d;
  return {{hn::Set(d, c[0]), hn::Set(d, c[1]), hn::Set(d, c[2]), hn::Set(d, c[3])}};
}

/// Factor of one channel; `s` and `t` are source and destination. BlendFactor lists each factor before its
/// complement.
HWY_INLINE V blend_factor(BlendFactor factor, const Rgba& s, const Rgba& t, const BlendState& blend,
                          int channel) {
  if (factor == BlendFactor::src_alpha_saturate) {
    return channel == 3 ? one() : minimum(s.c[3], hn::Sub(one(), t.c[3]));
  }
  const F d;
  const int number = static_cast<int>(factor);
  const auto pair = static_cast<BlendFactor>(number & ~1);
  const V value = pair == BlendFactor::zero             ? hn::Zero(d)
                  : pair == BlendFactor::src_color      ? s.c[channel]
                  : pair == BlendFactor::dst_color      ? t.c[channel]
                  : pair == BlendFactor::src_alpha      ? s.c[3]
                  : pair == BlendFactor::dst_alpha      ? t.c[3]
                  : pair == BlendFactor::constant_color ? hn::Set(d, blend.constant[channel])
                                                        : hn::Set(d, blend.constant[3]);
  return number % 2 == 0 ? value : hn::Sub(one(), value);
}

// Each way of blending knows whether it `keeps_unit`: colours in [0, 1] then give colours in [0, 1 + 2^-19],
// which round to the same 8 bits as if they had been clamped.

/// Blending::replace.
struct Replace {
  static constexpr bool kReads = false;
  static constexpr bool keeps_unit = true;  // NOLINT(readability-identifier-naming): not constant in each
  explicit Replace(const BlendState&) {}
  HWY_INLINE Rgba operator()(const Rgba& source, const Rgba&) const { return source; }
};

/// Blending::constant.
struct BlendConstant {
  static constexpr bool kReads = true;
  Rgba source, destination;
  bool keeps_unit = true;

  explicit BlendConstant(const BlendState& blend) {
    const V zero = hn::Zero(F());
    const Rgba none{{zero, zero, zero, zero}};
    for (int c = 0; c < 4; ++c) {
      source.c[c] = blend_factor(c == 3 ? blend.src_alpha : blend.src_rgb, none, none, blend, c);
      destination.c[c] = blend_factor(c == 3 ? blend.dst_alpha : blend.dst_rgb, none, none, blend, c);
      const float s = hn::GetLane(source.c[c]);
      const float t = hn::GetLane(destination.c[c]);
      keeps_unit = keeps_unit && s >= 0.0f && t >= 0.0f && s + t <= 1.0f + 0x1p-20f;
    }
  }
  HWY_INLINE Rgba operator()(const Rgba& s, const Rgba& t) const {
    Rgba out;
    for (int c = 0; c < 4; ++c)
      out.c[c] = hn::Add(hn::Mul(s.c[c], source.c[c]), hn::Mul(t.c[c], destination.c[c]));
    return out;
  }
};

/// Blending::source_alpha.
struct BlendSourceAlpha {
  static constexpr bool kReads = true;
  static constexpr bool keeps_unit = true;  // NOLINT(readability-identifier-naming): not constant in each

  explicit BlendSourceAlpha(const BlendState&) {}
  HWY_INLINE Rgba operator()(const Rgba& s, const Rgba& t) const {
    const V behind = hn::Sub(one(), s.c[3]);
    Rgba out;
    for (int c = 0; c < 4; ++c) out.c[c] = hn::Add(hn::Mul(s.c[c], s.c[3]), hn::Mul(t.c[c], behind));
    return out;
  }
};

/// Blending::general.
struct BlendGeneral {
  static constexpr bool kReads = true;
  static constexpr bool keeps_unit = false;  // NOLINT(readability-identifier-naming): not constant in each
  const BlendState& blend;

  explicit BlendGeneral(const BlendState& b) : blend(b) {}
  HWY_INLINE V channel(const Rgba& s, const Rgba& t, int c) const {
    if (blend.equation == BlendEquation::min) return minimum(s.c[c], t.c[c]);
    if (blend.equation == BlendEquation::max) return maximum(s.c[c], t.c[c]);
    const V a = hn::Mul(s.c[c], blend_factor(c == 3 ? blend.src_alpha : blend.src_rgb, s, t, blend, c));
    const V b = hn::Mul(t.c[c], blend_factor(c == 3 ? blend.dst_alpha : blend.dst_rgb, s, t, blend, c));
    if (blend.equation == BlendEquation::subtract) return hn::Sub(a, b);
    return blend.equation == BlendEquation::reverse_subtract ? hn::Sub(b, a) : hn::Add(a, b);
  }
  HWY_INLINE Rgba operator()(const Rgba& s, const Rgba& t) const {
    return {{channel(s, t, 0), channel(s, t, 1), channel(s, t, 2), channel(s, t, 3)}};
  }
};

/// The packing to bytes: channels in [-2^-19, 1 + 2^-19] rounded to 8 bits. Adding 2^23 leaves the nearest
/// integer, ties to even, in the low bits of the sum. Above it stands what a shift to the left has to push
/// out or a mask to remove.
template <class Channels>
HWY_INLINE auto round8(Channels channels) {
  const hn::DFromV<Channels> d;
  const hn::RebindToSigned<decltype(d)> di;
  return hn::BitCast(di, hn::Add(hn::Mul(channels, hn::Set(d, 255.0f)), hn::Set(d, 8388608.0f)));
}

/// Colours in [0, 1 + 2^-19] in 8 bits a channel; with an alpha of 1, whatever `color` has, when kOpaque.
template <bool kOpaque = false>
HWY_INLINE auto pack8_unit(const Rgba& color) {
  const hn::RebindToSigned<F> di;
  auto alpha = hn::Set(di, static_cast<std::int32_t>(0xff000000u));
  if constexpr (!kOpaque) alpha = hn::ShiftLeft<24>(round8(color.c[3]));
  const auto red = hn::And(round8(color.c[0]), hn::Set(di, 0xff));
  return hn::Or(hn::Or(red, hn::ShiftLeft<8>(round8(color.c[1]))),
                hn::Or(hn::ShiftLeft<16>(round8(color.c[2])), alpha));
}

/// Any colours.
HWY_INLINE auto pack8(const Rgba& color) {
  return pack8_unit({{clamp01(color.c[0]), clamp01(color.c[1]), clamp01(color.c[2]), clamp01(color.c[3])}});
}

/// One pixel's colour from its four channels, of any size.
HWY_INLINE std::uint32_t pack_pixel(hn::Vec<hn::FixedTag<float, 4>> channels) {
  const hn::FixedTag<std::uint8_t, 16> d8;
  alignas(16) static constexpr std::uint8_t kLowBytes[16] = {0, 4, 8, 12, 0, 4, 8, 12,
                                                             0, 4, 8, 12, 0, 4, 8, 12};
  const auto bytes =
      hn::TableLookupBytes(hn::BitCast(d8, round8(clamp01(channels))), hn::Load(d8, kLowBytes));
  return hn::GetLane(hn::BitCast(hn::FixedTag<std::uint32_t, 4>(), bytes));
}

/// The byte kByte of each lane, as an integer.
template <int kByte, class VI>
HWY_INLINE VI byte_of(VI packed) {
  const hn::RebindToSigned<F> di;
  const hn::Repartition<std::uint8_t, decltype(di)> d8;
  alignas(16) static constexpr std::uint8_t kFrom[16] = {kByte,      0x80, 0x80,      0x80, kByte + 4, 0x80,
                                                         0x80,       0x80, kByte + 8, 0x80, 0x80,      0x80,
                                                         kByte + 12, 0x80, 0x80,      0x80};
  return hn::BitCast(di, hn::TableLookupBytesOr0(hn::BitCast(d8, packed), hn::LoadDup128(d8, kFrom)));
}

template <class VI>
HWY_INLINE Rgba unpack8(VI packed) {
  const F d;
  const auto channel = [&](auto byte)
                           HWY_ATTR { return hn::Mul(hn::ConvertTo(d, byte), hn::Set(d, 1.0f / 255.0f)); };
  return {{channel(byte_of<0>(packed)), channel(byte_of<1>(packed)), channel(byte_of<2>(packed)),
           channel(byte_of<3>(packed))}};
}

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
