#include "pipeline/scene/prepared_geometry.h"

#include <limits>
#include <map>
#include <tuple>

#include <glm/common.hpp>

#include "pipeline/scene/normals.h"
#include "pipeline/scene/tangent_space.h"
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

/// What a primitive is made of, in the file or after it was deformed.
struct Vertices {
  pipeline::PrimitiveMode mode;
  std::uint32_t count;
  std::span<const float> positions, normals, tangents, colors;
  std::array<std::span<const float>, 2> texcoords;
  std::span<const std::uint32_t> indices;
  std::span<const float> rest;  ///< Positions before they were deformed
};

Vertices vertices_of(const Primitive& primitive) {
  return {primitive.mode,
          primitive.vertex_count,
          primitive.positions.values(),
          primitive.normals.values(),
          primitive.tangents.values(),
          primitive.colors.values(),
          {primitive.texcoords[0].values(), primitive.texcoords[1].values()},
          primitive.indices.values(),
          primitive.positions.values()};
}

glm::vec3 center_of(const Vertices& vertices) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const std::vector<bool> drawn = drawn_vertices(vertices.mode, vertices.indices, vertices.count);
  glm::vec3 low(kInfinity), high(-kInfinity);
  for (std::size_t i = 0; 3 * i + 2 < vertices.positions.size(); ++i) {
    if (!drawn.empty() && !drawn[i]) continue;
    const float* p = vertices.positions.data() + 3 * i;
    low = glm::min(low, glm::vec3(p[0], p[1], p[2]));
    high = glm::max(high, glm::vec3(p[0], p[1], p[2]));
  }
  return low.x <= high.x ? low * 0.5f + high * 0.5f : glm::vec3(0.0f);
}

/// All arrays as they are.
void view_in_place(PreparedGeometry& out, const Vertices& vertices) {
  out.geometry.mode = vertices.mode;
  out.geometry.vertex_count = vertices.count;
  out.geometry.position = attribute(vertices.positions, 3);
  out.geometry.normal = attribute(vertices.normals, 3);
  out.geometry.tangent = attribute(vertices.tangents, 4);
  out.geometry.indices = vertices.indices;
  out.colors = attribute(vertices.colors, 4);
  out.rest = attribute(vertices.rest, 3);
  for (std::size_t set = 0; set < 2; ++set) out.texcoord_sets[set] = attribute(vertices.texcoords[set], 2);
}

/// New arrays in which every vertex has a normal.
void split_for_normals(PreparedGeometry& out, const Vertices& vertices,
                       std::optional<float> crease_angle_deg) {
  const std::vector<std::uint32_t> triangles = triangle_list(vertices.mode, vertices.indices, vertices.count);
  NormalSplit split = crease_angle_deg ? averaged_normals(vertices.positions, triangles, *crease_angle_deg)
                                       : flat_normals(vertices.positions, triangles);
  out.positions = gathered(vertices.positions, 3, split.source);
  const bool is_deformed = vertices.rest.data() != vertices.positions.data();
  if (is_deformed) out.rest_positions = gathered(vertices.rest, 3, split.source);
  out.rest = attribute(is_deformed ? out.rest_positions : out.positions, 3);
  out.own_colors = gathered(vertices.colors, 4, split.source);
  out.normals = std::move(split.normals);
  out.indices = std::move(split.indices);
  out.geometry.mode = pipeline::PrimitiveMode::triangles;
  out.geometry.vertex_count = static_cast<std::uint32_t>(split.source.size());
  out.geometry.position = attribute(out.positions, 3);
  out.geometry.normal = attribute(out.normals, 3);
  out.geometry.indices = out.indices;
  out.colors = attribute(out.own_colors, 4);
  for (std::size_t set = 0; set < 2; ++set) {
    out.texcoords[set] = gathered(vertices.texcoords[set], 2, split.source);
    out.texcoord_sets[set] = attribute(out.texcoords[set], 2);
  }
}

void fill(PreparedGeometry& out, const Vertices& vertices, std::optional<float> crease_angle_deg) {
  out.center = center_of(vertices);
  if (vertices.normals.empty() && is_surface(vertices.mode)) {
    split_for_normals(out, vertices, crease_angle_deg);
  } else {
    view_in_place(out, vertices);
  }
}

std::span<const float> values_of(const pipeline::Attribute& attribute, std::uint32_t count) {
  return {attribute.data, static_cast<std::size_t>(attribute.components) * (attribute.data ? count : 0)};
}

/// (u, v) as they are looked up, with v upwards as tangents want it.
std::vector<float> places_on_map(std::span<const float> coordinates, const glm::mat3& transform) {
  std::vector<float> places(coordinates.size());
  for (std::size_t i = 0; i + 1 < coordinates.size(); i += 2) {
    const float u = coordinates[i], v = coordinates[i + 1];
    places[i] = (transform[0].x * u + transform[1].x * v) + transform[2].x;
    places[i + 1] = 1.0f - ((transform[0].y * u + transform[1].y * v) + transform[2].y);
  }
  return places;
}

/// Vertices of which each has one tangent.
struct TangentSplit {
  std::vector<std::uint32_t> source;   ///< Vertex before
  std::vector<std::size_t> corner;     ///< One that has the vertex's tangent
  std::vector<std::uint32_t> indices;  ///< Three a triangle
};

TangentSplit split_by_tangent(std::span<const std::uint32_t> triangles,
                              std::span<const CornerTangent> tangents) {
  TangentSplit split;
  using Key = std::tuple<std::uint32_t, float, float, float, bool>;
  std::map<Key, std::uint32_t> numbers;
  split.indices.reserve(triangles.size());
  for (std::size_t corner = 0; corner < triangles.size(); ++corner) {
    const CornerTangent& t = tangents[corner];
    const Key key{triangles[corner], t.tangent.x, t.tangent.y, t.tangent.z, t.keeps_orientation};
    const auto [slot, is_new] = numbers.try_emplace(key, static_cast<std::uint32_t>(split.source.size()));
    if (is_new) {
      split.source.push_back(triangles[corner]);
      split.corner.push_back(corner);
    }
    split.indices.push_back(slot->second);
  }
  return split;
}

void append(std::vector<float>& to, const glm::vec3& v) { to.insert(to.end(), {v.x, v.y, v.z}); }

void split_for_tangents(PreparedGeometry& out, const PreparedGeometry& from, TangentSplit split,
                        std::span<const CornerTangent> tangents, bool with_lengths) {
  const std::uint32_t count = from.geometry.vertex_count;
  out.center = from.center;
  out.geometry.mode = pipeline::PrimitiveMode::triangles;
  out.geometry.vertex_count = static_cast<std::uint32_t>(split.source.size());
  out.positions = gathered(values_of(from.geometry.position, count), 3, split.source);
  out.normals = gathered(values_of(from.geometry.normal, count), 3, split.source);
  out.own_colors = gathered(values_of(from.colors, count), 4, split.source);
  for (const std::size_t corner : split.corner) {
    const CornerTangent& t = tangents[corner];
    append(out.tangents, with_lengths ? t.tangent * t.tangent_length : t.tangent);
    if (!with_lengths) out.tangents.push_back(t.sign());
    // Downwards, as v runs.
    if (with_lengths) append(out.bitangents, t.bitangent * -t.bitangent_length);
  }
  out.indices = std::move(split.indices);
  out.geometry.position = attribute(out.positions, 3);
  out.geometry.normal = attribute(out.normals, 3);
  out.geometry.tangent = attribute(out.tangents, with_lengths ? 3 : 4);
  out.geometry.bitangent = attribute(out.bitangents, 3);
  out.geometry.indices = out.indices;
  out.colors = attribute(out.own_colors, 4);
  for (std::size_t set = 0; set < 2; ++set) {
    out.texcoords[set] = gathered(values_of(from.texcoord_sets[set], count), 2, split.source);
    out.texcoord_sets[set] = attribute(out.texcoords[set], 2);
  }
}

/// The triangles, those that their joints mirror wound the other way; the last vertex stays the provoking
/// one.
std::vector<std::uint32_t> rewound(const Vertices& vertices, const std::vector<bool>& mirrored) {
  std::vector<std::uint32_t> triangles = triangle_list(vertices.mode, vertices.indices, vertices.count);
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const int corners = mirrored[triangles[i]] + mirrored[triangles[i + 1]] + mirrored[triangles[i + 2]];
    if (corners >= 2) std::swap(triangles[i], triangles[i + 1]);
  }
  return triangles;
}

}  // namespace

std::unique_ptr<PreparedGeometry> prepare(const Primitive& primitive, std::optional<float> crease_angle_deg) {
  auto prepared = std::make_unique<PreparedGeometry>();
  fill(*prepared, vertices_of(primitive), crease_angle_deg);
  return prepared;
}

std::unique_ptr<PreparedGeometry> prepare_deformed(const Primitive& primitive, DeformedVertices deformed,
                                                   std::optional<float> crease_angle_deg) {
  auto prepared = std::make_unique<PreparedGeometry>();
  DeformedVertices& own = prepared->deformed = std::move(deformed);
  Vertices vertices = vertices_of(primitive);
  vertices.positions = own.positions;
  vertices.normals = own.normals;
  vertices.tangents = own.tangents;
  if (!own.colors.empty()) vertices.colors = own.colors;
  for (std::size_t set = 0; set < 2; ++set) {
    if (!own.texcoords[set].empty()) vertices.texcoords[set] = own.texcoords[set];
  }
  if (!own.mirrored.empty() && is_surface(vertices.mode)) {
    prepared->rewound = rewound(vertices, own.mirrored);
    vertices.mode = pipeline::PrimitiveMode::triangles;
    vertices.indices = prepared->rewound;
  }
  fill(*prepared, vertices, crease_angle_deg);
  return prepared;
}

bool has_tangents(const PreparedGeometry& prepared, const TangentUse& use) {
  return prepared.geometry.tangent.data != nullptr && !use.with_lengths;
}

std::unique_ptr<PreparedGeometry> prepare_tangents(const PreparedGeometry& prepared, const TangentUse& use) {
  const pipeline::Geometry& from = prepared.geometry;
  const pipeline::Attribute& coordinates = prepared.texcoord_sets[static_cast<std::size_t>(use.texcoord_set)];
  if (from.normal.data == nullptr || coordinates.data == nullptr || !is_surface(from.mode)) return nullptr;
  const std::vector<std::uint32_t> triangles = triangle_list(from.mode, from.indices, from.vertex_count);
  const std::vector<float> places = places_on_map(values_of(coordinates, from.vertex_count), use.transform);
  const std::vector<CornerTangent> tangents =
      corner_tangents({values_of(from.position, from.vertex_count), values_of(from.normal, from.vertex_count),
                       places, triangles});
  auto result = std::make_unique<PreparedGeometry>();
  split_for_tangents(*result, prepared, split_by_tangent(triangles, tangents), tangents, use.with_lengths);
  return result;
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

PreparedGeometry* GeometryCache::get(int mesh, int primitive, std::optional<float> crease_angle_deg,
                                     const TangentUse& use) {
  PreparedGeometry& plain = get(mesh, primitive, crease_angle_deg);
  if (has_tangents(plain, use)) return &plain;
  std::array<float, 9> transform{};
  for (int i = 0; i < 9; ++i) transform[static_cast<std::size_t>(i)] = use.transform[i / 3][i % 3];
  const Key key{mesh, primitive, crease_angle_deg.value_or(-1.0f)};
  const auto [slot, is_new] =
      with_tangents_.try_emplace({key, use.texcoord_set, use.with_lengths, transform});
  if (is_new) slot->second = prepare_tangents(plain, use);
  return slot->second.get();
}

const Box& GeometryCache::box_of(int mesh) {
  const auto [slot, is_new] = boxes_.try_emplace(mesh);
  if (!is_new) return slot->second;
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  Box box{glm::vec3(kInfinity), glm::vec3(-kInfinity)};
  for (const Primitive& primitive : scene_.meshes[static_cast<std::size_t>(mesh)].primitives) {
    const std::span<const float> positions = primitive.positions.values();
    for (std::size_t i = 0; i + 2 < positions.size(); i += 3) {
      const glm::vec3 p(positions[i], positions[i + 1], positions[i + 2]);
      box.low = glm::min(box.low, p);
      box.high = glm::max(box.high, p);
    }
  }
  if (box.low.x <= box.high.x) slot->second = box;
  return slot->second;
}

}  // namespace barrido::scene
