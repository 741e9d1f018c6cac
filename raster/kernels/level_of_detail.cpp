// The level of detail λ of a batch's fragments (OpenGL 1.3, section 3.8.8; docs/arithmetic.md, "Level of
// detail") and the mip levels it asks for: computed for groups of four pixels of a row, many rows at a time
// so that vectors are full, then given to each fragment of the group.
#include "raster/kernels/kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/level_of_detail.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>

#include "raster/kernels/levels-inl.h"
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

template <class V>
HWY_INLINE V half_log2_of_footprint(V ux, V vx, V uy, V vy) {
  const hn::DFromV<V> d;
  const auto a = hn::Add(hn::Mul(ux, ux), hn::Mul(vx, vx));
  const auto b = hn::Add(hn::Mul(uy, uy), hn::Mul(vy, vy));
  const auto limit = hn::Set(d, kLargestFootprint);
  const auto larger = hn::IfThenElse(hn::Gt(a, b), a, b);
  const auto bounded = hn::IfThenElse(hn::Lt(larger, limit), larger, limit);  // a NaN becomes the limit
  return hn::Mul(hn::Set(d, 0.5f), Log2(d, bounded));
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

/// λ of the groups from g on.
HWY_INLINE hn::Vec<hn::ScalableTag<float>> lod_of_groups(const LodGroups& groups, const FragmentState& state,
                                                         int unit, int g) {
  const hn::ScalableTag<float> d;
  using V = hn::Vec<decltype(d)>;
  const auto quantity = [&](int i) HWY_ATTR {
    return Differential<V>{hn::Load(d, groups.value[i] + g), hn::Load(d, groups.dx[i] + g),
                           hn::Load(d, groups.dy[i] + g)};
  };
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
    return lod_2d(s, t, Differential<V>{zero, zero, zero}, one, width, height);
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

/// Whole vectors: what is past the last fragment is as the last one.
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
  int g = 0;
  for (int r = 0; r < batch.run_count; ++r) {
    const FragmentRun& run = batch.runs[r];
    const int count = run.end - run.begin;
    spread_over_groups(of_group + g, run.x, count, levels.packed + run.begin);
    g += lod_groups_in(run.x, count);
  }
  hn::StoreU(hn::Set(di, levels.packed[batch.count - 1]), di, levels.packed + batch.count);
}

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace barrido::raster {

HWY_EXPORT(FindLevels);

void find_levels(const LodGroups& groups, int group_count, int unit, const FragmentBatch& batch,
                 SampleLevels& levels) {
  HWY_DYNAMIC_DISPATCH(FindLevels)(groups, group_count, unit, batch, levels);
}

}  // namespace barrido::raster
#endif
