// Resolve (raster/tiles/resolve.h): what is shown of float pixels, a vector at a time. Enters: a row of
// pixels. Leaves: packed bytes. The same operations as in raster/reference/resolve.cpp, so the same bits.
#include "raster/kernels/kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/resolve.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/blend-inl.h"
#include "raster/kernels/simd_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE V exposed(V c, float scale) { return hn::Mul(c, hn::Set(F(), scale)); }

/// In [0, 1].
HWY_INLINE V tone_mapped(V c, ToneMap map) {
  if (map == ToneMap::reinhard) {
    c = maximum(c, hn::Zero(F()));
    c = hn::Div(c, hn::Add(one(), c));
  }
  return clamp01(c);
}

/// The transfer function of IEC 61966-2-1.
HWY_INLINE V srgb_encoded(V c) {
  const F d;
  const V power = Pow(d, c, 1.0f / 2.4f);
  const V curve = hn::Sub(hn::Mul(hn::Set(d, 1.055f), power), hn::Set(d, 0.055f));
  return hn::IfThenElse(hn::Le(c, hn::Set(d, 0.0031308f)), hn::Mul(c, hn::Set(d, 12.92f)), curve);
}

void DisplayRow(const PixelRow& pixels, const DisplayTransform& display, std::uint32_t* out) {
  const F d;
  for (int i = 0; i < pixels.count; i += static_cast<int>(hn::Lanes(d))) {
    Rgba shown;
    for (int c = 0; c < 3; ++c) {
      const V exposure = exposed(hn::Load(d, pixels.channel[c] + i), display.exposure_scale);
      const V mapped = tone_mapped(exposure, display.tone_map);
      shown.c[c] = display.srgb_encode ? srgb_encoded(mapped) : mapped;
    }
    shown.c[3] = hn::Load(d, pixels.channel[3] + i);
    hn::Store(pack8(shown), hn::RebindToSigned<F>(), reinterpret_cast<std::int32_t*>(out) + i);
  }
}

/// Interleaved, for who wants the numbers themselves.
void StoreFloatRow(const PixelRow& pixels, float* out) {
  const F d;
  const auto& from = pixels.channel;
  const int lanes = static_cast<int>(hn::Lanes(d));
  int i = 0;
  for (; i + lanes <= pixels.count; i += lanes) {
    hn::StoreInterleaved4(hn::Load(d, from[0] + i), hn::Load(d, from[1] + i), hn::Load(d, from[2] + i),
                          hn::Load(d, from[3] + i), d, out + 4 * i);
  }
  for (; i < pixels.count; ++i) {
    for (int c = 0; c < 4; ++c) out[4 * i + c] = from[c][i];
  }
}

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace barrido::raster {

HWY_EXPORT(DisplayRow);
HWY_EXPORT(StoreFloatRow);

void display_row(const PixelRow& pixels, const DisplayTransform& display, std::uint32_t* out) {
  HWY_DYNAMIC_DISPATCH(DisplayRow)(pixels, display, out);
}

void store_float_row(const PixelRow& pixels, float* out) { HWY_DYNAMIC_DISPATCH(StoreFloatRow)(pixels, out); }

}  // namespace barrido::raster
#endif
