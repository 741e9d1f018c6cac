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

/// Where the colours of a draw's primitives are made.
enum class Shading : std::uint8_t {
  constant,        ///< One colour for the whole draw.
  per_vertex,      ///< Colours or lit colours of the vertices, interpolated (Gouraud, S4).
  flat_provoking,  ///< Lit at the vertices; the provoking one's is kept (S1).
  flat_centroid,   ///< Lit once a polygon, at its centroid (S1).
  cheap_phong,     ///< Dot products from the vertices, model per fragment (S7).
  phong,           ///< Normals from the vertices, model per fragment (S6).
};

constexpr bool is_flat(Shading s) { return s == Shading::flat_provoking || s == Shading::flat_centroid; }

/// Whether the model, or its dot products, are evaluated at the vertices (when lighting is on).
constexpr bool is_lit_at_vertices(Shading s) {
  return s == Shading::per_vertex || s == Shading::flat_provoking || s == Shading::cheap_phong;
}

/// Whether fragments evaluate the illumination model.
constexpr bool is_lit_per_fragment(Shading s) { return s == Shading::cheap_phong || s == Shading::phong; }

/// `illumination` null: lighting is off.
Shading choose_shading(const State& state, const Geometry& geometry, const Illumination* illumination);

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

VaryingNeeds varying_needs(const State& state, const Geometry& geometry, Shading shading,
                           const Illumination* illumination);

/// Packs the varyings, those linear on the screen first.
raster::VaryingLayout make_layout(const VaryingNeeds& needs);

/// Whether every vertex has w = 1 after projection, exactly.
bool has_unit_w(const State& state, const Geometry& geometry);

}  // namespace barrido::pipeline
