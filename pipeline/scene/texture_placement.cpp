#include "pipeline/scene/texture_placement.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "pipeline/matrix.h"
#include "raster/reference/mapping.h"

namespace barrido::scene {
namespace {

/// The rotation by the shortest way that takes `axis` to y.
glm::dmat3 upright_from(const glm::dvec3& axis) {
  const double largest = std::max({std::abs(axis.x), std::abs(axis.y), std::abs(axis.z)});
  const glm::dvec3 scaled = axis / largest;
  const glm::dvec3 a = scaled / std::sqrt(glm::dot(scaled, scaled));
  const double c = 1.0 + a.y;
  if (c < 1e-9) return {glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, -1)};
  // I + [v] + [v]²/(1 + a·y) with v = a × y = (−a.z, 0, a.x), as columns.
  return {glm::dvec3(1.0 - a.x * a.x / c, a.x, -a.x * a.z / c), glm::dvec3(-a.x, a.y, -a.z),
          glm::dvec3(-a.x * a.z / c, a.z, 1.0 - a.z * a.z / c)};
}

glm::dmat4 with_rotation(const glm::dmat3& rotation) {
  glm::dmat4 m(1.0);
  for (int c = 0; c < 3; ++c) m[c] = glm::dvec4(rotation[c], 0.0);
  return m;
}

glm::dmat4 scaling(const glm::dvec3& s) {
  glm::dmat4 m(1.0);
  for (int c = 0; c < 3; ++c) m[c][c] = s[c];
  return m;
}

glm::dmat4 translation(const glm::dvec3& t) {
  glm::dmat4 m(1.0);
  m[3] = glm::dvec4(t, 1.0);
  return m;
}

/// Half the box's extent along the axes of a turned space.
glm::dvec3 half_extent(const Box& box, const glm::dmat3& turned_from_object) {
  const glm::dvec3 half = (glm::dvec3(box.high) - glm::dvec3(box.low)) * 0.5;
  glm::dvec3 extent(0.0);
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) extent[r] += std::abs(turned_from_object[c][r]) * half[c];
  }
  return extent;
}

double or_one(double length) { return length > 0.0 ? length : 1.0; }

/// What is 1 in the mapping's space.
glm::dvec3 units_of(const MappingChoice& choice, const PlacedObject& object, const glm::dmat3& rotation) {
  if (choice.size > 0.0f) return glm::dvec3(0.5 * static_cast<double>(choice.size));
  const glm::dvec3 half = half_extent(object.box, rotation);
  const double across = or_one(std::max(half.x, half.z));
  if (choice.surface == raster::MappingSurface::cylinder) return {across, or_one(half.y), across};
  if (choice.surface == raster::MappingSurface::planar) return glm::dvec3(across);
  return glm::dvec3(or_one(std::max(across, half.y)));
}

raster::reference::Point point_at(const pipeline::Attribute& array, std::uint32_t index) {
  if (array.data == nullptr) return {0.0f, 0.0f, 1.0f};
  const float* p = array.data + static_cast<std::size_t>(index) * static_cast<std::size_t>(array.stride);
  return {p[0], p[1], p[2]};
}

glm::vec3 vector_of(const raster::reference::Point& p) { return {p[0], p[1], p[2]}; }
raster::reference::Point point_of(const glm::vec3& v) { return {v.x, v.y, v.z}; }

}  // namespace

TextureChoice chosen(TextureChoice own, const TextureChoice& by) {
  if (by.picture) own.solid.reset();
  if (by.solid) own.solid = by.solid;
  if (by.mapping) own.mapping = by.mapping;
  if (by.tiles) own.tiles = by.tiles;
  return own;
}

glm::vec3 mean_color(const raster::Pattern& pattern) {
  const auto& [dark, light] = pattern.colors;
  return {0.5f * dark[0] + 0.5f * light[0], 0.5f * dark[1] + 0.5f * light[1],
          0.5f * dark[2] + 0.5f * light[2]};
}

TexturePlacement place_solid(const SolidTexture& solid, const PlacedObject& object) {
  const bool in_world = solid.space == SolidTexture::Space::world;
  double unit = solid.scale;
  if (unit == 0.0) {
    unit = static_cast<double>(object.scene_size) / 8.0;
    if (!in_world) unit /= or_one(static_cast<double>(object.world_scale));
  }
  // An object that lies on a plane of the axes is to lie in the middle of cells, not between two.
  const bool is_wood = solid.pattern.kind == raster::PatternKind::wood;
  const glm::dvec3 middle(is_wood ? 0.0 : 0.5, 0.5, is_wood ? 0.0 : 0.5);
  const glm::dmat4 pattern = translation(middle) * scaling(glm::dvec3(1.0 / or_one(unit))) *
                             with_rotation(upright_from(glm::dvec3(solid.axis)));
  if (!in_world) return {object.rest, glm::mat4(pattern)};
  return {object.posed, glm::mat4(pattern * glm::dmat4(object.world_from_object))};
}

TexturePlacement place_mapping(const MappingChoice& choice, const PlacedObject& object) {
  const glm::dmat3 rotation = upright_from(glm::dvec3(choice.axis));
  const glm::dvec3 middle = (glm::dvec3(object.box.low) + glm::dvec3(object.box.high)) * 0.5;
  const glm::dvec3 centre = choice.centre ? glm::dvec3(*choice.centre) : middle;
  const glm::dvec3 units = units_of(choice, object, rotation);
  return {object.rest, glm::mat4(scaling(1.0 / units) * with_rotation(rotation) * translation(-centre))};
}

raster::Mapping mapping_of(const MappingChoice& choice) {
  raster::Mapping mapping;
  mapping.surface = choice.surface;
  mapping.ray = choice.ray;
  mapping.repeats = {choice.repeats.x, choice.repeats.y};
  mapping.offset = {choice.offset.x, choice.offset.y};
  return mapping;
}

void look_from(const glm::mat4& eye_from_object, const glm::mat4& mapping_from_object,
               raster::Mapping& mapping) {
  const glm::dmat4 eye = glm::dmat4(eye_from_object) * glm::inverse(glm::dmat4(mapping_from_object));
  const glm::dmat3 directions = glm::inverse(glm::dmat3(eye));
  for (std::size_t r = 0; r < 3; ++r) {
    const int row = static_cast<int>(r);
    for (std::size_t c = 0; c < 4; ++c) {
      const double value = eye[static_cast<int>(c)][row];
      mapping.eye_from_mapping[r][c] = std::isfinite(value) ? static_cast<float>(value) : 0.0f;
    }
    for (std::size_t c = 0; c < 3; ++c) {
      const double value = directions[static_cast<int>(c)][row];
      mapping.mapping_from_eye[r][c] = std::isfinite(value) ? static_cast<float>(value) : 0.0f;
    }
  }
}

std::vector<float> coordinates_at_vertices(const raster::Mapping& mapping, const TexturePlacement& placement,
                                           const PlacedObject& object) {
  const glm::dmat3 eye_normals = pipeline::normal_matrix(object.eye_from_object);
  std::vector<float> coordinates;
  coordinates.reserve(std::size_t{2} * object.vertex_count);
  for (std::uint32_t i = 0; i < object.vertex_count; ++i) {
    const glm::vec4 at = placement.matrix * glm::vec4(vector_of(point_at(placement.coordinates, i)), 1.0f);
    const glm::vec3 normal(eye_normals * glm::dvec3(vector_of(point_at(object.normals, i))));
    const auto place = raster::reference::reach_surface(mapping, point_of(glm::vec3(at)), point_of(normal));
    const std::array<float, 2> mapped = raster::reference::mapped_coordinates(mapping, place);
    coordinates.insert(coordinates.end(), mapped.begin(), mapped.end());
  }
  return coordinates;
}

}  // namespace barrido::scene
