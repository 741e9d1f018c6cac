// Small vector algebra on lanes, for the pipeline's kernels. Included once per target by Highway's
// foreach_target mechanism. No operation here gives different bits on different targets: no fused
// multiply-add, and no minimum or maximum of zeros of different sign or of NaN.
#if defined(BARRIDO_PIPELINE_VECTORS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BARRIDO_PIPELINE_VECTORS_INL_H
#undef BARRIDO_PIPELINE_VECTORS_INL_H
#else
#define BARRIDO_PIPELINE_VECTORS_INL_H
#endif

#include <array>

#include <hwy/highway.h>

#include "pipeline/bounded.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::pipeline::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::ScalableTag<float>;
using V = hn::Vec<F>;
inline constexpr int kLanes = static_cast<int>(hn::MaxLanes(F()));

/// A 3-vector in every lane.
struct Vec3 {
  V x, y, z;
};

HWY_INLINE V broadcast(float value) { return hn::Set(F(), value); }
HWY_INLINE Vec3 broadcast(const glm::vec3& v) { return {broadcast(v.x), broadcast(v.y), broadcast(v.z)}; }

HWY_INLINE Vec3 load3(const std::array<const float*, 3>& from, int i) {
  const F d;
  return {hn::Load(d, from[0] + i), hn::Load(d, from[1] + i), hn::Load(d, from[2] + i)};
}

HWY_INLINE V dot(const Vec3& a, const Vec3& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_INLINE Vec3 plus(const Vec3& a, const Vec3& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_INLINE Vec3 minus(const Vec3& a, const Vec3& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Vec3 cross(const Vec3& a, const Vec3& b) {
  return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
          hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}
HWY_INLINE Vec3 times(const Vec3& a, V s) { return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)}; }
HWY_INLINE Vec3 negative(const Vec3& a) { return {hn::Neg(a.x), hn::Neg(a.y), hn::Neg(a.z)}; }

/// max(v, 0), the same zero everywhere.
HWY_INLINE V positive(V v) { return hn::IfThenElseZero(hn::Gt(v, hn::Zero(F())), v); }
HWY_INLINE V clamp01(V v) { return hn::Min(positive(v), broadcast(1.0f)); }
HWY_INLINE V clamp_to_bound(V v) { return hn::Min(hn::Max(v, broadcast(-kBound)), broadcast(kBound)); }

/// Squares of lengths below this count as it, so that a zero vector stays zero.
inline constexpr float kMinSquare = 1e-30f;

/// 1/√square.
HWY_INLINE V inverse_length(V square) {
  return hn::Div(broadcast(1.0f), hn::Sqrt(hn::Max(square, broadcast(kMinSquare))));
}
HWY_INLINE Vec3 normalized(const Vec3& v) { return times(v, inverse_length(dot(v, v))); }

}  // namespace barrido::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
