// From a material to the state of a draw that depends on it alone: coefficients, texture units, alpha.
// Enters: a material and the choices of technique; leaves: a SurfaceState. Knows no lights, no view and no
// geometry.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "pipeline/scene/material_conversion.h"
#include "pipeline/scene/prepared_geometry.h"
#include "pipeline/scene/render_scene.h"
#include "pipeline/scene/scene.h"
#include "pipeline/scene/texture_cache.h"
#include "pipeline/state.h"

namespace barrido::scene {

struct SurfaceOptions {
  raster::Encoding encoding = raster::Encoding::srgb;  ///< Of colour pictures
  bool textures = true;
  std::optional<raster::MinFilter> min_filter;
  std::optional<raster::MagFilter> mag_filter;
  int max_anisotropy = 1;
  Reflections reflections = Reflections::metals;
  pipeline::SpecularModel specular_model = pipeline::SpecularModel::blinn;
  ConversionLimits limits;
  bool mip_colors = false;  ///< As TexelUse::mip_colors, for base colours.
  MaterialOverride material;
  MapOverride maps;
  bool fragment_normals = true;    ///< Fragments have normals of their own, which maps can change,
  bool fragment_light = true;      ///< and ambient light, which maps can weaken.
  TextureChoice texture;           ///< In place of the materials'.
  float scene_size = 1.0f;         ///< Diameter, in the world.
  glm::dvec3 origin{0, 0, 0};      ///< Of the frame's world in the file's.
  glm::mat4 eye_from_world{1.0f};  ///< Of the frame's view.
  int variant = kNone;             ///< Of Scene::variants
};

/// How a draw meets what is there already.
enum class Blending : std::uint8_t {
  none,    ///< In its place.
  over,    ///< By its alpha.
  filter,  ///< What is there is multiplied by its colour: a look through tinted glass.
  add,     ///< Its light is added: highlights on glass.
  coat     ///< Added where the draw before it left its depth: a second layer on the same surface.
};

struct SurfaceState {
  bool lit = true;
  Blending blending = Blending::none;
  glm::vec4 color{1, 1, 1, 1};  ///< Of unlit surfaces, or what vertex colours are multiplied by
  pipeline::ColorMaterial color_material = pipeline::ColorMaterial::none;
  pipeline::Material material;
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;
  bool double_sided = false;
  std::array<raster::TextureUnit, raster::kMaxTextureUnits> units;
  std::array<glm::mat4, raster::kMaxTextureUnits> texture_matrix{};
  std::array<int, raster::kMaxTextureUnits> texcoord_set;  ///< TEXCOORD_n of a unit, or kNone
  int unit_count = 0;
  int placed_unit = kNone;             ///< The unit whose coordinates come from positions or a mapping
  TextureChoice placed;                ///< What it shows
  glm::mat4 placed_from_object{1.0f};  ///< To the pattern or the mapping
  int reflection_unit = kNone;         ///< The unit that is to have the environment's cube map
  float reflection_exponent = 0.0f;    ///< Of the lobe in which the surface gathers its environment
  int normal_unit = kNone;             ///< The unit whose map changes normals,
  TangentUse tangents;                 ///< and what it is to know of the surface
  /// Maps that the shading mode has no place for: of normals, of ambient light.
  bool drops_normals = false, drops_occlusion = false;

  SurfaceState() { texcoord_set.fill(kNone); }
};

/// What a surface is made for.
struct SurfaceUse {
  const Primitive* primitive = nullptr;
  int material = kNone;      ///< kNone: glTF's default material
  bool has_normals = false;  ///< Without them it is unlit.
  bool has_colors = false;
  float scale = 1.0f;  ///< Of the primitive's units to the world's; for the thickness of glass
};

/// The surface of a primitive; several where it has to be drawn more than once, in this order: what glass
/// lets through, what it adds, a clear coat.
std::vector<SurfaceState> make_surfaces(const Scene& scene, const SurfaceUse& use,
                                        const SurfaceOptions& options, TextureCache& textures);

}  // namespace barrido::scene
