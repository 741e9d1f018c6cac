// Which varyings a draw's vertex records carry, and where. Enters: state and the arrays that the geometry
// has; leaves: offsets. Only what the fragments need is recorded, because every varying costs time per
// vertex, primitive and pixel.
#pragma once

#include <array>
#include <optional>

#include "pipeline/geometry.h"
#include "pipeline/illumination.h"
#include "pipeline/state.h"
#include "raster/fragments/fragment_state.h"

namespace barrido::pipeline {

/// What fragments need from the vertices.
struct VaryingNeeds {
  bool color = false;
  bool specular = false;
  bool normal = false;
  bool eye_position = false;
  int dots = 0;  ///< Floats of cheap Phong.
  std::array<std::optional<raster::TexcoordKind>, raster::kMaxTextureUnits> texcoord;
  bool fog = false;
  bool colors_affine = false;     ///< Colours, normals, positions and dots linear on the screen.
  bool texcoords_affine = false;  ///< Texture coordinates linear on the screen.
  bool all_affine = false;        ///< w is 1 everywhere: linear on the screen is right.
};

/// `illumination` null: lighting is off.
VaryingNeeds varying_needs(const State& state, const Geometry& geometry, const ColorOrigin& origin,
                           const Illumination* illumination);

/// Packs the varyings, those linear on the screen first.
raster::VaryingLayout make_layout(const VaryingNeeds& needs);

/// Whether every vertex has w = 1 after projection, exactly.
bool has_unit_w(const State& state, const Geometry& geometry);

}  // namespace barrido::pipeline
