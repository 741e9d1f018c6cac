// The interpolation along the scanline: appends a run of pixels of one span to the fragment batch. Enters:
// the planes and their values at the span's first pixel. Leaves: perspective-correct varyings, depth and
// level of detail.
#if defined(BARRIDO_INTERPOLATE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BARRIDO_INTERPOLATE_INL_H
#undef BARRIDO_INTERPOLATE_INL_H
#else
#define BARRIDO_INTERPOLATE_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>

#include "raster/kernels/lanes-inl.h"
#include "raster/kernels/planes-inl.h"
#include "raster/kernels/simd_math-inl.h"
#include "raster/tile.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

inline constexpr float kSmallestQ = 1e-30f;
inline constexpr float kLargestFootprint = 1e30f;

/// A span ready for interpolation: columns relative to the tile, values of all quantities at `anchor`.
struct InterpolatedSpan {
  const Planes* planes;
  int anchor;
  int last;
  bool constant_q;  ///< q is 1 everywhere: dividing by it changes no bit, so it is left out.
  alignas(64) float row[kMaxQuantities];
};

/// Varyings of `count` pixels from column x on, into the batch's arrays from fragment `at` on.
template <class D>
HWY_INLINE void interpolate_varyings(D d, const InterpolatedSpan& span, const VaryingLayout& layout, int x,
                                     int count, FragmentBatch& batch, int at) {
  const int lanes = static_cast<int>(hn::Lanes(d));
  const float* slope = span.planes->slope_x;
  const int perspective_from = span.constant_q ? layout.count : layout.affine_count;
  for (int i = 0; i < count; i += lanes) {
    const auto k = barrido::HWY_NAMESPACE::lanes_from(d, static_cast<float>(x + i - span.anchor));
    const auto linear = [&](int quantity) HWY_ATTR {
      return hn::Add(hn::Set(d, span.row[quantity]), hn::Mul(hn::Set(d, slope[quantity]), k));
    };
    for (int v = 0; v < perspective_from; ++v) {
      hn::StoreU(linear(kRecordVaryings + v), d, batch.varying[v] + at + i);
    }
    if (perspective_from == layout.count) continue;
    const auto q = barrido::HWY_NAMESPACE::maximum(linear(kRecordQ), hn::Set(d, kSmallestQ));
    const auto w = hn::Div(hn::Set(d, 1.0f), q);
    for (int v = perspective_from; v < layout.count; ++v) {
      hn::StoreU(hn::Mul(linear(kRecordVaryings + v), w), d, batch.varying[v] + at + i);
    }
  }
}

/// Short runs, the usual ones of small triangles, use short vectors: a division costs by the lane.
HWY_INLINE void interpolate_varyings(const InterpolatedSpan& span, const VaryingLayout& layout, int x,
                                     int count, FragmentBatch& batch, int at) {
  if (count <= 4) {
    interpolate_varyings(hn::FixedTag<float, 4>(), span, layout, x, count, batch, at);
  } else {
    interpolate_varyings(hn::ScalableTag<float>(), span, layout, x, count, batch, at);
  }
}

HWY_INLINE void interpolate_depth(const InterpolatedSpan& span, int x, int count, FragmentBatch& batch,
                                  int at) {
  const hn::ScalableTag<float> d;
  for (int i = 0; i < count; i += static_cast<int>(hn::Lanes(d))) {
    const auto k = barrido::HWY_NAMESPACE::lanes_from(d, static_cast<float>(x + i - span.anchor));
    const auto z = hn::Add(hn::Set(d, span.row[kRecordDepth]),
                           hn::Mul(hn::Set(d, span.planes->slope_x[kRecordDepth]), k));
    hn::StoreU(
        barrido::HWY_NAMESPACE::minimum(barrido::HWY_NAMESPACE::maximum(z, hn::Zero(d)), hn::Set(d, 1.0f)), d,
        batch.depth + at + i);
  }
}

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
  return hn::Mul(hn::Set(d, 0.5f), barrido::HWY_NAMESPACE::Log2(d, bounded));
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

/// Whether the unit's filters depend on the level of detail.
inline bool needs_lod(const TextureUnit& unit) {
  return !((unit.min_filter == MinFilter::nearest && unit.mag_filter == MagFilter::nearest) ||
           (unit.min_filter == MinFilter::linear && unit.mag_filter == MagFilter::linear));
}

/// Gives each of `count` pixels from column x on the value of its group of four; up to three more are
/// written.
HWY_INLINE void spread_over_groups(const float* group_values, int x, int count, float* out) {
  const hn::FixedTag<float, 4> d4;
  const int in_first = std::min(4 - (x & 3), count);
  for (int i = 0; i < in_first; ++i) out[i] = group_values[0];
  for (int i = in_first, g = 1; i < count; i += 4, ++g) hn::StoreU(hn::Set(d4, group_values[g]), d4, out + i);
}

/// λ per group of four pixels, then spread over the run's fragments.
HWY_INLINE void interpolate_lod(const InterpolatedSpan& span, const FragmentState& state, int unit, int x,
                                int count, FragmentBatch& batch, int at) {
  const hn::ScalableTag<float> d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const VaryingLayout& layout = state.varyings;
  const Texture& texture = *state.texture_units[static_cast<std::size_t>(unit)].texture;
  const TexcoordKind kind = layout.texcoord_kind[static_cast<std::size_t>(unit)];
  const int varying = layout.texcoord[static_cast<std::size_t>(unit)];
  const Planes& planes = *span.planes;
  const int first_group = x & ~3;
  const int groups = ((x + count - 1 - first_group) >> 2) + 1;
  alignas(64) float group_lod[kTileWidth / 4 + kBatchPadding];
  for (int g = 0; g < groups; g += lanes) {
    auto center =
        hn::Add(hn::Mul(barrido::HWY_NAMESPACE::lanes_from(d, static_cast<float>(g)), hn::Set(d, 4.0f)),
                hn::Set(d, static_cast<float>(first_group) + 1.5f));
    center = barrido::HWY_NAMESPACE::minimum(
        barrido::HWY_NAMESPACE::maximum(center, hn::Set(d, static_cast<float>(span.anchor))),
        hn::Set(d, static_cast<float>(span.last)));
    const auto k = hn::Sub(center, hn::Set(d, static_cast<float>(span.anchor)));
    using Value = decltype(k + k);
    const auto quantity = [&](int i) HWY_ATTR {
      const auto dx = hn::Set(d, planes.slope_x[i]);
      return Differential<Value>{hn::Add(hn::Set(d, span.row[i]), hn::Mul(dx, k)), dx,
                                 hn::Set(d, planes.slope_y[i])};
    };
    const auto s = quantity(kRecordVaryings + varying);
    const auto t = quantity(kRecordVaryings + varying + 1);
    const auto width = static_cast<float>(texture.width());
    const auto height = static_cast<float>(texture.height());
    Value lod;
    if (kind == TexcoordKind::cube) {
      lod = lod_cube(s, t, quantity(kRecordVaryings + varying + 2), width);
    } else if (kind == TexcoordKind::projective) {
      const auto q = quantity(kRecordVaryings + varying + 2);
      lod = lod_2d(s, t, q, hn::Div(hn::Set(d, 1.0f), q.value), width, height);
    } else if (varying < layout.affine_count) {
      const auto zero = hn::Zero(d);
      lod = lod_2d(s, t, Differential<Value>{zero, zero, zero}, hn::Set(d, 1.0f), width, height);
    } else {
      const auto q = quantity(kRecordQ);
      lod =
          lod_2d(s, t, q,
                 hn::Div(hn::Set(d, 1.0f), barrido::HWY_NAMESPACE::maximum(q.value, hn::Set(d, kSmallestQ))),
                 width, height);
    }
    hn::Store(lod, d, group_lod + g);
  }
  spread_over_groups(group_lod, x, count, batch.lod[unit] + at);
}

/// One value for each of `channels` arrays, for `count` fragments from `at` on.
HWY_INLINE void fill(const float* values, int channels, int count, float (*out)[kBatchStride], int at) {
  const hn::ScalableTag<float> d;
  for (int c = 0; c < channels; ++c) {
    const auto v = hn::Set(d, values[c]);
    for (int i = 0; i < count; i += static_cast<int>(hn::Lanes(d))) hn::StoreU(v, d, out[c] + at + i);
  }
}

/// The colours that no varying carries are the same for every fragment of the primitive.
HWY_INLINE void fill_flat(const FlatColors& flat, const FragmentState& state, int count, FragmentBatch& batch,
                          int at) {
  if (state.varyings.color == kAbsent) fill(flat.color, 4, count, batch.color, at);
  if (state.varyings.specular == kAbsent && state.separate_specular) {
    fill(flat.specular, 3, count, batch.specular, at);
  }
}

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
