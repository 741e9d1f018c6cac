// Resolve (raster/tiles/resolve.h): from samples to pixels and from float pixels to what is shown of them, a
// vector at a time. Enters: tiles drawn for one sample, rows of pixels. Leaves: pixels, packed bytes. The
// same operations as in raster/reference/resolve.cpp, so the same bits.
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

/// What is shown of a colour, not rounded; alpha as it is.
HWY_INLINE Rgba displayed(const Rgba& color, const DisplayTransform& display) {
  Rgba shown = color;
  for (int c = 0; c < 3; ++c) {
    const V mapped = tone_mapped(exposed(color.c[c], display.exposure_scale), display.tone_map);
    shown.c[c] = display.srgb_encode ? srgb_encoded(mapped) : mapped;
  }
  return shown;
}

HWY_INLINE Rgba sample_at(const TileSurface& tile, int at) {
  const F d;
  if (tile.format == ColorFormat::rgba8) {
    return unpack8(
        hn::Load(hn::RebindToSigned<F>(), reinterpret_cast<const std::int32_t*>(tile.color8) + at));
  }
  return {{hn::Load(d, tile.color_float[0] + at), hn::Load(d, tile.color_float[1] + at),
           hn::Load(d, tile.color_float[2] + at), hn::Load(d, tile.color_float[3] + at)}};
}

/// Colours of samples multiplied by their alpha, and that.
HWY_INLINE Rgba premultiplied(Rgba color, V depth, const SampleSettings& settings) {
  const F d;
  if (settings.alpha == SampleAlpha::opaque) {
    color.c[3] = one();
  } else if (settings.alpha == SampleAlpha::straight) {
    for (int c = 0; c < 3; ++c) color.c[c] = hn::Mul(color.c[c], color.c[3]);
  } else {
    const auto is_opaque = hn::Lt(depth, hn::Set(d, settings.background_depth));
    color.c[3] = hn::IfThenElse(is_opaque, one(), color.c[3]);
  }
  return color;
}

/// Of straight colours what is shown, of blended ones what is shown of the straight colours they stand for.
HWY_INLINE Rgba shown_sample(Rgba color, const SampleSettings& settings, const DisplayTransform& display) {
  if (settings.alpha != SampleAlpha::blended) return displayed(color, display);
  const V alpha = color.c[3];
  const auto divides = hn::And(hn::Gt(alpha, hn::Zero(F())), hn::Lt(alpha, one()));
  for (int c = 0; c < 3; ++c) {
    color.c[c] = hn::IfThenElse(divides, hn::Div(color.c[c], alpha), color.c[c]);
  }
  color = displayed(color, display);
  for (int c = 0; c < 3; ++c) {
    color.c[c] = hn::IfThenElse(divides, hn::Mul(color.c[c], alpha), color.c[c]);
  }
  return color;
}

void AddSample(const TileSurface& tile, const TileJob& job, const SampleSettings& settings, float weight,
               const float* weights, const DisplayTransform& display, TileSums& sums) {
  const F d;
  const bool shows = settings.order == FilterOrder::display && tile.format == ColorFormat::rgba32f;
  const int width = job.width;
  for (int row = 0; row < job.height; ++row) {
    for (int i = 0; i < width; i += static_cast<int>(hn::Lanes(d))) {
      const int at = row * kTileWidth + i;
      const V depth = hn::Load(d, tile.depth + at);
      // Alpha first: what is shown of a blended colour depends on it.
      Rgba color = sample_at(tile, at);
      if (settings.alpha == SampleAlpha::blended) color = premultiplied(color, depth, settings);
      if (shows) color = shown_sample(color, settings, display);
      if (settings.alpha != SampleAlpha::blended) color = premultiplied(color, depth, settings);
      const V share = weights == nullptr ? hn::Set(d, weight) : hn::Load(d, weights + at);
      const auto add = [&](V value, float* sum)
                           HWY_ATTR { hn::Store(hn::Add(hn::Load(d, sum), value), d, sum); };
      for (int c = 0; c < 4; ++c) add(hn::Mul(color.c[c], share), sums.color[c] + at);
      if (weights != nullptr) add(share, sums.weight + at);
      hn::Store(minimum(depth, hn::Load(d, sums.depth + at)), d, sums.depth + at);
    }
  }
}

void ResolveSamples(const TileSums& sums, const TileJob& job, const SampleSettings& settings,
                    TileSurface& tile) {
  const F d;
  const bool is_float = tile.format == ColorFormat::rgba32f;
  const bool is_shown = !is_float || settings.order == FilterOrder::display;
  for (int row = 0; row < job.height; ++row) {
    for (int i = 0; i < job.width; i += static_cast<int>(hn::Lanes(d))) {
      const int at = row * kTileWidth + i;
      const V alpha = hn::Load(d, sums.color[3] + at);
      const auto is_seen = hn::Gt(alpha, hn::Zero(d));
      Rgba color;
      for (int c = 0; c < 3; ++c) {
        color.c[c] = hn::IfThenElse(is_seen, hn::Div(hn::Load(d, sums.color[c] + at), alpha),
                                    hn::Set(d, settings.background[static_cast<std::size_t>(c)]));
      }
      const V total =
          settings.sums_weights() ? hn::Load(d, sums.weight + at) : hn::Set(d, settings.total_weight);
      color.c[3] = clamp01(hn::Div(alpha, total));
      if (is_float) {
        for (int c = 0; c < 4; ++c) hn::Store(color.c[c], d, tile.color_float[c] + at);
      }
      if (is_shown) {
        hn::Store(pack8(color), hn::RebindToSigned<F>(), reinterpret_cast<std::int32_t*>(tile.color8) + at);
      }
      hn::Store(hn::Load(d, sums.depth + at), d, tile.depth + at);
    }
  }
}

void DisplayRow(const PixelRow& pixels, const DisplayTransform& display, std::uint32_t* out) {
  const F d;
  for (int i = 0; i < pixels.count; i += static_cast<int>(hn::Lanes(d))) {
    Rgba color;
    for (int c = 0; c < 4; ++c) color.c[c] = hn::Load(d, pixels.channel[c] + i);
    const Rgba shown = displayed(color, display);
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

HWY_EXPORT(AddSample);
HWY_EXPORT(ResolveSamples);
HWY_EXPORT(DisplayRow);
HWY_EXPORT(StoreFloatRow);

void add_sample(const TileSurface& tile, const TileJob& job, const SampleSettings& settings, float weight,
                const float* weights, const DisplayTransform& display, TileSums& sums) {
  HWY_DYNAMIC_DISPATCH(AddSample)(tile, job, settings, weight, weights, display, sums);
}

void resolve_samples(const TileSums& sums, const TileJob& job, const SampleSettings& settings,
                     TileSurface& tile) {
  HWY_DYNAMIC_DISPATCH(ResolveSamples)(sums, job, settings, tile);
}

void display_row(const PixelRow& pixels, const DisplayTransform& display, std::uint32_t* out) {
  HWY_DYNAMIC_DISPATCH(DisplayRow)(pixels, display, out);
}

void store_float_row(const PixelRow& pixels, float* out) { HWY_DYNAMIC_DISPATCH(StoreFloatRow)(pixels, out); }

}  // namespace barrido::raster
#endif
