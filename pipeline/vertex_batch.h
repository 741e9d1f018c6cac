// Vertices on their way through the vertex stage: a structure of arrays that stays in the first-level cache.
// Each step of the stage reads some of the arrays and writes others, whole vectors at a time.
#pragma once

#include <cstdint>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "pipeline/geometry.h"
#include "pipeline/packed_position.h"
#include "pipeline/state.h"
#include "raster/fragments/fragment_state.h"

namespace barrido::pipeline {

/// A multiple of every vector width. Arrays are filled up to the next multiple of kVertexPadding.
inline constexpr int kVertexBatch = 128;
inline constexpr int kVertexPadding = 16;
static_assert(kVertexBatch % kVertexPadding == 0);

using BatchArray = float[kVertexBatch];

struct VertexBatch {
  int count = 0;
  alignas(64) BatchArray object[4];    ///< Object space, homogeneous.
  alignas(64) BatchArray eye[4];       ///< Eye space, homogeneous.
  alignas(64) BatchArray point[3];     ///< Eye space, divided by w.
  alignas(64) BatchArray normal[3];    ///< Eye space.
  alignas(64) BatchArray tangents[6];  ///< Tangent and bitangent; eye space in the end.
  alignas(64) BatchArray color[4];     ///< As given.
  alignas(64) BatchArray lit[7];       ///< Lit colours of one side: primary, secondary.
  alignas(64) BatchArray depth;        ///< Window z.
  alignas(64) BatchArray q;            ///< 1/w; 1 where w is below kMinW.
  alignas(64) BatchArray coordinate[raster::kMaxTextureUnits][4];  ///< Texture coordinates.
  alignas(64) BatchArray dots[2 * raster::kMaxLights + 3];         ///< Cheap Phong.
};

/// What takes positions and normals through the spaces; all elements are bounded.
struct VertexTransform {
  glm::mat4 clip_from_object{1.0f};
  glm::mat4 eye_from_object{1.0f};
  glm::mat3 eye_normal_from_object{1.0f};
  bool normalize = false;    ///< Bring eye normals to unit length.
  bool unit_w = false;       ///< Clip w is 1 everywhere.
  bool unit_eye_w = false;   ///< Eye w is 1 everywhere.
  bool depth_clamp = false;  ///< No outcodes for near and far, depth unclamped.
  int plane_count = 0;
  glm::vec4 planes[kMaxClipPlanes];  ///< User clip planes in object space: kept where dot ≥ 0.
  /// How far the view volume reaches to either side, in shares of itself: samples may lie beside the frame.
  glm::vec2 side_reach{1.0f};
  glm::vec3 window_scale{1.0f};  ///< Window = ndc × scale + offset, per axis (OpenGL 1.3, section 2.10.1).
  glm::vec3 window_offset{0.0f};
};

/// Reads elements first … first + count − 1 of an array into `out`, the missing components being (0, 0, 0,
/// 1); absent arrays give `constant`. With `bound`, numbers that are not below kBound in magnitude become 0.
void fetch_attribute(const Attribute& attribute, const glm::vec4& constant, std::uint32_t first, int count,
                     int components, bool bound, BatchArray* out);

/// Object positions (not yet bounded; they are afterwards) to depth, q and packed window positions.
/// `positions` has room for the batch's count rounded up to kVertexPadding.
void project_positions(const VertexTransform& transform, VertexBatch& batch, PackedPosition* positions);

/// Fills `eye`, and `point` when asked for.
void transform_to_eye(const VertexTransform& transform, VertexBatch& batch, bool with_point);

/// Object-space normals in `normal` to eye-space ones.
void transform_normals(const VertexTransform& transform, VertexBatch& batch);

/// Tangents from object space to eye space, from `tangents` (the fourth is w where there is no bitangent) and
/// the normals of object space in `normal`; of unit length where asked for.
void transform_tangents(const VertexTransform& transform, bool has_bitangent, bool to_unit,
                        VertexBatch& batch);

/// Bounds an array, and clamps it to [0, 1] when asked to.
void bound_column(int count, bool clamp01, float* column);

/// Texture coordinates of one unit, from as given to generated (OpenGL 1.3, section 2.10.4) and multiplied by
/// the texture matrix.
void generate_coordinates(const TextureCoordinates& rules, const VertexBatch& batch, BatchArray* coordinate);

/// Writes vertex records: depth, q and columns, those from `affine_count` on multiplied by q. The last record
/// is followed by garbage up to kVertexPadding records.
void store_records(const VertexBatch& batch, const float* const* columns, int column_count, int affine_count,
                   float* records, int stride);

}  // namespace barrido::pipeline
