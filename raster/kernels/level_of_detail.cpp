// The level of detail λ of a batch's fragments (OpenGL 1.3, section 3.8.8; docs/arithmetic.md, "Level of
// detail") and the mip levels it asks for: computed for groups of four pixels of a row, many rows at a time
// so that vectors are full, then given to each fragment of the group.
#include "raster/kernels/kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/level_of_detail.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cstring>

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

template <class V>
HWY_INLINE V half_log2_of_footprint(V ux, V vx, V uy, V vy) {
  return half_log2_of_larger(hn::Add(hn::Mul(ux, ux), hn::Mul(vx, vx)),
                             hn::Add(hn::Mul(uy, uy), hn::Mul(vy, vy)));
}

/// λ of a two-dimensional texture; Q is what S and T are divided by.
template <class V>
HWY_INLINE V lod_2d(const Differential<V>& s, const Differential<V>& t, const Differential<V>& q, V w,
                    float width, float height) {
  const hn::DFromV<V> d;
  const auto scale_u = hn::Set(d, width);
  const auto scale_v = hn::Set(d, height);
  const auto u = hn::Mul(s.value, w);
  const auto v = hn::Mul(t.value, w);
  const auto ux = hn::Mul(hn::Mul(hn::Sub(s.dx, hn::Mul(u, q.dx)), w), scale_u);
  const auto uy = hn::Mul(hn::Mul(hn::Sub(s.dy, hn::Mul(u, q.dy)), w), scale_u);
  const auto vx = hn::Mul(hn::Mul(hn::Sub(t.dx, hn::Mul(v, q.dx)), w), scale_v);
  const auto vy = hn::Mul(hn::Mul(hn::Sub(t.dy, hn::Mul(v, q.dy)), w), scale_v);
  return half_log2_of_footprint(ux, vx, uy, vy);
}

/// λ of a cube map of `size`² faces, by the face that (S, T, R) points to (OpenGL 1.3, table 3.19).
template <class V>
HWY_INLINE V lod_cube(const Differential<V>& s, const Differential<V>& t, const Differential<V>& r,
                      float size) {
  const hn::DFromV<V> d;
  const auto as = hn::Abs(s.value);
  const auto at = hn::Abs(t.value);
  const auto ar = hn::Abs(r.value);
  const auto is_x = hn::And(hn::Ge(as, at), hn::Ge(as, ar));
  const auto is_y = hn::And(hn::Not(is_x), hn::Ge(at, ar));
  const auto pick = [&](auto x, auto y, auto z)
                        HWY_ATTR { return hn::IfThenElse(is_x, x, hn::IfThenElse(is_y, y, z)); };
  // The signs of sc and tc do not change the length of the footprint; |ma| has the sign of ma in its
  // derivative.
  const auto ma = pick(s.value, t.value, r.value);
  const auto sign_ma = hn::CopySign(hn::Set(d, 1.0f), ma);
  const auto w = hn::Div(hn::Set(d, 1.0f), hn::Abs(ma));
  const auto mx = hn::Mul(pick(s.dx, t.dx, r.dx), sign_ma);
  const auto my = hn::Mul(pick(s.dy, t.dy, r.dy), sign_ma);
  const auto u = hn::Mul(pick(r.value, s.value, s.value), w);
  const auto v = hn::Mul(pick(t.value, r.value, t.value), w);
  const auto half = hn::Set(d, 0.5f);
  const auto scale = hn::Set(d, size);
  const auto derivative = [&](auto c, auto uv, auto m) HWY_ATTR {
    return hn::Mul(hn::Mul(hn::Mul(hn::Sub(c, hn::Mul(uv, m)), w), half), scale);
  };
  return half_log2_of_footprint(
      derivative(pick(r.dx, s.dx, s.dx), u, mx), derivative(pick(t.dx, r.dx, t.dx), v, mx),
      derivative(pick(r.dy, s.dy, s.dy), u, my), derivative(pick(t.dy, r.dy, t.dy), v, my));
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

/// λ of the groups from g on.
HWY_INLINE hn::Vec<hn::ScalableTag<float>> lod_of_groups(const LodGroups& groups, const FragmentState& state,
                                                         int unit, int g) {
  const F d;
  if (state.texture_units[unit].mapping.surface != MappingSurface::none) {
    return lod_mapped(groups, state, unit, g);
  }
  const auto quantity = [&](std::size_t i) HWY_ATTR { return quantity_of(groups, i, g); };
  const auto s = quantity(0);
  const auto t = quantity(1);
  const Texture& texture = *state.texture_units[unit].texture;
  const auto width = static_cast<float>(texture.width());
  const auto height = static_cast<float>(texture.height());
  const TexcoordKind kind = texcoord_kind(state, unit);
  if (kind == TexcoordKind::direct) return lod_cube(s, t, quantity(2), width);
  const auto one = hn::Set(d, 1.0f);
  if (kind == TexcoordKind::projective) {
    const auto q = quantity(2);
    return lod_2d(s, t, q, hn::Div(one, q.value), width, height);
  }
  if (state.varyings.at(Meaning::texcoord, unit) < state.varyings.affine_count) {
    const auto zero = hn::Zero(d);
    return lod_2d(s, t, Differential<VF>{zero, zero, zero}, one, width, height);
  }
  const auto q = quantity(2);
  return lod_2d(s, t, q, inverse_q(q.value), width, height);
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
void spread(const FragmentBatch& batch, const std::int32_t* of_group, std::int32_t* out) {
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

void FindLevels(const LodGroups& groups, int group_count, int unit_number, const FragmentBatch& batch,
                SampleLevels& levels) {
  const F d;
  const I di;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const TextureUnit& unit = batch.state->texture_units[unit_number];
  const UnitFilters filters = unit_filters(unit);
  if (!needs_lod(unit)) {
    const auto all = hn::Set(di, level_zero(filters.min_linear));
    for (int i = 0; i < batch.count; i += lanes) hn::Store(all, di, levels.packed + i);
    return;
  }
  alignas(64) std::int32_t of_group[kBatchStride];
  for (int g = 0; g < group_count; g += lanes) {
    const auto lod = hn::Add(lod_of_groups(groups, *batch.state, unit_number, g), hn::Set(d, unit.lod_bias));
    hn::Store(choose_levels(lod, filters, unit.texture->level_count() - 1), di, of_group + g);
  }
  spread(batch, of_group, levels.packed);
}

/// Width of the box of the pixel along coordinate `i` at the groups from g on.
HWY_INLINE VF extent_of_groups(const LodGroups& groups, const FragmentState& state, int unit, std::size_t i,
                               int g) {
  const F d;
  const Mapping& mapping = state.texture_units[unit].mapping;
  if (mapping.surface == MappingSurface::none) {
    const Differential<VF> c = point_coordinate(groups, state, unit, i, g);
    return maximum(hn::Abs(c.dx), hn::Abs(c.dy));
  }
  auto square_x = hn::Zero(d), square_y = square_x;
  steps_on_surface(groups, state, unit, g, square_x, square_y);
  return hn::Mul(hn::Sqrt(maximum(square_x, square_y)), hn::Set(d, mapping_density(mapping)[i]));
}

void FindExtents(const LodGroups& groups, int group_count, int unit, const FragmentBatch& batch,
                 float (*extent)[kBatchStride]) {
  const F d;
  const I di;
  const FragmentState& state = *batch.state;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const std::size_t coordinates = texcoord_kind(state, unit) == TexcoordKind::plain ? 2 : 3;
  alignas(64) std::int32_t of_group[kBatchStride];
  for (std::size_t i = 0; i < coordinates; ++i) {
    for (int g = 0; g < group_count; g += lanes) {
      hn::Store(hn::BitCast(di, extent_of_groups(groups, state, unit, i, g)), di, of_group + g);
    }
    spread(batch, of_group, reinterpret_cast<std::int32_t*>(extent[i]));
  }
  for (std::size_t i = coordinates; i < 3; ++i) std::memset(extent[i], 0, sizeof(extent[i]));
}

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace barrido::raster {

HWY_EXPORT(FindLevels);
HWY_EXPORT(FindExtents);

void find_extents(const LodGroups& groups, int group_count, int unit, const FragmentBatch& batch,
                  float (*extent)[kBatchStride]) {
  HWY_DYNAMIC_DISPATCH(FindExtents)(groups, group_count, unit, batch, extent);
}

void find_levels(const LodGroups& groups, int group_count, int unit, const FragmentBatch& batch,
                 SampleLevels& levels) {
  HWY_DYNAMIC_DISPATCH(FindLevels)(groups, group_count, unit, batch, levels);
}

}  // namespace barrido::raster
#endif
