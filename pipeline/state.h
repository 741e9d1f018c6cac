// The fixed-function state of a draw as plain structs, grouped as in the state tables of the OpenGL 1.3
// specification (chapter 6.2), whose defaults the initialisers are. Where the course asks for more than
// OpenGL had (shading modes, Phong's R·V, negative lights), the default is what OpenGL does.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "pipeline/shading_modes.h"
#include "raster/fragments/fragment_state.h"

namespace barrido::pipeline {

/// Where a flat polygon is lit (S1).
enum class FlatAt : std::uint8_t {
  provoking_vertex,  ///< OpenGL: the last vertex of an independent triangle, i + 2 in strips and fans.
  centroid,          ///< The course: mean of the polygon's vertices and of their normals.
};

/// Which power cheap Phong takes where (S7).
enum class CheapPhongPower : std::uint8_t {
  pixel,   ///< The interpolated R·V is raised to n per pixel.
  vertex,  ///< (R·V)^n is computed at the vertices and interpolated.
};

enum class SpecularModel : std::uint8_t {
  blinn,  ///< (N·H)^n, L9: what OpenGL has.
  phong,  ///< (R·V)^n, L3: the course.
};

enum class ColorInterpolation : std::uint8_t {
  perspective,  ///< f = Σ(b f/w) / Σ(b/w).
  screen,       ///< Linear on the screen, as textbook Gouraud (S10); also normals and dot products.
};

enum class TextureInterpolation : std::uint8_t {
  perspective,  ///< T3
  affine,       ///< T2: linear on the screen, wrong under perspective.
};

/// One light, in eye space (transform it when you specify it, as OpenGL does).
struct Light {
  glm::vec4 ambient{0, 0, 0, 1};
  glm::vec4 diffuse{1, 1, 1, 1};
  glm::vec4 specular{1, 1, 1, 1};  ///< Any component of the three may be negative (V5).
  /// Eye space, homogeneous: w = 0 is directional and points towards the light; w = 1 is a point or spot.
  glm::vec4 position{0, 0, 1, 0};
  glm::vec3 spot_direction{0, 0, -1};  ///< Eye space, from the light; need not be unit length.
  float spot_exponent = 0.0f;          ///< 0..128 in OpenGL; not clamped here.
  float spot_cutoff_deg = 180.0f;      ///< 0..90, or 180 for no cone.
  float constant_attenuation = 1.0f;
  float linear_attenuation = 0.0f;
  float quadratic_attenuation = 0.0f;
  /// Soft cone of KHR_lights_punctual: when `spot_outer_cos` < `spot_inner_cos`, the spot factor is
  /// saturate((cosθ − outer) / max(0.001, inner − outer))² in place of cosθ^exponent.
  float spot_inner_cos = -1.0f;
  float spot_outer_cos = -1.0f;
  /// Distance at which the light ends, 0 for never: factor max(min(1 − (d/range)⁴, 1), 0).
  float range = 0.0f;
};

/// Material of one side. Components may exceed 1 in float frames.
struct Material {
  glm::vec4 ambient{0.2f, 0.2f, 0.2f, 1.0f};
  glm::vec4 diffuse{0.8f, 0.8f, 0.8f, 1.0f};  ///< Its alpha is the alpha of lit colours.
  glm::vec4 specular{0, 0, 0, 1};
  glm::vec4 emission{0, 0, 0, 1};
  float shininess = 0.0f;  ///< n, ≥ 0; OpenGL stops at 128, Barrido does not.
};

/// GL_COLOR_MATERIAL: the vertex colour replaces these properties of the material.
enum class ColorMaterial : std::uint8_t { none, ambient, diffuse, ambient_and_diffuse, specular, emission };

struct Lighting {
  bool enabled = false;
  std::vector<Light> lights;                  ///< All of them are on; at most raster::kMaxLights.
  glm::vec4 ambient{0.2f, 0.2f, 0.2f, 1.0f};  ///< GL_LIGHT_MODEL_AMBIENT
  bool local_viewer = false;                  ///< V from the eye point; else V = (0, 0, 1).
  bool two_sided = false;                     ///< Back faces use −N and `back`.
  bool separate_specular = false;             ///< GL_SEPARATE_SPECULAR_COLOR
  SpecularModel specular_model = SpecularModel::blinn;
  ColorMaterial color_material = ColorMaterial::none;
  Material front;
  Material back;
};

enum class TexGenMode : std::uint8_t { object_linear, eye_linear, sphere_map, reflection_map, normal_map };

/// Generation of one coordinate. sphere_map has s and t, reflection_map and normal_map s, t and r.
struct TexGenCoordinate {
  bool enabled = false;
  TexGenMode mode = TexGenMode::eye_linear;
  glm::vec4 object_plane{0, 0, 0, 0};
  glm::vec4 eye_plane{0, 0, 0, 0};  ///< Already times the inverse model-view matrix of when it was given.
};

struct TextureCoordinates {
  std::array<TexGenCoordinate, 4> generation{
      TexGenCoordinate{false, TexGenMode::eye_linear, {1, 0, 0, 0}, {1, 0, 0, 0}},
      TexGenCoordinate{false, TexGenMode::eye_linear, {0, 1, 0, 0}, {0, 1, 0, 0}}, TexGenCoordinate{},
      TexGenCoordinate{}};
  glm::mat4 matrix{1.0f};  ///< GL_TEXTURE matrix
};

enum class CullFace : std::uint8_t { none, back, front, front_and_back };
enum class FrontFace : std::uint8_t { counter_clockwise, clockwise };
enum class PolygonMode : std::uint8_t { fill, line, point };

struct Viewport {
  int x = 0;
  int y = 0;      ///< Of the lower left corner, y up.
  int width = 0;  ///< 0: the whole frame.
  int height = 0;
  float depth_near = 0.0f;  ///< glDepthRange
  float depth_far = 1.0f;
};

struct State {
  glm::mat4 eye_from_object{1.0f};  ///< GL_MODELVIEW
  glm::mat4 clip_from_eye{1.0f};    ///< GL_PROJECTION
  Viewport viewport;
  bool normalize = false;              ///< GL_NORMALIZE
  bool rescale_normal = false;         ///< GL_RESCALE_NORMAL
  std::vector<glm::vec4> clip_planes;  ///< Eye space; a point p is kept when dot(plane, p) ≥ 0.
  /// GL_DEPTH_CLAMP: no clipping at the near and far planes; the depth is clamped instead.
  bool depth_clamp = false;

  ShadeModel shade_model = ShadeModel::gouraud;
  FlatAt flat_at = FlatAt::provoking_vertex;
  CheapPhongPower cheap_phong_power = CheapPhongPower::pixel;
  ColorInterpolation color_interpolation = ColorInterpolation::perspective;
  TextureInterpolation texture_interpolation = TextureInterpolation::perspective;
  Lighting lighting;

  std::array<TextureCoordinates, raster::kMaxTextureUnits> texture_coordinates;
  std::array<raster::TextureUnit, raster::kMaxTextureUnits> texture_units;

  CullFace cull_face = CullFace::none;
  FrontFace front_face = FrontFace::counter_clockwise;
  PolygonMode polygon_mode = PolygonMode::fill;
  float point_size = 1.0f;  ///< Pixels, > 0.
  float line_width = 1.0f;  ///< Pixels, > 0.

  // Per fragment.
  bool clamp_colors =
      true;  ///< Clamp lit colours to [0, 1], as OpenGL 1.x; off for values over the maximum (L8).
  raster::FogState fog;
  raster::AlphaTest alpha_test;
  raster::DepthState depth;
  raster::PolygonOffset polygon_offset;
  raster::BlendState blend;
  /// Fragments that pass their tests as they are drawn wait for all that follow them in their pixel and are
  /// also `sorted`; then they are blended from the farthest to the nearest.
  bool sorted = false;
  std::array<bool, 4> color_mask{true, true, true, true};
  raster::Scissor scissor;
};

}  // namespace barrido::pipeline
