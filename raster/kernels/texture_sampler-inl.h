// The usual sample of a texture, of one place a fragment: which texels, their fetch and their filter.
#if defined(BARRIDO_TEXTURE_SAMPLER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BARRIDO_TEXTURE_SAMPLER_INL_H
#undef BARRIDO_TEXTURE_SAMPLER_INL_H
#else
#define BARRIDO_TEXTURE_SAMPLER_INL_H
#endif

#include <hwy/highway.h>

#include "raster/kernels/lanes-inl.h"
#include "raster/kernels/texture_address-inl.h"
#include "raster/kernels/texture_filter-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Where a unit's fragments lie on its texture.
class Places {
 public:
  Places(const FragmentBatch& batch, int unit)
      : batch_(batch),
        kind_(texcoord_kind(*batch.state, unit)),
        varying_(batch.state->varyings.at(Meaning::texcoord, unit)),
        texture_(*batch.state->texture_units[unit].texture) {}

  const Texture& texture() const { return texture_; }
  int count() const { return batch_.count; }

  /// Of the fragments from i on.
  HWY_INLINE Coordinates operator()(int i) const {
    const F d;
    const auto s = hn::LoadU(d, batch_.varying[varying_] + i);
    const auto t = hn::LoadU(d, batch_.varying[varying_ + 1] + i);
    if (kind_ == TexcoordKind::plain) return coordinates_2d(s, t, texture_.options());
    const auto r = hn::LoadU(d, batch_.varying[varying_ + 2] + i);
    if (kind_ == TexcoordKind::direct) return coordinates_cube(s, t, r);
    return coordinates_2d(hn::Div(s, r), hn::Div(t, r), texture_.options());
  }

  /// Before they are wrapped.
  HWY_INLINE Coordinates unwrapped(int i) const {
    const F d;
    auto s = hn::LoadU(d, batch_.varying[varying_] + i);
    auto t = hn::LoadU(d, batch_.varying[varying_ + 1] + i);
    if (kind_ != TexcoordKind::plain) {
      const auto r = hn::LoadU(d, batch_.varying[varying_ + 2] + i);
      if (kind_ == TexcoordKind::direct) return coordinates_cube(s, t, r);
      s = hn::Div(s, r);
      t = hn::Div(t, r);
    }
    return {hn::IfThenElseZero(usable(s), s), hn::IfThenElseZero(usable(t), t), hn::Zero(I())};
  }

 private:
  const FragmentBatch& batch_;
  const TexcoordKind kind_;
  const int varying_;
  const Texture& texture_;
};

/// Samples one place of each fragment of a batch: places(i) are the coordinates from i on.
template <class PlacesOf>
class TextureSampler {
 public:
  TextureSampler(const PlacesOf& places, const Texture& texture, int count, const SampleLevels& levels)
      : places_(places), texture_(texture), count_(count), levels_(levels) {}

  /// Calls store(filtered, scale, i) for the fragments from each i on; `scale` brings them to [0, 1].
  /// @return texels read.
  template <class Store>
  std::uint64_t sample(Store&& store) {
    const std::uint64_t texels = sum_up_levels();
    find_footprints();
    if (texture_.format() == TexelFormat::rgba8) {
      filter<Texels8>(store);
    } else {
      filter<Texels16>(store);
    }
    return texels;
  }

 private:
  /// What the fragments' levels have in common. @return the texels they read.
  std::uint64_t sum_up_levels() {
    const I di;
    const int lanes = static_cast<int>(hn::Lanes(di));
    auto any = hn::Zero(di);
    auto texels = hn::Zero(di);
    for (int i = 0; i < count_; i += lanes) {
      const auto packed = hn::IfThenElseZero(lanes_below(di, count_ - i), hn::Load(di, levels_.packed + i));
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
    for (int i = 0; i < count_; i += static_cast<int>(hn::Lanes(di))) {
      shapes.look_up(hn::Load(di, levels_.packed + i));
      const Coordinates c = places_(i);
      address(c, shapes.lower, shapes, borders, cube, lower_, i);
      if (any_blend_) address(c, shapes.upper, shapes, borders, cube, upper_, i);
    }
  }

  /// Fetches the texels of one or two levels and filters them.
  template <class Texels, class Store>
  void filter(Store&& store) const {
    Texels lower, upper;
    lower.fetch(texture_.data(), lower_, count_, any_linear_);
    if (any_blend_) upper.fetch(texture_.data(), upper_, count_, any_linear_);
    for (int i = 0; i < count_; i += static_cast<int>(hn::Lanes(F()))) {
      Filtered f = any_linear_ ? lower.linear(lower_, i) : lower.nearest(i);
      if (any_blend_) {
        const Filtered above = any_linear_ ? upper.linear(upper_, i) : upper.nearest(i);
        f = mix(f, above, level_weight256(levels_, i));
      }
      store(f, Texels::kScale, i);
    }
  }

  const PlacesOf& places_;
  const Texture& texture_;
  const int count_;
  const SampleLevels& levels_;
  bool any_linear_ = false;
  bool any_blend_ = false;
  Footprint lower_, upper_;
};

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
