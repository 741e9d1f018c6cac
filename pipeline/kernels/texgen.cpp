// Texture coordinate generation and the texture matrix on vectors (OpenGL 1.3, section 2.10.4).
#include "pipeline/vertex_batch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/kernels/texgen.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "pipeline/kernels/vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::pipeline::HWY_NAMESPACE {

HWY_INLINE V plane_times(const glm::vec4& plane, const BatchArray* position, int i) {
  const F d;
  const V xy = hn::Add(hn::Mul(broadcast(plane.x), hn::Load(d, position[0] + i)),
                       hn::Mul(broadcast(plane.y), hn::Load(d, position[1] + i)));
  return hn::Add(hn::Add(xy, hn::Mul(broadcast(plane.z), hn::Load(d, position[2] + i))),
                 hn::Mul(broadcast(plane.w), hn::Load(d, position[3] + i)));
}

void linear(const glm::vec4& plane, const VertexBatch& batch, const BatchArray* position, float* out) {
  for (int i = 0; i < batch.count; i += kLanes) {
    hn::Store(clamp_to_bound(plane_times(plane, position, i)), F(), out + i);
  }
}

/// r = u − 2 n (n·u), u the unit vector from the eye to the vertex.
HWY_INLINE Vec3 reflection(const VertexBatch& batch, int i) {
  const Vec3 u = normalized(load3({batch.point[0], batch.point[1], batch.point[2]}, i));
  const Vec3 n = load3({batch.normal[0], batch.normal[1], batch.normal[2]}, i);
  const V n_dot_u = dot(n, u);
  return minus(u, times(n, hn::Add(n_dot_u, n_dot_u)));
}

HWY_INLINE V component(const Vec3& v, std::size_t axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

void reflection_map(const VertexBatch& batch, std::size_t axis, float* out) {
  for (int i = 0; i < batch.count; i += kLanes) {
    hn::Store(clamp_to_bound(component(reflection(batch, i), axis)), F(), out + i);
  }
}

/// s = r_x/m + ½, t = r_y/m + ½, m = 2 √(r_x² + r_y² + (r_z + 1)²).
void sphere_map(const VertexBatch& batch, std::size_t axis, float* out) {
  const V half = broadcast(0.5f);
  for (int i = 0; i < batch.count; i += kLanes) {
    const Vec3 r = reflection(batch, i);
    const Vec3 middle{clamp_to_bound(r.x), clamp_to_bound(r.y),
                      hn::Add(clamp_to_bound(r.z), broadcast(1.0f))};
    const V inverse_m = hn::Mul(half, inverse_length(dot(middle, middle)));
    hn::Store(hn::Add(hn::Mul(component(middle, axis), inverse_m), half), F(), out + i);
  }
}

void copy(const VertexBatch& batch, const float* from, float* out) {
  for (int i = 0; i < batch.count; i += kLanes) hn::Store(hn::Load(F(), from + i), F(), out + i);
}

void generate(const TexGenCoordinate& rule, std::size_t axis, const VertexBatch& batch, float* out) {
  switch (rule.mode) {
    case TexGenMode::object_linear:
      return linear(rule.object_plane, batch, batch.object, out);
    case TexGenMode::eye_linear:
      return linear(rule.eye_plane, batch, batch.eye, out);
    case TexGenMode::sphere_map:
      return sphere_map(batch, axis, out);
    case TexGenMode::reflection_map:
      return reflection_map(batch, axis, out);
    case TexGenMode::normal_map:
      return copy(batch, batch.normal[axis], out);
  }
}

void multiply(const glm::mat4& m, int count, BatchArray* coordinate) {
  const F d;
  for (int i = 0; i < count; i += kLanes) {
    V product[4];
    for (int row = 0; row < 4; ++row) {
      product[row] = plane_times({m[0][row], m[1][row], m[2][row], m[3][row]}, coordinate, i);
    }
    for (int row = 0; row < 4; ++row) hn::Store(product[row], d, coordinate[row] + i);
  }
}

void GenerateCoordinates(const TextureCoordinates& rules, const VertexBatch& batch, BatchArray* coordinate) {
  for (std::size_t axis = 0; axis < 4; ++axis) {
    const TexGenCoordinate& rule = rules.generation[axis];
    if (rule.enabled) generate(rule, axis, batch, coordinate[axis]);
  }
  if (rules.matrix != glm::mat4(1.0f)) multiply(rules.matrix, batch.count, coordinate);
}

}  // namespace barrido::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace barrido::pipeline {

HWY_EXPORT(GenerateCoordinates);

void generate_coordinates(const TextureCoordinates& rules, const VertexBatch& batch, BatchArray* coordinate) {
  HWY_DYNAMIC_DISPATCH(GenerateCoordinates)(rules, batch, coordinate);
}

}  // namespace barrido::pipeline
#endif
