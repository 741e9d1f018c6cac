// Where textures by procedure and by mapping lie on an object: from what is asked for (texture_choice.h) to
// the coordinates of a draw and the matrix that takes them to the pattern or the intermediate surface. Knows
// no materials and no lights.
#pragma once

#include <optional>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "pipeline/geometry.h"
#include "pipeline/scene/texture_choice.h"
#include "raster/fragments/fragment_state.h"

namespace barrido::scene {

/// `own` with what `by` chooses in its place. A picture takes the place of a procedure.
TextureChoice chosen(TextureChoice own, const TextureChoice& by);

/// Half way between the pattern's colours.
glm::vec3 mean_color(const raster::Pattern& pattern);

/// An upright box.
struct Box {
  glm::vec3 low{0, 0, 0}, high{0, 0, 0};
};

/// What the place of a texture depends on beside the choice.
struct PlacedObject {
  Box box;                      ///< Of the mesh, object space.
  pipeline::Attribute rest;     ///< Positions in the pose of the file, object space.
  pipeline::Attribute posed;    ///< Positions that are drawn,
  pipeline::Attribute normals;  ///< with their normals, in the space that world_from_object starts from.
  std::uint32_t vertex_count = 0;
  glm::mat4 world_from_object{1.0f};  ///< The world as the file has it.
  glm::mat4 eye_from_object{1.0f};    ///< Of the frame's view.
  float world_scale = 1.0f;           ///< Of lengths in the rest pose to those of the world.
  float scene_size = 1.0f;            ///< Diameter of the scene in the world.
};

/// Coordinates of a texture unit.
struct TexturePlacement {
  pipeline::Attribute coordinates;
  glm::mat4 matrix{1.0f};
};

/// Of a solid in object or world space: positions, and the pattern's space from theirs.
TexturePlacement place_solid(const SolidTexture& solid, const PlacedObject& object);

/// Of a mapping: positions in the pose of the file, and the intermediate surface's space from theirs.
TexturePlacement place_mapping(const MappingChoice& choice, const PlacedObject& object);

/// The unit's mapping as the choice says; its matrices to and from eye space are those of one point.
raster::Mapping mapping_of(const MappingChoice& choice);

/// Fills in what rays along normals and reflections need, of the view a draw is for.
void look_from(const glm::mat4& eye_from_object, const glm::mat4& mapping_from_object,
               raster::Mapping& mapping);

/// What the mapping gives at each vertex, 2 floats each: as of old, with a seam and torn poles.
std::vector<float> coordinates_at_vertices(const raster::Mapping& mapping, const TexturePlacement& placement,
                                           const PlacedObject& object);

}  // namespace barrido::scene
