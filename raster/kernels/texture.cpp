// The texture unit: from coordinates and level of detail to filtered texels, for one batch of fragments.
#include "raster/kernels/kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/texture.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/lanes-inl.h"
#include "raster/kernels/texture_address-inl.h"
#include "raster/kernels/texture_filter-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

class TextureSampler {
 public:
  TextureSampler(const FragmentBatch& batch, int unit)
      : batch_(batch),
        number_(static_cast<std::size_t>(unit)),
        unit_(batch.state->texture_units[number_]),
        texture_(*unit_.texture),
        choice_(level_choice(unit_)) {}

  std::uint64_t sample(float (*texel)[kBatchStride]) {
    find_footprints();
    if (texture_.format() == TexelFormat::rgba8) {
      filter<Texels8>(texel);
    } else {
      filter<Texels16>(texel);
    }
    return texels_;
  }

 private:
  HWY_INLINE Coordinates coordinates(int i) const {
    const F d;
    const int v = batch_.state->varyings.texcoord[number_];
    const auto s = hn::LoadU(d, batch_.varying[v] + i);
    const auto t = hn::LoadU(d, batch_.varying[v + 1] + i);
    const TexcoordKind kind = batch_.state->varyings.texcoord_kind[number_];
    if (kind == TexcoordKind::plain) return coordinates_2d(s, t, texture_.options());
    const auto r = hn::LoadU(d, batch_.varying[v + 2] + i);
    if (kind == TexcoordKind::cube) return coordinates_cube(s, t, r);
    return coordinates_2d(hn::Div(s, r), hn::Div(t, r), texture_.options());
  }

  void find_footprints() {
    const F d;
    const I di;
    const bool lod_matters =
        choice_.mip_linear || choice_.mip_nearest || choice_.min_linear != choice_.mag_linear;
    const auto bias = hn::Set(d, unit_.lod_bias);
    auto texels = hn::Zero(di);
    for (int i = 0; i < batch_.count; i += static_cast<int>(hn::Lanes(d))) {
      const auto lod = lod_matters ? hn::Add(hn::LoadU(d, batch_.lod[number_] + i), bias) : hn::Zero(d);
      const Levels levels = choose_levels(lod, choice_, texture_.level_count() - 1);
      const Coordinates c = coordinates(i);
      address(c, levels.lower, levels.linear, texture_.texel_levels(), texture_.options(), texture_.is_cube(),
              lower_, i);
      any_linear_ = any_linear_ || !hn::AllFalse(di, levels.linear);
      texels = hn::Add(texels, count_texels(levels, batch_.count - i));
      if (!choice_.mip_linear) continue;
      address(c, levels.upper, levels.linear, texture_.texel_levels(), texture_.options(), texture_.is_cube(),
              upper_, i);
      hn::Store(levels.weight, di, level_weight_ + i);
      any_blend_ = any_blend_ || !hn::AllTrue(di, hn::Eq(levels.weight, hn::Zero(di)));
    }
    texels_ = static_cast<std::uint64_t>(hn::GetLane(hn::SumOfLanes(di, texels)));
  }

  /// Fetches the texels of one or two levels and filters them.
  template <class Texels>
  void filter(float (*texel)[kBatchStride]) const {
    Texels lower, upper;
    lower.fetch(texture_.data(), lower_, batch_.count, any_linear_);
    if (any_blend_) upper.fetch(texture_.data(), upper_, batch_.count, any_linear_);
    for (int i = 0; i < batch_.count; i += static_cast<int>(hn::Lanes(F()))) {
      Filtered f = any_linear_ ? lower.linear(lower_, i) : lower.nearest(i);
      if (any_blend_) {
        const Filtered above = any_linear_ ? upper.linear(upper_, i) : upper.nearest(i);
        f = mix(f, above, load_weights(level_weight_, i));
      }
      store_texels(f, Texels::kScale, texel, i);
    }
  }

  /// One or four texels a level, one or two levels, for the fragments among the next `fragments`.
  HWY_INLINE VI count_texels(const Levels& levels, int fragments) const {
    const I di;
    const auto one_level = hn::IfThenElse(levels.linear, hn::Set(di, 4), hn::Set(di, 1));
    const auto two = hn::Gt(levels.weight, hn::Zero(di));
    const auto texels = hn::Add(one_level, hn::IfThenElseZero(two, one_level));
    return hn::IfThenElseZero(barrido::HWY_NAMESPACE::lanes_below(di, fragments), texels);
  }

  const FragmentBatch& batch_;
  const std::size_t number_;
  const TextureUnit& unit_;
  const Texture& texture_;
  const LevelChoice choice_;
  std::uint64_t texels_ = 0;
  bool any_linear_ = false;
  bool any_blend_ = false;
  Footprint lower_, upper_;
  alignas(64) std::int32_t level_weight_[kBatchStride];
};

std::uint64_t SampleTexture(const FragmentBatch& batch, int unit, float (*texel)[kBatchStride]) {
  return TextureSampler(batch, unit).sample(texel);
}

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace barrido::raster {

HWY_EXPORT(SampleTexture);

std::uint64_t sample_texture(const FragmentBatch& batch, int unit, float (*texel)[kBatchStride]) {
  return HWY_DYNAMIC_DISPATCH(SampleTexture)(batch, unit, texel);
}

}  // namespace barrido::raster
#endif
