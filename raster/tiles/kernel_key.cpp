#include "raster/tiles/kernel_key.h"

namespace barrido::raster {
namespace {

bool is_textured(const FragmentState& state) {
  for (int unit = 0; unit < kMaxTextureUnits; ++unit) {
    if (is_active(state, unit)) return true;
  }
  return false;
}

/// Whether the primary colour reaches no result, because the first texture takes its place.
bool primary_is_replaced(const FragmentState& state) {
  const TextureUnit* first = nullptr;
  for (int unit = kMaxTextureUnits - 1; unit >= 0; --unit) {
    if (!is_active(state, unit)) continue;
    first = &state.texture_units[unit];
    if (first->env_mode == TextureEnvMode::combine) return false;
  }
  return first != nullptr && first->env_mode == TextureEnvMode::replace;
}

/// Whether the factor is the same for all fragments.
bool is_constant(BlendFactor f) {
  return f == BlendFactor::zero || f == BlendFactor::one ||
         (f >= BlendFactor::constant_color && f <= BlendFactor::one_minus_constant_alpha);
}

Blending blending_of(const BlendState& blend) {
  if (!blend.enabled) return Blending::replace;
  if (blend.equation != BlendEquation::add) return Blending::general;
  if (is_constant(blend.src_rgb) && is_constant(blend.dst_rgb) && is_constant(blend.src_alpha) &&
      is_constant(blend.dst_alpha)) {
    return Blending::constant;
  }
  const bool usual = blend.src_rgb == BlendFactor::src_alpha && blend.src_alpha == BlendFactor::src_alpha &&
                     blend.dst_rgb == BlendFactor::one_minus_src_alpha &&
                     blend.dst_alpha == BlendFactor::one_minus_src_alpha;
  return usual ? Blending::source_alpha : Blending::general;
}

ColorWay color_way(const FragmentState& state, ColorFormat surface, Blending blending) {
  if (surface != ColorFormat::rgba8 || is_textured(state) || state.illumination.function != nullptr ||
      state.fog.enabled || state.alpha_test.enabled || !all_channels(state.color_mask)) {
    return ColorWay::batch;
  }
  const bool is_flat =
      state.varyings.color == kAbsent && (state.varyings.specular == kAbsent || !state.separate_specular);
  if (is_flat) return blending == Blending::replace ? ColorWay::flat : ColorWay::batch;
  return state.separate_specular || blending == Blending::general ? ColorWay::batch : ColorWay::smooth;
}

DepthTest depth_test(const FragmentState& state) {
  const DepthState& depth = state.depth;
  if (!depth.test) return DepthTest::off;
  if (!depth.write || state.alpha_test.enabled) return DepthTest::any;
  if (depth.compare == Compare::less) return DepthTest::less;
  return depth.compare == Compare::less_equal ? DepthTest::less_equal : DepthTest::any;
}

SmallTriangles small_triangles(const FragmentState& state, const KernelKey& key) {
  if (key.colors == ColorWay::batch || key.blending != Blending::replace) return SmallTriangles::spans;
  const bool fits = record_stride(state.varyings.count) == kTinyQuantities && !state.polygon_offset.enabled;
  return fits && key.depth == DepthTest::less ? SmallTriangles::lists : SmallTriangles::blocks;
}

}  // namespace

KernelKey make_kernel_key(const FragmentState& state, ColorFormat surface) {
  KernelKey key;
  key.surface = surface;
  key.blending = blending_of(state.blend);
  key.colors = color_way(state, surface, key.blending);
  key.depth = depth_test(state);
  key.late_depth = state.alpha_test.enabled && state.depth.test && state.depth.write;
  key.hides = is_opaque(state);
  key.small = small_triangles(state, key);
  if (key.colors != ColorWay::batch) {
    key.divides_color = key.colors == ColorWay::smooth && state.varyings.color >= state.varyings.affine_count;
    return key;
  }
  const bool is_lit = state.illumination.function != nullptr;
  key.takes_primary = !primary_is_replaced(state);
  key.fills_primary = !is_lit && state.varyings.color == kAbsent && key.takes_primary;
  key.fills_secondary = !is_lit && state.varyings.specular == kAbsent && state.separate_specular;
  key.unit_colors = state.clamp_colors && !state.fog.enabled;
  for (int unit = 0; unit < kMaxTextureUnits; ++unit) {
    if (is_active(state, unit) && needs_lod(state.texture_units[unit])) key.lod_units |= 1u << unit;
  }
  return key;
}

}  // namespace barrido::raster
