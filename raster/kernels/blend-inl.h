// Blending and the 8-bit form of colours (OpenGL 1.3, section 4.1.7; docs/arithmetic.md, "Colours"), a vector
// of fragments at a time. Enters: source and destination colours. Leaves: what is to be stored.
#if defined(BARRIDO_BLEND_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BARRIDO_BLEND_INL_H
#undef BARRIDO_BLEND_INL_H
#else
#define BARRIDO_BLEND_INL_H
#endif

#include <hwy/highway.h>

#include "raster/fragments/fragment_state.h"
#include "raster/kernels/simd_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::ScalableTag<float>;
using V = hn::Vec<F>;

HWY_INLINE V one() { return hn::Set(F(), 1.0f); }
HWY_INLINE V clamp01(V c) {
  return barrido::HWY_NAMESPACE::minimum(barrido::HWY_NAMESPACE::maximum(c, hn::Zero(F())), one());
}

struct Rgba {
  V c[4];
};

/// Factor of one channel; `s` and `t` are source and destination.
HWY_INLINE V blend_factor(BlendFactor factor, const Rgba& s, const Rgba& t, const BlendState& blend,
                          int channel) {
  const F d;
  const auto constant = [&](int c)
                            HWY_ATTR { return hn::Set(d, blend.constant[static_cast<std::size_t>(c)]); };
  switch (factor) {
    case BlendFactor::zero:
      return hn::Zero(d);
    case BlendFactor::one:
      return one();
    case BlendFactor::src_color:
      return s.c[channel];
    case BlendFactor::one_minus_src_color:
      return hn::Sub(one(), s.c[channel]);
    case BlendFactor::dst_color:
      return t.c[channel];
    case BlendFactor::one_minus_dst_color:
      return hn::Sub(one(), t.c[channel]);
    case BlendFactor::src_alpha:
      return s.c[3];
    case BlendFactor::one_minus_src_alpha:
      return hn::Sub(one(), s.c[3]);
    case BlendFactor::dst_alpha:
      return t.c[3];
    case BlendFactor::one_minus_dst_alpha:
      return hn::Sub(one(), t.c[3]);
    case BlendFactor::constant_color:
      return constant(channel);
    case BlendFactor::one_minus_constant_color:
      return hn::Sub(one(), constant(channel));
    case BlendFactor::constant_alpha:
      return constant(3);
    case BlendFactor::one_minus_constant_alpha:
      return hn::Sub(one(), constant(3));
    case BlendFactor::src_alpha_saturate:
      break;
  }
  return channel == 3 ? one() : barrido::HWY_NAMESPACE::minimum(s.c[3], hn::Sub(one(), t.c[3]));
}

// Each way of blending knows whether it `keeps_unit`: colours in [0, 1] then give colours in [0, 1 + 2^-19],
// which round to the same 8 bits as if they had been clamped.

/// No blending: the source replaces what is there.
struct Replace {
  static constexpr bool kReads = false;
  static constexpr bool keeps_unit = true;  // NOLINT(readability-identifier-naming): not constant in each
  explicit Replace(const BlendState&) {}
  HWY_INLINE Rgba operator()(const Rgba& source, const Rgba&) const { return source; }
};

/// Factors that are the same for all fragments, added: kept in registers.
struct BlendConstant {
  static constexpr bool kReads = true;
  Rgba source, destination;
  bool keeps_unit = true;

  static bool fits(const BlendState& blend) {
    const auto constant = [](BlendFactor f) {
      return f == BlendFactor::zero || f == BlendFactor::one ||
             (f >= BlendFactor::constant_color && f <= BlendFactor::one_minus_constant_alpha);
    };
    return blend.equation == BlendEquation::add && constant(blend.src_rgb) && constant(blend.dst_rgb) &&
           constant(blend.src_alpha) && constant(blend.dst_alpha);
  }
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

/// The usual transparency: source alpha, one minus source alpha.
struct BlendSourceAlpha {
  static constexpr bool kReads = true;
  static constexpr bool keeps_unit = true;  // NOLINT(readability-identifier-naming): not constant in each

  static bool fits(const BlendState& blend) {
    return blend.equation == BlendEquation::add && blend.src_rgb == BlendFactor::src_alpha &&
           blend.src_alpha == BlendFactor::src_alpha && blend.dst_rgb == BlendFactor::one_minus_src_alpha &&
           blend.dst_alpha == BlendFactor::one_minus_src_alpha;
  }
  explicit BlendSourceAlpha(const BlendState&) {}
  HWY_INLINE Rgba operator()(const Rgba& s, const Rgba& t) const {
    const V behind = hn::Sub(one(), s.c[3]);
    Rgba out;
    for (int c = 0; c < 4; ++c) out.c[c] = hn::Add(hn::Mul(s.c[c], s.c[3]), hn::Mul(t.c[c], behind));
    return out;
  }
};

/// Any factors and equation.
struct BlendGeneral {
  static constexpr bool kReads = true;
  static constexpr bool keeps_unit = false;  // NOLINT(readability-identifier-naming): not constant in each
  const BlendState& blend;

  explicit BlendGeneral(const BlendState& b) : blend(b) {}
  HWY_INLINE V channel(const Rgba& s, const Rgba& t, int c) const {
    if (blend.equation == BlendEquation::min) return barrido::HWY_NAMESPACE::minimum(s.c[c], t.c[c]);
    if (blend.equation == BlendEquation::max) return barrido::HWY_NAMESPACE::maximum(s.c[c], t.c[c]);
    const V a = hn::Mul(s.c[c], blend_factor(c == 3 ? blend.src_alpha : blend.src_rgb, s, t, blend, c));
    const V b = hn::Mul(t.c[c], blend_factor(c == 3 ? blend.dst_alpha : blend.dst_rgb, s, t, blend, c));
    if (blend.equation == BlendEquation::subtract) return hn::Sub(a, b);
    return blend.equation == BlendEquation::reverse_subtract ? hn::Sub(b, a) : hn::Add(a, b);
  }
  HWY_INLINE Rgba operator()(const Rgba& s, const Rgba& t) const {
    return {{channel(s, t, 0), channel(s, t, 1), channel(s, t, 2), channel(s, t, 3)}};
  }
};

/// A channel in [-2^-19, 1 + 2^-19], rounded to 8 bits: adding 2^23 leaves the nearest integer, ties to even,
/// in the low bits of the sum. Above it stands what a shift to the left has to push out or a mask to remove.
HWY_INLINE auto round8(V channel) {
  const hn::RebindToSigned<F> di;
  return hn::BitCast(di, hn::Add(hn::Mul(channel, hn::Set(F(), 255.0f)), hn::Set(F(), 8388608.0f)));
}

/// Colours in [0, 1 + 2^-19] in 8 bits a channel.
HWY_INLINE auto pack8_unit(const Rgba& color) {
  const auto low = hn::Set(hn::RebindToSigned<F>(), 0xff);
  return hn::Or(hn::Or(hn::And(round8(color.c[0]), low), hn::ShiftLeft<8>(round8(color.c[1]))),
                hn::Or(hn::ShiftLeft<16>(round8(color.c[2])), hn::ShiftLeft<24>(round8(color.c[3]))));
}

/// The same with an alpha of 1, whatever `color` has.
HWY_INLINE auto pack8_opaque(const Rgba& color) {
  const hn::RebindToSigned<F> di;
  const auto alpha = hn::Set(di, static_cast<std::int32_t>(0xff000000u));
  return hn::Or(hn::Or(hn::And(round8(color.c[0]), hn::Set(di, 0xff)), hn::ShiftLeft<8>(round8(color.c[1]))),
                hn::Or(hn::ShiftLeft<16>(round8(color.c[2])), alpha));
}

/// Any colours.
HWY_INLINE auto pack8(const Rgba& color) {
  return pack8_unit({{clamp01(color.c[0]), clamp01(color.c[1]), clamp01(color.c[2]), clamp01(color.c[3])}});
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
