// Sums over the lights of products of light and material, on lanes. Included once per target by Highway's
// foreach_target mechanism.
#if defined(BARRIDO_PIPELINE_SUMS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BARRIDO_PIPELINE_SUMS_INL_H
#undef BARRIDO_PIPELINE_SUMS_INL_H
#else
#define BARRIDO_PIPELINE_SUMS_INL_H
#endif

#include "pipeline/illumination.h"
#include "pipeline/kernels/vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::pipeline::HWY_NAMESPACE {

/// RGB; `color` is that of the vertices, and only set when kTracked.
struct Sums {
  V primary[3];
  V secondary[3];
  V color[3];
};

/// fixed + tracked × the vertices' colour, one channel.
template <bool kTracked>
HWY_INLINE V coefficient(const LightProducts& products, std::size_t side, int channel, V color) {
  const V fixed = broadcast(products.fixed[side][channel]);
  if constexpr (!kTracked) return fixed;
  return hn::Add(fixed, hn::Mul(broadcast(products.tracked[side][channel]), color));
}

template <bool kTracked>
HWY_INLINE void add_terms(Sums& sums, V (&into)[3], const LightProducts& products, std::size_t side,
                          V weight) {
  for (int c = 0; c < 3; ++c) {
    into[c] = hn::Add(into[c], hn::Mul(weight, coefficient<kTracked>(products, side, c, sums.color[c])));
  }
}

/// What does not depend on a light's direction.
template <bool kTracked>
HWY_INLINE Sums start_sums(const Illumination& illumination, const std::array<const float*, 4>& color,
                           std::size_t side, int i) {
  Sums sums;
  for (int c = 0; c < 3; ++c) {
    sums.color[c] = hn::Zero(F());
    if constexpr (kTracked) sums.color[c] = hn::Load(F(), color[static_cast<std::size_t>(c)] + i);
    sums.primary[c] = coefficient<kTracked>(illumination.base, side, c, sums.color[c]);
    sums.secondary[c] = hn::Zero(F());
  }
  return sums;
}

/// Leaves `share` of the ambient light in sums that have just been started.
template <bool kTracked>
HWY_INLINE void occlude(const Illumination& illumination, std::size_t side, V share, Sums& sums) {
  const V rest = hn::Sub(broadcast(1.0f), share);
  for (int c = 0; c < 3; ++c) {
    const V emission = coefficient<kTracked>(illumination.emission, side, c, sums.color[c]);
    sums.primary[c] = hn::Add(hn::Mul(sums.primary[c], share), hn::Mul(emission, rest));
  }
}

HWY_INLINE void store_sums(const Illumination& illumination, const Sums& sums,
                           const std::array<const float*, 4>& color, std::size_t side, int i,
                           const LitColors& out) {
  const F d;
  for (std::size_t c = 0; c < 3; ++c) {
    if (illumination.separate_specular) {
      hn::Store(sums.primary[c], d, out.primary[c] + i);
      hn::Store(sums.secondary[c], d, out.secondary[c] + i);
    } else {
      hn::Store(hn::Add(sums.primary[c], sums.secondary[c]), d, out.primary[c] + i);
    }
  }
  const V alpha = illumination.tracks_alpha ? hn::Load(d, color[3] + i) : broadcast(illumination.alpha[side]);
  hn::Store(alpha, d, out.primary[3] + i);
}

}  // namespace barrido::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
