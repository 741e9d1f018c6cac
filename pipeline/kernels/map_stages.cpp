// Maps that are read before light, on vectors of fragments: see map_stages.h for the formulas. Enters and
// leaves a batch with its texels.
#include "pipeline/map_stages.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/kernels/map_stages.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "pipeline/kernels/vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::pipeline::HWY_NAMESPACE {

HWY_INLINE Vec3 load3(const BatchRow* rows, int i) {
  const F d;
  return {hn::Load(d, rows[0] + i), hn::Load(d, rows[1] + i), hn::Load(d, rows[2] + i)};
}

HWY_INLINE void store3(const Vec3& v, BatchRow* rows, int i) {
  const F d;
  hn::Store(v.x, d, rows[0] + i);
  hn::Store(v.y, d, rows[1] + i);
  hn::Store(v.z, d, rows[2] + i);
}

/// 2t − 1
HWY_INLINE V signed_texel(V texel) { return hn::Sub(hn::Add(texel, texel), broadcast(1.0f)); }

void ApplyNormalMap(float strength, const BatchRow* texel, raster::FragmentBatch& batch) {
  const raster::VaryingList& varyings = batch.state->varyings;
  BatchRow* normal = batch.varying + varyings.at(raster::Meaning::normal);
  const BatchRow* tangents = batch.varying + varyings.at(raster::Meaning::tangents);
  for (int i = 0; i < batch.count; i += kLanes) {
    const Vec3 t = load3(texel, i);
    const V x = hn::Mul(signed_texel(t.x), broadcast(strength));
    const V y = hn::Mul(signed_texel(t.y), broadcast(strength));
    const Vec3 in_plane = plus(times(load3(tangents, i), x), times(load3(tangents + 3, i), y));
    store3(plus(in_plane, times(load3(normal, i), signed_texel(t.z))), normal, i);
  }
}

void ShiftCoordinate(const float* from, const float* q, float step, int count, float* to) {
  const F d;
  for (int i = 0; i < count; i += kLanes) {
    const V shift = q != nullptr ? hn::Mul(hn::LoadU(d, q + i), broadcast(step)) : broadcast(step);
    hn::StoreU(hn::Add(hn::LoadU(d, from + i), shift), d, to + i);
  }
}

void TakeHeights(const BatchRow* texel, int count, float* heights) {
  for (int i = 0; i < count; i += kLanes) {
    const Vec3 t = load3(texel, i);
    hn::Store(hn::Mul(hn::Add(hn::Add(t.x, t.y), t.z), broadcast(1.0f / 3.0f)), F(), heights + i);
  }
}

void TakeSlopes(const float* heights, float scale, int count, float* slope) {
  const F d;
  for (int i = 0; i < count; i += kLanes) {
    const V difference = hn::Sub(hn::Load(d, slope + i), hn::Load(d, heights + i));
    hn::Store(hn::Mul(difference, broadcast(scale)), d, slope + i);
  }
}

/// `a` times the unit vector along `v`.
HWY_INLINE Vec3 of_length(const Vec3& v, V a) { return times(v, hn::Mul(a, inverse_length(dot(v, v)))); }

void TiltNormals(raster::BumpForm form, const BatchRow* slopes, raster::FragmentBatch& batch) {
  const F d;
  const raster::VaryingList& varyings = batch.state->varyings;
  BatchRow* normal = batch.varying + varyings.at(raster::Meaning::normal);
  const BatchRow* tangents = batch.varying + varyings.at(raster::Meaning::tangents);
  for (int i = 0; i < batch.count; i += kLanes) {
    const Vec3 n = normalized(load3(normal, i));
    const Vec3 pu = load3(tangents, i), pv = load3(tangents + 3, i);
    const V fu = hn::Load(d, slopes[0] + i), fv = hn::Load(d, slopes[1] + i);
    Vec3 tilt = minus(times(cross(n, pv), fu), times(cross(n, pu), fv));
    V area = dot(cross(pu, pv), n);
    const auto inwards = hn::Lt(area, hn::Zero(d));
    const auto outwards = [&](V v) HWY_ATTR { return hn::IfThenElse(inwards, hn::Neg(v), v); };
    tilt = {outwards(tilt.x), outwards(tilt.y), outwards(tilt.z)};
    area = outwards(area);
    if (form == raster::BumpForm::blinn) {
      store3(plus(times(n, area), tilt), normal, i);
    } else {
      const V a = hn::Sqrt(hn::Add(hn::Mul(fu, fu), hn::Mul(fv, fv)));
      store3(plus(n, of_length(tilt, a)), normal, i);
    }
  }
}

void TiltNormalsInSpace(raster::BumpForm form, const glm::mat3& eye_gradient, const BatchRow* slopes,
                        raster::FragmentBatch& batch) {
  BatchRow* normal = batch.varying + batch.state->varyings.at(raster::Meaning::normal);
  const Vec3 columns[3] = {broadcast(eye_gradient[0]), broadcast(eye_gradient[1]),
                           broadcast(eye_gradient[2])};
  for (int i = 0; i < batch.count; i += kLanes) {
    const Vec3 n = normalized(load3(normal, i));
    const Vec3 f = load3(slopes, i);
    const Vec3 g = plus(plus(times(columns[0], f.x), times(columns[1], f.y)), times(columns[2], f.z));
    const Vec3 along_surface = minus(g, times(n, dot(n, g)));
    if (form == raster::BumpForm::blinn) {
      store3(minus(n, along_surface), normal, i);
      continue;
    }
    const Vec3 own = normalized({dot(columns[0], n), dot(columns[1], n), dot(columns[2], n)});
    const V off = dot(f, own);
    const V a = hn::Sqrt(positive(hn::Sub(dot(f, f), hn::Mul(off, off))));
    store3(minus(n, of_length(along_surface, a)), normal, i);
  }
}

void ApplyOcclusion(float strength, const BatchRow* texel, raster::FragmentBatch& batch) {
  const F d;
  float* share = batch.varying[batch.state->varyings.at(raster::Meaning::occlusion)];
  const V one = broadcast(1.0f);
  for (int i = 0; i < batch.count; i += kLanes) {
    const V lost = hn::Mul(hn::Sub(hn::Load(d, texel[0] + i), one), broadcast(strength));
    hn::Store(hn::Add(lost, one), d, share + i);
  }
}

}  // namespace barrido::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace barrido::pipeline {

HWY_EXPORT(ApplyNormalMap);
HWY_EXPORT(ShiftCoordinate);
HWY_EXPORT(TakeHeights);
HWY_EXPORT(TakeSlopes);
HWY_EXPORT(TiltNormals);
HWY_EXPORT(TiltNormalsInSpace);
HWY_EXPORT(ApplyOcclusion);

void apply_normal_map(float strength, const BatchRow* texel, raster::FragmentBatch& batch) {
  HWY_DYNAMIC_DISPATCH(ApplyNormalMap)(strength, texel, batch);
}

void shift_coordinate(const float* from, const float* q, float step, int count, float* to) {
  HWY_DYNAMIC_DISPATCH(ShiftCoordinate)(from, q, step, count, to);
}

void take_heights(const BatchRow* texel, int count, float* heights) {
  HWY_DYNAMIC_DISPATCH(TakeHeights)(texel, count, heights);
}

void take_slopes(const float* heights, float scale, int count, float* slope) {
  HWY_DYNAMIC_DISPATCH(TakeSlopes)(heights, scale, count, slope);
}

void tilt_normals(raster::BumpForm form, const BatchRow* slopes, raster::FragmentBatch& batch) {
  HWY_DYNAMIC_DISPATCH(TiltNormals)(form, slopes, batch);
}

void tilt_normals_in_space(raster::BumpForm form, const glm::mat3& eye_gradient, const BatchRow* slopes,
                           raster::FragmentBatch& batch) {
  HWY_DYNAMIC_DISPATCH(TiltNormalsInSpace)(form, eye_gradient, slopes, batch);
}

void apply_occlusion(float strength, const BatchRow* texel, raster::FragmentBatch& batch) {
  HWY_DYNAMIC_DISPATCH(ApplyOcclusion)(strength, texel, batch);
}

}  // namespace barrido::pipeline
#endif
