// The texture unit: from coordinates and level of detail to filtered texels, for one batch of fragments.
#include "raster/kernels/kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/texture.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/texture_sampler-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <bool kModulates>
HWY_INLINE std::uint64_t sample(const FragmentBatch& batch, int unit, const SampleLevels& levels,
                                float (*colors)[kBatchStride]) {
  const Places places(batch, unit);
  TextureSampler<Places> sampler(places, places.texture(), batch.count, levels);
  return sampler.sample([&](const Filtered& f, float scale, int i)
                            HWY_ATTR { store_texels<kModulates>(f, scale, colors, i); });
}

std::uint64_t SampleTexture(const FragmentBatch& batch, int unit, const SampleLevels& levels,
                            float (*texel)[kBatchStride]) {
  return sample<false>(batch, unit, levels, texel);
}

std::uint64_t ModulateByTexture(FragmentBatch& batch, int unit, const SampleLevels& levels) {
  return sample<true>(batch, unit, levels, batch.color);
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
