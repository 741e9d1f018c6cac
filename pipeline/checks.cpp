#include "pipeline/checks.h"

#include <stdexcept>
#include <string>

#include "pipeline/packed_position.h"

namespace barrido::pipeline {
namespace {

void require(bool condition, const std::string& message) {
  if (!condition) throw std::invalid_argument(message);
}

void check(const Attribute& attribute, const char* name, int min_components, int max_components) {
  if (attribute.data == nullptr) return;
  require(attribute.components >= min_components && attribute.components <= max_components,
          std::string(name) + ": an element must have " + std::to_string(min_components) + " to " +
              std::to_string(max_components) + " components, not " + std::to_string(attribute.components));
  require(attribute.stride >= 0, std::string(name) + ": the stride must not be negative");
}

void check(const Viewport& v) {
  constexpr int kSide = raster::kMaxFrameSide;
  require(v.width >= 0 && v.height >= 0 && v.width <= kSide && v.height <= kSide,
          "viewport: sides must be in 0..16384");
  require(v.x >= -kSide && v.x <= kSide && v.y >= -kSide && v.y <= kSide,
          "viewport: corners must be in -16384..16384");
  for (const float depth : {v.depth_near, v.depth_far}) {
    require(depth >= 0.0f && depth <= 1.0f, "viewport: the depth range must lie in [0, 1]");
  }
}

void check(const raster::TextureUnit& unit) {
  require(
      unit.procedure == nullptr || (unit.pattern.octaves >= 1 && unit.pattern.octaves <= raster::kMaxOctaves),
      "a pattern must have 1 to 16 octaves");
  const bool is_cube = unit.texture != nullptr && unit.procedure == nullptr && unit.texture->is_cube();
  require(
      unit.role == raster::TextureRole::environment || unit.mapping.surface == raster::MappingSurface::none,
      "a mapping makes coordinates of textures that colour, not of maps");
  require(!is_cube || unit.mapping.surface == raster::MappingSurface::none,
          "a mapping makes coordinates of two-dimensional textures, not of cube maps");
  require(unit.role == raster::TextureRole::environment || unit.tiles == raster::TileChange::none,
          "tiles are changed of textures that colour, not of maps");
}

}  // namespace

void check(const State& state) {
  check(state.viewport);
  require(state.clip_planes.size() <= static_cast<std::size_t>(kMaxClipPlanes),
          "at most 8 clip planes can be on");
  require(state.point_size > 0.0f, "the point size must be positive");
  require(state.line_width > 0.0f, "the line width must be positive");
  require(!state.scissor.enabled || (state.scissor.width >= 0 && state.scissor.height >= 0),
          "scissor: sides must not be negative");
  for (const raster::TextureUnit& unit : state.texture_units) {
    require(unit.combine.alpha.function < raster::CombineFunction::dot3_rgb,
            "texture environment: dot3 is a combination of colours, not of alpha");
  }
  for (const raster::TextureUnit& unit : state.texture_units) check(unit);
}

void check(const Geometry& geometry) {
  constexpr std::uint32_t kMaxVertices = 1u << 30;  // two records a vertex must be numbered in 32 bits
  require(geometry.vertex_count <= kMaxVertices, "at most 2^30 vertices can be drawn at once");
  require(geometry.indices.size() <= (std::size_t{1} << 31), "at most 2^31 indices can be drawn at once");
  require(geometry.position.data != nullptr || geometry.vertex_count == 0, "position: the array is missing");
  check(geometry.position, "position", 2, 4);
  check(geometry.normal, "normal", 3, 3);
  check(geometry.color, "color", 3, 4);
  check(geometry.tangent, "tangent", 3, 4);
  check(geometry.bitangent, "bitangent", 3, 3);
  for (const Attribute& texcoord : geometry.texcoord) check(texcoord, "texcoord", 2, 4);
}

}  // namespace barrido::pipeline
