// The first steps of the vertex stage on vectors: from the caller's arrays to eye space, normals and window
// positions. Each function reads and writes arrays of one VertexBatch.
#include "pipeline/vertex_batch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/kernels/transform.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "pipeline/kernels/vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::pipeline::HWY_NAMESPACE {

using I = hn::RebindToSigned<F>;
using U = hn::RebindToUnsigned<F>;

HWY_INLINE hn::Mask<F> is_bounded(V v) { return hn::Lt(hn::Abs(v), broadcast(kBound)); }
HWY_INLINE V bounded_or_zero(V v) { return hn::IfThenElseZero(is_bounded(v), v); }

HWY_INLINE void fill(float value, int count, float* out) {
  for (int i = 0; i < count; i += kLanes) hn::Store(broadcast(value), F(), out + i);
}

/// The vectors that lie wholly inside `count` packed elements. @return how many elements that were.
template <bool kBounded>
int fetch_packed(const float* from, int components, int count, BatchArray* out) {
  const F d;
  V element[4];
  int i = 0;
  for (; i + kLanes <= count; i += kLanes, from += components * kLanes) {
    if (components == 3) {
      hn::LoadInterleaved3(d, from, element[0], element[1], element[2]);
    } else if (components == 2) {
      hn::LoadInterleaved2(d, from, element[0], element[1]);
    } else {
      hn::LoadInterleaved4(d, from, element[0], element[1], element[2], element[3]);
    }
    for (int c = 0; c < components; ++c) {
      hn::Store(kBounded ? bounded_or_zero(element[c]) : element[c], d, out[c] + i);
    }
  }
  return i;
}

void FetchAttribute(const Attribute& attribute, const glm::vec4& constant, std::uint32_t first, int count,
                    int components, bool bound, BatchArray* out) {
  const int padded = (count + kVertexPadding - 1) / kVertexPadding * kVertexPadding;
  const int given = attribute.data != nullptr ? attribute.components : 0;
  for (int c = given; c < components; ++c) {
    fill(bounded(given == 0 ? constant[c] : (c == 3 ? 1.0f : 0.0f)), padded, out[c]);
  }
  if (given == 0) return;
  const auto stride = static_cast<std::size_t>(attribute.stride);
  const float* from = attribute.data + static_cast<std::size_t>(first) * stride;
  int fetched = 0;
  if (attribute.stride == given && given <= components) {
    fetched =
        bound ? fetch_packed<true>(from, given, count, out) : fetch_packed<false>(from, given, count, out);
  }
  const int wanted = given < components ? given : components;
  for (int c = 0; c < wanted; ++c) {
    for (int i = fetched; i < padded; ++i) {
      const float value =
          i < count ? from[static_cast<std::size_t>(i) * stride + static_cast<std::size_t>(c)] : 0.0f;
      const bool keep = !bound || (value < kBound && value > -kBound);
      out[c][i] = keep ? value : 0.0f;
    }
  }
}

struct Vec4 {
  V x, y, z, w;
};

/// One row of a matrix times a position.
HWY_INLINE V row_times(const glm::mat4& m, int row, const Vec4& p) {
  const V xy = hn::Add(hn::Mul(broadcast(m[0][row]), p.x), hn::Mul(broadcast(m[1][row]), p.y));
  return hn::Add(hn::Add(xy, hn::Mul(broadcast(m[2][row]), p.z)), hn::Mul(broadcast(m[3][row]), p.w));
}

HWY_INLINE V plane_distance(const glm::vec4& plane, const Vec4& p) {
  const V xy = hn::Add(hn::Mul(broadcast(plane.x), p.x), hn::Mul(broadcast(plane.y), p.y));
  return hn::Add(hn::Add(xy, hn::Mul(broadcast(plane.z), p.z)), hn::Mul(broadcast(plane.w), p.w));
}

HWY_INLINE hn::Vec<U> code_where(hn::Mask<F> mask, std::uint32_t code) {
  return hn::IfThenElseZero(hn::RebindMask(U(), mask), hn::Set(U(), code));
}

/// Outcode against the view volume. `placed`: the lanes that have a window position.
HWY_INLINE hn::Vec<U> outcodes(const Vec4& clip, const VertexTransform& transform, hn::Mask<F> finite,
                               hn::Mask<F> placed) {
  const F d;
  const bool depth_clamp = transform.depth_clamp;
  const auto inside_xy = hn::And(hn::Le(hn::Abs(clip.x), clip.w), hn::Le(hn::Abs(clip.y), clip.w));
  const auto inside_z = depth_clamp ? placed : hn::Le(hn::Abs(clip.z), clip.w);
  if (hn::AllTrue(d, hn::And(hn::And(inside_xy, inside_z), hn::And(finite, placed)))) return hn::Zero(U());
  const V minus_w = hn::Neg(clip.w);
  const V reach_x = hn::Mul(clip.w, broadcast(transform.side_reach.x));
  const V reach_y = hn::Mul(clip.w, broadcast(transform.side_reach.y));
  auto code = hn::Or(code_where(hn::Lt(clip.x, hn::Neg(reach_x)), kOutsideLeft),
                     code_where(hn::Gt(clip.x, reach_x), kOutsideRight));
  code = hn::Or(code, code_where(hn::Lt(clip.y, hn::Neg(reach_y)), kOutsideBottom));
  code = hn::Or(code, code_where(hn::Gt(clip.y, reach_y), kOutsideTop));
  if (!depth_clamp) {
    code = hn::Or(code, code_where(hn::Lt(clip.z, minus_w), kOutsideNear));
    code = hn::Or(code, code_where(hn::Gt(clip.z, clip.w), kOutsideFar));
  }
  code = hn::Or(code, code_where(hn::Not(placed), kOffGuardBand));
  return hn::Or(code, code_where(hn::Not(finite), kNotANumber));
}

HWY_INLINE hn::Vec<U> plane_codes(const VertexTransform& transform, const Vec4& object) {
  auto code = hn::Zero(U());
  for (int plane = 0; plane < transform.plane_count; ++plane) {
    const V distance = plane_distance(transform.planes[plane], object);
    code = hn::Or(code, code_where(hn::Lt(distance, hn::Zero(F())), 1u << plane));
  }
  return code;
}

/// floor(v·256 + ½) << 8: window coordinate in 1/256 pixel, making room for a code.
HWY_INLINE hn::Vec<U> snapped(V window, hn::Mask<F> placed) {
  const V units =
      hn::Add(hn::Mul(window, broadcast(static_cast<float>(raster::kSubpixelUnits))), broadcast(0.5f));
  const auto coordinate = hn::ConvertTo(I(), hn::Floor(hn::IfThenElseZero(placed, units)));
  return hn::ShiftLeft<kOutcodeBits>(hn::BitCast(U(), coordinate));
}

HWY_INLINE V to_window(const VertexTransform& transform, int axis, V clip, V q) {
  return hn::Add(hn::Mul(hn::Mul(clip, q), broadcast(transform.window_scale[axis])),
                 broadcast(transform.window_offset[axis]));
}

void ProjectPositions(const VertexTransform& transform, VertexBatch& batch, PackedPosition* positions) {
  const F d;
  const V guard = broadcast(kGuardLimitPixels);
  for (int i = 0; i < batch.count; i += kLanes) {
    Vec4 object{hn::Load(d, batch.object[0] + i), hn::Load(d, batch.object[1] + i),
                hn::Load(d, batch.object[2] + i), hn::Load(d, batch.object[3] + i)};
    const auto finite = hn::And(hn::And(is_bounded(object.x), is_bounded(object.y)),
                                hn::And(is_bounded(object.z), is_bounded(object.w)));
    object = {hn::IfThenElseZero(finite, object.x), hn::IfThenElseZero(finite, object.y),
              hn::IfThenElseZero(finite, object.z), hn::IfThenElseZero(finite, object.w)};
    hn::Store(object.x, d, batch.object[0] + i);
    hn::Store(object.y, d, batch.object[1] + i);
    hn::Store(object.z, d, batch.object[2] + i);
    hn::Store(object.w, d, batch.object[3] + i);

    Vec4 clip{row_times(transform.clip_from_object, 0, object),
              row_times(transform.clip_from_object, 1, object),
              row_times(transform.clip_from_object, 2, object), broadcast(1.0f)};
    V q = clip.w;
    auto has_w = finite;
    if (!transform.unit_w) {
      clip.w = row_times(transform.clip_from_object, 3, object);
      has_w = hn::Ge(clip.w, broadcast(kMinW));
      q = hn::Div(broadcast(1.0f), hn::IfThenElse(has_w, clip.w, broadcast(1.0f)));
    }
    const V x = to_window(transform, 0, clip.x, q);
    const V y = to_window(transform, 1, clip.y, q);
    const auto placed = hn::And(has_w, hn::And(hn::Le(hn::Abs(x), guard), hn::Le(hn::Abs(y), guard)));
    const V z = to_window(transform, 2, clip.z, q);
    hn::Store(transform.depth_clamp ? clamp_to_bound(z) : clamp01(z), d, batch.depth + i);
    hn::Store(q, d, batch.q + i);
    const auto x_and_code = hn::Or(snapped(x, placed), outcodes(clip, transform, finite, placed));
    const auto y_and_code = hn::Or(snapped(y, placed), plane_codes(transform, object));
    hn::StoreInterleaved2(x_and_code, y_and_code, U(), &positions[i].x);
  }
}

void TransformToEye(const VertexTransform& transform, VertexBatch& batch, bool with_point) {
  const F d;
  for (int i = 0; i < batch.count; i += kLanes) {
    const Vec4 object{hn::Load(d, batch.object[0] + i), hn::Load(d, batch.object[1] + i),
                      hn::Load(d, batch.object[2] + i), hn::Load(d, batch.object[3] + i)};
    V w = broadcast(1.0f);
    if (!transform.unit_eye_w) w = clamp_to_bound(row_times(transform.eye_from_object, 3, object));
    hn::Store(w, d, batch.eye[3] + i);
    const V inverse_w = hn::Div(broadcast(1.0f), hn::IfThenElse(hn::Eq(w, hn::Zero(d)), broadcast(1.0f), w));
    for (int axis = 0; axis < 3; ++axis) {
      const V eye = clamp_to_bound(row_times(transform.eye_from_object, axis, object));
      hn::Store(eye, d, batch.eye[axis] + i);
      if (!with_point) continue;
      hn::Store(transform.unit_eye_w ? eye : clamp_to_bound(hn::Mul(eye, inverse_w)), d,
                batch.point[axis] + i);
    }
  }
}

void TransformNormals(const VertexTransform& transform, VertexBatch& batch) {
  const F d;
  const glm::mat3& m = transform.eye_normal_from_object;
  const Vec3 columns[3] = {broadcast(m[0]), broadcast(m[1]), broadcast(m[2])};
  for (int i = 0; i < batch.count; i += kLanes) {
    const Vec3 n{hn::Load(d, batch.normal[0] + i), hn::Load(d, batch.normal[1] + i),
                 hn::Load(d, batch.normal[2] + i)};
    Vec3 eye = plus(plus(times(columns[0], n.x), times(columns[1], n.y)), times(columns[2], n.z));
    eye = {clamp_to_bound(eye.x), clamp_to_bound(eye.y), clamp_to_bound(eye.z)};
    if (transform.normalize) eye = normalized(eye);
    hn::Store(eye.x, d, batch.normal[0] + i);
    hn::Store(eye.y, d, batch.normal[1] + i);
    hn::Store(eye.z, d, batch.normal[2] + i);
  }
}

HWY_INLINE Vec3 load_columns(const BatchArray* from, int i) {
  const F d;
  return {hn::Load(d, from[0] + i), hn::Load(d, from[1] + i), hn::Load(d, from[2] + i)};
}

void TransformTangents(const VertexTransform& transform, bool has_bitangent, bool to_unit,
                       VertexBatch& batch) {
  const F d;
  const glm::mat4& m = transform.eye_from_object;
  const Vec3 columns[3] = {broadcast(glm::vec3(m[0])), broadcast(glm::vec3(m[1])),
                           broadcast(glm::vec3(m[2]))};
  const auto store = [&](const Vec3& v, BatchArray* to, int i) HWY_ATTR {
    Vec3 eye = plus(plus(times(columns[0], v.x), times(columns[1], v.y)), times(columns[2], v.z));
    eye = {clamp_to_bound(eye.x), clamp_to_bound(eye.y), clamp_to_bound(eye.z)};
    if (to_unit) eye = normalized(eye);
    hn::Store(eye.x, d, to[0] + i);
    hn::Store(eye.y, d, to[1] + i);
    hn::Store(eye.z, d, to[2] + i);
  };
  for (int i = 0; i < batch.count; i += kLanes) {
    const Vec3 tangent = load_columns(batch.tangents, i);
    Vec3 bitangent = load_columns(batch.tangents + 3, i);
    if (!has_bitangent) {
      const Vec3 n = load_columns(batch.normal, i);
      const V w = hn::Load(d, batch.tangents[3] + i);
      bitangent = times(cross(n, tangent), w);
      bitangent = {clamp_to_bound(bitangent.x), clamp_to_bound(bitangent.y), clamp_to_bound(bitangent.z)};
    }
    store(tangent, batch.tangents, i);
    store(bitangent, batch.tangents + 3, i);
  }
}

void BoundColumn(int count, bool to_unit, float* column) {
  const F d;
  for (int i = 0; i < count; i += kLanes) {
    const V v = hn::Load(d, column + i);
    hn::Store(to_unit ? clamp01(v) : clamp_to_bound(v), d, column + i);
  }
}

}  // namespace barrido::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace barrido::pipeline {

HWY_EXPORT(FetchAttribute);
HWY_EXPORT(ProjectPositions);
HWY_EXPORT(TransformToEye);
HWY_EXPORT(TransformNormals);
HWY_EXPORT(TransformTangents);
HWY_EXPORT(BoundColumn);

void fetch_attribute(const Attribute& attribute, const glm::vec4& constant, std::uint32_t first, int count,
                     int components, bool bound, BatchArray* out) {
  HWY_DYNAMIC_DISPATCH(FetchAttribute)(attribute, constant, first, count, components, bound, out);
}

void project_positions(const VertexTransform& transform, VertexBatch& batch, PackedPosition* positions) {
  HWY_DYNAMIC_DISPATCH(ProjectPositions)(transform, batch, positions);
}

void transform_to_eye(const VertexTransform& transform, VertexBatch& batch, bool with_point) {
  HWY_DYNAMIC_DISPATCH(TransformToEye)(transform, batch, with_point);
}

void transform_normals(const VertexTransform& transform, VertexBatch& batch) {
  HWY_DYNAMIC_DISPATCH(TransformNormals)(transform, batch);
}

void transform_tangents(const VertexTransform& transform, bool has_bitangent, bool to_unit,
                        VertexBatch& batch) {
  HWY_DYNAMIC_DISPATCH(TransformTangents)(transform, has_bitangent, to_unit, batch);
}

void bound_column(int count, bool clamp01, float* column) {
  HWY_DYNAMIC_DISPATCH(BoundColumn)(count, clamp01, column);
}

}  // namespace barrido::pipeline
#endif
