// The interpolation along the scanline: appends a run of pixels of one span to the fragment batch. Enters:
// the planes and their values at the span's first pixel. Leaves: perspective-correct varyings, depth, and
// what the level of detail depends on.
#if defined(BARRIDO_INTERPOLATE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BARRIDO_INTERPOLATE_INL_H
#undef BARRIDO_INTERPOLATE_INL_H
#else
#define BARRIDO_INTERPOLATE_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>

#include "raster/kernels/lanes-inl.h"
#include "raster/kernels/planes-inl.h"
#include "raster/kernels/simd_math-inl.h"
#include "raster/tiles/tile.h"
#include "raster/tiles/tile_places.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A span ready for interpolation: columns relative to the tile, values of all quantities at `anchor`.
struct InterpolatedSpan {
  const Planes* planes;
  int anchor;
  int last;
  bool constant_q;  ///< q is 1 everywhere: dividing by it changes no bit, so it is left out.
  alignas(64) float row[kMaxQuantities];
};

/// Varyings of a vector of pixels, which are `k` columns from the anchor, into the batch's arrays from
/// fragment `at` on.
template <class D>
HWY_INLINE void interpolate_vector(D d, const InterpolatedSpan& span, const VaryingList& varyings,
                                   hn::Vec<D> k, FragmentBatch& batch, int at) {
  const float* slope = span.planes->slope_x;
  const int perspective_from = span.constant_q ? varyings.count : varyings.affine_count;
  const auto linear = [&](int quantity) HWY_ATTR {
    return hn::Add(hn::Set(d, span.row[quantity]), hn::Mul(hn::Set(d, slope[quantity]), k));
  };
  for (int v = 0; v < perspective_from; ++v) {
    hn::StoreU(linear(kRecordVaryings + v), d, batch.varying[v] + at);
  }
  if (perspective_from == varyings.count) return;
  const auto w = inverse_q(linear(kRecordQ));
  for (int v = perspective_from; v < varyings.count; ++v) {
    hn::StoreU(hn::Mul(linear(kRecordVaryings + v), w), d, batch.varying[v] + at);
  }
}

/// Varyings of `count` pixels from column x on.
template <class D>
HWY_INLINE void interpolate_varyings(D d, const InterpolatedSpan& span, const VaryingList& varyings, int x,
                                     int count, FragmentBatch& batch, int at) {
  for (int i = 0; i < count; i += static_cast<int>(hn::Lanes(d))) {
    const auto k = lanes_from(d, static_cast<float>(x + i - span.anchor));
    interpolate_vector(d, span, varyings, k, batch, at + i);
  }
}

/// Short runs, the usual ones of small triangles, use short vectors: a division costs by the lane.
HWY_INLINE void interpolate_varyings(const InterpolatedSpan& span, const VaryingList& varyings, int x,
                                     int count, FragmentBatch& batch, int at) {
  if (count <= 4) {  // NOLINT(bugprone-branch-clone): the same only where vectors are that short
    interpolate_varyings(hn::FixedTag<float, 4>(), span, varyings, x, count, batch, at);
  } else {
    interpolate_varyings(hn::ScalableTag<float>(), span, varyings, x, count, batch, at);
  }
}

HWY_INLINE void interpolate_depth(const InterpolatedSpan& span, int x, int count, FragmentBatch& batch,
                                  int at) {
  const hn::ScalableTag<float> d;
  for (int i = 0; i < count; i += static_cast<int>(hn::Lanes(d))) {
    const auto k = lanes_from(d, static_cast<float>(x + i - span.anchor));
    const auto z = hn::Add(hn::Set(d, span.row[kRecordDepth]),
                           hn::Mul(hn::Set(d, span.planes->slope_x[kRecordDepth]), k));
    hn::StoreU(clamp01(z), d, batch.depth + at + i);
  }
}

/// A quantity of a vector of pixels from column x on, each at its place.
template <class D>
HWY_INLINE hn::Vec<D> placed_quantity(D d, const InterpolatedSpan& span, const TilePlaces& places, int row,
                                      int x, int quantity) {
  const int at = row * kTileWidth + x;
  const auto k = hn::Add(lanes_from(d, static_cast<float>(x - span.anchor)), hn::LoadU(d, places.x + at));
  const auto along_x =
      hn::Add(hn::Set(d, span.row[quantity]), hn::Mul(hn::Set(d, span.planes->slope_x[quantity]), k));
  return hn::Add(along_x, hn::Mul(hn::Set(d, span.planes->slope_y[quantity]), hn::LoadU(d, places.y + at)));
}

template <class D>
HWY_INLINE hn::Vec<D> placed_depth(D d, const InterpolatedSpan& span, const TilePlaces& places, int row,
                                   int x) {
  return placed_quantity(d, span, places, row, x, kRecordDepth);
}

/// Varyings and depths of `count` pixels from column x on, each at its place.
HWY_INLINE void interpolate_placed(const InterpolatedSpan& span, const VaryingList& varyings,
                                   const TilePlaces& places, int row, int x, int count, FragmentBatch& batch,
                                   int at) {
  const hn::ScalableTag<float> d;
  const int perspective_from = span.constant_q ? varyings.count : varyings.affine_count;
  for (int i = 0; i < count; i += static_cast<int>(hn::Lanes(d))) {
    const auto value = [&](int quantity)
                           HWY_ATTR { return placed_quantity(d, span, places, row, x + i, quantity); };
    hn::StoreU(clamp01(value(kRecordDepth)), d, batch.depth + at + i);
    const auto w = inverse_q(value(kRecordQ));
    for (int v = 0; v < varyings.count; ++v) {
      const auto plain = value(kRecordVaryings + v);
      hn::StoreU(v < perspective_from ? plain : hn::Mul(plain, w), d, batch.varying[v] + at + i);
    }
  }
}

/// The quantities that a unit's level of detail depends on; for affine coordinates the last does not count.
inline std::array<int, 3> lod_quantities(const VaryingList& varyings, int unit) {
  const int s = kRecordVaryings + varyings.at(Meaning::texcoord, unit);
  return {s, s + 1, varyings.floats(Meaning::texcoord, unit) == 2 ? kRecordQ : s + 2};
}

/// Those of a point in space beside its three coordinates.
inline std::array<int, 4> point_quantities(const VaryingList& varyings, const Mapping& mapping) {
  if (!needs_normal(mapping)) return {kRecordQ, kAbsent, kAbsent, kAbsent};
  const int normal = kRecordVaryings + varyings.at(Meaning::normal);
  return {kRecordQ, normal, normal + 1, normal + 2};
}

/// Appends the run's groups of four pixels to the unit's groups: what their level of detail depends on.
HWY_INLINE void append_lod_groups(const InterpolatedSpan& span, const FragmentState& state, int unit, int x,
                                  int count, LodGroups& groups, int at) {
  const hn::ScalableTag<float> d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const std::array<int, 3> quantities = lod_quantities(state.varyings, unit);
  const bool is_point = has_point(state, unit);
  const std::array<int, 4> more = point_quantities(state.varyings, state.texture_units[unit].mapping);
  const int first = x & ~3;
  const int group_count = lod_groups_in(x, count);
  for (int g = 0; g < group_count; g += lanes) {
    auto center = hn::Add(hn::Mul(lanes_from(d, static_cast<float>(g)), hn::Set(d, 4.0f)),
                          hn::Set(d, static_cast<float>(first) + 1.5f));
    center = minimum(maximum(center, hn::Set(d, static_cast<float>(span.anchor))),
                     hn::Set(d, static_cast<float>(span.last)));
    const auto k = hn::Sub(center, hn::Set(d, static_cast<float>(span.anchor)));
    const auto append = [&](std::size_t i, int quantity) HWY_ATTR {
      const auto dx = hn::Set(d, span.planes->slope_x[quantity]);
      hn::StoreU(hn::Add(hn::Set(d, span.row[quantity]), hn::Mul(dx, k)), d, groups.value[i] + at + g);
      hn::StoreU(dx, d, groups.dx[i] + at + g);
      hn::StoreU(hn::Set(d, span.planes->slope_y[quantity]), d, groups.dy[i] + at + g);
    };
    for (std::size_t i = 0; i < quantities.size(); ++i) append(i, quantities[i]);
    if (!is_point) continue;
    for (std::size_t i = 0; i < more.size() && more[i] != kAbsent; ++i) append(3 + i, more[i]);
  }
}

/// One value for each of `channels` arrays, clamped to [0, 1] if asked, for `count` fragments from `at` on.
HWY_INLINE void fill(const float* values, int channels, bool clamp, int count, float (*out)[kBatchStride],
                     int at) {
  const hn::ScalableTag<float> d;
  for (int c = 0; c < channels; ++c) {
    const auto value = hn::Set(d, values[c]);
    const auto v = clamp ? clamp01(value) : value;
    for (int i = 0; i < count; i += static_cast<int>(hn::Lanes(d))) hn::StoreU(v, d, out[c] + at + i);
  }
}

/// The colours that no varying carries are the same for every fragment of the primitive.
HWY_INLINE void fill_flat(const FlatColors& flat, const KernelKey& key, bool clamp, int count,
                          FragmentBatch& batch, int at) {
  if (key.fills_primary) fill(flat.color, 4, clamp, count, batch.color, at);
  if (key.fills_secondary) fill(flat.specular, 3, clamp, count, batch.specular, at);
}

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
