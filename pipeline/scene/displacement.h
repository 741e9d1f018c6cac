// Displacement (Cook 1984; T15): a surface is cut into smaller triangles, whose points are moved along its
// normals by heights, before anything else is done with it. Enters: a prepared primitive and where heights
// come from; leaves: the primitive with new vertices. Knows no view: what is made does not depend on the eye.
#pragma once

#include <cstdint>
#include <optional>

#include <glm/mat3x3.hpp>

#include "pipeline/scene/prepared_geometry.h"
#include "pipeline/scene/scene.h"
#include "pipeline/scene/texture_choice.h"
#include "raster/textures/texture.h"

namespace barrido::scene {

/// Heights in [0, 1] over a surface.
struct HeightMap {
  const raster::Texture* picture = nullptr;  ///< Its red channel; linear, with mip levels.
  glm::mat3 transform{1.0f};                 ///< (u, v, 1) → (u', v', 1)
  int texcoord_set = 0;
  Displacement by;
  std::optional<SolidTexture> solid;  ///< In place of a picture. Neither: 1 everywhere.
};

/// Whether the primitive has what displacement needs: triangles and, for a picture, coordinates.
bool can_displace(const PreparedGeometry& geometry, const HeightMap& heights);

/// Pieces that each edge is cut into: as many as asked for; else such that a piece is a texel long in the
/// mean, or an eighth of a procedure's cell, as far as `memory` bytes go.
int displacement_pieces(const PreparedGeometry& geometry, const HeightMap& heights, std::uint64_t memory);

/// Bytes that displacing takes, at most.
std::uint64_t displacement_bytes(const PreparedGeometry& geometry, int pieces);

/// Each triangle becomes pieces² triangles over the same surface, in the order of the old ones. All vertices
/// at one position move by one height (the mean of theirs) in one direction (the mean of the normals there),
/// so that no crack can open; coordinates, colours and creases stay with each corner. Normals are made anew
/// from the moved triangles, one a side where the surface had one a side.
void displace(PreparedGeometry& geometry, const HeightMap& heights, int pieces);

}  // namespace barrido::scene
