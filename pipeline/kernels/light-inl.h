// One light seen from a vector of surface points: how it falls on them and how it weakens. Included once per
// target by Highway's foreach_target mechanism.
#if defined(BARRIDO_PIPELINE_LIGHT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BARRIDO_PIPELINE_LIGHT_INL_H
#undef BARRIDO_PIPELINE_LIGHT_INL_H
#else
#define BARRIDO_PIPELINE_LIGHT_INL_H
#endif

#include "pipeline/illumination.h"
#include "pipeline/kernels/vectors-inl.h"
#include "raster/kernels/simd_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::pipeline::HWY_NAMESPACE {
namespace math = barrido::HWY_NAMESPACE;

/// Points of a surface, one a lane, eye space.
struct Surface {
  Vec3 normal;
  Vec3 position;   ///< Only when the illumination needs it.
  Vec3 to_viewer;  ///< Unit vector V; only with a local viewer.
};

/// What the evaluation needs of a light at those points.
struct Incidence {
  V n_dot_l;    ///< Not clamped.
  V highlight;  ///< N·H or R·V, not clamped; only when asked for.
  V factor;     ///< Weakening; only for lights that weaken.
};

HWY_INLINE Surface load_surface(const Illumination& illumination, const SurfacePoints& points, int i) {
  Surface s;
  s.normal = load3(points.normal, i);
  if (points.normalize) s.normal = normalized(s.normal);
  if (points.back && illumination.two_sided) s.normal = negative(s.normal);
  if (illumination.needs_position) s.position = load3(points.position, i);
  if (illumination.local_viewer) s.to_viewer = normalized(negative(s.position));
  return s;
}

/// Blinn (L9): N·H with H = (L + V)/|L + V|, V = (0, 0, 1) for a viewer at infinity (OpenGL 1.3, eq. 2.4).
HWY_INLINE V blinn_highlight(const Surface& s, const Vec3& l, bool local_viewer) {
  const Vec3 h = local_viewer ? plus(l, s.to_viewer) : Vec3{l.x, l.y, hn::Add(l.z, broadcast(1.0f))};
  return hn::Mul(dot(s.normal, h), inverse_length(dot(h, h)));
}

/// Phong (L3): R·V = 2 (N·L)(N·V) − L·V, which is R = 2 (N·L) N − L times V.
HWY_INLINE V phong_highlight(const Surface& s, const Vec3& l, V n_dot_l, bool local_viewer) {
  const V n_dot_v = local_viewer ? dot(s.normal, s.to_viewer) : s.normal.z;
  const V l_dot_v = local_viewer ? dot(l, s.to_viewer) : l.z;
  return hn::Sub(hn::Mul(hn::Add(n_dot_l, n_dot_l), n_dot_v), l_dot_v);
}

/// Spot factor for c = −L · direction.
HWY_INLINE V spot_factor(const IlluminatingLight& light, V c) {
  V factor = broadcast(1.0f);
  if (light.falloff == SpotFalloff::soft) {
    const V t = clamp01(hn::Add(hn::Mul(c, broadcast(light.soft_scale)), broadcast(light.soft_offset)));
    factor = hn::Mul(t, t);
  } else if (light.falloff == SpotFalloff::exponent) {
    factor = math::Pow(F(), positive(c), light.spot_exponent);
  }
  return hn::IfThenElseZero(hn::Ge(c, broadcast(light.cos_cutoff)), factor);
}

/// The light's weakening at distance `d` in direction `l` (unit, towards the light).
HWY_INLINE V weakening(const IlluminatingLight& light, V d, const Vec3& l) {
  const V linear = hn::Mul(broadcast(light.linear_attenuation), d);
  const V quadratic = hn::Mul(broadcast(light.quadratic_attenuation), hn::Mul(d, d));
  const V denominator = hn::Add(hn::Add(broadcast(light.constant_attenuation), linear), quadratic);
  V factor = hn::Div(broadcast(1.0f), hn::Max(denominator, broadcast(1.0f / kBound)));
  if (light.inverse_range != 0.0f) {
    const V r = hn::Mul(d, broadcast(light.inverse_range));
    const V r2 = hn::Mul(r, r);
    factor = hn::Mul(factor, positive(hn::Sub(broadcast(1.0f), hn::Mul(r2, r2))));
  }
  if (light.has_cone) {
    factor = hn::Mul(factor, spot_factor(light, hn::Neg(dot(l, broadcast(light.spot_direction)))));
  }
  return factor;
}

HWY_INLINE Incidence incidence(const Illumination& illumination, const IlluminatingLight& light,
                               const Surface& s, bool with_highlight) {
  Incidence at;
  const bool local = illumination.local_viewer;
  Vec3 l = broadcast(light.to_light);
  if (!light.directional) {
    const Vec3 towards = minus(broadcast(light.position), s.position);
    const V distance = hn::Sqrt(hn::Max(dot(towards, towards), broadcast(kMinSquare)));
    l = times(towards, hn::Div(broadcast(1.0f), distance));
    if (light.weakens) at.factor = weakening(light, distance, l);
  }
  at.n_dot_l = dot(s.normal, l);
  if (!with_highlight) return at;
  if (illumination.specular_model == SpecularModel::phong) {
    at.highlight = phong_highlight(s, l, at.n_dot_l, local);
  } else if (light.directional && !local) {
    at.highlight = dot(s.normal, broadcast(light.half_vector));
  } else {
    at.highlight = blinn_highlight(s, l, local);
  }
  return at;
}

/// h^n where the light falls on the front of the surface, else 0; within kBound.
HWY_INLINE V shine(V n_dot_l, V highlight, float shininess) {
  const V power = hn::Min(math::Pow(F(), highlight, shininess), broadcast(kBound));
  return hn::IfThenElseZero(hn::Gt(n_dot_l, hn::Zero(F())), power);
}

}  // namespace barrido::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
