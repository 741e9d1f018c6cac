// Texture environments: how the texels of a unit and the colours so far make the next colours (OpenGL 1.3,
// tables 3.22 to 3.24). Enters and leaves: the colours of one batch of fragments.
#include "raster/kernels/kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/combine.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/blend-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE Rgba load(const float (*colors)[kBatchStride], int i) {
  const F d;
  return {{hn::Load(d, colors[0] + i), hn::Load(d, colors[1] + i), hn::Load(d, colors[2] + i),
           hn::Load(d, colors[3] + i)}};
}

/// Arguments of GL_COMBINE.
struct CombineInputs {
  Rgba texture, constant, primary, previous;
};

HWY_INLINE V argument(const CombineInputs& in, CombineSource source, CombineOperand operand, int channel) {
  const Rgba& from = source == CombineSource::texture    ? in.texture
                     : source == CombineSource::constant ? in.constant
                     : source == CombineSource::primary  ? in.primary
                                                         : in.previous;
  switch (operand) {
    case CombineOperand::color:
      return from.c[channel];
    case CombineOperand::one_minus_color:
      return hn::Sub(one(), from.c[channel]);
    case CombineOperand::alpha:
      return from.c[3];
    case CombineOperand::one_minus_alpha:
      break;
  }
  return hn::Sub(one(), from.c[3]);
}

HWY_INLINE V combine_channel(const CombineInputs& in, const CombineChannel& c, int channel) {
  const auto a = [&](std::size_t n) HWY_ATTR { return argument(in, c.source[n], c.operand[n], channel); };
  V result = a(0);
  switch (c.function) {
    case CombineFunction::replace:
      break;
    case CombineFunction::modulate:
      result = hn::Mul(result, a(1));
      break;
    case CombineFunction::add:
      result = hn::Add(result, a(1));
      break;
    case CombineFunction::add_signed:
      result = hn::Sub(hn::Add(result, a(1)), hn::Set(F(), 0.5f));
      break;
    case CombineFunction::interpolate: {
      const V weight = a(2);
      result = hn::Add(hn::Mul(result, weight), hn::Mul(a(1), hn::Sub(one(), weight)));
      break;
    }
    case CombineFunction::subtract:
      result = hn::Sub(result, a(1));
      break;
    case CombineFunction::dot3_rgb:  // see combine_all
    case CombineFunction::dot3_rgba:
      break;
  }
  return hn::Mul(result, hn::Set(F(), c.scale));
}

/// 4 ((r₀ − ½)(r₁ − ½) + (g₀ − ½)(g₁ − ½) + (b₀ − ½)(b₁ − ½)) (OpenGL 1.3, table 3.24).
HWY_INLINE V dot3(const CombineInputs& in, const CombineChannel& c) {
  const auto product = [&](int channel) HWY_ATTR {
    const V half = hn::Set(F(), 0.5f);
    return hn::Mul(hn::Sub(argument(in, c.source[0], c.operand[0], channel), half),
                   hn::Sub(argument(in, c.source[1], c.operand[1], channel), half));
  };
  return hn::Mul(hn::Add(hn::Add(product(0), product(1)), product(2)), hn::Set(F(), 4.0f));
}

HWY_INLINE Rgba combine_all(const CombineInputs& in, const CombineState& combine) {
  Rgba out;
  const CombineFunction function = combine.rgb.function;
  const bool to_alpha = function == CombineFunction::dot3_rgba;
  if (to_alpha || function == CombineFunction::dot3_rgb) {
    const V value = dot3(in, combine.rgb);
    out.c[0] = out.c[1] = out.c[2] = hn::Mul(value, hn::Set(F(), combine.rgb.scale));
    out.c[3] =
        to_alpha ? hn::Mul(value, hn::Set(F(), combine.alpha.scale)) : combine_channel(in, combine.alpha, 3);
    return out;
  }
  for (int c = 0; c < 4; ++c) out.c[c] = combine_channel(in, c < 3 ? combine.rgb : combine.alpha, c);
  return out;
}

/// The environments of OpenGL 1.0 and 1.1 for an RGBA texture.
HWY_INLINE Rgba classic(const TextureUnit& unit, const Rgba& p, const Rgba& t) {
  Rgba out = p;
  for (int c = 0; c < 3; ++c) {
    switch (unit.env_mode) {
      case TextureEnvMode::add:
        out.c[c] = hn::Add(p.c[c], t.c[c]);
        break;
      case TextureEnvMode::decal:
        out.c[c] = hn::Add(hn::Mul(p.c[c], hn::Sub(one(), t.c[3])), hn::Mul(t.c[c], t.c[3]));
        break;
      case TextureEnvMode::blend: {
        const V constant = hn::Set(F(), unit.env_color[c]);
        out.c[c] = hn::Add(hn::Mul(p.c[c], hn::Sub(one(), t.c[c])), hn::Mul(constant, t.c[c]));
        break;
      }
      case TextureEnvMode::modulate:  // this one and the next are mostly applied as texels are sampled
        out.c[c] = hn::Mul(p.c[c], t.c[c]);
        break;
      case TextureEnvMode::replace:
      case TextureEnvMode::combine:
        out.c[c] = t.c[c];
        break;
    }
  }
  if (unit.env_mode == TextureEnvMode::replace) {
    out.c[3] = t.c[3];
  } else if (unit.env_mode != TextureEnvMode::decal) {
    out.c[3] = hn::Mul(p.c[3], t.c[3]);
  }
  return out;
}

void CombineTexture(FragmentBatch& batch, int unit_number, const float (*texel)[kBatchStride],
                    const float (*primary)[kBatchStride]) {
  const F d;
  const TextureUnit& unit = batch.state->texture_units[unit_number];
  const bool clamp = batch.state->clamp_colors;
  for (int i = 0; i < batch.count; i += static_cast<int>(hn::Lanes(d))) {
    const Rgba previous = load(batch.color, i);
    const Rgba texture = load(texel, i);
    Rgba out;
    if (unit.env_mode == TextureEnvMode::combine) {
      const auto& k = unit.env_color;
      const Rgba constant{{hn::Set(d, k[0]), hn::Set(d, k[1]), hn::Set(d, k[2]), hn::Set(d, k[3])}};
      out = combine_all({texture, constant, load(primary, i), previous}, unit.combine);
    } else {
      out = classic(unit, previous, texture);
    }
    for (int c = 0; c < 4; ++c) hn::Store(clamp ? clamp01(out.c[c]) : out.c[c], d, batch.color[c] + i);
  }
}

void MultiplySecondary(FragmentBatch& batch, const float (*texel)[kBatchStride]) {
  const F d;
  for (int c = 0; c < 3; ++c) {
    for (int i = 0; i < batch.count; i += static_cast<int>(hn::Lanes(d))) {
      const V product = hn::Mul(hn::Load(d, batch.specular[c] + i), hn::Load(d, texel[c] + i));
      hn::Store(product, d, batch.specular[c] + i);
    }
  }
}

/// `channels` arrays from `from` to `to` (which may be the same), clamped to [0, 1] on the way if asked.
void take_colors(const float (*from)[kBatchStride], float (*to)[kBatchStride], int channels, int count,
                 bool clamp) {
  const F d;
  if (from == to && !clamp) return;
  for (int c = 0; c < channels; ++c) {
    for (int i = 0; i < count; i += static_cast<int>(hn::Lanes(d))) {
      const V value = hn::Load(d, from[c] + i);
      hn::Store(clamp ? clamp01(value) : value, d, to[c] + i);
    }
  }
}

/// Colours of the primitive stand there already, clamped.
void StartColors(const KernelKey& key, FragmentBatch& batch) {
  const FragmentState& state = *batch.state;
  const bool made = is_lit(state);
  const auto take = [&](int varying, float(*to)[kBatchStride], int channels) {
    take_colors(made ? to : batch.varying + varying, to, channels, batch.count, state.clamp_colors);
  };
  if (key.takes_primary && !key.fills_primary) take(state.varyings.at(Meaning::color), batch.color, 4);
  if (state.separate_specular && !key.fills_secondary)
    take(state.varyings.at(Meaning::specular), batch.specular, 3);
}

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace barrido::raster {

HWY_EXPORT(CombineTexture);
HWY_EXPORT(MultiplySecondary);
HWY_EXPORT(StartColors);

void combine_texture(FragmentBatch& batch, int unit, const float (*texel)[kBatchStride],
                     const float (*primary)[kBatchStride]) {
  HWY_DYNAMIC_DISPATCH(CombineTexture)(batch, unit, texel, primary);
}

void multiply_secondary(FragmentBatch& batch, const float (*texel)[kBatchStride]) {
  HWY_DYNAMIC_DISPATCH(MultiplySecondary)(batch, texel);
}

void start_colors(const KernelKey& key, FragmentBatch& batch) {
  HWY_DYNAMIC_DISPATCH(StartColors)(key, batch);
}

}  // namespace barrido::raster
#endif
