// Cheap Phong on vectors: dot products at vertices, colours at fragments. See cheap_phong.h for the formulas.
#include "pipeline/cheap_phong.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/kernels/cheap_phong.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "pipeline/kernels/light-inl.h"
#include "pipeline/kernels/sums-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::pipeline::HWY_NAMESPACE {

/// The second varying of a light: (f^(1/n) h), or f h^n where the power is taken at the vertices.
HWY_INLINE V highlight_varying(const IlluminatingLight& light, const Incidence& at, float shininess,
                               bool power_here) {
  V value = at.highlight;
  if (power_here) {
    value = shine(at.n_dot_l, at.highlight, shininess);
    if (light.weakens) value = hn::Mul(value, at.factor);
  } else if (light.weakens) {
    value = hn::Mul(value, math::Pow(F(), at.factor, 1.0f / shininess));
  }
  return value;
}

template <bool kTracked>
void dots_at_points(const Illumination& illumination, const SurfacePoints& points,
                    std::span<float* const> columns) {
  const F d;
  const std::size_t side = points.back && illumination.two_sided ? 1 : 0;
  const bool power_here = power_at_vertices(illumination, static_cast<int>(side));
  const std::size_t ambient_column = 2 * illumination.lights.size();
  const bool has_ambient = columns.size() > ambient_column;
  for (int i = 0; i < points.count; i += kLanes) {
    const Surface surface = load_surface(illumination, points, i);
    Sums sums = start_sums<kTracked>(illumination, points.color, side, i);
    for (V& ambient : sums.primary) ambient = hn::Zero(d);
    std::size_t column = 0;
    for (const IlluminatingLight& light : illumination.lights) {
      const bool shines = light.shines[side];
      const Incidence at = incidence(illumination, light, surface, shines);
      const V diffuse = light.weakens ? hn::Mul(at.n_dot_l, at.factor) : at.n_dot_l;
      const V highlight =
          shines ? highlight_varying(light, at, illumination.shininess[side], power_here) : hn::Zero(d);
      hn::Store(diffuse, d, columns[column++] + i);
      hn::Store(highlight, d, columns[column++] + i);
      if (light.weakens && has_ambient) {
        add_terms<kTracked>(sums, sums.primary, light.ambient, side, at.factor);
      }
    }
    for (std::size_t c = 0; has_ambient && c < 3; ++c) {
      hn::Store(sums.primary[c], d, columns[ambient_column + c] + i);
    }
  }
}

/// kDimmed: `visibility` says how much of the light arrives.
template <bool kTracked, bool kDimmed>
HWY_INLINE void add_dots(const Illumination& illumination, const IlluminatingLight& light, V n_dot_l,
                         V highlight, bool power_here, std::size_t side, const float* visibility,
                         Sums& sums) {
  V diffuse = positive(n_dot_l);
  if constexpr (kDimmed) diffuse = hn::Mul(diffuse, hn::Load(F(), visibility));
  add_terms<kTracked>(sums, sums.primary, light.diffuse, side, diffuse);
  if (!light.shines[side]) return;
  V specular = power_here ? shine(n_dot_l, highlight, illumination.shininess[side]) : highlight;
  if constexpr (kDimmed) specular = hn::Mul(specular, hn::Load(F(), visibility));
  add_terms<kTracked>(sums, sums.secondary, light.specular, side, specular);
}

template <bool kTracked, bool kDimmed>
void colors_from_dots(const Illumination& illumination, const InterpolatedDots& dots, const LitColors& out) {
  const F d;
  const std::size_t side = dots.back && illumination.two_sided ? 1 : 0;
  const bool power_here = !power_at_vertices(illumination, static_cast<int>(side));
  const std::size_t ambient_column = 2 * illumination.lights.size();
  for (int i = 0; i < dots.count; i += kLanes) {
    Sums sums = start_sums<kTracked>(illumination, dots.color, side, i);
    const bool occluded = dots.occlusion != nullptr;
    const V share = occluded ? hn::Load(d, dots.occlusion + i) : broadcast(1.0f);
    if (occluded) occlude<kTracked>(illumination, side, share, sums);
    for (std::size_t c = 0; dots.columns.size() > ambient_column && c < 3; ++c) {
      const V ambient = hn::Load(d, dots.columns[ambient_column + c] + i);
      sums.primary[c] = hn::Add(sums.primary[c], occluded ? hn::Mul(ambient, share) : ambient);
    }
    for (std::size_t l = 0; l < illumination.lights.size(); ++l) {
      const V n_dot_l = hn::Load(d, dots.columns[2 * l] + i);
      const V highlight = hn::Load(d, dots.columns[2 * l + 1] + i);
      const float* visibility = kDimmed ? dots.visibility[l] + i : nullptr;
      add_dots<kTracked, kDimmed>(illumination, illumination.lights[l], n_dot_l, highlight, power_here, side,
                                  visibility, sums);
    }
    store_sums(illumination, sums, dots.color, side, i, out);
  }
}

void CheapPhongDots(const Illumination& illumination, const SurfacePoints& points,
                    std::span<float* const> columns) {
  if (illumination.tracks_color) {
    dots_at_points<true>(illumination, points, columns);
  } else {
    dots_at_points<false>(illumination, points, columns);
  }
}

void CheapPhongColors(const Illumination& illumination, const InterpolatedDots& dots, const LitColors& out) {
  const bool dimmed = !dots.visibility.empty();
  const auto run = illumination.tracks_color
                       ? (dimmed ? colors_from_dots<true, true> : colors_from_dots<true, false>)
                       : (dimmed ? colors_from_dots<false, true> : colors_from_dots<false, false>);
  run(illumination, dots, out);
}

}  // namespace barrido::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace barrido::pipeline {

HWY_EXPORT(CheapPhongDots);
HWY_EXPORT(CheapPhongColors);

void cheap_phong_dots(const Illumination& illumination, const SurfacePoints& points,
                      std::span<float* const> columns) {
  HWY_DYNAMIC_DISPATCH(CheapPhongDots)(illumination, points, columns);
}

void cheap_phong_colors(const Illumination& illumination, const InterpolatedDots& dots,
                        const LitColors& out) {
  HWY_DYNAMIC_DISPATCH(CheapPhongColors)(illumination, dots, out);
}

}  // namespace barrido::pipeline
#endif
