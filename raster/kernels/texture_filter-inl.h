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

using U16 = hn::ScalableTag<std::uint16_t>;
using U32 = hn::ScalableTag<std::uint32_t>;

HWY_INLINE hn::Vec<U32> as_u32(hn::Vec<U16> v) { return hn::BitCast(U32(), v); }
HWY_INLINE hn::Vec<U16> as_u16(hn::Vec<U32> v) { return hn::BitCast(U16(), v); }

/// The byte kByte of each 32-bit lane as the low or the high byte of both of its 16-bit halves.
template <int kByte, bool kHigh>
HWY_INLINE hn::Vec<U16> byte_in_halves(VI v) {
  const hn::Repartition<std::uint8_t, U32> d8;
  constexpr std::uint8_t kZero = 0x80;
  constexpr auto at = [](int lane) { return static_cast<std::uint8_t>(4 * lane + kByte); };
#define BARRIDO_BYTES(lane) \
  kHigh ? kZero : at(lane), kHigh ? at(lane) : kZero, kHigh ? kZero : at(lane), kHigh ? at(lane) : kZero
  alignas(16) static constexpr std::uint8_t kFrom[16] = {BARRIDO_BYTES(0), BARRIDO_BYTES(1), BARRIDO_BYTES(2),
                                                         BARRIDO_BYTES(3)};
#undef BARRIDO_BYTES
  return hn::BitCast(U16(), hn::TableLookupBytesOr0(hn::BitCast(d8, v), hn::LoadDup128(d8, kFrom)));
}

/// (a − ((a·weight) >> 16)) + ((b·weight) >> 16) per 16-bit lane: a when the weight is 0 or a = b.
HWY_INLINE hn::Vec<U16> mix(hn::Vec<U16> a, hn::Vec<U16> b, hn::Vec<U16> weight) {
  return hn::Add(hn::Sub(a, hn::MulHigh(a, weight)), hn::MulHigh(b, weight));
}

/// Filtered texels of a vector of fragments, 16 bits a channel: 32-bit lanes hold (red, blue) and (green,
/// alpha).
struct Filtered {
  hn::Vec<U16> red_blue, green_alpha;
};

HWY_INLINE Filtered mix(const Filtered& a, const Filtered& b, hn::Vec<U16> weight) {
  return {mix(a.red_blue, b.red_blue, weight), mix(a.green_alpha, b.green_alpha, weight)};
}

/// Weights of a vector of fragments in both 16-bit halves of each lane: along x in [0, 255], along y × 256.
HWY_INLINE hn::Vec<U16> weight_x(const Footprint& f, int i) {
  return byte_in_halves<0, false>(hn::Load(I(), f.weights + i));
}
HWY_INLINE hn::Vec<U16> weight_x256(const Footprint& f, int i) {
  return byte_in_halves<0, true>(hn::Load(I(), f.weights + i));
}
HWY_INLINE hn::Vec<U16> weight_y256(const Footprint& f, int i) {
  return byte_in_halves<3, true>(hn::Load(I(), f.weights + i));
}
/// Of the upper level, × 256.
HWY_INLINE hn::Vec<U16> level_weight256(const SampleLevels& levels, int i) {
  return byte_in_halves<0, true>(hn::Load(I(), levels.packed + i));
}

/// Calls fetch(i, below, above) for the fragments of a batch: the distances in bytes of the texel and of the
/// one above it, for texels of kBytes. Goes on to a multiple of four, which the footprint has room and
/// addresses for.
template <int kBytes, class Fetch>
HWY_INLINE void for_each_texel(const Footprint& f, int count, Fetch&& fetch) {
  const auto four = [&](int i, auto pitch_of) HWY_ATTR {
    for (int j = i; j < i + 4; ++j) {
      const std::ptrdiff_t below = kBytes * static_cast<std::ptrdiff_t>(f.address[j]);
      fetch(j, below, below + kBytes * pitch_of(j));
    }
  };
  if (f.has_one_pitch) {
    const std::ptrdiff_t pitch = f.pitch[0];
    for (int i = 0; i < count; i += 4) four(i, [pitch](int) { return pitch; });
  } else {
    for (int i = 0; i < count; i += 4)
      four(i, [&f](int j) { return static_cast<std::ptrdiff_t>(f.pitch[j]); });
  }
}

/// Texels of an rgba8 texture for a batch: each pair of horizontal neighbours is one 64-bit load.
class Texels8 {
 public:
  static constexpr float kScale = 1.0f / 65280.0f;  ///< From filtered texels to [0, 1].

  void fetch(const std::uint8_t* texels, const Footprint& f, int count, bool linear) {
    if (!linear) {
      for_each_texel<4>(f, count, [&](int i, std::ptrdiff_t texel, std::ptrdiff_t) HWY_ATTR {
        std::memcpy(&lower_[i], texels + texel, 4);
      });
      return;
    }
    for_each_texel<4>(f, count, [&](int i, std::ptrdiff_t below, std::ptrdiff_t above) HWY_ATTR {
      std::memcpy(&lower_[2 * i], texels + below, 8);
      std::memcpy(&upper_[2 * i], texels + above, 8);
    });
  }

  HWY_INLINE Filtered nearest(int i) const {
    const U32 du;
    const auto t = hn::Load(du, lower_ + i);
    const auto mask = hn::Set(du, 0x00ff00ffu);
    return {as_u16(hn::ShiftLeft<8>(hn::And(t, mask))), as_u16(hn::AndNot(mask, t))};
  }

  HWY_INLINE Filtered linear(const Footprint& f, int i) const {
    const auto wx = weight_x(f, i);
    return mix(across(lower_ + 2 * i, wx), across(upper_ + 2 * i, wx), weight_y256(f, i));
  }

 private:
  /// Between the left and the right texels of the pairs.
  static HWY_INLINE Filtered across(const std::uint32_t* pairs, hn::Vec<U16> wx) {
    const U32 du;
    const auto a = hn::Load(du, pairs);
    const auto b = hn::Load(du, pairs + hn::Lanes(du));
    const auto left = hn::ConcatEven(du, b, a);
    const auto right = hn::ConcatOdd(du, b, a);
    const auto wx0 = hn::Sub(hn::Set(U16(), std::uint16_t{256}), wx);
    const auto mask = hn::Set(du, 0x00ff00ffu);
    const auto blend = [&](hn::Vec<U16> l, hn::Vec<U16> r)
                           HWY_ATTR { return hn::Add(hn::Mul(l, wx0), hn::Mul(r, wx)); };
    return {blend(as_u16(hn::And(left, mask)), as_u16(hn::And(right, mask))),
            blend(hn::ShiftRight<8>(as_u16(left)), hn::ShiftRight<8>(as_u16(right)))};
  }

  alignas(64) std::uint32_t lower_[2 * kBatchStride];
  alignas(64) std::uint32_t upper_[2 * kBatchStride];
};

/// Texels of an rgba16 texture for a batch: 64 bits each.
class Texels16 {
 public:
  static constexpr float kScale = 1.0f / 65535.0f;

  void fetch(const std::uint8_t* texels, const Footprint& f, int count, bool linear) {
    for_each_texel<8>(f, count, [&](int i, std::ptrdiff_t below, std::ptrdiff_t above) HWY_ATTR {
      std::memcpy(&corner_[0][2 * i], texels + below, 8);
      if (!linear) return;
      std::memcpy(&corner_[1][2 * i], texels + below + 8, 8);
      std::memcpy(&corner_[2][2 * i], texels + above, 8);
      std::memcpy(&corner_[3][2 * i], texels + above + 8, 8);
    });
  }

  HWY_INLINE Filtered nearest(int i) const { return sorted(words(0, i)); }

  HWY_INLINE Filtered linear(const Footprint& f, int i) const {
    const auto wx = weight_x256(f, i);
    return sorted(
        mix(mix(words(0, i), words(1, i), wx), mix(words(2, i), words(3, i), wx), weight_y256(f, i)));
  }

 private:
  /// As they stand in memory: (red, green) in the first, (blue, alpha) in the second.
  HWY_INLINE Filtered words(int corner, int i) const {
    const U32 du;
    const auto a = hn::Load(du, corner_[corner] + 2 * i);
    const auto b = hn::Load(du, corner_[corner] + 2 * i + hn::Lanes(du));
    return {as_u16(hn::ConcatEven(du, b, a)), as_u16(hn::ConcatOdd(du, b, a))};
  }
  static HWY_INLINE Filtered sorted(const Filtered& f) {
    const auto red_green = as_u32(f.red_blue);
    const auto blue_alpha = as_u32(f.green_alpha);
    const auto low_half = hn::Set(U32(), 0x0000ffffu);
    return {as_u16(hn::Or(hn::And(red_green, low_half), hn::ShiftLeft<16>(blue_alpha))),
            as_u16(hn::Or(hn::ShiftRight<16>(red_green), hn::AndNot(low_half, blue_alpha)))};
  }

  /// Lower left, lower right, upper left, upper right.
  alignas(64) std::uint32_t corner_[4][2 * kBatchStride];
};

/// 16-bit channels to floats in red, green, blue, alpha of the fragments from i on. kModulates: the colours
/// that stand there are multiplied by them (OpenGL 1.3, table 3.22, GL_MODULATE).
template <bool kModulates>
HWY_INLINE void store_texels(const Filtered& f, float scale, float (*colors)[kBatchStride], int i) {
  const F d;
  const I di;
  const auto s = hn::Set(d, scale);
  const auto rb = as_u32(f.red_blue);
  const auto ga = as_u32(f.green_alpha);
  const auto low = hn::Set(U32(), 0xffffu);
  const auto store = [&](hn::Vec<U32> v, float* to) HWY_ATTR {
    const auto texel = hn::Mul(hn::ConvertTo(d, hn::BitCast(di, v)), s);
    hn::Store(kModulates ? hn::Mul(hn::Load(d, to + i), texel) : texel, d, to + i);
  };
  store(hn::And(rb, low), colors[0]);
  store(hn::And(ga, low), colors[1]);
  store(hn::ShiftRight<16>(rb), colors[2]);
  store(hn::ShiftRight<16>(ga), colors[3]);
}

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
