// The illumination model on vectors of surface points: see illumination.h for the formula. Enters: eye-space
// points; leaves: colours that are not clamped.
#include "pipeline/illumination.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/kernels/illumination.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "pipeline/kernels/light-inl.h"
#include "pipeline/kernels/sums-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::pipeline::HWY_NAMESPACE {

/// kDimmed: `visibility` says how much of the light arrives.
template <bool kTracked, bool kDimmed>
HWY_INLINE void add_light(const Illumination& illumination, const IlluminatingLight& light,
                          const Surface& surface, std::size_t side, const float* visibility,
                          const float* occlusion, Sums& sums) {
  const bool shines = light.shines[side];
  const Incidence at = incidence(illumination, light, surface, shines);
  V diffuse = positive(at.n_dot_l);
  if (light.weakens) {
    diffuse = hn::Mul(diffuse, at.factor);
    const V ambient = occlusion != nullptr ? hn::Mul(at.factor, hn::Load(F(), occlusion)) : at.factor;
    add_terms<kTracked>(sums, sums.primary, light.ambient, side, ambient);
  }
  if constexpr (kDimmed) diffuse = hn::Mul(diffuse, hn::Load(F(), visibility));
  add_terms<kTracked>(sums, sums.primary, light.diffuse, side, diffuse);
  if (!shines) return;
  V specular = shine(at.n_dot_l, at.highlight, illumination.shininess[side]);
  if (light.weakens) specular = hn::Mul(specular, at.factor);
  if constexpr (kDimmed) specular = hn::Mul(specular, hn::Load(F(), visibility));
  add_terms<kTracked>(sums, sums.secondary, light.specular, side, specular);
}

template <bool kTracked, bool kDimmed>
void illuminate_points(const Illumination& illumination, const SurfacePoints& points, const LitColors& out) {
  const std::size_t side = points.back && illumination.two_sided ? 1 : 0;
  for (int i = 0; i < points.count; i += kLanes) {
    const Surface surface = load_surface(illumination, points, i);
    Sums sums = start_sums<kTracked>(illumination, points.color, side, i);
    const float* occlusion = points.occlusion != nullptr ? points.occlusion + i : nullptr;
    if (occlusion != nullptr) occlude<kTracked>(illumination, side, hn::Load(F(), occlusion), sums);
    for (std::size_t l = 0; l < illumination.lights.size(); ++l) {
      const float* visibility = kDimmed ? points.visibility[l] + i : nullptr;
      add_light<kTracked, kDimmed>(illumination, illumination.lights[l], surface, side, visibility, occlusion,
                                   sums);
    }
    store_sums(illumination, sums, points.color, side, i, out);
  }
}

void Illuminate(const Illumination& illumination, const SurfacePoints& points, const LitColors& out) {
  const bool dimmed = !points.visibility.empty();
  const auto run = illumination.tracks_color
                       ? (dimmed ? illuminate_points<true, true> : illuminate_points<true, false>)
                       : (dimmed ? illuminate_points<false, true> : illuminate_points<false, false>);
  run(illumination, points, out);
}

}  // namespace barrido::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace barrido::pipeline {

HWY_EXPORT(Illuminate);

void illuminate(const Illumination& illumination, const SurfacePoints& points, const LitColors& out) {
  HWY_DYNAMIC_DISPATCH(Illuminate)(illumination, points, out);
}

}  // namespace barrido::pipeline
#endif
