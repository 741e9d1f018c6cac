// Shading without a detour, ColorWay::flat and ColorWay::smooth: colours that need neither textures nor
// illumination per fragment nor fog go from the span's planes straight to the 8-bit surface. The same
// operations as the batch's stages (shade_batch.cpp), so the same bits; what is saved is their way through
// memory, which costs more than the arithmetic.
#if defined(BARRIDO_DIRECT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BARRIDO_DIRECT_INL_H
#undef BARRIDO_DIRECT_INL_H
#else
#define BARRIDO_DIRECT_INL_H
#endif

#include <hwy/highway.h>

#include "raster/kernels/blend-inl.h"
#include "raster/kernels/depth-inl.h"
#include "raster/kernels/interpolate-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Pixels = std::int32_t*;  ///< A row of the surface, packed 8-bit colours.

/// One colour for all pixels of a primitive.
class FlatPixels {
 public:
  explicit FlatPixels(const float* color) : packed_(pack8(one_color(color))) {}

  HWY_INLINE void operator()(Pixels row, int x, hn::Mask<F> mask, V) const {
    const hn::RebindToSigned<F> di;
    hn::BlendedStore(packed_, hn::RebindMask(di, mask), di, row + x);
  }

 private:
  hn::Vec<hn::RebindToSigned<F>> packed_;
};

/// Whether the colours of a span that divides by no q need clamping in columns [begin, end): linear functions
/// are monotonic in floating point, too, so the ends decide.
HWY_INLINE bool colors_are_unit(const InterpolatedSpan& span, int color, int begin, int end) {
  const hn::FixedTag<float, 4> d;
  const auto row = hn::LoadU(d, span.row + color);
  const auto slope = hn::LoadU(d, span.planes->slope_x + color);
  const auto is_unit_at = [&](int x) HWY_ATTR {
    const auto c = hn::Add(row, hn::Mul(slope, hn::Set(d, static_cast<float>(x - span.anchor))));
    return hn::And(hn::Ge(c, hn::Zero(d)), hn::Le(c, hn::Set(d, 1.0f)));
  };
  return hn::AllTrue(d, hn::And(is_unit_at(begin), is_unit_at(end - 1)));
}

/// Interpolated colours of one span, blended with what is there unless Blend is Replace. kIsUnit: they are in
/// [0, 1] before they are blended, and divided by no q. kOneAlpha: so are they, and alpha does not change.
template <class Blend, bool kIsUnit, bool kOneAlpha>
class SmoothPixels {
 public:
  /// `color`: the first of the four quantities.
  SmoothPixels(const InterpolatedSpan& span, int color, bool divides, const Blend& blend)
      : span_(span), blend_(blend), color_(color), divides_(divides) {}

  /// The vector of pixels from column x on, which are `k` columns from the anchor.
  HWY_INLINE void operator()(Pixels row, int x, hn::Mask<F> mask, V k) const {
    const F d;
    const hn::RebindToSigned<F> di;
    const auto linear = [&](int quantity) HWY_ATTR {
      return hn::Add(hn::Set(d, span_.row[quantity]),
                     hn::Mul(hn::Set(d, span_.planes->slope_x[quantity]), k));
    };
    Rgba color{{linear(color_), linear(color_ + 1), linear(color_ + 2),
                kOneAlpha ? hn::Set(d, span_.row[color_ + 3]) : linear(color_ + 3)}};
    if (!kIsUnit && divides_) {
      const V w = inverse_q(linear(kRecordQ));
      for (V& c : color.c) c = hn::Mul(c, w);
    }
    if constexpr (Blend::kReads) {
      if constexpr (!kIsUnit) {
        for (V& c : color.c) c = clamp01(c);
      }
      color = blend_(color, unpack8(hn::LoadU(di, row + x)));
    }
    const auto packed = (kIsUnit || Blend::kReads) && blend_.keeps_unit ? pack8_unit(color) : pack8(color);
    hn::BlendedStore(packed, hn::RebindMask(di, mask), di, row + x);
  }

 private:
  const InterpolatedSpan& span_;
  const Blend& blend_;
  const int color_;
  const bool divides_;
};

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
