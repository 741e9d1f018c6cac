#include "pipeline/scene/prepared_geometry.h"

#include <limits>

#include <glm/common.hpp>

#include "pipeline/scene/normals.h"
#include "pipeline/scene/triangles.h"

namespace barrido::scene {
namespace {

pipeline::Attribute attribute(std::span<const float> values, int components) {
  if (values.empty()) return {};
  return {values.data(), components, components};
}

std::vector<float> gathered(std::span<const float> values, std::size_t components,
                            std::span<const std::uint32_t> source) {
  std::vector<float> result;
  if (values.empty()) return result;
  result.reserve(source.size() * components);
  for (const std::uint32_t vertex : source) {
    const float* element = values.data() + components * vertex;
    result.insert(result.end(), element, element + components);
  }
  return result;
}

glm::vec3 center_of(std::span<const float> positions) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  glm::vec3 low(kInfinity), high(-kInfinity);
  for (std::size_t i = 0; i + 2 < positions.size(); i += 3) {
    const glm::vec3 p(positions[i], positions[i + 1], positions[i + 2]);
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return low.x <= high.x ? low * 0.5f + high * 0.5f : glm::vec3(0.0f);
}

/// All arrays as the primitive has them.
void view_in_place(PreparedGeometry& out, const Primitive& primitive, std::span<const float> positions,
                   std::span<const float> normals) {
  out.geometry.mode = primitive.mode;
  out.geometry.vertex_count = primitive.vertex_count;
  out.geometry.position = attribute(positions, 3);
  out.geometry.normal = attribute(normals, 3);
  out.geometry.indices = primitive.indices;
  out.colors = attribute(primitive.colors.values(), 4);
  for (std::size_t set = 0; set < 2; ++set) {
    out.texcoord_sets[set] = attribute(primitive.texcoords[set].values(), 2);
  }
}

/// New arrays in which every vertex has a normal.
void split_for_normals(PreparedGeometry& out, const Primitive& primitive, std::span<const float> positions,
                       std::optional<float> crease_angle_deg) {
  const std::vector<std::uint32_t> triangles =
      triangle_list(primitive.mode, primitive.indices, primitive.vertex_count);
  NormalSplit split = crease_angle_deg ? averaged_normals(positions, triangles, *crease_angle_deg)
                                       : flat_normals(positions, triangles);
  out.positions = gathered(positions, 3, split.source);
  out.own_colors = gathered(primitive.colors.values(), 4, split.source);
  out.normals = std::move(split.normals);
  out.indices = std::move(split.indices);
  out.geometry.mode = pipeline::PrimitiveMode::triangles;
  out.geometry.vertex_count = static_cast<std::uint32_t>(split.source.size());
  out.geometry.position = attribute(out.positions, 3);
  out.geometry.normal = attribute(out.normals, 3);
  out.geometry.indices = out.indices;
  out.colors = attribute(out.own_colors, 4);
  for (std::size_t set = 0; set < 2; ++set) {
    out.texcoords[set] = gathered(primitive.texcoords[set].values(), 2, split.source);
    out.texcoord_sets[set] = attribute(out.texcoords[set], 2);
  }
}

void fill(PreparedGeometry& out, const Primitive& primitive, std::span<const float> positions,
          std::span<const float> normals, std::optional<float> crease_angle_deg) {
  out.center = center_of(positions);
  if (normals.empty() && is_surface(primitive.mode)) {
    split_for_normals(out, primitive, positions, crease_angle_deg);
  } else {
    view_in_place(out, primitive, positions, normals);
  }
}

}  // namespace

std::unique_ptr<PreparedGeometry> prepare(const Primitive& primitive, std::optional<float> crease_angle_deg) {
  auto prepared = std::make_unique<PreparedGeometry>();
  fill(*prepared, primitive, primitive.positions.values(), primitive.normals.values(), crease_angle_deg);
  return prepared;
}

std::unique_ptr<PreparedGeometry> prepare_deformed(const Primitive& primitive, DeformedVertices vertices,
                                                   std::optional<float> crease_angle_deg) {
  auto prepared = std::make_unique<PreparedGeometry>();
  prepared->deformed = std::move(vertices);
  fill(*prepared, primitive, prepared->deformed.positions, prepared->deformed.normals, crease_angle_deg);
  return prepared;
}

pipeline::Attribute colors_times(PreparedGeometry& prepared, const glm::vec4& scale) {
  if (prepared.colors.data == nullptr || scale == glm::vec4(1.0f)) return prepared.colors;
  std::vector<float>& scaled = prepared.scaled_colors[{scale.r, scale.g, scale.b, scale.a}];
  if (scaled.empty()) {
    const std::size_t floats = std::size_t{4} * prepared.geometry.vertex_count;
    scaled.resize(floats);
    for (std::size_t i = 0; i < floats; ++i) {
      scaled[i] = prepared.colors.data[i] * scale[static_cast<int>(i % 4)];
    }
  }
  return attribute(scaled, 4);
}

PreparedGeometry& GeometryCache::get(int mesh, int primitive, std::optional<float> crease_angle_deg) {
  const Primitive& source =
      scene_.meshes[static_cast<std::size_t>(mesh)].primitives[static_cast<std::size_t>(primitive)];
  const bool needs_normals = source.normals.empty() && is_surface(source.mode);
  if (!needs_normals) crease_angle_deg.reset();
  auto& slot = prepared_[{mesh, primitive, crease_angle_deg.value_or(-1.0f)}];
  if (!slot) slot = prepare(source, crease_angle_deg);
  return *slot;
}

}  // namespace barrido::scene
