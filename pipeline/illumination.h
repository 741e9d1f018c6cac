// The illumination model (course L1 to L6, L9, V5; OpenGL 1.3, section 2.13.1) as data: lights and materials
// multiplied out once per draw. One function evaluates it for vertices, centroids and fragments alike. Knows
// eye-space points and normals; knows neither polygons nor pixels.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "pipeline/state.h"

namespace barrido::pipeline {

/// Products of a light's colours with a material's, RGB. `fixed` stands alone; `tracked` is multiplied by the
/// colour of the vertex (GL_COLOR_MATERIAL).
struct LightProducts {
  std::array<glm::vec3, 2> fixed{glm::vec3{0}, glm::vec3{0}};  ///< Front and back side.
  std::array<glm::vec3, 2> tracked{glm::vec3{0}, glm::vec3{0}};
};

enum class SpotFalloff : std::uint8_t { none, exponent, soft };

/// One light, made ready.
struct IlluminatingLight {
  bool directional = true;
  glm::vec3 to_light{0, 0, 1};     ///< Directional: unit vector L, eye space.
  glm::vec3 half_vector{0, 0, 1};  ///< Directional and viewer at infinity: unit vector H, eye space.
  glm::vec3 position{0, 0, 0};     ///< Otherwise: eye space.

  /// Whether the light weakens with distance or direction, so that its factor has to be evaluated:
  /// spot / (kc + kl·d + kq·d²) × max(1 − (d/range)⁴, 0). Constant factors are in the products already.
  bool weakens = false;
  float constant_attenuation = 1.0f;
  float linear_attenuation = 0.0f;
  float quadratic_attenuation = 0.0f;
  float inverse_range = 0.0f;  ///< 1/range, 0 for none.
  SpotFalloff falloff = SpotFalloff::none;
  bool has_cone = false;  ///< Whether cos_cutoff, spot_direction and falloff apply.
  glm::vec3 spot_direction{0, 0, -1};
  float cos_cutoff = -1.0f;
  float spot_exponent = 0.0f;
  float soft_scale = 0.0f;  ///< Soft cone: saturate(cosθ·scale + offset)².
  float soft_offset = 0.0f;

  LightProducts ambient;  ///< Only of lights that weaken; others' is in Illumination::base.
  LightProducts diffuse;
  LightProducts specular;
  std::array<bool, 2> shines{false, false};  ///< Per side: some specular product is not 0.
};

/// Everything that the evaluation needs.
struct Illumination {
  const ShadingMode* mode = &shading_mode(ShadeModel::gouraud);
  CheapPhongPower cheap_phong_power = CheapPhongPower::pixel;
  SpecularModel specular_model = SpecularModel::blinn;
  bool local_viewer = false;   ///< False also when nothing shines.
  bool needs_position = true;  ///< Some light is near, or the viewer is local.
  bool tracks_color = false;   ///< Some property of the material is the vertex colour.
  bool tracks_alpha = false;
  bool two_sided = false;
  bool separate_specular = false;
  LightProducts base;      ///< Emission, global ambient, and ambient of lights that do not weaken.
  LightProducts emission;  ///< Of `base`, what no occlusion weakens.
  std::array<float, 2> alpha{1, 1};
  std::array<float, 2> shininess{0, 0};
  std::vector<IlluminatingLight> lights;

  /// Evaluations of x^n for one point: highlights and spot exponents.
  int powers_per_point(int side) const;
};

/// `constant_color` null: the vertices have colours of their own; else it is the colour of all of them.
/// @throws std::invalid_argument for more than raster::kMaxLights lights, a negative shininess or spot
/// exponent, or a cut-off that is neither in [0, 90] nor 180.
Illumination compile_illumination(const Lighting& lighting, const glm::vec4* constant_color);

/// Points of surfaces in eye space, as a structure of arrays. All arrays are aligned to 64 bytes and may be
/// read in whole vectors past `count`.
struct SurfacePoints {
  int count = 0;
  std::array<const float*, 3> normal{};
  std::array<const float*, 3> position{};  ///< Unused unless Illumination::needs_position.
  std::array<const float*, 4> color{};     ///< Unused unless Illumination::tracks_color.
  bool normalize = false;                  ///< Bring normals to unit length first.
  bool back = false;                       ///< Seen from behind: with two_sided, −N and the back material.
  /// An array a light: the share of its diffuse and specular light that arrives. Empty: all of it.
  std::span<const float* const> visibility{};
  const float* occlusion = nullptr;  ///< The share of ambient light that arrives. Null: all of it.
};

/// Where the colours go; not clamped. Arrays as those of SurfacePoints.
struct LitColors {
  std::array<float*, 4> primary{};
  std::array<float*, 3> secondary{};  ///< Unused unless Illumination::separate_specular.
};

/// Evaluates the model at every point:
/// C = base + Σ f_i (a_i + (N·L_i)⁺ d_i + [N·L_i > 0] h_i^n s_i), with h = N·H (blinn) or R·V (phong), f the
/// light's weakening (times its visibility for d and s) and a, d, s its products with the material
/// (OpenGL 1.3, eq. 2.4; L3, L5). Where ambient light is occluded by 1 − o, base·o + emission·(1 − o) stands
/// for base, and o·a_i for a_i.
void illuminate(const Illumination& illumination, const SurfacePoints& points, const LitColors& out);

}  // namespace barrido::pipeline
