// Textures that are asked for beside those of a file's pictures: by procedure, by a mapping from an
// intermediate surface, tile by tile. As materials (extras.barrido) and users give them; plain data.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "pipeline/pictures/image.h"
#include "raster/textures/mapping.h"
#include "raster/textures/pattern.h"

namespace barrido::scene {

/// A texture by procedure (T12, T13).
struct SolidTexture {
  enum class Space : std::uint8_t {
    object,   ///< The pattern sticks to the object, in the pose of its file.
    world,    ///< The object slides through the pattern.
    surface,  ///< (u, v) of the mapping, or of the file.
  };
  raster::Pattern pattern;
  Space space = Space::object;
  /// Size of the pattern's unit, in the model's units (object: as large as the scene is in the world) or, on
  /// surfaces, in those of (u, v). 0: an eighth of the scene, or of the picture.
  float scale = 0.0f;
  glm::vec3 axis{0, 1, 0};  ///< Of stripes, rings and layers; not zero.

  bool operator==(const SolidTexture&) const = default;
};

/// The pattern with the colours and octaves that belong to it when nothing else is said.
inline SolidTexture standard_solid(raster::PatternKind kind) {
  SolidTexture solid;
  raster::Pattern& pattern = solid.pattern;
  pattern.kind = kind;
  if (kind == raster::PatternKind::wood) {
    pattern.octaves = 3;
    pattern.turbulence = 0.3f;
    pattern.colors = {{{0.55f, 0.27f, 0.1f, 1}, {0.24f, 0.1f, 0.03f, 1}}};
  } else if (kind == raster::PatternKind::marble) {
    pattern.octaves = 6;
    pattern.turbulence = 1.5f;
    pattern.colors = {{{0.1f, 0.12f, 0.16f, 1}, {0.9f, 0.88f, 0.84f, 1}}};
  }
  return solid;
}

/// Two-part mapping (T4 to T8).
struct MappingChoice {
  raster::MappingSurface surface = raster::MappingSurface::none;
  raster::MappingRay ray = raster::MappingRay::surface;
  bool at_vertices = false;         ///< Coordinates are made at the vertices and interpolated (T1).
  glm::vec3 axis{0, 1, 0};          ///< In object space, not zero: from pole to pole, or across the plane.
  std::optional<glm::vec3> centre;  ///< In object space; empty: the middle of the object's box.
  float size = 0.0f;                ///< In object space: side, height or diameter; 0: as the object's box.
  glm::vec2 repeats{1, 1};          ///< Of the picture over the whole surface; not 0.
  glm::vec2 offset{0, 0};           ///< Added to the coordinates.

  bool operator==(const MappingChoice&) const = default;
};

struct TextureChoice {
  std::shared_ptr<const Image> picture;  ///< In place of the base colour's; null: the file's.
  std::optional<SolidTexture> solid;     ///< In place of a picture.
  std::optional<MappingChoice> mapping;  ///< Of the base colour.
  std::optional<raster::TileChange> tiles;
};

}  // namespace barrido::scene
