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
  TextureSampler(const FragmentBatch& batch, int unit, const SampleLevels& levels)
      : batch_(batch),
        number_(unit),
        kind_(texcoord_kind(*batch.state, unit)),
        texture_(*batch.state->texture_units[number_].texture),
        levels_(levels) {}

  /// @return texels read.
  template <bool kModulates>
  std::uint64_t sample(float (*colors)[kBatchStride]) {
    const std::uint64_t texels = sum_up_levels();
    find_footprints();
    if (texture_.format() == TexelFormat::rgba8) {
      filter<Texels8, kModulates>(colors);
    } else {
      filter<Texels16, kModulates>(colors);
    }
    return texels;
  }

 private:
  HWY_INLINE Coordinates coordinates(int i) const {
    const F d;
    const int v = batch_.state->varyings.at(Meaning::texcoord, number_);
    const auto s = hn::LoadU(d, batch_.varying[v] + i);
    const auto t = hn::LoadU(d, batch_.varying[v + 1] + i);
    if (kind_ == TexcoordKind::plain) return coordinates_2d(s, t, texture_.options());
    const auto r = hn::LoadU(d, batch_.varying[v + 2] + i);
    if (kind_ == TexcoordKind::direct) return coordinates_cube(s, t, r);
    return coordinates_2d(hn::Div(s, r), hn::Div(t, r), texture_.options());
  }

  /// What the fragments' levels have in common. @return the texels they read.
  std::uint64_t sum_up_levels() {
    const I di;
    const int lanes = static_cast<int>(hn::Lanes(di));
    auto any = hn::Zero(di);
    auto texels = hn::Zero(di);
    for (int i = 0; i < batch_.count; i += lanes) {
      const auto packed =
          hn::IfThenElseZero(lanes_below(di, batch_.count - i), hn::Load(di, levels_.packed + i));
      any = hn::Or(any, packed);
      texels = hn::Add(texels, hn::ShiftRight<kTexelCountShift>(packed));
    }
    const auto has = [&](std::int32_t bits) HWY_ATTR {
      return !hn::AllTrue(di, hn::Eq(hn::And(any, hn::Set(di, bits)), hn::Zero(di)));
    };
    any_linear_ = has(kFourTexels);
    any_blend_ = has(kUpperWeightMask);
    return static_cast<std::uint64_t>(hn::GetLane(hn::SumOfLanes(di, texels)));
  }

  void find_footprints() {
    const I di;
    const TextureOptions& options = texture_.options();
    const bool cube = texture_.is_cube();
    const Borders borders{!cube && options.wrap_s == Wrap::clamp_to_border,
                          !cube && options.wrap_t == Wrap::clamp_to_border};
    LevelShapes shapes(texture_.texel_levels());
    for (int i = 0; i < batch_.count; i += static_cast<int>(hn::Lanes(di))) {
      shapes.look_up(hn::Load(di, levels_.packed + i));
      const Coordinates c = coordinates(i);
      address(c, shapes.lower, shapes, borders, cube, lower_, i);
      if (any_blend_) address(c, shapes.upper, shapes, borders, cube, upper_, i);
    }
  }

  /// Fetches the texels of one or two levels and filters them.
  template <class Texels, bool kModulates>
  void filter(float (*colors)[kBatchStride]) const {
    Texels lower, upper;
    lower.fetch(texture_.data(), lower_, batch_.count, any_linear_);
    if (any_blend_) upper.fetch(texture_.data(), upper_, batch_.count, any_linear_);
    for (int i = 0; i < batch_.count; i += static_cast<int>(hn::Lanes(F()))) {
      Filtered f = any_linear_ ? lower.linear(lower_, i) : lower.nearest(i);
      if (any_blend_) {
        const Filtered above = any_linear_ ? upper.linear(upper_, i) : upper.nearest(i);
        f = mix(f, above, level_weight256(levels_, i));
      }
      store_texels<kModulates>(f, Texels::kScale, colors, i);
    }
  }

  const FragmentBatch& batch_;
  const int number_;
  const TexcoordKind kind_;
  const Texture& texture_;
  const SampleLevels& levels_;
  bool any_linear_ = false;
  bool any_blend_ = false;
  Footprint lower_, upper_;
};

std::uint64_t SampleTexture(const FragmentBatch& batch, int unit, const SampleLevels& levels,
                            float (*texel)[kBatchStride]) {
  return TextureSampler(batch, unit, levels).sample<false>(texel);
}

std::uint64_t ModulateByTexture(FragmentBatch& batch, int unit, const SampleLevels& levels) {
  return TextureSampler(batch, unit, levels).sample<true>(batch.color);
}

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace barrido::raster {

HWY_EXPORT(SampleTexture);
HWY_EXPORT(ModulateByTexture);

std::uint64_t sample_texture(const FragmentBatch& batch, int unit, const SampleLevels& levels,
                             float (*texel)[kBatchStride]) {
  return HWY_DYNAMIC_DISPATCH(SampleTexture)(batch, unit, levels, texel);
}

std::uint64_t modulate_by_texture(FragmentBatch& batch, int unit, const SampleLevels& levels) {
  return HWY_DYNAMIC_DISPATCH(ModulateByTexture)(batch, unit, levels);
}

}  // namespace barrido::raster
#endif
