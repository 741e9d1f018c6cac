// The end of the fragment's way: secondary colour, fog, alpha test, blending, stores (OpenGL 1.3,
// sections 3.9 to 4.1). Enters: the colours of one batch. Leaves: the tile's pixels.
#include "raster/kernels/kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/write.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/blend-inl.h"
#include "raster/kernels/depth-inl.h"
#include "raster/kernels/lanes-inl.h"
#include "raster/kernels/simd_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using M = hn::Mask<F>;

void AddSecondary(FragmentBatch& batch) {
  const F d;
  for (int c = 0; c < 3; ++c) {
    for (int i = 0; i < batch.count; i += static_cast<int>(hn::Lanes(d))) {
      const V sum = hn::Add(hn::Load(d, batch.color[c] + i), hn::Load(d, batch.specular[c] + i));
      hn::Store(batch.state->clamp_colors ? clamp01(sum) : sum, d, batch.color[c] + i);
    }
  }
}

HWY_INLINE V fog_factor(const FogState& fog, V distance) {
  constexpr float kLog2E = 1.44269504f;
  const F d;
  V f = one();
  switch (fog.mode) {
    case FogMode::linear:
      f = hn::Mul(hn::Sub(hn::Set(d, fog.end), distance), hn::Set(d, 1.0f / (fog.end - fog.start)));
      break;
    case FogMode::exp:
      f = Exp2(d, hn::Mul(hn::Set(d, -fog.density * kLog2E), distance));
      break;
    case FogMode::exp2: {
      const V t = hn::Mul(hn::Set(d, fog.density), distance);
      f = Exp2(d, hn::Mul(hn::Mul(t, t), hn::Set(d, -kLog2E)));
      break;
    }
  }
  return clamp01(f);
}

void ApplyFog(FragmentBatch& batch) {
  const F d;
  const FogState& fog = batch.state->fog;
  const float* distances = batch.varying[batch.state->varyings.at(Meaning::fog)];
  for (int i = 0; i < batch.count; i += static_cast<int>(hn::Lanes(d))) {
    const V f = fog_factor(fog, hn::Abs(hn::LoadU(d, distances + i)));
    for (int c = 0; c < 3; ++c) {
      const V fog_part = hn::Mul(hn::Sub(one(), f), hn::Set(d, fog.color[c]));
      hn::Store(hn::Add(hn::Mul(f, hn::Load(d, batch.color[c] + i)), fog_part), d, batch.color[c] + i);
    }
  }
}

/// ColorFormat::rgba8: rows of packed pixels.
struct ByteColors {
  std::int32_t* pixels;
  explicit ByteColors(TileSurface& s) : pixels(reinterpret_cast<std::int32_t*>(s.color8)) {}

  HWY_INLINE Rgba read(int at) const { return unpack8(hn::LoadU(hn::RebindToSigned<F>(), pixels + at)); }
  /// `is_unit`: the colours need no clamping.
  HWY_INLINE void write(const Rgba& color, bool is_unit, M mask, const std::array<bool, 4>& channels,
                        int at) const {
    const hn::RebindToSigned<F> di;
    auto packed = is_unit ? pack8_unit(color) : pack8(color);
    if (!all_channels(channels)) {
      std::uint32_t keep = 0;
      for (std::size_t c = 0; c < 4; ++c) keep |= channels[c] ? 0u : 0xffu << (8 * c);
      const auto kept = hn::Set(di, static_cast<std::int32_t>(keep));
      packed = hn::Or(hn::AndNot(kept, packed), hn::And(kept, hn::LoadU(di, pixels + at)));
    }
    hn::BlendedStore(packed, hn::RebindMask(di, mask), di, pixels + at);
  }
  static constexpr bool kClampsSource = true;
};

/// ColorFormat::rgba32f: one plane a channel.
struct FloatColors {
  float (*planes)[kTilePixels + kSurfacePadding];
  explicit FloatColors(TileSurface& s) : planes(s.color_float) {}

  HWY_INLINE Rgba read(int at) const {
    const F d;
    return {{hn::LoadU(d, planes[0] + at), hn::LoadU(d, planes[1] + at), hn::LoadU(d, planes[2] + at),
             hn::LoadU(d, planes[3] + at)}};
  }
  HWY_INLINE void write(const Rgba& color, bool, M mask, const std::array<bool, 4>& channels, int at) const {
    for (int c = 0; c < 4; ++c) {
      if (channels[c]) hn::BlendedStore(color.c[c], mask, F(), planes[c] + at);
    }
  }
  static constexpr bool kClampsSource = false;
};

/// The pixels whose fragments, from i on, pass the alpha test; those write their depth, which was left open
/// until now.
HWY_INLINE M alpha_test(const FragmentBatch& batch, const CompareRule& rule, bool late_depth, int i, M mask,
                        float* depth) {
  const F d;
  const V reference = hn::Set(d, batch.state->alpha_test.reference);
  mask = hn::And(mask, rule(hn::LoadU(d, batch.color[3] + i), reference));
  if (late_depth) hn::BlendedStore(hn::LoadU(d, batch.depth + i), mask, d, depth);
  return mask;
}

template <class Colors, class Blend>
void store_runs(const KernelKey& key, const FragmentBatch& batch, TileSurface& tile) {
  const F d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const FragmentState& state = *batch.state;
  const Colors stored(tile);
  const Blend blend(state.blend);
  const CompareRule alpha_rule(state.alpha_test.compare);
  const bool clamp_source = Colors::kClampsSource && !key.unit_colors;
  const bool writes_unit = (Blend::kReads || !clamp_source) && blend.keeps_unit;
  for (int r = 0; r < batch.run_count; ++r) {
    const FragmentRun& run = batch.runs[r];
    const int pixel = run.y * kTileWidth + run.x;
    for (int i = run.begin; i < run.end; i += lanes) {
      const int at = pixel + (i - run.begin);
      M mask = lanes_below(d, run.end - i);
      if (state.alpha_test.enabled) {
        mask = alpha_test(batch, alpha_rule, key.late_depth, i, mask, tile.depth + at);
      }
      Rgba color{{hn::LoadU(d, batch.color[0] + i), hn::LoadU(d, batch.color[1] + i),
                  hn::LoadU(d, batch.color[2] + i), hn::LoadU(d, batch.color[3] + i)}};
      if constexpr (Blend::kReads) {
        if (clamp_source) {
          for (V& c : color.c) c = clamp01(c);
        }
        color = blend(color, stored.read(at));
      }
      stored.write(color, writes_unit, mask, state.color_mask, at);
    }
  }
}

/// Opaque fragments on the 8-bit surface: the whole batch is packed in full vectors, then copied run by run.
void store_opaque8(const KernelKey& key, const FragmentBatch& batch, TileSurface& tile) {
  const F d;
  const hn::RebindToSigned<F> di;
  const int lanes = static_cast<int>(hn::Lanes(d));
  alignas(64) std::int32_t packed[kBatchStride];
  for (int i = 0; i < batch.count; i += lanes) {
    const Rgba color{{hn::Load(d, batch.color[0] + i), hn::Load(d, batch.color[1] + i),
                      hn::Load(d, batch.color[2] + i), hn::Load(d, batch.color[3] + i)}};
    hn::Store(key.unit_colors ? pack8_unit(color) : pack8(color), di, packed + i);
  }
  auto* pixels = reinterpret_cast<std::int32_t*>(tile.color8);
  for (int r = 0; r < batch.run_count; ++r) {
    const FragmentRun& run = batch.runs[r];
    std::int32_t* to = pixels + run.y * kTileWidth + run.x - run.begin;
    for (int i = run.begin; i < run.end; i += lanes) {
      hn::BlendedStore(hn::LoadU(di, packed + i), lanes_below(di, run.end - i), di, to + i);
    }
  }
}

template <class Colors>
void store_batch(const KernelKey& key, const FragmentBatch& batch, TileSurface& tile) {
  switch (key.blending) {
    case Blending::replace:
      return store_runs<Colors, Replace>(key, batch, tile);
    case Blending::constant:
      return store_runs<Colors, BlendConstant>(key, batch, tile);
    case Blending::source_alpha:
      return store_runs<Colors, BlendSourceAlpha>(key, batch, tile);
    case Blending::general:
      break;
  }
  store_runs<Colors, BlendGeneral>(key, batch, tile);
}

void WriteFragments(const KernelKey& key, FragmentBatch& batch, TileSurface& surface) {
  if (key.surface == ColorFormat::rgba32f) return store_batch<FloatColors>(key, batch, surface);
  if (key.hides) return store_opaque8(key, batch, surface);
  store_batch<ByteColors>(key, batch, surface);
}

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace barrido::raster {

HWY_EXPORT(AddSecondary);
HWY_EXPORT(ApplyFog);
HWY_EXPORT(WriteFragments);

void add_secondary(FragmentBatch& batch) { HWY_DYNAMIC_DISPATCH(AddSecondary)(batch); }

void apply_fog(FragmentBatch& batch) { HWY_DYNAMIC_DISPATCH(ApplyFog)(batch); }

void write_fragments(const KernelKey& key, FragmentBatch& batch, TileSurface& surface) {
  HWY_DYNAMIC_DISPATCH(WriteFragments)(key, batch, surface);
}

}  // namespace barrido::raster
#endif
