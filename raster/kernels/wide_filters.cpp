// Filters that follow the shape of the pixel's footprint on the texture (docs/arithmetic.md, "Footprints"):
// samples along its longer side or at its corners, and the mean of all texels under it.
#include "raster/kernels/kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/wide_filters.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/footprint_mean-inl.h"
#include "raster/kernels/level_of_detail-inl.h"
#include "raster/kernels/texture_sampler-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// What the filter reads for a group of four pixels.
struct GroupFilter {
  VI levels;     ///< Packed
  VI samples;    ///< 0: the mean of the footprint
  VI sum_level;  ///< Whose texels are summed
  Slopes slopes;
};

HWY_INLINE Slopes where(hn::Mask<F> mask, const Slopes& s) {
  return {hn::IfThenElseZero(mask, s.ux), hn::IfThenElseZero(mask, s.uy), hn::IfThenElseZero(mask, s.vx),
          hn::IfThenElseZero(mask, s.vy)};
}

/// EXT_texture_filter_anisotropic: N = min(⌈Pmax/Pmin⌉, most) samples along the longer side, of the levels
/// for λ' = log2(Pmax/N).
HWY_INLINE GroupFilter anisotropic(const TextureUnit& unit, const Slopes& slopes,
                                   const FootprintSides& sides) {
  const F d;
  const auto zero = hn::Zero(d);
  const auto most = sides.larger();
  const auto ratio = hn::Ceil(hn::Sqrt(hn::Div(most, minimum(sides.along_x, sides.along_y))));
  const auto n =
      maximum(minimum(ratio, hn::Set(d, static_cast<float>(unit.max_anisotropy))), hn::Set(d, 1.0f));
  const auto lod = hn::Mul(hn::Set(d, 0.5f), Log2(d, hn::Div(most, hn::Mul(n, n))));
  const auto along_x = hn::Gt(sides.along_x, sides.along_y);
  return {choose_levels(hn::Add(lod, hn::Set(d, unit.lod_bias)), unit_filters(unit),
                        unit.texture->level_count() - 1),
          whole_to_integer(d, n),
          hn::Zero(I()),
          {hn::IfThenElse(along_x, slopes.ux, slopes.uy), zero, hn::IfThenElse(along_x, slopes.vx, slopes.vy),
           zero}};
}

/// One sample where the texture is magnified, else the four corners or the footprint.
HWY_INLINE GroupFilter whole_footprint(const TextureUnit& unit, const Slopes& slopes,
                                       const FootprintSides& sides) {
  const F d;
  const I di;
  const UnitFilters filters = unit_filters(unit);
  const auto lod = hn::Add(lod_of(sides), hn::Set(d, unit.lod_bias));
  const auto magnified = hn::Le(lod, hn::Set(d, filters.magnification_limit));
  const bool sums = unit.min_filter == MinFilter::footprint;
  return {choose_levels(lod, filters, unit.texture->level_count() - 1),
          hn::IfThenElse(hn::RebindMask(di, magnified), hn::Set(di, 1), hn::Set(di, sums ? 0 : 4)),
          summed_levels(slopes, *unit.texture), sums ? slopes : where(hn::Not(magnified), slopes)};
}

/// The filters of a batch's fragments.
struct WideFilters {
  SampleLevels levels;
  alignas(64) std::int32_t samples[kBatchStride];
  FootprintShapes shapes;
  int most_samples = 0;
  bool any_sum = false;
};

class WideSampler {
 public:
  WideSampler(const FragmentBatch& batch, int unit)
      : batch_(batch),
        number_(unit),
        unit_(batch.state->texture_units[unit]),
        texture_(*unit_.texture),
        places_(batch, unit) {}

  std::uint64_t sample(const LodGroups& groups, int group_count, float (*texel)[kBatchStride]) {
    find_filters(groups, group_count);
    std::uint64_t texels = 0;
    if (filters_.most_samples > 0) texels += sample_probes(texel);
    if (filters_.any_sum) texels += sum_footprints(texel);
    return texels;
  }

 private:
  void find_filters(const LodGroups& groups, int group_count) {
    const I di;
    constexpr int kArrays = 7;
    alignas(64) std::int32_t of_group[kArrays][kBatchStride];
    const bool corners_or_mean =
        unit_.min_filter == MinFilter::footprint || unit_.min_filter == MinFilter::corners;
    for (int g = 0; g < group_count; g += static_cast<int>(hn::Lanes(di))) {
      const Slopes slopes = slopes_of_groups(groups, *batch_.state, number_, g);
      const FootprintSides sides = footprint_sides(slopes, texture_);
      const GroupFilter filter =
          corners_or_mean ? whole_footprint(unit_, slopes, sides) : anisotropic(unit_, slopes, sides);
      const VI values[kArrays] = {filter.levels,
                                  filter.samples,
                                  filter.sum_level,
                                  hn::BitCast(di, filter.slopes.ux),
                                  hn::BitCast(di, filter.slopes.uy),
                                  hn::BitCast(di, filter.slopes.vx),
                                  hn::BitCast(di, filter.slopes.vy)};
      for (int a = 0; a < kArrays; ++a) hn::Store(values[a], di, of_group[a] + g);
    }
    FootprintShapes& shapes = filters_.shapes;
    std::int32_t* const out[kArrays] = {filters_.levels.packed, filters_.samples,     shapes.level,
                                        shapes.slope_bits[0],   shapes.slope_bits[1], shapes.slope_bits[2],
                                        shapes.slope_bits[3]};
    for (int a = 0; a < kArrays; ++a) spread(batch_, of_group[a], out[a]);
    for (int i = 0; i < batch_.count; ++i) {
      filters_.most_samples = std::max(filters_.most_samples, filters_.samples[i]);
      filters_.any_sum = filters_.any_sum || filters_.samples[i] == 0;
    }
  }

  /// Where sample k of the fragments from i on lies.
  HWY_INLINE Coordinates probe(int k, int i) const {
    const F d;
    const auto at = [&](float value) HWY_ATTR { return hn::Set(d, value); };
    auto x = at((k & 1) != 0 ? 0.5f : -0.5f);
    auto y = at((k & 2) != 0 ? 0.5f : -0.5f);
    if (unit_.min_filter != MinFilter::corners) {
      const auto n = hn::ConvertTo(d, hn::Load(I(), filters_.samples + i));
      x = hn::Sub(hn::Mul(at(static_cast<float>(k + 1)), hn::Div(at(1.0f), hn::Add(n, at(1.0f)))), at(0.5f));
      y = hn::Zero(d);
    }
    Coordinates c = places_.unwrapped(i);
    const Slopes slopes = filters_.shapes.slopes(i);
    const auto moved = [&](VF u, VF along_x, VF along_y, Wrap mode) HWY_ATTR {
      const auto sum = hn::Add(u, hn::Add(hn::Mul(along_x, x), hn::Mul(along_y, y)));
      return hn::IfThenElseZero(usable(sum), wrap(sum, mode));
    };
    const bool cube = texture_.is_cube();
    const TextureOptions& options = texture_.options();
    c.u = moved(c.u, slopes.ux, slopes.uy, cube ? Wrap::clamp_to_edge : options.wrap_s);
    c.v = moved(c.v, slopes.vx, slopes.vy, cube ? Wrap::clamp_to_edge : options.wrap_t);
    return c;
  }

  /// The mean of each fragment's samples. Those that have fewer than others are sampled on without weight.
  std::uint64_t sample_probes(float (*texel)[kBatchStride]) {
    const I di;
    alignas(64) std::int32_t sum[4][kBatchStride];
    float to_unit = 0.0f;
    for (int k = 0; k < filters_.most_samples; ++k) {
      const auto place = [&](int i) HWY_ATTR { return probe(k, i); };
      TextureSampler sampler(place, texture_, batch_.count, filters_.levels);
      sampler.sample([&](const Filtered& f, float scale, int i) HWY_ATTR {
        to_unit = scale;
        const auto counts = hn::Gt(hn::Load(di, filters_.samples + i), hn::Set(di, k));
        const VI channels[4] = {low_half(f.red_blue), low_half(f.green_alpha), high_half(f.red_blue),
                                high_half(f.green_alpha)};
        for (int c = 0; c < 4; ++c) {
          const auto before = k == 0 ? hn::Zero(di) : hn::Load(di, sum[c] + i);
          hn::Store(hn::Add(before, hn::IfThenElseZero(counts, channels[c])), di, sum[c] + i);
        }
      });
    }
    return store_means(sum, to_unit, texel);
  }

  static HWY_INLINE VI low_half(hn::Vec<U16> v) {
    return hn::BitCast(I(), hn::And(as_u32(v), hn::Set(U32(), 0xffffu)));
  }
  static HWY_INLINE VI high_half(hn::Vec<U16> v) { return hn::BitCast(I(), hn::ShiftRight<16>(as_u32(v))); }

  /// @return texels read.
  std::uint64_t store_means(const std::int32_t (*sum)[kBatchStride], float to_unit,
                            float (*texel)[kBatchStride]) const {
    const F d;
    const I di;
    auto texels = hn::Zero(di);
    for (int i = 0; i < batch_.count; i += static_cast<int>(hn::Lanes(di))) {
      const auto n = hn::Load(di, filters_.samples + i);
      const auto scale = hn::Div(hn::Set(d, to_unit), hn::ConvertTo(d, n));
      for (int c = 0; c < 4; ++c) {
        hn::Store(hn::Mul(hn::ConvertTo(d, hn::Load(di, sum[c] + i)), scale), d, texel[c] + i);
      }
      const auto each = hn::ShiftRight<kTexelCountShift>(hn::Load(di, filters_.levels.packed + i));
      texels = hn::Add(texels, hn::IfThenElseZero(lanes_below(di, batch_.count - i), hn::Mul(n, each)));
    }
    return static_cast<std::uint64_t>(hn::GetLane(hn::SumOfLanes(di, texels)));
  }

  std::uint64_t sum_footprints(float (*texel)[kBatchStride]) const {
    const F d;
    const I di;
    const FootprintMean mean(texture_);
    auto texels = hn::Zero(di);
    for (int i = 0; i < batch_.count; i += static_cast<int>(hn::Lanes(di))) {
      const auto sums = hn::And(hn::Eq(hn::Load(di, filters_.samples + i), hn::Zero(di)),
                                lanes_below(di, batch_.count - i));
      if (hn::AllFalse(di, sums)) continue;
      VF color[4];
      texels = hn::Add(texels, mean.of(places_.unwrapped(i), filters_.shapes, i, sums, color));
      for (int c = 0; c < 4; ++c) {
        hn::BlendedStore(color[c], hn::RebindMask(d, sums), d, texel[c] + i);
      }
    }
    return static_cast<std::uint64_t>(hn::GetLane(hn::SumOfLanes(di, texels)));
  }

  const FragmentBatch& batch_;
  const int number_;
  const TextureUnit& unit_;
  const Texture& texture_;
  const Places places_;
  WideFilters filters_;
};

std::uint64_t SampleWide(const LodGroups& groups, int group_count, const FragmentBatch& batch, int unit,
                         float (*texel)[kBatchStride]) {
  return WideSampler(batch, unit).sample(groups, group_count, texel);
}

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace barrido::raster {

HWY_EXPORT(SampleWide);

std::uint64_t sample_wide(const LodGroups& groups, int group_count, const FragmentBatch& batch, int unit,
                          float (*texel)[kBatchStride]) {
  return HWY_DYNAMIC_DISPATCH(SampleWide)(groups, group_count, batch, unit, texel);
}

}  // namespace barrido::raster
#endif
