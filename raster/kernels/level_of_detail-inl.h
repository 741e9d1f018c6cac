// From the planes of a unit's coordinates to how they change from pixel to pixel, and to the level of detail
// λ (OpenGL 1.3, section 3.8.8; docs/arithmetic.md, "Level of detail"), for vectors of groups of four pixels.
#if defined(BARRIDO_LEVEL_OF_DETAIL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BARRIDO_LEVEL_OF_DETAIL_INL_H
#undef BARRIDO_LEVEL_OF_DETAIL_INL_H
#else
#define BARRIDO_LEVEL_OF_DETAIL_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>

#include "raster/kernels/levels-inl.h"
#include "raster/kernels/mapping-inl.h"
#include "raster/kernels/planes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

inline constexpr float kLargestFootprint = 1e30f;

/// A quantity and its screen derivatives at the centres of groups of four pixels.
template <class V>
struct Differential {
  V value, dx, dy;
};

/// ½ log2 of the larger of two squares.
template <class V>
HWY_INLINE V half_log2_of_larger(V a, V b) {
  const hn::DFromV<V> d;
  const auto limit = hn::Set(d, kLargestFootprint);
  const auto larger = hn::IfThenElse(hn::Gt(a, b), a, b);
  const auto bounded = hn::IfThenElse(hn::Lt(larger, limit), larger, limit);  // a NaN becomes the limit
  return hn::Mul(hn::Set(d, 0.5f), Log2(d, bounded));
}

/// How the place (u, v) changes from pixel to pixel, in widths and heights of the texture or face.
struct Slopes {
  VF ux, uy, vx, vy;
};

/// Of a two-dimensional texture; Q is what S and T are divided by.
HWY_INLINE Slopes slopes_2d(const Differential<VF>& s, const Differential<VF>& t, const Differential<VF>& q,
                            VF w) {
  const auto u = hn::Mul(s.value, w);
  const auto v = hn::Mul(t.value, w);
  return {hn::Mul(hn::Sub(s.dx, hn::Mul(u, q.dx)), w), hn::Mul(hn::Sub(s.dy, hn::Mul(u, q.dy)), w),
          hn::Mul(hn::Sub(t.dx, hn::Mul(v, q.dx)), w), hn::Mul(hn::Sub(t.dy, hn::Mul(v, q.dy)), w)};
}

/// Of a cube map, on the face that (S, T, R) points to (OpenGL 1.3, table 3.19).
HWY_INLINE Slopes slopes_cube(const Differential<VF>& s, const Differential<VF>& t,
                              const Differential<VF>& r) {
  const F d;
  const auto as = hn::Abs(s.value);
  const auto at = hn::Abs(t.value);
  const auto ar = hn::Abs(r.value);
  const auto is_x = hn::And(hn::Ge(as, at), hn::Ge(as, ar));
  const auto is_y = hn::And(hn::Not(is_x), hn::Ge(at, ar));
  const auto pick = [&](VF x, VF y, VF z)
                        HWY_ATTR { return hn::IfThenElse(is_x, x, hn::IfThenElse(is_y, y, z)); };
  // |ma| has the sign of ma in its derivative.
  const auto one = hn::Set(d, 1.0f);
  const auto ma = pick(s.value, t.value, r.value);
  const auto sign_ma = hn::CopySign(one, ma);
  const auto w = hn::Div(one, hn::Abs(ma));
  const auto mx = hn::Mul(pick(s.dx, t.dx, r.dx), sign_ma);
  const auto my = hn::Mul(pick(s.dy, t.dy, r.dy), sign_ma);
  const auto u = hn::Mul(pick(r.value, s.value, s.value), w);
  const auto v = hn::Mul(pick(t.value, r.value, t.value), w);
  // Those of sc and tc.
  const auto half = hn::Set(d, 0.5f);
  const auto sign_u = hn::Mul(half, pick(hn::Neg(sign_ma), one, sign_ma));
  const auto sign_v = hn::Mul(half, pick(hn::Neg(one), sign_ma, hn::Neg(one)));
  const auto derivative = [&](VF c, VF uv, VF m, VF sign)
                              HWY_ATTR { return hn::Mul(hn::Mul(hn::Sub(c, hn::Mul(uv, m)), w), sign); };
  return {
      derivative(pick(r.dx, s.dx, s.dx), u, mx, sign_u), derivative(pick(r.dy, s.dy, s.dy), u, my, sign_u),
      derivative(pick(t.dx, r.dx, t.dx), v, mx, sign_v), derivative(pick(t.dy, r.dy, t.dy), v, my, sign_v)};
}

/// A unit's quantity `i` at the groups from g on.
HWY_INLINE Differential<VF> quantity_of(const LodGroups& groups, std::size_t i, int g) {
  const F d;
  return {hn::Load(d, groups.value[i] + g), hn::Load(d, groups.dx[i] + g), hn::Load(d, groups.dy[i] + g)};
}

/// The same, divided: the quotient rule.
HWY_INLINE Differential<VF> divided(const Differential<VF>& c, const Differential<VF>& q, VF w) {
  const auto value = hn::Mul(c.value, w);
  return {value, hn::Mul(hn::Sub(c.dx, hn::Mul(value, q.dx)), w),
          hn::Mul(hn::Sub(c.dy, hn::Mul(value, q.dy)), w)};
}

/// One coordinate of the unit's point, and how it changes from pixel to pixel.
HWY_INLINE Differential<VF> point_coordinate(const LodGroups& groups, const FragmentState& state, int unit,
                                             std::size_t i, int g) {
  const Differential<VF> c = quantity_of(groups, i, g);
  if (state.varyings.at(Meaning::texcoord, unit) < state.varyings.affine_count) return c;
  const std::size_t quotient = has_point(state, unit) ? 3 : 2;
  const Differential<VF> q = quantity_of(groups, quotient, g);
  return divided(c, q, inverse_q(q.value));
}

/// Squares of the steps that a pixel to the right and a pixel up make on the intermediate surface. The face
/// is that of the group's centre, so that nothing jumps at the edges of a box, nor at a seam or pole.
HWY_INLINE void steps_on_surface(const LodGroups& groups, const FragmentState& state, int unit, int g,
                                 VF& square_x, VF& square_y) {
  using Point = IntermediateSurface::Point;
  const Mapping& mapping = state.texture_units[unit].mapping;
  const IntermediateSurface surface(mapping);
  Differential<VF> p[3], n[3];
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = n[i] = point_coordinate(groups, state, unit, i, g);
    if (needs_normal(mapping)) n[i] = quantity_of(groups, kPointQuantities + i, g);
  }
  const Point point{p[0].value, p[1].value, p[2].value}, normal{n[0].value, n[1].value, n[2].value};
  const auto face = surface.face_of(point, normal);
  const Point here = surface.place(point, normal, face);
  const auto square_to = [&](VF Differential<VF>::*step) HWY_ATTR {
    const auto moved = [&](const Differential<VF>& c) HWY_ATTR { return hn::Add(c.value, c.*step); };
    const Point there =
        surface.place({moved(p[0]), moved(p[1]), moved(p[2])}, {moved(n[0]), moved(n[1]), moved(n[2])}, face);
    const auto x = hn::Sub(there.x, here.x), y = hn::Sub(there.y, here.y), z = hn::Sub(there.z, here.z);
    return hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
  };
  square_x = square_to(&Differential<VF>::dx);
  square_y = square_to(&Differential<VF>::dy);
}

/// λ of coordinates that a mapping makes: the step on the intermediate surface, in texels.
HWY_INLINE VF lod_mapped(const LodGroups& groups, const FragmentState& state, int unit, int g) {
  const F d;
  const TextureUnit& texture = state.texture_units[unit];
  const std::array<float, 2> density = mapping_density(texture.mapping);
  const float width = density[0] * static_cast<float>(texture.texture->width());
  const float height = density[1] * static_cast<float>(texture.texture->height());
  const auto texels = hn::Set(d, width > height ? width : height);
  auto square_x = hn::Zero(d), square_y = square_x;
  steps_on_surface(groups, state, unit, g, square_x, square_y);
  const auto scale = hn::Mul(texels, texels);
  return half_log2_of_larger(hn::Mul(square_x, scale), hn::Mul(square_y, scale));
}

/// Of the groups from g on. A mapping's are those of an upright box as wide as its longest step.
HWY_INLINE Slopes slopes_of_groups(const LodGroups& groups, const FragmentState& state, int unit, int g) {
  const F d;
  const Mapping& mapping = state.texture_units[unit].mapping;
  if (mapping.surface != MappingSurface::none) {
    auto square_x = hn::Zero(d), square_y = square_x;
    steps_on_surface(groups, state, unit, g, square_x, square_y);
    const auto side = hn::Sqrt(maximum(square_x, square_y));
    const std::array<float, 2> density = mapping_density(mapping);
    return {hn::Mul(side, hn::Set(d, density[0])), hn::Zero(d), hn::Zero(d),
            hn::Mul(side, hn::Set(d, density[1]))};
  }
  const auto quantity = [&](std::size_t i) HWY_ATTR { return quantity_of(groups, i, g); };
  const auto s = quantity(0);
  const auto t = quantity(1);
  const TexcoordKind kind = texcoord_kind(state, unit);
  if (kind == TexcoordKind::direct) return slopes_cube(s, t, quantity(2));
  const auto one = hn::Set(d, 1.0f);
  if (kind == TexcoordKind::projective) {
    const auto q = quantity(2);
    return slopes_2d(s, t, q, hn::Div(one, q.value));
  }
  if (state.varyings.at(Meaning::texcoord, unit) < state.varyings.affine_count) {
    const auto zero = hn::Zero(d);
    return slopes_2d(s, t, Differential<VF>{zero, zero, zero}, one);
  }
  const auto q = quantity(2);
  return slopes_2d(s, t, q, inverse_q(q.value));
}

/// The squares of the two sides of the pixel's footprint, in texels of level 0.
struct FootprintSides {
  VF along_x, along_y;

  /// NaN becomes the limit.
  HWY_INLINE VF larger() const { return minimum(maximum(along_x, along_y), hn::Set(F(), kLargestFootprint)); }
};

HWY_INLINE FootprintSides footprint_sides(const Slopes& slopes, const Texture& texture) {
  const F d;
  const auto width = hn::Set(d, static_cast<float>(texture.width()));
  const auto height = hn::Set(d, static_cast<float>(texture.height()));
  const auto square = [&](VF u, VF v) HWY_ATTR {
    const auto x = hn::Mul(u, width);
    const auto y = hn::Mul(v, height);
    return hn::Add(hn::Mul(x, x), hn::Mul(y, y));
  };
  return {square(slopes.ux, slopes.vx), square(slopes.uy, slopes.vy)};
}

HWY_INLINE VF lod_of(const FootprintSides& sides) {
  return half_log2_of_larger(sides.along_x, sides.along_y);
}

/// λ of the groups from g on.
HWY_INLINE VF lod_of_groups(const LodGroups& groups, const FragmentState& state, int unit, int g) {
  const TextureUnit& texture = state.texture_units[unit];
  if (texture.mapping.surface != MappingSurface::none) return lod_mapped(groups, state, unit, g);
  return lod_of(footprint_sides(slopes_of_groups(groups, state, unit, g), *texture.texture));
}

/// Gives each of `count` pixels from column x on the number of its group of four; up to three more are
/// written.
HWY_INLINE void spread_over_groups(const std::int32_t* of_group, int x, int count, std::int32_t* out) {
  const hn::FixedTag<std::int32_t, 4> d4;
  const int in_first = std::min(4 - (x & 3), count);
  for (int i = 0; i < in_first; ++i) out[i] = of_group[0];
  for (int i = in_first, g = 1; i < count; i += 4, ++g) hn::StoreU(hn::Set(d4, of_group[g]), d4, out + i);
}

/// Gives each fragment what its group has, in whole vectors: what is past the last is as the last one.
inline void spread(const FragmentBatch& batch, const std::int32_t* of_group, std::int32_t* out) {
  const I di;
  int g = 0;
  for (int r = 0; r < batch.run_count; ++r) {
    const FragmentRun& run = batch.runs[r];
    const int count = run.end - run.begin;
    spread_over_groups(of_group + g, run.x, count, out + run.begin);
    g += lod_groups_in(run.x, count);
  }
  hn::StoreU(hn::Set(di, out[batch.count - 1]), di, out + batch.count);
}

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
