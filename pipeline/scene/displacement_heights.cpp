#include "pipeline/scene/displacement_heights.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "pipeline/scene/texture_placement.h"
#include "raster/base/portable_math.h"
#include "raster/reference/pattern.h"
#include "raster/reference/sampling.h"

namespace barrido::scene {

glm::dvec3 vector3(const pipeline::Attribute& attribute, std::uint32_t vertex) {
  const float* v = attribute.data + static_cast<std::size_t>(attribute.stride) * vertex;
  return {v[0], v[1], v[2]};
}

glm::vec2 place_on_heights(const PreparedGeometry& geometry, const HeightMap& heights, std::uint32_t vertex) {
  const pipeline::Attribute& set = geometry.texcoord_sets[static_cast<std::size_t>(heights.texcoord_set)];
  const float* uv = set.data + static_cast<std::size_t>(set.stride) * vertex;
  return {heights.transform * glm::vec3(uv[0], uv[1], 1.0f)};
}

double mean_edge_texels(const PreparedGeometry& geometry, const HeightMap& heights,
                        const std::vector<std::uint32_t>& triangles) {
  const glm::dvec2 size(heights.picture->width(), heights.picture->height());
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t c = 0; c < triangles.size(); ++c) {
    const std::size_t next = c % 3 == 2 ? c - 2 : c + 1;
    const glm::dvec2 edge = (glm::dvec2(place_on_heights(geometry, heights, triangles[next])) -
                             glm::dvec2(place_on_heights(geometry, heights, triangles[c]))) *
                            size;
    const double length = std::sqrt(glm::dot(edge, edge));
    if (!std::isfinite(length)) continue;
    sum += length;
    ++count;
  }
  return count == 0 ? 1.0 : sum / static_cast<double>(count);
}

double mean_edge_length(const PreparedGeometry& geometry, const std::vector<std::uint32_t>& triangles) {
  double sum = 0.0;
  for (std::size_t c = 0; c < triangles.size(); ++c) {
    const std::size_t next = c % 3 == 2 ? c - 2 : c + 1;
    const glm::dvec3 edge = vector3(geometry.rest, triangles[next]) - vector3(geometry.rest, triangles[c]);
    const double length = std::sqrt(glm::dot(edge, edge));
    if (std::isfinite(length)) sum += length;
  }
  return triangles.empty() ? 0.0 : sum / static_cast<double>(triangles.size());
}

SolidHeights::SolidHeights(const PreparedGeometry& geometry, SolidTexture solid) : pattern_(solid.pattern) {
  solid.space = SolidTexture::Space::object;
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  glm::vec3 low(kInfinity), high(-kInfinity);
  for (std::uint32_t v = 0; v < geometry.geometry.vertex_count; ++v) {
    const glm::vec3 p(vector3(geometry.rest, v));
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  PlacedObject object;
  object.rest = geometry.rest;
  const glm::dvec3 size(high - low);
  object.scene_size = static_cast<float>(std::sqrt(glm::dot(size, size)));
  pattern_from_object_ = glm::dmat4(place_solid(solid, object).matrix);
  const glm::dvec3 unit(pattern_from_object_[0]);
  cells_a_unit_ = std::sqrt(glm::dot(unit, unit));
}

double SolidHeights::at(const glm::dvec3& place) const {
  const glm::vec3 p(pattern_from_object_ * glm::dvec4(place, 1.0));
  const float point[3] = {p.x, p.y, p.z};
  return raster::reference::pattern_at(pattern_, point, extent_).value;
}

PictureHeights::PictureHeights(const HeightMap& heights, double texels_apart) {
  unit_.texture = heights.picture;
  unit_.min_filter = raster::MinFilter::linear_mipmap_linear;
  // The mean edge of a grid of right triangles is so much longer than the distance of its points.
  constexpr double kEdgeOverGrid = (2.0 + 1.41421356237309505) / 3.0;
  lod_ = portable_log2(static_cast<float>(std::clamp(texels_apart / kEdgeOverGrid, 1e-6, 1e6)));
}

double PictureHeights::at(const glm::dvec2& uv) const {
  const float place[3] = {static_cast<float>(uv.x), static_cast<float>(uv.y), 0.0f};
  return raster::reference::sample_texture(unit_, raster::TexcoordKind::plain, place, lod_)[0];
}

}  // namespace barrido::scene
