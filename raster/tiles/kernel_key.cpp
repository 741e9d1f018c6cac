#include "raster/tiles/kernel_key.h"

namespace barrido::raster {
namespace {

/// Whether the stages make nothing of the colours that vertices or primitives have, but their sum.
bool keeps_colors(const FragmentState& state) {
  for (const FragmentStage& stage : state.stages) {
    if (stage.kind != &kTakeColors && stage.kind != &kAddSecondary) return false;
  }
  return true;
}

/// Whether the primary colour reaches no result, because the first texture takes its place.
bool primary_is_replaced(const FragmentState& state) {
  const TextureUnit* first = nullptr;
  for (const FragmentStage& stage : state.stages) {
    if (stage.kind != &kApplyTexture) continue;
    const TextureUnit& unit = state.texture_units[static_cast<std::size_t>(stage.unit)];
    if (unit.env_mode == TextureEnvMode::combine) return false;
    if (first == nullptr) first = &unit;
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
  if (surface != ColorFormat::rgba8 || !keeps_colors(state) || state.alpha_test.enabled || state.sorted ||
      !all_channels(state.color_mask)) {
    return ColorWay::batch;
  }
  const bool is_flat = !state.varyings.has(Meaning::color) &&
                       (!state.varyings.has(Meaning::specular) || !state.separate_specular);
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

KernelKey make_kernel_key(const FragmentState& state, ColorFormat surface, bool by_batches) {
  KernelKey key;
  key.surface = surface;
  key.blending = blending_of(state.blend);
  key.sorted = state.sorted;
  key.colors = by_batches ? ColorWay::batch : color_way(state, surface, key.blending);
  key.depth = depth_test(state);
  key.late_depth = state.alpha_test.enabled && state.depth.test && state.depth.write;
  key.hides = is_opaque(state);
  key.small = small_triangles(state, key);
  if (key.colors != ColorWay::batch) {
    key.divides_color =
        key.colors == ColorWay::smooth && state.varyings.at(Meaning::color) >= state.varyings.affine_count;
    return key;
  }
  const bool lit = is_lit(state);
  key.takes_primary = !primary_is_replaced(state);
  key.fills_primary = !lit && !state.varyings.has(Meaning::color) && key.takes_primary;
  key.fills_secondary = !lit && !state.varyings.has(Meaning::specular) && state.separate_specular;
  key.unit_colors = state.clamp_colors && state.stages.back().kind->clamps;
  for (int unit = 0; unit < kMaxTextureUnits; ++unit) {
    if (!is_active(state, unit)) continue;
    const TextureUnit& texture = state.texture_units[unit];
    if (texture.procedure != nullptr || needs_lod(texture)) key.lod_units |= 1u << unit;
  }
  return key;
}

}  // namespace barrido::raster
